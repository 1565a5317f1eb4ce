(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the corners of cutter compensation C: the vectors between two lines keep the distance of the offset from
    them. *)
From Coq Require Import Reals Lra Psatz Bool ZArith List.
From Coq Require String.
From Toolcomp Require Import Vectors CutterCompensationC OutcomeLaws SpecifiedCorners.
From Toolcomp Require Numbers Outcomes Arcs Corners CutterState State Movements CutterRules CutterModes CutterC
  CutterLaws.
Import Outcomes(outcome(..)).
Import ListNotations.
Open Scope R_scope.

(** * Groups *)

Lemma zero_vector : vector Corners.zero2 = zero.
Proof. reflexivity. Qed.
Lemma first_of vs : vector (hd Corners.zero2 vs) = hd zero (map vector vs).
Proof. now destruct vs. Qed.
Lemma last_of vs : vector (last vs Corners.zero2) = last (map vector vs) zero.
Proof.
  induction vs as [|v [|w vs] IH]; [reflexivity..|]. exact IH.
Qed.

Lemma flat_perpendicular rho t : direction t -> on_offset_line rho t (perpendicular rho t).
Proof. intro D. rewrite <- (M_straight_on rho t D). apply M_on_both_lines; auto. destruct D as [_ E]. rewrite E. lra.
Qed.

Lemma group_on_lines rho t1 t2 : direction t1 -> direction t2 -> rho <> 0 ->
  on_offset_line rho t1 (hd zero (group rho t1 t2)) /\ on_offset_line rho t2 (last (group rho t1 t2) zero).
Proof.
  intros A B R. pose proof (cosine_sine t1 t2 A B) as S. unfold Rsqr in S. unfold group.
  destruct (Rlt_dec 0 (rho * turn t1 t2)) as [L|L]; [|destruct (Rle_dec 0 (dot t1 t2))]; cbn [hd last].
  - apply M_on_both_lines; auto. intro K. assert (turn t1 t2 = 0) by nra. rewrite H in L. lra.
  - apply M_on_both_lines; auto. lra.
  - split; [apply Q1_past_the_corner|apply Q2_before_the_corner]; auto.
Qed.

(** * Corners of blocks *)

Lemma line_behind s b : CutterRules.arc_run (CutterC.moves_of b) = None ->
  CutterC.leg_behind s b =
  line_of (CutterRules.travel_in_plane s (Movements.command_of b) (Movements.before b) (Movements.behind b))
    (CutterC.rho_of (State.cutter (Movements.behind b))).
Proof. intro L. unfold CutterC.leg_behind, CutterModes.end_leg. now rewrite L. Qed.

(** A straight block of the mode, with its travel. *)
Definition straight s (b : Movements.planned R) (u : Arcs.pair R) : Prop :=
  CutterRules.arc_run (CutterC.moves_of b) = None /\
  CutterModes.way_to_intermediate s (Movements.command_of b) (Movements.before b) (CutterC.moves_of b) = None /\
  CutterRules.travel_in_plane s (Movements.command_of b) (Movements.before b) (Movements.behind b) = u /\ travels u.

Lemma legs_of_straight s b u rho : straight s b u ->
  CutterC.leg_behind s b = line_of u (CutterC.rho_of (State.cutter (Movements.behind b))) /\
  CutterC.leg_before s b rho = line_of u rho.
Proof.
  intros (A & W & <- & _). split; [now apply line_behind|]. unfold CutterC.leg_before. now rewrite A, W.
Qed.

Lemma parallel_ways u v : travels u -> travels v -> (Corners.aside u v = 0 <-> turn (tangent u) (tangent v) = 0).
Proof.
  intros U V. destruct (by_tangents u v U V) as (k & K & T & _). rewrite T. split; intro E; [|rewrite E; ring].
  apply Rmult_integral in E as [E|E]; lra.
Qed.

Lemma no_arc_of_line u rho : Corners.of_arc (line_of u rho) = [].
Proof. reflexivity. Qed.

Lemma obtuse_meets u v rho : travels u -> travels v -> rho <> 0 ->
  Corners.corner_of (line_of u rho) (line_of v rho) = Got Corners.Obtuse ->
  on_offset_line rho (tangent u) (M rho (tangent u) (tangent v)) /\
  on_offset_line rho (tangent v) (M rho (tangent u) (tangent v)).
Proof.
  intros U V R K. pose proof (tangent_direction u U) as DU. pose proof (tangent_direction v V) as DV.
  apply M_on_both_lines; auto. unfold Corners.corner_of in K. apply bound in K as (side & SD & K). apply decided in SD.
  destruct side; [apply bound in K as (back & _ & K); destruct back; now apply same in K| |now apply same in K].
  intro E. assert (T : turn (tangent u) (tangent v) = 0).
  { pose proof (cosine_sine _ _ DU DV) as Q. unfold Rsqr in Q. nra. }
  apply (parallel_ways u v U V) in T. change (Corners.way (line_of u rho)) with u in SD.
  change (Corners.way (line_of v rho)) with v in SD. rewrite T in SD. cbn in SD. lra.
Qed.

(** The side and the value of a corner, at the block before it and at the one behind it. *)
Definition offset_before (a : Movements.planned R) : R := CutterC.rho_of (State.cutter (Movements.behind a)).
Definition offset_behind (a b : Movements.planned R) : R :=
  CutterModes.offset_of (CutterState.was_left (State.cutter (Movements.behind b)))
    (CutterState.reach (State.cutter (Movements.behind a))).

(** fanuc.cutter-c.which-rule: at every corner between two lines of the mode the tool comes to a vector at the distance
    of the offset from the line before, and leaves from one at that distance from the line behind: outer, inner,
    straight on and back. *)
Theorem corner_keeps_distance s a b u v vs :
  CutterC.corner_group s a b false = Got vs -> straight s a u -> straight s b v ->
  CutterC.part_of a = CutterState.ModeBlock -> CutterC.part_of b = CutterState.ModeBlock ->
  CutterState.was_left (State.cutter (Movements.behind a)) = CutterState.was_left (State.cutter (Movements.behind b)) ->
  CutterState.reach (State.cutter (Movements.behind a)) <> 0 ->
  on_offset_line (offset_before a) (tangent u) (vector (hd Corners.zero2 vs)) /\
  on_offset_line (offset_behind a b) (tangent v) (vector (last vs Corners.zero2)).
Proof.
  intros H A B PA PB S R. unfold CutterC.corner_group in H. rewrite PA, PB, S, Bool.eqb_reflx in H.
  apply bound in H as (nothing & N & H). apply zero_sign in N. destruct nothing; [destruct R; now apply N|].
  cbn [negb andb] in H. pose proof (legs_of_straight s a u 0 A) as [LA _].
  pose proof (legs_of_straight s b v (CutterC.rho_of (State.cutter (Movements.behind a))) B) as [_ LB].
  rewrite LA, LB in H. destruct A as (_ & _ & _ & U). destruct B as (_ & _ & _ & V).
  assert (O : CutterC.rho_of (State.cutter (Movements.behind a)) <> 0).
  { unfold CutterC.rho_of. destruct (CutterState.was_left _); cbn; lra. }
  apply mode_group_is_group in H; auto. rewrite first_of, last_of, H.
  assert (E : offset_behind a b = offset_before a) by (unfold offset_behind, offset_before, CutterC.rho_of;
    now rewrite S).
  rewrite E. apply group_on_lines; auto using tangent_direction.
Qed.

(** A corner with all that the theorem asks of it: a square one to the right, offset to the left by 5. *)
Definition plain_axes : Words.setup R := ProgramLaws.plain_setup.
Definition in_mode (x y : R) (part_ : CutterState.part) : State.state R :=
  State.with_cutter (State.at_position (State.initial plain_axes) [x; y; 0] [0; 0; 0])
    (CutterState.CutterState (Some CutterState.LeftHand) 5 CutterState.Running Corners.zero2 5 true part_).
Definition leg_of_mode (x y x' y' : R) : Movements.planned R :=
  Movements.Planned 0 (State.Command ProgramLaws.up [10%Z] None (Codes.initial_modes false) None None [] [] [])
    (in_mode x y CutterState.ModeBlock) (in_mode x' y' CutterState.ModeBlock) [].

Lemma travel_of_mode x y x' y' :
  straight plain_axes (leg_of_mode x y x' y') (x' + 0 - (x + 0), y' + 0 - (y + 0)) <-> x' - x <> 0 \/ y' - y <> 0.
Proof.
  unfold straight, travels; cbn. split; [intros (_ & _ & _ & T); lra|intro T; repeat split; lra].
Qed.

Example corner_keeps_distance_instance vs :
  CutterC.corner_group plain_axes (leg_of_mode 0 0 0 20) (leg_of_mode 0 20 20 20) false = Got vs ->
  on_offset_line 5 (tangent (0 + 0 - (0 + 0), 20 + 0 - (0 + 0))) (vector (hd Corners.zero2 vs)).
Proof.
  intro H. eapply (corner_keeps_distance plain_axes _ _ _ _ vs H); try reflexivity; try (apply travel_of_mode; lra).
  cbn. lra.
Qed.

(** fanuc.cutter-c.direction-change: at a change of the side between two lines at an angle the vector is at the distance
    of the offset from both, on the side of each. *)
Theorem side_change_keeps_distance s a b u v vs :
  CutterC.corner_group s a b false = Got vs -> straight s a u -> straight s b v -> Corners.aside u v <> 0 ->
  CutterC.part_of b = CutterState.ModeBlock ->
  CutterState.was_left (State.cutter (Movements.behind a)) <> CutterState.was_left (State.cutter (Movements.behind b))
    ->
  CutterState.reach (State.cutter (Movements.behind a)) <> 0 ->
  on_offset_line (offset_before a) (tangent u) (vector (hd Corners.zero2 vs)) /\
  on_offset_line (offset_behind a b) (tangent v) (vector (hd Corners.zero2 vs)).
Proof.
  intros H A B N PB S R. unfold CutterC.corner_group in H. rewrite PB in H.
  apply bound in H as (nothing & Z & H). apply zero_sign in Z. destruct nothing; [destruct R; now apply Z|].
  set (l := CutterState.was_left (State.cutter (Movements.behind a))) in *.
  set (l' := CutterState.was_left (State.cutter (Movements.behind b))) in *.
  assert (D : Bool.eqb l l' = false) by (destruct l, l'; try reflexivity; now destruct S). rewrite D in H.
  cbn [negb andb] in H. pose proof (legs_of_straight s a u 0 A) as [LA _].
  pose proof (legs_of_straight s b v (- CutterC.rho_of (State.cutter (Movements.behind a))) B) as [_ LB].
  assert (NEG : (Numbers.minus (Numbers.integer 0) (CutterC.rho_of (State.cutter (Movements.behind a)))) =
                - CutterC.rho_of (State.cutter (Movements.behind a))) by (cbn; ring).
  rewrite LA, NEG, LB in H. destruct A as (_ & _ & _ & U). destruct B as (_ & _ & _ & V).
  apply direction_change_is_direction_change in H; [|exact N]. rewrite first_of, H. cbn [hd].
  assert (E : offset_behind a b = - offset_before a).
  { unfold offset_behind, offset_before, CutterC.rho_of. fold l l'. destruct l, l'; try (now destruct S); cbn; ring. }
  rewrite E. apply direction_change_on_both_lines; auto using tangent_direction.
  intro K. apply N, (parallel_ways u v U V). pose proof (cosine_sine _ _ (tangent_direction u U) (tangent_direction v
    V)) as C.
  rewrite K in C. unfold Rsqr in C. nra.
Qed.

Definition other_side (b : Movements.planned R) : Movements.planned R :=
  let x := State.cutter (Movements.behind b) in
  Movements.Planned (Movements.at_place b) (Movements.command_of b) (Movements.before b)
    (State.with_cutter (Movements.behind b)
       (CutterState.CutterState (Some CutterState.RightHand) 5 CutterState.Running Corners.zero2 5 false
         (CutterState.plays x)))
    (Movements.items b).

Example side_change_keeps_distance_instance vs :
  CutterC.corner_group plain_axes (leg_of_mode 0 0 0 20) (other_side (leg_of_mode 0 20 20 20)) false = Got vs ->
  on_offset_line (- (5)) (tangent (20 + 0 - (0 + 0), 20 + 0 - (20 + 0))) (vector (hd Corners.zero2 vs)).
Proof.
  intro H. replace (- (5)) with (offset_behind (leg_of_mode 0 0 0 20) (other_side (leg_of_mode 0 20 20 20))) by (cbn;
    ring).
  eapply (side_change_keeps_distance plain_axes _ _ (0 + 0 - (0 + 0), 20 + 0 - (0 + 0)) _ vs H);
    try reflexivity; try (apply travel_of_mode; lra); try discriminate;
    first [unfold straight, travels; cbn; repeat split; lra | unfold Corners.aside; cbn; unfold Arcs.cross2; cbn; lra].
Qed.

(** fanuc.cutter-c.start-up-type: a start-up ends at the distance of the offset from the line behind it, in type A and
    B; and before a cancel the tool comes to that distance from the line before. *)
Theorem start_and_cancel_keep_distance s a b u v vs :
  CutterC.corner_group s a b false = Got vs -> straight s a u -> straight s b v ->
  CutterState.was_left (State.cutter (Movements.behind a)) = CutterState.was_left (State.cutter (Movements.behind b)) ->
  CutterState.reach (State.cutter (Movements.behind a)) <> 0 ->
  (CutterC.part_of a = CutterState.StartUpBlock -> CutterC.part_of b = CutterState.ModeBlock ->
   on_offset_line (offset_before a) (tangent v) (vector (last vs Corners.zero2))) /\
  (CutterC.part_of a = CutterState.ModeBlock -> CutterC.part_of b = CutterState.CancelBlock ->
   CutterC.cancel_direction s b = Got None -> on_offset_line (offset_before a) (tangent u) (vector (hd Corners.zero2
     vs))).
Proof.
  intros H A B S R. unfold CutterC.corner_group in H.
  apply bound in H as (nothing & Z & H). apply zero_sign in Z. destruct nothing; [destruct R; now apply Z|].
  rewrite S, Bool.eqb_reflx in H. cbn [negb andb] in H. rewrite andb_false_r in H.
  pose proof (legs_of_straight s a u 0 A) as [LA _].
  pose proof (legs_of_straight s b v (CutterC.rho_of (State.cutter (Movements.behind a))) B) as [_ LB].
  rewrite LA, LB in H. destruct A as (_ & _ & _ & U). destruct B as (_ & _ & _ & V).
  pose proof (tangent_direction u U) as DU. pose proof (tangent_direction v V) as DV. fold (offset_before a) in H.
  assert (O : offset_before a <> 0).
  { unfold offset_before, CutterC.rho_of. destruct (CutterState.was_left _); cbn; lra. }
  split; intros PA PB; [|intro C; rewrite C in H]; rewrite PA, PB in H; cbn [Outcomes.bind] in H.
  - rewrite last_of. unfold Corners.start_up_group in H.
    assert (P : forall ws, Got [Corners.perpendicular (line_of v (offset_before a))] = Got ws ->
                on_offset_line (offset_before a) (tangent v) (last (map vector ws) zero)).
    { intros ws E. apply same in E as <-. cbn [map last]. rewrite perpendicular_of_line. now apply flat_perpendicular. }
    destruct (negb (CutterModes.sup s)); [now apply P|]. apply bound in H as (kind & K & H).
    destruct kind; try (now apply P).
    + apply same in H as <-. rewrite no_arc_of_line. cbn [app map last]. rewrite tangents_meet_in_M.
      now apply (obtuse_meets u v).
    + apply bound in H as (tiny & _ & H). destruct tiny; [now apply P|]. apply bound in H as (both & Q & H).
      apply same in H as <-. rewrite no_arc_of_line, app_nil_r, map_app. apply (prolonged_in_Q u v) in Q. rewrite Q.
      cbn [map app last].
      apply Q2_before_the_corner; auto.
  - rewrite first_of. unfold Corners.cancel_group in H.
    assert (P : forall ws, Got [Corners.perpendicular (line_of u (offset_before a))] = Got ws ->
                on_offset_line (offset_before a) (tangent u) (hd zero (map vector ws))).
    { intros ws E. apply same in E as <-. cbn [map hd]. rewrite perpendicular_of_line. now apply flat_perpendicular. }
    destruct (negb (CutterModes.sup s)); [now apply P|]. apply bound in H as (kind & K & H).
    destruct kind; try (now apply P).
    + apply same in H as <-. rewrite no_arc_of_line. cbn [app map hd]. rewrite tangents_meet_in_M.
      now apply (obtuse_meets u v).
    + apply bound in H as (tiny & _ & H). destruct tiny; [now apply P|]. apply bound in H as (both & Q & H).
      apply same in H as <-. rewrite no_arc_of_line. cbn [app]. rewrite map_app. apply (prolonged_in_Q u v) in Q.
      rewrite Q. cbn [map app hd].
      apply Q1_past_the_corner; auto.
Qed.

Definition of_start (b : Movements.planned R) : Movements.planned R :=
  Movements.Planned (Movements.at_place b) (Movements.command_of b) (Movements.before b)
    (State.with_cutter (Movements.behind b)
       (CutterState.CutterState (Some CutterState.LeftHand) 5 CutterState.Started Corners.zero2 5 true
         CutterState.StartUpBlock))
    (Movements.items b).

Example start_and_cancel_keep_distance_instance vs :
  CutterC.corner_group plain_axes (of_start (leg_of_mode 0 0 0 20)) (leg_of_mode 0 20 20 20) false = Got vs ->
  on_offset_line 5 (tangent (20 + 0 - (0 + 0), 20 + 0 - (20 + 0))) (vector (last vs Corners.zero2)).
Proof.
  intro H. destruct (start_and_cancel_keep_distance plain_axes _ _ (0 + 0 - (0 + 0), 20 + 0 - (0 + 0))
    (20 + 0 - (0 + 0), 20 + 0 - (20 + 0)) vs H) as [K _]; try reflexivity; try (apply travel_of_mode; lra).
  all: first [unfold straight, travels; cbn; repeat split; lra | cbn; lra | now apply K].
Qed.
