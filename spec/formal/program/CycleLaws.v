(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of canned cycles: what a block that drills makes, and the initial level. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Lia.
From Toolcomp Require Import Numbers Outcomes Words Codes LengthOffset CycleState State Movements.
From Toolcomp Require Import DrillingCycle Program OutcomeLaws PlanLaws ProgramLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * Holes and moves *)

Definition makes_holes_in {num} (s : setup num) (p : planned num) : bool :=
  makes_holes s (codes_said (command_of p)) (block_of (command_of p)) (cycle (before p)).

(** fanuc.canned-cycle.drills: in the plan a block that drills makes no move, and no other one a hole. *)
Theorem holes_or_moves {num} {N : Numbers num} decimal (s : setup num) bs place st :
  Forall (fun p => forallb (if makes_holes_in s p then is_no_move else is_no_hole) (items p) = true)
    (fst (planned_from decimal s bs place st)).
Proof.
  apply (planned_all decimal s (fun _ => True) (fun _ => True)); [|apply Forall_forall; auto|exact I].
  intros ? b ? p after moves others _ _ T. split; [exact I|]. destruct T. rewrite its_items.
  unfold makes_holes_in. rewrite its_block. destruct (makes_holes s _ b (cycle (before p))) eqn:M.
  - rewrite (drills_alone eq_refl). exact its_others.
  - rewrite forallb_app, (drills_only eq_refl), andb_true_r. apply forallb_forall. intros i J.
    now apply in_map_iff in J as (m & <- & _).
Qed.

Definition one_hole : block R := Block [natural Letter.G 81; natural Letter.X 10; natural Letter.F 100] None.

Example holes_or_moves_instance :
  Forall (fun p => forallb (if makes_holes_in plain_setup p then is_no_move else is_no_hole) (items p) = true)
    (fst (planned_from (fun _ => "") plain_setup [up; one_hole] 0 (initial plain_setup))).
Proof. apply holes_or_moves. Qed.

Lemma count_of_places {num} {N : Numbers num} travels numbers count (from : values num) :
  List.length (hole_places travels numbers count from) = count.
Proof. revert from; induction count as [|count IH]; intro from; [reflexivity|]. cbn. now rewrite IH. Qed.

(** fanuc.canned-cycle.repeats: a block that drills makes as many holes as it says. *)
Theorem holes_as_counted {num} {N : Numbers num} (s : setup num) c numbers st count :
  drilling (cycle st) <> None -> hole_count (block_of c) = Some count ->
  List.length (snd (cycle_step s c true numbers st)) = Z.to_nat count.
Proof.
  intros D C. unfold cycle_step. rewrite C. destruct (drilling (cycle st)) as [d|]; [|congruence]. cbv zeta.
  match goal with |- context [hole_places ?t ?n ?k ?p] => assert (L := count_of_places t n k p);
    destruct (hole_places t n k p) end; cbn [snd]; [exact L|now rewrite map_length].
Qed.

(** G81 X10 K3, in the mode, under G99. *)
Definition three_holes : command R :=
  Command (Block [natural Letter.X 10; natural Letter.K 3] None) [] None (initial_modes false) None None [] [] [].
Definition begun_at_20 : drilling_mode R := DrillingMode 810 Letter.Z 20%R (Some (Distance (-15)%R)) None None.
Definition in_the_mode : state R := with_cycle (initial plain_setup) (CycleState (Some begun_at_20) true).

Example holes_as_counted_instance :
  List.length (snd (cycle_step plain_setup three_holes true [Some 10%R; None; None] in_the_mode)) = 3%nat.
Proof. now apply (holes_as_counted plain_setup three_holes [Some 10%R; None; None] in_the_mode 3). Qed.

(** * The initial level *)

Lemma value_put (s : setup R) (v : values R) letter x : In letter (axes s) -> List.length v = List.length (axes s) ->
  value_on s (with_value s v letter x) letter = x.
Proof.
  unfold value_on, with_value, on_named, the_axis. revert v.
  induction (axes s) as [|a others IH]; intros [|y v] I L; cbn in L; try discriminate; [contradiction|]. cbn.
  assert (E : Letter.eqb letter a = Letter.eqb a letter).
  { unfold Letter.eqb.
    match goal with |- (if ?p then _ else _) = (if ?q then _ else _) => destruct p, q end; congruence. }
  rewrite E. destruct (Letter.eqb a letter) eqn:S; [reflexivity|]. apply IH; [|now injection L].
  destruct I as [->|I]; [|exact I]. unfold Letter.eqb in S.
  match type of S with (if ?p then _ else _) = _ => destruct p end; congruence.
Qed.

Lemma length_of_map2 {A B C} (f : A -> B -> C) xs ys : List.length ys = List.length xs ->
  List.length (map2 f xs ys) = List.length xs.
Proof. revert ys; induction xs as [|x xs IH]; intros [|y ys] L; cbn in *; try discriminate; auto. Qed.

Lemma length_of_place travels (numbers : some_values R) count from : List.length numbers = List.length from ->
  List.length (last (hole_places travels numbers count from) from) = List.length from.
Proof.
  assert (K : forall count here, List.length here = List.length numbers ->
    List.length (last (hole_places travels numbers count here) here) = List.length numbers).
  { clear. induction count as [|count IH]; intros here L; [exact L|]. cbn [hole_places].
    assert (L' : List.length (destination travels here numbers) = List.length numbers).
    { unfold destination. now rewrite length_of_map2. }
    specialize (IH _ L'). cbn [last].
    destruct (hole_places travels numbers count (destination travels here numbers)) as [|p ps]; [exact L'|].
    rewrite <- IH. clear. f_equal. revert p. induction ps as [|q ps IH]; intro p; [reflexivity|]. exact (IH q). }
  intro L. rewrite K; congruence.
Qed.

(** The initial level of a state in the mode. *)
Definition initial_level (s : setup R) (st : state R) : option R :=
  option_map (fun d => (value_on s (programmed st) (drilling_axis d) + rise d)%R) (drilling (cycle st)).

(** fanuc.canned-cycle.initial-level: a block of the mode leaves it where it was: under G98 and under G99, with holes
    and without. *)
Theorem initial_level_kept (s : setup R) c drills_ numbers st d :
  drilling (cycle st) = Some d -> In (drilling_axis d) (axes s) ->
  List.length (programmed st) = List.length (axes s) -> List.length numbers = List.length (axes s) ->
  initial_level s (fst (cycle_step s c drills_ numbers st)) = initial_level s st.
Proof.
  intros D I P L. unfold cycle_step. rewrite D. destruct drills_; [|reflexivity].
  destruct (hole_count (block_of c)) as [count|]; [|reflexivity]. cbv zeta.
  match goal with |- context [hole_places ?t ?n ?k ?p] => assert (M := length_of_place t n k p);
    destruct (hole_places t n k p) as [|q qs]; cbn [fst] end.
  - unfold initial_level. cbn. now rewrite D.
  - unfold initial_level.
    cbn [drilling cycle with_cycle option_map programmed at_position drilling_axis with_data rise].
    rewrite D. cbn [option_map]. f_equal. rewrite value_put; [|exact I|].
    + destruct (to_point_r (cycle st)); cbn; lra.
    + rewrite M; [exact P|]. unfold beside_drilling, the_axis. rewrite length_of_map2; rewrite map_length; congruence.
Qed.

Example initial_level_kept_instance :
  initial_level plain_setup (fst (cycle_step plain_setup three_holes true [Some 10%R; None; None] in_the_mode)) =
  Some 20%R.
Proof.
  rewrite (initial_level_kept _ _ _ _ _ begun_at_20);
    try reflexivity; cbn; [do 2 f_equal; lra|auto].
Qed.

(** fanuc.canned-cycle.return: behind holes the drilling axis stands at their level of the return, less the shift. *)
Theorem stands_at_the_return_level (s : setup R) c numbers st d h :
  drilling (cycle st) = Some d -> In (drilling_axis d) (axes s) ->
  List.length (programmed st) = List.length (axes s) -> List.length numbers = List.length (axes s) ->
  In h (snd (cycle_step s c true numbers st)) ->
  let st' := fst (cycle_step s c true numbers st) in
  return_level h = (value_on s (programmed st') (drilling_axis d) + value_on s (shift st') (drilling_axis d))%R.
Proof.
  intros D I P L J. cbv zeta. unfold cycle_step in *. rewrite D in *.
  destruct (hole_count (block_of c)) as [count|]; [|contradiction]. cbv zeta in *.
  match goal with |- context [hole_places ?t ?n ?k ?p] => assert (M := length_of_place t n k p);
    destruct (hole_places t n k p) as [|q qs]; cbn [fst snd] in * end; [contradiction|].
  apply in_map_iff in J as (y & <- & _).
  cbn [programmed shift with_cycle at_position return_level hole_at drilling_axis with_data].
  rewrite value_put; [reflexivity|exact I|]. rewrite M; [exact P|].
  unfold beside_drilling, the_axis. rewrite length_of_map2; rewrite map_length; congruence.
Qed.

Example stands_at_the_return_level_instance h :
  let after := cycle_step plain_setup three_holes true [Some 10%R; None; None] in_the_mode in
  In h (snd after) ->
  return_level h = (value_on plain_setup (programmed (fst after)) Letter.Z +
                    value_on plain_setup (shift (fst after)) Letter.Z)%R.
Proof.
  intros after J. apply (stands_at_the_return_level _ _ _ _ begun_at_20);
    try reflexivity; [cbn; auto|exact J].
Qed.
