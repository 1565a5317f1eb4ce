(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/cutter-compensation-c: the vectors at a corner, and why they are the right ones.

    Everything lies in the plane of the first two coordinates; vectors are counted from the corner. [t1] is the unit
    tangent of the block that ends there, [t2] that of the block that starts there, [rho] the offset value with its
    side: positive to the left. *)
From Coq Require Import Reals Lra Psatz List.
From Toolcomp Require Import Vectors.
Import ListNotations.
Open Scope R_scope.

(** A unit vector of the plane. *)
Definition direction t := vz t = 0 /\ dot t t = 1.

(** The left normal of a direction. *)
Definition left t := Vec (- vy t) (vx t) 0.

(** The turn from [t1] to [t2]: positive to the left. *)
Definition turn t1 t2 := vx t1 * vy t2 - vy t1 * vx t2.

(** [p] lies on the line along [t], offset by [rho] to the left. *)
Definition on_offset_line rho t p := vz p = 0 /\ dot (left t) p = rho.

(** [p] lies on the circle about [o] with the radius [r]. *)
Definition on_circle o r p := vz p = 0 /\ dot (sub p o) (sub p o) = r².

(** The perpendicular vector of a block. *)
Definition perpendicular rho t := scale rho (left t).

(** The intersection of the two offset tangents. *)
Definition M rho t1 t2 := scale (rho / (1 + dot t1 t2)) (add (left t1) (left t2)).

(** The two vectors of an acute corner. *)
Definition Q1 rho t1 := add (perpendicular rho t1) (scale (Rabs rho) t1).
Definition Q2 rho t2 := sub (perpendicular rho t2) (scale (Rabs rho) t2).

(** The vector of a change of direction between two lines: [rho] before, [- rho] after the corner. *)
Definition direction_change rho t1 t2 := scale (rho / (1 - dot t1 t2)) (sub (left t1) (left t2)).

(** The offset with its side, of a code and a value. *)
Inductive code := G41 | G42.
Definition side_offset c d := match c with G41 => d | G42 => - d end.

(** The group of vectors between two lines in the offset mode. *)
Definition group rho t1 t2 :=
  if Rlt_dec 0 (rho * turn t1 t2) then [M rho t1 t2]
  else if Rle_dec 0 (dot t1 t2) then [M rho t1 t2]
  else [Q1 rho t1; Q2 rho t2].

(** A line and an arc: [t] of the line, the centre [o] and the offset radius [r] of the arc. *)
Definition line_circle_height rho t o := dot o (left t) - rho.
Definition line_circle_point rho t o r :=
  let s0 := dot o t in
  let root := sqrt (r² - (line_circle_height rho t o)²) in
  add (perpendicular rho t) (scale (if Rlt_dec 0 s0 then s0 - root else s0 + root) t).

(** Two arcs: centres and offset radii; [side] is 1 or -1, the side of the line through the centres. *)
Definition circles_foot o1 o2 r1 r2 :=
  let e := sub o2 o1 in (dot e e + r1² - r2²) / (2 * dot e e).
Definition circles_height2 o1 o2 r1 r2 :=
  let e := sub o2 o1 in r1² - (circles_foot o1 o2 r1 r2)² * dot e e.
Definition circles_point side o1 o2 r1 r2 :=
  let e := sub o2 o1 in
  add o1 (add (scale (circles_foot o1 o2 r1 r2) e)
              (scale (side * (sqrt (circles_height2 o1 o2 r1 r2) / norm e)) (left e))).

(** * Basic facts *)

Ltac values := unfold turn, dot, left, sub, opp, add, scale, zero in *; cbn [vx vy vz] in *; try lra.
Ltac coordinates :=
  repeat match goal with u : vec |- _ => destruct u end;
  unfold direction, on_offset_line, on_circle, perpendicular, turn, left, sub, opp, add, scale, dot, zero, Rsqr in *;
  cbn [vx vy vz] in *.

Lemma direction_x : direction (Vec 1 0 0).
Proof. unfold direction; split; values. Qed.
Lemma direction_y : direction (Vec 0 1 0).
Proof. unfold direction; split; values. Qed.
Lemma direction_minus_x : direction (Vec (-1) 0 0).
Proof. unfold direction; split; values. Qed.
Lemma direction_minus_y : direction (Vec 0 (-1) 0).
Proof. unfold direction; split; values. Qed.
Lemma direction_up : direction (Vec (3/5) (4/5) 0).
Proof. unfold direction; split; values. Qed.
Lemma direction_back : direction (Vec (-3/5) (-4/5) 0).
Proof. unfold direction; split; values. Qed.
#[local] Hint Resolve direction_x direction_y direction_minus_x direction_minus_y direction_up direction_back : core.

Lemma left_direction t : direction t -> direction (left t).
Proof. coordinates. intros [Z H]; split; [reflexivity | rewrite <- H, Z; ring]. Qed.

Lemma opp_direction t : direction t -> direction (opp t).
Proof. coordinates. intros [Z H]; split; [rewrite Z; ring | rewrite <- H; ring]. Qed.

Lemma left_dot_left u v : vz u = 0 -> dot (left u) (left v) = dot u v.
Proof. coordinates. intros Z; rewrite Z; ring. Qed.

Lemma left_dot u v : dot (left u) v = turn u v.
Proof. coordinates; ring. Qed.

Lemma left_dot_self u : dot (left u) u = 0.
Proof. coordinates; ring. Qed.

Lemma left_sub u v : left (sub u v) = sub (left u) (left v).
Proof. coordinates; f_equal; ring. Qed.

Lemma turn_comm u v : turn v u = - turn u v.
Proof. coordinates; ring. Qed.

Lemma cosine_sine t1 t2 : direction t1 -> direction t2 -> (dot t1 t2)² + (turn t1 t2)² = 1.
Proof.
  destruct t1 as [a b z], t2 as [c d w]. unfold direction, dot, turn, Rsqr; cbn [vx vy vz].
  intros [Z1 H1] [Z2 H2]. subst z w.
  transitivity ((a * a + b * b + 0 * 0) * (c * c + d * d + 0 * 0)); [ring | rewrite H1, H2; ring].
Qed.

Lemma cosine_range t1 t2 : direction t1 -> direction t2 -> -1 <= dot t1 t2 <= 1.
Proof. intros A B; pose proof (cosine_sine t1 t2 A B); unfold Rsqr in *; nra. Qed.

(** Parallel directions of opposite sense are opposite. *)
Lemma opposite t1 t2 : direction t1 -> direction t2 -> dot t1 t2 = -1 -> t2 = opp t1.
Proof.
  destruct t1 as [a b z], t2 as [c d w]. unfold direction, dot, opp, scale; cbn [vx vy vz].
  intros [Z1 H1] [Z2 H2] K. subst z w.
  assert (E : (a + c)² + (b + d)² = 0) by (unfold Rsqr; lra).
  apply Rplus_sqr_eq_0 in E. f_equal; lra.
Qed.

(** * The intersection of two offset lines *)

(** fanuc.cutter-c.inner-lines: the vector M lies on both offset lines. *)
Theorem M_on_both_lines rho t1 t2 : direction t1 -> direction t2 -> 1 + dot t1 t2 <> 0 ->
  on_offset_line rho t1 (M rho t1 t2) /\ on_offset_line rho t2 (M rho t1 t2).
Proof.
  intros [Z1 H1] [Z2 H2] K. unfold on_offset_line, M.
  rewrite !dot_scale_r, !dot_add_r, !left_dot_left, H1, H2, (dot_comm t2 t1) by auto.
  repeat split; try (coordinates; ring); field; auto.
Qed.

Example M_on_both_lines_instance :
  on_offset_line 10 (Vec 1 0 0) (M 10 (Vec 1 0 0) (Vec (3/5) (4/5) 0)) /\
  on_offset_line 10 (Vec (3/5) (4/5) 0) (M 10 (Vec 1 0 0) (Vec (3/5) (4/5) 0)).
Proof. apply M_on_both_lines; auto; values. Qed.

(** fanuc.cutter-c.inner-lines: no other point lies on both offset lines of two blocks at an angle. *)
Theorem M_unique rho t1 t2 p : direction t1 -> direction t2 -> turn t1 t2 <> 0 ->
  on_offset_line rho t1 p -> on_offset_line rho t2 p -> p = M rho t1 t2.
Proof.
  intros A B C [Z E1] [_ E2]. pose proof (cosine_sine t1 t2 A B) as S. unfold Rsqr in S.
  assert (K : 1 + dot t1 t2 <> 0) by (intro K; apply C; nra).
  destruct (M_on_both_lines rho t1 t2 A B K) as [[Z' F1] [_ F2]].
  set (m := M rho t1 t2) in *; clearbody m.
  assert (D1 : dot (left t1) (sub p m) = 0) by (unfold sub, opp; rewrite dot_add_r, dot_scale_r; lra).
  assert (D2 : dot (left t2) (sub p m) = 0) by (unfold sub, opp; rewrite dot_add_r, dot_scale_r; lra).
  assert (Z0 : vz (sub p m) = 0) by (coordinates; lra).
  destruct (sub p m) as [x y z] eqn:E. cbn in Z0; subst z.
  unfold left, dot, turn in D1, D2, C; cbn [vx vy vz] in D1, D2.
  assert (X : x * (vx t1 * vy t2 - vy t1 * vx t2) = 0).
  { replace (x * (vx t1 * vy t2 - vy t1 * vx t2)) with
      (vx t2 * (- vy t1 * x + vx t1 * y + 0 * 0) - vx t1 * (- vy t2 * x + vx t2 * y + 0 * 0)) by ring.
    rewrite D1, D2; ring. }
  assert (Y : y * (vx t1 * vy t2 - vy t1 * vx t2) = 0).
  { replace (y * (vx t1 * vy t2 - vy t1 * vx t2)) with
      (vy t2 * (- vy t1 * x + vx t1 * y + 0 * 0) - vy t1 * (- vy t2 * x + vx t2 * y + 0 * 0)) by ring.
    rewrite D1, D2; ring. }
  apply Rmult_integral in X; apply Rmult_integral in Y.
  destruct X as [X | X]; [| tauto]; destruct Y as [Y | Y]; [| tauto].
  subst; apply vec_eq; [apply (f_equal vx) in E | apply (f_equal vy) in E | apply (f_equal vz) in E];
    coordinates; lra.
Qed.

Example M_unique_instance : Vec (-10) 10 0 = M 10 (Vec 1 0 0) (Vec 0 1 0).
Proof.
  apply M_unique; auto; try (values; fail); split; values.
Qed.

(** fanuc.cutter-c.inner-lines: the square of the vector's length is 2 r² / (1 + k). *)
Theorem M_length rho t1 t2 : direction t1 -> direction t2 -> 1 + dot t1 t2 <> 0 ->
  dot (M rho t1 t2) (M rho t1 t2) = 2 * rho² / (1 + dot t1 t2).
Proof.
  intros [Z1 H1] [Z2 H2] K. unfold M.
  rewrite dot_scale_l, dot_scale_r, !dot_add_l, !dot_add_r, !left_dot_left, H1, H2, (dot_comm t2 t1) by auto.
  unfold Rsqr; field; auto.
Qed.

Example M_length_instance :
  dot (M 10 (Vec 1 0 0) (Vec 0 1 0)) (M 10 (Vec 1 0 0) (Vec 0 1 0)) = 2 * 10² / (1 + dot (Vec 1 0 0) (Vec 0 1 0)).
Proof. apply M_length; auto; values. Qed.

(** fanuc.cutter-c.outer-obtuse: no corner brings the tool nearer to the programmed point than the offset value. *)
Theorem M_keeps_distance rho t1 t2 : direction t1 -> direction t2 -> 1 + dot t1 t2 <> 0 ->
  rho² <= dot (M rho t1 t2) (M rho t1 t2).
Proof.
  intros A B K. rewrite M_length by auto. pose proof (cosine_range t1 t2 A B).
  assert (P : 0 < 1 + dot t1 t2) by lra.
  apply (Rmult_le_reg_r (1 + dot t1 t2)); auto.
  unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra. pose proof (Rle_0_sqr rho). nra.
Qed.

Example M_keeps_distance_instance :
  10² <= dot (M 10 (Vec 1 0 0) (Vec 0 (-1) 0)) (M 10 (Vec 1 0 0) (Vec 0 (-1) 0)).
Proof. apply M_keeps_distance; auto; values. Qed.

(** fanuc.cutter-c.straight-or-reversal: straight back the two offset lines have no point in common. *)
Theorem reversal_has_no_intersection rho t p : direction t -> rho <> 0 ->
  on_offset_line rho t p -> ~ on_offset_line rho (opp t) p.
Proof.
  intros _ R [_ E] [_ F]. apply R. rewrite <- E in F at 1.
  assert (dot (left (opp t)) p = - dot (left t) p) by (coordinates; ring). lra.
Qed.

Example reversal_has_no_intersection_instance :
  on_offset_line 10 (Vec 1 0 0) (Vec 3 10 0) -> ~ on_offset_line 10 (opp (Vec 1 0 0)) (Vec 3 10 0).
Proof. apply reversal_has_no_intersection; auto; lra. Qed.

(** fanuc.cutter-c.tangent-join: straight on the intersection is the perpendicular vector of both blocks. *)
Theorem M_straight_on rho t : direction t -> M rho t t = perpendicular rho t.
Proof.
  intros [Z H]. unfold M, perpendicular. rewrite H. coordinates; f_equal; field.
Qed.

Example M_straight_on_instance : M 10 (Vec (3/5) (4/5) 0) (Vec (3/5) (4/5) 0) = perpendicular 10 (Vec (3/5) (4/5) 0).
Proof. apply M_straight_on; auto. Qed.

(** fanuc.cutter-c.tangent-join: a straight block of length [l] from [P] may be split after [s]: the head there lies on
    the straight way from head to head, for whatever vectors of the offset line the block starts and ends with. *)
Theorem split_changes_nothing rho t P l s V W : direction t -> on_offset_line rho t V -> on_offset_line rho t W ->
  let start := add P V in
  let split := add (add P (scale s t)) (M rho t t) in
  let finish := add (add P (scale l t)) W in
  dot (left t) (sub split start) = 0 /\ dot (left t) (sub finish split) = 0.
Proof.
  intros A [_ HV] [_ HW]; cbv zeta. rewrite M_straight_on by auto.
  assert (L : dot (left t) (perpendicular rho t) = rho).
  { unfold perpendicular. destruct A as [Z H]. rewrite dot_scale_r, left_dot_left, H by auto; ring. }
  assert (T : dot (left t) t = 0) by apply left_dot_self.
  unfold sub, opp.
  split; repeat (rewrite ?dot_add_r, ?dot_scale_r); rewrite L, T, ?HV, ?HW; ring.
Qed.

Example split_changes_nothing_instance :
  let start := add (Vec 7 2 0) (Vec 0 10 0) in
  let split := add (add (Vec 7 2 0) (scale 5 (Vec 1 0 0))) (M 10 (Vec 1 0 0) (Vec 1 0 0)) in
  let finish := add (add (Vec 7 2 0) (scale 40 (Vec 1 0 0))) (Vec (-5) 10 0) in
  dot (left (Vec 1 0 0)) (sub split start) = 0 /\ dot (left (Vec 1 0 0)) (sub finish split) = 0.
Proof. apply split_changes_nothing; auto; split; values. Qed.

(** fanuc.cutter-c.tangent-join: a tangent join inside a straight path adds no corner move. *)
Theorem split_adds_no_corner rho t : direction t -> group rho t t = [perpendicular rho t].
Proof.
  intro A. unfold group. assert (turn t t = 0) by (unfold turn; ring). rewrite H.
  destruct A as [Z E]. destruct (Rlt_dec 0 (rho * 0)); [exfalso; lra |].
  destruct (Rle_dec 0 (dot t t)); [| exfalso; lra]. rewrite M_straight_on; [reflexivity | split; auto].
Qed.

Example split_adds_no_corner_instance :
  group (-10) (Vec (3/5) (4/5) 0) (Vec (3/5) (4/5) 0) = [perpendicular (-10) (Vec (3/5) (4/5) 0)].
Proof. apply split_adds_no_corner; auto. Qed.

(** * Acute corners *)

(** fanuc.cutter-c.outer-acute: the first vector lies on A's offset line, past the corner by the offset value. *)
Theorem Q1_past_the_corner rho t1 : direction t1 ->
  on_offset_line rho t1 (Q1 rho t1) /\ dot t1 (Q1 rho t1) = Rabs rho.
Proof.
  intros [Z H]. unfold on_offset_line, Q1, perpendicular.
  rewrite !dot_add_r, !dot_scale_r, left_dot_left, left_dot_self, (dot_comm t1 (left t1)), left_dot_self, H by auto.
  repeat split; try ring. destruct t1; cbn in *; rewrite Z; ring.
Qed.

Example Q1_past_the_corner_instance :
  on_offset_line 10 (Vec 1 0 0) (Q1 10 (Vec 1 0 0)) /\ dot (Vec 1 0 0) (Q1 10 (Vec 1 0 0)) = Rabs 10.
Proof. apply Q1_past_the_corner; auto. Qed.

(** fanuc.cutter-c.outer-acute: the second lies on B's offset line, as far before the corner. *)
Theorem Q2_before_the_corner rho t2 : direction t2 ->
  on_offset_line rho t2 (Q2 rho t2) /\ dot t2 (Q2 rho t2) = - Rabs rho.
Proof.
  intros [Z H]. unfold on_offset_line, Q2, perpendicular, sub, opp.
  rewrite !dot_add_r, !dot_scale_r, left_dot_left, left_dot_self, (dot_comm t2 (left t2)), left_dot_self, H by auto.
  repeat split; try ring. destruct t2; cbn in *; rewrite Z; ring.
Qed.

Example Q2_before_the_corner_instance :
  on_offset_line 10 (Vec (-3/5) (-4/5) 0) (Q2 10 (Vec (-3/5) (-4/5) 0)) /\
  dot (Vec (-3/5) (-4/5) 0) (Q2 10 (Vec (-3/5) (-4/5) 0)) = - Rabs 10.
Proof. apply Q2_before_the_corner; auto. Qed.

(** fanuc.cutter-c.obtuse-or-acute: at exactly 90 degrees both vectors of an acute corner are the intersection, so the
    limit may belong to either side. *)
Theorem Q_at_90_degrees rho t1 t2 : direction t1 -> direction t2 -> dot t1 t2 = 0 -> rho * turn t1 t2 <= 0 ->
  Q1 rho t1 = M rho t1 t2 /\ Q2 rho t2 = M rho t1 t2.
Proof.
  intros A B K C. pose proof (cosine_sine t1 t2 A B) as S. rewrite K in S. unfold Rsqr in S.
  assert (T : turn t1 t2 = 1 \/ turn t1 t2 = -1) by (destruct (Rle_dec 0 (turn t1 t2)); [left | right]; nra).
  destruct A as [Z1 H1], B as [Z2 H2]. unfold M, Q1, Q2, perpendicular; rewrite K.
  destruct t1 as [a b z], t2 as [c d w]. unfold dot, turn in *; cbn [vx vy vz] in *; subst z w.
  assert (N : (c = - b /\ d = a /\ rho <= 0) \/ (c = b /\ d = - a /\ 0 <= rho)).
  { assert (X : c = a * (a * c + b * d) - b * (a * d - b * c)).
    { transitivity (c * (a * a + b * b + 0 * 0)); [rewrite H1; ring | ring]. }
    assert (Y : d = b * (a * c + b * d) + a * (a * d - b * c)).
    { transitivity (d * (a * a + b * b + 0 * 0)); [rewrite H1; ring | ring]. }
    replace (a * c + b * d) with 0 in X, Y by lra.
    destruct T as [T | T]; [left | right]; rewrite T in C, X, Y; repeat split; lra. }
  unfold left, sub, opp, add, scale; cbn [vx vy vz].
  destruct N as [[X [Y R]] | [X [Y R]]]; subst c d;
    [rewrite (Rabs_left1 rho) by auto | rewrite (Rabs_right rho) by lra]; split; f_equal; field.
Qed.

Example Q_at_90_degrees_instance :
  Q1 10 (Vec 1 0 0) = M 10 (Vec 1 0 0) (Vec 0 (-1) 0) /\ Q2 10 (Vec 0 (-1) 0) = M 10 (Vec 1 0 0) (Vec 0 (-1) 0).
Proof. apply Q_at_90_degrees; auto; values. Qed.

Lemma Q1_length rho t1 : direction t1 -> dot (Q1 rho t1) (Q1 rho t1) = 2 * rho².
Proof.
  intros [Z H]. unfold Q1, perpendicular.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, left_dot_left, left_dot_self, (dot_comm t1 (left t1)),
    left_dot_self, H by auto.
  pose proof (Rsqr_abs rho). unfold Rsqr in *; lra.
Qed.

Lemma Q2_length rho t2 : direction t2 -> dot (Q2 rho t2) (Q2 rho t2) = 2 * rho².
Proof.
  intros [Z H]. unfold Q2, perpendicular, sub, opp.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, left_dot_left, left_dot_self, (dot_comm t2 (left t2)),
    left_dot_self, H by auto.
  pose proof (Rsqr_abs rho). unfold Rsqr in *; lra.
Qed.

Lemma Q1_dot_Q2 rho t1 t2 : direction t1 -> direction t2 ->
  dot (Q1 rho t1) (Q2 rho t2) = -2 * (Rabs rho * (rho * turn t1 t2)).
Proof.
  intros [Z1 H1] [Z2 H2]. unfold Q1, Q2, perpendicular, sub, opp.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, left_dot_left, (dot_comm t1 (left t2)), !left_dot,
    (turn_comm t1 t2) by auto.
  pose proof (Rsqr_abs rho) as E. unfold Rsqr in E.
  replace (rho * (rho * dot t1 t2)) with (rho * rho * dot t1 t2) by ring. rewrite E; ring.
Qed.

(** fanuc.cutter-c.outer-acute: the straight move that joins the two vectors keeps the offset as distance from the
    programmed point all along. *)
Theorem acute_keeps_distance rho t1 t2 u : direction t1 -> direction t2 -> rho * turn t1 t2 <= 0 -> 0 <= u <= 1 ->
  let p := add (scale (1 - u) (Q1 rho t1)) (scale u (Q2 rho t2)) in rho² <= dot p p.
Proof.
  intros A B C U p. unfold p.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, (dot_comm (Q2 rho t2)), Q1_length, Q2_length, Q1_dot_Q2
    by auto.
  pose proof (Rabs_pos rho). pose proof (Rle_0_sqr rho).
  assert (P : 0 <= - (Rabs rho * (rho * turn t1 t2))) by nra.
  assert (W : 0 <= u * (1 - u)) by (apply Rmult_le_pos; lra).
  set (x := - (Rabs rho * (rho * turn t1 t2))) in *.
  replace (-2 * (Rabs rho * (rho * turn t1 t2))) with (2 * x) by (unfold x; ring).
  assert (0 <= u * (1 - u) * x) by (apply Rmult_le_pos; auto).
  assert (0 <= (1 - 2 * u)² * rho²) by (apply Rmult_le_pos; apply Rle_0_sqr).
  match goal with |- _ <= ?e =>
    replace e with (rho² + (1 - 2 * u)² * rho² + 4 * (u * (1 - u) * x)) by (unfold Rsqr; ring) end.
  lra.
Qed.

Example acute_keeps_distance_instance :
  let p := add (scale (1 - 1/2) (Q1 10 (Vec 1 0 0))) (scale (1/2) (Q2 10 (Vec (-3/5) (-4/5) 0))) in 10² <= dot p p.
Proof. apply acute_keeps_distance; auto; values. Qed.

(** * Classification *)

Lemma norm_direction t : direction t -> norm t = 1.
Proof. intros [_ H]; unfold norm; rewrite H; apply sqrt_1. Qed.

(** The angle of an outer corner, on the side of the workpiece. *)
Lemma cos_corner t1 t2 : direction t1 -> direction t2 -> cos (angle (opp t1) t2) = - dot t1 t2.
Proof.
  intros A B. unfold angle. rewrite norm_opp, !norm_direction by auto. pose proof (cosine_range t1 t2 A B).
  replace (dot (opp t1) t2) with (- dot t1 t2) by (unfold opp; rewrite dot_scale_l; ring).
  rewrite cos_acos; [field |]. replace (- dot t1 t2 / (1 * 1)) with (- dot t1 t2) by field. lra.
Qed.

(** fanuc.cutter-c.obtuse-or-acute: the test by the product of the tangents is the one of 90 degrees. *)
Theorem obtuse_is_angle t1 t2 : direction t1 -> direction t2 ->
  (0 <= dot t1 t2 <-> PI / 2 <= angle (opp t1) t2).
Proof.
  intros A B. pose proof (cos_corner t1 t2 A B) as C. pose proof (angle_bounds (opp t1) t2) as [L U].
  pose proof PI_RGT_0. split; intro H'.
  - apply Rnot_lt_le; intro G. assert (0 < cos (angle (opp t1) t2)) by (apply cos_gt_0; lra). lra.
  - assert (cos (angle (opp t1) t2) <= 0) by (apply cos_le_0; lra). lra.
Qed.

Example obtuse_is_angle_instance :
  0 <= dot (Vec 1 0 0) (Vec (3/5) (4/5) 0) <-> PI / 2 <= angle (opp (Vec 1 0 0)) (Vec (3/5) (4/5) 0).
Proof. apply obtuse_is_angle; auto. Qed.

(** fanuc.cutter-c.under-one-degree: the test by squares is the one of the angle, for any limit below 90 degrees. *)
Theorem under_is_angle delta t1 t2 : 0 < delta < PI / 2 -> direction t1 -> direction t2 -> dot t1 t2 < 0 ->
  ((turn t1 t2)² < (tan delta)² * (dot t1 t2)² <-> angle (opp t1) t2 < delta).
Proof.
  intros D A B K. pose proof (cos_corner t1 t2 A B) as C. pose proof (angle_bounds (opp t1) t2) as [L U].
  pose proof (cosine_sine t1 t2 A B) as S. pose proof PI_RGT_0.
  assert (Cd : 0 < cos delta) by (apply cos_gt_0; lra).
  assert (E : (tan delta)² * (cos delta)² = 1 - (cos delta)²).
  { unfold tan. rewrite Rsqr_div', <- (sin2_cos2 delta) by lra. unfold Rsqr; field; lra. }
  assert (T : (turn t1 t2)² < (tan delta)² * (dot t1 t2)² <-> cos delta < - dot t1 t2).
  { assert (P : 0 < (cos delta)²) by (unfold Rsqr; nra).
    split; intro H'.
    - apply Rsqr_incrst_0; try lra. rewrite <- Rsqr_neg.
      assert ((turn t1 t2)² * (cos delta)² < (1 - (cos delta)²) * (dot t1 t2)²) by (rewrite <- E; nra).
      nra.
    - assert (G : (cos delta)² < (dot t1 t2)²) by (rewrite (Rsqr_neg (dot t1 t2)); apply Rsqr_incrst_1; lra).
      apply (Rmult_lt_reg_r ((cos delta)²)); auto. nra. }
  rewrite T, <- C. split; intro H'.
  - apply Rnot_le_lt; intros [G | G]; [apply cos_decreasing_1 in G; lra | rewrite G in H'; lra].
  - apply cos_decreasing_1; lra.
Qed.

Example under_is_angle_instance :
  (turn (Vec 1 0 0) (Vec (-3/5) (-4/5) 0))² < (tan (PI / 4))² * (dot (Vec 1 0 0) (Vec (-3/5) (-4/5) 0))² <->
  angle (opp (Vec 1 0 0)) (Vec (-3/5) (-4/5) 0) < PI / 4.
Proof. apply under_is_angle; auto; [pose proof PI_RGT_0; lra | values]. Qed.

(** * Symmetries *)

(** fanuc.cutter.side: G41 with a negative value is G42 with the positive one, at every corner. *)
Theorem negative_value_exchanges_sides d t1 t2 :
  group (side_offset G41 (- d)) t1 t2 = group (side_offset G42 d) t1 t2.
Proof. reflexivity. Qed.

Example negative_value_exchanges_sides_instance :
  group (side_offset G41 (- 10)) (Vec 1 0 0) (Vec 0 1 0) = group (side_offset G42 10) (Vec 1 0 0) (Vec 0 1 0).
Proof. apply negative_value_exchanges_sides. Qed.

(** The mirror image at the first axis. *)
Definition mirror u := Vec (vx u) (- vy u) (vz u).

(** fanuc.cutter.side: the mirror image of a path, offset to the other side, has the mirror images of the vectors. *)
Theorem mirrored_group rho t1 t2 : group (- rho) (mirror t1) (mirror t2) = map mirror (group rho t1 t2).
Proof.
  unfold group.
  replace (- rho * turn (mirror t1) (mirror t2)) with (rho * turn t1 t2) by (unfold turn, mirror; cbn; ring).
  replace (dot (mirror t1) (mirror t2)) with (dot t1 t2) by (unfold dot, mirror; cbn; ring).
  assert (E : M (- rho) (mirror t1) (mirror t2) = mirror (M rho t1 t2)).
  { unfold M. replace (dot (mirror t1) (mirror t2)) with (dot t1 t2) by (unfold dot, mirror; cbn; ring).
    unfold Rdiv. generalize (/ (1 + dot t1 t2)); intro q.
    unfold mirror, left, add, scale; cbn [vx vy vz]; f_equal; ring. }
  destruct (Rlt_dec 0 (rho * turn t1 t2)); [| destruct (Rle_dec 0 (dot t1 t2))]; cbn [map]; rewrite ?E; auto.
  repeat f_equal; unfold Q1, Q2, perpendicular; rewrite Rabs_Ropp;
    unfold mirror, left, sub, opp, add, scale; cbn [vx vy vz]; f_equal; ring.
Qed.

Example mirrored_group_instance :
  group (- 10) (mirror (Vec 1 0 0)) (mirror (Vec (-3/5) (-4/5) 0)) =
  map mirror (group 10 (Vec 1 0 0) (Vec (-3/5) (-4/5) 0)).
Proof. apply mirrored_group. Qed.

(** fanuc.cutter.side: the path run backwards, offset to the other side, has the same vectors in reverse order. *)
Theorem reversed_group rho t1 t2 : group (- rho) (opp t2) (opp t1) = rev (group rho t1 t2).
Proof.
  unfold group.
  replace (- rho * turn (opp t2) (opp t1)) with (rho * turn t1 t2) by (unfold turn, opp, scale; cbn; ring).
  replace (dot (opp t2) (opp t1)) with (dot t1 t2) by (unfold dot, opp, scale; cbn; ring).
  assert (E : M (- rho) (opp t2) (opp t1) = M rho t1 t2).
  { unfold M. replace (dot (opp t2) (opp t1)) with (dot t1 t2) by (unfold dot, opp, scale; cbn; ring).
    unfold Rdiv. generalize (/ (1 + dot t1 t2)); intro q.
    unfold left, opp, add, scale; cbn [vx vy vz]; f_equal; ring. }
  destruct (Rlt_dec 0 (rho * turn t1 t2)); [| destruct (Rle_dec 0 (dot t1 t2))]; cbn [rev app]; rewrite ?E; auto.
  assert (E1 : Q1 (- rho) (opp t2) = Q2 rho t2).
  { unfold Q1, Q2, perpendicular; rewrite Rabs_Ropp; destruct t2;
      unfold left, sub, opp, add, scale; cbn; f_equal; ring. }
  assert (E2 : Q2 (- rho) (opp t1) = Q1 rho t1).
  { unfold Q1, Q2, perpendicular; rewrite Rabs_Ropp; destruct t1;
      unfold left, sub, opp, add, scale; cbn; f_equal; ring. }
  rewrite E1, E2; reflexivity.
Qed.

Example reversed_group_instance :
  group (- 10) (opp (Vec (-3/5) (-4/5) 0)) (opp (Vec 1 0 0)) = rev (group 10 (Vec 1 0 0) (Vec (-3/5) (-4/5) 0)).
Proof. apply reversed_group. Qed.

(** * Change of direction *)

(** fanuc.cutter-c.direction-change-lines: the vector lies on A's offset line and on B's, which is on the other side. *)
Theorem direction_change_on_both_lines rho t1 t2 : direction t1 -> direction t2 -> dot t1 t2 <> 1 ->
  on_offset_line rho t1 (direction_change rho t1 t2) /\ on_offset_line (- rho) t2 (direction_change rho t1 t2).
Proof.
  intros [Z1 H1] [Z2 H2] K. unfold on_offset_line, direction_change, sub, opp.
  rewrite !dot_scale_r, !dot_add_r, !dot_scale_r, !left_dot_left, H1, H2, (dot_comm t2 t1) by auto.
  repeat split; try (destruct t1, t2; unfold left, add, scale; cbn; ring); field; lra.
Qed.

Example direction_change_on_both_lines_instance :
  on_offset_line 10 (Vec 1 0 0) (direction_change 10 (Vec 1 0 0) (Vec 0 1 0)) /\
  on_offset_line (- 10) (Vec 0 1 0) (direction_change 10 (Vec 1 0 0) (Vec 0 1 0)).
Proof. apply direction_change_on_both_lines; auto; values. Qed.

(** fanuc.cutter-c.direction-change-lines: it lies equally far along both lines, so beyond one of the two blocks. *)
Theorem direction_change_past_the_corner rho t1 t2 : direction t1 -> direction t2 -> dot t1 t2 <> 1 ->
  dot t1 (direction_change rho t1 t2) = rho * turn t1 t2 / (1 - dot t1 t2) /\
  dot t2 (direction_change rho t1 t2) = rho * turn t1 t2 / (1 - dot t1 t2).
Proof.
  intros A B K. unfold direction_change, sub, opp.
  rewrite !dot_scale_r, !dot_add_r, !dot_scale_r, (dot_comm t1 (left t1)), (dot_comm t1 (left t2)),
    (dot_comm t2 (left t1)), (dot_comm t2 (left t2)), !left_dot_self, !left_dot, (turn_comm t1 t2).
  split; field; lra.
Qed.

Example direction_change_past_the_corner_instance :
  dot (Vec 1 0 0) (direction_change 10 (Vec 1 0 0) (Vec 0 1 0)) =
    10 * turn (Vec 1 0 0) (Vec 0 1 0) / (1 - dot (Vec 1 0 0) (Vec 0 1 0)) /\
  dot (Vec 0 1 0) (direction_change 10 (Vec 1 0 0) (Vec 0 1 0)) =
    10 * turn (Vec 1 0 0) (Vec 0 1 0) / (1 - dot (Vec 1 0 0) (Vec 0 1 0)).
Proof. apply direction_change_past_the_corner; auto; values. Qed.

(** fanuc.cutter-c.direction-change-parallel: straight back both perpendicular vectors are one, and it is the
    intersection, too. *)
Theorem direction_change_straight_back rho t1 t2 : direction t1 -> direction t2 -> dot t1 t2 = -1 ->
  direction_change rho t1 t2 = perpendicular rho t1 /\ perpendicular (- rho) t2 = perpendicular rho t1.
Proof.
  intros A B K. unfold direction_change. rewrite K, (opposite t1 t2 A B K).
  unfold perpendicular, left, sub, opp, add, scale; cbn [vx vy vz]. split; f_equal; field.
Qed.

Example direction_change_straight_back_instance :
  direction_change 10 (Vec 1 0 0) (Vec (-1) 0 0) = perpendicular 10 (Vec 1 0 0) /\
  perpendicular (- 10) (Vec (-1) 0 0) = perpendicular 10 (Vec 1 0 0).
Proof. apply direction_change_straight_back; auto; values. Qed.

(** fanuc.cutter-c.direction-change-without-intersection: straight on the two offset lines have no point in common. *)
Theorem straight_on_has_no_common_point rho t p : rho <> 0 -> on_offset_line rho t p -> ~ on_offset_line (- rho) t p.
Proof. intros R [_ E] [_ F]. lra. Qed.

Example straight_on_has_no_common_point_instance :
  on_offset_line 10 (Vec 1 0 0) (Vec 3 10 0) -> ~ on_offset_line (- 10) (Vec 1 0 0) (Vec 3 10 0).
Proof. apply straight_on_has_no_common_point; lra. Qed.

(** * Intersections with arcs *)

(** fanuc.cutter-c.line-arc-point: the point lies on the offset line and on the offset circle. *)
Theorem line_circle_point_on_both rho t o r : direction t -> vz o = 0 -> (line_circle_height rho t o)² <= r² ->
  on_offset_line rho t (line_circle_point rho t o r) /\ on_circle o r (line_circle_point rho t o r).
Proof.
  intros [Z H] Zo D. unfold line_circle_point, perpendicular. set (s := if Rlt_dec 0 (dot o t) then _ else _).
  assert (S : (s - dot o t)² = r² - (line_circle_height rho t o)²).
  { unfold s; destruct Rlt_dec.
    - replace (dot o t - sqrt (r² - (line_circle_height rho t o)²) - dot o t)
        with (- sqrt (r² - (line_circle_height rho t o)²)) by ring.
      rewrite <- Rsqr_neg, Rsqr_sqrt by lra; reflexivity.
    - replace (dot o t + sqrt (r² - (line_circle_height rho t o)²) - dot o t)
        with (sqrt (r² - (line_circle_height rho t o)²)) by ring.
      rewrite Rsqr_sqrt by lra; reflexivity. }
  clearbody s. unfold line_circle_height in S.
  assert (P : dot o o = (dot o t)² + (dot o (left t))²).
  { destruct t as [a b z], o as [x y w]; unfold dot, left, Rsqr in *; cbn [vx vy vz] in *; subst z w.
    transitivity ((x * x + y * y) * (a * a + b * b + 0 * 0)); [rewrite H; ring | ring]. }
  split.
  - split; [destruct t; cbn in *; rewrite Z; ring |].
    rewrite dot_add_r, !dot_scale_r, left_dot_left, left_dot_self, H by auto; ring.
  - split; [destruct t; cbn in *; rewrite Z; ring |].
    unfold sub, opp. rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, left_dot_left, left_dot_self, H,
      (dot_comm t (left t)), left_dot_self, (dot_comm (left t) o), (dot_comm t o), P by auto.
    unfold Rsqr in *. lra.
Qed.

Example line_circle_point_on_both_instance :
  on_offset_line 10 (Vec 1 0 0) (line_circle_point 10 (Vec 1 0 0) (Vec (-40) 30 0) 40) /\
  on_circle (Vec (-40) 30 0) 40 (line_circle_point 10 (Vec 1 0 0) (Vec (-40) 30 0) 40).
Proof. apply line_circle_point_on_both; auto. unfold line_circle_height, Rsqr; values. Qed.

(** fanuc.cutter-c.line-arc-point: of the two common points it is the one that is the corner itself where the offset
    is 0. *)
Theorem line_circle_point_without_offset t o : direction t -> vz o = 0 ->
  line_circle_point 0 t o (norm o) = zero.
Proof.
  intros [Z H] Zo. unfold line_circle_point, line_circle_height, perpendicular.
  assert (P : (norm o)² - (dot o (left t) - 0)² = (dot o t)²).
  { unfold Rsqr at 1; rewrite norm_sqr. rewrite Rminus_0_r.
    destruct t as [a b z], o as [x y w]; unfold dot, left, Rsqr in *; cbn [vx vy vz] in *; subst z w.
    replace (x * x + y * y + 0 * 0) with ((x * x + y * y) * (a * a + b * b + 0 * 0)) by (rewrite H; ring). ring. }
  rewrite P, sqrt_Rsqr_abs.
  destruct Rlt_dec as [G | G]; [rewrite Rabs_right by lra | rewrite Rabs_left1 by lra];
    [replace (dot o t - dot o t) with 0 by ring | replace (dot o t + - dot o t) with 0 by ring];
    rewrite !scale_zero_l; unfold add, zero; cbn; f_equal; ring.
Qed.

Example line_circle_point_without_offset_instance :
  line_circle_point 0 (Vec 1 0 0) (Vec (-40) 30 0) (norm (Vec (-40) 30 0)) = zero.
Proof. apply line_circle_point_without_offset; auto. Qed.

(** fanuc.cutter-c.arc-arc-point: the point lies on both offset circles. *)
Theorem circles_point_on_both side o1 o2 r1 r2 : side = 1 \/ side = -1 -> vz o1 = 0 -> vz o2 = 0 -> o1 <> o2 ->
  0 <= circles_height2 o1 o2 r1 r2 ->
  on_circle o1 r1 (circles_point side o1 o2 r1 r2) /\ on_circle o2 r2 (circles_point side o1 o2 r1 r2).
Proof.
  intros S Z1 Z2 D Hh. unfold circles_point, on_circle. set (e := sub o2 o1) in *.
  assert (Ze : vz e = 0) by (unfold e; destruct o1, o2; cbn in *; lra).
  assert (Pe : 0 < dot e e).
  { apply dot_self_pos. intro E; apply D. destruct o1, o2; unfold e, sub, opp, add, scale, zero in E; cbn in E.
    injection E; intros; f_equal; lra. }
  assert (Ne : 0 < norm e) by (unfold norm; apply sqrt_lt_R0; auto).
  set (a := circles_foot o1 o2 r1 r2) in *.
  assert (Fa : 2 * a * dot e e = dot e e + r1² - r2²) by (unfold a, circles_foot; fold e; field; lra).
  set (q := side * (sqrt (circles_height2 o1 o2 r1 r2) / norm e)) in *.
  assert (Fq : q² * dot e e = r1² - a² * dot e e).
  { unfold q. rewrite <- (norm_sqr e). unfold Rdiv.
    replace ((side * (sqrt (circles_height2 o1 o2 r1 r2) * / norm e))² * (norm e * norm e))
      with (side² * (sqrt (circles_height2 o1 o2 r1 r2))²) by (unfold Rsqr; field; lra).
    rewrite Rsqr_sqrt by auto. replace (side²) with 1 by (unfold Rsqr; destruct S; subst; ring).
    unfold circles_height2. fold e. fold a. rewrite norm_sqr. ring. }
  clearbody a q.
  assert (Z : vz (add o1 (add (scale a e) (scale q (left e)))) = 0).
  { unfold add, scale, left; cbn [vz]. rewrite Z1, Ze; ring. }
  assert (X : sub (add o1 (add (scale a e) (scale q (left e)))) o1 = add (scale a e) (scale q (left e))).
  { generalize (left e); clear; intro f. destruct o1, e, f; unfold sub, opp, add, scale; cbn; f_equal; ring. }
  assert (Y : sub (add o1 (add (scale a e) (scale q (left e)))) o2 = add (scale (a - 1) e) (scale q (left e))).
  { replace o2 with (add o1 e) by (unfold e; destruct o1, o2; unfold sub, opp, add, scale; cbn; f_equal; ring).
    generalize (left e); clear; intro f. destruct o1, e, f; unfold sub, opp, add, scale; cbn; f_equal; ring. }
  assert (W : forall c, dot (add (scale c e) (scale q (left e))) (add (scale c e) (scale q (left e)))
    = c² * dot e e + q² * dot e e).
  { intro c. rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, left_dot_left, (dot_comm e (left e)),
      left_dot_self by auto. unfold Rsqr; ring. }
  split; (split; [exact Z |]); rewrite ?X, ?Y, W, Fq; unfold Rsqr in *; lra.
Qed.

Example circles_point_on_both_instance :
  on_circle (Vec 0 0 0) 5 (circles_point 1 (Vec 0 0 0) (Vec 6 0 0) 5 5) /\
  on_circle (Vec 6 0 0) 5 (circles_point 1 (Vec 0 0 0) (Vec 6 0 0) 5 5).
Proof.
  apply circles_point_on_both; auto; cbn; auto.
  - intro E; injection E; lra.
  - unfold circles_height2, circles_foot, sub, opp, add, scale, dot, Rsqr; cbn; lra.
Qed.

(** * Interference *)

(** fanuc.cutter-c.interference-direction: on a straight block of length [l] between two vectors of its own offset line
    the test says that the tool would go backwards along the block. *)
Theorem interference_is_backwards rho t l V W : direction t -> 0 < l ->
  on_offset_line rho t V -> on_offset_line rho t W ->
  let D := scale l t in let D' := sub (add D W) V in
  (dot D D' < 0 <-> l + dot t W < dot t V).
Proof.
  intros [Z H] L _ _ D D'. unfold D', D, sub, opp.
  rewrite !dot_add_r, !dot_scale_l, !dot_scale_r, H. split; intro; nra.
Qed.

Example interference_is_backwards_instance :
  let D := scale 15 (Vec 0 1 0) in let D' := sub (add D (Vec (-10) (-10) 0)) (Vec (-10) 10 0) in
  (dot D D' < 0 <-> 15 + dot (Vec 0 1 0) (Vec (-10) (-10) 0) < dot (Vec 0 1 0) (Vec (-10) 10 0)).
Proof. apply interference_is_backwards with (rho := 10); auto; [lra | |]; split; values. Qed.

(** fanuc.cutter-c.interference-direction: a groove with a flat bottom of length [l] is refused exactly where it is
    narrower than twice the offset; one of twice the offset is cut. *)
Theorem groove_of_twice_the_offset rho t t' l : direction t -> direction t' -> dot t' t = 0 -> 0 < l ->
  0 < rho * turn t' t ->
  let D := scale l t in let D' := sub (add D (M rho t (opp t'))) (M rho t' t) in
  (dot D D' < 0 <-> l < 2 * Rabs rho).
Proof.
  intros A B K L C D D'. pose proof (cosine_sine t' t B A) as S. rewrite K in S. unfold Rsqr in S.
  assert (T : turn t' t = 1 \/ turn t' t = -1) by (destruct (Rle_dec 0 (turn t' t)); [left | right]; nra).
  assert (R : rho * turn t' t = Rabs rho).
  { destruct T as [T | T]; rewrite T in *; [rewrite Rabs_right by lra | rewrite Rabs_left by lra]; ring. }
  assert (E1 : dot t (M rho t' t) = Rabs rho).
  { unfold M. rewrite K, dot_scale_r, dot_add_r, (dot_comm t (left t')), (dot_comm t (left t)), left_dot_self, left_dot.
    rewrite <- R; field. }
  assert (E2 : dot t (M rho t (opp t')) = - Rabs rho).
  { unfold M. replace (dot t (opp t')) with 0 by (unfold opp; rewrite dot_scale_r, (dot_comm t t'), K; ring).
    rewrite dot_scale_r, dot_add_r, (dot_comm t (left t)), (dot_comm t (left (opp t'))), left_dot_self, left_dot.
    replace (turn (opp t') t) with (- turn t' t) by (unfold turn, opp, scale; cbn; ring). rewrite <- R; field. }
  unfold D', D, sub, opp. rewrite !dot_add_r, !dot_scale_l, !dot_scale_r.
  fold (opp t'). rewrite E1, E2. destruct A as [Z H]; rewrite H. split; intro; nra.
Qed.

Example groove_of_twice_the_offset_instance :
  let D := scale 20 (Vec 0 1 0) in
  let D' := sub (add D (M 10 (Vec 0 1 0) (opp (Vec 1 0 0)))) (M 10 (Vec 1 0 0) (Vec 0 1 0)) in
  (dot D D' < 0 <-> 20 < 2 * Rabs 10).
Proof. apply groove_of_twice_the_offset; auto; values. Qed.

(** fanuc.cutter-c.interference-sweep: of two sweeps within a whole turn the sine tells whether they differ by more than
    180 degrees. *)
Theorem sweep_difference_by_sine large small : 0 < large - small < 2 * PI ->
  (0 < sin (small - large) <-> PI < large - small).
Proof.
  intro D. pose proof PI_RGT_0. replace (small - large) with (- (large - small)) by ring. rewrite sin_neg.
  split; intro H'.
  - apply Rnot_le_lt; intro G. assert (0 <= sin (large - small)) by (apply sin_ge_0; lra). lra.
  - assert (sin (large - small) < 0) by (apply sin_lt_0; lra). lra.
Qed.

Example sweep_difference_by_sine_instance : 0 < sin (PI / 8 - 3 * PI / 2) <-> PI < 3 * PI / 2 - PI / 8.
Proof. apply sweep_difference_by_sine; pose proof PI_RGT_0; lra. Qed.
