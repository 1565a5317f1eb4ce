(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-center-point-control: the direction of the tool on heads, tables and mixed machines, its inverse, the
    control point, and the path of the tip on a table.

    [ut], [uw]: axis on the tool side and on the work side, [t0]: the tool with both at 0, all of length 1; [tau], [omega]:
    their angles, senses included, in radians. *)
From Coq Require Import Reals Lra Psatz.
From Toolcomp Require Import Vectors ToolDirection.
Open Scope R_scope.

(** * Definitions *)

Definition is_unit u := dot u u = 1.

(** The direction of the tool, seen from the work. *)
Definition V ut uw t0 tau omega := rotate uw omega (rotate ut tau t0).

(** The same from the machine: first axis [u1] with sense [s1] at [a1], second likewise. On a head the first carries the
    second; on a table the work is turned by the second and carried by the first; on a mixed machine the first turns the
    tool, the second the work. *)
Definition head u1 s1 a1 u2 s2 a2 t0 := rotate u1 (s1 * a1) (rotate u2 (s2 * a2) t0).
Definition turned_work u1 s1 a1 u2 s2 a2 v := rotate u1 (s1 * a1) (rotate u2 (s2 * a2) v).
Definition table u1 s1 a1 u2 s2 a2 t0 := rotate u2 (- (s2 * a2)) (rotate u1 (- (s1 * a1)) t0).
Definition mixed u1 s1 a1 u2 s2 a2 t0 := rotate u2 (- (s2 * a2)) (rotate u1 (s1 * a1) t0).

(** The angle of the point (x, y), from -pi to pi. *)
Definition atan2 y x :=
  if Rle_dec 0 y then acos (x / sqrt (x * x + y * y)) else - acos (x / sqrt (x * x + y * y)).

(** The inverse for axes of any inclination: the part of the tool along its axis and across it, their heights along the
    work-side axis, and the two roots [e] = 1 and [e] = -1. *)
Definition along ut t0 := scale (dot t0 ut) ut.
Definition A ut uw t0 := dot uw (sub t0 (along ut t0)).
Definition B ut uw t0 := dot uw (cross ut t0).
Definition C ut uw t0 v := dot uw v - dot uw (along ut t0).
Definition rho ut uw t0 := sqrt (A ut uw t0 * A ut uw t0 + B ut uw t0 * B ut uw t0).
Definition inverse_tau e ut uw t0 v := atan2 (B ut uw t0) (A ut uw t0) + e * acos (C ut uw t0 v / rho ut uw t0).
Definition carrying uw w v := atan2 (dot uw (cross w v)) (dot w v - dot uw w * dot uw v).
Definition inverse_omega e ut uw t0 v := carrying uw (rotate ut (inverse_tau e ut uw t0 v) t0) v.

(** Control point of a head without offsets, and the points D and E and F with them. *)
Definition head_control_point T L v := add T (scale L v).
Definition head_F u1 a1 u2 a2 t0 T L dDE dEF :=
  add (add (add T (scale L (rotate u1 a1 (rotate u2 a2 t0)))) (rotate u1 a1 (rotate u2 a2 dDE))) (rotate u1 a1 dEF).

(** A point fixed to a table, by its place in the machine, and back: [O] on the first axis, [d] from there to the second. *)
Definition on_table u1 a1 u2 a2 O d X := rotate u2 (- a2) (sub (rotate u1 (- a1) (sub X O)) d).
Definition in_machine u1 a1 u2 a2 O d q := add O (rotate u1 a1 (add d (rotate u2 a2 q))).

(** A point on the way from [P] to [Q]. *)
Definition on_line t P Q := add (scale (1 - t) P) (scale t Q).

(** The tool leaned by [Q] from [v] toward the travel [d]. *)
Definition lean Q v d := rotate (scale (/ norm (cross v d)) (cross v d)) Q v.

(** * Basic facts *)

Lemma cos_sin_square a : cos a * cos a = 1 - sin a * sin a.
Proof. exact (cos_sin_unit a). Qed.

Lemma unit_nonzero u : is_unit u -> u <> zero.
Proof. intros U E; subst; unfold is_unit, dot, zero in U; cbn in U; lra. Qed.

Lemma norm_unit u : is_unit u -> norm u = 1.
Proof. intro U; unfold norm; rewrite U; apply sqrt_1. Qed.

Lemma rotate_zero k v : rotate k 0 v = v.
Proof. unfold rotate; rewrite cos_0, sin_0; vec_ring. Qed.

Lemma rotate_back k a v : is_unit k -> rotate k (- a) (rotate k a v) = v.
Proof. intro K; rewrite rotate_twice, Rplus_opp_r by exact K; apply rotate_zero. Qed.

Lemma rotate_forth k a v : is_unit k -> rotate k a (rotate k (- a) v) = v.
Proof. intro K; rewrite rotate_twice, Rplus_opp_l by exact K; apply rotate_zero. Qed.

Lemma rotate_add k a u v : rotate k a (add u v) = add (rotate k a u) (rotate k a v).
Proof. unfold rotate; set (c := cos a); set (s := sin a); vec_ring. Qed.

Lemma rotate_scale k a x v : rotate k a (scale x v) = scale x (rotate k a v).
Proof. unfold rotate; set (c := cos a); set (s := sin a); vec_ring. Qed.

Lemma rotate_sub k a u v : rotate k a (sub u v) = sub (rotate k a u) (rotate k a v).
Proof. unfold sub, opp; rewrite rotate_add, rotate_scale; reflexivity. Qed.

Lemma rotate_axis k a : is_unit k -> rotate k a k = k.
Proof.
  intro K. unfold rotate. replace (dot k k) with 1. replace (cross k k) with zero by vec_ring. vec_ring.
Qed.

Lemma rotate_norm k a v : is_unit k -> norm (rotate k a v) = norm v.
Proof. intro K; unfold norm; rewrite rotate_dot by exact K; reflexivity. Qed.

(** What the rotation does along its axis. *)
Lemma rotate_keeps_height k a v : is_unit k -> dot k (rotate k a v) = dot k v.
Proof. intro K; rewrite <- (rotate_axis k a K) at 1; apply rotate_dot, K. Qed.

Lemma cos_acos_square c : -1 <= c <= 1 -> sin (acos c) * sin (acos c) = 1 - c * c.
Proof. intro H; pose proof (cos_sin_square (acos c)) as E; rewrite (cos_acos c H) in E; lra. Qed.

Lemma hypotenuse x y : sqrt (x * x + y * y) * sqrt (x * x + y * y) = x * x + y * y.
Proof. apply sqrt_sqrt; nra. Qed.

Lemma component_bound x y : 0 < sqrt (x * x + y * y) -> -1 <= x / sqrt (x * x + y * y) <= 1.
Proof.
  intro P. pose proof (hypotenuse x y) as H. set (h := sqrt (x * x + y * y)) in *.
  assert (- h <= x <= h) by (split; nra).
  split; apply (Rmult_le_reg_r h); auto; unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
Qed.

(** The point is its distance times (cos, sin) of its angle. *)
Lemma cos_atan2 y x : sqrt (x * x + y * y) * cos (atan2 y x) = x.
Proof.
  pose proof (hypotenuse x y) as H. pose proof (sqrt_pos (x * x + y * y)) as P.
  destruct (Req_dec (sqrt (x * x + y * y)) 0) as [Z | N]; [rewrite Z in *; nra |].
  pose proof (component_bound x y ltac:(lra)) as W.
  unfold atan2; destruct (Rle_dec 0 y); rewrite ?cos_neg, cos_acos by exact W; field; exact N.
Qed.

Lemma sin_atan2 y x : sqrt (x * x + y * y) * sin (atan2 y x) = y.
Proof.
  pose proof (hypotenuse x y) as H. pose proof (sqrt_pos (x * x + y * y)) as P.
  destruct (Req_dec (sqrt (x * x + y * y)) 0) as [Z | N]; [rewrite Z in *; nra |].
  pose proof (component_bound x y ltac:(lra)) as W.
  pose proof (cos_acos_square _ W) as Q.
  assert (S : 0 <= sin (acos (x / sqrt (x * x + y * y)))) by (apply sin_ge_0; apply acos_bound).
  set (h := sqrt (x * x + y * y)) in *. set (s := sin (acos (x / h))) in *.
  assert (E : (h * s) * (h * s) = y * y).
  { replace ((h * s) * (h * s)) with (h * h * (s * s)) by ring. rewrite Q.
    replace (h * h * (1 - x / h * (x / h))) with (h * h - x * x) by (field; exact N). lra. }
  assert (G : 0 <= h * s) by (apply Rmult_le_pos; assumption).
  unfold atan2; fold h; destruct (Rle_dec 0 y) as [L | L]; rewrite ?sin_neg; fold s.
  - apply Rsqr_inj; [exact G | exact L | exact E].
  - assert (K : h * s = - y) by (apply Rsqr_inj; [exact G | lra | rewrite <- Rsqr_neg; exact E]). lra.
Qed.

(** Turning the point (x, y) by the difference of two angles takes it to a point at the same distance. *)
Lemma turn_to x y x' y' : x * x + y * y = x' * x' + y' * y' ->
  let a := atan2 y x - atan2 y' x' in cos a * x' - sin a * y' = x /\ sin a * x' + cos a * y' = y.
Proof.
  intros E a. pose proof (cos_atan2 y x) as C1; pose proof (sin_atan2 y x) as S1.
  pose proof (cos_atan2 y' x') as C2; pose proof (sin_atan2 y' x') as S2.
  rewrite <- E in C2, S2. set (h := sqrt (x * x + y * y)) in *.
  pose proof (cos_sin_square (atan2 y' x')) as Q.
  unfold a; rewrite cos_minus, sin_minus.
  set (c := cos (atan2 y x)) in *; set (s := sin (atan2 y x)) in *.
  set (c' := cos (atan2 y' x')) in *; set (s' := sin (atan2 y' x')) in *.
  rewrite <- C2, <- S2, <- C1, <- S1. split.
  - replace ((c * c' + s * s') * (h * c') - (s * c' - c * s') * (h * s')) with (h * c * (c' * c' + s' * s')) by ring.
    rewrite Q; ring.
  - replace ((s * c' - c * s') * (h * c') + (c * c' + s * s') * (h * s')) with (h * s * (c' * c' + s' * s')) by ring.
    rewrite Q; ring.
Qed.

Lemma within x r : Rabs x <= r -> - r <= x <= r.
Proof. unfold Rabs; destruct (Rcase_abs x); lra. Qed.

Lemma square_bound x r : 0 <= r -> x * x <= r * r -> - r <= x <= r.
Proof. intros; split; nra. Qed.

Lemma there_and_back u v : add u (sub v u) = v.
Proof. vec_ring. Qed.

Lemma back_and_there u v : sub (add u v) u = v.
Proof. vec_ring. Qed.

Lemma sin_signed e a : e = 1 \/ e = -1 -> sin (e * a) = e * sin a.
Proof.
  intros [E | E]; subst; [rewrite !Rmult_1_l; reflexivity |].
  replace (-1 * a) with (- a) by ring; rewrite sin_neg; ring.
Qed.

Lemma cos_signed e a : e = 1 \/ e = -1 -> cos (e * a) = cos a.
Proof.
  intros [E | E]; subst; [rewrite Rmult_1_l; reflexivity |].
  replace (-1 * a) with (- a) by ring; apply cos_neg.
Qed.

Ltac numbers := unfold is_unit, dot, cross, sub, opp, add, scale, zero, ex, ey, ez in *; cbn [vx vy vz] in *.

(** * One formula for the three types of machine *)

(** fanuc.tool-center-point.frozen-pose: the direction seen from the table, turned with the work, is the reference direction
    of the machine, in which the tool of a table machine so starts. *)
Theorem table_in_machine u1 s1 a1 u2 s2 a2 t0 : is_unit u1 -> is_unit u2 ->
  turned_work u1 s1 a1 u2 s2 a2 (table u1 s1 a1 u2 s2 a2 t0) = t0.
Proof. intros U1 U2; unfold turned_work, table; rewrite !rotate_forth by assumption; reflexivity. Qed.

Example table_in_machine_instance : turned_work ex (-1) 1 ez (-1) 2 (table ex (-1) 1 ez (-1) 2 ez) = ez.
Proof. apply table_in_machine; numbers; lra. Qed.

(** fanuc.tool-direction.mechanism: with the usual senses (tool right-handed, table left-handed) a head, a table and a
    mixed machine with the same axes on tool and work side point alike. *)
Theorem machines_share_V ut uw t0 tau omega :
  head uw 1 omega ut 1 tau t0 = V ut uw t0 tau omega /\
  table ut (-1) tau uw (-1) omega t0 = V ut uw t0 tau omega /\
  mixed ut 1 tau uw (-1) omega t0 = V ut uw t0 tau omega.
Proof. unfold head, table, mixed, V; repeat split; repeat f_equal; ring. Qed.

Example machines_share_V_instance : table ex (-1) 1 ez (-1) 2 ez = head ez 1 2 ex 1 1 ez.
Proof. destruct (machines_share_V ex ez ez 1 2) as (H & T & M); congruence. Qed.

(** fanuc.tool-center-point.inverse: turning work and program about the work-side axis shifts its position and nothing
    else. *)
Theorem work_turned ut uw t0 tau omega phi : is_unit uw ->
  V ut uw t0 tau (omega + phi) = rotate uw phi (V ut uw t0 tau omega).
Proof. intro U; unfold V; rewrite rotate_twice by exact U; reflexivity. Qed.

Example work_turned_instance : V ey ez ez 1 (2 + 3) = rotate ez 3 (V ey ez ez 1 2).
Proof. apply work_turned; numbers; lra. Qed.

(** fanuc.tool-center-point.parallel-to-the-work-side: where the tool is parallel to the work-side axis, that axis may
    stand anywhere. *)
Theorem any_work_side ut uw t0 tau omega omega' : is_unit uw -> parallel (V ut uw t0 tau omega) uw ->
  V ut uw t0 tau omega' = V ut uw t0 tau omega.
Proof.
  intros U P. replace omega' with (omega + (omega' - omega)) by ring. rewrite work_turned by exact U.
  apply parallel_multiple in P; [| apply unit_nonzero, U]. destruct P as [k E].
  rewrite E, rotate_scale, rotate_axis by exact U; reflexivity.
Qed.

Example any_work_side_instance : V ey ez ez 0 1 = V ey ez ez 0 2.
Proof.
  apply any_work_side; [numbers; lra |]. unfold V; rewrite rotate_zero, rotate_axis by (numbers; lra).
  unfold parallel; vec_ring.
Qed.

(** * Closed forms of machines with orthogonal axes, and their inverses *)

(** fanuc.tool-center-point.inverse: B on the tool side, C on the work side; both pairs. *)
Theorem inverse_BC e v : is_unit v -> e = 1 \/ e = -1 ->
  V ey ez ez (e * acos (vz v)) (atan2 (e * vy v) (e * vx v)) = v.
Proof.
  intros U E. destruct v as [i j k]; cbn [vx vy vz].
  assert (K : -1 <= k <= 1) by (numbers; nra).
  assert (S : sin (e * acos k) = e * sqrt (e * i * (e * i) + e * j * (e * j))).
  { replace (e * i * (e * i) + e * j * (e * j)) with (1 - k²) by (unfold Rsqr; numbers; destruct E; subst; nra).
    rewrite <- (sin_acos k K). apply sin_signed, E. }
  assert (D : cos (e * acos k) = k).
  { rewrite cos_signed by exact E. apply cos_acos, K. }
  unfold V. rewrite rotate_about_z, rotate_about_y. cbn [vx vy vz ez]. rewrite S, D.
  pose proof (cos_atan2 (e * j) (e * i)) as X. pose proof (sin_atan2 (e * j) (e * i)) as Y.
  f_equal; destruct E; subst; nra.
Qed.

Example inverse_BC_instance : V ey ez ez (-1 * acos (4/5)) (atan2 (-1 * (3/5)) (-1 * 0)) = Vec 0 (3/5) (4/5).
Proof. apply (inverse_BC (-1) (Vec 0 (3/5) (4/5))); [numbers; lra | right; reflexivity]. Qed.

(** fanuc.tool-center-point.inverse: A on the tool side, C on the work side; both pairs. *)
Theorem inverse_AC e v : is_unit v -> e = 1 \/ e = -1 ->
  V ex ez ez (e * acos (vz v)) (atan2 (e * vx v) (- (e * vy v))) = v.
Proof.
  intros U E. destruct v as [i j k]; cbn [vx vy vz].
  assert (K : -1 <= k <= 1) by (numbers; nra).
  assert (S : sin (e * acos k) = e * sqrt (- (e * j) * - (e * j) + e * i * (e * i))).
  { replace (- (e * j) * - (e * j) + e * i * (e * i)) with (1 - k²) by (unfold Rsqr; numbers; destruct E; subst; nra).
    rewrite <- (sin_acos k K). apply sin_signed, E. }
  assert (D : cos (e * acos k) = k) by (rewrite cos_signed by exact E; apply cos_acos, K).
  unfold V. rewrite rotate_about_z, rotate_about_x. cbn [vx vy vz ez]. rewrite S, D.
  pose proof (cos_atan2 (e * i) (- (e * j))) as X. pose proof (sin_atan2 (e * i) (- (e * j))) as Y.
  f_equal; destruct E; subst; nra.
Qed.

Example inverse_AC_instance : V ex ez ez (1 * acos (4/5)) (atan2 (1 * (3/5)) (- (1 * 0))) = Vec (3/5) 0 (4/5).
Proof. apply (inverse_AC 1 (Vec (3/5) 0 (4/5))); [numbers; lra | left; reflexivity]. Qed.

(** The position with sine [y] that [e] = 1 leaves as it is and [e] = -1 mirrors: asin y, pi - asin y. *)
Definition supplement e y := if Rlt_dec 0 e then asin y else PI - asin y.

Lemma sin_supplement e y : -1 <= y <= 1 -> sin (supplement e y) = y.
Proof.
  intro Y; unfold supplement; destruct (Rlt_dec 0 e); [apply sin_asin, Y |].
  rewrite sin_PI_x. apply sin_asin, Y.
Qed.

Lemma cos_supplement e y : e = 1 \/ e = -1 -> -1 <= y <= 1 -> cos (supplement e y) = e * sqrt (1 - y²).
Proof.
  intros E Y; rewrite <- (cos_asin y Y); unfold supplement; destruct (Rlt_dec 0 e); destruct E; subst; try lra.
  replace (PI - asin y) with (- (asin y - PI)) by ring. rewrite cos_neg, cos_minus, cos_PI, sin_PI; ring.
Qed.

(** fanuc.tool-center-point.inverse: A on the tool side, B on the work side; both pairs. *)
Theorem inverse_AB e v : is_unit v -> e = 1 \/ e = -1 ->
  V ex ey ez (supplement e (- vy v)) (atan2 (e * vx v) (e * vz v)) = v.
Proof.
  intros U E. destruct v as [i j k]; cbn [vx vy vz].
  assert (J : -1 <= - j <= 1) by (numbers; nra).
  unfold V. rewrite rotate_about_y, rotate_about_x. cbn [vx vy vz ez].
  rewrite sin_supplement, (cos_supplement e) by assumption.
  replace (1 - (- j)²) with (e * k * (e * k) + e * i * (e * i)) by (unfold Rsqr; numbers; destruct E; subst; nra).
  pose proof (cos_atan2 (e * i) (e * k)) as X. pose proof (sin_atan2 (e * i) (e * k)) as Y.
  f_equal; destruct E; subst; nra.
Qed.

Example inverse_AB_instance : V ex ey ez (supplement (-1) (- (3/5))) (atan2 (-1 * 0) (-1 * (4/5))) = Vec 0 (3/5) (4/5).
Proof. apply (inverse_AB (-1) (Vec 0 (3/5) (4/5))); [numbers; lra | right; reflexivity]. Qed.

(** fanuc.tool-center-point.inverse: B on the tool side, A on the work side; both pairs. *)
Theorem inverse_BA e v : is_unit v -> e = 1 \/ e = -1 ->
  V ey ex ez (supplement e (vx v)) (atan2 (- (e * vy v)) (e * vz v)) = v.
Proof.
  intros U E. destruct v as [i j k]; cbn [vx vy vz].
  assert (I : -1 <= i <= 1) by (numbers; nra).
  unfold V. rewrite rotate_about_x, rotate_about_y. cbn [vx vy vz ez].
  rewrite sin_supplement, (cos_supplement e) by assumption.
  replace (1 - i²) with (e * k * (e * k) + - (e * j) * - (e * j)) by (unfold Rsqr; numbers; destruct E; subst; nra).
  pose proof (cos_atan2 (- (e * j)) (e * k)) as X. pose proof (sin_atan2 (- (e * j)) (e * k)) as Y.
  f_equal; destruct E; subst; nra.
Qed.

Example inverse_BA_instance : V ey ex ez (supplement 1 (3/5)) (atan2 (- (1 * 0)) (1 * (4/5))) = Vec (3/5) 0 (4/5).
Proof. apply (inverse_BA 1 (Vec (3/5) 0 (4/5))); [numbers; lra | left; reflexivity]. Qed.

(** An axis inclined by 45 degrees from Y to Z. *)
Definition nutating := Vec 0 (/ sqrt 2) (/ sqrt 2).

Lemma half_sqrt : / sqrt 2 * / sqrt 2 = / 2.
Proof. rewrite <- Rinv_mult. rewrite sqrt_sqrt by lra; reflexivity. Qed.

(** fanuc.tool-center-point.inverse: the direction of a nutating tool side. *)
Theorem nutating_direction tau :
  rotate nutating tau ez = Vec (sin tau * / sqrt 2) ((1 - cos tau) / 2) ((1 + cos tau) / 2).
Proof.
  pose proof half_sqrt as H. unfold rotate, nutating. set (c := cos tau); set (s := sin tau). set (h := / sqrt 2) in *.
  numbers. f_equal.
  - ring.
  - transitivity ((1 - c) * (h * h)); [ring | rewrite H; field].
  - transitivity (c + (1 - c) * (h * h)); [ring | rewrite H; field].
Qed.

Example nutating_direction_instance : rotate nutating 0 ez = ez.
Proof. rewrite nutating_direction, sin_0, cos_0; unfold ez; f_equal; lra. Qed.

(** fanuc.tool-center-point.inverse: the pairs of a nutating tool side, C on the work side; the tool reaches the upper half
    sphere. *)
Theorem inverse_nutating e v : is_unit v -> 0 <= vz v -> e = 1 \/ e = -1 ->
  let tau := e * acos (2 * vz v - 1) in
  V nutating ez ez tau (atan2 (vy v) (vx v) - atan2 ((1 - cos tau) / 2) (sin tau * / sqrt 2)) = v.
Proof.
  intros U P E tau. destruct v as [i j k]; cbn [vx vy vz] in *.
  assert (K : -1 <= 2 * k - 1 <= 1) by (numbers; split; nra).
  assert (D : cos tau = 2 * k - 1) by (unfold tau; rewrite cos_signed by exact E; apply cos_acos, K).
  assert (S : sin tau * sin tau = 1 - (2 * k - 1) * (2 * k - 1)).
  { unfold tau; rewrite sin_signed by exact E. pose proof (cos_acos_square _ K). destruct E; subst; nra. }
  pose proof half_sqrt as H.
  unfold V. rewrite nutating_direction, rotate_about_z. cbn [vx vy vz].
  set (w := sin tau * / sqrt 2) in *.
  assert (W : w * w = 2 * k - 2 * k * k).
  { unfold w. replace (sin tau * / sqrt 2 * (sin tau * / sqrt 2)) with (sin tau * sin tau * (/ sqrt 2 * / sqrt 2)) by ring.
    rewrite S, H; lra. }
  rewrite D. set (z := (1 - (2 * k - 1)) / 2). assert (Z : z = 1 - k) by (unfold z; lra).
  destruct (turn_to i j w z) as [X Y]; [rewrite Z; numbers; nra |].
  rewrite X, Y. f_equal; lra.
Qed.

Example inverse_nutating_instance :
  let tau := 1 * acos (2 * (4/5) - 1) in
  V nutating ez ez tau (atan2 0 (3/5) - atan2 ((1 - cos tau) / 2) (sin tau * / sqrt 2)) = Vec (3/5) 0 (4/5).
Proof. apply (inverse_nutating 1 (Vec (3/5) 0 (4/5))); [numbers; lra | cbn; lra | left; reflexivity]. Qed.

(** * The inverse for axes of any inclination *)

(** The height of the tool along the work-side axis swings as the tool-side axis turns. *)
Lemma height_swings ut uw t0 tau :
  dot uw (rotate ut tau t0) = dot uw (along ut t0) + (A ut uw t0 * cos tau + B ut uw t0 * sin tau).
Proof. unfold rotate, A, B, along. set (c := cos tau); set (s := sin tau). vec_ring. Qed.

(** Turning about [u] takes a direction to any other of the same height. *)
Lemma carried u w v : is_unit u -> is_unit w -> is_unit v -> dot u w = dot u v -> rotate u (carrying u w v) w = v.
Proof.
  intros U W W' H.
  set (m := 1 - dot u w * dot u w).
  assert (X : dot u (cross w v) * dot u (cross w v) = m * m - (dot w v - dot u w * dot u v) * (dot w v - dot u w * dot u v)).
  { assert (G : dot u (cross w v) * dot u (cross w v) =
      dot u u * dot w w * dot v v + 2 * dot u w * dot w v * dot u v
      - dot u u * (dot w v * dot w v) - dot w w * (dot u v * dot u v) - dot v v * (dot u w * dot u w)) by vec_ring.
    rewrite G, U, W, W'. unfold m; rewrite <- H; ring. }
  assert (M : 0 <= m).
  { unfold m. pose proof (dot_bound u w) as Bd. unfold Rsqr in Bd. rewrite U, W in Bd. lra. }
  unfold carrying. set (y := dot u (cross w v)) in *. set (x := dot w v - dot u w * dot u v) in *.
  assert (R : sqrt (x * x + y * y) = m).
  { replace (x * x + y * y) with (m * m) by lra. apply sqrt_square, M. }
  pose proof (cos_atan2 y x) as Cx; pose proof (sin_atan2 y x) as Sx. rewrite R in Cx, Sx.
  set (a := atan2 y x) in *. unfold rotate. set (c := cos a) in *; set (s := sin a) in *.
  destruct (Req_dec m 0) as [Z | N].
  - (* both are the axis itself *)
    assert (P : sub w (scale (dot u w) u) = zero).
    { apply dot_self_zero. transitivity (dot w w - 2 * (dot u w * dot u w) + dot u w * dot u w * dot u u); [vec_ring |].
      rewrite U, W. unfold m in Z; lra. }
    assert (P' : sub v (scale (dot u w) u) = zero).
    { apply dot_self_zero. transitivity (dot v v - 2 * (dot u w * dot u v) + dot u w * dot u w * dot u u); [vec_ring |].
      rewrite U, W', <- H. unfold m in Z; lra. }
    assert (E : w = scale (dot u w) u).
    { transitivity (add (sub w (scale (dot u w) u)) (scale (dot u w) u)); [vec_ring | rewrite P; vec_ring]. }
    assert (E' : v = scale (dot u w) u).
    { transitivity (add (sub v (scale (dot u w) u)) (scale (dot u w) u)); [vec_ring | rewrite P'; vec_ring]. }
    rewrite E' at 1. set (k := dot u w) in *. clearbody k. rewrite E. vec_ring.
  - (* m v in the frame of u, the rest of w, and their cross product *)
    assert (L : scale m (add (scale c w) (add (scale s (cross u w)) (scale ((1 - c) * dot u w) u))) = scale m v).
    { transitivity (add (scale (m * c) w) (add (scale (m * s) (cross u w)) (scale ((m - m * c) * dot u w) u))); [vec_ring |].
      rewrite Cx, Sx.
      assert (G : add (scale (dot w v * dot u u - dot u w * dot u v) w)
                  (add (scale (dot u (cross w v)) (cross u w)) (scale (dot u v * dot w w - dot u w * dot w v) u)) =
                  scale (dot u u * dot w w - dot u w * dot u w) v) by vec_ring.
      rewrite U, W in G. fold y in G. fold m in G.
      replace (scale m v) with (scale (1 * 1 - dot u w * dot u w) v) by (unfold m; f_equal; ring).
      rewrite <- G. unfold x. f_equal; [f_equal; ring |]. f_equal. f_equal. unfold m. rewrite <- H. ring. }
    transitivity (scale (/ m) (scale m (add (scale c w) (add (scale s (cross u w)) (scale ((1 - c) * dot u w) u))))).
    + rewrite scale_scale, Rinv_l by exact N. rewrite scale_one; reflexivity.
    + rewrite L, scale_scale, Rinv_l by exact N. apply scale_one.
Qed.

Lemma rho_square ut uw t0 : rho ut uw t0 * rho ut uw t0 = A ut uw t0 * A ut uw t0 + B ut uw t0 * B ut uw t0.
Proof. apply hypotenuse. Qed.

(** The tool side at both roots has the height that is asked for. *)
Lemma root_height e ut uw t0 v : e = 1 \/ e = -1 -> 0 < rho ut uw t0 -> Rabs (C ut uw t0 v) <= rho ut uw t0 ->
  dot uw (rotate ut (inverse_tau e ut uw t0 v) t0) = dot uw v.
Proof.
  intros E P Q. rewrite height_swings. unfold inverse_tau.
  set (c := acos (C ut uw t0 v / rho ut uw t0)). set (g := atan2 (B ut uw t0) (A ut uw t0)).
  pose proof (cos_atan2 (B ut uw t0) (A ut uw t0)) as X. pose proof (sin_atan2 (B ut uw t0) (A ut uw t0)) as Y.
  fold (rho ut uw t0) in X, Y. fold g in X, Y.
  assert (D : rho ut uw t0 * cos c = C ut uw t0 v).
  { unfold c. rewrite cos_acos; [field; lra |].
    apply within in Q. split; apply (Rmult_le_reg_r (rho ut uw t0)); auto;
      unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra. }
  rewrite cos_plus, sin_plus, (cos_signed e c E), (sin_signed e c E).
  pose proof (cos_sin_square g) as G. unfold C in D. set (r := rho ut uw t0) in *.
  rewrite <- X, <- Y.
  transitivity (dot uw (along ut t0) + r * cos c * (cos g * cos g + sin g * sin g)); [ring |].
  rewrite G. lra.
Qed.

(** fanuc.tool-center-point.inverse: both roots of the general form point along the direction that is asked for. *)
Theorem forward_of_inverse e ut uw t0 v : is_unit ut -> is_unit uw -> is_unit t0 -> is_unit v -> e = 1 \/ e = -1 ->
  0 < rho ut uw t0 -> Rabs (C ut uw t0 v) <= rho ut uw t0 ->
  V ut uw t0 (inverse_tau e ut uw t0 v) (inverse_omega e ut uw t0 v) = v.
Proof.
  intros Ut Uw U0 Uv E P Q. unfold V, inverse_omega. apply carried; auto.
  - unfold is_unit; rewrite rotate_dot by exact Ut; exact U0.
  - apply root_height; assumption.
Qed.

Lemma rho_BC : rho ey ez ez = 1.
Proof.
  assert (X : A ey ez ez = 1) by (unfold A, along; numbers; ring).
  assert (Y : B ey ez ez = 0) by (unfold B; numbers; ring).
  unfold rho; rewrite X, Y. replace (1 * 1 + 0 * 0) with 1 by ring. apply sqrt_1.
Qed.

Example forward_of_inverse_instance :
  V ey ez ez (inverse_tau (-1) ey ez ez (Vec 0 (3/5) (4/5)))
    (inverse_omega (-1) ey ez ez (Vec 0 (3/5) (4/5))) = Vec 0 (3/5) (4/5).
Proof.
  apply forward_of_inverse; rewrite ?rho_BC; try (numbers; lra).
  unfold C, along; numbers. apply Rabs_le; lra.
Qed.

(** fanuc.tool-center-point.unreachable: a direction is pointed along by some position exactly where |C| <= rho. *)
Theorem reachable_iff ut uw t0 v : is_unit ut -> is_unit uw -> is_unit t0 -> is_unit v -> 0 < rho ut uw t0 ->
  (exists tau omega, V ut uw t0 tau omega = v) <-> Rabs (C ut uw t0 v) <= rho ut uw t0.
Proof.
  intros Ut Uw U0 Uv P; split.
  - intros (tau & omega & E).
    assert (H : C ut uw t0 v = A ut uw t0 * cos tau + B ut uw t0 * sin tau).
    { unfold C. rewrite <- E. unfold V. rewrite rotate_keeps_height, height_swings by exact Uw; ring. }
    apply Rabs_le. pose proof (rho_square ut uw t0) as R. pose proof (cos_sin_square tau) as Q.
    rewrite H. set (a := A ut uw t0) in *; set (b := B ut uw t0) in *; set (r := rho ut uw t0) in *.
    set (c := cos tau) in *; set (s := sin tau) in *.
    assert (L : (a * c + b * s) * (a * c + b * s) + (a * s - b * c) * (a * s - b * c) = r * r).
    { rewrite R. transitivity ((a * a + b * b) * (c * c + s * s)); [ring | rewrite Q; ring]. }
    apply square_bound; [lra |]. pose proof (Rle_0_sqr (a * s - b * c)) as Z. unfold Rsqr in Z. lra.
  - intro Q. exists (inverse_tau 1 ut uw t0 v), (inverse_omega 1 ut uw t0 v). apply forward_of_inverse; auto.
Qed.

Example reachable_iff_instance : exists tau omega, V ey ez ez tau omega = Vec 0 (3/5) (4/5).
Proof.
  apply reachable_iff; rewrite ?rho_BC; try (numbers; lra).
  unfold C, along; numbers. apply Rabs_le; lra.
Qed.

(** fanuc.tool-center-point.choice: there are no other pairs: a position that points along v stands at one of the two
    roots. *)
Theorem roots_are_all ut uw t0 v tau omega : is_unit uw -> 0 < rho ut uw t0 -> V ut uw t0 tau omega = v ->
  exists e, (e = 1 \/ e = -1) /\
    cos tau = cos (inverse_tau e ut uw t0 v) /\ sin tau = sin (inverse_tau e ut uw t0 v).
Proof.
  intros Uw P E.
  assert (H : C ut uw t0 v = A ut uw t0 * cos tau + B ut uw t0 * sin tau).
  { unfold C. rewrite <- E. unfold V. rewrite rotate_keeps_height, height_swings by exact Uw; ring. }
  pose proof (cos_atan2 (B ut uw t0) (A ut uw t0)) as X. pose proof (sin_atan2 (B ut uw t0) (A ut uw t0)) as Y.
  fold (rho ut uw t0) in X, Y. unfold inverse_tau.
  set (g := atan2 (B ut uw t0) (A ut uw t0)) in *. set (r := rho ut uw t0) in *.
  assert (D : C ut uw t0 v / r = cos (tau - g)).
  { rewrite H, <- X, <- Y, cos_minus. field; lra. }
  rewrite D. pose proof (COS_bound (tau - g)) as Bd. pose proof (cos_acos _ Bd) as K.
  set (c := acos (cos (tau - g))) in *.
  assert (S2 : sin c * sin c = sin (tau - g) * sin (tau - g)).
  { pose proof (cos_sin_square c). pose proof (cos_sin_square (tau - g)). rewrite K in *. lra. }
  assert (F : exists e, (e = 1 \/ e = -1) /\ sin (tau - g) = e * sin c).
  { destruct (Rle_dec 0 (sin (tau - g) * sin c)) as [L | L].
    - exists 1; split; [left; reflexivity |]. assert ((sin (tau - g) - sin c) * (sin (tau - g) - sin c) <= 0) by nra. nra.
    - exists (-1); split; [right; reflexivity |].
      assert ((sin (tau - g) + sin c) * (sin (tau - g) + sin c) <= 0) by nra. nra. }
  destruct F as (e & E1 & F). exists e; split; [exact E1 |].
  assert (Ct : cos tau = cos (g + (tau - g))) by (f_equal; ring).
  assert (St : sin tau = sin (g + (tau - g))) by (f_equal; ring).
  rewrite Ct, St, !cos_plus, !sin_plus, (cos_signed e c E1), (sin_signed e c E1), F, K. split; ring.
Qed.

Example roots_are_all_instance : exists e, (e = 1 \/ e = -1) /\
  cos 2 = cos (inverse_tau e ey ez ez (V ey ez ez 2 3)) /\ sin 2 = sin (inverse_tau e ey ez ez (V ey ez ez 2 3)).
Proof. apply (roots_are_all ey ez ez _ 2 3); [numbers; lra | rewrite rho_BC; lra | reflexivity]. Qed.

(** The bounds of reach by the angles alpha of axis and tool, beta of the two axes, gamma of work-side axis and direction. *)
Definition reach_bounds alpha beta gamma := cos gamma <= cos (alpha - beta) /\ cos (alpha + beta) <= cos gamma.

Lemma unit_cos_angle u v : is_unit u -> is_unit v -> cos (angle u v) = dot u v.
Proof.
  intros U W. pose proof (cos_angle u v (unit_nonzero u U) (unit_nonzero v W)) as E.
  rewrite !norm_unit in E by assumption. lra.
Qed.

Lemma unit_sin_angle u v : is_unit u -> is_unit v ->
  0 <= sin (angle u v) /\ sin (angle u v) * sin (angle u v) = 1 - dot u v * dot u v.
Proof.
  intros U W. split; [apply sin_ge_0; apply angle_bounds |].
  pose proof (cos_sin_square (angle u v)) as E. rewrite unit_cos_angle in E by assumption. lra.
Qed.

Lemma rho_by_angles ut uw t0 : is_unit ut -> is_unit uw -> is_unit t0 ->
  rho ut uw t0 = sin (angle ut t0) * sin (angle ut uw).
Proof.
  intros Ut Uw U0. destruct (unit_sin_angle ut t0 Ut U0) as [P1 S1]. destruct (unit_sin_angle ut uw Ut Uw) as [P2 S2].
  unfold rho. assert (E : A ut uw t0 * A ut uw t0 + B ut uw t0 * B ut uw t0 =
    (sin (angle ut t0) * sin (angle ut uw)) * (sin (angle ut t0) * sin (angle ut uw))).
  { transitivity ((sin (angle ut t0) * sin (angle ut t0)) * (sin (angle ut uw) * sin (angle ut uw))); [| ring].
    rewrite S1, S2.
    assert (G : B ut uw t0 * B ut uw t0 = dot uw uw * dot ut ut * dot t0 t0 + 2 * dot uw ut * dot ut t0 * dot uw t0
      - dot uw uw * (dot ut t0 * dot ut t0) - dot ut ut * (dot uw t0 * dot uw t0) - dot t0 t0 * (dot uw ut * dot uw ut)).
    { unfold B. vec_ring. }
    assert (F : A ut uw t0 = dot uw t0 - dot ut t0 * dot uw ut) by (unfold A, along; vec_ring).
    rewrite G, F, Ut, Uw, U0, (dot_comm uw ut). ring. }
  rewrite E. apply sqrt_square, Rmult_le_pos; assumption.
Qed.

(** fanuc.tool-center-point.reach-toward-the-axis: rho - C and rho + C (reach-away-from-the-axis) are the distances of
    cos gamma from the cosines of the bounds |alpha - beta| and alpha + beta. *)
Theorem reach_by_angles ut uw t0 v : is_unit ut -> is_unit uw -> is_unit t0 -> is_unit v ->
  rho ut uw t0 - C ut uw t0 v = cos (angle ut t0 - angle ut uw) - cos (angle uw v) /\
  rho ut uw t0 + C ut uw t0 v = cos (angle uw v) - cos (angle ut t0 + angle ut uw).
Proof.
  intros Ut Uw U0 Uv. rewrite rho_by_angles, cos_minus, cos_plus, !unit_cos_angle by assumption.
  unfold C, along. replace (dot uw (scale (dot t0 ut) ut)) with (dot ut t0 * dot ut uw) by vec_ring. split; ring.
Qed.

Example reach_by_angles_instance :
  rho ey ez ez + C ey ez ez ex = cos (angle ez ex) - cos (angle ey ez + angle ey ez).
Proof. apply reach_by_angles; numbers; lra. Qed.

(** fanuc.tool-center-point.reach-away-from-the-axis: a direction is reached exactly between the bounds. *)
Theorem reachable_by_angles ut uw t0 v : is_unit ut -> is_unit uw -> is_unit t0 -> is_unit v -> 0 < rho ut uw t0 ->
  (exists tau omega, V ut uw t0 tau omega = v) <-> reach_bounds (angle ut t0) (angle ut uw) (angle uw v).
Proof.
  intros Ut Uw U0 Uv P. rewrite reachable_iff by assumption.
  destruct (reach_by_angles ut uw t0 v Ut Uw U0 Uv) as [X Y]. unfold reach_bounds.
  split; [intro Q; apply within in Q; lra | intro Q; apply Rabs_le; lra].
Qed.

Example reachable_by_angles_instance : reach_bounds (angle ey ez) (angle ey ez) (angle ez (V ey ez ez 1 2)).
Proof.
  apply reachable_by_angles; rewrite ?rho_BC; try (numbers; lra).
  - unfold is_unit, V; rewrite !rotate_dot by (numbers; lra). numbers; lra.
  - exists 1, 2; reflexivity.
Qed.

(** * The control point *)

(** fanuc.tool-center-point.control-point-tool-rotation: on a head without offsets the control point keeps the length of
    the tool as its distance from the tip. *)
Theorem head_distance T L v : is_unit v -> norm (sub (head_control_point T L v) T) = Rabs L.
Proof.
  intro U. unfold head_control_point. replace (sub (add T (scale L v)) T) with (scale L v) by vec_ring.
  rewrite norm_scale, norm_unit by exact U; ring.
Qed.

Example head_distance_instance : norm (sub (head_control_point ex (-5) ez) ex) = 5.
Proof. rewrite head_distance, Rabs_left by (numbers; lra). lra. Qed.

(** fanuc.tool-center-point.control-point-tool-rotation: without offsets F is the control point on the tool. *)
Theorem head_without_offsets u1 a1 u2 a2 t0 T L :
  head_F u1 a1 u2 a2 t0 T L zero zero = head_control_point T L (head u1 1 a1 u2 1 a2 t0).
Proof.
  unfold head_F, head_control_point, head. rewrite !Rmult_1_l.
  assert (Z : forall k a, rotate k a zero = zero) by (intros; unfold rotate; vec_ring).
  rewrite !Z. set (v := rotate u1 a1 (rotate u2 a2 t0)). clearbody v. vec_ring.
Qed.

Example head_without_offsets_instance :
  head_F ez 1 ey 2 ez ex 3 zero zero = head_control_point ex 3 (head ez 1 1 ey 1 2 ez).
Proof. apply head_without_offsets. Qed.

(** fanuc.tool-center-point.control-point-table-rotation: the places of a point in the machine and on the table are
    inverse to each other. *)
Theorem table_point_inverse u1 a1 u2 a2 O d X : is_unit u1 -> is_unit u2 ->
  in_machine u1 a1 u2 a2 O d (on_table u1 a1 u2 a2 O d X) = X /\
  on_table u1 a1 u2 a2 O d (in_machine u1 a1 u2 a2 O d X) = X.
Proof.
  intros U1 U2; unfold in_machine, on_table; split.
  - rewrite rotate_forth, there_and_back, rotate_forth by assumption. apply there_and_back.
  - rewrite back_and_there, rotate_back, back_and_there by assumption. apply rotate_back, U2.
Qed.

Example table_point_inverse_instance : on_table ex 1 ez 2 ez ey (in_machine ex 1 ez 2 ez ey ex) = ex.
Proof. apply table_point_inverse; numbers; lra. Qed.

(** fanuc.tool-center-point.frozen-pose: at the frozen pose a point of the programming system stands where the workpiece
    system has it. *)
Theorem at_the_frozen_pose u1 a1 u2 a2 O d W T : is_unit u1 -> is_unit u2 ->
  in_machine u1 a1 u2 a2 O d (on_table u1 a1 u2 a2 O d (add W T)) = add W T.
Proof. intros U1 U2; apply table_point_inverse; assumption. Qed.

Example at_the_frozen_pose_instance : in_machine ex 1 ez 2 ez ey (on_table ex 1 ez 2 ez ey (add ex ey)) = add ex ey.
Proof. apply at_the_frozen_pose; numbers; lra. Qed.

(** fanuc.tool-center-point.tip-path: a line of the programming system is a line on the table, passed evenly, however the
    table turns meanwhile. *)
Theorem tip_on_the_line u1 a1 u2 a2 O d W t P Q :
  on_table u1 a1 u2 a2 O d (add W (on_line t P Q)) =
  on_line t (on_table u1 a1 u2 a2 O d (add W P)) (on_table u1 a1 u2 a2 O d (add W Q)).
Proof.
  unfold on_table, on_line.
  replace (sub (add W (add (scale (1 - t) P) (scale t Q))) O)
    with (add (scale (1 - t) (sub (add W P) O)) (scale t (sub (add W Q) O))) by vec_ring.
  rewrite rotate_add, !rotate_scale. set (p := rotate u1 (- a1) (sub (add W P) O)).
  set (q := rotate u1 (- a1) (sub (add W Q) O)). clearbody p q.
  replace (sub (add (scale (1 - t) p) (scale t q)) d) with (add (scale (1 - t) (sub p d)) (scale t (sub q d))) by vec_ring.
  rewrite rotate_add, !rotate_scale; reflexivity.
Qed.

Example tip_on_the_line_instance :
  on_table ex 1 ez 2 ez ey (add ex (on_line (1/2) ey ez)) =
  on_line (1/2) (on_table ex 1 ez 2 ez ey (add ex ey)) (on_table ex 1 ez 2 ez ey (add ex ez)).
Proof. apply tip_on_the_line. Qed.

(** fanuc.tool-center-point.tip-path: what the machine is sent to, seen from the table at that moment, lies on the line. *)
Theorem tip_seen_from_the_table u1 a1 u2 a2 O d P Q t b1 b2 : is_unit u1 -> is_unit u2 ->
  on_table u1 b1 u2 b2 O d (in_machine u1 b1 u2 b2 O d (on_table u1 a1 u2 a2 O d (on_line t P Q))) =
  on_line t (on_table u1 a1 u2 a2 O d P) (on_table u1 a1 u2 a2 O d Q).
Proof.
  intros U1 U2. destruct (table_point_inverse u1 b1 u2 b2 O d (on_table u1 a1 u2 a2 O d (on_line t P Q)) U1 U2) as [_ E].
  rewrite E. pose proof (tip_on_the_line u1 a1 u2 a2 O d zero t P Q) as L.
  assert (Z : forall w, add zero w = w) by (intro; vec_ring). rewrite !Z in L. exact L.
Qed.

Example tip_seen_from_the_table_instance :
  on_table ex 3 ez 4 ez ey (in_machine ex 3 ez 4 ez ey (on_table ex 1 ez 2 ez ey (on_line (1/2) ex ey))) =
  on_line (1/2) (on_table ex 1 ez 2 ez ey ex) (on_table ex 1 ez 2 ez ey ey).
Proof. apply tip_seen_from_the_table; numbers; lra. Qed.

(** * The lean angle *)

(** fanuc.tool-center-point.lean: the leaned tool is as long, turned by Q in the plane of tool and travel, toward it. *)
Theorem lean_components Q v d : cross v d <> zero ->
  dot (lean Q v d) (lean Q v d) = dot v v /\ dot (lean Q v d) v = cos Q * dot v v /\
  dot (lean Q v d) (cross v d) = 0 /\ dot (lean Q v d) d = cos Q * dot v d + sin Q * norm (cross v d).
Proof.
  intro N. pose proof (norm_pos _ N) as P. pose proof (norm_sqr (cross v d)) as R.
  set (w := cross v d) in *. set (h := norm w) in *.
  assert (K : is_unit (scale (/ h) w)).
  { unfold is_unit; rewrite dot_scale_l, dot_scale_r, <- R; field; lra. }
  assert (W : dot w v = 0) by (unfold w; vec_ring).
  assert (W' : dot w d = 0) by (unfold w; vec_ring).
  assert (X : dot (cross w v) d = dot w w) by (unfold w; vec_ring).
  assert (Y : dot (cross w v) v = 0) by vec_ring.
  assert (Z : dot (cross w v) w = 0) by vec_ring.
  unfold lean; fold w; fold h. split; [apply rotate_dot, K |].
  assert (E : rotate (scale (/ h) w) Q v = add (scale (cos Q) v) (scale (sin Q * / h) (cross w v))).
  { unfold rotate. replace (dot (scale (/ h) w) v) with (/ h * dot w v) by vec_ring. rewrite W.
    set (c := cos Q); set (s := sin Q); set (i := / h). vec_ring. }
  rewrite E, !dot_add_l, !dot_scale_l, X, Y, Z, (dot_comm v w), W, <- R. repeat split; try ring. field; lra.
Qed.

Example lean_components_instance : dot (lean (PI / 2) ez ex) ex = 1.
Proof.
  assert (N : cross ez ex <> zero) by (intro E; apply (f_equal vy) in E; numbers; lra).
  destruct (lean_components (PI / 2) ez ex N) as (_ & _ & _ & E). rewrite E, cos_PI2, sin_PI2.
  assert (H : cross ez ex = ey) by (numbers; f_equal; ring). rewrite H, norm_unit by (numbers; lra). numbers; ring.
Qed.
