(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the definitions and calls of drilling cycles in a Klartext run. *)
From Coq Require Import List String ZArith Bool Reals Lra.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool.
From Toolcomp Require Import KlartextPeripheral KlartextState KlartextMoves KlartextDrilling KlartextProgram.
From Toolcomp Require Import OutcomeLaws KlartextLaws RetractionLaws PeripheralLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** What the parts of a hole are. *)
Lemma drilled_as_said {num} {N : Numbers num} (s : klartext_setup num) st st' d :
  drill s st = Got (st', Some d) -> exists second : bool,
  let axis := axis_of_tool (tool_of st) in
  let surface := (at_letter s axis (datum st) + q_value st 203)%num in
  let level := (surface + if second then q_value st 204 else q_value st 200)%num in
  is_positive "heidenhain.program.cycle-return" (q_value st 204 - q_value st 200)%num = Got second /\
  existsb (fun letter => negb (Letter.eqb letter axis)) (unknown_axes st) = false /\
  point_r_level (hole_of d) = (surface + q_value st 200)%num /\
  bottom_level (hole_of d) = (surface + q_value st 201)%num /\ return_level (hole_of d) = level /\
  positions_behind (hole_of d) =
    with_axis s axis (level + of_length (total_deltas (tool_now st)))%num (with_axis s axis level (position st)) /\
  st' = at_end_of_motion (with_axis s axis level (position st)) [] None st.
Proof.
  unfold drill. intro H. apply bound in H as (nothing & _ & H). destruct nothing; [discriminate|].
  apply bound in H as (? & K & H). apply no_alarm in K. apply bound in H as (second & P & H). exists second.
  apply same in H. injection H as <- <-. repeat split; assumption.
Qed.

Lemma with_axis_length {num} (s : klartext_setup num) axis x v :
  List.length v = List.length (letters s) -> List.length (with_axis s axis x v) = List.length (letters s).
Proof.
  unfold with_axis. generalize (letters s). intro axes; revert v.
  induction axes as [|a axes IH]; intros [|b v] L; try discriminate; [reflexivity|].
  cbn in *. f_equal. apply IH. now injection L.
Qed.

Lemma with_axis_at {num} {N : Numbers num} (s : klartext_setup num) axis x v letter :
  List.length v = List.length (letters s) -> In letter (letters s) ->
  at_letter s letter (with_axis s axis x v) = if Letter.eqb letter axis then x else at_letter s letter v.
Proof. intros L I. unfold with_axis. now rewrite (at_letter_map2 s). Qed.

(** CYCL DEF 200 Q200=+2 Q201=-15 Q203=+1 Q204=+50, with Z lost. *)
Definition q (index : Z) (x : R) : q_parameter * written R := (QParameter OfQ index, Literal x).
Definition depth_15 : list (q_parameter * written R) := [q 200 2; q 201 (-15); q 203 1; q 204 50].
Definition ready : klartext_state R := assigned depth_15 lost_z.

Lemma ready_drills shift : exists st d, drill plain_control (with_datum shift ready) = Got (st, Some d).
Proof.
  unfold drill. change (q_value (with_datum shift ready)) with (q_value ready).
  change (q_value ready 201) with (-15)%R. rewrite is_not_zero by lra. cbn [bind].
  unfold is_positive. destruct (decides "heidenhain.program.cycle-return" (q_value ready 204 - q_value ready 200)%num) as
    [c D]. rewrite D. cbn. eauto.
Qed.

(** * Definitions *)

(** heidenhain.program.drilling-cycle, heidenhain.program.parameter-value: a definition does what assignments of its
    parameters do, one behind the other, and nothing else. *)
Theorem definition_is_assignments {num} {N : Numbers num} (s : klartext_setup num) number p v sets st :
  let defines sets := KlartextBlock (Cycle number 0 [] sets) [] None in
  let assigns := KlartextBlock (Assignment p v) [] None in
  whole_block s (defines []) st = Got (st, None, None) /\
  whole_block s (defines (sets ++ [(p, v)])) st =
    ('(st, _, _) <- whole_block s (defines sets) st ;; whole_block s assigns st).
Proof.
  intros defines assigns.
  assert (D : forall sets, whole_block s (defines sets) st = Got (assigned sets st, None, None)).
  { intro all. unfold whole_block, klartext_step; cbn. now rewrite andb_false_r. }
  split; [exact (D [])|]. rewrite !D. unfold assigned. rewrite fold_left_app. reflexivity.
Qed.

(** Q201 = -Q200 takes the value that Q200 has just been given. *)
Example definition_is_assignments_instance :
  let as_200 := (QParameter OfQ 201, OfParameter (QParameter OfQ 200) true) in
  whole_block plain_control (says_only (Cycle 200 0 [] [q 200 2; as_200])) at_start =
  whole_block plain_control (says_only (Assignment (QParameter OfQ 201) (OfParameter (QParameter OfQ 200) true)))
    (with_parameter (QParameter OfQ 200) 2%R at_start).
Proof.
  intro as_200. destruct (definition_is_assignments plain_control 200 (fst as_200) (snd as_200) [q 200 2] at_start) as [_ E].
  exact E.
Qed.

(** * Levels *)

(** heidenhain.program.cycle-return, heidenhain.program.cycle-call: the tool returns to where the hole begins or to the
    second set-up clearance, whichever is higher, and never below the former. *)
Theorem return_is_the_higher_clearance (s : klartext_setup R) st st' d :
  drill s st = Got (st', Some d) ->
  let h := hole_of d in
  let second := (at_letter s (axis_of_tool (tool_of st)) (datum st) + q_value st 203 + q_value st 204)%R in
  return_level h = Rmax (point_r_level h) second /\ (point_r_level h <= return_level h)%R.
Proof.
  intros H h second. apply drilled_as_said in H as (higher & P & _ & r & _ & l & _). fold h in r, l.
  apply positive_sign in P. assert (E : return_level h = Rmax (point_r_level h) second).
  { rewrite r, l. unfold second. cbn in *. destruct higher.
    - assert (0 < q_value st 204 - q_value st 200)%R by now apply P. rewrite Rmax_right; lra.
    - assert (~ 0 < q_value st 204 - q_value st 200)%R by now apply (no_is _ _ P). rewrite Rmax_left; lra. }
  split; [exact E|]. rewrite E. apply Rmax_l.
Qed.

Example return_is_the_higher_clearance_instance :
  exists st d, drill plain_control ready = Got (st, Some d) /\ return_level (hole_of d) = Rmax (0 + 1 + 2) (0 + 1 + 50).
Proof.
  destruct (ready_drills (datum ready)) as (st & d & H). exists st, d. split; [exact H|].
  destruct (return_is_the_higher_clearance _ _ _ _ H) as [E _]. rewrite E.
  apply drilled_as_said in H as (? & _ & _ & r & _). rewrite r. reflexivity.
Qed.

(** heidenhain.program.datum-shift, heidenhain.program.cycle-call, heidenhain.program.cycle-return: the datum of the tool
    axis shifted by so much shifts all levels of a hole by as much. *)
Theorem shifted_datum_shifted_levels (s : klartext_setup R) st shifted by_ st1 st2 d1 d2 :
  drill s st = Got (st1, Some d1) -> drill s (with_datum shifted st) = Got (st2, Some d2) ->
  let axis := axis_of_tool (tool_of st) in
  at_letter s axis shifted = (at_letter s axis (datum st) + by_)%R ->
  point_r_level (hole_of d2) = (point_r_level (hole_of d1) + by_)%R /\
  bottom_level (hole_of d2) = (bottom_level (hole_of d1) + by_)%R /\
  return_level (hole_of d2) = (return_level (hole_of d1) + by_)%R.
Proof.
  intros H1 H2 axis E. apply drilled_as_said in H1 as (second & P1 & _ & r1 & b1 & l1 & _).
  apply drilled_as_said in H2 as (second' & P2 & _ & r2 & b2 & l2 & _).
  change (q_value (with_datum shifted st)) with (q_value st) in *.
  change (axis_of_tool (tool_of (with_datum shifted st))) with axis in *. fold axis in r1, b1, l1.
  cbn [datum with_datum] in *. rewrite P1 in P2. apply same in P2 as <-.
  rewrite r1, b1, l1, r2, b2, l2, E. cbn. repeat split; ring.
Qed.

Example shifted_datum_shifted_levels_instance :
  exists st1 st2 d1 d2, drill plain_control ready = Got (st1, Some d1) /\
  drill plain_control (with_datum [0; 0; 7; 0]%R ready) = Got (st2, Some d2) /\
  bottom_level (hole_of d2) = (bottom_level (hole_of d1) + 7)%R.
Proof.
  destruct (ready_drills [0; 0; 0; 0]%R) as (st1 & d1 & H1), (ready_drills [0; 0; 7; 0]%R) as (st2 & d2 & H2).
  exists st1, st2, d1, d2. split; [exact H1|]. split; [exact H2|].
  apply (shifted_datum_shifted_levels _ _ _ 7 _ _ _ _ H1 H2). cbn. ring.
Qed.

(** * Behind a hole *)

(** heidenhain.program.cycle-return, heidenhain.program.unknown-position: behind a hole nothing is unknown, and the
    programmed position is the return level in the tool axis, and in all others what it was. *)
Theorem call_moves_the_tool_axis_alone {num} {N : Numbers num} (s : klartext_setup num) st st' d letter :
  drill s st = Got (st', Some d) -> List.length (position st) = List.length (letters s) -> In letter (letters s) ->
  let axis := axis_of_tool (tool_of st) in
  unknown_axes st' = [] /\
  at_letter s letter (position st') =
    (if Letter.eqb letter axis then return_level (hole_of d) else at_letter s letter (position st)) /\
  at_letter s letter (positions_behind (hole_of d)) =
    (if Letter.eqb letter axis then return_level (hole_of d) + of_length (total_deltas (tool_now st))
     else at_letter s letter (position st))%num.
Proof.
  intros H L I axis. apply drilled_as_said in H as (second & _ & _ & _ & _ & l & b & ->). rewrite b, l.
  cbn [unknown_axes position at_end_of_motion]. fold axis. split; [reflexivity|].
  split; rewrite !with_axis_at by (auto using with_axis_length); [reflexivity|]. now destruct (Letter.eqb letter axis).
Qed.

Example call_moves_the_tool_axis_alone_instance :
  exists st d, drill plain_control ready = Got (st, Some d) /\ unknown_axes ready = [Letter.Z] /\ unknown_axes st = [] /\
  at_letter plain_control Letter.Z (position st) = return_level (hole_of d) /\
  at_letter plain_control Letter.X (position st) = 0%R.
Proof.
  destruct (ready_drills (datum ready)) as (st & d & H). exists st, d. split; [exact H|]. split; [reflexivity|].
  destruct (call_moves_the_tool_axis_alone _ _ _ _ Letter.Z H) as (U & Z & _); [reflexivity|cbn; auto|].
  destruct (call_moves_the_tool_axis_alone _ _ _ _ Letter.X H) as (_ & X & _); [reflexivity|cbn; auto|]. auto.
Qed.

(** heidenhain.program.cycle-call: with Q201 = 0 a block does what it does without the call. *)
Theorem depth_0_changes_nothing (s : klartext_setup R) b st st' p :
  klartext_step s b st = Got (st', p) -> q_value st' 201 = 0%R -> whole_block s b st = Got (st', p, None).
Proof.
  intros H Q. unfold whole_block. rewrite H. cbn [bind]. unfold drill. rewrite Q, zero_is_zero. now destruct (calls_cycle b).
Qed.

Example depth_0_changes_nothing_instance :
  whole_block plain_control (says_only CycleCall) at_start = Got (at_start, None, None).
Proof. now apply depth_0_changes_nothing. Qed.

(** heidenhain.program.cycle-call, heidenhain.peripheral.cancel: a block that waits for the next one that moves waits for a
    hole as for a motion of L under R0, and as behind such a motion nothing behind the hole has the cause cancel. *)
Theorem hole_is_a_motion_under_r0 {num} {N : Numbers num} (s : klartext_setup num) d p at_ more prior tip shift touch :
  way_of p = Known tip shift touch -> travel (ends (motion_of p)) = travel_to_hole d ->
  following_of (Drilling at_ d :: more) = following_of (Moving at_ p :: more) /\
  exists of_hole of_motion,
    events_of s (Drilling at_ d :: more) prior = of_hole ++ events_of s more None /\
    events_of s (Moving at_ p :: more) prior = of_motion ++ events_of s more None.
Proof.
  intros W T. cbn [following_of events_of]. rewrite W, T. split; [reflexivity|]. eexists [_], _. split; reflexivity.
Qed.

Definition down : drilled R := DrilledHole (Hole 2 [5; 0; 3; 0]%R 3 (-14) 3 [5; 0; 3; 0])%R (Some (0, 0, -2)%R).
Definition as_down : planned R :=
  Planned [] (Motion true None (Ending [5; 0; 3; 0]%R [] (Some (0, 0, -2)%R)) [] (0, 0, 1)%R 0%R None 1%R)
    (Known (5, 0, 3)%R zero3 None).

Example hole_is_a_motion_under_r0_instance :
  following_of [Drilling 1 down; Moving 2 beside_block] = following_of [Moving 1 as_down; Moving 2 beside_block].
Proof. now apply (hole_is_a_motion_under_r0 plain_control down as_down 1 _ (Some None) (5, 0, 3)%R zero3 None). Qed.
