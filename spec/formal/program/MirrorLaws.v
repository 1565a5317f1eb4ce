(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of mirror images: a corner of two lines that is mirrored, and offset to the other side,
    has the mirrored vectors. *)
From Coq Require Import List String ZArith Bool Reals Lra.
From Toolcomp Require Import Numbers Outcomes Words Codes Arcs Corners OutcomeLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** The mirror image in the first axis. *)
Definition mirror2 (v : pair R) : pair R := (fst v, - snd v)%R.
(** A line, and the mirrored one, offset to the other side. *)
Definition line (u : pair R) (rho : R) : leg R := line_leg u rho.
Definition mirrored_line (u : pair R) (rho : R) : leg R := line_leg (mirror2 u) (- rho)%R.

Lemma mirrored_unit u rho : unit_way (mirrored_line u rho) = mirror2 (unit_way (line u rho)).
Proof.
  unfold mirrored_line, line, line_leg, leg_along; cbn. unfold square_of; cbn. unfold dot2, mirror2; cbn.
  replace (fst u * fst u + - snd u * - snd u)%R with (fst u * fst u + snd u * snd u)%R by ring.
  unfold scale2; cbn. f_equal. ring.
Qed.
Lemma normal_of_unit u rho : normal (line u rho) = left_of (unit_way (line u rho)).
Proof. reflexivity. Qed.
Lemma mirrored_normal u rho : normal (mirrored_line u rho) = left_of (mirror2 (unit_way (line u rho))).
Proof. rewrite <- mirrored_unit. reflexivity. Qed.

Lemma mirrored_perpendicular u rho : perpendicular (mirrored_line u rho) = mirror2 (perpendicular (line u rho)).
Proof.
  unfold perpendicular. rewrite mirrored_normal, normal_of_unit. destruct (unit_way (line u rho)) as [x y].
  unfold mirror2, left_of; cbn. unfold scale2; cbn. f_equal; ring.
Qed.

Lemma same_cosine u v rho rho' : dot (unit_way (mirrored_line u rho)) (unit_way (mirrored_line v rho')) =
  dot (unit_way (line u rho)) (unit_way (line v rho')).
Proof. rewrite !mirrored_unit. cbn. unfold dot2, mirror2; cbn. ring. Qed.

Lemma mirrored_meeting u v rho rho' : tangents_meet (mirrored_line u rho) (mirrored_line v rho') =
  mirror2 (tangents_meet (line u rho) (line v rho')).
Proof.
  unfold tangents_meet. rewrite same_cosine, !mirrored_normal, !normal_of_unit.
  generalize (dot (unit_way (line u rho)) (unit_way (line v rho'))) as k. intro k.
  destruct (unit_way (line u rho)) as [a b], (unit_way (line v rho')) as [c d].
  unfold mirror2, left_of; cbn. unfold add2, scale2; cbn. unfold Rdiv. f_equal; ring.
Qed.

Lemma other_side_of_turn u v : aside (mirror2 u) (mirror2 v) = (- aside u v)%R.
Proof. cbn. unfold cross2, mirror2; cbn. ring. Qed.
Lemma same_advance u v : ahead (mirror2 u) (mirror2 v) = ahead u v.
Proof. cbn. unfold dot2, mirror2; cbn. ring. Qed.

Lemma same_corner u v rho rho' : corner_of (mirrored_line u rho) (mirrored_line v rho') = corner_of (line u rho) (line v
  rho').
Proof.
  unfold corner_of. cbn [way mirrored_line line line_leg leg_along Corners.rho].
  rewrite other_side_of_turn, same_advance. cbn [times reals].
  now replace (- rho * - aside u v)%R with (rho * aside u v)%R by ring.
Qed.

Lemma same_degree u v rho rho' : under_one_degree (mirrored_line u rho) (mirrored_line v rho') =
  under_one_degree (line u rho) (line v rho').
Proof.
  unfold under_one_degree. cbn [is_arc bent given orb mirrored_line line line_leg leg_along way].
  rewrite other_side_of_turn, same_advance. f_equal. cbn [times minus reals]. ring.
Qed.

Lemma mirrored_prolonged u v rho rho' : prolonged (mirrored_line u rho) (mirrored_line v rho') =
  mapped (map mirror2) (prolonged (line u rho) (line v rho')).
Proof.
  unfold prolonged. cbn [Corners.rho mirrored_line line line_leg leg_along].
  fold (line_leg (mirror2 u) (- rho)%R) (line_leg (mirror2 v) (- rho')%R) (line_leg u rho) (line_leg v rho').
  fold (mirrored_line u rho) (mirrored_line v rho') (line u rho) (line v rho').
  rewrite (magnitude_is "fanuc.cutter.side"
    (fun r => Got [add (perpendicular (mirrored_line u rho)) (scale r (unit_way (mirrored_line u rho)));
               subtract (perpendicular (mirrored_line v rho')) (scale r (unit_way (mirrored_line v rho')))])).
  rewrite (magnitude_is "fanuc.cutter.side"
    (fun r => Got [add (perpendicular (line u rho)) (scale r (unit_way (line u rho)));
               subtract (perpendicular (line v rho')) (scale r (unit_way (line v rho')))])).
  rewrite Rabs_Ropp, !mirrored_perpendicular, !mirrored_unit. cbn [mapped map]. do 2 f_equal; [|f_equal].
  all: cbn; unfold mirror2, add2, sub2, scale2; cbn; f_equal; ring.
Qed.

Ltac no_arcs := repeat match goal with |- context [of_arc ?a] => change (of_arc a) with (@nil (pair R)) end.

(** fanuc.cutter.side: the mirror image of a corner of two lines, offset to the other side, has the mirror images of the
    vectors: in the mode, at a start-up, before a cancel and at a change of the side, of type A and B. *)
Theorem mirrored_corner_mirrored_vectors type_b u v rho rho' :
  mode_group (mirrored_line u rho) (mirrored_line v rho') = mapped (map mirror2) (mode_group (line u rho) (line v rho'))
    /\
  start_up_group type_b (mirrored_line u rho) (mirrored_line v rho') =
    mapped (map mirror2) (start_up_group type_b (line u rho) (line v rho')) /\
  cancel_group type_b (mirrored_line u rho) (mirrored_line v rho') =
    mapped (map mirror2) (cancel_group type_b (line u rho) (line v rho')) /\
  direction_change_group (mirrored_line u rho) (mirrored_line v rho') =
    mapped (map mirror2) (direction_change_group (line u rho) (line v rho')).
Proof.
  repeat split.
  - unfold mode_group. rewrite same_corner. destruct (corner_of (line u rho) (line v rho')) as [[]| |]; try reflexivity;
      cbn [bind].
    + cbn [mapped map]. now rewrite mirrored_perpendicular.
    + change (paths_meet (mirrored_line u rho) (mirrored_line v rho')) with
        (Got (MeetAt (tangents_meet (mirrored_line u rho) (mirrored_line v rho')))).
      change (paths_meet (line u rho) (line v rho')) with (Got (MeetAt (tangents_meet (line u rho) (line v rho')))).
      cbn [bind mapped map]. now rewrite mirrored_meeting.
    + no_arcs. cbn [mapped map app]. now rewrite mirrored_meeting.
    + rewrite mirrored_prolonged. destruct (prolonged (line u rho) (line v rho')) as [both| |]; try reflexivity.
      cbn [bind mapped].
      no_arcs. cbn [app]. now rewrite !app_nil_r.
  - unfold start_up_group. destruct type_b; cbn [negb]; [|cbn [mapped map]; now rewrite mirrored_perpendicular].
    rewrite same_corner. destruct (corner_of (line u rho) (line v rho')) as [[]| |]; try reflexivity; cbn [bind].
    + cbn [mapped map]. now rewrite mirrored_perpendicular.
    + cbn [mapped map]. now rewrite mirrored_perpendicular.
    + no_arcs. cbn [mapped map app]. now rewrite mirrored_perpendicular, mirrored_meeting.
    + rewrite same_degree. destruct (under_one_degree (line u rho) (line v rho')) as [[]| |]; try reflexivity;
        cbn [bind].
      * cbn [mapped map]. now rewrite mirrored_perpendicular.
      * rewrite mirrored_prolonged. destruct (prolonged (line u rho) (line v rho')) as [both| |]; try reflexivity.
        cbn [bind mapped].
        no_arcs. rewrite !app_nil_r. cbn [map app]. now rewrite mirrored_perpendicular.
  - unfold cancel_group. destruct type_b; cbn [negb]; [|cbn [mapped map]; now rewrite mirrored_perpendicular].
    rewrite same_corner. destruct (corner_of (line u rho) (line v rho')) as [[]| |]; try reflexivity; cbn [bind].
    + cbn [mapped map]. now rewrite mirrored_perpendicular.
    + cbn [mapped map]. now rewrite mirrored_perpendicular.
    + no_arcs. cbn [mapped map app]. now rewrite mirrored_perpendicular, mirrored_meeting.
    + rewrite same_degree. destruct (under_one_degree (line u rho) (line v rho')) as [[]| |]; try reflexivity;
        cbn [bind].
      * cbn [mapped map]. now rewrite mirrored_perpendicular.
      * rewrite mirrored_prolonged. destruct (prolonged (line u rho) (line v rho')) as [both| |]; try reflexivity.
        cbn [bind mapped].
        no_arcs. cbn [app]. rewrite map_app. cbn [map]. now rewrite mirrored_perpendicular.
  - unfold direction_change_group.
    change (way (mirrored_line u rho)) with (mirror2 u). change (way (mirrored_line v rho')) with (mirror2 v).
    change (way (line u rho)) with u. change (way (line v rho')) with v. rewrite other_side_of_turn, zero_either_way.
    destruct (is_zero "fanuc.cutter-c.direction-change-parallel" (aside u v)) as [[]| |]; try reflexivity; cbn [bind].
    + cbn [mapped map]. now rewrite mirrored_perpendicular.
    + change (is_arc (mirrored_line u rho) || is_arc (mirrored_line v rho')) with false.
      change (is_arc (line u rho) || is_arc (line v rho')) with false. cbn iota.
      rewrite same_cosine, !mirrored_normal, !normal_of_unit.
      cbn [mapped map]. do 2 f_equal. generalize (dot (unit_way (line u rho)) (unit_way (line v rho'))) as k. intro k.
      change (Corners.rho (mirrored_line u rho)) with (- rho)%R. change (Corners.rho (line u rho)) with rho.
      destruct (unit_way (line u rho)) as [a b], (unit_way (line v rho')) as [c d].
      unfold mirror2, left_of; cbn. unfold sub2, scale2; cbn. unfold Rdiv. f_equal; ring.
Qed.

Example mirrored_corner_mirrored_vectors_instance :
  mode_group (mirrored_line (10, 0)%R 5%R) (mirrored_line (0, 10)%R 5%R) =
  mapped (map mirror2) (mode_group (line (10, 0)%R 5%R) (line (0, 10)%R 5%R)).
Proof. apply (mirrored_corner_mirrored_vectors true). Qed.
