(* SPDX-License-Identifier: Apache-2.0 *)
(** Cosines of rational numbers of degrees: what can be said of them without rounding. *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List.
Import ListNotations.
Local Open Scope R_scope.

Definition cosine (q : Q) : R := cos (Q2R q * PI / 180).

(** * In the first quarter *)

Definition wrapped (q : Q) : Q := Qred (q - inject_Z (360 * (Qnum q / (360 * Zpos (Qden q))))).
(** From 0 to 90 degrees; whether the cosine is the opposite of theirs. *)
Definition folded (q : Q) : bool * Q :=
  let turn := wrapped q in
  let half := if Qle_bool turn 180 then turn else Qred (360 - turn) in
  if Qle_bool half 90 then (false, half) else (true, Qred (180 - half)).

Lemma red q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma turns (k : Z) y : cos (y + IZR k * (2 * PI)) = cos y.
Proof.
  assert (P : forall n y, cos (y + INR n * (2 * PI)) = cos y).
  { intros n z. rewrite <- (cos_period z n). f_equal. ring. }
  destruct (Z_le_gt_dec 0 k) as [L|G].
  - rewrite <- (Z2Nat.id k L), <- INR_IZR_INZ. apply P.
  - rewrite <- (P (Z.to_nat (- k)) (y + IZR k * (2 * PI))). f_equal.
    rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR by lia. lra.
Qed.

Lemma wrapped_cosine q : cosine q = cosine (wrapped q).
Proof.
  unfold cosine, wrapped. rewrite red, Q2R_minus. set (k := (Qnum q / (360 * Zpos (Qden q)))%Z).
  unfold inject_Z. unfold Q2R at 3. cbn [Qnum Qden]. rewrite Rinv_1, mult_IZR.
  rewrite <- (turns k ((Q2R q - 360 * IZR k * 1) * PI / 180)). f_equal. field.
Qed.

Lemma whole_degrees n : Q2R (inject_Z n) = IZR n.
Proof. unfold Q2R, inject_Z; cbn. lra. Qed.

(** How far beside a full or a half turn, and on which side, does not matter. *)
Lemma cosine_beside_turn q : cosine (360 - q) = cosine q.
Proof.
  unfold cosine. rewrite Q2R_minus. change 360%Q with (inject_Z 360). rewrite whole_degrees, <- (cos_neg (Q2R q * PI / 180)).
  rewrite <- (turns 1 (- (Q2R q * PI / 180))). f_equal. field.
Qed.
Lemma cosine_beside_half q : cosine (180 - q) = - cosine q.
Proof.
  unfold cosine. rewrite Q2R_minus. change 180%Q with (inject_Z 180). rewrite whole_degrees, <- (cos_neg (Q2R q * PI / 180)).
  rewrite <- neg_cos. f_equal. field.
Qed.
Lemma cosine_red q : cosine (Qred q) = cosine q.
Proof. unfold cosine. now rewrite red. Qed.

Lemma folded_cosine q negative w : folded q = (negative, w) -> cosine q = if negative then - cosine w else cosine w.
Proof.
  unfold folded. rewrite wrapped_cosine. generalize (wrapped q). intros turn.
  assert (H : cosine turn = cosine (if Qle_bool turn 180 then turn else Qred (360 - turn))).
  { destruct (Qle_bool turn 180); [reflexivity|]. now rewrite cosine_red, cosine_beside_turn. }
  rewrite H. generalize (if Qle_bool turn 180 then turn else Qred (360 - turn)). intros half. clear H.
  destruct (Qle_bool half 90); intros E.
  - assert (N : negative = false) by congruence. assert (W : w = half) by congruence. now rewrite N, W.
  - assert (N : negative = true) by congruence. assert (W : w = Qred (180 - half)) by congruence. rewrite N, W.
    rewrite cosine_red, cosine_beside_half. ring.
Qed.

(** * Simple ones *)

Lemma half_of_root2 : / sqrt 2 = / 2 * sqrt 2.
Proof.
  pose proof (sqrt_sqrt 2 ltac:(lra)) as S. assert (P : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  apply (Rmult_eq_reg_r (sqrt 2)); [|lra]. rewrite Rinv_l by lra. nra.
Qed.
Lemma cosine_equal p q : (p == q)%Q -> cosine p = cosine q.
Proof. intro E. unfold cosine. now rewrite (Qeq_eqR _ _ E). Qed.
Lemma cosine_whole n : cosine (inject_Z n) = cos (IZR n * PI / 180).
Proof. unfold cosine. now rewrite whole_degrees. Qed.
Lemma cosine_0 : cosine 0 = 1.
Proof. change 0%Q with (inject_Z 0). rewrite cosine_whole, <- cos_0. f_equal. field. Qed.
Lemma cosine_30 : cosine 30 = / 2 * sqrt 3.
Proof. change 30%Q with (inject_Z 30). rewrite cosine_whole. replace (30 * PI / 180) with (PI / 6) by field. rewrite cos_PI6. lra. Qed.
Lemma cosine_45 : cosine 45 = / 2 * sqrt 2.
Proof.
  change 45%Q with (inject_Z 45). rewrite cosine_whole. replace (45 * PI / 180) with (PI / 4) by field.
  rewrite cos_PI4, <- half_of_root2. lra.
Qed.
Lemma cosine_60 : cosine 60 = / 2.
Proof. change 60%Q with (inject_Z 60). rewrite cosine_whole. replace (60 * PI / 180) with (PI / 3) by field. rewrite cos_PI3. lra. Qed.
Lemma cosine_90 : cosine 90 = 0.
Proof. change 90%Q with (inject_Z 90). rewrite cosine_whole. replace (90 * PI / 180) with (PI / 2) by field. apply cos_PI2. Qed.

(** * Products *)

Lemma cosine_product p q : cosine p * cosine q = / 2 * (cosine (p + q) + cosine (p - q)).
Proof.
  unfold cosine. rewrite Q2R_plus, Q2R_minus. set (x := Q2R p * PI / 180). set (y := Q2R q * PI / 180).
  replace ((Q2R p + Q2R q) * PI / 180) with (x + y) by (unfold x, y; field).
  replace ((Q2R p - Q2R q) * PI / 180) with (x - y) by (unfold x, y; field).
  rewrite cos_plus, cos_minus. lra.
Qed.
Lemma root_2_cosine q : sqrt 2 * cosine q = cosine (q + 45) + cosine (q - 45).
Proof. pose proof (cosine_product q 45) as P. rewrite cosine_45 in P. lra. Qed.
Lemma root_3_cosine q : sqrt 3 * cosine q = cosine (q + 30) + cosine (q - 30).
Proof. pose proof (cosine_product q 30) as P. rewrite cosine_30 in P. lra. Qed.
Lemma cosine_beyond_60 q : cosine q = cosine (q - 60) - cosine (120 - q).
Proof.
  pose proof (cosine_product (q - 60) 60) as P. rewrite cosine_60 in P.
  rewrite (cosine_equal (q - 60 + 60) q) in P by ring.
  replace (cosine (q - 60 - 60)) with (cosine (120 - q)) in P; [lra|].
  unfold cosine. rewrite !Q2R_minus, <- cos_neg. f_equal.
  change 120%Q with (inject_Z 120). change 60%Q with (inject_Z 60). rewrite !whole_degrees. field.
Qed.

Lemma sine_is_cosine q : sin (Q2R q * PI / 180) = cosine (90 - q).
Proof.
  unfold cosine. rewrite Q2R_minus. change 90%Q with (inject_Z 90). rewrite whole_degrees, <- cos_shift. f_equal. field.
Qed.
