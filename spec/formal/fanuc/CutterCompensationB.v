(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/cutter-compensation-b: the vector at the end of a block, its length and side, and the arcs of the tool.

    Everything lies in the plane of the first two coordinates. [u] is the direction of a block (its travel, or I J), of any
    length; [rho] the offset value with its side: positive to the left; [o] the centre of an arc, [sigma] 1 for G03 and
    -1 for G02. *)
From Coq Require Import Reals Lra Psatz.
From Toolcomp Require Import Vectors.
Open Scope R_scope.

(** * Definitions *)

Definition planar u := vz u = 0.

(** The left normal of a direction. *)
Definition left u := Vec (- vy u) (vx u) 0.

(** The turn from [u] to [v]: positive to the left. *)
Definition turn u v := vx u * vy v - vy u * vx v.

(** The offset with its side, of a code and a value. *)
Inductive code := G41 | G42.
Definition side_offset c d := match c with G41 => d | G42 => - d end.

(** The vector at the end of a straight block, and of G39. *)
Definition V rho u := scale (rho / norm u) (left u).

(** The vector at the end [q] of an arc about [o]: on the line of centre and end. *)
Definition arc_V sigma rho o q := scale (- (sigma * rho) / norm (sub q o)) (sub q o).

(** The tangent of that arc at [q], of the length of the radius. *)
Definition arc_tangent sigma o q := scale sigma (left (sub q o)).

(** The distance of the tool from the centre at a point [q] with the vector [w]. *)
Definition head_radius o q w := norm (sub (add q w) o).

Definition mirror u := Vec (vx u) (- vy u) (vz u).

(** * Basic facts *)

Ltac coordinates :=
  repeat match goal with u : vec |- _ => destruct u end;
  unfold planar, left, turn, mirror, sub, opp, add, scale, dot, zero in *; cbn [vx vy vz] in *.

Lemma norm_of_square u l : 0 <= l -> dot u u = l * l -> norm u = l.
Proof. intros P H; unfold norm; rewrite H; apply sqrt_square, P. Qed.

Lemma norm_left u : planar u -> norm (left u) = norm u.
Proof. unfold norm; intro H; f_equal. coordinates; subst; ring. Qed.

Lemma left_left u : planar u -> left (left u) = opp u.
Proof. coordinates; intro; subst; f_equal; ring. Qed.

Lemma left_scale k u : left (scale k u) = scale k (left u).
Proof. coordinates; f_equal; ring. Qed.

Lemma planar_sub u v : planar u -> planar v -> planar (sub u v).
Proof. coordinates; intros; subst; ring. Qed.

Lemma not_zero_x u : vx u <> 0 -> u <> zero.
Proof. intros H E; apply H; rewrite E; reflexivity. Qed.

Lemma not_zero_y u : vy u <> 0 -> u <> zero.
Proof. intros H E; apply H; rewrite E; reflexivity. Qed.

(** * Straight blocks *)

(** fanuc.cutter-b.vector: the vector is at right angles to the direction. *)
Theorem V_perpendicular rho u : dot (V rho u) u = 0.
Proof. unfold V; rewrite dot_scale_l. replace (dot (left u) u) with 0 by (coordinates; ring). ring. Qed.

Example V_perpendicular_instance : dot (V 10 (Vec 30 40 0)) (Vec 30 40 0) = 0.
Proof. apply V_perpendicular. Qed.

(** fanuc.cutter-b.vector: the vector is as long as the offset value, whatever its sign. *)
Theorem V_length rho u : planar u -> u <> zero -> norm (V rho u) = Rabs rho.
Proof.
  intros Z H. pose proof (norm_pos u H) as P. unfold V. rewrite norm_scale, norm_left by auto.
  unfold Rdiv. rewrite Rabs_mult, (Rabs_right (/ norm u)) by (left; apply Rinv_0_lt_compat; auto).
  field; lra.
Qed.

Example V_length_instance : norm (V (-10) (Vec 30 40 0)) = 10.
Proof. rewrite V_length; [rewrite Rabs_left; lra | reflexivity | apply not_zero_x; cbn; lra]. Qed.

Lemma norm_30_40 : norm (Vec 30 40 0) = 50.
Proof. apply norm_of_square; [lra |]. unfold dot; cbn; lra. Qed.

(** fanuc.cutter-b.vector: a positive offset lies to the left of the direction, a negative one to the right. *)
Theorem V_side rho u : planar u -> u <> zero -> turn u (V rho u) = rho * norm u.
Proof.
  intros Z H. pose proof (norm_pos u H) as P.
  replace (turn u (V rho u)) with (rho / norm u * dot u u) by (unfold V; coordinates; subst; ring).
  rewrite <- norm_sqr. field; lra.
Qed.

(** G41 X30 Y40 with 10: (-8, 6), on the left. *)
Example V_side_instance : V 10 (Vec 30 40 0) = Vec (-8) 6 0 /\ 0 < turn (Vec 30 40 0) (V 10 (Vec 30 40 0)).
Proof.
  split.
  - unfold V; rewrite norm_30_40. unfold scale, left; cbn; f_equal; lra.
  - rewrite V_side, norm_30_40; [lra | reflexivity | apply not_zero_x; cbn; lra].
Qed.

(** fanuc.cutter.side: a negative value exchanges G41 and G42. *)
Theorem negative_value_exchanges_sides d u : V (side_offset G41 (- d)) u = V (side_offset G42 d) u.
Proof. reflexivity. Qed.

Example negative_value_exchanges_sides_instance : V (side_offset G41 (- (10))) (Vec 30 40 0) = Vec 8 (-6) 0.
Proof.
  rewrite negative_value_exchanges_sides. unfold V; rewrite norm_30_40. unfold scale, left; cbn; f_equal; lra.
Qed.

(** fanuc.cutter-b.direction-words: of I J the direction counts alone, not the length. *)
Theorem V_direction_only rho k u : 0 < k -> u <> zero -> V rho (scale k u) = V rho u.
Proof.
  intros K H. pose proof (norm_pos u H) as P. unfold V. rewrite norm_scale, (Rabs_right k), left_scale, scale_scale by lra.
  f_equal. field; split; lra.
Qed.

(** N1 of the manual's program: J1 is as good as J50. *)
Example V_direction_only_instance : V 5 (scale 50 (Vec 0 1 0)) = Vec (-5) 0 0.
Proof.
  rewrite V_direction_only; [| lra | apply not_zero_y; cbn; lra].
  assert (N : norm (Vec 0 1 0) = 1) by (apply norm_of_square; [lra | unfold dot; cbn; lra]).
  unfold V; rewrite N. unfold scale, left; cbn; f_equal; lra.
Qed.

(** fanuc.cutter-b.head-to-head: a straight block may be split: the second part ends with the vector of the first. *)
Theorem split_changes_nothing rho u k l : 0 < k -> 0 < l -> u <> zero -> V rho (scale k u) = V rho (scale l u).
Proof. intros K L H; rewrite !V_direction_only; auto. Qed.

Example split_changes_nothing_instance : V 10 (scale 1 (Vec 3 4 0)) = V 10 (scale 7 (Vec 3 4 0)).
Proof. apply split_changes_nothing; [lra | lra | apply not_zero_x; cbn; lra]. Qed.

(** fanuc.cutter-b.number-zero: with the value 0 there is no vector. *)
Theorem V_of_zero u : V 0 u = zero.
Proof. unfold V, Rdiv; rewrite Rmult_0_l; apply scale_zero_l. Qed.

Example V_of_zero_instance : V 0 (Vec 30 40 0) = zero.
Proof. apply V_of_zero. Qed.

(** fanuc.cutter-b.vector: mirrored, with the other side, a block has the mirrored vector. *)
Theorem mirrored_block rho u : V (- rho) (mirror u) = mirror (V rho u).
Proof.
  assert (N : norm (mirror u) = norm u) by (unfold norm; f_equal; coordinates; ring).
  unfold V; rewrite N. coordinates; f_equal; unfold Rdiv; ring.
Qed.

Example mirrored_block_instance : V (- (10)) (Vec 30 (- (40)) 0) = Vec (-8) (- (6)) 0.
Proof.
  transitivity (mirror (V 10 (Vec 30 40 0))).
  - exact (mirrored_block 10 (Vec 30 40 0)).
  - destruct V_side_instance as [E _]; rewrite E; reflexivity.
Qed.

(** * Arcs *)

(** fanuc.cutter-b.arc-vector: the vector of an arc is at right angles to its tangent, on the side of the code. *)
Theorem arc_V_is_V_of_tangent sigma rho o q : sigma = 1 \/ sigma = -1 -> planar q -> planar o -> q <> o ->
  arc_V sigma rho o q = V rho (arc_tangent sigma o q).
Proof.
  intros S Q O H. pose proof (planar_sub q o Q O) as P.
  assert (N : norm (arc_tangent sigma o q) = norm (sub q o)).
  { unfold arc_tangent; rewrite norm_scale, norm_left by auto.
    replace (Rabs sigma) with 1 by (destruct S; subst; [rewrite Rabs_right | rewrite Rabs_left]; lra). ring. }
  unfold V; rewrite N. unfold arc_V, arc_tangent. rewrite left_scale, left_left by auto.
  unfold opp; rewrite !scale_scale. f_equal; unfold Rdiv; ring.
Qed.

(** The end of a quarter circle G02 from (0, 20) to (20, 0) about the origin, G41 with 5: the tool outside, at (25, 0). *)
Example arc_V_is_V_of_tangent_instance :
  V 5 (arc_tangent (-1) (Vec 0 0 0) (Vec 20 0 0)) = Vec 5 0 0.
Proof.
  rewrite <- arc_V_is_V_of_tangent; try reflexivity; try (right; lra).
  - unfold arc_V. replace (norm (sub (Vec 20 0 0) (Vec 0 0 0))) with 20
      by (symmetry; apply norm_of_square; [lra | unfold dot; cbn; lra]).
    unfold scale, sub, opp, add; cbn; f_equal; lra.
  - intro E; injection E; lra.
Qed.

Lemma head_along k o q : sub (add q (scale k (sub q o))) o = scale (1 + k) (sub q o).
Proof. coordinates; f_equal; ring. Qed.

(** fanuc.cutter-b.arc-vector: at the end of an arc the tool is at R - sigma rho from the centre. *)
Theorem arc_head_radius sigma rho o q : q <> o -> sigma * rho <= norm (sub q o) ->
  head_radius o q (arc_V sigma rho o q) = norm (sub q o) - sigma * rho.
Proof.
  intros H L. assert (N : sub q o <> zero).
  { intro E; apply H. apply vec_eq; [apply (f_equal vx) in E | apply (f_equal vy) in E | apply (f_equal vz) in E];
      unfold sub, opp, add, scale, zero in E; cbn in E; lra. }
  pose proof (norm_pos _ N) as P. unfold head_radius, arc_V. rewrite head_along, norm_scale.
  set (R := norm (sub q o)) in *.
  assert (E : 1 + - (sigma * rho) / R = (R - sigma * rho) / R) by (field; lra).
  rewrite E, Rabs_right.
  - field; lra.
  - apply Rle_ge, Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat; auto].
Qed.

(** N7 of the manual's program, G02 of R40 under G41 with 5: the tool goes on a radius of 45. *)
Example arc_head_radius_instance :
  head_radius (Vec 60 40 0) (Vec 100 40 0) (arc_V (-1) 5 (Vec 60 40 0) (Vec 100 40 0)) = 45.
Proof.
  assert (N : norm (sub (Vec 100 40 0) (Vec 60 40 0)) = 40).
  { apply norm_of_square; [lra | unfold dot; cbn; lra]. }
  rewrite arc_head_radius, N; [lra | intro E; injection E; lra | rewrite N; lra].
Qed.

(** fanuc.cutter-b.arc-radii: where the block before joins in a tangent the tool's arc has one radius. *)
Theorem tangent_join_has_one_radius sigma rho o p q u k : sigma = 1 \/ sigma = -1 ->
  planar p -> planar q -> planar o -> p <> o -> q <> o -> norm (sub p o) = norm (sub q o) ->
  sigma * rho <= norm (sub q o) -> 0 < k -> u = scale k (arc_tangent sigma o p) ->
  head_radius o p (V rho u) = head_radius o q (arc_V sigma rho o q).
Proof.
  intros S Pp Pq Po Hp Hq E L K U.
  assert (T : arc_tangent sigma o p <> zero).
  { intro Z. apply Hp. unfold arc_tangent, left, sub, opp, add, scale, zero in Z; cbn in Z.
    injection Z; intros _ B C. unfold planar in *. apply vec_eq; destruct S; subst; lra. }
  subst u. rewrite V_direction_only, <- arc_V_is_V_of_tangent by auto.
  rewrite !arc_head_radius by (rewrite ?E; auto). rewrite E; reflexivity.
Qed.

(** Along X to the origin, then a quarter circle G02 about (0, -40): with 5 on the left both ends are at 45. *)
Example tangent_join_has_one_radius_instance :
  head_radius (Vec 0 (-40) 0) (Vec 0 0 0) (V 5 (Vec 40 0 0)) =
  head_radius (Vec 0 (-40) 0) (Vec 40 (-40) 0) (arc_V (-1) 5 (Vec 0 (-40) 0) (Vec 40 (-40) 0)).
Proof.
  assert (M : norm (sub (Vec 0 0 0) (Vec 0 (-40) 0)) = 40) by (apply norm_of_square; [lra | unfold dot; cbn; lra]).
  assert (N : norm (sub (Vec 40 (-40) 0) (Vec 0 (-40) 0)) = 40)
    by (apply norm_of_square; [lra | unfold dot; cbn; lra]).
  apply (tangent_join_has_one_radius (-1) 5 (Vec 0 (-40) 0) (Vec 0 0 0) (Vec 40 (-40) 0) (Vec 40 0 0) 1);
    try reflexivity; try (right; lra); try lra.
  - intro E; injection E; lra.
  - intro E; injection E; lra.
  - unfold arc_tangent, left, scale, sub, opp, add; cbn; f_equal; lra.
Qed.

(** * G39 *)

(** fanuc.cutter-b.corner-arc: with one value G39 goes on an arc of one radius, the offset value, about the corner. *)
Theorem corner_arc_has_one_radius rho u v : planar u -> u <> zero -> planar v -> v <> zero ->
  norm (V rho u) = norm (V rho v).
Proof. intros; rewrite !V_length; auto. Qed.

Example corner_arc_has_one_radius_instance : norm (V 5 (Vec 0 40 0)) = norm (V 5 (Vec 40 20 0)).
Proof.
  apply corner_arc_has_one_radius; try reflexivity; [apply not_zero_y | apply not_zero_x]; cbn; lra.
Qed.

(** fanuc.cutter-b.corner-arc-sense: the tool turns about the corner as the path does. *)
Theorem corner_arc_turns_with_the_path rho u v : planar u -> planar v -> u <> zero -> v <> zero ->
  turn (V rho u) (V rho v) = rho² / (norm u * norm v) * turn u v.
Proof.
  intros Zu Zv U W. pose proof (norm_pos u U) as P. pose proof (norm_pos v W) as Q.
  transitivity (rho / norm u * (rho / norm v) * turn u v).
  - unfold V; set (a := rho / norm u); set (b := rho / norm v). coordinates; ring.
  - unfold Rsqr; field; lra.
Qed.

(** So G41 at an outer corner (a turn to the right) makes the short arc clockwise: from +Y to +X. *)
Example corner_arc_turns_with_the_path_instance : turn (V 5 (Vec 0 40 0)) (V 5 (Vec 40 0 0)) < 0.
Proof.
  rewrite corner_arc_turns_with_the_path; try reflexivity;
    [| apply not_zero_y; cbn; lra | apply not_zero_x; cbn; lra].
  assert (A : norm (Vec 0 40 0) = 40) by (apply norm_of_square; [lra | unfold dot; cbn; lra]).
  assert (B : norm (Vec 40 0 0) = 40) by (apply norm_of_square; [lra | unfold dot; cbn; lra]).
  rewrite A, B. unfold turn, Rsqr; cbn; lra.
Qed.
