(* SPDX-License-Identifier: Apache-2.0 *)
(* The vector of the leading edge offset. Gappa bounds components in intervals and does not know that those of a unit
   vector are never at their largest together; so whole vectors are bounded here, by hand.

# code: fast/fanuc/leading_edge_offset/compensation_vector.h
#   const Vector3<double> c = cross(way, tool);
#   if (4 * c2 >= square) [[likely]]
#   lean.backward = cross(c, tool);
#   lean.norm = std::sqrt(dot(lean.backward, lean.backward));
# code: fast/fanuc/leading_edge_offset/leading_edge_offset.h
#   vector_ = lean.backward * (backward_ * radius / lean.norm);
# code: fast/kinematics/direction.h
#   const double norm = std::sqrt(vx * vx + vy * vy + vz * vz);
#   const DoublePair xy = DoublePair{vx, vy} / norm;
#   direction.unit[2] = vz / norm;
#
# ranges: a movement that doubles hold exactly, the sine of its angle to the tool at least 0.4901 (the engine asks for
#   1/2, by doubles; below it takes more digits); a tool direction by words. `backward_`, a sign, goes through every
#   rounding. The squares of a length may be added in either order: the last may as well be the first.
# u = 2^-53, s the sine of the angle between movement and tool, so 1/s the condition of the policy.
# proves: the vector, as a whole, is off by at most 12.65 u/s times its length (leading_edge_by_words). With a direction
#   that is off by e: (10.5 u + 2.1 e)/s (leading_edge).
# bound: 203b-57
# refuted: 32b-57
# facts: lemmas of RoundedVectors.v
*)
From Coq Require Import Reals Lra Psatz.
Require Import RoundedVectors.
Open Scope R_scope.

(* The vector of the leading edge before it is given its length: m the movement, V a vector along the tool, v the tool
   direction as the engine has it. *)
Lemma backward_error m V v e :
  0 < norm m -> Rabs (norm V - 1) <= / 2 ^ 40 -> 0 <= e <= / 2 ^ 45 -> norm (sub v V) <= e ->
  0.49 * norm m <= norm (cross m V) ->
  norm (sub (rcross (rcross m v) v) (cross (cross m V) V)) <=
    (1.42 * u + 1.01 * e) * norm m + (3.45 * u + 1.01 * e) * norm (cross m V).
Proof.
  intros Hm HV He Hv HS.
  assert (Pu := u_positive).
  set (c := rcross m v). set (C := cross m V).
  assert (Nv : norm v <= 1 + / 2 ^ 39).
  { replace v with (add V (sub v V)) by (destruct v; unfold add, sub; simpl; f_equal; ring).
    eapply Rle_trans; [apply triangle |]. split_Rabs; lra. }
  assert (Pv := norm_nonneg v).
  (* the first product *)
  assert (D : norm (cross m (sub v V)) <= norm m * e).
  { eapply Rle_trans; [apply cross_at_most |]. apply Rmult_le_compat_l; lra. }
  assert (E1 : norm (sub c C) <= (1.4145 * u + 1.0001 * e) * norm m + u * norm C).
  { replace (sub c C) with (add (sub c (cross m v)) (cross m (sub v V))).
    2: { unfold c, C, add, sub, cross, rcross. simpl. f_equal; ring. }
    eapply Rle_trans; [apply triangle |].
    assert (F := rcross_error m v). fold c in F.
    assert (G : norm (cross m v) <= norm C + norm m * e).
    { replace (cross m v) with (add C (cross m (sub v V))).
      2: { unfold C, add, sub, cross. simpl. f_equal; ring. }
      eapply Rle_trans; [apply triangle |]. lra. }
    assert (K : norm m * norm v <= norm m * (1 + / 2 ^ 39)) by (apply Rmult_le_compat_l; lra).
    revert D F G K. generalize (norm (sub c (cross m v))) (norm (cross m (sub v V))) (norm (cross m v)) (norm m * norm
      v).
    intros a b d g D F G K.
    assert (u * d <= u * (norm C + norm m * e)) by (apply Rmult_le_compat_l; lra).
    assert (u * g <= u * (norm m * (1 + / 2 ^ 39))) by (apply Rmult_le_compat_l; lra).
    assert (u * (norm m * e) <= / 2 ^ 53 * (norm m * e)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos; lra | lra]).
    assert (0 <= norm m * e) by (apply Rmult_le_pos; lra).
    assert (0 <= u * norm m) by (apply Rmult_le_pos; lra).
    lra. }
  assert (PC := norm_nonneg C). fold C in HS.
  assert (Dc : norm (sub c C) <= / 2 ^ 40 * norm C).
  { eapply Rle_trans; [exact E1 |].
    assert ((1.4145 * u + 1.0001 * e) * norm m <= (1.4145 * u + 1.0001 * e) * (2.05 * norm C)) by (apply
      Rmult_le_compat_l; lra).
    assert (u * norm C <= / 2 ^ 53 * norm C) by (apply Rmult_le_compat_r; lra).
    assert (e * norm C <= / 2 ^ 45 * norm C) by (apply Rmult_le_compat_r; lra).
    lra. }
  (* the second *)
  replace (sub (rcross c v) (cross C V)) with
    (add (sub (rcross c v) (cross c v)) (add (cross (sub c C) v) (cross C (sub v V)))).
  2: { unfold add, sub, cross. simpl. f_equal; ring. }
  eapply Rle_trans; [apply triangle |].
  assert (T := triangle (cross (sub c C) v) (cross C (sub v V))).
  assert (A1 := cross_at_most (sub c C) v). assert (A2 := cross_at_most C (sub v V)).
  assert (A3 := rcross_error c v). assert (A4 := cross_at_most c v).
  assert (Nc : norm c <= (1 + / 2 ^ 40) * norm C).
  { replace (norm c) with (norm (add C (sub c C))).
    - eapply Rle_trans; [apply triangle |]. lra.
    - f_equal. unfold C, c, add, sub, cross, rcross. simpl. f_equal; ring. }
  assert (Pc := norm_nonneg c). assert (Pd := norm_nonneg (sub c C)).
  assert (B1 : norm (sub c C) * norm v <= norm (sub c C) * (1 + / 2 ^ 39)) by (apply Rmult_le_compat_l; lra).
  assert (B2 : norm C * norm (sub v V) <= norm C * e) by (apply Rmult_le_compat_l; lra).
  assert (B3 : norm c * norm v <= (1 + / 2 ^ 40) * norm C * (1 + / 2 ^ 39)) by (apply Rmult_le_compat; lra).
  revert T A1 A2 A3 A4 B1 B2 B3 E1. 
  generalize (norm (add (cross (sub c C) v) (cross C (sub v V)))) (norm (cross (sub c C) v)) (norm (cross C (sub v V)))
    (norm (sub (rcross c v) (cross c v))) (norm (cross c v)) (norm c * norm v) (norm (sub c C) * norm v) (norm C *
      norm (sub v V)).
  revert Dc. generalize (norm (sub c C)). intros d Dc t a b f g h i j T A1 A2 A3 A4 B1 B2 B3 E1.
  assert (u * g <= u * h) by (apply Rmult_le_compat_l; lra).
  assert (u * h <= u * ((1 + / 2 ^ 40) * norm C * (1 + / 2 ^ 39))) by (apply Rmult_le_compat_l; lra).
  assert (0 <= u * norm C) by (apply Rmult_le_pos; lra).
  assert (0 <= e * norm C) by (apply Rmult_le_pos; lra).
  assert (0 <= u * norm m) by (apply Rmult_le_pos; lra).
  assert (0 <= e * norm m) by (apply Rmult_le_pos; lra).
  lra.
Qed.

(* The vector as the engine computes it: m the movement, v the tool direction, R the offset. *)
Definition edge_vector m v (offset : R) :=
  let b := rcross (rcross m v) v in rscale (rnd (rnd offset / rnorm b)) b.
(* (m x V) x V, given the length of the offset. *)
Definition exact_edge_vector m V (offset : R) :=
  let b := cross (cross m V) V in scale (offset / norm b) b.

Lemma norm_of_backward m V : norm (cross (cross m V) V) = norm (cross m V) * norm V.
Proof.
  unfold norm at 1. replace (dot (cross (cross m V) V) (cross (cross m V) V)) with (dot (cross m V) (cross m V) * dot
    V V).
  - apply sqrt_mult_alt, dot_nonneg.
  - rewrite <- lagrange. replace (dot (cross m V) V) with 0 by (unfold dot, cross; simpl; ring). ring.
Qed.

Lemma leading_edge m V v e offset :
  0 < norm m -> Rabs (norm V - 1) <= / 2 ^ 40 -> 0 <= e <= / 2 ^ 45 -> norm (sub v V) <= e -> 0 < offset ->
  let s := norm (cross m V) / (norm m * norm V) in
  0.4901 <= s ->
  norm (sub (edge_vector m v offset) (exact_edge_vector m V offset)) <= (10.5 * u + 2.1 * e) / s * offset.
Proof.
  intros Hm HV He Hv Ho s Hs. assert (Pu := u_positive).
  assert (HVp : 0.999 <= norm V <= 1.001) by (split_Rabs; lra).
  assert (Mp : 0 < norm m * norm V) by (apply Rmult_lt_0_compat; lra).
  assert (ES : norm (cross m V) = s * (norm m * norm V)) by (unfold s; field; lra).
  assert (S1 : s <= 1).
  { apply Rmult_le_reg_r with (norm m * norm V); [exact Mp |]. rewrite <- ES. generalize (cross_at_most m V). lra. }
  assert (HC : 0.49 * norm m <= norm (cross m V)).
  { rewrite ES. assert (0.4901 * (norm m * norm V) <= s * (norm m * norm V)) by (apply Rmult_le_compat_r; lra).
    assert (norm m * (1 - / 2 ^ 40) <= norm m * norm V) by (apply Rmult_le_compat_l; [lra | split_Rabs; lra]). lra. }
  assert (H := backward_error m V v e Hm HV He Hv HC).
  unfold edge_vector, exact_edge_vector. set (b := rcross (rcross m v) v) in *. set (B := cross (cross m V) V) in *.
  assert (EB : norm B = norm (cross m V) * norm V) by apply norm_of_backward.
  set (C := norm (cross m V)) in *.
  assert (PC : 0 < C) by lra.
  assert (LB : (1 - / 2 ^ 40) * C <= norm B).
  { rewrite EB, Rmult_comm. apply Rmult_le_compat_l; [lra |]. split_Rabs; lra. }
  assert (PB : 0 < norm B) by lra.
  (* what the double product is off by, over its length *)
  assert (D : norm (sub b B) / norm B <= (1.43 * u + 1.02 * e) / s + 3.46 * u + 1.02 * e).
  { apply Rmult_le_reg_r with (norm B); [exact PB |]. unfold Rdiv at 1. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    eapply Rle_trans; [exact H |].
    assert (K : norm m <= 1.0001 * norm B / s).
    { apply Rmult_le_reg_r with s; [lra |]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
      assert (C = norm m * s * norm V) by lra.
      assert (norm m * s * (1 - / 2 ^ 40) <= norm m * s * norm V).
      { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | split_Rabs; lra]. }
      lra. }
    assert ((1.42 * u + 1.01 * e) * norm m <= (1.42 * u + 1.01 * e) * (1.0001 * norm B / s)) by (apply
      Rmult_le_compat_l; lra).
    assert (0 <= norm B / s) by (apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; lra]).
    assert (0 <= u * (norm B / s)) by (apply Rmult_le_pos; lra).
    assert (0 <= e * (norm B / s)) by (apply Rmult_le_pos; lra).
    assert (C <= 1.0001 * norm B) by lra.
    assert (u * C <= u * (1.0001 * norm B)) by (apply Rmult_le_compat_l; lra).
    assert (e * C <= e * (1.0001 * norm B)) by (apply Rmult_le_compat_l; lra).
    assert (0 <= u * norm B) by (apply Rmult_le_pos; lra).
    assert (0 <= e * norm B) by (apply Rmult_le_pos; lra).
    replace (((1.43 * u + 1.02 * e) / s + 3.46 * u + 1.02 * e) * norm B) with
      (1.43 * (u * (norm B / s)) + 1.02 * (e * (norm B / s)) + 3.46 * (u * norm B) + 1.02 * (e * norm B)) by (field;
        lra).
    replace ((1.42 * u + 1.01 * e) * (1.0001 * norm B / s)) with
      (1.42 * 1.0001 * (u * (norm B / s)) + 1.01 * 1.0001 * (e * (norm B / s))) in * by (field; lra).
    lra. }
  assert (Is : 0 < / s <= 2.05).
  { split; [apply Rinv_0_lt_compat; lra |]. apply Rmult_le_reg_r with s; [lra |]. rewrite Rinv_l; lra. }
  assert (Dt : norm (sub b B) / norm B <= / 2 ^ 38).
  { eapply Rle_trans; [exact D |]. unfold Rdiv.
    assert ((1.43 * u + 1.02 * e) * / s <= (1.43 * u + 1.02 * e) * 2.05) by (apply Rmult_le_compat_l; lra). lra. }
  assert (Lb : (1 - / 2 ^ 37) * norm B <= norm b).
  { assert (norm (sub b B) <= / 2 ^ 38 * norm B).
    { apply Rmult_le_reg_r with (/ norm B); [apply Rinv_0_lt_compat, PB |]. rewrite Rmult_assoc, Rinv_r by lra.
      unfold Rdiv in Dt. lra. }
    assert (T : norm B <= norm b + norm (sub b B)).
    { replace B with (add b (scale (-1) (sub b B))) at 1 by (destruct B; unfold add, scale, sub; simpl; f_equal; ring).
      eapply Rle_trans; [apply triangle |]. rewrite norm_scale, Rabs_left by lra. lra. }
    lra. }
  assert (Pb : 0 < norm b) by lra.
  assert (Q := directions_differ b B PB Lb).
  (* the factor *)
  set (n := rnorm b). set (f := rnd (rnd offset / n)).
  assert (Hn := rnorm_error b). fold n in Hn.
  assert (Pn : 0 < n) by (eapply Rlt_le_trans; [| apply (proj1 Hn)]; apply Rmult_lt_0_compat; lra).
  assert (Hr := rnd_between offset offset offset ltac:(lra) ltac:(lra)).
  set (r := rnd offset) in *.
  assert (G : (1 - 4.6 * u) * offset <= f * norm b <= (1 + 4.6 * u) * offset).
  { assert (G1 : (1 - 3.55 * u) * offset <= r / n * norm b <= (1 + 3.55 * u) * offset).
    { assert (E : r / n * norm b * n = r * norm b) by (field; lra).
      assert (0 <= offset * norm b) by (apply Rmult_le_pos; lra).
      split; apply Rmult_le_reg_r with n; try exact Pn; rewrite E.
      - apply Rle_trans with ((1 - 3.55 * u) * offset * ((1 + 2.51 * u) * norm b)).
        + apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra].
        + apply Rle_trans with ((1 - u) * offset * norm b); [| apply Rmult_le_compat_r; lra].
          replace ((1 - 3.55 * u) * offset * ((1 + 2.51 * u) * norm b)) with
            ((1 - 3.55 * u) * (1 + 2.51 * u) * (offset * norm b)) by ring.
          replace ((1 - u) * offset * norm b) with ((1 - u) * (offset * norm b)) by ring.
          apply Rmult_le_compat_r; [assumption |]. unfold u. lra.
      - apply Rle_trans with ((1 + 3.55 * u) * offset * ((1 - 2.51 * u) * norm b)).
        + apply Rle_trans with ((1 + u) * offset * norm b); [apply Rmult_le_compat_r; lra |].
          replace ((1 + 3.55 * u) * offset * ((1 - 2.51 * u) * norm b)) with
            ((1 + 3.55 * u) * (1 - 2.51 * u) * (offset * norm b)) by ring.
          replace ((1 + u) * offset * norm b) with ((1 + u) * (offset * norm b)) by ring.
          apply Rmult_le_compat_r; [assumption |]. unfold u. lra.
        + apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra]. }
    assert (Pr : 0 <= r / n) by (apply Rmult_le_pos; [nra | left; apply Rinv_0_lt_compat, Pn]).
    assert (F := rnd_between (r / n) (r / n) (r / n) ltac:(lra) ltac:(lra)). fold f in F.
    assert (F1 : (1 - u) * (r / n) * norm b <= f * norm b) by (apply Rmult_le_compat_r; lra).
    assert (F2 : f * norm b <= (1 + u) * (r / n) * norm b) by (apply Rmult_le_compat_r; lra).
    rewrite Rmult_assoc in F1, F2. revert G1 F1 F2. generalize (r / n * norm b) (f * norm b). intros p q G1 F1 F2.
    assert ((1 - u) * ((1 - 3.55 * u) * offset) <= (1 - u) * p) by (apply Rmult_le_compat_l; lra).
    assert ((1 + u) * p <= (1 + u) * ((1 + 3.55 * u) * offset)) by (apply Rmult_le_compat_l; lra).
    assert (u * (u * offset) <= / 2 ^ 53 * (u * offset)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos |]; lra).
    assert (0 <= u * offset) by (apply Rmult_le_pos; lra).
    assert (0 <= u * (u * offset)) by (apply Rmult_le_pos; lra).
    split; lra. }
  assert (Pf : 0 <= f).
  { apply Rmult_le_reg_r with (norm b); [exact Pb |]. rewrite Rmult_0_l. eapply Rle_trans; [| apply (proj1 G)].
    apply Rmult_le_pos; lra. }
  (* the three parts *)
  replace (sub (rscale f b) (scale (offset / norm B) B)) with
    (add (sub (rscale f b) (scale f b))
         (add (scale (f * norm b - offset) (scale (/ norm b) b))
              (scale offset (sub (scale (/ norm b) b) (scale (/ norm B) B))))).
  2: { unfold add, sub, scale, rscale. simpl. f_equal; field; lra. }
  eapply Rle_trans; [apply triangle |].
  assert (T := triangle (scale (f * norm b - offset) (scale (/ norm b) b))
    (scale offset (sub (scale (/ norm b) b) (scale (/ norm B) B)))).
  rewrite !norm_scale, (Rabs_right offset), (Rabs_right (/ norm b)) in T
    by (try lra; left; apply Rinv_0_lt_compat, Pb).
  rewrite Rinv_l, Rmult_1_r in T by lra.
  assert (P1 : norm (sub (rscale f b) (scale f b)) <= u * (f * norm b)).
  { replace (u * (f * norm b)) with (norm (scale u (magnitude (scale f b)))).
    - apply norm_within. unfold within, sub, rscale, scale, magnitude. simpl.
      repeat split; rewrite (Rmult_comm f); apply rnd_error.
    - rewrite norm_scale, norm_magnitude, norm_scale, !Rabs_right by lra. reflexivity. }
  assert (P2 : Rabs (f * norm b - offset) <= 4.6 * u * offset) by (split_Rabs; lra).
  assert (P3 : offset * norm (sub (scale (/ norm b) b) (scale (/ norm B) B)) <=
    offset * ((1 + / 2 ^ 36) * ((1.43 * u + 1.02 * e) / s + 3.46 * u + 1.02 * e))).
  { apply Rmult_le_compat_l; [lra |]. eapply Rle_trans; [exact Q |]. apply Rmult_le_compat_l; lra. }
  assert (P4 : u * (f * norm b) <= u * ((1 + 4.6 * u) * offset)) by (apply Rmult_le_compat_l; lra).
  assert (u * (u * offset) <= / 2 ^ 53 * (u * offset)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos |]; lra).
  assert (O1 : 0 <= u * offset) by (apply Rmult_le_pos; lra).
  assert (O2 : 0 <= e * offset) by (apply Rmult_le_pos; lra).
  assert (I1 : u * offset * 1 <= u * offset * / s).
  { apply Rmult_le_compat_l; [exact O1 |]. apply Rmult_le_reg_r with s; [lra |]. rewrite Rinv_l; lra. }
  assert (I2 : e * offset * 1 <= e * offset * / s).
  { apply Rmult_le_compat_l; [exact O2 |]. apply Rmult_le_reg_r with s; [lra |]. rewrite Rinv_l; lra. }
  unfold Rdiv in *.
  replace (offset * ((1 + / 2 ^ 36) * ((1.43 * u + 1.02 * e) * / s + 3.46 * u + 1.02 * e))) with
    ((1 + / 2 ^ 36) * (1.43 * (u * offset * / s) + 1.02 * (e * offset * / s) + 3.46 * (u * offset) + 1.02 * (e *
      offset)))
    in P3 by ring.
  replace ((10.5 * u + 2.1 * e) * / s * offset) with (10.5 * (u * offset * / s) + 2.1 * (e * offset * / s)) by ring.
  revert T P1 P2 P3 P4.
  generalize (norm (sub (rscale f b) (scale f b))) (Rabs (f * norm b - offset)) (f * norm b)
    (offset * norm (sub (scale (/ norm b) b) (scale (/ norm B) B))).
  intros p1 p2 g p3. revert I1 I2. generalize (u * offset * / s) (e * offset * / s). intros us es I1 I2 T P1 P2 P3 P4.
  lra.
Qed.

Lemma scaled_cross k a b : cross a (scale k b) = scale k (cross a b).
Proof. unfold cross, scale. simpl. f_equal; ring. Qed.
Lemma scaled_backward k m x :
  cross (cross m (scale k x)) (scale k x) = scale (k * k) (cross (cross m x) x).
Proof. unfold cross, scale. simpl. f_equal; ring. Qed.

(* How long the vector along the tool is does not matter. *)
Lemma exact_edge_vector_scaled k m x offset : 0 < k -> 0 < norm (cross (cross m x) x) ->
  exact_edge_vector m (scale k x) offset = exact_edge_vector m x offset.
Proof.
  intros Hk HB. unfold exact_edge_vector. rewrite scaled_backward, norm_scale, Rabs_right by nra.
  unfold scale. simpl. f_equal; field; split; nra.
Qed.

(* The direction by words, as the engine has it: quotients by the rounded length. *)
Definition direction_of x := V3 (rnd (X x / rnorm x)) (rnd (Y x / rnorm x)) (rnd (Z x / rnorm x)).

Lemma leading_edge_by_words m x offset : 0 < norm m -> 0 < norm x -> 0 < offset ->
  let s := norm (cross m x) / (norm m * norm x) in
  0.4901 <= s ->
  norm (sub (edge_vector m (direction_of x) offset) (exact_edge_vector m x offset)) <= 12.65 * u / s * offset.
Proof.
  intros Hm Hx Ho s Hs. assert (Pu := u_positive). assert (Hn := rnorm_error x). set (n := rnorm x) in *.
  assert (Pn : 0 < n) by (eapply Rlt_le_trans; [| apply (proj1 Hn)]; apply Rmult_lt_0_compat; lra).
  assert (In : 0 < / n) by (apply Rinv_0_lt_compat, Pn).
  set (V := scale (/ n) x).
  assert (NV : norm V = norm x / n) by (unfold V; rewrite norm_scale, Rabs_right by lra; unfold Rdiv; ring).
  assert (HV : Rabs (norm V - 1) <= / 2 ^ 40).
  { rewrite NV. replace (norm x / n - 1) with ((norm x - n) * / n) by (field; lra).
    rewrite Rabs_mult, (Rabs_right (/ n)) by lra. apply Rmult_le_reg_r with n; [exact Pn |].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (u * norm x <= / 2 ^ 53 * norm x) by (apply Rmult_le_compat_r; lra). split_Rabs; lra. }
  assert (Hv : norm (sub (direction_of x) V) <= u * norm V).
  { replace (u * norm V) with (norm (scale u (magnitude V))).
    - apply norm_within. unfold within, sub, direction_of, V, scale, magnitude. simpl. fold n.
      repeat split; rewrite (Rmult_comm (/ n)); apply rnd_error.
    - rewrite norm_scale, norm_magnitude, Rabs_right by lra. reflexivity. }
  assert (Nc : norm (cross m V) = / n * norm (cross m x))
    by (unfold V; rewrite scaled_cross, norm_scale, Rabs_right by lra; reflexivity).
  assert (Es : norm (cross m V) / (norm m * norm V) = s).
  { rewrite Nc, NV. unfold s. field. repeat split; lra. }
  assert (HB : 0 < norm (cross (cross m x) x)).
  { rewrite norm_of_backward. apply Rmult_lt_0_compat; [| exact Hx].
    replace (norm (cross m x)) with (s * (norm m * norm x)) by (unfold s; field; lra).
    apply Rmult_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]. }
  rewrite <- (exact_edge_vector_scaled (/ n) m x offset In HB). fold V.
  assert (HVe : u * norm V <= 1.01 * u) by (assert (norm V <= 1.01) by (split_Rabs; lra); nra).
  assert (He : 0 <= 1.01 * u <= / 2 ^ 45) by lra.
  assert (H := leading_edge m V (direction_of x) (1.01 * u) offset Hm HV He ltac:(lra) Ho). cbv zeta in H.
  rewrite Es in H. eapply Rle_trans; [exact (H Hs) |].
  apply Rmult_le_compat_r; [lra |]. unfold Rdiv. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; lra | lra].
Qed.
