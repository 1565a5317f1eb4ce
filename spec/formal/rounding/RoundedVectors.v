(* SPDX-License-Identifier: Apache-2.0 *)
(* Vectors whose components are rounded to 53 bits, to nearest, and how far rounding takes lengths, products and
   directions. Exponents have no least: what the engine computes with is 0, or far above the least double. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core Relative.
Open Scope R_scope.

Definition rnd (x : R) : R := round radix2 (FLX_exp 53) ZnearestE x.
Definition u : R := / 2 ^ 53.

Lemma rnd_error x : Rabs (rnd x - x) <= u * Rabs x.
Proof.
  unfold rnd, u.
  replace (/ 2 ^ 53) with (/ 2 * bpow radix2 (- 53 + 1)).
  - apply relative_error_N_FLX. reflexivity.
  - simpl. lra.
Qed.

Record vec := V3 { X : R; Y : R; Z : R }.
Definition add a b := V3 (X a + X b) (Y a + Y b) (Z a + Z b).
Definition sub a b := V3 (X a - X b) (Y a - Y b) (Z a - Z b).
Definition scale k a := V3 (k * X a) (k * Y a) (k * Z a).
Definition dot a b := X a * X b + Y a * Y b + Z a * Z b.
Definition cross a b := V3 (Y a * Z b - Z a * Y b) (Z a * X b - X a * Z b) (X a * Y b - Y a * X b).
Definition norm a := sqrt (dot a a).

Lemma dot_nonneg a : 0 <= dot a a.
Proof. unfold dot. nra. Qed.
Lemma norm_nonneg a : 0 <= norm a.
Proof. apply sqrt_pos. Qed.
Lemma norm_square a : norm a * norm a = dot a a.
Proof. apply sqrt_sqrt, dot_nonneg. Qed.

Lemma norm_at_most a k : 0 <= k -> dot a a <= k * k -> norm a <= k.
Proof. intros Hk H. rewrite <- (sqrt_square k Hk). apply sqrt_le_1_alt, H. Qed.

Lemma lagrange a b : dot (cross a b) (cross a b) + dot a b * dot a b = dot a a * dot b b.
Proof. unfold dot, cross. simpl. ring. Qed.

Lemma cross_at_most a b : norm (cross a b) <= norm a * norm b.
Proof.
  apply norm_at_most; [apply Rmult_le_pos; apply norm_nonneg |].
  replace (norm a * norm b * (norm a * norm b)) with ((norm a * norm a) * (norm b * norm b)) by ring.
  rewrite !norm_square, <- lagrange. generalize (Rle_0_sqr (dot a b)). unfold Rsqr. lra.
Qed.

Lemma dot_at_most a b : dot a b <= norm a * norm b.
Proof.
  destruct (Rle_dec (dot a b) 0) as [H | H].
  - generalize (Rmult_le_pos _ _ (norm_nonneg a) (norm_nonneg b)). lra.
  - apply Rsqr_incr_0; [| lra | apply Rmult_le_pos; apply norm_nonneg]. unfold Rsqr.
    replace (norm a * norm b * (norm a * norm b)) with ((norm a * norm a) * (norm b * norm b)) by ring.
    rewrite !norm_square, <- lagrange. generalize (dot_nonneg (cross a b)). lra.
Qed.

Lemma triangle a b : norm (add a b) <= norm a + norm b.
Proof.
  generalize (norm_nonneg a) (norm_nonneg b). intros Ha Hb. apply norm_at_most; [lra |].
  replace (dot (add a b) (add a b)) with (dot a a + dot b b + 2 * dot a b) by (unfold dot, add; simpl; ring).
  rewrite <- !norm_square. generalize (dot_at_most a b). lra.
Qed.

Lemma norm_scale k a : norm (scale k a) = Rabs k * norm a.
Proof.
  unfold norm. replace (dot (scale k a) (scale k a)) with (k * k * dot a a) by (unfold dot, scale; simpl; ring).
  rewrite sqrt_mult_alt by nra. f_equal. apply sqrt_Rsqr_abs.
Qed.

Definition within (a b : vec) := Rabs (X a) <= X b /\ Rabs (Y a) <= Y b /\ Rabs (Z a) <= Z b.
Definition magnitude a := V3 (Rabs (X a)) (Rabs (Y a)) (Rabs (Z a)).

Lemma square_within x y : Rabs x <= y -> x * x <= y * y.
Proof. intros H. generalize (Rabs_pos x). intros P. split_Rabs; nra. Qed.

Lemma norm_within a b : within a b -> norm a <= norm b.
Proof.
  intros (HX & HY & HZ). apply sqrt_le_1_alt. unfold dot.
  generalize (square_within _ _ HX) (square_within _ _ HY) (square_within _ _ HZ). lra.
Qed.

Lemma norm_magnitude a : norm (magnitude a) = norm a.
Proof. unfold norm, magnitude, dot. simpl. f_equal. rewrite <- !Rabs_mult, !Rabs_right by nra. reflexivity. Qed.

(* The cross product as it is computed. *)
Definition rcross a b := V3 (rnd (rnd (Y a * Z b) - rnd (Z a * Y b))) (rnd (rnd (Z a * X b) - rnd (X a * Z b)))
                            (rnd (rnd (X a * Y b) - rnd (Y a * X b))).
Definition pcross a b := V3 (rnd (Y a * Z b) - rnd (Z a * Y b)) (rnd (Z a * X b) - rnd (X a * Z b))
                            (rnd (X a * Y b) - rnd (Y a * X b)).

Lemma u_positive : 0 < u <= / 2 ^ 53.
Proof. unfold u. lra. Qed.

Lemma products_error a b : norm (sub (pcross a b) (cross a b)) <= 1.4143 * u * (norm a * norm b).
Proof.
  assert (Pu := u_positive). assert (Na := norm_nonneg a). assert (Nb := norm_nonneg b).
  set (P := V3 (u * (Rabs (Y a * Z b) + Rabs (Z a * Y b))) (u * (Rabs (Z a * X b) + Rabs (X a * Z b)))
               (u * (Rabs (X a * Y b) + Rabs (Y a * X b)))).
  apply Rle_trans with (norm P).
  - apply norm_within. unfold P, within, sub, pcross, cross. simpl.
    assert (H : forall p q, Rabs (rnd p - rnd q - (p - q)) <= u * (Rabs p + Rabs q)).
    { intros p q. replace (rnd p - rnd q - (p - q)) with ((rnd p - p) + - (rnd q - q)) by ring.
      eapply Rle_trans; [apply Rabs_triang |]. rewrite Rabs_Ropp. generalize (rnd_error p) (rnd_error q). lra. }
    repeat split; apply H.
  - assert (H : forall p q r s, (Rabs (p * q) + Rabs (r * s)) * (Rabs (p * q) + Rabs (r * s)) <= (p * p + r * r) * (q
    * q + s * s)).
    { intros p q r s. rewrite !Rabs_mult.
      assert (E : forall x, x * x = Rabs x * Rabs x) by (intros x; rewrite <- Rabs_mult, Rabs_right by nra;
        reflexivity).
      rewrite (E p), (E q), (E r), (E s).
      generalize (Rabs p) (Rabs q) (Rabs r) (Rabs s). intros a' b' c' d'.
      generalize (Rle_0_sqr (a' * d' - c' * b')). unfold Rsqr. nra. }
    apply norm_at_most; [apply Rmult_le_pos; [lra | apply Rmult_le_pos; assumption] |].
    replace (1.4143 * u * (norm a * norm b) * (1.4143 * u * (norm a * norm b))) with
      (1.4143 * 1.4143 * (u * u) * ((norm a * norm a) * (norm b * norm b))) by ring.
    rewrite !norm_square. unfold P, dot. simpl.
    generalize (H (Y a) (Z b) (Z a) (Y b)) (H (Z a) (X b) (X a) (Z b)) (H (X a) (Y b) (Y a) (X b)).
    generalize (Rabs (Y a * Z b) + Rabs (Z a * Y b)) (Rabs (Z a * X b) + Rabs (X a * Z b)) (Rabs (X a * Y b) + Rabs (Y
      a * X b)).
    intros p q r HX HY HZ.
    assert (S : p * p + q * q + r * r <= 2 * ((X a * X a + Y a * Y a + Z a * Z a) * (X b * X b + Y b * Y b + Z b * Z
      b))).
    { generalize (Rle_0_sqr (X a * Y b)) (Rle_0_sqr (X a * Z b)) (Rle_0_sqr (Y a * X b)) (Rle_0_sqr (Y a * Z b))
        (Rle_0_sqr (Z a * X b)) (Rle_0_sqr (Z a * Y b)). unfold Rsqr. lra. }
    generalize (dot_nonneg a) (dot_nonneg b). unfold dot. intros Da Db.
    assert (U : 0 <= u * u) by nra.
    replace (u * p * (u * p) + u * q * (u * q) + u * r * (u * r)) with (u * u * (p * p + q * q + r * r)) by ring.
    revert S. generalize (Rmult_le_pos _ _ Da Db).
    generalize ((X a * X a + Y a * Y a + Z a * Z a) * (X b * X b + Y b * Y b + Z b * Z b)). intros D' HD S.
    replace (1.4143 * 1.4143 * (u * u) * D') with (u * u * (1.4143 * 1.4143 * D')) by ring.
    apply Rmult_le_compat_l; [exact U |]. lra.
Qed.

Lemma rcross_error a b :
  norm (sub (rcross a b) (cross a b)) <= 1.4144 * u * (norm a * norm b) + u * norm (cross a b).
Proof.
  assert (Pu := u_positive). assert (Na := norm_nonneg a). assert (Nb := norm_nonneg b).
  assert (H := products_error a b).
  replace (sub (rcross a b) (cross a b)) with
    (add (sub (rcross a b) (pcross a b)) (sub (pcross a b) (cross a b))) by (unfold add, sub; simpl; f_equal; ring).
  eapply Rle_trans; [apply triangle |].
  assert (Q : norm (sub (rcross a b) (pcross a b)) <= u * norm (pcross a b)).
  { replace (u * norm (pcross a b)) with (norm (scale u (magnitude (pcross a b)))).
    - apply norm_within. repeat split; apply rnd_error.
    - rewrite norm_scale, norm_magnitude, (Rabs_right u) by lra. reflexivity. }
  assert (T : norm (pcross a b) <= norm (cross a b) + norm (sub (pcross a b) (cross a b))).
  { replace (norm (pcross a b)) with (norm (add (cross a b) (sub (pcross a b) (cross a b)))) by (f_equal; unfold add,
    sub, pcross, cross; simpl; f_equal; ring).
    apply triangle. }
  assert (D : 0 <= norm a * norm b) by (apply Rmult_le_pos; assumption).
  revert H Q T D. generalize (norm a * norm b) (norm (cross a b)) (norm (sub (pcross a b) (cross a b))) (norm (pcross
    a b))
    (norm (sub (rcross a b) (pcross a b))). intros d c p q r H Q T D.
  unfold u in *. nra.
Qed.

(* A length, and a multiple, as they are computed. *)
Definition rnorm a := rnd (sqrt (rnd (rnd (rnd (X a * X a) + rnd (Y a * Y a)) + rnd (Z a * Z a)))).
Definition rscale f a := V3 (rnd (X a * f)) (rnd (Y a * f)) (rnd (Z a * f)).

Lemma rnd_between x l h : 0 <= l <= x -> x <= h -> (1 - u) * l <= rnd x <= (1 + u) * h.
Proof.
  intros Hl Hh. assert (Pu := u_positive). generalize (rnd_error x). rewrite (Rabs_right x) by lra. intros H.
  assert (u * x <= u * h) by (apply Rmult_le_compat_l; lra).
  assert ((1 - u) * l <= (1 - u) * x) by (apply Rmult_le_compat_l; lra).
  split_Rabs; lra.
Qed.

Lemma rnorm_error a : (1 - 2.51 * u) * norm a <= rnorm a <= (1 + 2.51 * u) * norm a.
Proof.
  assert (Pu := u_positive). unfold rnorm.
  assert (Q : forall x, 0 <= x * x) by (intros x; nra).
  assert (HX := rnd_between (X a * X a) (X a * X a) (X a * X a) ltac:(generalize (Q (X a)); lra) ltac:(lra)).
  assert (HY := rnd_between (Y a * Y a) (Y a * Y a) (Y a * Y a) ltac:(generalize (Q (Y a)); lra) ltac:(lra)).
  assert (HZ := rnd_between (Z a * Z a) (Z a * Z a) (Z a * Z a) ltac:(generalize (Q (Z a)); lra) ltac:(lra)).
  generalize (Q (X a)) (Q (Y a)) (Q (Z a)). intros QX QY QZ.
  set (p := rnd (X a * X a)) in *. set (q := rnd (Y a * Y a)) in *. set (r := rnd (Z a * Z a)) in *.
  assert (H1 := rnd_between (p + q) ((1 - u) * (X a * X a + Y a * Y a)) ((1 + u) * (X a * X a + Y a * Y a))
    ltac:(split; [apply Rmult_le_pos |]; lra) ltac:(lra)).
  set (t := rnd (p + q)) in *.
  assert (L : (1 - u) * ((1 - u) * (Z a * Z a)) <= (1 - u) * (Z a * Z a)).
  { rewrite <- (Rmult_1_l ((1 - u) * (Z a * Z a))) at 2. apply Rmult_le_compat_r; [apply Rmult_le_pos |]; lra. }
  assert (G : (1 + u) * (Z a * Z a) <= (1 + u) * ((1 + u) * (Z a * Z a))).
  { rewrite <- (Rmult_1_l ((1 + u) * (Z a * Z a))) at 1. apply Rmult_le_compat_r; [apply Rmult_le_pos |]; lra. }
  assert (H2 := rnd_between (t + r) ((1 - u) * ((1 - u) * dot a a)) ((1 + u) * ((1 + u) * dot a a))
    ltac:(unfold dot; split; [repeat apply Rmult_le_pos |]; lra) ltac:(unfold dot; lra)).
  set (w := rnd (t + r)) in *.
  assert (Dp := dot_nonneg a). assert (Na := norm_nonneg a).
  assert (S1 : (1 - 1.501 * u) * norm a <= sqrt w).
  { rewrite <- (sqrt_square ((1 - 1.501 * u) * norm a)) by (apply Rmult_le_pos; lra).
    apply sqrt_le_1_alt. eapply Rle_trans; [| apply (proj1 H2)].
    replace ((1 - 1.501 * u) * norm a * ((1 - 1.501 * u) * norm a)) with
      ((1 - 1.501 * u) * (1 - 1.501 * u) * (norm a * norm a)) by ring.
    rewrite norm_square. rewrite <- !Rmult_assoc. apply Rmult_le_compat_r; [exact Dp |]. unfold u. lra. }
  assert (S2 : sqrt w <= (1 + 1.501 * u) * norm a).
  { rewrite <- (sqrt_square ((1 + 1.501 * u) * norm a)) by (apply Rmult_le_pos; lra).
    apply sqrt_le_1_alt. eapply Rle_trans; [apply (proj2 H2) |].
    replace ((1 + 1.501 * u) * norm a * ((1 + 1.501 * u) * norm a)) with
      ((1 + 1.501 * u) * (1 + 1.501 * u) * (norm a * norm a)) by ring.
    rewrite norm_square. rewrite <- !Rmult_assoc. apply Rmult_le_compat_r; [exact Dp |]. unfold u. lra. }
  assert (H3 := rnd_between (sqrt w) ((1 - 1.501 * u) * norm a) ((1 + 1.501 * u) * norm a)
    ltac:(split; [apply Rmult_le_pos |]; lra) ltac:(lra)).
  revert H3. rewrite <- !Rmult_assoc. intros [H3 H4]. split.
  - eapply Rle_trans; [| exact H3]. apply Rmult_le_compat_r; [exact Na |]. unfold u. lra.
  - eapply Rle_trans; [exact H4 |]. apply Rmult_le_compat_r; [exact Na |]. unfold u. lra.
Qed.

(* Two directions differ by what the vectors differ by, over the length. *)
Lemma directions_differ a b : 0 < norm b -> (1 - / 2 ^ 37) * norm b <= norm a ->
  norm (sub (scale (/ norm a) a) (scale (/ norm b) b)) <= (1 + / 2 ^ 36) * (norm (sub a b) / norm b).
Proof.
  intros Hb Ha. assert (Pa : 0 < norm a) by nra.
  assert (Nd := norm_nonneg (sub a b)).
  assert (Hq : 0 <= norm (sub a b) / norm b) by (apply Rmult_le_pos; [exact Nd | left; apply Rinv_0_lt_compat, Hb]).
  apply norm_at_most; [apply Rmult_le_pos; [lra | exact Hq] |].
  assert (E : dot (sub a b) (sub a b) = (norm a - norm b) * (norm a - norm b) +
    norm a * norm b * dot (sub (scale (/ norm a) a) (scale (/ norm b) b)) (sub (scale (/ norm a) a) (scale (/ norm b)
      b))).
  { replace (dot (sub (scale (/ norm a) a) (scale (/ norm b) b)) (sub (scale (/ norm a) a) (scale (/ norm b) b))) with
      (/ norm a * / norm a * dot a a + / norm b * / norm b * dot b b - 2 * (/ norm a * / norm b * dot a b))
      by (unfold dot, sub, scale; simpl; ring).
    replace (dot (sub a b) (sub a b)) with (dot a a + dot b b - 2 * dot a b) by (unfold dot, sub; simpl; ring).
    rewrite <- !norm_square. field. split; lra. }
  revert E. generalize (dot (sub (scale (/ norm a) a) (scale (/ norm b) b)) (sub (scale (/ norm a) a) (scale (/ norm
    b) b))).
  intros d E.
  replace ((1 + / 2 ^ 36) * (norm (sub a b) / norm b) * ((1 + / 2 ^ 36) * (norm (sub a b) / norm b))) with
    ((1 + / 2 ^ 36) * (1 + / 2 ^ 36) * ((norm (sub a b) * norm (sub a b)) / (norm b * norm b))) by (field; lra).
  rewrite (norm_square (sub a b)).
  assert (D : norm a * norm b * d <= dot (sub a b) (sub a b)).
  { generalize (Rle_0_sqr (norm a - norm b)). unfold Rsqr. lra. }
  assert (D2 : (1 - / 2 ^ 37) * (norm b * norm b) * d <= dot (sub a b) (sub a b)).
  { destruct (Rle_dec 0 d) as [P | P].
    - eapply Rle_trans; [| exact D]. apply Rmult_le_compat_r; [exact P |].
      replace ((1 - / 2 ^ 37) * (norm b * norm b)) with ((1 - / 2 ^ 37) * norm b * norm b) by ring.
      apply Rmult_le_compat_r; lra.
    - generalize (dot_nonneg (sub a b)). intros Q. assert (0 <= (1 - / 2 ^ 37) * (norm b * norm b)) by nra. nra. }
  apply Rmult_le_reg_r with (norm b * norm b); [nra |].
  replace ((1 + / 2 ^ 36) * (1 + / 2 ^ 36) * (dot (sub a b) (sub a b) / (norm b * norm b)) * (norm b * norm b)) with
    ((1 + / 2 ^ 36) * (1 + / 2 ^ 36) * dot (sub a b) (sub a b)) by (field; lra).
  revert D2. generalize (dot_nonneg (sub a b)). generalize (dot (sub a b) (sub a b)) (norm b * norm b). intros x y Px
    D2.
  assert ((1 - / 2 ^ 37) * (d * y) <= x) by lra. lra.
Qed.
