(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/canned-cycle: the drilling mode on the drilling axis and one axis of the position.

    Every axis of the position goes by itself, so one is enough. *)
From Coq Require Import Reals Lra Lia List.
Import ListNotations.
Open Scope R_scope.

(** * Definitions *)

Inductive word :=
| Absolute (p : R)      (* G90: a coordinate *)
| Incremental (d : R).  (* G91: a travel or a distance *)

(** Where a word leads from [base]; none: there. *)
Definition from base w :=
  match w with Some (Absolute p) => p | Some (Incremental d) => base + d | None => base end.

(** The level to which the tool returns: the initial level, point R. *)
Inductive return_code := G98 | G99.

(** What the mode keeps: the initial level, R and the word of the drilling axis as they were given. *)
Record mode := Mode { initial : R; r_word : option word; z_word : option word }.

Definition point_r m := from (initial m) (r_word m).
Definition bottom m := from (point_r m) (z_word m).
Definition return_level g m := match g with G98 => initial m | G99 => point_r m end.

(** The position, where the drilling axis stands, and the mode; none: G80. *)
Record state := State { place : R; level : R; in_mode : option mode }.

(** A block in the mode, the first one too: its return code, its words, and how many holes it drills. *)
Record block := Block { returns : return_code; x : option word; r : option word; z : option word; count : nat }.

Definition or_before (new before : option word) := match new with Some _ => new | None => before end.

(** The mode begins where the drilling axis stands. *)
Definition mode_with s b :=
  let m := match in_mode s with Some m => m | None => Mode (level s) None None end in
  Mode (initial m) (or_before (r b) (r_word m)) (or_before (z b) (z_word m)).

(** One hole after the other. *)
Fixpoint places p w n := match n with O => [] | S n => from p w :: places (from p w) w n end.

Record hole := Hole { at_place : R; at_r : R; at_bottom : R; back_at : R }.

Definition holes s b :=
  let m := mode_with s b in
  map (fun p => Hole p (point_r m) (bottom m) (return_level (returns b) m)) (places (place s) (x b) (count b)).

Definition step s b :=
  let m := mode_with s b in
  match count b with
  | O => State (place s) (level s) (Some m)
  | _ => State (last (places (place s) (x b) (count b)) (place s)) (return_level (returns b) m) (Some m)
  end.

Definition run := fold_left step.

(** What the axes are sent to with a length offset [v] of the drilling axis. *)
Definition sent v h := Hole (at_place h) (at_r h + v) (at_bottom h + v) (back_at h + v).

(** The same point of the machine by coordinates of the drilling axis that are [v] greater. *)
Definition renamed v s :=
  State (place s) (level s + v)
    (match in_mode s with Some m => Some (Mode (initial m + v) (r_word m) (z_word m)) | None => None end).

(** Data that are none or distances. *)
Definition is_distance w := match w with Some (Absolute _) => false | _ => true end.
Definition by_distances s b :=
  is_distance (r_word (mode_with s b)) = true /\ is_distance (z_word (mode_with s b)) = true.

(** * Repeats *)

(** fanuc.canned-cycle.repeats: a block drills as many holes as it says. *)
Theorem as_many_holes s b : length (holes s b) = count b.
Proof.
  unfold holes. rewrite map_length. generalize (place s) as p. induction (count b) as [|n IH]; intro p; [reflexivity|].
  cbn. now rewrite IH.
Qed.

Example as_many_holes_instance :
  length (holes (State 0 50 None) (Block G98 (Some (Incremental 10)) None None 3)) = 3%nat.
Proof. apply as_many_holes. Qed.

(** fanuc.canned-cycle.repeats: under G91 the K-th hole is K travels away. *)
Theorem holes_travel p d n : forall k otherwise, (k < n)%nat ->
  nth k (places p (Some (Incremental d)) n) otherwise = p + INR (S k) * d.
Proof.
  revert p; induction n as [|n IH]; intros p k otherwise L; [lia|]. destruct k as [|k].
  - cbn. lra.
  - cbn [places nth]. rewrite IH by lia. rewrite (S_INR (S k)). cbn [from]. lra.
Qed.

Example holes_travel_instance : nth 2 (places 100 (Some (Incremental 10)) 3) 0 = 130.
Proof. rewrite holes_travel by lia. cbn. lra. Qed.

(** fanuc.canned-cycle.repeats: under G90, and without a word, all are in one place. *)
Theorem holes_in_one_place p a n :
  Forall (fun q => q = a) (places p (Some (Absolute a)) n) /\ Forall (fun q => q = p) (places p None n).
Proof. split; [revert p|]; induction n as [|n IH]; constructor; auto. Qed.

Example holes_in_one_place_instance : Forall (fun q => q = 40) (places 100 (Some (Absolute 40)) 3).
Proof. apply holes_in_one_place. Qed.

(** fanuc.canned-cycle.no-hole: the data of a block with K0 count in the next one as if they stood there. *)
Theorem no_hole_keeps_data s g x' r' z' h x'' n :
  let ahead := step s (Block g x' r' z' 0) in
  holes ahead (Block h x'' None None n) = holes s (Block h x'' r' z' n) /\
  step ahead (Block h x'' None None n) = step s (Block h x'' r' z' n).
Proof.
  intro ahead.
  assert (M : mode_with ahead (Block h x'' None None n) = mode_with s (Block h x'' r' z' n)).
  { unfold ahead, mode_with, step; cbn. now destruct (in_mode s). }
  assert (P : place ahead = place s) by reflexivity. assert (L : level ahead = level s) by reflexivity.
  clearbody ahead. unfold holes, step. rewrite M, P, L. now split.
Qed.

Example no_hole_keeps_data_instance :
  holes (step (State 0 50 None) (Block G98 (Some (Absolute 99)) (Some (Absolute 2)) (Some (Incremental (-7))) 0))
    (Block G99 (Some (Absolute 10)) None None 1) = [Hole 10 2 (-5) 2].
Proof.
  destruct (no_hole_keeps_data (State 0 50 None) G98 (Some (Absolute 99)) (Some (Absolute 2)) (Some (Incremental (-7)))
              G99 (Some (Absolute 10)) 1) as [-> _].
  cbn. unfold bottom, point_r; cbn. repeat f_equal; lra.
Qed.

(** * The initial level *)

Lemma initial_of_step s b m : in_mode s = Some m -> exists m', in_mode (step s b) = Some m' /\ initial m' = initial m.
Proof.
  intro M. unfold step, mode_with. rewrite M. destruct (count b); (eexists; split; [reflexivity|reflexivity]).
Qed.

(** fanuc.canned-cycle.initial-level: no block of the mode changes it, under G99 neither. *)
Theorem initial_level_stays bs : forall s m, in_mode s = Some m ->
  exists m', in_mode (run bs s) = Some m' /\ initial m' = initial m.
Proof.
  induction bs as [|b bs IH]; intros s m M; [exists m; now split|].
  destruct (initial_of_step s b m M) as (m1 & M1 & E1). destruct (IH (step s b) m1 M1) as (m2 & M2 & E2).
  exists m2. split; [exact M2|congruence].
Qed.

Example initial_level_stays_instance :
  exists m, in_mode (run [Block G99 (Some (Absolute 10)) (Some (Absolute 2)) None 1; Block G99 None None None 1]
                       (State 0 50 (Some (Mode 50 None None)))) = Some m /\ initial m = 50.
Proof. now apply (initial_level_stays _ _ (Mode 50 None None)). Qed.

(** fanuc.canned-cycle.return: after whatever blocks of the mode, a hole under G98 leaves the drilling axis where it
    stood when the mode began. *)
Theorem back_at_the_initial_level s b bs x' r' z' n : in_mode s = None -> n <> O ->
  level (step (run bs (step s b)) (Block G98 x' r' z' n)) = level s.
Proof.
  intros OFF N.
  assert (M : exists m, in_mode (step s b) = Some m /\ initial m = level s).
  { unfold step, mode_with. rewrite OFF. destruct (count b); (eexists; split; [reflexivity|reflexivity]). }
  destruct M as (m & M & E). destruct (initial_level_stays bs (step s b) m M) as (m' & M' & E').
  unfold step at 1. cbn [count]. destruct n as [|n]; [congruence|]. cbn [level return_level returns].
  unfold mode_with. rewrite M'. cbn. congruence.
Qed.

Example back_at_the_initial_level_instance :
  level (step (run [Block G99 (Some (Absolute 20)) None None 1]
                 (step (State 0 50 None) (Block G99 (Some (Absolute 10)) (Some (Absolute 2)) (Some (Absolute (-5))) 1)))
           (Block G98 (Some (Absolute 30)) None None 1)) = 50.
Proof. now apply (back_at_the_initial_level (State 0 50 None)). Qed.

(** fanuc.canned-cycle.point-r: from one hole to the next the levels stay, where a block gives none. *)
Theorem levels_stay s b g x' n : let m := mode_with s b in let m' := mode_with (step s b) (Block g x' None None n) in
  point_r m' = point_r m /\ bottom m' = bottom m.
Proof. intros m m'. unfold m', m, step. destruct (count b); split; reflexivity. Qed.

Example levels_stay_instance : let s := State 0 50 None in
  let b := Block G99 (Some (Absolute 10)) (Some (Incremental (-48))) (Some (Incremental (-7))) 1 in
  point_r (mode_with (step s b) (Block G98 (Some (Absolute 20)) None None 1)) = 2.
Proof. intros s b. destruct (levels_stay s b G98 (Some (Absolute 20)) 1) as [-> _]. cbn. lra. Qed.

(** * G90 and G91 *)

(** fanuc.canned-cycle.bottom: a block in G90 and its twin in G91, R counted from the initial level and the bottom from
    point R, drill the same hole. *)
Theorem absolute_is_incremental s g p a c : let i := initial (mode_with s (Block g None None None 1)) in
  let absolute := Block g (Some (Absolute p)) (Some (Absolute a)) (Some (Absolute c)) 1 in
  let incremental :=
    Block g (Some (Incremental (p - place s))) (Some (Incremental (a - i))) (Some (Incremental (c - a))) 1 in
  holes s incremental = holes s absolute /\ place (step s incremental) = place (step s absolute) /\
  level (step s incremental) = level (step s absolute).
Proof.
  cbv zeta. unfold holes, step; cbn.
  set (i := initial (match in_mode s with Some m => m | None => Mode (level s) None None end)).
  unfold bottom, point_r, return_level; cbn. unfold point_r; cbn. fold i.
  replace (i + (a - i)) with a by ring. replace (a + (c - a)) with c by ring.
  replace (place s + (p - place s)) with p by ring. repeat split; now destruct g.
Qed.

Example absolute_is_incremental_instance :
  holes (State 100 50 None)
    (Block G99 (Some (Incremental (110 - 100))) (Some (Incremental (2 - 50))) (Some (Incremental (-5 - 2))) 1) =
  [Hole 110 2 (-5) 2].
Proof. destruct (absolute_is_incremental (State 100 50 None) G99 110 2 (-5)) as [H _]. exact H. Qed.

(** * Offsets and other coordinates *)

(** fanuc.canned-cycle.initial-level: by other coordinates of the drilling axis the holes of distances are the same. *)
Theorem renamed_holes v s b : by_distances s b -> holes (renamed v s) b = map (sent v) (holes s b).
Proof.
  intros [RD ZD]. unfold holes. rewrite map_map. cbn [place renamed]. apply map_ext. intro p. unfold sent; cbn.
  assert (M : mode_with (renamed v s) b =
              Mode (initial (mode_with s b) + v) (r_word (mode_with s b)) (z_word (mode_with s b))).
  { unfold mode_with, renamed. destruct (in_mode s); reflexivity. }
  rewrite M. unfold bottom, point_r, return_level, point_r; cbn [initial r_word z_word].
  destruct (r_word (mode_with s b)) as [[?|?]|], (z_word (mode_with s b)) as [[?|?]|]; try discriminate;
    destruct (returns b); cbn; f_equal; lra.
Qed.

(** Coordinates 30 greater, and the hole is named so. *)
Example renamed_holes_instance :
  let b := Block G99 None (Some (Incremental (-48))) (Some (Incremental (-7))) 1 in
  holes (renamed 30 (State 0 50 None)) b = map (sent 30) (holes (State 0 50 None) b).
Proof. intro b. apply renamed_holes. now split. Qed.

(** fanuc.canned-cycle.length-offset: it moves point R, the bottom and the return alike: depths stay. *)
Theorem offset_keeps_depths v h :
  at_r (sent v h) - at_bottom (sent v h) = at_r h - at_bottom h /\
  back_at (sent v h) - at_bottom (sent v h) = back_at h - at_bottom h /\ at_place (sent v h) = at_place h.
Proof. cbn; repeat split; lra. Qed.

Example offset_keeps_depths_instance : at_r (sent 20 (Hole 10 2 (-5) 50)) - at_bottom (sent 20 (Hole 10 2 (-5) 50)) = 7.
Proof. destruct (offset_keeps_depths 20 (Hole 10 2 (-5) 50)) as (-> & _). cbn. lra. Qed.

(** fanuc.canned-cycle.length-offset: with an offset v a block of distances drills where the same block would that
    begins v farther up the drilling axis without it. *)
Theorem offset_is_a_higher_start v p l b : is_distance (r b) = true -> is_distance (z b) = true ->
  map (sent v) (holes (State p l None) b) = holes (State p (l + v) None) b.
Proof.
  intros RD ZD. rewrite <- (renamed_holes v (State p l None) b); [reflexivity|].
  unfold by_distances, mode_with; cbn. now destruct (r b), (z b).
Qed.

Example offset_is_a_higher_start_instance :
  map (sent 20) (holes (State 0 50 None) (Block G98 None (Some (Incremental (-48))) (Some (Incremental (-7))) 1)) =
  holes (State 0 (50 + 20) None) (Block G98 None (Some (Incremental (-48))) (Some (Incremental (-7))) 1).
Proof. now apply offset_is_a_higher_start. Qed.
