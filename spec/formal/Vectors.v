(* SPDX-License-Identifier: Apache-2.0 *)
(** Vectors, lengths, angles and rigid motions: the geometry every section shares. *)
From Coq Require Import Reals Lra Psatz.
Open Scope R_scope.

(** A point or a direction, in the axes X, Y, Z of the programming coordinate system. *)
Record vec := Vec { vx : R; vy : R; vz : R }.

Definition zero := Vec 0 0 0.
Definition add u v := Vec (vx u + vx v) (vy u + vy v) (vz u + vz v).
Definition scale k u := Vec (k * vx u) (k * vy u) (k * vz u).
Definition opp u := scale (-1) u.
Definition sub u v := add u (opp v).
Definition dot u v := vx u * vx v + vy u * vy v + vz u * vz v.
Definition cross u v :=
  Vec (vy u * vz v - vz u * vy v) (vz u * vx v - vx u * vz v) (vx u * vy v - vy u * vx v).
Definition norm u := sqrt (dot u u).

(** The angle between two directions, in radians, from 0 to pi. *)
Definition angle u v := acos (dot u v / (norm u * norm v)).

(** Same or opposite direction (or a zero vector). *)
Definition parallel u v := cross u v = zero.

Ltac vec_ring :=
  repeat match goal with u : vec |- _ => destruct u end;
  unfold sub, opp, add, scale, dot, cross, zero; cbn [vx vy vz];
  match goal with |- Vec _ _ _ = Vec _ _ _ => f_equal | _ => idtac end; ring.

Lemma vec_eq u v : vx u = vx v -> vy u = vy v -> vz u = vz v -> u = v.
Proof. destruct u, v; cbn; intros; subst; reflexivity. Qed.

Lemma dot_comm u v : dot u v = dot v u.
Proof. vec_ring. Qed.

Lemma dot_scale_l k u v : dot (scale k u) v = k * dot u v.
Proof. vec_ring. Qed.

Lemma dot_scale_r k u v : dot u (scale k v) = k * dot u v.
Proof. vec_ring. Qed.

Lemma dot_add_l u v w : dot (add u v) w = dot u w + dot v w.
Proof. vec_ring. Qed.

Lemma dot_add_r u v w : dot u (add v w) = dot u v + dot u w.
Proof. vec_ring. Qed.

Lemma scale_scale j k u : scale j (scale k u) = scale (j * k) u.
Proof. vec_ring. Qed.

Lemma scale_add k u v : scale k (add u v) = add (scale k u) (scale k v).
Proof. vec_ring. Qed.

Lemma scale_zero_l u : scale 0 u = zero.
Proof. vec_ring. Qed.

Lemma scale_zero_r k : scale k zero = zero.
Proof. vec_ring. Qed.

Lemma scale_one u : scale 1 u = u.
Proof. vec_ring. Qed.

(** The vector triple product. *)
Lemma triple_product u v w : cross (cross u v) w = sub (scale (dot u w) v) (scale (dot v w) u).
Proof. vec_ring. Qed.

(** Lagrange's identity. *)
Lemma lagrange u v : dot (cross u v) (cross u v) = dot u u * dot v v - (dot u v)².
Proof. unfold Rsqr; vec_ring. Qed.

Lemma dot_self_nonneg u : 0 <= dot u u.
Proof. destruct u; unfold dot; cbn; nra. Qed.

Lemma dot_self_zero u : dot u u = 0 -> u = zero.
Proof.
  destruct u as [a b c]; unfold dot, zero; cbn; intro H.
  assert (a = 0) by nra. assert (b = 0) by nra. assert (c = 0) by nra. subst; reflexivity.
Qed.

Lemma dot_self_pos u : u <> zero -> 0 < dot u u.
Proof.
  intro H. destruct (Rtotal_order 0 (dot u u)) as [L | [E | G]]; auto.
  - exfalso; apply H; apply dot_self_zero; auto.
  - pose proof (dot_self_nonneg u); lra.
Qed.

Lemma norm_sqr u : norm u * norm u = dot u u.
Proof. unfold norm; apply sqrt_sqrt, dot_self_nonneg. Qed.

Lemma norm_nonneg u : 0 <= norm u.
Proof. apply sqrt_pos. Qed.

Lemma norm_pos u : u <> zero -> 0 < norm u.
Proof. intro H; apply sqrt_lt_R0, dot_self_pos, H. Qed.

Lemma norm_scale k u : norm (scale k u) = Rabs k * norm u.
Proof.
  unfold norm. replace (dot (scale k u) (scale k u)) with (k² * dot u u) by (unfold Rsqr; vec_ring).
  rewrite sqrt_mult_alt by apply Rle_0_sqr. rewrite sqrt_Rsqr_abs; reflexivity.
Qed.

Lemma norm_opp u : norm (opp u) = norm u.
Proof. unfold opp; rewrite norm_scale, Rabs_left by lra; ring. Qed.

Lemma nonzero_by_dot u v : dot u v <> 0 -> u <> zero /\ v <> zero.
Proof. intro H; split; intro E; subst; apply H; vec_ring. Qed.

(** Two directions are parallel exactly where one is a multiple of the other. *)
Lemma parallel_multiple u v : v <> zero -> (parallel u v <-> exists k, u = scale k v).
Proof.
  intro Hv; pose proof (dot_self_pos v Hv) as P; split.
  - intro H; exists (dot u v / dot v v).
    assert (E : scale (dot v v) u = scale (dot u v) v).
    { pose proof (triple_product u v v) as T. unfold parallel in H. rewrite H in T.
      apply vec_eq; [apply (f_equal vx) in T | apply (f_equal vy) in T | apply (f_equal vz) in T];
        unfold sub, opp, add, scale, cross, zero in *; cbn in *; lra. }
    transitivity (scale (/ dot v v) (scale (dot v v) u)).
    + rewrite scale_scale, Rinv_l, scale_one by lra; reflexivity.
    + rewrite E, scale_scale; f_equal; field; lra.
  - intros [k E]; subst; unfold parallel; vec_ring.
Qed.

(** Cauchy and Schwarz. *)
Lemma dot_bound u v : (dot u v)² <= dot u u * dot v v.
Proof. pose proof (lagrange u v). pose proof (dot_self_nonneg (cross u v)). lra. Qed.

Lemma cosine_bounds u v : u <> zero -> v <> zero -> -1 <= dot u v / (norm u * norm v) <= 1.
Proof.
  intros Hu Hv. pose proof (norm_pos u Hu). pose proof (norm_pos v Hv).
  assert (P : 0 < norm u * norm v) by nra.
  assert (B : - (norm u * norm v) <= dot u v <= norm u * norm v).
  { split; [apply Rsqr_neg_pos_le_0 | apply Rsqr_incr_0_var]; try lra;
      (replace ((norm u * norm v)²) with (dot u u * dot v v) by (rewrite <- !norm_sqr; unfold Rsqr; ring));
      apply dot_bound. }
  split; apply (Rmult_le_reg_r (norm u * norm v)); auto;
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.

Lemma cos_angle u v : u <> zero -> v <> zero -> cos (angle u v) * (norm u * norm v) = dot u v.
Proof.
  intros Hu Hv. unfold angle. rewrite cos_acos by (apply cosine_bounds; auto).
  field; split; apply Rgt_not_eq; apply norm_pos; auto.
Qed.

Lemma angle_bounds u v : 0 <= angle u v <= PI.
Proof. apply acos_bound. Qed.

(** A rigid motion of directions: the images of the axes are perpendicular and of length 1 (rotations and mirrors). *)
Record motion := Motion { e1 : vec; e2 : vec; e3 : vec }.

Definition move m u := add (scale (vx u) (e1 m)) (add (scale (vy u) (e2 m)) (scale (vz u) (e3 m))).

Definition rigid m :=
  dot (e1 m) (e1 m) = 1 /\ dot (e2 m) (e2 m) = 1 /\ dot (e3 m) (e3 m) = 1 /\
  dot (e1 m) (e2 m) = 0 /\ dot (e1 m) (e3 m) = 0 /\ dot (e2 m) (e3 m) = 0.

Lemma move_scale m k u : move m (scale k u) = scale k (move m u).
Proof. destruct m; unfold move; cbn [e1 e2 e3]; vec_ring. Qed.

Lemma move_add m u v : move m (add u v) = add (move m u) (move m v).
Proof. destruct m; unfold move; cbn [e1 e2 e3]; vec_ring. Qed.

Lemma move_sub m u v : move m (sub u v) = sub (move m u) (move m v).
Proof. unfold sub, opp; rewrite move_add, move_scale; reflexivity. Qed.

Lemma move_dot m u v : rigid m -> dot (move m u) (move m v) = dot u v.
Proof.
  intros (A & B & C & D & E & F). unfold move.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r.
  rewrite (dot_comm (e2 m) (e1 m)), (dot_comm (e3 m) (e1 m)), (dot_comm (e3 m) (e2 m)).
  rewrite A, B, C, D, E, F. unfold dot at 1; ring.
Qed.

Lemma move_norm m u : rigid m -> norm (move m u) = norm u.
Proof. intro H; unfold norm; rewrite move_dot by auto; reflexivity. Qed.
