(* SPDX-License-Identifier: Apache-2.0 *)
(* The polynomials of fast/arithmetic/trigonometry.cpp (those of fdlibm) against sine and cosine: what sine.gappa and
   cosine.gappa take for granted. Constants are the doubles of the source, as fractions. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Open Scope R_scope.

Definition kh := 78602641 / 2 ^ 52.
Definition kl := 3103902894581251 / 2 ^ 104.
Definition s1 := -6004799503160649 / 2 ^ 55.
Definition s2 := 2401919801261139 / 2 ^ 58.
Definition s3 := -7320136532976085 / 2 ^ 65.
Definition s4 := 6506786730409597 / 2 ^ 71.
Definition s5 := -7571127717829867 / 2 ^ 78.
Definition s6 := 1537454791456095 / 2 ^ 83.
Definition c1 := 1501199875790163 / 2 ^ 55.
Definition c2 := -6405119470031223 / 2 ^ 62.
Definition c3 := 457508533350745 / 2 ^ 64.
Definition c4 := -5205429506036397 / 2 ^ 74.
Definition c5 := 1261860039765105 / 2 ^ 79.
Definition c6 := -1757820317994549 / 2 ^ 87.
Definition C (z : R) := z * (c1 + z * (c2 + z * (c3 + z * (c4 + z * (c5 + z * c6))))).
Definition S (z : R) := s2 + z * (s3 + z * (s4 + z * (s5 + z * s6))).

Lemma pi_in_two : Rabs (PI / 180000000 - (kh + kl)) <= / 2 ^ 106.
Proof. unfold kh, kl. interval with (i_prec 200). Qed.

Lemma sine_of_little x : Rabs (sin x) <= Rabs x.
Proof.
  assert (H : forall y, 0 <= y -> Rabs (sin y) <= y).
  { intros y Hy. destruct (Rle_dec y 1) as [H1 | H1].
    - assert (0 <= sin y) by (apply sin_ge_0; [lra | generalize PI_RGT_0 PI2_3_2; unfold PI2; intros; lra]).
      rewrite Rabs_right by lra. destruct (Req_dec y 0) as [-> | N]; [rewrite sin_0; lra |].
      generalize (sin_lt_x y ltac:(lra)). lra.
    - generalize (SIN_bound y). intros [? ?]. apply Rabs_le. lra. }
  destruct (Rle_dec 0 x) as [H0 | H0].
  - rewrite (Rabs_right x) by lra. auto.
  - rewrite (Rabs_left x) by lra. rewrite <- Rabs_Ropp, <- sin_neg. apply H. lra.
Qed.

Lemma cosine_step a b : Rabs (cos (a + b) - cos a) <= Rabs b.
Proof.
  replace (cos (a + b) - cos a) with (-2 * sin (b / 2) * sin (a + b / 2)).
  2: { rewrite form2. f_equal; [f_equal|]; f_equal; lra. }
  generalize (sine_of_little (b / 2)) (SIN_bound (a + b / 2)). intros H [H1 H2].
  rewrite !Rabs_mult. rewrite (Rabs_left (-2)) by lra.
  unfold Rdiv in H at 2. rewrite Rabs_mult, (Rabs_right (/ 2)) in H by lra.
  assert (Rabs (sin (a + b / 2)) <= 1) by (apply Rabs_le; lra).
  generalize (Rabs_pos (sin (b / 2))) (Rabs_pos (sin (a + b / 2))). nra.
Qed.

Lemma difference_of_products l a b c L A B : Rabs l <= L -> Rabs a <= A -> Rabs b <= B -> Rabs c <= 1 ->
  Rabs (l * a - b * c) <= L * A + B.
Proof.
  intros Hl Ha Hb Hc. unfold Rminus. eapply Rle_trans; [apply Rabs_triang |].
  rewrite Rabs_Ropp, !Rabs_mult.
  generalize (Rabs_pos l) (Rabs_pos a) (Rabs_pos b) (Rabs_pos c). nra.
Qed.

(* cosine.gappa: h = hi, l = lo, e = X - (hi + lo). *)
Lemma cosine_near h l e : Rabs h <= 0.785399 -> Rabs l <= / 2 ^ 53 -> Rabs e <= / 2 ^ 70 ->
  Rabs (cos (h + l + e) - (1 - 0.5 * (h * h) + h * h * C (h * h) - h * l)) <= / 2 ^ 56.
Proof.
  intros Hh Hl He.
  assert (A : Rabs (cos h - (1 - 0.5 * (h * h) + h * h * C (h * h))) <= / 2 ^ 58).
  { unfold C, c1, c2, c3, c4, c5, c6. interval with (i_bisect h, i_taylor h, i_degree 16, i_prec 90). }
  generalize (cosine_step (h + l) e). intros B.
  assert (D : Rabs (cos (h + l) - cos h + h * l) <= / 2 ^ 56 * 0.7).
  { replace (cos (h + l) - cos h + h * l) with
      (l * (h - sin (h + l / 2)) - (2 * sin (l / 2) - l) * sin (h + l / 2)).
    2: { replace (cos (h + l) - cos h) with (-2 * sin (l / 2) * sin (h + l / 2)); [ring |].
         rewrite form2. f_equal; [f_equal|]; f_equal; lra. }
    assert (D1 : Rabs (h - sin (h + l / 2)) <= 0.0785) by (interval with (i_bisect h, i_depth 20, i_prec 60)).
    assert (D2 : Rabs (2 * sin (l / 2) - l) <= / 2 ^ 70).
    { clear - Hl. interval with (i_taylor l, i_bisect l, i_prec 120). }
    assert (D3 : Rabs (sin (h + l / 2)) <= 1) by (apply Rabs_le, SIN_bound).
    eapply Rle_trans; [exact (difference_of_products _ _ _ _ _ _ _ Hl D1 D2 D3) | lra]. }
  revert A B D He. generalize (cos (h + l + e)) (cos (h + l)) (cos h) (1 - 0.5 * (h * h) + h * h * C (h * h)).
  intros a b c d A B D He.
  revert A B D He. split_Rabs; lra.
Qed.

Definition sine_slope (h : R) :=
  cos h - (1 + h ^ 2 * (3 * s1 + h ^ 2 * (5 * s2 + h ^ 2 * (7 * s3 + h ^ 2 * (9 * s4 +
    h ^ 2 * (11 * s5 + h ^ 2 * (13 * s6))))))).

Lemma sine_slope_near h : Rabs h <= / 16 -> Rabs (sine_slope h) <= / 2 ^ 57.
Proof.
  intros Hh. unfold sine_slope, s1, s2, s3, s4, s5, s6.
  interval with (i_bisect h, i_taylor h, i_degree 16, i_prec 90).
Qed.

Lemma sine_of_much h : / 16 <= h <= 0.785399 ->
  Rabs (sin h - h * (1 + h * h * (s1 + h * h * S (h * h)))) <= / 2 ^ 57 * h.
Proof.
  intros Hh. apply Rabs_le.
  assert (sin h - h * (1 + h * h * (s1 + h * h * S (h * h))) - / 2 ^ 57 * h <= 0 /\
          0 <= sin h - h * (1 + h * h * (s1 + h * h * S (h * h))) + / 2 ^ 57 * h); [| lra].
  unfold S, s1, s2, s3, s4, s5, s6.
  split; interval with (i_bisect h, i_taylor h, i_degree 16, i_prec 90).
Qed.

Lemma sine_of_small h : 0 < h <= / 16 ->
  Rabs (sin h - h * (1 + h * h * (s1 + h * h * S (h * h)))) <= / 2 ^ 57 * h.
Proof.
  intros Hh.
  pose (f := fun x => sin x - x * (1 + x * x * (s1 + x * x * S (x * x)))).
  destruct (MVT_gen f 0 h sine_slope) as [c [Hc E]].
  - intros x _. unfold f, S, sine_slope. auto_derive; [exact I |]. ring.
  - intros x _. apply continuity_pt_filterlim, (ex_derive_continuous f).
    unfold f, S. auto_derive. exact I.
  - rewrite Rmin_left, Rmax_right in Hc by lra.
    replace (f 0) with 0 in E by (unfold f; rewrite sin_0; ring).
    replace (h - 0) with h in E by ring. rewrite Rminus_0_r in E.
    fold (f h). rewrite E, Rabs_mult, (Rabs_right h) by lra.
    apply Rmult_le_compat_r; [lra |]. apply sine_slope_near. apply Rabs_le. lra.
Qed.

Lemma sine_step a b : Rabs (sin (a + b) - sin a) <= Rabs b.
Proof.
  replace (sin (a + b) - sin a) with (2 * cos (a + b / 2) * sin (b / 2)).
  2: { rewrite form4. f_equal; [f_equal|]; f_equal; lra. }
  generalize (sine_of_little (b / 2)) (COS_bound (a + b / 2)). intros H [H1 H2].
  rewrite !Rabs_mult. rewrite (Rabs_right 2) by lra.
  unfold Rdiv in H at 2. rewrite Rabs_mult, (Rabs_right (/ 2)) in H by lra.
  assert (Rabs (cos (a + b / 2)) <= 1) by (apply Rabs_le; lra).
  generalize (Rabs_pos (sin (b / 2))) (Rabs_pos (cos (a + b / 2))). nra.
Qed.

Lemma chord_of_little l : Rabs l <= / 2 ^ 50 -> Rabs (2 * sin (l / 2) - l) <= / 2 ^ 60 * Rabs l.
Proof.
  intros Hl.
  pose (g := fun x => 2 * sin (x / 2) - x).
  destruct (MVT_gen g 0 l (fun x => cos (x / 2) - 1)) as [c [Hc E]].
  - intros x _. unfold g. auto_derive; [exact I |]. unfold Rdiv. ring_simplify. f_equal. lra.
  - intros x _. apply continuity_pt_filterlim, (ex_derive_continuous g). unfold g. auto_derive. exact I.
  - replace (g 0) with 0 in E by (unfold g; replace (0 / 2) with 0 by lra; rewrite sin_0; ring).
    rewrite !Rminus_0_r in E. fold (g l). rewrite E, Rabs_mult.
    apply Rmult_le_compat_r; [apply Rabs_pos |].
    assert (Rabs c <= / 2 ^ 50).
    { revert Hc Hl. unfold Rmin, Rmax. destruct (Rle_dec 0 l); split_Rabs; lra. }
    interval with (i_prec 130).
Qed.

(* sine.gappa: h = hi, l = lo, e = X - (hi + lo). *)
Lemma sine_near h l e : 0 < h <= 0.785399 -> Rabs l <= / 2 ^ 53 * 1.1 * h -> Rabs e <= / 2 ^ 70 * h ->
  Rabs (sin (h + l + e) - (h * (1 + h * h * (s1 + h * h * S (h * h))) + l * (1 - 0.5 * (h * h)))) <= / 2 ^ 56 * h.
Proof.
  intros Hh Hl He.
  assert (A : Rabs (sin h - h * (1 + h * h * (s1 + h * h * S (h * h)))) <= / 2 ^ 57 * h).
  { destruct (Rle_dec h (/ 16)); [apply sine_of_small | apply sine_of_much]; lra. }
  assert (L : Rabs l <= / 2 ^ 53) by nra.
  generalize (sine_step (h + l) e). intros B.
  assert (D : Rabs (sin (h + l) - sin h - l * (1 - 0.5 * (h * h))) <=
              / 2 ^ 53 * 1.1 * h * 0.017 + / 2 ^ 60 * (/ 2 ^ 53 * 1.1 * h)).
  { replace (sin (h + l) - sin h - l * (1 - 0.5 * (h * h))) with
      (l * (cos (h + l / 2) - (1 - 0.5 * (h * h))) - (l - 2 * sin (l / 2)) * cos (h + l / 2)).
    2: { replace (sin (h + l) - sin h) with (2 * cos (h + l / 2) * sin (l / 2)); [ring |].
         rewrite form4. f_equal; [f_equal|]; f_equal; lra. }
    apply difference_of_products; [exact Hl | | | apply Rabs_le, COS_bound].
    - interval with (i_bisect h, i_taylor h, i_depth 20, i_prec 60).
    - rewrite Rabs_minus_sym. eapply Rle_trans; [apply chord_of_little; lra | lra]. }
  revert A B D He. generalize (sin (h + l + e)) (sin (h + l)) (sin h) (h * (1 + h * h * (s1 + h * h * S (h * h))))
    (l * (1 - 0.5 * (h * h))).
  intros a b c d f A B D He. revert A B D He. split_Rabs; lra.
Qed.

Lemma cosine_of_half_a_right_angle x : Rabs x <= 0.7854 -> 0.7071 <= cos x <= 1.
Proof. intros H. split; [interval with (i_prec 60) | apply COS_bound]. Qed.

Lemma sine_over_its_angle h l e : 0 < h <= 0.785399 -> Rabs l <= / 2 ^ 53 * 1.1 * h -> Rabs e <= / 2 ^ 70 * h ->
  0.9 * h <= sin (h + l + e) <= 1.0001 * h.
Proof.
  intros Hh Hl He. generalize (sine_near h l e Hh Hl He).
  assert (A : 0.9002 <= 1 + h * h * (s1 + h * h * S (h * h)) <= 1.00001).
  { unfold S, s1, s2, s3, s4, s5, s6. split; interval with (i_bisect h, i_taylor h, i_prec 60). }
  assert (B : Rabs (l * (1 - 0.5 * (h * h))) <= / 2 ^ 20 * h).
  { rewrite Rabs_mult. assert (Rabs (1 - 0.5 * (h * h)) <= 1) by (split_Rabs; nra).
    generalize (Rabs_pos l). nra. }
  revert A B. generalize (1 + h * h * (s1 + h * h * S (h * h))) (l * (1 - 0.5 * (h * h))) (sin (h + l + e)).
  intros a b c A B H. assert (0.9002 * h <= h * a <= 1.00001 * h) by nra. split_Rabs; lra.
Qed.
