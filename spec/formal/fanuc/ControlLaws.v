(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of tool center point control, over the real numbers: what the rotary axes turn, and the control point over the
    tip. *)
From Coq Require Import Reals Lra Psatz Bool ZArith List.
From Coq Require Import String.
From Toolcomp Require Import Vectors ToolDirection SpecifiedSpace ToolCenterPointControl OutcomeLaws.
From Toolcomp Require Numbers Outcomes Words Coordinates Angles ControlState State Space Pose ControlFrame ControlWords
  Program ProgramLaws.
Import Outcomes(outcome(..)).
Import ListNotations.
Open Scope string_scope.
Open Scope R_scope.

(** * Turns *)

(** The cosine and the sine of an angle that is one. *)
Definition is_angle (x : Angles.angle R) : Prop := Angles.cosine_of x * Angles.cosine_of x + Angles.sine_of x *
  Angles.sine_of x = 1.
Definition is_pose (p : Pose.pose R) : Prop := is_angle (fst p) /\ is_angle (snd p).
(** Both axes have directions of length 1. *)
Definition has_axes (k : Words.kinematics R) : Prop :=
  is_unit (vector (Words.about (Words.first_axis k))) /\ is_unit (vector (Words.about (Words.second_axis k))).

Lemma some_angle c s : c * c + s * s = 1 -> exists theta, cos theta = c /\ sin theta = s.
Proof.
  intro E. exists (atan2 s c). pose proof (cos_atan2 s c) as C. pose proof (sin_atan2 s c) as S.
  rewrite E, sqrt_1 in C, S. lra.
Qed.

Lemma turned_is_rotate u theta v : vector (Pose.turned u (cos theta) (sin theta) v) = rotate (vector u) theta (vector
  v).
Proof.
  unfold Pose.turned, rotate. rewrite !vector_add, !vector_scale, vector_cross, vector_dot. cbn.
  set (c := cos theta). set (s := sin theta). vec_ring.
Qed.

Lemma carried_is_rotate a x : is_angle x -> exists theta, forall v,
  vector (Pose.carried a x v) = rotate (vector (Words.about a)) theta (vector v) /\
  vector (Pose.carried_back a x v) = rotate (vector (Words.about a)) (- theta) (vector v).
Proof.
  intro E. destruct (some_angle _ _ E) as (theta & C & S). unfold Pose.carried, Pose.carried_back.
  destruct (Words.left_handed a).
  - exists (- theta). intro v. rewrite Ropp_involutive, <- !turned_is_rotate, cos_neg, sin_neg, C, S.
    split; [|reflexivity].
    f_equal. f_equal. cbn. ring.
  - exists theta. intro v. rewrite <- !turned_is_rotate, cos_neg, sin_neg, C, S. split; [reflexivity|]. f_equal.
    f_equal. cbn. ring.
Qed.

Lemma back_of_carried a x v : is_angle x -> is_unit (vector (Words.about a)) ->
  Pose.carried_back a x (Pose.carried a x v) = v.
Proof.
  intros E U. destruct (carried_is_rotate a x E) as (theta & T). apply vector_same.
  rewrite (proj2 (T _)), (proj1 (T v)). now apply rotate_back.
Qed.
Lemma carried_of_back a x v : is_angle x -> is_unit (vector (Words.about a)) ->
  Pose.carried a x (Pose.carried_back a x v) = v.
Proof.
  intros E U. destruct (carried_is_rotate a x E) as (theta & T). apply vector_same.
  rewrite (proj1 (T _)), (proj2 (T v)). now apply rotate_forth.
Qed.
Lemma carried_length a x v : is_angle x -> is_unit (vector (Words.about a)) ->
  Space.dot3 (Pose.carried a x v) (Pose.carried a x v) = Space.dot3 v v /\
  Space.dot3 (Pose.carried_back a x v) (Pose.carried_back a x v) = Space.dot3 v v.
Proof.
  intros E U. destruct (carried_is_rotate a x E) as (theta & T).
  rewrite !vector_dot, (proj1 (T v)), (proj2 (T v)), !rotate_dot by exact U.
  split; reflexivity.
Qed.

(** Some machine: a table that turns about X and then about Z, with the tool along Z. *)
Definition some_axis (letter : Space.triple R) (here : nat) :
  Words.rotary_axis R := Words.RotaryAxis (Some here) 0 letter true.
Definition some_table : Words.kinematics R :=
  Words.Kinematics Words.TableRotation (some_axis (1, 0, 0) 3) (some_axis (0, 0, 1) 4) (0, 0, 1).
Definition upright : Angles.angle R := Angles.Angle 0 1 0 (Some 0%Z).
Definition a_quarter : Angles.angle R := Angles.Angle 90 0 1 (Some 0%Z).
Lemma some_axes : has_axes some_table.
Proof. split; unfold is_unit, dot; cbn; lra. Qed.
Lemma some_pose : is_pose (upright, a_quarter).
Proof. split; unfold is_angle; cbn; lra. Qed.

(** * Directions *)

(** fanuc.tool-direction.mechanism: whatever the machine and the positions of its rotary axes, the direction of the tool
    is as long as the reference direction. *)
Theorem direction_keeps_its_length k p : has_axes k -> is_pose p ->
  Space.dot3 (Pose.direction_at k p) (Pose.direction_at k p) = Space.dot3 (Words.reference_direction k)
    (Words.reference_direction k).
Proof.
  intros [U1 U2] [E1 E2]. unfold Pose.direction_at. destruct p as [a1 a2]. cbn [fst snd] in *.
  destruct (Words.machine_of k);
    repeat first [rewrite (proj1 (carried_length _ _ _ E1 U1)) | rewrite (proj2 (carried_length _ _ _ E1 U1)) |
                  rewrite (proj1 (carried_length _ _ _ E2 U2)) | rewrite (proj2 (carried_length _ _ _ E2 U2))];
                    reflexivity.
Qed.

Example direction_keeps_its_length_instance :
  Space.dot3 (Pose.direction_at some_table (upright, a_quarter)) (Pose.direction_at some_table (upright,
    a_quarter)) = 1.
Proof. rewrite (direction_keeps_its_length _ _ some_axes some_pose). cbn. lra. Qed.

(** fanuc.tool-center-point.frozen-pose: at the frozen pose a direction of the table system is that of the machine: of a
    table the reference direction, of a mixed machine the one to which the first axis has turned it. *)
Theorem frozen_direction_of_the_machine k p : has_axes k -> is_pose p ->
  ControlFrame.programmed_direction k false p p = ControlFrame.programmed_direction k true p p.
Proof.
  intros [U1 U2] [E1 E2]. unfold ControlFrame.programmed_direction, ControlFrame.turned_by_table, Pose.direction_at.
  destruct p as [a1 a2].
  cbn [fst snd] in *. destruct (Words.machine_of k); [reflexivity|..].
  - now rewrite (carried_of_back _ _ _ E2 U2), (carried_of_back _ _ _ E1 U1).
  - now rewrite (carried_of_back _ _ _ E2 U2).
Qed.

Example frozen_direction_of_the_machine_instance :
  ControlFrame.programmed_direction some_table false (upright, a_quarter) (upright, a_quarter) = (0, 0, 1).
Proof. now rewrite (frozen_direction_of_the_machine _ _ some_axes some_pose). Qed.

(** * Points *)

Lemma there_is_back (a b : Space.triple R) : Space.sub3 (Space.add3 a b) a = b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]; cbn. f_equal; [f_equal|]; ring. Qed.
Lemma back_is_there (a b : Space.triple R) : Space.add3 a (Space.sub3 b a) = b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]; cbn. f_equal; [f_equal|]; ring. Qed.

(** fanuc.tool-center-point.control-point-table-rotation: a point fixed to the table comes from pose to pose as it would
    at once, and the table turned back brings it back. *)
Theorem table_carries_a_point s k p q r x : has_axes k -> is_pose p -> is_pose q -> is_pose r ->
  ControlFrame.with_table s k q r (ControlFrame.with_table s k p q x) = ControlFrame.with_table s k p r x /\
  ControlFrame.with_table s k p p x = x.
Proof.
  intros [U1 U2] [P1 P2] [Q1 Q2] [R1 R2]. unfold ControlFrame.with_table.
  destruct (Words.machine_of k); [now split|..].
  - rewrite there_is_back, (back_of_carried _ _ _ Q1 U1), there_is_back, (back_of_carried _ _ _ Q2 U2).
    split; [reflexivity|].
    now rewrite (carried_of_back _ _ _ P2 U2), back_is_there, (carried_of_back _ _ _ P1 U1), back_is_there.
  - rewrite there_is_back, (back_of_carried _ _ _ Q2 U2). split; [reflexivity|].
    now rewrite (carried_of_back _ _ _ P2 U2), back_is_there.
Qed.

Example table_carries_a_point_instance x :
  ControlFrame.with_table ProgramLaws.plain_setup some_table (upright, a_quarter) (upright, upright)
    (ControlFrame.with_table ProgramLaws.plain_setup some_table (upright, upright) (upright, a_quarter) x) = x.
Proof.
  assert (U : is_pose (upright, upright)) by (split; unfold is_angle; cbn; lra).
  destruct (table_carries_a_point ProgramLaws.plain_setup some_table (upright, upright) (upright, a_quarter) (upright,
    upright) x some_axes U some_pose U) as [-> _].
  now destruct (table_carries_a_point ProgramLaws.plain_setup some_table (upright, upright) (upright, upright) (upright,
    upright) x some_axes U U U).
Qed.

(** fanuc.tool-center-point.frozen-pose: at the frozen pose the tip stands where it is programmed, in the table system
    and in the workpiece system. *)
Theorem tip_at_the_frozen_pose s k c m tip : has_axes k -> is_pose (ControlState.frozen_pose m) ->
  ControlFrame.standing_tip s k c m (ControlState.frozen_pose m) tip = tip.
Proof.
  intros U P. unfold ControlFrame.standing_tip. destruct (ControlState.in_workpiece_system m); [reflexivity|].
  rewrite (proj2 (table_carries_a_point s k _ _ _ _ U P P P)). apply there_is_back.
Qed.

Definition some_mode : ControlState.control_mode R :=
  ControlState.ControlMode ControlState.ByAxes false 0 false (upright, a_quarter) 100
    (ControlState.Directed (0, 0, 1) (0, 0, 1)) (ControlState.Directed (0, 0, 1) (0, 0, 1)).

Example tip_at_the_frozen_pose_instance c tip :
  ControlFrame.standing_tip ProgramLaws.plain_setup some_table c some_mode (upright, a_quarter) tip = tip.
Proof. apply (tip_at_the_frozen_pose ProgramLaws.plain_setup some_table c some_mode tip some_axes some_pose). Qed.

(** The parameters of a machine whose rotary axes meet in the control point. *)
Definition without_offsets (s : Words.setup R) : Prop := forall number,
  In number ["19709"; "19710"; "19711"; "19712"; "19713"; "19714"] -> Pose.parameter_of s number = 0.

Lemma no_vector s x y z : Pose.parameter_of s x = 0 -> Pose.parameter_of s y = 0 -> Pose.parameter_of s z = 0 ->
  ControlFrame.vector_parameter s x y z = (0, 0, 0).
Proof. intros X Y Z. unfold ControlFrame.vector_parameter. now rewrite X, Y, Z. Qed.

Lemma plus_none (a : Space.triple R) : Space.add3 a (0, 0, 0) = a.
Proof. destruct a as [[? ?] ?]; cbn. f_equal; [f_equal|]; ring. Qed.
Lemma carried_scale a x l v : Pose.carried a x (Space.scale3 l v) = Space.scale3 l (Pose.carried a x v).
Proof.
  unfold Pose.carried, Pose.turned. destruct (Words.about a) as [[? ?] ?], v as [[? ?] ?]. cbn.
  f_equal; [f_equal|]; ring.
Qed.

(** fanuc.tool-center-point.control-point-tool-rotation: where the rotary axes meet, the axes stand the length of the
    tool from the tip, along the tool as it stands in the machine. *)
Theorem control_point_along_the_tool s k length p : without_offsets s ->
  ControlFrame.to_control_point s k length p = Space.scale3 length (ControlFrame.programmed_direction k true p p).
Proof.
  intro O. unfold ControlFrame.to_control_point, ControlFrame.programmed_direction, Pose.direction_at.
  destruct p as [a1 a2]. cbn [fst snd].
  rewrite !no_vector by (apply O; cbn; tauto). destruct (Words.machine_of k); [|reflexivity|].
  - now rewrite !plus_none, !carried_scale.
  - now rewrite plus_none, carried_scale.
Qed.

Example control_point_along_the_tool_instance :
  ControlFrame.to_control_point ProgramLaws.plain_setup some_table 100 (upright, a_quarter) = (100 * 0, 100 * 0,
    100 * 1).
Proof.
  rewrite control_point_along_the_tool; [reflexivity|]. intros number _. reflexivity.
Qed.
