(* SPDX-License-Identifier: Apache-2.0 *)
(* What the scripts of Gappa take for granted of real numbers: its arithmetic is that of intervals, and does not know
   that a square is a share of a sum of squares, or a component no longer than its vector. *)
From Coq Require Import Reals Lra Psatz.
From Interval Require Import Tactic.
Open Scope R_scope.

Lemma share_of_a_square a b : 0 <= a -> 0 <= b -> 0 < a + b -> 0 <= a / (a + b) <= 1.
Proof.
  intros Ha Hb H. split.
  - apply Rmult_le_pos; [exact Ha | left; apply Rinv_0_lt_compat, H].
  - apply Rmult_le_reg_r with (a + b); [exact H |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma at_most_root a b : a * a <= b -> Rabs a <= sqrt b.
Proof. intros H. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. exact H. Qed.

Lemma over_root a b : a * a <= b -> 0 < b -> Rabs (a / sqrt b) <= 1.
Proof.
  intros H Hb. assert (P := sqrt_lt_R0 b Hb). unfold Rdiv. rewrite Rabs_mult, (Rabs_right (/ sqrt b)).
  - apply Rmult_le_reg_r with (sqrt b); [exact P |]. rewrite Rmult_assoc, Rinv_l by lra.
    generalize (at_most_root a b H). lra.
  - left. apply Rinv_0_lt_compat, P.
Qed.

Lemma at_most_one a : a * a <= 1 -> Rabs a <= 1.
Proof. intros H. rewrite <- sqrt_1 at 1. apply at_most_root. exact H. Qed.

Lemma component_of_a_unit_vector x y z :
  0 < x * x + y * y + z * z -> Rabs (x / sqrt (x * x + y * y + z * z)) <= 1.
Proof. intros H. apply over_root; nra. Qed.

Lemma lagrange x1 y1 x2 y2 :
  (x1 * y2 - y1 * x2) * (x1 * y2 - y1 * x2) + (x1 * x2 + y1 * y2) * (x1 * x2 + y1 * y2) =
  (x1 * x1 + y1 * y1) * (x2 * x2 + y2 * y2).
Proof. ring. Qed.

Lemma half_of_a_right_angle x1 y1 x2 y2 :
  let c := x1 * y2 - y1 * x2 in
  let k := x1 * x2 + y1 * y2 in
  let m := sqrt (x1 * x1 + y1 * y1) * sqrt (x2 * x2 + y2 * y2) in
  0 < c -> 0 <= k -> c / (m + k) <= 1.
Proof.
  intros c k m Hc Hk. unfold m. rewrite <- sqrt_mult_alt by nra. rewrite <- lagrange. fold c k.
  assert (H : c <= sqrt (c * c + k * k)).
  { rewrite <- (Rabs_right c) at 1 by lra. apply at_most_root. nra. }
  apply Rmult_le_reg_r with (sqrt (c * c + k * k) + k); [lra |].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Lemma half_of_a_right_angle_back x1 y1 x2 y2 :
  let c := x1 * y2 - y1 * x2 in
  let k := x1 * x2 + y1 * y2 in
  let m := sqrt (x1 * x1 + y1 * y1) * sqrt (x2 * x2 + y2 * y2) in
  1 <= c <= 2 ^ 63 -> - 2 ^ 63 <= k <= 0 -> 1 <= (m - k) / c <= 2 ^ 65.
Proof.
  intros c k m Hc Hk. unfold m. rewrite <- sqrt_mult_alt by nra. rewrite <- lagrange. fold c k.
  assert (H : c <= sqrt (c * c + k * k)).
  { rewrite <- (Rabs_right c) at 1 by lra. apply at_most_root. nra. }
  assert (G : sqrt (c * c + k * k) <= c - k).
  { rewrite <- (sqrt_Rsqr (c - k)) by lra. apply sqrt_le_1_alt. unfold Rsqr. nra. }
  split; apply Rmult_le_reg_r with c; try lra; unfold Rdiv; rewrite Rmult_assoc, Rinv_l; nra.
Qed.

Lemma component_along_a_corner x y t : x * x + y * y = 1 -> Rabs ((- y - x * t) / sqrt (1 + t * t)) <= 1.
Proof.
  intros H. apply over_root; [| nra].
  generalize (lagrange x y t 1) (Rle_0_sqr (x * 1 - y * t)). rewrite H. unfold Rsqr. lra.
Qed.

Lemma component_along_a_corner_back x y i : x * x + y * y = 1 -> Rabs ((- y * i - x) / sqrt (1 + i * i)) <= 1.
Proof.
  intros H. apply over_root; [| nra].
  generalize (lagrange x y 1 i) (Rle_0_sqr (x * i - y * 1)). rewrite H. unfold Rsqr. lra.
Qed.

Lemma component_of_a_cross_product ty tz hy hz :
  ty * ty + tz * tz <= 1 -> hy * hy + hz * hz <= 1 -> Rabs (ty * hz - tz * hy) <= 1.
Proof.
  intros HT HH. apply at_most_one. generalize (lagrange ty tz hy hz).
  generalize (ty * hy + tz * hz). intros k E.
  assert ((ty * ty + tz * tz) * (hy * hy + hz * hz) <= 1) by nra. nra.
Qed.

(* Two components of a vector of length 1, turned by an angle. *)
Lemma component_of_a_turned_vector x y s c : x * x + y * y <= 1 -> s * s + c * c = 1 -> Rabs (c * x - s * y) <= 1.
Proof.
  intros HV HA.
  replace (c * x - s * y) with (c * x - s * y) by ring.
  apply component_of_a_cross_product; lra.
Qed.

(* The vector that direction_nutating.gappa turns. *)
Lemma component_of_a_nutating_vector si ci :
  si * si + ci * ci = 1 -> (sqrt (/ 2) * si) * (sqrt (/ 2) * si) + (/ 2 - / 2 * ci) * (/ 2 - / 2 * ci) <= 1.
Proof.
  intros H. replace ((sqrt (/ 2) * si) * (sqrt (/ 2) * si)) with ((sqrt (/ 2) * sqrt (/ 2)) * (si * si)) by ring.
  rewrite sqrt_sqrt by lra. nra.
Qed.

Lemma root_of_it q : 0 < q -> sqrt q * (1 / q) * sqrt q = 1.
Proof.
  intros H. replace (sqrt q * (1 / q) * sqrt q) with ((sqrt q * sqrt q) * / q) by (unfold Rdiv; ring).
  rewrite sqrt_sqrt by lra. field. lra.
Qed.

(* What a square exceeds 1 by, e 10^-16: 1/root by its series. *)
Lemma inverse_root_series e : Rabs e <= 2000000000000 ->
  let x := e / 10 ^ 16 in
  Rabs (((1 - x / 2) + x * x * ((3 / 8 - x * (5 / 16)) + x * x * (35 / 128))) - 1 / sqrt (1 + x)) <= / 2 ^ 63 /\
  0.9998 <= 1 / sqrt (1 + x) <= 1.0002.
Proof.
  intros He x. assert (H : Rabs x <= 0.0002) by (unfold x; split_Rabs; lra).
  clearbody x. clear He. split; [| split; interval with (i_prec 60)].
  interval with (i_bisect x, i_taylor x, i_degree 8, i_prec 90).
Qed.
