(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-posture-control: the direction of the tool between two directions, singular postures, and a changed end.

    [a], [b]: directions of length 1 at start and end of a block; [N] their cross product; [s] a singular direction. Angles
    are in radians. *)
From Coq Require Import Reals Lra Psatz.
From Toolcomp Require Import Vectors ToolDirection ToolCenterPointControl.
Open Scope R_scope.

(** * Definitions *)

(** From [a] to [b], [theta] apart, at the fraction [t]. *)
Definition between theta a b t := add (scale (sin ((1 - t) * theta) / sin theta) a) (scale (sin (t * theta) / sin theta) b).
Definition great_circle a b t := between (angle a b) a b t.

(** Whether the great circle of [a] and [b] comes nearer to [s] than [limit], by products. *)
Definition near limit a b s := dot (cross a b) s * dot (cross a b) s < sin limit * sin limit * dot (cross a b) (cross a b).

(** The point of that great circle nearest to [s], of any length. *)
Definition foot a b s := sub s (scale (dot s (cross a b) / dot (cross a b) (cross a b)) (cross a b)).

(** The changed end of the tool side, mirrored at the singular position [S], and positions that go evenly. *)
Definition mirrored S tau := 2 * S - tau.
Definition evenly p q t := (1 - t) * p + t * q.

(** The direction at polar angle [p] about Z and azimuth [w]: that of a machine with B on the tool and C on the work side. *)
Definition polar p w := Vec (sin p * cos w) (sin p * sin w) (cos p).

(** * Between two directions *)

(** fanuc.tool-posture.great-circle: it starts and ends where it has to. *)
Theorem between_ends theta a b : sin theta <> 0 -> between theta a b 0 = a /\ between theta a b 1 = b.
Proof.
  intro N; unfold between. rewrite Rminus_0_r, Rmult_0_l, Rmult_1_l, sin_0, Rminus_diag_eq, Rmult_0_l, sin_0 by reflexivity.
  assert (Z : 0 / sin theta = 0) by (field; exact N). assert (I : sin theta / sin theta = 1) by (field; exact N).
  rewrite Z, I. split; vec_ring.
Qed.

Example between_ends_instance : between (PI / 2) ex ey 1 = ey.
Proof. apply between_ends; rewrite sin_PI2; lra. Qed.

(** fanuc.tool-posture.great-circle: the tool stays in the plane of its directions at the ends. *)
Theorem between_in_plane theta a b t : dot (cross a b) (between theta a b t) = 0.
Proof. unfold between. set (x := _ / _); set (y := sin (t * theta) / _). vec_ring. Qed.

Example between_in_plane_instance : dot (cross ex ey) (between 1 ex ey (1/2)) = 0.
Proof. apply between_in_plane. Qed.

(** fanuc.tool-posture.great-circle: exchanging the ends runs the same directions backwards. *)
Theorem between_symmetric theta a b t : between theta a b t = between theta b a (1 - t).
Proof.
  unfold between. replace (1 - (1 - t)) with t by ring. set (x := _ / _); set (y := sin (t * theta) / _). vec_ring.
Qed.

Example between_symmetric_instance : between 1 ex ey (1/4) = between 1 ey ex (1 - 1/4).
Proof. apply between_symmetric. Qed.

(** Products of two directions on the way. *)
Lemma between_dot theta a b t u : is_unit a -> is_unit b -> dot a b = cos theta -> sin theta <> 0 ->
  dot (between theta a b t) (between theta a b u) = cos ((t - u) * theta).
Proof.
  intros U W D N. unfold between.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, U, W, (dot_comm b a), D.
  replace ((1 - t) * theta) with (theta - t * theta) by ring. replace ((1 - u) * theta) with (theta - u * theta) by ring.
  replace ((t - u) * theta) with (t * theta - u * theta) by ring.
  rewrite !sin_minus, cos_minus. set (x := t * theta); set (y := u * theta).
  pose proof (cos_sin_square theta) as Q. set (c := cos theta) in *; set (s := sin theta) in *.
  set (cx := cos x); set (sx := sin x); set (cy := cos y); set (sy := sin y).
  transitivity ((s * s * cx * cy + (1 - c * c) * (sx * sy)) / (s * s)).
  - field; exact N.
  - replace (1 - c * c) with (s * s) by lra. field; exact N.
Qed.

(** fanuc.tool-posture.great-circle: the direction keeps the length 1. *)
Theorem between_unit theta a b t : is_unit a -> is_unit b -> dot a b = cos theta -> sin theta <> 0 ->
  is_unit (between theta a b t).
Proof.
  intros U W D N; unfold is_unit; rewrite between_dot by assumption.
  replace ((t - t) * theta) with 0 by ring. apply cos_0.
Qed.

Example between_unit_instance : is_unit (between (PI / 2) ex ey (1/3)).
Proof. apply between_unit; rewrite ?sin_PI2, ?cos_PI2; numbers; lra. Qed.

(** Two directions that are neither equal nor opposite: their angle, and its sine. *)
Lemma apart a b : is_unit a -> is_unit b -> ~ parallel a b -> dot a b = cos (angle a b) /\ 0 < sin (angle a b).
Proof.
  intros U W P. split; [symmetry; apply unit_cos_angle; assumption |].
  destruct (unit_sin_angle a b U W) as [S Q].
  assert (N : cross a b <> zero) by exact P.
  pose proof (dot_self_pos _ N) as L. rewrite lagrange, U, W in L. unfold Rsqr in L.
  destruct (Req_dec (sin (angle a b)) 0) as [Z | Z]; [rewrite Z in Q |]; lra.
Qed.

Lemma x_y_apart : ~ parallel ex ey.
Proof. intro E; apply (f_equal vz) in E; numbers; lra. Qed.

(** fanuc.tool-posture.great-circle: the tool turns evenly: between two moments by the same part of the whole angle. *)
Theorem constant_rate a b t u : is_unit a -> is_unit b -> ~ parallel a b -> 0 <= t <= 1 -> 0 <= u <= t ->
  angle (great_circle a b t) (great_circle a b u) = (t - u) * angle a b.
Proof.
  intros U W P T T'. destruct (apart a b U W P) as [D S].
  assert (X : is_unit (great_circle a b t)) by (apply between_unit; auto; lra).
  assert (Y : is_unit (great_circle a b u)) by (apply between_unit; auto; lra).
  unfold angle at 1. rewrite !norm_unit by assumption. unfold great_circle.
  rewrite between_dot by (auto; lra). replace (cos ((t - u) * angle a b) / (1 * 1)) with (cos ((t - u) * angle a b)) by field.
  apply acos_cos. pose proof (angle_bounds a b). split; nra.
Qed.

Example constant_rate_instance : angle (great_circle ex ey (1/2)) (great_circle ex ey (1/4)) = (1/2 - 1/4) * angle ex ey.
Proof. apply constant_rate; try (numbers; lra). apply x_y_apart. Qed.

(** fanuc.tool-posture.great-circle: after the fraction t the tool has turned by t times the angle. *)
Theorem angle_from_start a b t : is_unit a -> is_unit b -> ~ parallel a b -> 0 <= t <= 1 ->
  angle (great_circle a b t) a = t * angle a b.
Proof.
  intros U W P T. destruct (apart a b U W P) as [D S].
  destruct (between_ends (angle a b) a b) as [E _]; [lra |].
  rewrite <- E at 2. fold (great_circle a b 0). rewrite constant_rate by (auto; lra). ring.
Qed.

Example angle_from_start_instance : angle (great_circle ex ey (1/3)) ex = 1/3 * angle ex ey.
Proof. apply angle_from_start; try (numbers; lra). apply x_y_apart. Qed.

(** fanuc.tool-posture.no-plane: only equal and opposite directions span no plane. *)
Theorem no_plane_iff a b : is_unit a -> is_unit b -> (dot (cross a b) (cross a b) = 0 <-> a = b \/ a = opp b).
Proof.
  intros U W. split.
  - intro Z. apply dot_self_zero in Z.
    assert (P : parallel a b) by exact Z. apply parallel_multiple in P; [| apply unit_nonzero, W].
    destruct P as [k E]. subst. unfold is_unit in U. rewrite dot_scale_l, dot_scale_r, W in U.
    assert (K : (k - 1) * (k + 1) = 0) by lra. apply Rmult_integral in K. destruct K as [K | K].
    + left. replace k with 1 by lra. apply scale_one.
    + right. unfold opp. f_equal; lra.
  - intros [E | E]; subst; vec_ring.
Qed.

Example no_plane_iff_instance : dot (cross ex (opp ex)) (cross ex (opp ex)) = 0.
Proof.
  apply no_plane_iff; [numbers; lra | numbers; lra |]. right. numbers. f_equal; ring.
Qed.

(** * A planar face *)

(** fanuc.tool-posture.flat-face: where a face with normal [n] holds both directions, the tool stays parallel to it. *)
Theorem parallel_to_the_face theta a b n t : dot n a = 0 -> dot n b = 0 -> dot n (between theta a b t) = 0.
Proof. intros P Q; unfold between; rewrite dot_add_r, !dot_scale_r, P, Q; ring. Qed.

Example parallel_to_the_face_instance : dot ez (between 1 ex ey (1/2)) = 0.
Proof. apply parallel_to_the_face; numbers; ring. Qed.

(** fanuc.tool-posture.flat-face: the side of the cutter touches the face all along the block: every point of its axis, at
    height [h] above a tip that runs from [P] to [Q], keeps the distance r from the face through [F]. *)
Theorem flank_touches_the_face theta a b n F P Q r t h : dot n a = 0 -> dot n b = 0 ->
  dot n (sub P F) = r -> dot n (sub Q F) = r ->
  dot n (sub (add (on_line t P Q) (scale h (between theta a b t))) F) = r.
Proof.
  intros A0 B0 HP HQ.
  assert (E : dot n (sub (add (on_line t P Q) (scale h (between theta a b t))) F) =
              (1 - t) * dot n (sub P F) + t * dot n (sub Q F) + h * dot n (between theta a b t)).
  { set (v := between theta a b t). clearbody v. unfold on_line. vec_ring. }
  rewrite E, HP, HQ, parallel_to_the_face by assumption. ring.
Qed.

Example flank_touches_the_face_instance :
  dot ez (sub (add (on_line (1/3) (Vec 0 0 5) (Vec 7 8 5)) (scale 40 (between 1 ex ey (1/3)))) zero) = 5.
Proof. apply flank_touches_the_face; numbers; ring. Qed.

(** * Singular postures *)

(** fanuc.tool-posture.singular: along the work-side axis the direction does not depend on its position. *)
Theorem singular_posture uw ut t0 tau omega omega' : is_unit uw -> parallel (V ut uw t0 tau omega) uw ->
  V ut uw t0 tau omega' = V ut uw t0 tau omega.
Proof. apply any_work_side. Qed.

Example singular_posture_instance : V ey ez ez 0 1 = V ey ez ez 0 2.
Proof.
  apply singular_posture; [numbers; lra |]. unfold V; rewrite rotate_zero, rotate_axis by (numbers; lra).
  unfold parallel; vec_ring.
Qed.

Lemma unit_opp u : is_unit u -> is_unit (opp u).
Proof. unfold is_unit; intro U. transitivity (dot u u); [vec_ring | exact U]. Qed.

Lemma angle_self u : is_unit u -> angle u u = 0.
Proof.
  intro U; unfold angle; rewrite norm_unit, U by exact U. replace (1 / (1 * 1)) with 1 by field. apply acos_1.
Qed.

Lemma angle_opposite u : is_unit u -> angle u (opp u) = PI.
Proof.
  intro U; unfold angle; rewrite norm_opp, norm_unit by exact U.
  replace (dot u (opp u)) with (- dot u u) by vec_ring. rewrite U. replace (- (1) / (1 * 1)) with (- (1)) by field.
  rewrite acos_opp, acos_1; ring.
Qed.

Lemma cos_one x : - PI <= x <= PI -> 1 <= cos x -> x = 0.
Proof.
  intros B L. pose proof (COS_bound x) as Bd. assert (E : cos x = 1) by lra.
  destruct (Rle_dec 0 x).
  - rewrite <- (acos_cos x) by lra. rewrite E. apply acos_1.
  - assert (H : - x = 0); [| lra]. rewrite <- (acos_cos (- x)) by lra. rewrite cos_neg, E. apply acos_1.
Qed.

(** fanuc.tool-posture.singular: the posture along the work-side axis can be reached exactly where the tool is as far from
    the tool-side axis as the work-side axis is (alpha = beta). *)
Theorem singular_toward ut uw t0 : is_unit ut -> is_unit uw -> is_unit t0 -> 0 < rho ut uw t0 ->
  (exists tau omega, V ut uw t0 tau omega = uw) <-> angle ut t0 = angle ut uw.
Proof.
  intros Ut Uw U0 P. rewrite reachable_by_angles by assumption. unfold reach_bounds.
  rewrite angle_self, cos_0 by exact Uw. pose proof (angle_bounds ut t0). pose proof (angle_bounds ut uw). split.
  - intros [L _]. assert (E : angle ut t0 - angle ut uw = 0) by (apply cos_one; lra). lra.
  - intro E. rewrite E, Rminus_diag_eq, cos_0 by reflexivity. split; [lra | apply COS_bound].
Qed.

Example singular_toward_instance : exists tau omega, V ey ez ez tau omega = ez.
Proof. apply singular_toward; rewrite ?rho_BC; try (numbers; lra). Qed.

(** fanuc.tool-posture.singular: the posture against it exactly where the two angles add up to 180 degrees. *)
Theorem singular_away ut uw t0 : is_unit ut -> is_unit uw -> is_unit t0 -> 0 < rho ut uw t0 ->
  (exists tau omega, V ut uw t0 tau omega = opp uw) <-> angle ut t0 + angle ut uw = PI.
Proof.
  intros Ut Uw U0 P. rewrite reachable_by_angles by (try apply unit_opp; assumption). unfold reach_bounds.
  rewrite angle_opposite, cos_PI by exact Uw. pose proof (angle_bounds ut t0). pose proof (angle_bounds ut uw). split.
  - intros [_ L]. assert (E : angle ut t0 + angle ut uw - PI = 0); [| lra].
    apply cos_one; [lra |]. rewrite cos_minus, cos_PI, sin_PI. lra.
  - intro E. rewrite E, cos_PI. split; [apply COS_bound | lra].
Qed.

Lemma right_angle_yz : angle ey ez = PI / 2.
Proof.
  unfold angle; rewrite !norm_unit by (numbers; lra). replace (dot ey ez) with 0 by (numbers; ring).
  replace (0 / (1 * 1)) with 0 by field. apply acos_0.
Qed.

Example singular_away_instance : exists tau omega, V ey ez ez tau omega = opp ez.
Proof. apply singular_away; rewrite ?rho_BC, ?right_angle_yz; try (numbers; lra). Qed.

(** * Near a singular posture *)

(** fanuc.tool-posture.near: no direction in the plane is nearer to [s] than sin^2 d = (N . s)^2/N^2 says. *)
Theorem distance_bound a b s v : is_unit s -> is_unit v -> dot (cross a b) v = 0 -> cross a b <> zero ->
  dot s v * dot s v <= 1 - dot (cross a b) s * dot (cross a b) s / dot (cross a b) (cross a b).
Proof.
  intros U W P N. pose proof (dot_self_pos _ N) as L. set (n := cross a b) in *.
  assert (G : 0 <= dot n n * dot s s * dot v v + 2 * dot n s * dot s v * dot n v
              - dot n n * (dot s v * dot s v) - dot s s * (dot n v * dot n v) - dot v v * (dot n s * dot n s)).
  { replace (_ - dot v v * _) with (dot n (cross s v) * dot n (cross s v)) by vec_ring. apply Rle_0_sqr. }
  rewrite U, W, P in G. apply (Rmult_le_reg_l (dot n n)); [exact L |].
  replace (dot n n * (1 - dot n s * dot n s / dot n n)) with (dot n n - dot n s * dot n s) by (field; lra). lra.
Qed.

Example distance_bound_instance :
  dot ez ex * dot ez ex <= 1 - dot (cross ex ey) ez * dot (cross ex ey) ez / dot (cross ex ey) (cross ex ey).
Proof. apply distance_bound; try (numbers; lra). apply x_y_apart. Qed.

(** fanuc.tool-posture.near: the foot lies in the plane and comes that near. *)
Theorem foot_is_nearest a b s : is_unit s -> cross a b <> zero ->
  dot (cross a b) (foot a b s) = 0 /\
  dot s (foot a b s) = 1 - dot (cross a b) s * dot (cross a b) s / dot (cross a b) (cross a b) /\
  dot (foot a b s) (foot a b s) = dot s (foot a b s).
Proof.
  intros U N. pose proof (dot_self_pos _ N) as L. unfold foot. set (n := cross a b) in *. clearbody n.
  set (k := dot s n / dot n n). assert (K : k * dot n n = dot s n) by (unfold k; field; lra).
  replace (dot n (sub s (scale k n))) with (dot s n - k * dot n n) by vec_ring.
  replace (dot s (sub s (scale k n))) with (dot s s - k * dot s n) by vec_ring.
  replace (dot (sub s (scale k n)) (sub s (scale k n)))
    with (dot s s - k * dot s n - k * (dot s n - k * dot n n)) by vec_ring.
  rewrite K, U, (dot_comm n s). unfold k. repeat split; field; lra.
Qed.

Example foot_is_nearest_instance : dot (cross ex ey) (foot ex ey (Vec (3/5) 0 (4/5))) = 0.
Proof. apply foot_is_nearest; [numbers; lra | apply x_y_apart]. Qed.

(** fanuc.tool-posture.near: for a limit up to 90 degrees the test by products is the test of the angle between [s] and its
    foot. *)
Theorem near_is_angle limit a b s : is_unit s -> cross a b <> zero -> foot a b s <> zero -> 0 < limit <= PI / 2 ->
  near limit a b s <-> angle s (foot a b s) < limit.
Proof.
  intros U N F B. pose proof (dot_self_pos _ N) as L. pose proof (dot_self_pos _ F) as L'.
  destruct (foot_is_nearest a b s U N) as (_ & D & E).
  pose proof (cos_angle s (foot a b s) (unit_nonzero s U) F) as Ca. rewrite norm_unit, Rmult_1_l in Ca by exact U.
  pose proof (norm_sqr (foot a b s)) as R. pose proof (norm_pos _ F) as Pn. pose proof (angle_bounds s (foot a b s)) as Bd.
  set (g := angle s (foot a b s)) in *. set (h := norm (foot a b s)) in *. rewrite E in R, L'.
  assert (Hc : h = cos g) by (apply (Rmult_eq_reg_r h); lra).
  assert (G : 0 <= g <= PI / 2).
  { split; [lra |]. destruct (Rle_dec g (PI / 2)) as [| H]; [assumption | exfalso].
    pose proof (cos_lt_0 g ltac:(lra) ltac:(lra)). lra. }
  assert (S : sin g * sin g * dot (cross a b) (cross a b) = dot (cross a b) s * dot (cross a b) s).
  { pose proof (cos_sin_square g) as Q. replace (sin g * sin g) with (1 - cos g * cos g) by lra.
    rewrite <- Hc, R, D. field; lra. }
  pose proof (sin_ge_0 g ltac:(lra) ltac:(lra)) as Sg. pose proof (sin_gt_0 limit ltac:(lra) ltac:(lra)) as Sl.
  unfold near. rewrite <- S. set (m := dot (cross a b) (cross a b)) in *. split.
  - intro H. destruct (Rlt_dec g limit) as [| K]; [assumption | exfalso].
    assert (sin limit <= sin g) by (apply sin_incr_1; lra).
    assert (sin limit * sin limit <= sin g * sin g) by nra. nra.
  - intro H. assert (sin g < sin limit) by (apply sin_increasing_1; lra).
    assert (sin g * sin g < sin limit * sin limit) by nra. nra.
Qed.

Example near_is_angle_instance :
  near (PI / 2) ex ey (Vec (3/5) 0 (4/5)) <->
  angle (Vec (3/5) 0 (4/5)) (foot ex ey (Vec (3/5) 0 (4/5))) < PI / 2.
Proof.
  pose proof PI_RGT_0. apply near_is_angle; [numbers; lra | apply x_y_apart | | lra].
  unfold foot; intro E; apply (f_equal vx) in E; numbers; field_simplify in E; lra.
Qed.

(** * The changed end *)

(** fanuc.tool-posture.passing: going evenly from tau to the mirrored end of an end on the same side, the tool side is at the
    singular position at the fraction stated, inside the block. *)
Theorem passes_the_singular_position S tau tau_e :
  0 < tau - S -> 0 < tau_e - S ->
  let t := (tau - S) / ((tau - S) + (tau_e - S)) in
  0 < t < 1 /\ evenly tau (mirrored S tau_e) t = S.
Proof.
  intros A0 B0 t. unfold evenly, mirrored, t. set (p := tau - S) in *; set (q := tau_e - S) in *.
  split.
  - split; [apply Rdiv_lt_0_compat; lra |]. apply (Rmult_lt_reg_r (p + q)); [lra |].
    unfold Rdiv; rewrite Rmult_assoc, Rinv_l by lra; lra.
  - replace tau with (S + p) by (unfold p; ring). replace (2 * S - tau_e) with (S - q) by (unfold q; ring). field; lra.
Qed.

Example passes_the_singular_position_instance : evenly 10 (mirrored 0 12) ((10 - 0) / ((10 - 0) + (12 - 0))) = 0.
Proof. apply passes_the_singular_position; lra. Qed.

(** fanuc.tool-posture.passing: where the tool is at right angles to its axis, going evenly on the tool side alone is the
    great circle at an even rate. *)
Theorem passing_is_great_circle ut uw t0 omega p q t : is_unit ut -> is_unit uw -> is_unit t0 -> dot ut t0 = 0 ->
  sin (q - p) <> 0 ->
  V ut uw t0 (evenly p q t) omega = between (q - p) (V ut uw t0 p omega) (V ut uw t0 q omega) t.
Proof.
  intros Ut Uw U0 O N. unfold V, between.
  rewrite <- !(rotate_scale uw), <- rotate_add. f_equal.
  assert (R : forall x, rotate ut x t0 = add (scale (cos x) t0) (scale (sin x) (cross ut t0))).
  { intro x; unfold rotate. rewrite O. set (c := cos x); set (s := sin x). vec_ring. }
  rewrite !R. clear R. unfold evenly.
  replace ((1 - t) * p + t * q) with (p + t * (q - p)) by ring.
  replace ((1 - t) * (q - p)) with ((q - p) - t * (q - p)) by ring.
  replace (cos q) with (cos (p + (q - p))) by (f_equal; ring). replace (sin q) with (sin (p + (q - p))) by (f_equal; ring).
  set (d := q - p) in *. set (x := t * d).
  rewrite (sin_minus d x), !cos_plus, !sin_plus.
  pose proof (cos_sin_square d) as Q. set (w := cross ut t0). clearbody w.
  set (cd := cos d) in *; set (sd := sin d) in *; set (cx := cos x); set (sx := sin x); set (cp := cos p); set (sp := sin p).
  assert (X : cp * cx - sp * sx = (sd * cx - cd * sx) / sd * cp + sx / sd * (cp * cd - sp * sd)) by (field; exact N).
  assert (Y : sp * cx + cp * sx = (sd * cx - cd * sx) / sd * sp + sx / sd * (sp * cd + cp * sd)) by (field; exact N).
  rewrite X, Y. set (k := _ / sd); set (l := sx / sd). vec_ring.
Qed.

Example passing_is_great_circle_instance :
  V ey ez ez (evenly 0 (PI / 2) (1/3)) 2 = between (PI / 2 - 0) (V ey ez ez 0 2) (V ey ez ez (PI / 2) 2) (1/3).
Proof.
  apply passing_is_great_circle; try (numbers; lra). replace (PI / 2 - 0) with (PI / 2) by ring. rewrite sin_PI2; lra.
Qed.

(** fanuc.tool-posture.great-circle: so, with orthogonal axes and the work side standing, conventional and posture control
    agree, and the great circle through a singular posture leaves the work side alone. *)
Theorem standing_work_side ut uw t0 omega p q t : is_unit ut -> is_unit uw -> is_unit t0 -> dot ut t0 = 0 ->
  0 < q - p < PI ->
  V ut uw t0 (evenly p q t) omega = great_circle (V ut uw t0 p omega) (V ut uw t0 q omega) t.
Proof.
  intros Ut Uw U0 O L. pose proof (sin_gt_0 (q - p) ltac:(lra) ltac:(lra)) as S.
  rewrite passing_is_great_circle by (auto; lra). unfold great_circle. f_equal.
  unfold angle, norm, V. rewrite !(rotate_dot uw) by exact Uw. rewrite !(rotate_dot ut p), !(rotate_dot ut q) by exact Ut.
  replace (dot (rotate ut p t0) (rotate ut q t0)) with (cos (q - p)).
  - rewrite U0, sqrt_1. replace (cos (q - p) / (1 * 1)) with (cos (q - p)) by field. rewrite acos_cos by lra. reflexivity.
  - replace (rotate ut q t0) with (rotate ut p (rotate ut (q - p) t0)).
    + rewrite rotate_dot by exact Ut. unfold rotate. rewrite O, !dot_add_r, !dot_scale_r, U0.
      replace (dot t0 (cross ut t0)) with 0 by vec_ring. ring.
    + rewrite rotate_twice by exact Ut. f_equal; ring.
Qed.

Example standing_work_side_instance :
  V ey ez ez (evenly (-1) 1 (1/2)) 2 = great_circle (V ey ez ez (-1) 2) (V ey ez ez 1 2) (1/2).
Proof. apply standing_work_side; try (numbers; lra). pose proof PI2_1; lra. Qed.

(** * Consequences for orthogonal axes *)

(** fanuc.tool-posture.changed: [polar] is the direction of the machine, and negating the polar angle turns the azimuth by a
    half turn. *)
Theorem polar_of_machine p w : V ey ez ez p w = polar p w /\ polar (- p) w = polar p (w + PI).
Proof.
  split; unfold polar.
  - unfold V. rewrite rotate_about_z, rotate_about_y. cbn [vx vy vz ez]. f_equal; ring.
  - rewrite sin_neg, cos_neg, neg_cos, neg_sin. f_equal; ring.
Qed.

Example polar_of_machine_instance : V ey ez ez (-1) 2 = polar 1 (2 + PI).
Proof. destruct (polar_of_machine (-1) 2) as [E _]; rewrite E. apply (polar_of_machine 1 2). Qed.

(** fanuc.tool-posture.veto: with delta the azimuth by which the changed end differs, the tips of the two end directions are
    2 sin b |sin (delta/2)| apart: the angle between them is 2 asin (sin b sin (delta/2)). *)
Theorem end_error b w delta :
  let e := sub (polar b (w + PI + delta)) (polar (- b) w) in
  dot e e = (2 * sin b * sin (delta / 2)) * (2 * sin b * sin (delta / 2)).
Proof.
  cbv zeta. destruct (polar_of_machine b w) as [_ E]. rewrite E. unfold polar.
  set (v := w + PI). rewrite cos_plus, sin_plus.
  set (x := delta / 2).
  assert (Cd : cos delta = 1 - 2 * sin x * sin x) by (rewrite <- cos_2a_sin; unfold x; f_equal; field).
  assert (Sd : sin delta = 2 * sin x * cos x) by (rewrite <- sin_2a; unfold x; f_equal; field).
  rewrite Cd, Sd. pose proof (cos_sin_square v) as Qv. pose proof (cos_sin_square x) as Qx.
  set (cv := cos v) in *; set (sv := sin v) in *; set (cx := cos x) in *; set (sx := sin x) in *; set (sb := sin b).
  numbers.
  transitivity (sb * sb * (cv * cv + sv * sv) * (4 * (sx * sx) * (sx * sx + cx * cx))); [ring |].
  rewrite Qv, Qx. ring.
Qed.

Example end_error_instance : let e := sub (polar 1 (2 + PI + 3)) (polar (- 1) 2) in
  dot e e = (2 * sin 1 * sin (3 / 2)) * (2 * sin 1 * sin (3 / 2)).
Proof. apply end_error. Qed.

(** fanuc.tool-posture.near: N . s = sin a sin b sin (difference of the azimuths): together with |N| = sin Theta this is
    sin d = sin a sin b sin delta / sin Theta. *)
Theorem distance_by_azimuths a b w w' : dot (cross (polar a w) (polar b w')) ez = sin a * sin b * sin (w' - w).
Proof. unfold polar; rewrite sin_minus; numbers; ring. Qed.

Example distance_by_azimuths_instance : dot (cross (polar 1 2) (polar 3 4)) ez = sin 1 * sin 3 * sin (4 - 2).
Proof. apply distance_by_azimuths. Qed.

(** fanuc.tool-posture.veto: a limit 19739 of 0 never lets an end change: where delta is 0 the great circle goes through the
    singular posture exactly. *)
Theorem no_difference_crosses a b w : dot (cross (polar a w) (polar b (w + PI))) ez = 0.
Proof.
  rewrite distance_by_azimuths. replace (w + PI - w) with PI by ring. rewrite sin_PI; ring.
Qed.

Example no_difference_crosses_instance : dot (cross (polar 1 2) (polar 3 (2 + PI))) ez = 0.
Proof. apply no_difference_crosses. Qed.

(** fanuc.tool-posture.great-circle: cos Theta by polar angles and azimuths. *)
Theorem angle_by_azimuths a b w w' : dot (polar a w) (polar b w') = cos a * cos b + sin a * sin b * cos (w' - w).
Proof. unfold polar; rewrite cos_minus; numbers; ring. Qed.

Example angle_by_azimuths_instance : dot (polar 1 2) (polar 3 4) = cos 1 * cos 3 + sin 1 * sin 3 * cos (4 - 2).
Proof. apply angle_by_azimuths. Qed.

(** fanuc.tool-posture.great-circle: half way the direction is the sum of both, by which samples are computed without an
    angle. *)
Theorem half_way a b : is_unit a -> is_unit b -> ~ parallel a b ->
  great_circle a b (1/2) = scale (/ norm (add a b)) (add a b).
Proof.
  intros U W P. destruct (apart a b U W P) as [D S]. unfold great_circle, between. set (g := angle a b) in *.
  pose proof (angle_bounds a b) as Bd. fold g in Bd.
  assert (G : g < PI).
  { destruct (Req_dec g PI) as [E |]; [rewrite E, sin_PI in S |]; lra. }
  pose proof (cos_gt_0 (g / 2) ltac:(lra) ltac:(lra)) as Cg.
  assert (Sg : sin g = 2 * sin (g / 2) * cos (g / 2)).
  { rewrite <- sin_2a. f_equal; field. }
  assert (Cd : cos g = 2 * cos (g / 2) * cos (g / 2) - 1).
  { rewrite <- cos_2a_cos. f_equal; field. }
  assert (N : norm (add a b) = 2 * cos (g / 2)).
  { unfold norm. replace (dot (add a b) (add a b)) with ((2 * cos (g / 2)) * (2 * cos (g / 2))).
    - apply sqrt_square; lra.
    - rewrite dot_add_l, !dot_add_r, U, W, (dot_comm b a), D, Cd. ring. }
  assert (Z : sin (g / 2) <> 0) by (intro E; rewrite E in Sg; lra).
  replace ((1 - 1 / 2) * g) with (g / 2) by field. replace (1 / 2 * g) with (g / 2) by field.
  rewrite N, Sg, scale_add. replace (sin (g / 2) / (2 * sin (g / 2) * cos (g / 2))) with (/ (2 * cos (g / 2))) by (field; lra).
  reflexivity.
Qed.

Example half_way_instance : great_circle ex ey (1/2) = scale (/ norm (add ex ey)) (add ex ey).
Proof. apply half_way; try (numbers; lra). apply x_y_apart. Qed.
