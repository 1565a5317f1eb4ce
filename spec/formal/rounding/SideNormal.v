(* SPDX-License-Identifier: Apache-2.0 *)
(* The vector of tool side compensation at right angles to a line: by whole vectors, as in LeadingEdge.v.

# code: fast/fanuc/tool_side_compensation/tool_plane.h
#   seen.left = cross(unit(), travel.value);
#   seen.square = dot(seen.left, seen.left);
#   seen.norm = std::sqrt(seen.square);
#   seen.inverse = 1 / seen.norm;
#   turn.left1 = first.seen.left * first.seen.inverse;
# code: fast/fanuc/tool_side_compensation/side_corner.cpp
#   return n.left1 * n.rho1;
#
# ranges: a movement that doubles hold exactly, the sine of its angle to the tool at least 0.4901 (the engine asks for
#   1/2, by doubles; below it takes double-double); an offset that is not 0. Its sign goes through every rounding.
# u = 2^-53, s the sine of the angle between movement and tool, so 1/s the condition of the policy.
# proves: the vector, as a whole, is off by at most (9.1 u + 1.1 e)/s times its length, with a direction that is off by
#   e: 10.3 u/s by words (e = u, as in LeadingEdge.v), 34.1 u/s by rotary axes along X, Y, Z (13.2 u a component).
# bound: 165b-57
# refuted: 32b-57
# facts: lemmas of RoundedVectors.v
*)
From Coq Require Import Reals Lra Psatz.
Require Import RoundedVectors.
Open Scope R_scope.

Definition side_normal v travel (offset : R) :=
  let left := rcross v travel in rscale (rnd offset) (rscale (rnd (1 / rnorm left)) left).
Definition exact_side_normal V travel (offset : R) :=
  let left := cross V travel in scale (offset / norm left) left.

(* Multiplied twice by numbers that are not negative. *)
Lemma scaled_twice f r b : 0 <= f -> 0 <= r ->
  norm (sub (rscale r (rscale f b)) (scale (r * f) b)) <= 2.01 * u * (r * (f * norm b)).
Proof.
  intros Hf Hr. assert (Pu := u_positive). assert (Nb := norm_nonneg b).
  assert (Pfb : 0 <= f * norm b) by (apply Rmult_le_pos; assumption).
  set (p := rscale f b).
  assert (Q : forall g a, 0 <= g -> norm (sub (rscale g a) (scale g a)) <= u * (g * norm a)).
  { intros g a Hg. replace (u * (g * norm a)) with (norm (scale u (magnitude (scale g a)))).
    - apply norm_within. unfold within, sub, rscale, scale, magnitude. simpl.
      repeat split; rewrite (Rmult_comm g); apply rnd_error.
    - rewrite norm_scale, norm_magnitude, norm_scale, !Rabs_right by lra. reflexivity. }
  assert (E1 := Q f b Hf). fold p in E1. assert (E2 := Q r p Hr).
  assert (Np : norm p <= (1 + u) * (f * norm b)).
  { replace (norm p) with (norm (add (scale f b) (sub p (scale f b)))).
    - eapply Rle_trans; [apply triangle |]. rewrite norm_scale, Rabs_right by lra. lra.
    - f_equal. unfold p, add, sub, scale, rscale. simpl. f_equal; ring. }
  replace (sub (rscale r p) (scale (r * f) b)) with
    (add (sub (rscale r p) (scale r p)) (scale r (sub p (scale f b))))
    by (unfold p, add, sub, scale, rscale; simpl; f_equal; ring).
  eapply Rle_trans; [apply triangle |]. rewrite norm_scale, (Rabs_right r) by lra.
  assert (r * norm (sub p (scale f b)) <= r * (u * (f * norm b))) by (apply Rmult_le_compat_l; assumption).
  assert (u * (r * norm p) <= u * (r * ((1 + u) * (f * norm b)))).
  { apply Rmult_le_compat_l; [lra |]. apply Rmult_le_compat_l; assumption. }
  assert (Z0 : 0 <= r * (f * norm b)) by (apply Rmult_le_pos; assumption).
  assert (0 <= u * (r * (f * norm b))) by (apply Rmult_le_pos; lra).
  assert (u * (u * (r * (f * norm b))) <= / 2 ^ 53 * (u * (r * (f * norm b)))) by (apply Rmult_le_compat_r; lra).
  replace (u * (r * ((1 + u) * (f * norm b)))) with (u * (r * (f * norm b)) + u * (u * (r * (f * norm b)))) in * by
    ring.
  replace (r * (u * (f * norm b))) with (u * (r * (f * norm b))) in * by ring.
  lra.
Qed.

Lemma side_normal_error V v travel e offset :
  0 < norm travel -> Rabs (norm V - 1) <= / 2 ^ 40 -> 0 <= e <= / 2 ^ 45 -> norm (sub v V) <= e -> 0 < offset ->
  let s := norm (cross V travel) / (norm V * norm travel) in
  0.4901 <= s ->
  norm (sub (side_normal v travel offset) (exact_side_normal V travel offset)) <= (9.1 * u + 1.1 * e) / s * offset.
Proof.
  intros Hm HV He Hv Ho s Hs. assert (Pu := u_positive).
  assert (HVp : 1 - / 2 ^ 40 <= norm V <= 1 + / 2 ^ 40) by (split_Rabs; lra).
  assert (Mp : 0 < norm V * norm travel) by (apply Rmult_lt_0_compat; lra).
  unfold side_normal, exact_side_normal. set (b := rcross v travel). set (B := cross V travel) in *.
  assert (ES : norm B = s * (norm V * norm travel)) by (unfold s; field; lra).
  assert (S1 : s <= 1).
  { apply Rmult_le_reg_r with (norm V * norm travel); [exact Mp |]. rewrite <- ES. generalize (cross_at_most V travel).
    fold B. lra. }
  assert (Is : 0 < / s) by (apply Rinv_0_lt_compat; lra).
  assert (PB : 0 < norm B) by (rewrite ES; apply Rmult_lt_0_compat; lra).
  assert (Nv : norm v <= 1.0001).
  { replace v with (add V (sub v V)) by (destruct v; unfold add, sub; simpl; f_equal; ring).
    eapply Rle_trans; [apply triangle |]. lra. }
  (* the product, over the length of the movement and over its own *)
  assert (E : norm (sub b B) <= (1.415 * u + 1.0001 * e) * norm travel + u * norm B).
  { replace (sub b B) with (add (sub b (cross v travel)) (cross (sub v V) travel))
      by (unfold b, B, add, sub, cross, rcross; simpl; f_equal; ring).
    eapply Rle_trans; [apply triangle |].
    assert (F := rcross_error v travel). fold b in F.
    assert (A := cross_at_most (sub v V) travel).
    assert (A2 : norm (sub v V) * norm travel <= e * norm travel) by (apply Rmult_le_compat_r; lra).
    assert (G : norm (cross v travel) <= norm B + e * norm travel).
    { replace (cross v travel) with (add B (cross (sub v V) travel))
        by (unfold B, add, sub, cross; simpl; f_equal; ring).
      eapply Rle_trans; [apply triangle |]. lra. }
    assert (K : norm v * norm travel <= 1.0001 * norm travel) by (apply Rmult_le_compat_r; lra).
    assert (u * (norm v * norm travel) <= u * (1.0001 * norm travel)) by (apply Rmult_le_compat_l; lra).
    assert (u * norm (cross v travel) <= u * (norm B + e * norm travel)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= e * norm travel) by (apply Rmult_le_pos; lra).
    assert (u * (e * norm travel) <= / 2 ^ 53 * (e * norm travel)) by (apply Rmult_le_compat_r; lra).
    assert (0 <= u * norm travel) by (apply Rmult_le_pos; lra).
    lra. }
  assert (K : norm travel <= 1.0001 * norm B / s).
  { apply Rmult_le_reg_r with s; [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra. rewrite ES.
    assert (P : 0 <= s * norm travel) by (apply Rmult_le_pos; lra).
    assert (s * norm travel * (1 - / 2 ^ 40) <= s * norm travel * norm V) by (apply Rmult_le_compat_l; lra).
    lra. }
  assert (D : norm (sub b B) / norm B <= (1.42 * u + 1.01 * e) / s + u).
  { apply Rmult_le_reg_r with (norm B); [exact PB |]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    eapply Rle_trans; [exact E |].
    assert (H : (1.415 * u + 1.0001 * e) * norm travel <= (1.415 * u + 1.0001 * e) * (1.0001 * norm B / s))
      by (apply Rmult_le_compat_l; lra).
    assert (0 <= norm B * / s) by (apply Rmult_le_pos; lra).
    assert (0 <= u * (norm B * / s)) by (apply Rmult_le_pos; lra).
    assert (0 <= e * (norm B * / s)) by (apply Rmult_le_pos; lra).
    unfold Rdiv in *.
    replace (((1.42 * u + 1.01 * e) * / s + u) * norm B) with
      (1.42 * (u * (norm B * / s)) + 1.01 * (e * (norm B * / s)) + u * norm B) by ring.
    replace ((1.415 * u + 1.0001 * e) * (1.0001 * norm B * / s)) with
      (1.415 * 1.0001 * (u * (norm B * / s)) + 1.0001 * 1.0001 * (e * (norm B * / s))) in H by ring.
    lra. }
  assert (Dt : norm (sub b B) / norm B <= / 2 ^ 38).
  { eapply Rle_trans; [exact D |]. unfold Rdiv.
    assert (/ s <= 2.05) by (apply Rmult_le_reg_r with s; [lra |]; rewrite Rinv_l; lra).
    assert ((1.42 * u + 1.01 * e) * / s <= (1.42 * u + 1.01 * e) * 2.05) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Lb : (1 - / 2 ^ 37) * norm B <= norm b).
  { assert (norm (sub b B) <= / 2 ^ 38 * norm B).
    { apply Rmult_le_reg_r with (/ norm B); [apply Rinv_0_lt_compat, PB |]. rewrite Rmult_assoc, Rinv_r by lra.
      unfold Rdiv in Dt. lra. }
    assert (T : norm B <= norm b + norm (sub b B)).
    { replace (norm B) with (norm (add b (scale (-1) (sub b B)))).
      - eapply Rle_trans; [apply triangle |]. rewrite norm_scale, Rabs_left by lra. lra.
      - f_equal. destruct B. unfold add, scale, sub. simpl. f_equal; ring. }
    lra. }
  assert (Pb : 0 < norm b) by lra.
  assert (Q := directions_differ b B PB Lb).
  (* the factor *)
  assert (Hn := rnorm_error b). set (n := rnorm b) in *.
  assert (Pn : 0 < n) by (eapply Rlt_le_trans; [| apply (proj1 Hn)]; apply Rmult_lt_0_compat; lra).
  assert (In : 0 < 1 / n) by (unfold Rdiv; rewrite Rmult_1_l; apply Rinv_0_lt_compat, Pn).
  assert (F := rnd_between (1 / n) (1 / n) (1 / n) ltac:(lra) ltac:(lra)). set (f := rnd (1 / n)) in *.
  assert (Hr := rnd_between offset offset offset ltac:(lra) ltac:(lra)). set (r := rnd offset) in *.
  assert (G1 : 1 - 2.52 * u <= 1 / n * norm b <= 1 + 2.52 * u).
  { assert (E0 : 1 / n * norm b * n = norm b) by (field; lra).
    split; apply Rmult_le_reg_r with n; try exact Pn; rewrite E0.
    - apply Rle_trans with ((1 - 2.52 * u) * ((1 + 2.51 * u) * norm b)); [apply Rmult_le_compat_l; lra |].
      rewrite <- Rmult_assoc. rewrite <- (Rmult_1_l (norm b)) at 2. apply Rmult_le_compat_r; [lra |]. unfold u. lra.
    - apply Rle_trans with ((1 + 2.52 * u) * ((1 - 2.51 * u) * norm b)); [| apply Rmult_le_compat_l; lra].
      rewrite <- Rmult_assoc. rewrite <- (Rmult_1_l (norm b)) at 1. apply Rmult_le_compat_r; [lra |]. unfold u. lra. }
  assert (G2 : 1 - 3.53 * u <= f * norm b <= 1 + 3.53 * u).
  { assert (F1 : (1 - u) * (1 / n) * norm b <= f * norm b) by (apply Rmult_le_compat_r; lra).
    assert (F2 : f * norm b <= (1 + u) * (1 / n) * norm b) by (apply Rmult_le_compat_r; lra).
    rewrite Rmult_assoc in F1, F2. revert G1 F1 F2. generalize (1 / n * norm b) (f * norm b). intros p q G1 F1 F2.
    assert ((1 - u) * (1 - 2.52 * u) <= (1 - u) * p) by (apply Rmult_le_compat_l; lra).
    assert ((1 + u) * p <= (1 + u) * (1 + 2.52 * u)) by (apply Rmult_le_compat_l; lra).
    assert (u * u <= / 2 ^ 53 * u) by (apply Rmult_le_compat_r; lra). assert (0 <= u * u) by nra.
    split; lra. }
  assert (Pf : 0 <= f) by (assert (0 <= (1 - u) * (1 / n)) by (apply Rmult_le_pos; lra); lra).
  assert (Pr : 0 <= r) by (assert (0 <= (1 - u) * offset) by (apply Rmult_le_pos; lra); lra).
  assert (G : (1 - 4.54 * u) * offset <= r * (f * norm b) <= (1 + 4.54 * u) * offset).
  { revert G2. generalize (f * norm b). intros q G2.
    assert (A1 : (1 - u) * offset * (1 - 3.53 * u) <= r * q) by (apply Rmult_le_compat; [apply Rmult_le_pos | | |];
      lra).
    assert (A2 : r * q <= (1 + u) * offset * (1 + 3.53 * u)) by (apply Rmult_le_compat; lra).
    assert (u * (u * offset) <= / 2 ^ 53 * (u * offset)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos |]; lra).
    assert (0 <= u * offset) by (apply Rmult_le_pos; lra).
    assert (0 <= u * (u * offset)) by (apply Rmult_le_pos; lra).
    split; lra. }
  (* the three parts *)
  replace (sub (rscale r (rscale f b)) (scale (offset / norm B) B)) with
    (add (sub (rscale r (rscale f b)) (scale (r * f) b))
         (add (scale (r * (f * norm b) - offset) (scale (/ norm b) b))
              (scale offset (sub (scale (/ norm b) b) (scale (/ norm B) B))))).
  2: { unfold add, sub, scale, rscale. simpl. f_equal; field; lra. }
  eapply Rle_trans; [apply triangle |].
  assert (T := triangle (scale (r * (f * norm b) - offset) (scale (/ norm b) b))
    (scale offset (sub (scale (/ norm b) b) (scale (/ norm B) B)))).
  rewrite !norm_scale, (Rabs_right offset), (Rabs_right (/ norm b)) in T
    by (try lra; left; apply Rinv_0_lt_compat, Pb).
  rewrite Rinv_l, Rmult_1_r in T by lra.
  assert (P1 := scaled_twice f r b Pf Pr).
  assert (P2 : Rabs (r * (f * norm b) - offset) <= 4.54 * u * offset) by (split_Rabs; lra).
  assert (P3 : offset * norm (sub (scale (/ norm b) b) (scale (/ norm B) B)) <=
    offset * ((1 + / 2 ^ 36) * ((1.42 * u + 1.01 * e) / s + u))).
  { apply Rmult_le_compat_l; [lra |]. eapply Rle_trans; [exact Q |]. apply Rmult_le_compat_l; lra. }
  assert (P4 : 2.01 * u * (r * (f * norm b)) <= 2.01 * u * ((1 + 4.54 * u) * offset)) by (apply Rmult_le_compat_l; lra).
  assert (u * (u * offset) <= / 2 ^ 53 * (u * offset)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos |]; lra).
  assert (O1 : 0 <= u * offset) by (apply Rmult_le_pos; lra).
  assert (O2 : 0 <= e * offset * / s) by (apply Rmult_le_pos; [apply Rmult_le_pos |]; lra).
  assert (I1 : u * offset * 1 <= u * offset * / s).
  { apply Rmult_le_compat_l; [exact O1 |]. apply Rmult_le_reg_r with s; [lra |]. rewrite Rinv_l; lra. }
  unfold Rdiv in *.
  replace (offset * ((1 + / 2 ^ 36) * ((1.42 * u + 1.01 * e) * / s + u))) with
    ((1 + / 2 ^ 36) * (1.42 * (u * offset * / s) + 1.01 * (e * offset * / s) + u * offset)) in P3 by ring.
  replace ((9.1 * u + 1.1 * e) * / s * offset) with (9.1 * (u * offset * / s) + 1.1 * (e * offset * / s)) by ring.
  revert T P1 P2 P3 P4.
  generalize (norm (sub (rscale r (rscale f b)) (scale (r * f) b))) (Rabs (r * (f * norm b) - offset)) (r * (f * norm
    b))
    (offset * norm (sub (scale (/ norm b) b) (scale (/ norm B) B))).
  intros p1 p2 g p3. revert I1 O2. generalize (u * offset * / s) (e * offset * / s). intros us es I1 O2 T P1 P2 P3 P4.
  lra.
Qed.
