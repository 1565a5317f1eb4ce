(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/face-milling: where the effective tool stands so that it touches what the nominal tool touched, and why
    that is the compensation the manual describes.

    [N] is the surface normal as programmed, from the workpiece into the tool, [T] the direction of the tool from tip to
    carrier, both of any length; [P] a programmed point, [q] the point where the tool touches. *)
From Coq Require Import Reals Lra Psatz ZArith.
From Toolcomp Require Import Vectors.
Open Scope R_scope.

(** * Definitions *)

(** The direction of length 1; of the zero vector the zero vector. *)
Definition unit v := scale (/ norm v) v.

(** The part of the normal across the tool, without a root: (T.T) N - (N.T) T. *)
Definition w N T := sub (scale (dot T T) N) (scale (dot N T) T).

(** The direction from the touched point of the ring to the axis; zero where the normal is along the tool. *)
Definition u N T := unit (w N T).

(** Radius and corner radius of the tool table. *)
Record tool := Tool { radius : R; corner : R }.

(** The sums of the deltas from tool table, tool call and compensation table. *)
Record deltas := Deltas { dL : R; dR : R; dR2 : R }.

(** The radius of the flat of the nominal tool: of the ring on which the centres of its corner lie. *)
Definition ring k := radius k - corner k.

(** The same of the effective tool, never below 0. *)
Definition effective_ring k d := Rmax 0 (radius k + dR d - (corner k + dR2 d)).

(** The tip of a tool of corner radius [r2] and ring [rho] that touches at [q]. *)
Definition tip q N T r2 rho := add q (sub (add (scale r2 (unit N)) (scale rho (u N T))) (scale r2 (unit T))).

(** Where a tool with its tip at [p] touches. *)
Definition contact p N T r2 rho := sub p (sub (add (scale r2 (unit N)) (scale rho (u N T))) (scale r2 (unit T))).

(** The centre of the corner, on the ring where it is nearest to the wall. *)
Definition CR2 p N T r2 rho := sub (add p (scale r2 (unit T))) (scale rho (u N T)).

(** The centre of the tool, on its axis. *)
Definition center p T r2 := add p (scale r2 (unit T)).

(** What the programmed point is: the tip (TIP) or the centre (CNT-CNT) of the nominal tool. *)
Inductive reference := TIP | CNT.
Definition nominal_tip r k P T := match r with TIP => P | CNT => sub P (scale (corner k) (unit T)) end.

(** The tip of the effective tool under PROG PATH OFF. *)
Definition effective_tip r k d P N T :=
  tip (contact (nominal_tip r k P T) N T (corner k) (ring k)) N T (corner k + dR2 d) (effective_ring k d).

(** The displacement of the tip. *)
Definition D_tip k d N T :=
  add (scale (dR2 d) (sub (unit N) (unit T))) (scale (effective_ring k d - ring k) (u N T)).

(** The displacement of the real tool against one without deltas, its length included. *)
Definition D_tool k d N T := add (D_tip k d N T) (scale (dL d) (unit T)).

(** What the axes are sent to: the tip of a tool of exactly the table length. *)
Definition axes r k d P N T := add (effective_tip r k d P N T) (scale (dL d) (unit T)).

(** * Directions *)

Lemma unit_norm v : v <> zero -> dot (unit v) (unit v) = 1.
Proof.
  intro H. pose proof (norm_pos v H) as P. unfold unit.
  rewrite dot_scale_l, dot_scale_r, <- norm_sqr. field. lra.
Qed.

Lemma unit_times_norm v : v <> zero -> scale (norm v) (unit v) = v.
Proof.
  intro H. pose proof (norm_pos v H) as P. unfold unit. rewrite scale_scale, Rinv_r, scale_one by lra. reflexivity.
Qed.

Lemma unit_zero : unit zero = zero.
Proof. unfold unit. apply scale_zero_r. Qed.

Lemma unit_scale k v : 0 < k -> v <> zero -> unit (scale k v) = unit v.
Proof.
  intros K H. pose proof (norm_pos v H) as P. unfold unit. rewrite norm_scale, (Rabs_right k) by lra.
  rewrite scale_scale. f_equal. field. lra.
Qed.

Lemma unit_scale_any k v : 0 < k -> unit (scale k v) = unit v.
Proof.
  intro K. destruct (Rtotal_order 0 (dot v v)) as [L | [E | G]].
  - apply unit_scale; auto. intro Z; subst; replace (dot zero zero) with 0 in L by vec_ring; lra.
  - symmetry in E; apply dot_self_zero in E; subst. rewrite scale_zero_r. reflexivity.
  - pose proof (dot_self_nonneg v); lra.
Qed.

Lemma w_squared N T : dot (w N T) (w N T) = dot T T * dot (cross N T) (cross N T).
Proof. unfold w; vec_ring. Qed.

(** heidenhain.face.ring-direction: w, made without a root, lies across the tool. *)
Theorem w_across N T : dot (w N T) T = 0.
Proof. unfold w; vec_ring. Qed.

Example w_across_instance : dot (w (Vec (3/5) 0 (4/5)) (Vec 0 0 1)) (Vec 0 0 1) = 0.
Proof. apply w_across. Qed.

(** heidenhain.face.along-the-tool: w vanishes exactly where the normal is parallel or opposite to the tool. *)
Theorem w_zero_iff_parallel N T : T <> zero -> (w N T = zero <-> parallel N T).
Proof.
  intro H. pose proof (dot_self_pos T H) as P. unfold parallel; split; intro E.
  - apply dot_self_zero. pose proof (w_squared N T) as S. rewrite E in S.
    replace (dot zero zero) with 0 in S by vec_ring. symmetry in S; apply Rmult_integral in S; destruct S; lra.
  - apply dot_self_zero. rewrite w_squared, E. vec_ring.
Qed.

Example w_zero_iff_parallel_instance : w (Vec 0 0 2) (Vec 0 0 1) = zero.
Proof.
  apply w_zero_iff_parallel.
  - intro E; injection E; intros; lra.
  - unfold parallel, cross, zero; cbn; f_equal; lra.
Qed.

Lemma w_nonzero N T : ~ parallel N T -> w N T <> zero.
Proof.
  intros H E. apply H. apply w_zero_iff_parallel; auto. intro Z; apply H; unfold parallel; subst; vec_ring.
Qed.

Lemma not_parallel_nonzero N T : ~ parallel N T -> N <> zero /\ T <> zero.
Proof. intro H; split; intro E; apply H; unfold parallel; subst; vec_ring. Qed.

(** heidenhain.face.along-the-tool: there the direction across is the zero vector, and the contact is on the axis. *)
Theorem u_along_the_tool N T : T <> zero -> parallel N T -> u N T = zero.
Proof. intros H P. unfold u. apply w_zero_iff_parallel in P; auto. rewrite P. apply unit_zero. Qed.

Example u_along_the_tool_instance : u (Vec 0 0 2) (Vec 0 0 1) = zero.
Proof.
  apply u_along_the_tool.
  - intro E; injection E; intros; lra.
  - unfold parallel, cross, zero; cbn; f_equal; lra.
Qed.

(** heidenhain.face.ring-direction: elsewhere it has length 1 and is at right angles to the tool. *)
Theorem u_unit_across N T : ~ parallel N T -> dot (u N T) (u N T) = 1 /\ dot (u N T) (unit T) = 0.
Proof.
  intro H. split.
  - apply unit_norm, w_nonzero, H.
  - unfold u, unit. rewrite dot_scale_l, dot_scale_r, w_across. ring.
Qed.

Lemma not_parallel_XZ : ~ parallel (Vec (3/5) 0 (4/5)) (Vec 0 0 1).
Proof. unfold parallel, cross, zero; cbn; intro E; injection E; intros; lra. Qed.

Example u_unit_across_instance :
  dot (u (Vec (3/5) 0 (4/5)) (Vec 0 0 1)) (u (Vec (3/5) 0 (4/5)) (Vec 0 0 1)) = 1.
Proof. apply u_unit_across, not_parallel_XZ. Qed.

Lemma u_dot_T N T : dot (u N T) (unit T) = 0.
Proof. unfold u, unit. rewrite dot_scale_l, dot_scale_r, w_across. ring. Qed.

(** The part of the normal across the tool. *)
Definition across N T := sub (unit N) (scale (dot (unit N) (unit T)) (unit T)).

Lemma w_is_across N T : N <> zero -> T <> zero -> w N T = scale (norm N * (norm T * norm T)) (across N T).
Proof.
  intros HN HT. rewrite <- (unit_times_norm N HN) at 1. rewrite <- (unit_times_norm T HT) at 1.
  pose proof (unit_norm T HT) as UT. unfold across. set (n := unit N) in *; set (t := unit T) in *; clearbody n t.
  set (a := norm N); set (b := norm T).
  assert (X : w (scale a n) (scale b t) = scale (a * (b * b)) (sub (scale (dot t t) n) (scale (dot n t) t)))
    by (unfold w; vec_ring).
  rewrite X, UT, scale_one. reflexivity.
Qed.

Lemma u_is_across N T : N <> zero -> T <> zero -> u N T = unit (across N T).
Proof.
  intros HN HT. pose proof (norm_pos N HN). pose proof (norm_pos T HT).
  unfold u. rewrite w_is_across by auto. apply unit_scale_any. repeat apply Rmult_lt_0_compat; auto.
Qed.

Lemma normal_dot_across N T : T <> zero -> dot (unit N) (across N T) = dot (across N T) (across N T).
Proof.
  intro HT. pose proof (unit_norm T HT) as UT. unfold across.
  set (n := unit N); set (t := unit T) in *; clearbody n t.
  assert (A : dot (sub n (scale (dot n t) t)) (sub n (scale (dot n t) t)) =
              dot n (sub n (scale (dot n t) t)) + (dot n t)² * (dot t t - 1)) by (unfold Rsqr; vec_ring).
  rewrite A, UT. unfold Rsqr; ring.
Qed.

Lemma normal_dot_u N T : N <> zero -> T <> zero -> dot (unit N) (u N T) = norm (across N T).
Proof.
  intros HN HT. rewrite u_is_across by auto. unfold unit at 2. rewrite dot_scale_r, normal_dot_across by auto.
  destruct (Rtotal_order 0 (norm (across N T))) as [L | [E | G]].
  - rewrite <- norm_sqr. field. lra.
  - rewrite <- norm_sqr, <- E. ring.
  - pose proof (norm_nonneg (across N T)); lra.
Qed.

(** heidenhain.face.ring-direction: the normal is c t + s u with the cosine c = n.t and a sine s = n.u that is never
    negative: u points from the wall to the axis. *)
Theorem normal_by_tool_and_ring N T : N <> zero -> T <> zero ->
  unit N = add (scale (dot (unit N) (unit T)) (unit T)) (scale (dot (unit N) (u N T)) (u N T)) /\
  0 <= dot (unit N) (u N T).
Proof.
  intros HN HT. rewrite normal_dot_u by auto. split; [| apply norm_nonneg].
  assert (U : scale (norm (across N T)) (u N T) = across N T).
  { rewrite u_is_across by auto. unfold unit. rewrite scale_scale.
    destruct (Rtotal_order 0 (norm (across N T))) as [L | [E | G]].
    - rewrite Rinv_r, scale_one by lra. reflexivity.
    - assert (Z : across N T = zero) by (apply dot_self_zero; rewrite <- norm_sqr, <- E; ring).
      rewrite Z. apply scale_zero_r.
    - pose proof (norm_nonneg (across N T)); lra. }
  rewrite U. unfold across. set (n := unit N); set (t := unit T); clearbody n t. vec_ring.
Qed.

Lemma XZ_nonzero : Vec (3/5) 0 (4/5) <> zero.
Proof. intro E; injection E; intros; lra. Qed.

Lemma Z_nonzero : Vec 0 0 1 <> zero.
Proof. intro E; injection E; intros; lra. Qed.

Example normal_by_tool_and_ring_instance : 0 <= dot (unit (Vec (3/5) 0 (4/5))) (u (Vec (3/5) 0 (4/5)) (Vec 0 0 1)).
Proof. apply normal_by_tool_and_ring; [apply XZ_nonzero | apply Z_nonzero]. Qed.

(** * The effective tool *)

(** heidenhain.face.effective-tip: the tip of the effective tool is the programmed tip and the displacement of the
    formula, for either reference point. *)
Theorem tip_moves_by_D_tip r k d P N T :
  effective_tip r k d P N T = add (nominal_tip r k P T) (D_tip k d N T).
Proof.
  unfold effective_tip, tip, contact, D_tip, ring. set (p := nominal_tip r k P T).
  set (n := unit N); set (t := unit T); set (x := u N T); set (e := effective_ring k d). clearbody p n t x e. vec_ring.
Qed.

Example tip_moves_by_D_tip_instance P :
  effective_tip TIP (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) P (Vec (3/5) 0 (4/5)) (Vec 0 0 1) =
  add P (D_tip (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) (Vec (3/5) 0 (4/5)) (Vec 0 0 1)).
Proof. exact (tip_moves_by_D_tip TIP _ _ P _ _). Qed.

(** heidenhain.face.effective-tip: the centre of the corner moves by exactly dR2 along the normal, whatever dR is. *)
Theorem corner_center_moves_along_the_normal k d p N T :
  sub (CR2 (add p (D_tip k d N T)) N T (corner k + dR2 d) (effective_ring k d)) (CR2 p N T (corner k) (ring k)) =
  scale (dR2 d) (unit N).
Proof.
  unfold CR2, D_tip. set (n := unit N); set (t := unit T); set (x := u N T); set (e := effective_ring k d).
  clearbody n t x e. vec_ring.
Qed.

Example corner_center_moves_along_the_normal_instance p :
  sub (CR2 (add p (D_tip (Tool 6 1) (Deltas 0 (-1/10) (-1/50)) (Vec 3 0 4) (Vec 0 0 1))) (Vec 3 0 4) (Vec 0 0 1)
    (1 + -1/50) (effective_ring (Tool 6 1) (Deltas 0 (-1/10) (-1/50)))) (CR2 p (Vec 3 0 4) (Vec 0 0 1) 1 (6 - 1)) =
  scale (-1/50) (unit (Vec 3 0 4)).
Proof. exact (corner_center_moves_along_the_normal (Tool 6 1) (Deltas 0 (-1/10) (-1/50)) p _ _). Qed.

(** heidenhain.face.effective-tip: the centre of the tool moves by dR2 n and by the change of the ring across. *)
Theorem center_moves k d p N T :
  sub (center (add p (D_tip k d N T)) T (corner k + dR2 d)) (center p T (corner k)) =
  add (scale (dR2 d) (unit N)) (scale (effective_ring k d - ring k) (u N T)).
Proof.
  unfold center, D_tip. set (n := unit N); set (t := unit T); set (x := u N T); set (e := effective_ring k d).
  clearbody n t x e. vec_ring.
Qed.

Example center_moves_instance p :
  sub (center (add p (D_tip (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) (Vec 3 0 4) (Vec 0 0 1))) (Vec 0 0 1) (3 + -1/10))
    (center p (Vec 0 0 1) 3) =
  add (scale (-1/10) (unit (Vec 3 0 4)))
    (scale (effective_ring (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) - ring (Tool 3 3)) (u (Vec 3 0 4) (Vec 0 0 1))).
Proof. exact (center_moves (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) p _ _). Qed.

(** The ring stays where dR = dR2. *)
Lemma ring_of_even_deltas k a b : corner k <= radius k -> effective_ring k (Deltas b a a) = ring k.
Proof. intro H. unfold effective_ring, ring; cbn [dR dR2]. rewrite Rmax_right; lra. Qed.

(** heidenhain.face.example-oversize-tip: DL = DR = DR2 = a moves the tool by exactly a n, every tool and every direction:
    an even oversize. *)
Theorem uniform_allowance k a N T : corner k <= radius k -> D_tool k (Deltas a a a) N T = scale a (unit N).
Proof.
  intro H. unfold D_tool, D_tip. rewrite ring_of_even_deltas by auto. cbn [dL dR dR2].
  set (n := unit N); set (t := unit T); set (x := u N T); set (e := ring k). clearbody n t x e. vec_ring.
Qed.

Example uniform_allowance_instance :
  D_tool (Tool 6 1) (Deltas (1/5) (1/5) (1/5)) (Vec 3 0 4) (Vec 0 0 1) = scale (1/5) (unit (Vec 3 0 4)).
Proof. apply uniform_allowance; cbn; lra. Qed.

(** heidenhain.face.effective-tip: along the normal the tip moves by dR2 (1 - c) + (rho' - rho) s, the distance between
    the tangent planes of both tools with their tips in one point. *)
Theorem displacement_along_the_normal k d N T : N <> zero ->
  dot (D_tip k d N T) (unit N) =
  dR2 d * (1 - dot (unit N) (unit T)) + (effective_ring k d - ring k) * dot (unit N) (u N T).
Proof.
  intro HN. pose proof (unit_norm N HN) as UN. unfold D_tip, sub, opp.
  rewrite !dot_add_l, !dot_scale_l, dot_add_l, dot_scale_l, UN, (dot_comm (u N T)), (dot_comm (unit T)). ring.
Qed.

Example displacement_along_the_normal_instance :
  dot (D_tip (Tool 6 0) (Deltas 0 (-1/10) 0) (Vec (3/5) 0 (4/5)) (Vec 0 0 1)) (unit (Vec (3/5) 0 (4/5))) =
  0 * (1 - dot (unit (Vec (3/5) 0 (4/5))) (unit (Vec 0 0 1))) +
  (effective_ring (Tool 6 0) (Deltas 0 (-1/10) 0) - ring (Tool 6 0)) *
    dot (unit (Vec (3/5) 0 (4/5))) (u (Vec (3/5) 0 (4/5)) (Vec 0 0 1)).
Proof. apply (displacement_along_the_normal (Tool 6 0) (Deltas 0 (-1/10) 0)), XZ_nonzero. Qed.

Lemma dot_at_most a b x y : 0 <= a -> 0 <= b -> dot x x <= a² -> dot y y <= b² -> - (a * b) <= dot x y.
Proof.
  intros A B X Y. pose proof (dot_bound x y) as C.
  assert (P : 0 <= a * b) by nra.
  apply Rsqr_neg_pos_le_0; auto.
  apply (Rle_trans _ (dot x x * dot y y)); auto.
  replace ((a * b)²) with (a² * b²) by (unfold Rsqr; ring).
  pose proof (dot_self_nonneg x). pose proof (dot_self_nonneg y). apply Rmult_le_compat; auto.
Qed.

(** heidenhain.face.effective-tip: the effective tool touches the contact plane at [q] and cuts nothing beyond it. Its
    points are those of the disc of radius rho' (centre on the axis, R2' above the tip), thickened by R2', and all that is
    above them along the tool, as far as the normal leans to the holder. *)
Theorem effective_tool_touches_the_plane q r2 rho e f h N T : N <> zero -> T <> zero -> 0 <= r2 -> 0 <= rho ->
  0 <= dot (unit N) (unit T) -> dot e (unit T) = 0 -> dot e e <= rho² -> dot f f <= r2² -> 0 <= h ->
  0 <= dot (sub (add (add (center (tip q N T r2 rho) T r2) (add e f)) (scale h (unit T))) q) (unit N).
Proof.
  intros HN HT R2 RHO LEAN ET EE FF H.
  assert (X : sub (add (add (center (tip q N T r2 rho) T r2) (add e f)) (scale h (unit T))) q =
              add (add (scale r2 (unit N)) (scale rho (u N T))) (add (add e f) (scale h (unit T)))).
  { unfold center, tip. set (n := unit N); set (t := unit T); set (x := u N T). clearbody n t x. vec_ring. }
  rewrite X. clear X. pose proof (unit_norm N HN) as UN.
  destruct (normal_by_tool_and_ring N T HN HT) as [SPLIT S].
  rewrite !dot_add_l, !dot_scale_l, UN, (dot_comm (u N T)), (dot_comm (unit T) (unit N)).
  assert (E : dot e (unit N) = dot (unit N) (u N T) * dot e (u N T)).
  { rewrite SPLIT at 1. rewrite dot_add_r, !dot_scale_r, ET. ring. }
  assert (UU : dot (u N T) (u N T) <= 1²).
  { destruct (Rtotal_order 0 (dot (w N T) (w N T))) as [L | [Z | G]].
    - right. unfold u. rewrite unit_norm; [unfold Rsqr; ring |].
      intro W; rewrite W in L; replace (dot zero zero) with 0 in L by vec_ring; lra.
    - symmetry in Z. apply dot_self_zero in Z. unfold u. rewrite Z, unit_zero. unfold Rsqr.
      replace (dot zero zero) with 0 by vec_ring. lra.
    - pose proof (dot_self_nonneg (w N T)); lra. }
  assert (A : - (rho * 1) <= dot e (u N T)) by (apply dot_at_most; auto; lra).
  assert (B : - (r2 * 1) <= dot f (unit N)).
  { apply dot_at_most; auto; [lra | rewrite UN; unfold Rsqr; lra]. }
  rewrite E. set (s := dot (unit N) (u N T)) in *. set (a := dot e (u N T)) in *. clearbody s a.
  assert (0 <= s * (rho + a)) by (apply Rmult_le_pos; lra).
  assert (0 <= h * dot (unit N) (unit T)) by (apply Rmult_le_pos; auto). nra.
Qed.

Lemma norm_XZ : norm (Vec (3/5) 0 (4/5)) = 1.
Proof. unfold norm, dot; cbn. replace (3/5 * (3/5) + 0 * 0 + 4/5 * (4/5)) with 1 by field. apply sqrt_1. Qed.

Lemma norm_Z : norm (Vec 0 0 1) = 1.
Proof. unfold norm, dot; cbn. replace (0 * 0 + 0 * 0 + 1 * 1) with 1 by ring. apply sqrt_1. Qed.

Lemma unit_of_unit v : norm v = 1 -> unit v = v.
Proof. intro H. unfold unit. rewrite H, Rinv_1. apply scale_one. Qed.

Example effective_tool_touches_the_plane_instance q :
  0 <= dot (sub (add (add (center (tip q (Vec (3/5) 0 (4/5)) (Vec 0 0 1) (21/10) (16/5)) (Vec 0 0 1) (21/10))
    (add (Vec 3 1 0) (Vec 1 (-1) 1))) (scale 7 (unit (Vec 0 0 1)))) q) (unit (Vec (3/5) 0 (4/5))).
Proof.
  apply effective_tool_touches_the_plane; try apply XZ_nonzero; try apply Z_nonzero; try lra;
    rewrite ?(unit_of_unit _ norm_XZ), ?(unit_of_unit _ norm_Z); unfold dot, Rsqr; cbn; lra.
Qed.

(** heidenhain.face.effective-tip: and the contact point is a point of the tool, on the corner. *)
Theorem contact_is_on_the_tool q r2 rho N T :
  add (center (tip q N T r2 rho) T r2) (add (scale (- rho) (u N T)) (scale (- r2) (unit N))) = q.
Proof.
  unfold center, tip. set (n := unit N); set (t := unit T); set (x := u N T). clearbody n t x. vec_ring.
Qed.

Example contact_is_on_the_tool_instance q :
  add (center (tip q (Vec 3 0 4) (Vec 0 0 1) 2 3) (Vec 0 0 1) 2)
    (add (scale (- 3) (u (Vec 3 0 4) (Vec 0 0 1))) (scale (- 2) (unit (Vec 3 0 4)))) = q.
Proof. apply contact_is_on_the_tool. Qed.

(** heidenhain.face.contact-point: contact point and tip are each other's inverse: the compensation keeps the contact. *)
Theorem contact_of_tip q N T r2 rho : contact (tip q N T r2 rho) N T r2 rho = q.
Proof.
  unfold contact, tip. set (n := unit N); set (t := unit T); set (x := u N T). clearbody n t x. vec_ring.
Qed.

Example contact_of_tip_instance q : contact (tip q (Vec 3 0 4) (Vec 0 0 1) 2 3) (Vec 3 0 4) (Vec 0 0 1) 2 3 = q.
Proof. apply contact_of_tip. Qed.

(** * Laws *)

(** heidenhain.face.not-normalized: lengths of normal and tool vector do not matter. *)
Theorem lengths_do_not_matter r k d P N T a b : 0 < a -> 0 < b ->
  effective_tip r k d P (scale a N) (scale b T) = effective_tip r k d P N T.
Proof.
  intros A B.
  assert (U : u (scale a N) (scale b T) = u N T).
  { unfold u. replace (w (scale a N) (scale b T)) with (scale (a * (b * b)) (w N T)) by (unfold w; vec_ring).
    apply unit_scale_any. repeat apply Rmult_lt_0_compat; auto. }
  unfold effective_tip, tip, contact, nominal_tip. rewrite U, !unit_scale_any by auto. reflexivity.
Qed.

Example lengths_do_not_matter_instance P :
  effective_tip TIP (Tool 6 1) (Deltas 0 0 (1/10)) P (scale 2 (Vec 3 0 4)) (scale 3 (Vec 0 0 1)) =
  effective_tip TIP (Tool 6 1) (Deltas 0 0 (1/10)) P (Vec 3 0 4) (Vec 0 0 1).
Proof. apply lengths_do_not_matter; lra. Qed.

(** heidenhain.program.reference-point: a program of tips and one of centres, R2 t apart, mean the same. *)
Theorem tip_and_center_programs k d P N T :
  effective_tip CNT k d (add P (scale (corner k) (unit T))) N T = effective_tip TIP k d P N T.
Proof.
  unfold effective_tip, nominal_tip.
  replace (sub (add P (scale (corner k) (unit T))) (scale (corner k) (unit T))) with P; [reflexivity |].
  set (t := unit T); clearbody t. vec_ring.
Qed.

Example tip_and_center_programs_instance P :
  effective_tip CNT (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) (add P (scale 3 (unit (Vec 0 0 1)))) (Vec 3 0 4) (Vec 0 0 1) =
  effective_tip TIP (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) P (Vec 3 0 4) (Vec 0 0 1).
Proof. exact (tip_and_center_programs (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) P (Vec 3 0 4) (Vec 0 0 1)). Qed.

(** heidenhain.face.applies: without deltas the tool stands where it is programmed. *)
Theorem without_deltas k P N T : corner k <= radius k -> effective_tip TIP k (Deltas 0 0 0) P N T = P.
Proof.
  intro H. rewrite tip_moves_by_D_tip. unfold D_tip. rewrite ring_of_even_deltas by auto. cbn [dR2 nominal_tip].
  set (n := unit N); set (t := unit T); set (x := u N T); set (e := ring k). clearbody n t x e. vec_ring.
Qed.

Example without_deltas_instance P : effective_tip TIP (Tool 6 1) (Deltas 0 0 0) P (Vec 3 0 4) (Vec 0 0 1) = P.
Proof. apply without_deltas; cbn; lra. Qed.

(** heidenhain.face.example-reworked-center: the centre of a ball moves by dR2 n, whatever the direction of the tool. *)
Theorem ball_center_moves_along_the_normal r a b P N T : effective_tip CNT (Tool r r) (Deltas b a a) P N T =
  sub (add P (scale a (unit N))) (scale (r + a) (unit T)).
Proof.
  rewrite tip_moves_by_D_tip. unfold D_tip. rewrite ring_of_even_deltas by (cbn; lra).
  unfold ring; cbn [dR2 nominal_tip corner radius].
  set (n := unit N); set (t := unit T); set (x := u N T). clearbody n t x. vec_ring.
Qed.

Example ball_center_moves_along_the_normal_instance P :
  effective_tip CNT (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) P (Vec 3 0 4) (Vec 0 0 1) =
  sub (add P (scale (-1/10) (unit (Vec 3 0 4)))) (scale (3 + -1/10) (unit (Vec 0 0 1))).
Proof. apply ball_center_moves_along_the_normal. Qed.

(** heidenhain.face.negative-length: the corner radius as a negative length, programmed at the tip, puts the axes where
    CNT-CNT puts them. *)
Theorem negative_length_is_center k a b c P N T :
  axes TIP k (Deltas (a - corner k) b c) P N T = axes CNT k (Deltas a b c) P N T.
Proof.
  unfold axes. rewrite !tip_moves_by_D_tip. unfold D_tip, effective_ring; cbn [dL dR dR2 nominal_tip].
  set (n := unit N); set (t := unit T); set (x := u N T).
  set (e := Rmax 0 (radius k + b - (corner k + c))); set (g := ring k). clearbody n t x e g. vec_ring.
Qed.

Example negative_length_is_center_instance P :
  axes TIP (Tool 3 3) (Deltas (0 - 3) (-1/10) (-1/10)) P (Vec 3 0 4) (Vec 0 0 1) =
  axes CNT (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) P (Vec 3 0 4) (Vec 0 0 1).
Proof. apply (negative_length_is_center (Tool 3 3)). Qed.

(** heidenhain.face.along-the-tool: with the tool along the normal the tip stays, whatever tool and deltas. *)
Theorem along_the_normal k d N T c : 0 < c -> N <> zero -> T = scale c N -> D_tip k d N T = zero.
Proof.
  intros C HN E.
  assert (HT : T <> zero).
  { intro Z. apply HN. rewrite <- (scale_one N), <- (Rinv_l c), <- scale_scale, <- E, Z by lra. apply scale_zero_r. }
  assert (U : u N T = zero) by (apply u_along_the_tool; auto; subst T; unfold parallel; vec_ring).
  unfold D_tip. rewrite U, E, unit_scale_any by auto. set (n := unit N); clearbody n.
  set (e := effective_ring k d - ring k). clearbody e. vec_ring.
Qed.

Example along_the_normal_instance :
  D_tip (Tool 6 1) (Deltas 0 (-1/10) (1/10)) (Vec (3/5) 0 (4/5)) (scale 2 (Vec (3/5) 0 (4/5))) = zero.
Proof. apply (along_the_normal _ _ _ _ 2); [lra | apply XZ_nonzero | reflexivity]. Qed.

Lemma u_of_right_angle N T : N <> zero -> T <> zero -> dot N T = 0 -> u N T = unit N.
Proof.
  intros HN HT E. pose proof (dot_self_pos T HT). unfold u, w. rewrite E.
  replace (sub (scale (dot T T) N) (scale 0 T)) with (scale (dot T T) N) by vec_ring. apply unit_scale_any. auto.
Qed.

(** heidenhain.peripheral.by-normal: at right angles to the tool the tip moves by dR n - dR2 t, so an end mill by dR n. *)
Theorem at_right_angles k d N T : N <> zero -> T <> zero -> dot N T = 0 -> corner k + dR2 d <= radius k + dR d ->
  D_tip k d N T = sub (scale (dR d) (unit N)) (scale (dR2 d) (unit T)).
Proof.
  intros HN HT E H. unfold D_tip. rewrite u_of_right_angle by auto.
  unfold effective_ring, ring. rewrite Rmax_right by lra.
  set (n := unit N); set (t := unit T). clearbody n t. vec_ring.
Qed.

Example at_right_angles_instance :
  D_tip (Tool 6 0) (Deltas 0 (-1/10) 0) (Vec (3/5) 0 (4/5)) (Vec 0 1 0) =
  sub (scale (-1/10) (unit (Vec (3/5) 0 (4/5)))) (scale 0 (unit (Vec 0 1 0))).
Proof.
  apply (at_right_angles (Tool 6 0) (Deltas 0 (-1/10) 0)); [apply XZ_nonzero | | unfold dot; cbn; lra | cbn; lra].
  intro E; injection E; intros; lra.
Qed.

(** heidenhain.face.without-tcpm: the tip moved by dR2 n, the naive reading, misses the contact plane of a ball by
    dR2 n.t: the surface is not kept. *)
Theorem naive_shift_misses_the_plane a b k N T : N <> zero -> corner k <= radius k ->
  dot (sub (scale a (unit N)) (D_tip k (Deltas b a a) N T)) (unit N) = a * dot (unit N) (unit T).
Proof.
  intros HN H. pose proof (unit_norm N HN) as UN. unfold sub at 1, opp.
  rewrite dot_add_l, !dot_scale_l, displacement_along_the_normal, ring_of_even_deltas, UN by auto. cbn [dR2]. ring.
Qed.

Example naive_shift_misses_the_plane_instance :
  dot (sub (scale (-1/10) (unit (Vec (3/5) 0 (4/5)))) (D_tip (Tool 3 3) (Deltas 0 (-1/10) (-1/10)) (Vec (3/5) 0 (4/5))
    (Vec 0 0 1))) (unit (Vec (3/5) 0 (4/5))) = -1/10 * dot (unit (Vec (3/5) 0 (4/5))) (unit (Vec 0 0 1)).
Proof. apply naive_shift_misses_the_plane; [apply XZ_nonzero | cbn; lra]. Qed.

Lemma move_unit m v : rigid m -> unit (move m v) = move m (unit v).
Proof. intro H. unfold unit. rewrite move_norm, move_scale by auto. reflexivity. Qed.

Lemma move_u m N T : rigid m -> u (move m N) (move m T) = move m (u N T).
Proof.
  intro H. unfold u. rewrite <- move_unit by auto. f_equal. unfold w.
  rewrite !move_dot, move_sub, !move_scale by auto. reflexivity.
Qed.

(** heidenhain.face.effective-tip: turning or mirroring everything turns or mirrors the result. *)
Theorem rigid_motion m r k d P N T : rigid m ->
  effective_tip r k d (move m P) (move m N) (move m T) = move m (effective_tip r k d P N T).
Proof.
  intro H. rewrite !tip_moves_by_D_tip. unfold D_tip.
  rewrite !move_unit, move_u, !move_add, !move_scale, !move_sub by auto.
  destruct r; cbn [nominal_tip]; [reflexivity |]. rewrite move_sub, move_scale, move_unit by auto. reflexivity.
Qed.

Example rigid_motion_instance r k d P N T :
  effective_tip r k d (move (Motion (Vec (3/5) (4/5) 0) (Vec (-4/5) (3/5) 0) (Vec 0 0 1)) P)
    (move (Motion (Vec (3/5) (4/5) 0) (Vec (-4/5) (3/5) 0) (Vec 0 0 1)) N)
    (move (Motion (Vec (3/5) (4/5) 0) (Vec (-4/5) (3/5) 0) (Vec 0 0 1)) T) =
  move (Motion (Vec (3/5) (4/5) 0) (Vec (-4/5) (3/5) 0) (Vec 0 0 1)) (effective_tip r k d P N T).
Proof. apply rigid_motion. unfold rigid, dot; cbn; repeat split; lra. Qed.

(** * Decisions without roots *)

Lemma square_mod_8 a : (a * a mod 8 = 0 \/ a * a mod 8 = 1 \/ a * a mod 8 = 4)%Z.
Proof.
  rewrite Z.mul_mod by lia. pose proof (Z.mod_pos_bound a 8 ltac:(lia)) as B.
  assert (C : (a mod 8 = 0 \/ a mod 8 = 1 \/ a mod 8 = 2 \/ a mod 8 = 3 \/
               a mod 8 = 4 \/ a mod 8 = 5 \/ a mod 8 = 6 \/ a mod 8 = 7)%Z) by lia.
  destruct C as [-> | [-> | [-> | [-> | [-> | [-> | [-> | ->]]]]]]]; cbn; auto.
Qed.

Lemma even_or_odd a : (exists h, a = 2 * h \/ a = 2 * h + 1)%Z.
Proof. exists (a / 2)%Z. pose proof (Z.div_mod a 2). pose proof (Z.mod_pos_bound a 2). lia. Qed.

(** heidenhain.face.below: no vectors in whole numbers, so none in decimals, make n.t exactly -0.0002: a sum of three
    squares is never 24999999 times a square. *)
Theorem no_tie_at_the_band m : forall a b c k : Z,
  (Z.abs k <= Z.of_nat m -> a * a + b * b + c * c = 24999999 * (k * k) -> k = 0)%Z.
Proof.
  induction m as [| m IH]; intros a b c k M E; [lia |].
  destruct (Z.eq_dec k 0) as [Z0 | K]; auto. exfalso.
  destruct (even_or_odd k) as [h [-> | ->]].
  - assert (P : forall x y z, (x * x + y * y + z * z = 4 * (24999999 * (h * h)) -> exists i, x = 2 * i)%Z).
    { intros x y z S. destruct (even_or_odd x) as [i [-> | ->]]; [exists i; auto |]. exfalso.
      destruct (even_or_odd y) as [j [-> | ->]]; destruct (even_or_odd z) as [l [-> | ->]]; lia. }
    destruct (P a b c ltac:(lia)) as [a' ->]. destruct (P b (2 * a') c ltac:(lia))%Z as [b' ->].
    destruct (P c (2 * a') (2 * b') ltac:(lia))%Z as [c' ->].
    apply K. rewrite (IH a' b' c' h); lia.
  - assert (Q : (24999999 * ((2 * h + 1) * (2 * h + 1)) mod 8 = 7)%Z).
    { destruct (even_or_odd h) as [i [-> | ->]].
      - replace (24999999 * ((2 * (2 * i) + 1) * (2 * (2 * i) + 1)))%Z
          with (7 + (24999999 * (2 * (i * i) + i) + 3124999) * 8)%Z by ring.
        apply Z_mod_plus_full.
      - replace (24999999 * ((2 * (2 * i + 1) + 1) * (2 * (2 * i + 1) + 1)))%Z
          with (7 + (24999999 * (2 * (i * i) + 3 * i + 1) + 3124999) * 8)%Z by ring.
        apply Z_mod_plus_full. }
    rewrite <- E, Z.add_mod, (Z.add_mod (a * a)) in Q by lia.
    destruct (square_mod_8 a) as [A | [A | A]]; destruct (square_mod_8 b) as [B | [B | B]];
      destruct (square_mod_8 c) as [C | [C | C]]; rewrite A, B, C in Q; cbn in Q; lia.
Qed.

Example no_tie_at_the_band_instance : forall a b c : Z, (a * a + b * b + c * c <> 24999999 * (3 * 3))%Z.
Proof. intros a b c E. pose proof (no_tie_at_the_band 3 a b c 3 ltac:(lia) E). lia. Qed.

(** heidenhain.tool.deviation-below: the contact angle is beyond a support point exactly where the product tells so. *)
Theorem beyond_by_product b N T : N <> zero -> T <> zero -> 0 <= b <= PI ->
  (b < angle N T <-> dot N T < cos b * (norm N * norm T)).
Proof.
  intros HN HT B. pose proof (cos_angle N T HN HT) as C. pose proof (angle_bounds N T) as A.
  assert (P : 0 < norm N * norm T) by (apply Rmult_lt_0_compat; apply norm_pos; auto).
  rewrite <- C. split; intro H.
  - apply Rmult_lt_compat_r; auto. apply cos_decreasing_1; lra.
  - apply Rmult_lt_reg_r in H; auto. apply cos_decreasing_0; lra.
Qed.

Example beyond_by_product_instance : 0 < angle (Vec 0 3 0) (Vec 0 0 1).
Proof.
  apply beyond_by_product.
  - intro E; injection E; intros; lra.
  - apply Z_nonzero.
  - pose proof PI_RGT_0; lra.
  - rewrite cos_0, norm_Z. unfold norm, dot; cbn. replace (0 * 0 + 3 * 0 + 0 * 1) with 0 by ring.
    replace (0 * 0 + 3 * 3 + 0 * 0) with (3 * 3) by ring. rewrite sqrt_square; lra.
Qed.

(** The deviation between two support points. *)
Definition tau b0 v0 b1 v1 theta := v0 + (v1 - v0) * (theta - b0) / (b1 - b0).

(** heidenhain.tool.deviation-segment: the deviations at the support points are those of the table, so a contact angle at
    one of them may count to either segment. *)
Theorem deviation_at_support_points b0 v0 b1 v1 : b0 < b1 -> tau b0 v0 b1 v1 b0 = v0 /\ tau b0 v0 b1 v1 b1 = v1.
Proof. intro H. unfold tau. split; field; lra. Qed.

Example deviation_at_support_points_instance : tau 40 (3/100) 50 (-2/100) 50 = -2/100.
Proof. apply deviation_at_support_points; lra. Qed.

(** heidenhain.tool.deviation-segment: the manual's example. *)
Theorem deviation_of_the_manual : tau 40 (3/100) 50 (-2/100) 45 = 5/1000.
Proof. unfold tau; lra. Qed.

Example deviation_of_the_manual_instance : tau 40 (3/100) 50 (-2/100) 45 - 5/1000 = 0.
Proof. rewrite deviation_of_the_manual; lra. Qed.

(** heidenhain.tool.effective-corner-radius: inside a segment the corner radius is negative exactly on one side of an
    angle that is rational where the table is: the contact angle is compared with it. *)
Theorem corner_radius_by_angle b0 v0 b1 v1 r theta : b0 < b1 -> v0 < v1 ->
  (r + tau b0 v0 b1 v1 theta < 0 <-> theta < b0 + (- r - v0) * (b1 - b0) / (v1 - v0)).
Proof.
  intros B V. set (z := b0 + (- r - v0) * (b1 - b0) / (v1 - v0)).
  assert (E : r + tau b0 v0 b1 v1 theta = (theta - z) * ((v1 - v0) / (b1 - b0))) by (unfold tau, z; field; lra).
  assert (P : 0 < (v1 - v0) / (b1 - b0)) by (apply Rdiv_lt_0_compat; lra).
  rewrite E. split; intro H; nra.
Qed.

Example corner_radius_by_angle_instance theta :
  -1/100 + tau 40 0 50 (2/100) theta < 0 <-> theta < 40 + (- (-1/100) - 0) * (50 - 40) / (2/100 - 0).
Proof. apply corner_radius_by_angle; lra. Qed.
