(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/cutter-compensation-c: the corners of program/, over the real numbers, are those of the definitions: their
    theorems hold of what runs. *)
From Coq Require Import Reals Lra Psatz Bool ZArith List.
From Coq Require String.
From Toolcomp Require Import Vectors CutterCompensationC OutcomeLaws.
From Toolcomp Require Numbers Outcomes Arcs Corners.
Import Outcomes(outcome(..)).
Import ListNotations.
Open Scope R_scope.

(** * Definitions *)

(** A vector of the plane of program/. *)
Definition vector (v : Arcs.pair R) : vec := Vec (fst v) (snd v) 0.

(** A line at the corner, of a travel. *)
Definition line_of (travel : Arcs.pair R) (rho : R) : Corners.leg R := Corners.line_leg travel rho.
Definition travels (v : Arcs.pair R) : Prop := fst v <> 0 \/ snd v <> 0.

(** Its unit tangent. *)
Definition tangent (v : Arcs.pair R) : vec := vector (Corners.unit_way (line_of v 0)).

Lemma same_point {A} (a b : A) : Corners.MeetAt a = Corners.MeetAt b -> a = b.
Proof. now injection 1. Qed.

(** * Vectors *)

Lemma vector_add (a b : Arcs.pair R) : vector (Corners.add a b) = add (vector a) (vector b).
Proof. unfold vector, add; cbn; f_equal; ring. Qed.
Lemma vector_sub (a b : Arcs.pair R) : vector (Corners.subtract a b) = sub (vector a) (vector b).
Proof. unfold vector, sub, add, opp, scale; cbn; f_equal; ring. Qed.
Lemma vector_scale (k : R) (a : Arcs.pair R) : vector (Corners.scale k a) = scale k (vector a).
Proof. unfold vector, scale; cbn; f_equal; ring. Qed.
Lemma vector_dot (a b : Arcs.pair R) : Corners.dot a b = dot (vector a) (vector b).
Proof. unfold vector, dot; cbn; ring. Qed.
Lemma vector_cross (a b : Arcs.pair R) : Corners.cross a b = turn (vector a) (vector b).
Proof. unfold vector, turn; cbn; ring. Qed.
Lemma vector_left (a : Arcs.pair R) : vector (Corners.left_normal a) = left (vector a).
Proof. unfold vector, left; cbn; f_equal; ring. Qed.

Lemma square_positive v : travels v -> 0 < fst v * fst v + snd v * snd v.
Proof. intros [H|H]; nra. Qed.

Lemma tangent_values v : tangent v = scale (/ sqrt (fst v * fst v + snd v * snd v)) (vector v).
Proof.
  unfold tangent, line_of, vector, Corners.line_leg, Corners.leg_along; cbn. unfold scale; cbn.
  f_equal; unfold Rdiv; ring.
Qed.

Lemma tangent_direction v : travels v -> direction (tangent v).
Proof.
  intro D. apply square_positive in D. rewrite tangent_values. destruct v as [x y]. cbn [fst snd] in D.
  unfold direction, scale, dot, vector; cbn [vx vy vz fst snd]. split; [ring|].
  set (k := / sqrt (x * x + y * y)).
  assert (E : (x * x + y * y) * (k * k) = 1) by (unfold k; rewrite <- Rinv_mult, sqrt_sqrt by lra; field; lra).
  lra.
Qed.

(** Signs do not depend on the lengths of the tangents. *)
Lemma by_tangents u v : travels u -> travels v -> exists k, 0 < k /\
  Corners.aside u v = k * turn (tangent u) (tangent v) /\ Corners.ahead u v = k * dot (tangent u) (tangent v).
Proof.
  intros U V. apply square_positive in U, V. rewrite !tangent_values.
  set (a := fst u * fst u + snd u * snd u) in *. set (b := fst v * fst v + snd v * snd v) in *.
  assert (A : 0 < sqrt a) by now apply sqrt_lt_R0. assert (B : 0 < sqrt b) by now apply sqrt_lt_R0.
  exists (sqrt a * sqrt b). split; [nra|].
  unfold turn, dot, scale, vector; cbn. unfold Arcs.cross2, Arcs.dot2; cbn. split; field; lra.
Qed.

Lemma unit_of_line v rho : vector (Corners.unit_way (line_of v rho)) = tangent v.
Proof. reflexivity. Qed.
Lemma normal_of_line v rho : vector (Corners.normal (line_of v rho)) = left (tangent v).
Proof. apply vector_left. Qed.
Lemma perpendicular_of_line v rho : vector (Corners.perpendicular (line_of v rho)) = perpendicular rho (tangent v).
Proof. unfold Corners.perpendicular, perpendicular. now rewrite vector_scale, normal_of_line. Qed.
Lemma tangents_meet_in_M u v rho rho' :
  vector (Corners.tangents_meet (line_of u rho) (line_of v rho')) = M rho (tangent u) (tangent v).
Proof.
  unfold Corners.tangents_meet, M. now rewrite vector_scale, vector_add, vector_dot, !normal_of_line, !unit_of_line.
Qed.
Lemma prolonged_in_Q u v rho vs : Corners.prolonged (line_of u rho) (line_of v rho) = Got vs ->
  map vector vs = [Q1 rho (tangent u); Q2 rho (tangent v)].
Proof.
  unfold Corners.prolonged; intro H. apply bound in H as (right & S & H). apply negative_sign in S.
  change (Corners.rho (line_of u rho)) with rho in *. unfold Q1, Q2.
  destruct right; apply same in H as <-; cbn [map];
    rewrite vector_add, vector_sub, !vector_scale, !perpendicular_of_line, !unit_of_line.
  - rewrite Rabs_left by (now apply S). repeat f_equal; cbn; ring.
  - rewrite Rabs_pos_eq; [reflexivity|]. pose proof (no_is _ _ S eq_refl). lra.
Qed.

(** * Groups *)

Lemma straight_on t1 t2 : direction t1 -> direction t2 -> turn t1 t2 = 0 -> 0 <= dot t1 t2 -> t2 = t1.
Proof.
  intros A B T D. pose proof (cosine_sine t1 t2 A B) as S. rewrite T in S. unfold Rsqr in S.
  assert (K : dot t1 t2 = 1) by nra.
  assert (O : t2 = opp (opp t1)).
  { apply opposite; [now apply opp_direction | exact B |]. clear - K. destruct t1, t2.
    unfold dot, opp, scale in *; cbn in *. lra. }
  rewrite O. destruct t1. unfold opp, scale; cbn. f_equal; ring.
Qed.

(** fanuc.cutter-c.outer-acute: the group between two lines is the one of the definitions. *)
Theorem mode_group_is_group u v rho vs : travels u -> travels v -> rho <> 0 ->
  Corners.mode_group (line_of u rho) (line_of v rho) = Got vs -> map vector vs = group rho (tangent u) (tangent v).
Proof.
  intros U V R H. destruct (by_tangents u v U V) as (k & K & T & D).
  pose proof (tangent_direction u U) as DU. pose proof (tangent_direction v V) as DV.
  unfold Corners.mode_group, Corners.corner_of in H. apply bound in H as (kind & C & H).
  apply bound in C as (side & S & C). apply decided in S.
  change (Corners.way (line_of u rho)) with u in *. change (Corners.way (line_of v rho)) with v in *.
  change (Corners.rho (line_of u rho)) with rho in *. rewrite T in S. rewrite D in C. cbn in S.
  unfold group. destruct side.
  - assert (Z : turn (tangent u) (tangent v) = 0).
    { apply Rmult_integral in S as [S|S]; [lra|]. apply Rmult_integral in S as [S|S]; lra. }
    apply bound in C as (back & B & C). apply negative_sign in B. apply same in C as <-.
    destruct (Rlt_dec 0 (rho * turn (tangent u) (tangent v))); [rewrite Z in *; lra|].
    destruct back.
    + assert (dot (tangent u) (tangent v) < 0) by (assert (k * dot (tangent u) (tangent v) < 0) by (now apply B); nra).
      destruct (Rle_dec 0 (dot (tangent u) (tangent v))); [lra|].
      apply bound in H as (both & P & H). apply same in H as <-. cbn. rewrite app_nil_r.
      now apply (prolonged_in_Q u v rho).
    + pose proof (no_is _ _ B eq_refl).
      assert (0 <= dot (tangent u) (tangent v)) by nra.
      destruct (Rle_dec 0 (dot (tangent u) (tangent v))); [|lra].
      apply same in H as <-. cbn [map]. rewrite perpendicular_of_line.
      now rewrite (straight_on (tangent u) (tangent v)), M_straight_on.
  - assert (rho * turn (tangent u) (tangent v) < 0) by nra.
    destruct (Rlt_dec 0 (rho * turn (tangent u) (tangent v))); [lra|].
    apply bound in C as (acute & B & C). apply negative_sign in B. apply same in C as <-.
    destruct acute.
    + assert (dot (tangent u) (tangent v) < 0) by (assert (k * dot (tangent u) (tangent v) < 0) by (now apply B); nra).
      destruct (Rle_dec 0 (dot (tangent u) (tangent v))); [lra|].
      apply bound in H as (both & P & H). apply same in H as <-. cbn. rewrite app_nil_r.
      now apply (prolonged_in_Q u v rho).
    + pose proof (no_is _ _ B eq_refl).
      assert (0 <= dot (tangent u) (tangent v)) by nra.
      destruct (Rle_dec 0 (dot (tangent u) (tangent v))); [|lra].
      apply same in H as <-. unfold Corners.of_arc.
      change (Corners.is_arc (line_of u rho)) with false. change (Corners.is_arc (line_of v rho)) with false.
      cbn [app map]. now rewrite tangents_meet_in_M.
  - assert (0 < rho * turn (tangent u) (tangent v)) by nra.
    destruct (Rlt_dec 0 (rho * turn (tangent u) (tangent v))); [|lra].
    apply same in C as <-. apply bound in H as (meeting & P & H).
    change (Corners.paths_meet (line_of u rho) (line_of v rho)) with
      (Got (Corners.MeetAt (Corners.tangents_meet (line_of u rho) (line_of v rho)))) in P.
    apply same in P as <-. apply same in H as <-. cbn [map]. now rewrite tangents_meet_in_M.
Qed.

Example mode_group_is_group_instance vs :
  Corners.mode_group (line_of (1, 0) 10) (line_of (0, -7) 10) = Got vs ->
  map vector vs = group 10 (tangent (1, 0)) (tangent (0, -7)).
Proof. apply mode_group_is_group; [left | right |]; cbn; lra. Qed.

(** fanuc.cutter-c.direction-change-lines: so is the vector of a change of direction between two lines at an angle. *)
Theorem direction_change_is_direction_change u v rho vs : Corners.aside u v <> 0 ->
  Corners.direction_change_group (line_of u rho) (line_of v (- rho)) = Got vs ->
  map vector vs = [direction_change rho (tangent u) (tangent v)].
Proof.
  intros N H. unfold Corners.direction_change_group in H. apply bound in H as (parallel_ & P & H). apply zero_sign in P.
  destruct parallel_; [destruct N; now apply P|].
  apply same in H as <-. cbn [map]. unfold direction_change.
  now rewrite vector_scale, vector_sub, vector_dot, !normal_of_line, !unit_of_line.
Qed.

Example direction_change_is_direction_change_instance vs :
  Corners.direction_change_group (line_of (3, 4) 10) (line_of (0, 7) (- (10))) = Got vs ->
  map vector vs = [direction_change 10 (tangent (3, 4)) (tangent (0, 7))].
Proof. apply direction_change_is_direction_change. cbn. unfold Arcs.cross2; cbn. lra. Qed.

(** * Intersections with an arc *)

(** fanuc.cutter-c.line-arc-point: and the point where an offset line meets an offset circle, for a centre that is not
    beside the corner. *)
Theorem line_meets_circle_is_line_circle_point t rho b r v : dot (vector (Corners.to_center b)) (tangent t) <> 0 ->
  Corners.line_meets_circle (line_of t rho) b r = Got (Corners.MeetAt v) ->
  vector v = line_circle_point rho (tangent t) (vector (Corners.to_center b)) r.
Proof.
  intros N H. unfold Corners.line_meets_circle in H. apply bound in H as (apart & A & H).
  destruct apart; [discriminate|]. apply bound in H as (behind & B & H). apply negative_sign in B.
  apply same in H. apply same_point in H as <-.
  rewrite vector_add, vector_scale, perpendicular_of_line, unit_of_line. unfold line_circle_point, line_circle_height.
  change (Corners.rho (line_of t rho)) with rho. rewrite vector_dot, unit_of_line in B.
  rewrite !vector_dot, normal_of_line, ?unit_of_line. unfold Rsqr.
  destruct (Rlt_dec 0 (dot (vector (Corners.to_center b)) (tangent t))).
  - destruct behind; [assert (dot (vector (Corners.to_center b)) (tangent t) < 0) by (now apply B); lra | reflexivity].
  - destruct behind; [reflexivity | pose proof (no_is _ _ B eq_refl); lra].
Qed.

Example line_meets_circle_is_line_circle_point_instance v :
  Corners.line_meets_circle (line_of (1, 0) 1) (Corners.Bow true (3, 1)) 2 = Got (Corners.MeetAt v) ->
  vector v = line_circle_point 1 (tangent (1, 0)) (Vec 3 1 0) 2.
Proof.
  apply (line_meets_circle_is_line_circle_point (1, 0) 1 (Corners.Bow true (3, 1))).
  rewrite tangent_values. cbn. replace (1 * 1 + 0 * 0) with 1 by ring. rewrite sqrt_1. unfold dot; cbn. lra.
Qed.

(** fanuc.cutter-c.arc-arc-point: and the one where two offset circles about different centres meet. *)
Theorem circles_meet_is_circles_point o1 r1 o2 r2 v : vector o2 <> vector o1 ->
  Corners.circles_meet o1 r1 o2 r2 = Got (Corners.MeetAt v) ->
  let side := if Rlt_dec (turn (sub (vector o2) (vector o1)) (opp (vector o1))) 0 then -1 else 1 in
  vector v = circles_point side (vector o1) (vector o2) r1 r2.
Proof.
  intros N H side. unfold Corners.circles_meet in H. cbv zeta in H.
  apply bound in H as (apart & _ & H). destruct apart; [discriminate|].
  apply bound in H as (nested & _ & H). destruct nested; [discriminate|].
  apply bound in H as (right & S & H). apply negative_sign in S. apply same in H. apply same_point in H as <-.
  assert (E : vector (Corners.subtract o2 o1) = sub (vector o2) (vector o1)) by apply vector_sub.
  assert (O : vector (Corners.opposite o1) = opp (vector o1)).
  { unfold Corners.opposite. rewrite vector_scale. unfold opp. f_equal. }
  rewrite vector_cross, E, O in S.
  unfold circles_point, circles_height2, circles_foot. rewrite !vector_add, !vector_scale, vector_left, E.
  unfold Corners.square_of. rewrite !vector_dot, E. set (e := sub (vector o2) (vector o1)) in *.
  assert (P : 0 < dot e e).
  { destruct (Rle_lt_or_eq_dec 0 (dot e e)) as [L|L]; [apply dot_self_nonneg | exact L |].
    exfalso. apply N. symmetry in L. apply dot_self_zero in L. unfold e in L. clear - L.
    destruct (vector o1) as [a b c], (vector o2) as [d f g]. unfold sub, add, opp, scale, zero in L; cbn in L.
    injection L; intros; f_equal; lra. }
  cbn [Numbers.over Numbers.minus Numbers.plus Numbers.times Numbers.root Numbers.integer Numbers.reals].
  set (a := (dot e e + r1 * r1 - r2 * r2) / (2 * dot e e)). set (h := r1 * r1 - a * a * dot e e).
  change ((dot e e + r1² - r2²) / (2 * dot e e)) with a. change (r1² - a² * dot e e) with h.
  assert (K : (if right then 0 - sqrt (h / dot e e) else sqrt (h / dot e e)) = side * (sqrt h / norm e)).
  { unfold norm. rewrite sqrt_div_alt by exact P. subst side.
    destruct (Rlt_dec (turn e (opp (vector o1))) 0) as [L|L]; destruct right; try ring.
    - apply (no_is _ _ S eq_refl) in L. contradiction.
    - exfalso. apply L, S. reflexivity. }
  now rewrite K.
Qed.

Example circles_meet_is_circles_point_instance v :
  Corners.circles_meet (0, 3) 3 (4, 3) 2 = Got (Corners.MeetAt v) ->
  vector v = circles_point (if Rlt_dec (turn (sub (Vec 4 3 0) (Vec 0 3 0)) (opp (Vec 0 3 0))) 0 then -1 else 1)
    (Vec 0 3 0) (Vec 4 3 0) 3 2.
Proof. apply (circles_meet_is_circles_point (0, 3) 3 (4, 3) 2). unfold vector; cbn. intro H. injection H. lra. Qed.
