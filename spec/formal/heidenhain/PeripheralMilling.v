(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/peripheral-milling: the direction in which RL and RR compensate under TCPM, and the end points between
    blocks.

    [T] is the direction of the tool from tip to carrier, [d] the movement of a block, both of any length; [s] is 1 for RL
    and -1 for RR; [delta] is dR, or R + dR where the contour is programmed. *)
From Coq Require Import Reals Lra Psatz.
From Toolcomp Require Import Vectors ToolDirection FaceMilling.
Open Scope R_scope.

(** * Definitions *)

(** The direction of compensation. *)
Definition c s T d := scale s (unit (cross T d)).

(** The vector at the end of a block between two compensated ones. *)
Definition mitre delta c1 c2 := scale (delta / (1 + dot c1 c2)) (add c1 c2).

(** The direction of a tool along [e] after the rotary words A, B, C (in radians), about the fixed axes in this order. *)
Definition spatial A B C e := rotate ez C (rotate ey B (rotate ex A e)).

(** * The direction of compensation *)

(** heidenhain.peripheral.direction: it is perpendicular to the tool and to the movement. *)
Theorem c_perpendicular s T d : dot (c s T d) T = 0 /\ dot (c s T d) d = 0.
Proof.
  unfold c, unit. rewrite !dot_scale_l.
  replace (dot (cross T d) T) with 0 by vec_ring. replace (dot (cross T d) d) with 0 by vec_ring. split; ring.
Qed.

Example c_perpendicular_instance : dot (c 1 (Vec 0 0 1) (Vec 5 0 0)) (Vec 5 0 0) = 0.
Proof. apply c_perpendicular. Qed.

Lemma c_unit s T d : s * s = 1 -> ~ parallel T d -> dot (c s T d) (c s T d) = 1.
Proof.
  intros S H. unfold c. rewrite dot_scale_l, dot_scale_r, unit_norm by exact H. lra.
Qed.

(** heidenhain.peripheral.direction: neither the length of the tool vector nor that of the movement matters, so T need not
    be normalised. *)
Theorem lengths_of_tool_and_movement s T d a b : 0 < a -> 0 < b -> c s (scale a T) (scale b d) = c s T d.
Proof.
  intros A B. unfold c. replace (cross (scale a T) (scale b d)) with (scale (a * b) (cross T d)) by vec_ring.
  rewrite unit_scale_any; auto. apply Rmult_lt_0_compat; auto.
Qed.

Example lengths_of_tool_and_movement_instance :
  c 1 (scale 2 (Vec 0 0 1)) (scale 3 (Vec 5 0 0)) = c 1 (Vec 0 0 1) (Vec 5 0 0).
Proof. apply lengths_of_tool_and_movement; lra. Qed.

(** heidenhain.peripheral.side: travel along Y with the tool along Z: RL to the left (-X), RR to the right. *)
Theorem left_and_right k : 0 < k -> c 1 ez (Vec 0 k 0) = Vec (-1) 0 0 /\ c (-1) ez (Vec 0 k 0) = Vec 1 0 0.
Proof.
  intro K. assert (E : unit (cross ez (Vec 0 k 0)) = Vec (-1) 0 0).
  { replace (cross ez (Vec 0 k 0)) with (scale k (Vec (-1) 0 0)) by (unfold ez; vec_ring).
    rewrite unit_scale_any by auto. apply unit_of_unit. unfold norm, dot; cbn.
    replace (-1 * -1 + 0 * 0 + 0 * 0) with 1 by ring. apply sqrt_1. }
  unfold c. rewrite E. split; unfold scale; cbn; f_equal; lra.
Qed.

Example left_and_right_instance : c 1 ez (Vec 0 7 0) = Vec (-1) 0 0.
Proof. apply left_and_right; lra. Qed.

(** heidenhain.peripheral.side: RR compensates by the opposite of RL. *)
Theorem other_side s T d : c (- s) T d = opp (c s T d).
Proof. unfold c. set (v := unit (cross T d)). clearbody v. vec_ring. Qed.

Example other_side_instance : c (- 1) (Vec 0 0 1) (Vec 5 0 0) = opp (c 1 (Vec 0 0 1) (Vec 5 0 0)).
Proof. apply other_side. Qed.

(** * End points *)

(** heidenhain.peripheral.mitre: the end point lies on both offset lines. *)
Theorem mitre_on_both_lines delta c1 c2 : dot c1 c1 = 1 -> dot c2 c2 = 1 -> 1 + dot c1 c2 <> 0 ->
  dot (mitre delta c1 c2) c1 = delta /\ dot (mitre delta c1 c2) c2 = delta.
Proof.
  intros U1 U2 H. unfold mitre. rewrite !dot_scale_l, !dot_add_l, U1, U2, (dot_comm c2 c1). split; field; auto.
Qed.

Example mitre_on_both_lines_instance : dot (mitre 6 (Vec 1 0 0) (Vec 0 1 0)) (Vec 1 0 0) = 6.
Proof. apply mitre_on_both_lines; unfold dot; cbn; lra. Qed.

(** heidenhain.peripheral.mitre: it lies in the plane across the tool, and no other point there lies on both lines. *)
Theorem mitre_unique delta c1 c2 T v : dot c1 c1 = 1 -> dot c2 c2 = 1 -> 1 + dot c1 c2 <> 0 ->
  dot c1 T = 0 -> dot c2 T = 0 -> dot T (cross c1 c2) <> 0 ->
  dot v T = 0 -> dot v c1 = delta -> dot v c2 = delta -> v = mitre delta c1 c2.
Proof.
  intros U1 U2 H T1 T2 D VT V1 V2. set (m := mitre delta c1 c2).
  destruct (mitre_on_both_lines delta c1 c2 U1 U2 H) as [M1 M2]. fold m in M1, M2.
  assert (MT : dot m T = 0) by (unfold m, mitre; rewrite dot_scale_l, dot_add_l, T1, T2; ring).
  clearbody m. set (x := sub v m).
  assert (X : scale (dot T (cross c1 c2)) x =
              add (scale (dot x T) (cross c1 c2)) (add (scale (dot x c1) (cross c2 T)) (scale (dot x c2) (cross T c1))))
    by vec_ring.
  assert (XT : dot x T = 0) by (unfold x, sub, opp; rewrite dot_add_l, dot_scale_l; lra).
  assert (X1 : dot x c1 = 0) by (unfold x, sub, opp; rewrite dot_add_l, dot_scale_l; lra).
  assert (X2 : dot x c2 = 0) by (unfold x, sub, opp; rewrite dot_add_l, dot_scale_l; lra).
  rewrite XT, X1, X2, !scale_zero_l in X.
  assert (Z : x = zero).
  { rewrite <- (scale_one x), <- (Rinv_l (dot T (cross c1 c2))), <- scale_scale, X by auto. vec_ring. }
  apply vec_eq; [apply (f_equal vx) in Z | apply (f_equal vy) in Z | apply (f_equal vz) in Z];
    unfold x, sub, opp, add, scale, zero in Z; cbn in Z; lra.
Qed.

Example mitre_unique_instance : Vec 6 6 0 = mitre 6 (Vec 1 0 0) (Vec 0 1 0).
Proof. apply (mitre_unique 6 _ _ (Vec 0 0 1)); unfold dot, cross; cbn; lra. Qed.

(** heidenhain.peripheral.mitre: straight on, the vector is that of either block: splitting a block changes nothing. *)
Theorem mitre_straight_on delta c1 : dot c1 c1 = 1 -> mitre delta c1 c1 = scale delta c1.
Proof.
  intro U. unfold mitre. rewrite U. replace (add c1 c1) with (scale 2 c1) by vec_ring.
  rewrite scale_scale. f_equal. field.
Qed.

Example mitre_straight_on_instance : mitre (-1/10) (Vec 0 1 0) (Vec 0 1 0) = scale (-1/10) (Vec 0 1 0).
Proof. apply mitre_straight_on; unfold dot; cbn; lra. Qed.

(** heidenhain.peripheral.mitre: both sides exchanged, or the sign of the value, the vector is the opposite. *)
Theorem mitre_of_the_other_side delta c1 c2 : mitre delta (opp c1) (opp c2) = opp (mitre delta c1 c2).
Proof.
  unfold mitre. replace (dot (opp c1) (opp c2)) with (dot c1 c2) by vec_ring.
  set (k := delta / (1 + dot c1 c2)). clearbody k. vec_ring.
Qed.

Example mitre_of_the_other_side_instance :
  mitre 6 (opp (Vec 1 0 0)) (opp (Vec 0 1 0)) = opp (mitre 6 (Vec 1 0 0) (Vec 0 1 0)).
Proof. apply mitre_of_the_other_side. Qed.

(** heidenhain.peripheral.reversal: between opposite directions no point lies on both offset lines. *)
Theorem reversal_has_no_end_point delta c1 c2 v : c2 = opp c1 -> delta <> 0 ->
  ~ (dot v c1 = delta /\ dot v c2 = delta).
Proof.
  intros E H [V1 V2]. subst c2. unfold opp in V2. rewrite dot_scale_r, V1 in V2. lra.
Qed.

Example reversal_has_no_end_point_instance v : ~ (dot v (Vec 1 0 0) = 6 /\ dot v (Vec (-1) 0 0) = 6).
Proof. apply reversal_has_no_end_point; [unfold opp, scale; cbn; f_equal; lra | lra]. Qed.

(** heidenhain.peripheral.reversal: the test without roots: the directions of [a] and [b] are opposite exactly where their
    cross product vanishes and their scalar product is negative. *)
Theorem reversal_by_products a b : a <> zero -> b <> zero ->
  (1 + dot (unit a) (unit b) = 0 <-> cross a b = zero /\ dot a b < 0).
Proof.
  intros A B. pose proof (norm_pos a A) as PA. pose proof (norm_pos b B) as PB.
  assert (P : 0 < norm a * norm b) by (apply Rmult_lt_0_compat; auto).
  assert (E : dot (unit a) (unit b) * (norm a * norm b) = dot a b).
  { unfold unit. rewrite dot_scale_l, dot_scale_r. field. lra. }
  assert (L : (norm a * norm b)² = dot a a * dot b b) by (rewrite <- !norm_sqr; unfold Rsqr; ring).
  pose proof (lagrange a b) as G. split.
  - intro H. assert (D : dot a b = - (norm a * norm b)) by (rewrite <- E; nra).
    split; [| lra]. apply dot_self_zero. rewrite G, <- L, D. unfold Rsqr; ring.
  - intros [C D]. rewrite C in G. replace (dot zero zero) with 0 in G by vec_ring.
    assert (S : (- dot a b)² = (norm a * norm b)²) by (rewrite L; unfold Rsqr in *; lra).
    apply Rsqr_inj in S; [| lra | lra].
    apply (Rmult_eq_reg_r (norm a * norm b)); [| lra]. rewrite Rmult_plus_distr_r, E. lra.
Qed.

Example reversal_by_products_instance : 1 + dot (unit (Vec 0 3 0)) (unit (Vec 0 (-5) 0)) = 0.
Proof.
  apply reversal_by_products; try (intro E; injection E; intros; lra).
  split; [unfold cross, zero; cbn; f_equal; lra | unfold dot; cbn; lra].
Qed.

(** heidenhain.peripheral.by-normal: an end mill is displaced by a normal at right angles to it as RL or RR displaces it
    in that direction. *)
Theorem end_mill_by_normal r d0 N T : N <> zero -> T <> zero -> dot N T = 0 -> 0 <= r + d0 ->
  D_tip (Tool r 0) (Deltas 0 d0 0) N T = scale d0 (unit N).
Proof.
  intros HN HT E H. rewrite at_right_angles by (auto; cbn; lra). cbn [dR dR2].
  set (n := unit N); set (t := unit T). clearbody n t. vec_ring.
Qed.

Example end_mill_by_normal_instance :
  D_tip (Tool 6 0) (Deltas 0 (-1/10) 0) (Vec (3/5) 0 (4/5)) (Vec 0 1 0) = scale (-1/10) (unit (Vec (3/5) 0 (4/5))).
Proof.
  apply end_mill_by_normal; [apply XZ_nonzero | | unfold dot; cbn; lra | lra].
  intro E; injection E; intros; lra.
Qed.

(** * The tool *)

(** heidenhain.program.direction-of-rotary-axes: the direction of a tool along Z. *)
Theorem spatial_direction A B C : spatial A B C ez =
  Vec (cos A * sin B * cos C + sin A * sin C) (cos A * sin B * sin C - sin A * cos C) (cos A * cos B).
Proof. unfold spatial. rewrite rotate_about_x, rotate_about_y, rotate_about_z. cbn [vx vy vz ez]. f_equal; ring. Qed.

Example spatial_direction_instance : spatial 0 (PI / 2) 0 ez = ex.
Proof.
  rewrite spatial_direction, sin_PI2, cos_PI2, sin_0, cos_0. unfold ex. f_equal; ring.
Qed.

(** heidenhain.program.direction-of-rotary-axes: it is a direction of length 1, whatever the tool axis. *)
Theorem spatial_unit A B C e : norm e = 1 -> norm (spatial A B C e) = 1.
Proof.
  intro H. unfold spatial, norm. rewrite !rotate_dot by (unfold dot, ex, ey, ez; cbn; ring). exact H.
Qed.

Example spatial_unit_instance A B C : norm (spatial A B C (Vec 0 0 1)) = 1.
Proof. apply spatial_unit, norm_Z. Qed.
