(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of whole programs: they hold for every program and every setup. *)
From Coq Require Import List String ZArith Bool Reals Lra.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ToolShift Measurement State.
From Toolcomp Require Import Movements OwnMove Compensation Program OutcomeLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * How a run goes *)

(** fanuc.program.end: how blocks run before anything compensates them depends on these blocks alone, whatever follows:
    look-ahead is the compensations' alone. *)
Theorem earlier_blocks_stay {num} {N : Numbers num} decimal (s : setup num) bs more place st :
  exists later, fst (planned_from decimal s (bs ++ more) place st) = fst (planned_from decimal s bs place st) ++ later.
Proof.
  revert place st; induction bs as [|b bs IH]; intros place st; cbn -[step]; [eexists; reflexivity|].
  destruct (step decimal s place b st) as [[r [number|]]| |]; cbn -[step]; try (exists []; reflexivity).
  destruct (ends b); cbn -[step]; [exists []; reflexivity|].
  destruct (IH (S place) (behind r)) as [later IH'].
  destruct (planned_from decimal s (bs ++ more) (S place) (behind r)) as [all how].
  destruct (planned_from decimal s bs (S place) (behind r)) as [some how'].
  cbn -[step] in *. exists later. now rewrite IH'.
Qed.

Definition plain_setup : setup R :=
  Setup [Letter.X; Letter.Y; Letter.Z] false IS_B (fun _ => None) (fun _ => None) (fun _ => None) MemoryA 99 [(1%Z, (5%R, 0%R))] [] false
    (repeat (repeat 0%R 3) 6) (repeat 0%R 3) [] (repeat 0%R 3) [] (repeat 0%R 3)
    [None; None; Some 100%R] false 0%Z false false false false None.
Definition natural letter (value : Z) : word R := Word letter (IZR value) (Some (10 * value)%Z) false false.
Definition up : block R := Block [natural Letter.G 43; natural Letter.Z 10; natural Letter.H 1] None.

Example earlier_blocks_stay_instance : exists later,
  fst (planned_from (fun _ => "") plain_setup ([up] ++ [up]) 0 (initial plain_setup)) =
  fst (planned_from (fun _ => "") plain_setup [up] 0 (initial plain_setup)) ++ later.
Proof. apply earlier_blocks_stay. Qed.

(** fanuc.program.end: nothing comes behind the block with M02 or M30. *)
Theorem nothing_behind_the_end {num} {N : Numbers num} decimal (s : setup num) b more place st :
  ends b = true -> planned_from decimal s (b :: more) place st = planned_from decimal s [b] place st.
Proof.
  intro E; cbn -[step]. destruct (step decimal s place b st) as [[r [number|]]| |]; [reflexivity| |reflexivity..].
  now rewrite E.
Qed.

Definition last_block : block R := Block [natural Letter.M 30] None.

Example nothing_behind_the_end_instance :
  planned_from (fun _ => "") plain_setup [last_block; up] 0 (initial plain_setup) =
  planned_from (fun _ => "") plain_setup [last_block] 0 (initial plain_setup).
Proof. now apply nothing_behind_the_end. Qed.

(** An event that ends the run. *)
Definition final {num} (e : event num) : bool := match e with Raised _ | NotDecided _ => true | _ => false end.

Lemma nothing_final_in_blocks {num} {N : Numbers num} (blocks : list (planned num)) :
  existsb final (map snd (flat_map (fun b => map (fun i => (at_place b, event_of i)) (items b)) blocks)) = false.
Proof.
  induction blocks as [|b blocks IH]; [reflexivity|]. cbn [flat_map]. rewrite map_app, existsb_app, IH, orb_false_r.
  rewrite map_map. cbn. induction (items b) as [|i rest IH']; [reflexivity|]. cbn. rewrite IH'. now destruct i.
Qed.

(** fanuc.program.unreadable-block: every alarm ends the run, and nothing follows it; so does what cannot be decided. In
    every section, whatever its compensation does. *)
Theorem alarm_is_last {num} {N : Numbers num} decimal (s : setup num) bs :
  nothing_behind final (map snd (fst (run_program decimal s bs))).
Proof.
  unfold run_program; cbn [fst]. unfold events_of. rewrite map_app. apply nothing_behind_app.
  - apply nothing_final_in_blocks.
  - destruct (snd (compensated s (planned_from decimal s bs 0 (initial s)))); cbn; auto.
Qed.

Definition unknown_code : block R := Block [natural Letter.G 27] None.

Example alarm_is_last_instance : nothing_behind final
  (map snd (fst (run_program (fun _ => "") plain_setup [up; unknown_code; up]))).
Proof. apply alarm_is_last. Qed.

(** * Moves *)

(** fanuc.program.own-move: a block with an axis word, of its own path, makes exactly one move, even where nothing moves;
    so does an arc. *)
Theorem one_own_move {num} {N : Numbers num} (s : setup num) numbers b circle_of changed longer st st' events :
  own_move s numbers b circle_of changed longer st = Got (st', events) ->
  circle_of <> None \/ empty (which numbers) = false -> exists m, events = [m].
Proof.
  unfold own_move; intros H O. destruct circle_of as [c|].
  - apply bound in H; destruct H as (? & _ & H).
    repeat match type of H with (let '(_, _) := ?x in _) = Got _ => destruct x end.
    injection H as _ <-. eexists; reflexivity.
  - destruct O as [O|O]; [congruence|].
    apply bound in H; destruct H as (? & _ & H). rewrite O in H. injection H as _ <-. eexists; reflexivity.
Qed.

Example one_own_move_instance st' events :
  own_move plain_setup [None; None; Some 10%R] up None false None (initial plain_setup) = Got (st', events) ->
  exists m, events = [m].
Proof. intro H. eapply one_own_move; [exact H|right; reflexivity]. Qed.

(** fanuc.length-offset.move-without-axis-word: without an axis word and without a change of the offset there is none. *)
Theorem no_move_without_cause {num} {N : Numbers num} (s : setup num) numbers b st st' events :
  own_move s numbers b None false None st = Got (st', events) -> empty (which numbers) = true -> events = [].
Proof. unfold own_move; intros H O. cbn in H. rewrite O in H. now injection H as _ <-. Qed.

Example no_move_without_cause_instance st' events :
  own_move plain_setup [None; None; None] up None false None (initial plain_setup) = Got (st', events) -> events = [].
Proof. intro H. eapply no_move_without_cause; [exact H|reflexivity]. Qed.

(** * Positions *)

(** fanuc.program.incremental: the text in G91 of a path, written for where it begins, leads to where the text in G90
    does. *)
Theorem incremental_is_absolute (from : values R) (ends_at : some_values R) :
  destination true from (map2 (fun x end_ => option_map (fun y => (y - x)%R) end_) from ends_at) =
  destination false from ends_at.
Proof.
  revert ends_at; induction from as [|x from IH]; intros [|e ends_at]; try reflexivity.
  unfold destination in *; cbn in *. rewrite IH. f_equal. destruct e; cbn; [lra|reflexivity].
Qed.

Example incremental_is_absolute_instance :
  destination true [1%R; 2%R] (map2 (fun x end_ => option_map (fun y => (y - x)%R) end_) [1%R; 2%R] [Some 5%R; None]) =
  [5%R; 2%R].
Proof. now rewrite incremental_is_absolute. Qed.

Lemma sum_zero (v zero : values R) : List.length zero = List.length v -> Forall (fun x => x = 0%R) zero -> sum v zero = v.
Proof.
  revert zero; induction v as [|x v IH]; intros [|z zero] L Z; cbn in *; try discriminate; [reflexivity|].
  inversion Z as [|? ? Z0 Z']; subst. f_equal; [cbn; lra|]. apply IH; [now injection L|assumption].
Qed.

(** fanuc.tool-offset.shift: without shift and offset the axes go where it is programmed. *)
Theorem uncompensated_is_programmed (s : setup R) t c machine a st :
  let zero := map (fun _ => 0%R) (programmed st) in
  shift st = zero ->
  sum (programmed st) (zeros s) = programmed st ->
  let m := move_of (move_to s t c machine a st zero) in
  tool_point m = programmed_end m /\ axis_positions m = programmed_end m.
Proof.
  cbv zeta; intros S H. unfold move_to, move_of. cbn. rewrite S.
  assert (Z : sum (programmed st) (map (fun _ => 0%R) (programmed st)) = programmed st).
  { apply sum_zero; [apply map_length|]. apply Forall_forall. intros x I. apply in_map_iff in I as (? & I & _); auto. }
  rewrite !Z, H, Z. now split.
Qed.

Example uncompensated_is_programmed_instance :
  let m := move_of (move_to plain_setup Rapid Programmed false None (initial plain_setup) [0%R; 0%R; 0%R]) in
  tool_point m = programmed_end m /\ axis_positions m = programmed_end m.
Proof.
  apply (uncompensated_is_programmed plain_setup Rapid Programmed false None (initial plain_setup)); [reflexivity|].
  cbn. now rewrite !Rplus_0_r.
Qed.

(** * The length offset *)

(** fanuc.length-offset.cancel: behind a block with G49 no axis is offset, whatever was in force. *)
Theorem cancelled_is_zero {num} {N : Numbers num} (s : setup num) o c l on_way at_end :
  length_step s o c l = Got (on_way, at_end) -> code c = Some G49 -> vector at_end = zeros s /\ in_force at_end = None.
Proof.
  unfold length_step; intros H C. rewrite C in H. cbv zeta in H.
  apply bound in H; destruct H as (l' & E & H).
  unfold cancel in E. apply bound in E; destruct E as (? & _ & E). apply bound in E; destruct E as (? & _ & E).
  injection E as <-. cbn in H. injection H as _ <-. now split.
Qed.

Definition g49 := LengthCommand (Some G49) None XY [false; false; false] true false [false; false; false].

Example cancelled_is_zero_instance on_way at_end :
  length_step plain_setup (given_offsets plain_setup) g49 (no_length_offset plain_setup) = Got (on_way, at_end) ->
  vector at_end = [0%R; 0%R; 0%R] /\ in_force at_end = None.
Proof. intro H. eapply cancelled_is_zero in H; [exact H|reflexivity]. Qed.

(** fanuc.length-offset.direction: G44 with a value is G43 with the negative value. *)
Theorem other_code_negative_value (set : axis_set) (x : R) (v : values R) :
  offset_on set (signed Subtract x) v = offset_on set (signed Add (- x)%R) v.
Proof. unfold signed; cbn. now replace (0 - x)%R with (- x)%R by lra. Qed.

Example other_code_negative_value_instance :
  offset_on [false; true] (signed Subtract 4%R) [1%R; 2%R] = [1%R; (- (4))%R].
Proof. now rewrite other_code_negative_value. Qed.

(** fanuc.length-offset.replaces: a second offset on the same axes leaves nothing of the first. *)
Theorem later_offset_replaces (set : axis_set) (x y : R) (v : values R) :
  offset_on set y (offset_on set x v) = offset_on set y v.
Proof.
  revert v; induction set as [|here set IH]; intros [|e v]; try reflexivity.
  unfold offset_on in *; cbn. rewrite IH. now destruct here.
Qed.

Example later_offset_replaces_instance : offset_on [true] 3%R (offset_on [true] 2%R [1%R]) = [3%R].
Proof. now rewrite later_offset_replaces. Qed.

(** fanuc.program.workpiece-system: a change of coordinates moves nothing: the machine position stays. *)
Theorem renaming_moves_nothing (s : setup R) (before after : coordinates R) (position : values R) :
  List.length (work_zero s before) = List.length position -> List.length (work_zero s after) = List.length position ->
  sum (renamed s before after position) (work_zero s after) = sum position (work_zero s before).
Proof.
  unfold renamed. generalize (work_zero s before) as old, (work_zero s after) as new.
  induction position as [|x position IH]; intros [|o old] [|n new] L L'; cbn in *; try discriminate; [reflexivity|].
  f_equal; [lra|]. apply IH; congruence.
Qed.

Example renaming_moves_nothing_instance (c : coordinates R) :
  let c := given_coordinates plain_setup in
  let shifted := with_shift plain_setup [Some 7%R; None; None] [1%R; 2%R; 3%R] c in
  sum (renamed plain_setup c shifted [1%R; 2%R; 3%R]) (work_zero plain_setup shifted) =
  sum [1%R; 2%R; 3%R] (work_zero plain_setup c).
Proof. cbv zeta. now apply renaming_moves_nothing. Qed.

(** * The tool offset *)

(** fanuc.tool-offset.increase: G45 with a value is G46 with the negative value, and G47 is G48 with it. *)
Theorem lengthen_negative_is_shorten (x : R) :
  lengthening (Some Lengthen) (- x)%R = lengthening (Some Shorten) x /\
  lengthening (Some LengthenTwice) (- x)%R = lengthening (Some ShortenTwice) x.
Proof. cbn; split; f_equal; lra. Qed.

Example lengthen_negative_is_shorten_instance : lengthening (Some Lengthen) (- (4))%R = lengthening (Some Shorten) 4%R.
Proof. apply lengthen_negative_is_shorten. Qed.

(** fanuc.tool-offset.direction: on a travel turned round the shift grows the other way. *)
Theorem turned_travel_turned_growth (longer : R) (positive : bool) :
  growth longer (Some (negb positive)) = (- growth longer (Some positive))%R.
Proof. destruct positive; cbn; lra. Qed.

Example turned_travel_turned_growth_instance : growth 4%R (Some false) = (- (4))%R.
Proof. apply (turned_travel_turned_growth 4 true). Qed.

(** * The measurement *)

(** fanuc.length-measurement.value: where G37 finds the tool as long as its offset says, nothing changes. *)
Theorem right_offset_measures_nothing (s : setup R) (o : offsets R) number :
  let w := measured s o number 0%R in
  (of_wear w = false -> for_h w = fst (entry_of ByH o number)) /\
  (of_wear w = true -> for_h w = snd (entry_of ByH o number)).
Proof.
  cbv zeta; unfold measured. destruct (memory s); destruct (entry_of ByH o number); cbn; split; intro; try discriminate; lra.
Qed.

Example right_offset_measures_nothing_instance :
  for_h (measured plain_setup (given_offsets plain_setup) 1 0%R) = 5%R.
Proof. apply (right_offset_measures_nothing plain_setup (given_offsets plain_setup) 1). reflexivity. Qed.

(** fanuc.length-measurement.too-late: without a signal the axis stops half the zone behind the coordinate, with PS0080. *)
Theorem no_signal_stops_behind_the_zone (s : setup R) (a d : R) : (a < d)%R -> exists path,
  measure s a d None = Got path /\ reached path = (d + zone s)%R /\ in_zone path = false.
Proof.
  intro O. unfold measure, is_positive, decide. cbn [sign reals minus].
  replace (real_sign (d - a)) with (Some Gt).
  2: { unfold real_sign. destruct (total_order_T (d - a) 0) as [[L|E]|G]; [lra|lra|reflexivity]. }
  cbn [bind]. unfold real_sign. cbn [bind]. eexists; repeat split.
Qed.

Example no_signal_stops_behind_the_zone_instance : exists path,
  measure plain_setup 0%R 200%R None = Got path /\ reached path = (200 + zone plain_setup)%R /\ in_zone path = false.
Proof. apply no_signal_stops_behind_the_zone; lra. Qed.
