(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/leading-edge-offset: the compensation vector of G41.3, its direction rules, and why they are consistent.

    [VT] is the tool direction from tip to spindle at the end of a block, of any length; [VM] the movement of the next
    block; [r] the offset value. *)
From Coq Require Import Reals Lra Psatz List.
From Toolcomp Require Import Vectors.
Import ListNotations.
Open Scope R_scope.

(** * Definitions *)

(** The direction of the compensation vector: V = (VM x VT) x VT. *)
Definition V VM VT := cross (cross VM VT) VT.

(** The vector of length [r] along V for the sense +1 (backward), against it for -1 (forward). *)
Definition VC sense r VM VT := scale (sense * r / norm (V VM VT)) (V VM VT).

(** The sense of a pair that is not near a right angle: backward where the tool leans forward. *)
Definition sense VM VT := if Rlt_dec (dot VM VT) 0 then -1 else 1.

(** The compensation vector of a block away from 0, 90 and 180 degrees. *)
Definition VC_oblique r VM VT := VC (sense VM VT) r VM VT.

(** The angle classes of parameter 19631; [delta] is that parameter as an angle. *)
Inductive class := along | against | square | oblique.

(** The class of a pair by products and squares alone, tested in the order 0, 180, 90 degrees. *)
Definition classify delta VM VT :=
  let d := dot VM VT in
  let s := dot VM VM * dot VT VT in
  if Rlt_dec 0 d then
    if Rle_dec ((cos delta)² * s) d² then along else if Rle_dec d² ((sin delta)² * s) then square else oblique
  else if Rlt_dec d 0 then
    if Rle_dec ((cos delta)² * s) d² then against else if Rle_dec d² ((sin delta)² * s) then square else oblique
  else square.

(** What is carried from block to block: the last vector and the sense of the last computed one. *)
Record state := State { vector : vec; history : R }.

(** The vector at the end of a block: kept near 0 and 180 degrees, by history near 90, else by the lean of the tool. *)
Definition step delta r s (pair : vec * vec) :=
  let (VM, VT) := pair in
  match classify delta VM VT with
  | along | against => s
  | square => State (VC (history s) r VM VT) (history s)
  | oblique => State (VC_oblique r VM VT) (sense VM VT)
  end.

(** The state after a run of blocks. *)
Definition run delta r := fold_left (step delta r).

(** * The direction V *)

(** fanuc.leading-edge.vector: the component formula that is printed is the triple product. *)
Theorem V_components VM VT : V VM VT = Vec
  (vz VT * (vz VM * vx VT - vx VM * vz VT) - vy VT * (vx VM * vy VT - vy VM * vx VT))
  (vx VT * (vx VM * vy VT - vy VM * vx VT) - vz VT * (vy VM * vz VT - vz VM * vy VT))
  (vy VT * (vy VM * vz VT - vz VM * vy VT) - vx VT * (vz VM * vx VT - vx VM * vz VT)).
Proof. unfold V; vec_ring. Qed.

Example V_components_instance : V (Vec 100 0 0) (Vec (3/5) 0 (4/5)) = Vec (-64) 0 48.
Proof. rewrite V_components; cbn; f_equal; lra. Qed.

(** fanuc.leading-edge.vector: V = (VM.VT) VT - |VT|^2 VM, the part of VM across the tool, turned back. *)
Theorem V_expansion VM VT : V VM VT = sub (scale (dot VM VT) VT) (scale (dot VT VT) VM).
Proof. unfold V; vec_ring. Qed.

Example V_expansion_instance :
  V (Vec 100 0 0) (Vec 0 0 1) = sub (scale 0 (Vec 0 0 1)) (scale 1 (Vec 100 0 0)).
Proof. rewrite V_expansion; unfold dot; cbn; f_equal; f_equal; ring. Qed.

(** fanuc.leading-edge.vector: |V|^2 = |VT|^2 |VM x VT|^2. *)
Theorem V_length VM VT : dot (V VM VT) (V VM VT) = dot VT VT * dot (cross VM VT) (cross VM VT).
Proof. unfold V; vec_ring. Qed.

Example V_length_instance : dot (V (Vec 100 0 0) (Vec (3/5) 0 (4/5))) (V (Vec 100 0 0) (Vec (3/5) 0 (4/5))) = 6400.
Proof. rewrite V_length; unfold dot, cross; cbn; lra. Qed.

(** fanuc.leading-edge.vector: V vanishes exactly where the movement is along the tool. *)
Theorem V_zero_iff_parallel VM VT : VT <> zero -> (V VM VT = zero <-> parallel VM VT).
Proof.
  intro H; unfold parallel; split; intro E.
  - apply dot_self_zero. pose proof (V_length VM VT) as L. rewrite E in L.
    pose proof (dot_self_pos VT H) as P.
    replace (dot zero zero) with 0 in L by vec_ring.
    symmetry in L; apply Rmult_integral in L; destruct L; lra.
  - unfold V; rewrite E; vec_ring.
Qed.

Example V_zero_iff_parallel_instance : V (Vec 60 0 80) (Vec (3/5) 0 (4/5)) = zero.
Proof.
  apply V_zero_iff_parallel.
  - intro E; injection E; intros; lra.
  - unfold parallel, cross, zero; cbn; f_equal; lra.
Qed.

Lemma V_dot_VT VM VT : dot (V VM VT) VT = 0.
Proof. unfold V; vec_ring. Qed.

Lemma V_dot_VM VM VT : dot (V VM VT) VM = - dot (cross VM VT) (cross VM VT).
Proof. unfold V; vec_ring. Qed.

Lemma V_nonzero VM VT : ~ parallel VM VT -> V VM VT <> zero.
Proof.
  intros H E. apply H, V_zero_iff_parallel; auto.
  intro Z; apply H; unfold parallel; subst; vec_ring.
Qed.

Lemma cross_pos VM VT : ~ parallel VM VT -> 0 < dot (cross VM VT) (cross VM VT).
Proof. intro H; apply dot_self_pos; exact H. Qed.

(** * The compensation vector *)

(** fanuc.leading-edge.vector: VC is perpendicular to the tool. *)
Theorem VC_perpendicular s r VM VT : dot (VC s r VM VT) VT = 0.
Proof. unfold VC; rewrite dot_scale_l, V_dot_VT; ring. Qed.

Example VC_perpendicular_instance : dot (VC 1 10 (Vec 100 0 0) (Vec (3/5) 0 (4/5))) (Vec (3/5) 0 (4/5)) = 0.
Proof. apply VC_perpendicular. Qed.

(** fanuc.leading-edge.vector: VC lies in the plane of the tool and the movement. *)
Theorem VC_in_span s r VM VT : exists a b, VC s r VM VT = add (scale a VT) (scale b VM).
Proof.
  exists (s * r / norm (V VM VT) * dot VM VT), (- (s * r / norm (V VM VT)) * dot VT VT).
  unfold VC; set (k := s * r / norm (V VM VT)); rewrite V_expansion; vec_ring.
Qed.

Example VC_in_span_instance : exists a b,
  VC 1 10 (Vec 100 0 0) (Vec (3/5) 0 (4/5)) = add (scale a (Vec (3/5) 0 (4/5))) (scale b (Vec 100 0 0)).
Proof. apply VC_in_span. Qed.

(** fanuc.leading-edge.vector: VC is as long as the offset value, whatever its sign. *)
Theorem VC_length s r VM VT : s = 1 \/ s = -1 -> ~ parallel VM VT -> norm (VC s r VM VT) = Rabs r.
Proof.
  intros Hs H. pose proof (norm_pos _ (V_nonzero VM VT H)) as P.
  unfold VC; rewrite norm_scale; unfold Rdiv; rewrite !Rabs_mult.
  rewrite (Rabs_right (/ norm (V VM VT))) by (left; apply Rinv_0_lt_compat; auto).
  replace (Rabs s) with 1 by (destruct Hs; subst; [rewrite Rabs_right | rewrite Rabs_left]; lra).
  field; lra.
Qed.

Lemma sense_cases VM VT : sense VM VT = 1 \/ sense VM VT = -1.
Proof. unfold sense; destruct Rlt_dec; auto. Qed.

Lemma not_parallel_y VM VT : vy (cross VM VT) <> 0 -> ~ parallel VM VT.
Proof. intros H E; apply H; unfold parallel in E; rewrite E; reflexivity. Qed.

Example VC_length_instance : norm (VC (-1) (-10) (Vec 100 0 0) (Vec (3/5) 0 (4/5))) = Rabs (-10).
Proof. apply VC_length; [lra | apply not_parallel_y; cbn; lra]. Qed.

(** fanuc.leading-edge.sign: where the tool leans forward and the offset is positive, VC points backward. *)
Theorem VC_backward r VM VT : 0 < r -> 0 < dot VM VT -> ~ parallel VM VT -> dot (VC_oblique r VM VT) VM < 0.
Proof.
  intros Hr Hd H. pose proof (norm_pos _ (V_nonzero VM VT H)) as P. pose proof (cross_pos VM VT H) as Q.
  unfold VC_oblique, VC, sense; destruct Rlt_dec; [lra |].
  rewrite dot_scale_l, V_dot_VM. unfold Rdiv.
  pose proof (Rinv_0_lt_compat _ P). assert (0 < 1 * r * / norm (V VM VT)) by nra. nra.
Qed.

Example VC_backward_instance : dot (VC_oblique 10 (Vec 100 0 0) (Vec (3/5) 0 (4/5))) (Vec 100 0 0) < 0.
Proof. apply VC_backward; [lra | unfold dot; cbn; lra | apply not_parallel_y; cbn; lra]. Qed.

(** fanuc.leading-edge.sign: where the tool leans backward and the offset is positive, VC points forward. *)
Theorem VC_forward r VM VT : 0 < r -> dot VM VT < 0 -> ~ parallel VM VT -> 0 < dot (VC_oblique r VM VT) VM.
Proof.
  intros Hr Hd H. pose proof (norm_pos _ (V_nonzero VM VT H)) as P. pose proof (cross_pos VM VT H) as Q.
  unfold VC_oblique, VC, sense; destruct Rlt_dec; [| lra].
  rewrite dot_scale_l, V_dot_VM. unfold Rdiv.
  pose proof (Rinv_0_lt_compat _ P). assert (0 < r * / norm (V VM VT)) by nra. nra.
Qed.

Example VC_forward_instance : 0 < dot (VC_oblique 10 (Vec 100 0 0) (Vec (-3/5) 0 (4/5))) (Vec 100 0 0).
Proof. apply VC_forward; [lra | unfold dot; cbn; lra | apply not_parallel_y; cbn; lra]. Qed.

(** fanuc.leading-edge.vector: moving along the same line the other way gives the same vector. *)
Theorem VC_movement_reversed r VM VT : dot VM VT <> 0 -> VC_oblique r (opp VM) VT = VC_oblique r VM VT.
Proof.
  intro H. unfold VC_oblique, VC, sense.
  replace (dot (opp VM) VT) with (- dot VM VT) by vec_ring.
  replace (V (opp VM) VT) with (opp (V VM VT)) by (unfold V; vec_ring).
  rewrite norm_opp. unfold opp. rewrite scale_scale.
  f_equal. destruct (Rlt_dec (- dot VM VT) 0), (Rlt_dec (dot VM VT) 0); try lra; unfold Rdiv; ring.
Qed.

Example VC_movement_reversed_instance :
  VC_oblique 6 (opp (Vec 40 (-10) 5)) (Vec 2 1 9) = VC_oblique 6 (Vec 40 (-10) 5) (Vec 2 1 9).
Proof. apply VC_movement_reversed; unfold dot; cbn; lra. Qed.

Lemma V_scale_VT k VM VT : V VM (scale k VT) = scale (k * k) (V VM VT).
Proof. unfold V; vec_ring. Qed.

Lemma V_scale_VM k VM VT : V (scale k VM) VT = scale k (V VM VT).
Proof. unfold V; vec_ring. Qed.

Lemma normalise_scale j k u : 0 < k -> scale (j / norm (scale k u)) (scale k u) = scale (j / norm u) u.
Proof.
  intro H. rewrite norm_scale, Rabs_right, scale_scale by lra.
  destruct (Req_EM_T (norm u) 0) as [E | E].
  - assert (u = zero) by (apply dot_self_zero; rewrite <- norm_sqr, E; ring). subst; rewrite !scale_zero_r; auto.
  - f_equal; field; split; lra.
Qed.

Lemma sense_positive a VM VT VM' VT' : 0 < a -> dot VM' VT' = a * dot VM VT -> sense VM' VT' = sense VM VT.
Proof.
  intros Ha E; unfold sense; rewrite E.
  destruct (Rlt_dec (a * dot VM VT) 0), (Rlt_dec (dot VM VT) 0); auto; exfalso; nra.
Qed.

(** fanuc.tool-direction.given-directly: the length given to the tool direction does not matter. *)
Theorem VC_tool_scaled r k VM VT : 0 < k -> VC_oblique r VM (scale k VT) = VC_oblique r VM VT.
Proof.
  intro H. unfold VC_oblique. rewrite (sense_positive k VM VT); auto using dot_scale_r.
  unfold VC. rewrite V_scale_VT. apply normalise_scale. nra.
Qed.

Example VC_tool_scaled_instance :
  VC_oblique 10 (Vec 100 0 0) (scale (1/5) (Vec 3 0 4)) = VC_oblique 10 (Vec 100 0 0) (Vec 3 0 4).
Proof. apply VC_tool_scaled; lra. Qed.

(** fanuc.leading-edge.vector: the length of the movement does not matter. *)
Theorem VC_movement_scaled r k VM VT : 0 < k -> VC_oblique r (scale k VM) VT = VC_oblique r VM VT.
Proof.
  intro H. unfold VC_oblique. rewrite (sense_positive k VM VT); auto using dot_scale_l.
  unfold VC. rewrite V_scale_VM. apply normalise_scale; auto.
Qed.

Example VC_movement_scaled_instance :
  VC_oblique 10 (scale 100 (Vec 1 0 0)) (Vec 3 0 4) = VC_oblique 10 (Vec 1 0 0) (Vec 3 0 4).
Proof. apply VC_movement_scaled; lra. Qed.

(** fanuc.leading-edge.vector: turning or mirroring tool and path turns or mirrors the vector. *)
Theorem VC_rigid_motion m r VM VT : rigid m -> VC_oblique r (move m VM) (move m VT) = move m (VC_oblique r VM VT).
Proof.
  intro H. unfold VC_oblique, VC, sense. rewrite move_scale, move_dot by auto.
  assert (E : V (move m VM) (move m VT) = move m (V VM VT)).
  { rewrite !V_expansion, !move_dot, move_sub, !move_scale by auto; reflexivity. }
  rewrite E, move_norm by auto; reflexivity.
Qed.

Example VC_rigid_motion_instance :
  let m := Motion (Vec (3/5) (4/5) 0) (Vec (-4/5) (3/5) 0) (Vec 0 0 (-1)) in
  VC_oblique 10 (move m (Vec 100 0 0)) (move m (Vec 3 0 4)) = move m (VC_oblique 10 (Vec 100 0 0) (Vec 3 0 4)).
Proof. intro m; apply VC_rigid_motion; unfold m, rigid, dot; cbn; repeat split; lra. Qed.

(** fanuc.leading-edge.negative-radius: a negative offset value reverses the vector. *)
Theorem VC_offset_negated s r VM VT : VC s (- r) VM VT = opp (VC s r VM VT).
Proof. unfold VC, opp; rewrite scale_scale; f_equal; unfold Rdiv; ring. Qed.

Example VC_offset_negated_instance :
  VC 1 (-10) (Vec 100 0 0) (Vec 3 0 4) = opp (VC 1 10 (Vec 100 0 0) (Vec 3 0 4)).
Proof. apply VC_offset_negated. Qed.

(** fanuc.leading-edge.vector: offset value 0 is no compensation. *)
Theorem VC_offset_zero s VM VT : VC s 0 VM VT = zero.
Proof. unfold VC, Rdiv; rewrite Rmult_0_r, Rmult_0_l; apply scale_zero_l. Qed.

Example VC_offset_zero_instance : VC 1 0 (Vec 100 0 0) (Vec 3 0 4) = zero.
Proof. apply VC_offset_zero. Qed.

(** fanuc.leading-edge.across-keeps-sense: across a right angle the vector jumps by twice the offset value, so history decides. *)
Theorem VC_jump r VM VT : ~ parallel VM VT -> norm (sub (VC 1 r VM VT) (VC (-1) r VM VT)) = 2 * Rabs r.
Proof.
  intro H. replace (sub (VC 1 r VM VT) (VC (-1) r VM VT)) with (scale 2 (VC 1 r VM VT)).
  - rewrite norm_scale, VC_length, Rabs_right by (auto; lra); reflexivity.
  - unfold VC, sub, opp; rewrite !scale_scale.
    replace (-1 * (-1 * r / norm (V VM VT))) with (1 * r / norm (V VM VT)) by (unfold Rdiv; ring).
    set (u := V VM VT); set (k := 1 * r / norm u); clearbody k; clearbody u; vec_ring.
Qed.

Example VC_jump_instance :
  norm (sub (VC 1 10 (Vec 100 0 0) (Vec 0 0 1)) (VC (-1) 10 (Vec 100 0 0) (Vec 0 0 1))) = 2 * Rabs 10.
Proof. apply VC_jump, not_parallel_y; cbn; lra. Qed.

(** * The angle ranges of parameter 19631 *)

Lemma PI_half : 0 < PI / 2.
Proof. pose proof PI_RGT_0; lra. Qed.

Lemma norms_pos VM VT : dot VM VT <> 0 -> 0 < norm VM * norm VT.
Proof. intro H; apply nonzero_by_dot in H; apply Rmult_lt_0_compat; apply norm_pos; tauto. Qed.

Lemma dot_squared VM VT : VM <> zero -> VT <> zero ->
  (dot VM VT)² = (cos (angle VM VT))² * (dot VM VM * dot VT VT).
Proof.
  intros A B. rewrite <- (cos_angle VM VT A B), <- !norm_sqr. unfold Rsqr; ring.
Qed.

Lemma cos_positive VM VT : VM <> zero -> VT <> zero -> (0 < dot VM VT <-> angle VM VT < PI / 2).
Proof.
  intros A B. pose proof (angle_bounds VM VT) as [L U]. pose proof (cos_angle VM VT A B) as C.
  assert (P : 0 < norm VM * norm VT) by (apply Rmult_lt_0_compat; apply norm_pos; auto).
  split; intro H.
  - apply Rnot_le_lt; intro G. assert (cos (angle VM VT) <= 0) by (apply cos_le_0; lra). nra.
  - assert (0 < cos (angle VM VT)) by (apply cos_gt_0; pose proof PI_half; lra). nra.
Qed.

(** fanuc.leading-edge.near-0: the test with products and squares is the manual's range from 0 to the parameter. *)
Theorem along_is_angle delta VM VT : 0 <= delta < PI / 2 -> VM <> zero -> VT <> zero ->
  (classify delta VM VT = along <-> angle VM VT <= delta).
Proof.
  intros D A B. pose proof (angle_bounds VM VT) as [L U]. pose proof (cos_positive VM VT A B) as P.
  assert (S : 0 < dot VM VM * dot VT VT) by (apply Rmult_lt_0_compat; apply dot_self_pos; auto).
  assert (Cd : 0 < cos delta) by (apply cos_gt_0; lra).
  unfold classify. rewrite (dot_squared VM VT) by auto.
  destruct (Rlt_dec 0 (dot VM VT)) as [Hd | Hd].
  - assert (Ha : angle VM VT < PI / 2) by tauto.
    assert (Ca : 0 < cos (angle VM VT)) by (apply cos_gt_0; lra).
    destruct Rle_dec as [Q | Q]; split; intro H; auto.
    + apply Rmult_le_reg_r in Q; auto. apply Rsqr_incr_0 in Q; try lra.
      apply Rnot_lt_le; intro G. apply cos_decreasing_1 in G; lra.
    + destruct Rle_dec; discriminate.
    + exfalso; apply Q. apply Rmult_le_compat_r; [lra |]. apply Rsqr_incr_1; try lra.
      destruct H as [H | H]; [left; apply cos_decreasing_1; lra | rewrite H; lra].
  - split; intro H.
    + destruct (Rlt_dec (dot VM VT) 0); [destruct Rle_dec; [| destruct Rle_dec] |]; discriminate.
    + exfalso; apply Hd, P; lra.
Qed.

Example along_is_angle_instance : classify 0 (Vec 60 0 80) (Vec 3 0 4) = along <-> angle (Vec 60 0 80) (Vec 3 0 4) <= 0.
Proof. apply along_is_angle; [pose proof PI_half; lra | |]; intro E; injection E; intros; lra. Qed.

Lemma classify_opp delta VM VT : classify delta (opp VM) VT = along <-> classify delta VM VT = against.
Proof.
  unfold classify. replace (dot (opp VM) VT) with (- dot VM VT) by vec_ring.
  replace (dot (opp VM) (opp VM)) with (dot VM VM) by vec_ring. rewrite <- Rsqr_neg.
  destruct (Rlt_dec 0 (- dot VM VT)), (Rlt_dec 0 (dot VM VT)), (Rlt_dec (dot VM VT) 0), (Rlt_dec (- dot VM VT) 0);
    try lra; repeat destruct Rle_dec; split; intro; try discriminate; auto.
Qed.

Lemma angle_opp VM VT : angle (opp VM) VT = PI - angle VM VT.
Proof.
  unfold angle. rewrite norm_opp. replace (dot (opp VM) VT) with (- dot VM VT) by vec_ring.
  rewrite <- acos_opp. f_equal. unfold Rdiv; ring.
Qed.

(** fanuc.leading-edge.near-180: the same test with the sign turned is the range that ends at 180 degrees. *)
Theorem against_is_angle delta VM VT : 0 <= delta < PI / 2 -> VM <> zero -> VT <> zero ->
  (classify delta VM VT = against <-> PI - delta <= angle VM VT).
Proof.
  intros D A B. rewrite <- classify_opp, along_is_angle, angle_opp; auto; [lra |].
  intro E; apply A. destruct VM as [a b c]; unfold opp, scale, zero in *; cbn in E; injection E; intros; f_equal; lra.
Qed.

Example against_is_angle_instance :
  classify 0 (Vec (-60) 0 (-80)) (Vec 3 0 4) = against <-> PI - 0 <= angle (Vec (-60) 0 (-80)) (Vec 3 0 4).
Proof. apply against_is_angle; [pose proof PI_half; lra | |]; intro E; injection E; intros; lra. Qed.

(** fanuc.leading-edge.near-90: for a parameter below 45 degrees the test is the manual's range of 90 degrees plus or
    minus the parameter. *)
Theorem square_is_angle delta VM VT : 0 <= delta < PI / 4 -> VM <> zero -> VT <> zero ->
  (classify delta VM VT = square <-> PI / 2 - delta <= angle VM VT <= PI / 2 + delta).
Proof.
  intros D A B. pose proof (angle_bounds VM VT) as [L U].
  assert (S : 0 < dot VM VM * dot VT VT) by (apply Rmult_lt_0_compat; apply dot_self_pos; auto).
  set (a := angle VM VT) in *.
  assert (N : forall b, 0 <= b < PI / 2 -> ((cos a)² <= (sin b)² <-> PI / 2 - b <= a <= PI / 2 + b)).
  { intros b Hb. assert (Sb : 0 <= sin b) by (apply sin_ge_0; lra).
    replace (sin b) with (cos (PI / 2 - b)) in * by (rewrite cos_shift; auto).
    assert (E : - cos (PI / 2 - b) = cos (PI / 2 + b)) by (rewrite cos_shift, cos_plus, cos_PI2, sin_PI2; lra).
    split; intro H.
    - assert (K : - cos (PI / 2 - b) <= cos a <= cos (PI / 2 - b)).
      { split; [apply Rsqr_neg_pos_le_0 | apply Rsqr_incr_0_var]; auto. }
      split; apply Rnot_lt_le; intro G; apply cos_decreasing_1 in G; lra.
    - destruct H as [H1 H2]. apply neg_pos_Rsqr_le.
      + rewrite E. destruct H2 as [H2 | H2]; [left; apply cos_decreasing_1; lra | rewrite H2; lra].
      + destruct H1 as [H1 | H1]; [left; apply cos_decreasing_1; lra | rewrite <- H1; lra]. }
  assert (X : (sin delta)² < (cos delta)²).
  { apply Rsqr_incrst_1; [| apply sin_ge_0; lra | apply cos_ge_0; lra].
    rewrite <- cos_shift. apply cos_decreasing_1; lra. }
  assert (Z : dot VM VT = 0 -> a = PI / 2).
  { intro H. pose proof (cos_angle VM VT A B) as C. fold a in C. rewrite H in C.
    assert (0 < norm VM * norm VT) by (apply Rmult_lt_0_compat; apply norm_pos; auto).
    assert (cos a = 0) by nra.
    destruct (N 0) as [N0 _]; [lra |]. rewrite sin_0 in N0. destruct N0; [rewrite H1; unfold Rsqr; lra | lra]. }
  rewrite <- (N delta) by lra.
  unfold classify. rewrite (dot_squared VM VT) by auto. fold a.
  assert (R1 : (cos a)² * (dot VM VM * dot VT VT) <= (sin delta)² * (dot VM VM * dot VT VT) <->
               (cos a)² <= (sin delta)²).
  { split; intro H; [apply Rmult_le_reg_r in H; auto | apply Rmult_le_compat_r; lra]. }
  assert (R2 : (cos delta)² * (dot VM VM * dot VT VT) <= (cos a)² * (dot VM VM * dot VT VT) <->
               (cos delta)² <= (cos a)²).
  { split; intro H; [apply Rmult_le_reg_r in H; auto | apply Rmult_le_compat_r; lra]. }
  destruct (Rlt_dec 0 (dot VM VT)); [| destruct (Rlt_dec (dot VM VT) 0)].
  1, 2: destruct Rle_dec as [Q | Q]; [rewrite R2 in Q | destruct Rle_dec as [Q' | Q']; rewrite R1 in Q'];
    split; intro H; auto; try discriminate; try tauto; lra.
  split; intro H; auto. rewrite Z by lra. rewrite cos_PI2. unfold Rsqr at 1. rewrite Rmult_0_l. apply Rle_0_sqr.
Qed.

Example square_is_angle_instance : classify 0 (Vec 100 0 0) (Vec 0 0 1) = square <->
  PI / 2 - 0 <= angle (Vec 100 0 0) (Vec 0 0 1) <= PI / 2 + 0.
Proof. apply square_is_angle; [pose proof PI_half; lra | |]; intro E; injection E; intros; lra. Qed.

(** * Runs of blocks *)

(** fanuc.leading-edge.kept-along-the-tool: any number of blocks near 0 or 180 degrees keeps the vector from before them. *)
Theorem run_along_keeps delta r pairs s :
  Forall (fun p => classify delta (fst p) (snd p) = along \/ classify delta (fst p) (snd p) = against) pairs ->
  run delta r pairs s = s.
Proof.
  revert s; induction pairs as [| [VM VT] pairs IH]; intros s H; auto.
  apply Forall_cons_iff in H; destruct H as [H T]; cbn [fst snd] in H. unfold run; cbn [fold_left step].
  destruct H as [E | E]; rewrite E; apply IH, T.
Qed.

Lemma classify_along_0 VM VT : 0 < dot VM VT -> dot VM VM * dot VT VT <= (dot VM VT)² -> classify 0 VM VT = along.
Proof.
  intros A B; unfold classify; destruct Rlt_dec; [| lra]. rewrite cos_0. destruct Rle_dec; auto. unfold Rsqr in *; lra.
Qed.

Example run_along_keeps_instance s :
  run 0 10 [(Vec 60 0 80, Vec 3 0 4); (Vec 0 0 5, Vec 0 0 1)] s = s.
Proof.
  apply run_along_keeps. repeat apply Forall_cons; try apply Forall_nil; left;
    apply classify_along_0; unfold dot, Rsqr; cbn; lra.
Qed.

(** fanuc.leading-edge.across-keeps-sense: a run of blocks near 90 degrees keeps the sense from before it, and each vector is that
    of its own pair. *)
Theorem run_square_sense delta r pairs VM VT s :
  Forall (fun p => classify delta (fst p) (snd p) = square) (pairs ++ [(VM, VT)]) ->
  run delta r (pairs ++ [(VM, VT)]) s = State (VC (history s) r VM VT) (history s).
Proof.
  revert s; induction pairs as [| [A B] pairs IH]; intros s H; cbn [app] in *;
    apply Forall_cons_iff in H; destruct H as [H T]; cbn [fst snd] in H; unfold run; cbn [fold_left step]; rewrite H.
  - reflexivity.
  - unfold run in IH; rewrite IH by auto; reflexivity.
Qed.

Example run_square_sense_instance v :
  run 0 10 ([(Vec 100 0 0, Vec 0 0 1)] ++ [(Vec 0 5 0, Vec 0 0 1)]) (State v (-1)) =
  State (VC (-1) 10 (Vec 0 5 0) (Vec 0 0 1)) (-1).
Proof.
  apply run_square_sense. repeat apply Forall_cons; try apply Forall_nil;
    unfold classify, dot; cbn; do 2 (destruct Rlt_dec; [lra |]); reflexivity.
Qed.

(** fanuc.leading-edge.across-keeps-sense: away from 90 degrees the sense that is carried on is the one the manual reads off the
    previous vector: backward exactly where that vector points against its movement. *)
Theorem history_is_direction delta r VM VT s : 0 < r -> classify delta VM VT = oblique -> ~ parallel VM VT ->
  let s' := step delta r s (VM, VT) in
  (history s' = 1 <-> dot (vector s') VM < 0) /\ (history s' = -1 <-> 0 < dot (vector s') VM).
Proof.
  intros Hr C H s'. assert (Hd : dot VM VT <> 0).
  { intro E; unfold classify in C; rewrite E in C. destruct (Rlt_dec 0 0); [lra | discriminate]. }
  subst s'; unfold step; rewrite C; cbn [history vector].
  destruct (Rdichotomy _ _ Hd) as [L | L].
  - pose proof (VC_forward r VM VT Hr L H). unfold sense; destruct Rlt_dec; split; split; intros; lra.
  - pose proof (VC_backward r VM VT Hr L H). unfold sense; destruct Rlt_dec; split; split; intros; lra.
Qed.

Example history_is_direction_instance s :
  history (step 0 10 s (Vec 100 0 0, Vec 3 0 4)) = 1 <->
  dot (vector (step 0 10 s (Vec 100 0 0, Vec 3 0 4))) (Vec 100 0 0) < 0.
Proof.
  apply history_is_direction; [lra | | apply not_parallel_y; cbn; lra].
  unfold classify, dot; cbn. rewrite cos_0, sin_0. unfold Rsqr.
  destruct Rlt_dec; [| lra]. do 2 (destruct Rle_dec; [lra |]). reflexivity.
Qed.
