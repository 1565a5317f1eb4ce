(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-side-compensation: the vectors of G41.2 and G42.2 between two lines, with and without a basis of the
    compensation plane, and why they are the right ones.

    [VT] is the tool direction from tip to spindle at the corner, of any length; [U1] the displacement of the block that
    ends there, [U2] that of the block that starts there; [r] the offset value; [s] the side, 1 to the left (G41.2),
    -1 to the right (G42.2). Vectors are counted from the corner. *)
From Coq Require Import Reals Lra Psatz List.
From Toolcomp Require Import Vectors.
From Toolcomp Require CutterCompensationC.
Import ListNotations.
Open Scope R_scope.

(** * Definitions *)

Definition sided s := s = 1 \/ s = -1.
Definition unit v := scale (/ norm v) v.

(** The projection of a displacement to the plane across the tool, and its direction. *)
Definition across VT U := sub U (scale (dot U VT / dot VT VT) VT).
Definition d VT U := unit (across VT U).

(** The normal of a displacement on the side of the tool. *)
Definition n s VT U := scale (s / norm (cross VT U)) (cross VT U).

(** The predicates that choose the class of a corner: [S] > 0 inner, [S] < 0 outer; [C] the sign of the turn's cosine. *)
Definition S s VT U1 U2 := s * dot VT (cross U1 U2).
Definition C VT U1 U2 := dot (cross VT U1) (cross VT U2).

(** The intersection of the two offset lines, and the two vectors of an acute corner. *)
Definition cosine VT U1 U2 := dot (d VT U1) (d VT U2).
Definition Vi r s VT U1 U2 := scale (r / (1 + cosine VT U1 U2)) (add (n s VT U1) (n s VT U2)).
Definition K1 r s VT U1 := scale r (add (n s VT U1) (d VT U1)).
Definition K2 r s VT U2 := scale r (sub (n s VT U2) (d VT U2)).

(** The group of vectors between two lines in the mode. *)
Definition group r s VT U1 U2 :=
  if Rlt_dec 0 (S s VT U1 U2) then [Vi r s VT U1 U2]
  else if Rle_dec 0 (C VT U1 U2) then [Vi r s VT U1 U2]
  else [K1 r s VT U1; K2 r s VT U2].

(** The vector of a change of side between two lines that are not parallel: [s] before the corner, [- s] after it. *)
Definition side_change r s VT U1 U2 :=
  scale (r / (1 - cosine VT U1 U2)) (add (n s VT U1) (n (- s) VT U2)).

(** The manual's system C2, by Gram and Schmidt from the tool direction and two auxiliary vectors. *)
Definition axis1 VT := unit VT.
Definition axis2 VT a2 := unit (sub a2 (scale (dot a2 (axis1 VT)) (axis1 VT))).
Definition axis3 VT a2 a3 := unit (sub (sub a3 (scale (dot a3 (axis1 VT)) (axis1 VT)))
  (scale (dot a3 (axis2 VT a2)) (axis2 VT a2))).

(** The matrix M of the manual, its first two rows alone (the component along the tool is dropped), and the way back. *)
Definition dropped VT a2 a3 P := Vec (dot (axis2 VT a2) P) (dot (axis3 VT a2 a3) P) 0.
Definition back VT a2 a3 v := add (scale (vx v) (axis2 VT a2)) (scale (vy v) (axis3 VT a2 a3)).

(** The manual's way: P, Q and R are turned into C2, the corner is that of cutter compensation C, and is turned back. *)
Definition manual_group r s VT a2 a3 P Q R :=
  let P' := dropped VT a2 a3 P in
  let Q' := dropped VT a2 a3 Q in
  let R' := dropped VT a2 a3 R in
  map (back VT a2 a3) (CutterCompensationC.group (s * r) (unit (sub Q' P')) (unit (sub R' Q'))).

(** The handedness of C2: positive exactly where it is right-handed. *)
Definition handed VT a2 a3 := dot VT (cross a2 a3).

(** The three conditions of the check at a change of the compensation plane: the tool turns from [Va] to [Vb] by the
    limit or more, the vectors keep their side, and the second displacement goes back against the first. *)
Definition overcut limit Va Vb Ua Ub :=
  limit <= angle Va Vb /\ 0 <= dot (cross Va Ua) (cross Vb Ub) /\ dot (across Va Ua) (across Va Ub) < 0.

(** * Basic facts *)

Ltac values := unfold S, C, handed, parallel, dot, cross, sub, opp, add, scale, zero, Rsqr in *; cbn [vx vy vz] in *; try lra.

Lemma not_parallel_x u v : vy u * vz v - vz u * vy v <> 0 -> ~ parallel u v.
Proof. intros H E; apply H; apply (f_equal vx) in E; unfold cross, zero in E; cbn in E; lra. Qed.
Lemma not_parallel_y u v : vz u * vx v - vx u * vz v <> 0 -> ~ parallel u v.
Proof. intros H E; apply H; apply (f_equal vy) in E; unfold cross, zero in E; cbn in E; lra. Qed.
Lemma not_parallel_z u v : vx u * vy v - vy u * vx v <> 0 -> ~ parallel u v.
Proof. intros H E; apply H; apply (f_equal vz) in E; unfold cross, zero in E; cbn in E; lra. Qed.

Lemma tool_nonzero VT U : ~ parallel VT U -> VT <> zero.
Proof. intros H E; apply H; subst; unfold parallel; vec_ring. Qed.

Lemma sided_square s : sided s -> s * s = 1.
Proof. intros [E | E]; subst; ring. Qed.

Lemma sided_opp s : sided s -> sided (- s).
Proof. unfold sided; intros [E | E]; subst; [right | left]; lra. Qed.

Lemma unit_unit v : v <> zero -> dot (unit v) (unit v) = 1.
Proof.
  intro H. unfold unit. rewrite dot_scale_l, dot_scale_r, <- norm_sqr. pose proof (norm_pos v H). field; lra.
Qed.

Lemma unit_scale k v : 0 < k -> unit (scale k v) = unit v.
Proof.
  intro K. unfold unit. rewrite norm_scale, (Rabs_right k), scale_scale by lra.
  destruct (Req_dec (norm v) 0) as [Z | Z]; [| f_equal; field; lra].
  assert (E : v = zero) by (apply dot_self_zero; rewrite <- norm_sqr, Z; ring).
  rewrite E, !scale_zero_r; reflexivity.
Qed.

Lemma sub_self_zero v : sub v v = zero.
Proof. vec_ring. Qed.

(** Binet's and Cauchy's identity. *)
Lemma cross_dot_cross a b c e : dot (cross a b) (cross c e) = dot a c * dot b e - dot a e * dot b c.
Proof. vec_ring. Qed.

Lemma cross_scale_l k u v : cross (scale k u) v = scale k (cross u v).
Proof. vec_ring. Qed.
Lemma cross_scale_r k u v : cross u (scale k v) = scale k (cross u v).
Proof. vec_ring. Qed.
Lemma cross_add_r u v w : cross u (add v w) = add (cross u v) (cross u w).
Proof. vec_ring. Qed.
Lemma dot_cross_l u v : dot (cross u v) u = 0.
Proof. vec_ring. Qed.
Lemma dot_cross_r u v : dot (cross u v) v = 0.
Proof. vec_ring. Qed.
Lemma dot_cross_swap e u v : dot (cross e u) v = - dot u (cross e v).
Proof. vec_ring. Qed.

(** A vector by two others and their cross product. *)
Lemma by_cross a b y : scale (dot (cross a b) (cross a b)) y =
  add (scale (dot y (cross a b)) (cross a b))
      (add (scale (dot y a * dot b b - dot y b * dot a b) a) (scale (dot y b * dot a a - dot y a * dot a b) b)).
Proof. vec_ring. Qed.

(** The same in a right-angled frame. *)
Lemma by_frame e a y : dot e e = 1 -> dot a a = 1 -> dot e a = 0 ->
  y = add (scale (dot y (cross e a)) (cross e a)) (add (scale (dot y e) e) (scale (dot y a) a)).
Proof.
  intros E A P. pose proof (by_cross e a y) as B.
  rewrite cross_dot_cross, E, A, P, (dot_comm a e), P in B.
  replace (1 * 1 - 0 * 0) with 1 in B by ring. rewrite scale_one in B. rewrite B at 1.
  f_equal; f_equal; f_equal; ring.
Qed.

(** * The projection, the direction and the normal *)

Lemma across_tool VT U : VT <> zero -> dot (across VT U) VT = 0.
Proof.
  intro H. pose proof (dot_self_pos VT H). unfold across, sub, opp. rewrite dot_add_l, !dot_scale_l. field; lra.
Qed.

Lemma cross_across VT U : cross VT (across VT U) = cross VT U.
Proof. unfold across; set (k := dot U VT / dot VT VT); clearbody k; vec_ring. Qed.

Lemma across_products VT U W : VT <> zero ->
  dot (cross VT U) (cross VT W) = dot VT VT * dot (across VT U) (across VT W).
Proof.
  intro H. pose proof (dot_self_pos VT H) as P.
  rewrite <- (cross_across VT U), <- (cross_across VT W), cross_dot_cross, (dot_comm VT (across VT W)),
    !across_tool by auto. ring.
Qed.

Lemma across_nonzero VT U : ~ parallel VT U -> across VT U <> zero.
Proof.
  intros H E. apply H. unfold parallel. rewrite <- cross_across, E. vec_ring.
Qed.

Lemma cross_norm VT U : VT <> zero -> norm (cross VT U) = norm VT * norm (across VT U).
Proof.
  intro H. unfold norm. rewrite across_products, sqrt_mult_alt by (auto; apply dot_self_nonneg). reflexivity.
Qed.

Lemma d_tool VT U : VT <> zero -> dot (d VT U) VT = 0.
Proof. intro H; unfold d, unit; rewrite dot_scale_l, across_tool by auto; ring. Qed.

Lemma d_unit VT U : ~ parallel VT U -> dot (d VT U) (d VT U) = 1.
Proof. intro H; apply unit_unit, across_nonzero, H. Qed.

Lemma n_tool s VT U : dot (n s VT U) VT = 0.
Proof. unfold n; rewrite dot_scale_l, dot_cross_l; ring. Qed.

(** The normal is the direction, turned by a right angle about the tool. *)
Lemma n_turned s VT U : ~ parallel VT U -> n s VT U = scale s (cross (unit VT) (d VT U)).
Proof.
  intro H. pose proof (tool_nonzero VT U H) as T. pose proof (norm_pos _ T). pose proof (norm_pos _ (across_nonzero VT U H)).
  unfold n, d, unit. rewrite cross_norm by auto.
  rewrite cross_scale_l, cross_scale_r, cross_across, !scale_scale. f_equal. field; lra.
Qed.

Lemma tool_unit_d VT U : VT <> zero -> dot (unit VT) (d VT U) = 0.
Proof. intro H; unfold unit at 1; rewrite dot_scale_l, dot_comm, d_tool by auto; ring. Qed.

(** Products of normals and directions: [c] the cosine and [t] the sine of the turn toward the side of the tool. *)
Lemma n_dot_n s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  dot (n s VT U1) (n s VT U2) = cosine VT U1 U2.
Proof.
  intros A H1 H2. pose proof (tool_nonzero VT U1 H1) as T.
  rewrite !n_turned, dot_scale_l, dot_scale_r, cross_dot_cross, (dot_comm (d VT U1) (unit VT)), !tool_unit_d, unit_unit
    by auto.
  unfold cosine. replace (s * (s * (1 * dot (d VT U1) (d VT U2) - 0 * 0))) with (s * s * dot (d VT U1) (d VT U2)) by ring.
  rewrite sided_square by auto; ring.
Qed.

Lemma n_dot_n_other s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  dot (n s VT U1) (n (- s) VT U2) = - cosine VT U1 U2.
Proof.
  intros A H1 H2. rewrite <- (n_dot_n s VT U1 U2) by auto. unfold n. rewrite !dot_scale_l, !dot_scale_r.
  unfold Rdiv; ring.
Qed.

Lemma n_unit s VT U : sided s -> ~ parallel VT U -> dot (n s VT U) (n s VT U) = 1.
Proof. intros; rewrite n_dot_n by auto; apply d_unit; auto. Qed.

Lemma n_dot_d s VT U : ~ parallel VT U -> dot (n s VT U) (d VT U) = 0.
Proof. intro H; rewrite n_turned, dot_scale_l, dot_cross_r by auto; ring. Qed.

Lemma n_dot_d_swap s VT U1 U2 : ~ parallel VT U1 -> ~ parallel VT U2 ->
  dot (n s VT U1) (d VT U2) = - dot (n s VT U2) (d VT U1).
Proof.
  intros H1 H2. rewrite !n_turned, !dot_scale_l, dot_cross_swap, (dot_comm (d VT U1)) by auto. ring.
Qed.

(** The sign of the sine is that of [S]. *)
Lemma n_dot_d_S s VT U1 U2 : ~ parallel VT U1 -> ~ parallel VT U2 ->
  dot (n s VT U1) (d VT U2) = / norm (cross VT U1) * / norm (across VT U2) * S s VT U1 U2.
Proof.
  intros H1 H2. pose proof (tool_nonzero VT U1 H1) as T. pose proof (dot_self_pos VT T).
  unfold n, d, unit, S. rewrite dot_scale_l, dot_scale_r.
  assert (E : dot (cross VT U1) (across VT U2) = dot VT (cross U1 U2)).
  { unfold across, sub, opp. rewrite dot_add_r, !dot_scale_r, dot_cross_l.
    transitivity (dot (cross VT U1) U2); [ring | vec_ring]. }
  rewrite E. unfold Rdiv; ring.
Qed.

Lemma cosine_C VT U1 U2 : VT <> zero ->
  C VT U1 U2 = norm (cross VT U1) * norm (cross VT U2) * cosine VT U1 U2.
Proof.
  intro T. unfold C, cosine, d, unit. rewrite across_products, dot_scale_l, dot_scale_r, !cross_norm, <- norm_sqr by auto.
  destruct (Req_dec (norm (across VT U1)) 0) as [Z1 | Z1].
  { assert (E : across VT U1 = zero) by (apply dot_self_zero; rewrite <- norm_sqr, Z1; ring).
    rewrite Z1, E. replace (dot zero (across VT U2)) with 0 by vec_ring. ring. }
  destruct (Req_dec (norm (across VT U2)) 0) as [Z2 | Z2].
  { assert (E : across VT U2 = zero) by (apply dot_self_zero; rewrite <- norm_sqr, Z2; ring).
    rewrite Z2, E. replace (dot (across VT U1) zero) with 0 by vec_ring. ring. }
  field; auto.
Qed.

Lemma cosine_range VT U1 U2 : ~ parallel VT U1 -> ~ parallel VT U2 -> -1 <= cosine VT U1 U2 <= 1.
Proof.
  intros H1 H2. pose proof (dot_bound (d VT U1) (d VT U2)) as B. rewrite !d_unit in B by auto.
  unfold cosine. unfold Rsqr in B. nra.
Qed.

(** A tool in the plane of X and Z, and displacements across it: the examples. *)
Lemma tool_345_y b : b <> 0 -> ~ parallel (Vec 3 0 4) (Vec 0 b 0).
Proof. intro H; apply not_parallel_x; cbn; lra. Qed.
Lemma tool_345_x : ~ parallel (Vec 3 0 4) (Vec 100 0 0).
Proof. apply not_parallel_y; cbn; lra. Qed.
Lemma tool_345_back : ~ parallel (Vec 3 0 4) (Vec 94 (-60) (-8)).
Proof. apply not_parallel_y; cbn; lra. Qed.
Lemma left_sided : sided 1.
Proof. left; reflexivity. Qed.
Lemma right_sided : sided (-1).
Proof. right; reflexivity. Qed.
#[local] Hint Resolve tool_345_x tool_345_back left_sided right_sided : core.
#[local] Hint Extern 1 (~ parallel (Vec 3 0 4) (Vec 0 _ 0)) => apply tool_345_y; lra : core.

Ltac forms := rewrite ?dot_scale_l, ?dot_scale_r; rewrite ?dot_add_l, ?dot_add_r; rewrite ?dot_scale_l, ?dot_scale_r.

(** * The plane and the offset lines *)

(** fanuc.tool-side.plane: every vector of a corner is perpendicular to the tool. *)
Theorem group_across_tool r s VT U1 U2 : VT <> zero -> Forall (fun V => dot V VT = 0) (group r s VT U1 U2).
Proof.
  intro T.
  assert (I : dot (Vi r s VT U1 U2) VT = 0) by (unfold Vi; forms; rewrite !n_tool; ring).
  unfold group. destruct (Rlt_dec 0 (S s VT U1 U2)); [| destruct (Rle_dec 0 (C VT U1 U2))]; repeat constructor; auto.
  - unfold K1; forms; rewrite n_tool, d_tool by auto; ring.
  - unfold K2, sub, opp; forms; rewrite n_tool, d_tool by auto; ring.
Qed.

Lemma tool_345_nonzero : Vec 3 0 4 <> zero.
Proof. intro E; injection E; intros; lra. Qed.
#[local] Hint Resolve tool_345_nonzero : core.

Example group_across_tool_instance :
  Forall (fun V => dot V (Vec 3 0 4) = 0) (group 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 94 (-60) (-8))).
Proof. apply group_across_tool; auto. Qed.

(** fanuc.tool-side.moving-block: a block along the tool [Va] of the block before leaves nothing in the plane there; it
    moves in the plane of its own tool [VT] all the same, and every vector made at its end is across that tool. *)
Theorem along_the_tool_before r s k Va VT U2 : k <> 0 -> ~ parallel VT Va ->
  across Va (scale k Va) = zero /\ across VT (scale k Va) <> zero /\
  Forall (fun V => dot V VT = 0) (group r s VT (scale k Va) U2).
Proof.
  intros K H. pose proof (tool_nonzero VT Va H) as T.
  assert (A : Va <> zero) by (intro E; apply H; subst; unfold parallel; vec_ring).
  pose proof (dot_self_pos Va A) as P. split; [| split].
  - unfold across. rewrite dot_scale_l. replace (k * dot Va Va / dot Va Va) with k by (field; lra). apply sub_self_zero.
  - apply across_nonzero. unfold parallel. rewrite cross_scale_r. intro E. apply H.
    apply (f_equal (scale (/ k))) in E. rewrite scale_scale, scale_zero_r in E.
    replace (/ k * k) with 1 in E by (field; auto). rewrite scale_one in E. exact E.
  - apply group_across_tool, T.
Qed.

(** An example: 80 along Y, the tool of the block before, while it turns to (-4, 4, 7)/9; then along X. *)
Example along_the_tool_before_instance :
  across (Vec 0 1 0) (scale 80 (Vec 0 1 0)) = zero /\ across (Vec (-4) 4 7) (scale 80 (Vec 0 1 0)) <> zero /\
  Forall (fun V => dot V (Vec (-4) 4 7) = 0) (group 5 1 (Vec (-4) 4 7) (scale 80 (Vec 0 1 0)) (Vec 50 0 0)).
Proof. apply along_the_tool_before; [lra | apply not_parallel_x; cbn; lra]. Qed.

(** fanuc.tool-side.inner: the intersection vector lies on both offset lines: V.n1 = V.n2 = r. *)
Theorem Vi_on_both_lines r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 -> 1 + cosine VT U1 U2 <> 0 ->
  dot (Vi r s VT U1 U2) (n s VT U1) = r /\ dot (Vi r s VT U1 U2) (n s VT U2) = r.
Proof.
  intros A H1 H2 K. unfold Vi. forms. rewrite (dot_comm (n s VT U2) (n s VT U1)), !n_unit, n_dot_n by auto.
  split; field; auto.
Qed.

Lemma cosine_of_C VT U1 U2 : ~ parallel VT U1 -> ~ parallel VT U2 -> 0 <= C VT U1 U2 -> 0 <= cosine VT U1 U2.
Proof.
  intros H1 H2 H. pose proof (tool_nonzero VT U1 H1) as T. rewrite cosine_C in H by auto.
  pose proof (norm_pos _ H1). pose proof (norm_pos _ H2).
  assert (P : 0 < norm (cross VT U1) * norm (cross VT U2)) by (apply Rmult_lt_0_compat; auto).
  apply Rnot_lt_le; intro G. nra.
Qed.

(** The corner of golden example TS2 has a cosine of 0. *)
Lemma cosine_example : 1 + cosine (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0) <> 0.
Proof.
  assert (0 <= cosine (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0)) by (apply cosine_of_C; auto; values). lra.
Qed.
#[local] Hint Resolve cosine_example : core.

Example Vi_on_both_lines_instance :
  dot (Vi 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0)) (n 1 (Vec 3 0 4) (Vec 0 100 0)) = 10 /\
  dot (Vi 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0)) (n 1 (Vec 3 0 4) (Vec 100 0 0)) = 10.
Proof. apply Vi_on_both_lines; auto. Qed.

(** A vector across the tool and the normal of a line is along the line. *)
Lemma along_the_line s VT U x : sided s -> ~ parallel VT U -> dot x VT = 0 -> dot x (n s VT U) = 0 ->
  x = scale (dot x (d VT U)) (d VT U).
Proof.
  intros A H X0 X1. pose proof (tool_nonzero VT U H) as T.
  pose proof (by_frame (unit VT) (d VT U) x (unit_unit VT T) (d_unit VT U H) (tool_unit_d VT U T)) as F.
  assert (Y0 : dot x (unit VT) = 0) by (unfold unit; rewrite dot_scale_r, X0; ring).
  assert (Y1 : dot x (cross (unit VT) (d VT U)) = 0).
  { rewrite n_turned, dot_scale_r in X1 by auto. destruct A; subst s; lra. }
  rewrite Y0, Y1, !scale_zero_l in F. rewrite F at 1.
  set (k := dot x (d VT U)); clearbody k; set (u := d VT U); clearbody u; vec_ring.
Qed.

Lemma sub_zero V W : sub W V = zero -> V = W.
Proof.
  intro F. apply vec_eq; [apply (f_equal vx) in F | apply (f_equal vy) in F | apply (f_equal vz) in F];
    unfold sub, opp, add, scale, zero in F; cbn in F; lra.
Qed.

Lemma dot_sub_l V W x : dot (sub W V) x = dot W x - dot V x.
Proof. vec_ring. Qed.

Lemma Vi_across r s VT U1 U2 : dot (Vi r s VT U1 U2) VT = 0.
Proof. unfold Vi; forms; rewrite !n_tool; ring. Qed.

(** fanuc.tool-side.inner: where 1 + c is not 0 there is exactly one vector across the tool that lies on both offset lines
    and on the bisector of the corner (as far along one line as against the other). *)
Theorem Vi_exists_once r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 -> 1 + cosine VT U1 U2 <> 0 ->
  exists! V, dot V VT = 0 /\ dot V (n s VT U1) = r /\ dot V (n s VT U2) = r /\ dot V (add (d VT U1) (d VT U2)) = 0.
Proof.
  intros A H1 H2 K. exists (Vi r s VT U1 U2).
  assert (B : dot (Vi r s VT U1 U2) (add (d VT U1) (d VT U2)) = 0).
  { unfold Vi. forms. rewrite !n_dot_d, (n_dot_d_swap s VT U1 U2) by auto. ring. }
  pose proof (Vi_on_both_lines r s VT U1 U2 A H1 H2 K) as [L1 L2]. pose proof (Vi_across r s VT U1 U2) as L0.
  split; [auto |]. intros W (W0 & W1 & W2 & W3).
  set (V := Vi r s VT U1 U2) in *; clearbody V.
  pose proof (along_the_line s VT U1 (sub W V) A H1) as F.
  rewrite !(dot_sub_l V W) in F. specialize (F ltac:(lra) ltac:(lra)).
  assert (X : dot (sub W V) (add (d VT U1) (d VT U2)) = 0) by (rewrite dot_sub_l; lra).
  rewrite F, dot_scale_l, dot_add_r, d_unit in X by auto. fold (cosine VT U1 U2) in X.
  apply Rmult_integral in X. destruct X as [X | X]; [| tauto].
  apply sub_zero. rewrite F, X. apply scale_zero_l.
Qed.

Example Vi_exists_once_instance : exists! V,
  dot V (Vec 3 0 4) = 0 /\ dot V (n 1 (Vec 3 0 4) (Vec 0 100 0)) = 10 /\
  dot V (n 1 (Vec 3 0 4) (Vec 100 0 0)) = 10 /\ dot V (add (d (Vec 3 0 4) (Vec 0 100 0)) (d (Vec 3 0 4) (Vec 100 0 0))) = 0.
Proof. apply Vi_exists_once; auto. Qed.

(** Straight back there is no turn to either side. *)
Lemma reversal_has_no_turn s VT U1 U2 : ~ parallel VT U1 -> ~ parallel VT U2 -> 1 + cosine VT U1 U2 = 0 ->
  dot (n s VT U1) (d VT U2) = 0.
Proof.
  intros H1 H2 K.
  assert (Z : dot (add (d VT U1) (d VT U2)) (add (d VT U1) (d VT U2)) = 0).
  { rewrite !dot_add_l, !dot_add_r, !d_unit, (dot_comm (d VT U2)) by auto. fold (cosine VT U1 U2). lra. }
  apply dot_self_zero in Z. pose proof (n_dot_d s VT U1 H1) as D.
  replace (d VT U2) with (sub (add (d VT U1) (d VT U2)) (d VT U1)) by (set (a := d VT U1); set (b := d VT U2); vec_ring).
  rewrite Z. unfold sub, opp. rewrite dot_add_r, dot_scale_r, D. vec_ring.
Qed.

Lemma turn_of_S s VT U1 U2 : ~ parallel VT U1 -> ~ parallel VT U2 ->
  (dot (n s VT U1) (d VT U2) = 0 <-> S s VT U1 U2 = 0).
Proof.
  intros H1 H2. rewrite n_dot_d_S by auto.
  pose proof (Rinv_0_lt_compat _ (norm_pos _ H1)). pose proof (Rinv_0_lt_compat _ (norm_pos _ (across_nonzero VT U2 H2))).
  split; intro Z; [| rewrite Z; ring].
  apply Rmult_integral in Z. destruct Z as [Z | Z]; [| auto]. apply Rmult_integral in Z. lra.
Qed.

(** fanuc.tool-side.inner: of two lines at an angle no other vector across the tool lies on both offset lines. *)
Theorem Vi_unique r s VT U1 U2 V : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 -> S s VT U1 U2 <> 0 ->
  dot V VT = 0 -> dot V (n s VT U1) = r -> dot V (n s VT U2) = r -> Vi r s VT U1 U2 = V.
Proof.
  intros A H1 H2 N V0 V1 V2.
  assert (K : 1 + cosine VT U1 U2 <> 0).
  { intro K. apply N, turn_of_S; auto. apply reversal_has_no_turn; auto. }
  pose proof (Vi_on_both_lines r s VT U1 U2 A H1 H2 K) as [L1 L2]. pose proof (Vi_across r s VT U1 U2) as L0.
  set (W := Vi r s VT U1 U2) in *; clearbody W.
  pose proof (along_the_line s VT U1 (sub V W) A H1) as F.
  rewrite !(dot_sub_l W V) in F. specialize (F ltac:(lra) ltac:(lra)).
  assert (X : dot (sub V W) (n s VT U2) = 0) by (rewrite dot_sub_l; lra).
  rewrite F, dot_scale_l, (dot_comm (d VT U1)) in X.
  apply Rmult_integral in X. destruct X as [X | X]; [apply sub_zero; rewrite F, X; apply scale_zero_l | exfalso].
  apply N, turn_of_S; auto. rewrite n_dot_d_swap by auto. lra.
Qed.

(** Of golden example TS2. *)
Lemma norm_is u m : 0 <= m -> dot u u = m * m -> norm u = m.
Proof. intros H E; unfold norm; rewrite E; apply sqrt_square, H. Qed.

Ltac normals :=
  unfold n; rewrite ?(norm_is (cross (Vec 3 0 4) (Vec 0 100 0)) 500), ?(norm_is (cross (Vec 3 0 4) (Vec 100 0 0)) 400)
    by values; values.

Example Vi_unique_instance : Vec (-8) 10 6 = Vi 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0).
Proof. symmetry; apply Vi_unique; auto; normals. Qed.

(** fanuc.tool-side.inner: the square of the vector's length is 2 r² / (1 + c), however sharp the corner. *)
Theorem Vi_length r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 -> 1 + cosine VT U1 U2 <> 0 ->
  dot (Vi r s VT U1 U2) (Vi r s VT U1 U2) = 2 * r² / (1 + cosine VT U1 U2).
Proof.
  intros A H1 H2 K. unfold Vi at 2. forms. destruct (Vi_on_both_lines r s VT U1 U2 A H1 H2 K) as [-> ->].
  unfold Rsqr; field; auto.
Qed.

Example Vi_length_instance :
  dot (Vi 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0)) (Vi 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0)) =
  2 * 10² / (1 + cosine (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0)).
Proof. apply Vi_length; auto. Qed.

(** fanuc.tool-side.straight-or-reversal: straight back in the compensation plane the two offset lines have no point in
    common, which is why a reversal counts as acute. *)
Theorem reversal_has_no_intersection r s VT U1 U2 V : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 -> r <> 0 ->
  cosine VT U1 U2 = -1 -> dot V (n s VT U1) = r -> dot V (n s VT U2) <> r.
Proof.
  intros A H1 H2 R K V1 V2.
  assert (Z : dot (add (n s VT U1) (n s VT U2)) (add (n s VT U1) (n s VT U2)) = 0).
  { rewrite !dot_add_l, !dot_add_r, !n_unit, (dot_comm (n s VT U2)), n_dot_n by auto. lra. }
  apply dot_self_zero in Z. apply (f_equal (dot V)) in Z. rewrite dot_add_r, V1, V2 in Z.
  replace (dot V zero) with 0 in Z by vec_ring. lra.
Qed.

Lemma cosine_back VT U k : 0 < k -> ~ parallel VT U -> cosine VT U (scale (- k) U) = -1.
Proof.
  intros K H. unfold cosine, d.
  replace (across VT (scale (- k) U)) with (scale k (opp (across VT U))).
  - rewrite unit_scale by auto. unfold unit. rewrite norm_opp. unfold opp.
    rewrite !dot_scale_l, !dot_scale_r, <- norm_sqr. pose proof (norm_pos _ (across_nonzero VT U H)). field; lra.
  - unfold across. replace (dot (scale (- k) U) VT / dot VT VT) with (- k * (dot U VT / dot VT VT))
      by (rewrite dot_scale_l; unfold Rdiv; ring).
    set (q := dot U VT / dot VT VT); clearbody q; vec_ring.
Qed.

Lemma tool_345_scaled k : k <> 0 -> ~ parallel (Vec 3 0 4) (scale k (Vec 100 0 0)).
Proof. intro K; apply not_parallel_y; unfold scale; cbn; lra. Qed.

Example reversal_has_no_intersection_instance :
  dot (Vec 0 10 0) (n 1 (Vec 3 0 4) (Vec 100 0 0)) = 10 ->
  dot (Vec 0 10 0) (n 1 (Vec 3 0 4) (scale (- (2)) (Vec 100 0 0))) <> 10.
Proof.
  apply reversal_has_no_intersection; auto; [apply tool_345_scaled; lra |]. apply (cosine_back (Vec 3 0 4) (Vec 100 0 0) 2); auto; lra.
Qed.

(** * Acute corners *)

(** fanuc.tool-side.outer-acute: the first vector lies on A's offset line, past the corner by the offset value; the second
    on B's, as far before it. *)
Theorem K_past_the_corner r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  dot (K1 r s VT U1) (n s VT U1) = r /\ dot (K1 r s VT U1) (d VT U1) = r /\
  dot (K2 r s VT U2) (n s VT U2) = r /\ dot (K2 r s VT U2) (d VT U2) = - r.
Proof.
  intros A H1 H2. unfold K1, K2, sub, opp. forms.
  rewrite (dot_comm (d VT U1) (n s VT U1)), (dot_comm (d VT U2) (n s VT U2)), !n_unit, !n_dot_d, !d_unit by auto.
  repeat split; ring.
Qed.

Example K_past_the_corner_instance :
  dot (K1 10 1 (Vec 3 0 4) (Vec 0 100 0)) (n 1 (Vec 3 0 4) (Vec 0 100 0)) = 10 /\
  dot (K1 10 1 (Vec 3 0 4) (Vec 0 100 0)) (d (Vec 3 0 4) (Vec 0 100 0)) = 10 /\
  dot (K2 10 1 (Vec 3 0 4) (Vec 94 (-60) (-8))) (n 1 (Vec 3 0 4) (Vec 94 (-60) (-8))) = 10 /\
  dot (K2 10 1 (Vec 3 0 4) (Vec 94 (-60) (-8))) (d (Vec 3 0 4) (Vec 94 (-60) (-8))) = - 10.
Proof. apply K_past_the_corner; auto. Qed.

Lemma K1_square r s VT U : sided s -> ~ parallel VT U -> dot (K1 r s VT U) (K1 r s VT U) = 2 * r².
Proof.
  intros A H. unfold K1. forms. rewrite (dot_comm (d VT U) (n s VT U)), n_unit, n_dot_d, d_unit by auto.
  unfold Rsqr; ring.
Qed.

Lemma K2_square r s VT U : sided s -> ~ parallel VT U -> dot (K2 r s VT U) (K2 r s VT U) = 2 * r².
Proof.
  intros A H. unfold K2, sub, opp. forms. rewrite (dot_comm (d VT U) (n s VT U)), n_unit, n_dot_d, d_unit by auto.
  unfold Rsqr; ring.
Qed.

Lemma K1_dot_K2 r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  dot (K1 r s VT U1) (K2 r s VT U2) = -2 * r² * dot (n s VT U1) (d VT U2).
Proof.
  intros A H1 H2. unfold K1, K2, sub, opp. forms.
  rewrite (dot_comm (d VT U1) (n s VT U2)), n_dot_n, (n_dot_d_swap s VT U2 U1) by auto. fold (cosine VT U1 U2).
  unfold Rsqr; ring.
Qed.

(** fanuc.tool-side.outer-acute: along the straight move from the first vector to the second the axis of the tool, at any
    height [h], keeps the offset value as distance from the corner. *)
Theorem acute_keeps_distance r s VT U1 U2 t h : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  S s VT U1 U2 <= 0 -> 0 <= t <= 1 ->
  let p := add (add (scale (1 - t) (K1 r s VT U1)) (scale t (K2 r s VT U2))) (scale h VT) in r² <= dot p p.
Proof.
  intros A H1 H2 O B p. pose proof (tool_nonzero VT U1 H1) as T. unfold p.
  assert (Z1 : dot (K1 r s VT U1) VT = 0) by (unfold K1; forms; rewrite n_tool, d_tool by auto; ring).
  assert (Z2 : dot (K2 r s VT U2) VT = 0) by (unfold K2, sub, opp; forms; rewrite n_tool, d_tool by auto; ring).
  forms. rewrite !(dot_comm VT), Z1, Z2, (dot_comm (K2 r s VT U2)), K1_square, K2_square, K1_dot_K2 by auto.
  assert (M : dot (n s VT U1) (d VT U2) <= 0).
  { rewrite n_dot_d_S by auto. pose proof (Rinv_0_lt_compat _ (norm_pos _ H1)).
    pose proof (Rinv_0_lt_compat _ (norm_pos _ (across_nonzero VT U2 H2))).
    assert (0 <= / norm (cross VT U1) * / norm (across VT U2)) by (apply Rmult_le_pos; lra). nra. }
  set (m := dot (n s VT U1) (d VT U2)) in *. pose proof (dot_self_nonneg VT) as Q. pose proof (Rle_0_sqr r) as R2.
  set (q := dot VT VT) in *. set (r2 := r²) in *.
  assert (E1 : 0 <= t * (1 - t) * (r2 * - m)) by (apply Rmult_le_pos; [apply Rmult_le_pos |  apply Rmult_le_pos]; lra).
  assert (E2 : 0 <= h * h * q) by (apply Rmult_le_pos; [apply Rle_0_sqr | auto]).
  assert (E3 : 0 <= (1 - 2 * t)² * r2) by (apply Rmult_le_pos; [apply Rle_0_sqr | auto]).
  match goal with |- _ <= ?e =>
    replace e with (r2 + (1 - 2 * t)² * r2 + 4 * (t * (1 - t) * (r2 * - m)) + h * h * q) by (unfold Rsqr; ring) end.
  lra.
Qed.

Example acute_keeps_distance_instance :
  let p := add (add (scale (1 - 1/2) (K1 10 1 (Vec 3 0 4) (Vec 0 100 0)))
                    (scale (1/2) (K2 10 1 (Vec 3 0 4) (Vec 94 (-60) (-8))))) (scale 7 (Vec 3 0 4)) in 10² <= dot p p.
Proof. apply acute_keeps_distance; auto; values. Qed.

(** fanuc.tool-side.obtuse-or-acute: at exactly 90 degrees both vectors of an acute corner are the intersection, so the
    limit may belong to either side. *)
Theorem K_at_90_degrees r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  S s VT U1 U2 <= 0 -> C VT U1 U2 = 0 -> K1 r s VT U1 = Vi r s VT U1 U2 /\ K2 r s VT U2 = Vi r s VT U1 U2.
Proof.
  intros A H1 H2 O Z. pose proof (tool_nonzero VT U1 H1) as T.
  pose proof (norm_pos _ H1). pose proof (norm_pos _ H2).
  assert (K : cosine VT U1 U2 = 0).
  { rewrite cosine_C in Z by auto. apply Rmult_integral in Z. destruct Z as [Z | Z]; [| auto].
    apply Rmult_integral in Z; lra. }
  (* n1 and d1 are the frame of the plane: d2 = - n1, n2 = d1. *)
  assert (F : forall x, dot x VT = 0 -> x = add (scale (dot x (n s VT U1)) (n s VT U1)) (scale (dot x (d VT U1)) (d VT U1))).
  { intros x X0. pose proof (by_frame (unit VT) (d VT U1) x (unit_unit VT T) (d_unit VT U1 H1) (tool_unit_d VT U1 T)) as F.
    assert (Y0 : dot x (unit VT) = 0) by (unfold unit; rewrite dot_scale_r, X0; ring).
    rewrite Y0, scale_zero_l in F. rewrite F at 1. rewrite n_turned, dot_scale_r, scale_scale by auto.
    replace (s * dot x (cross (unit VT) (d VT U1)) * s) with (s * s * dot x (cross (unit VT) (d VT U1))) by ring.
    rewrite sided_square by auto. rewrite Rmult_1_l.
    set (k := dot x (d VT U1)); set (j := dot x (cross (unit VT) (d VT U1))).
    set (a := cross (unit VT) (d VT U1)); set (b := d VT U1). clearbody a b j k. vec_ring. }
  pose proof (F _ (d_tool VT U2 T)) as D. pose proof (F _ (n_tool s VT U2)) as N.
  rewrite (dot_comm (d VT U2) (d VT U1)) in D. fold (cosine VT U1 U2) in D.
  rewrite (dot_comm (n s VT U2) (n s VT U1)), n_dot_n in N by auto. rewrite K, scale_zero_l in D, N.
  rewrite (dot_comm (d VT U2)) in D. pose proof (n_dot_d_swap s VT U1 U2 H1 H2) as W.
  pose proof (n_dot_d_S s VT U1 U2 H1 H2) as SS.
  set (m := dot (n s VT U1) (d VT U2)) in *.
  assert (Q : m * m = 1).
  { pose proof (d_unit VT U2 H2) as Q. rewrite D in Q. rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r in Q.
    rewrite n_unit in Q by auto. replace (dot zero zero) with 0 in Q by vec_ring.
    replace (dot zero (n s VT U1)) with 0 in Q by vec_ring. replace (dot (n s VT U1) zero) with 0 in Q by vec_ring. lra. }
  assert (M : m = -1).
  { assert (m <= 0).
    { rewrite SS. pose proof (Rinv_0_lt_compat _ (norm_pos _ H1)).
      pose proof (Rinv_0_lt_compat _ (norm_pos _ (across_nonzero VT U2 H2))).
      assert (0 <= / norm (cross VT U1) * / norm (across VT U2)) by (apply Rmult_le_pos; lra). nra. }
    nra. }
  unfold K1, K2, Vi. rewrite K. replace (r / (1 + 0)) with r by field.
  replace (dot (n s VT U2) (d VT U1)) with 1 in N by lra. rewrite M in D.
  rewrite N, D. set (a := n s VT U1); set (b := d VT U1); clearbody a b. split; vec_ring.
Qed.

Example K_at_90_degrees_instance :
  K1 10 1 (Vec 3 0 4) (Vec 0 100 0) = Vi 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0) /\
  K2 10 1 (Vec 3 0 4) (Vec 100 0 0) = Vi 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0).
Proof. apply K_at_90_degrees; auto; values. Qed.

(** * The degenerate plane *)

(** fanuc.tool-side.corner-side: where P, Q, R and the tool lie in one plane [S] is exactly 0: such corners go straight on
    or straight back, and rounding must not choose. *)
Theorem coplanar_has_no_turn s VT P Q R N : N <> zero ->
  dot N VT = 0 -> dot N (sub Q P) = 0 -> dot N (sub R Q) = 0 -> S s VT (sub Q P) (sub R Q) = 0.
Proof.
  intros H A B D. unfold S. set (U1 := sub Q P) in *; set (U2 := sub R Q) in *; clearbody U1 U2.
  pose proof (dot_self_pos N H) as L.
  assert (E : dot N N * dot VT (cross U1 U2) =
    dot N VT * dot N (cross U1 U2) + dot N U1 * dot N (cross U2 VT) + dot N U2 * dot N (cross VT U1)) by vec_ring.
  rewrite A, B, D in E. assert (Z : dot VT (cross U1 U2) = 0).
  { apply (Rmult_eq_reg_l (dot N N)); [rewrite E; ring | lra]. }
  rewrite Z; ring.
Qed.

Example coplanar_has_no_turn_instance :
  S 1 (Vec 3 0 4) (sub (Vec 7 0 1) (Vec 1 0 2)) (sub (Vec 2 0 9) (Vec 7 0 1)) = 0.
Proof. apply (coplanar_has_no_turn 1 (Vec 3 0 4) _ _ _ (Vec 0 1 0)); values. intro E; injection E; intros; lra. Qed.

(** fanuc.tool-side.straight-or-reversal: of the directions without a turn only straight on and straight back exist: the
    cosine is 1 or -1. *)
Theorem no_turn_is_straight_or_back s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  S s VT U1 U2 = 0 -> (cosine VT U1 U2 = 1 /\ 0 < C VT U1 U2) \/ (cosine VT U1 U2 = -1 /\ C VT U1 U2 < 0).
Proof.
  intros A H1 H2 Z. pose proof (tool_nonzero VT U1 H1) as T.
  pose proof (norm_pos _ H1) as P1. pose proof (norm_pos _ H2) as P2. rewrite cosine_C by auto.
  apply turn_of_S in Z; auto.
  assert (W : dot (d VT U2) (n s VT U1) = 0) by (rewrite dot_comm; exact Z).
  pose proof (along_the_line s VT U1 (d VT U2) A H1 (d_tool VT U2 T) W) as F.
  rewrite (dot_comm (d VT U2) (d VT U1)) in F. fold (cosine VT U1 U2) in F.
  pose proof (d_unit VT U2 H2) as D. rewrite F, dot_scale_l, dot_scale_r, d_unit in D by auto.
  set (c := cosine VT U1 U2) in *. clearbody c.
  assert (L : 0 < norm (cross VT U1) * norm (cross VT U2)) by (apply Rmult_lt_0_compat; auto).
  assert (K : c = 1 \/ c = -1) by (destruct (Rle_dec 0 c); [left | right]; nra).
  destruct K as [-> | ->]; [left | right]; split; lra.
Qed.

Example no_turn_is_straight_or_back_instance :
  let b := Vec 0 (-50) 0 in let a := Vec 0 100 0 in
  (cosine (Vec 3 0 4) a b = 1 /\ 0 < C (Vec 3 0 4) a b) \/ (cosine (Vec 3 0 4) a b = -1 /\ C (Vec 3 0 4) a b < 0).
Proof. apply (no_turn_is_straight_or_back 1); auto; values. Qed.

(** fanuc.tool-side.outer-acute: straight back the group has two vectors, and the tool goes round the end at the distance
    of the offset value. *)
Theorem reversal_group r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  S s VT U1 U2 = 0 -> C VT U1 U2 < 0 ->
  group r s VT U1 U2 = [K1 r s VT U1; K2 r s VT U2] /\
  K2 r s VT U2 = scale r (sub (d VT U1) (n s VT U1)).
Proof.
  intros A H1 H2 Z B. split.
  - unfold group. destruct Rlt_dec; [lra |]. destruct Rle_dec; [lra | reflexivity].
  - pose proof (tool_nonzero VT U1 H1) as T.
    destruct (no_turn_is_straight_or_back s VT U1 U2 A H1 H2 Z) as [[_ X] | [K _]]; [lra |].
    assert (D : add (d VT U1) (d VT U2) = zero).
    { apply dot_self_zero. rewrite !dot_add_l, !dot_add_r, !d_unit, (dot_comm (d VT U2)) by auto.
      fold (cosine VT U1 U2). lra. }
    assert (E : d VT U2 = opp (d VT U1)).
    { set (a := d VT U1) in *; set (b := d VT U2) in *; clearbody a b.
      apply vec_eq; [apply (f_equal vx) in D | apply (f_equal vy) in D | apply (f_equal vz) in D];
        unfold opp, add, scale, zero in *; cbn in *; lra. }
    unfold K2. rewrite !n_turned, E by auto. set (e := unit VT); set (a := d VT U1); clearbody e a. vec_ring.
Qed.

Example reversal_group_instance :
  group 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 0 (-50) 0) =
    [K1 10 1 (Vec 3 0 4) (Vec 0 100 0); K2 10 1 (Vec 3 0 4) (Vec 0 (-50) 0)] /\
  K2 10 1 (Vec 3 0 4) (Vec 0 (-50) 0) =
    scale 10 (sub (d (Vec 3 0 4) (Vec 0 100 0)) (n 1 (Vec 3 0 4) (Vec 0 100 0))).
Proof. apply reversal_group; auto; values. Qed.

(** * A planar face *)

(** Both factors in the face: their product is along its normal. *)
Lemma cross_in_face N a b : dot N N = 1 -> dot N a = 0 -> dot N b = 0 -> cross a b = scale (dot N (cross a b)) N.
Proof.
  intros E A B.
  assert (F : scale (dot N N) (cross a b) =
    add (scale (dot N (cross a b)) N) (sub (scale (dot N a) (cross N b)) (scale (dot N b) (cross N a)))).
  { vec_ring. }
  rewrite E, A, B, scale_one in F. rewrite F at 1.
  set (k := dot N (cross a b)); clearbody k; set (u := cross N b); set (v := cross N a); clearbody u v; vec_ring.
Qed.

Lemma normal_of_face s VT U N : sided s -> dot N N = 1 -> dot N VT = 0 -> dot N U = 0 ->
  0 < s * dot N (cross VT U) -> n s VT U = N.
Proof.
  intros A E T H O. unfold n. pose proof (cross_in_face N VT U E T H) as F.
  set (k := dot N (cross VT U)) in *. rewrite F, norm_scale, scale_scale. unfold norm. rewrite E, sqrt_1.
  destruct A; subst s; [rewrite Rabs_right by lra | rewrite Rabs_left by lra];
    (match goal with |- scale ?q N = N => replace q with 1 by (field; lra) end); apply scale_one.
Qed.

(** fanuc.tool-side.plane: a block from P along U in a planar face with the unit normal N, the tool axis in the face at
    both ends, on the side of N: whatever vectors of the offset lines it starts and ends with, all along the block every
    point of the axis of the tool (at the height [h], in any direction VT of the face) has the distance r from the face. *)
Theorem face_keeps_distance r s N P U VT0 VT1 V0 V1 VT t h : sided s -> dot N N = 1 ->
  dot N U = 0 -> dot N VT0 = 0 -> dot N VT1 = 0 -> dot N VT = 0 ->
  0 < s * dot N (cross VT0 U) -> 0 < s * dot N (cross VT1 U) ->
  dot V0 (n s VT0 U) = r -> dot V1 (n s VT1 U) = r ->
  let tip := add (scale (1 - t) (add P V0)) (scale t (add (add P U) V1)) in
  dot N (sub (add tip (scale h VT)) P) = r.
Proof.
  intros A E HU H0 H1 H O0 O1 L0 L1 tip. rewrite (normal_of_face s VT0 U N) in L0 by auto.
  rewrite (normal_of_face s VT1 U N) in L1 by auto. rewrite dot_comm in L0, L1.
  unfold tip, sub, opp. repeat (rewrite ?dot_add_r, ?dot_scale_r). rewrite HU, H, L0, L1. ring.
Qed.

Example face_keeps_distance_instance t h :
  let tip := add (scale (1 - t) (add (Vec 1 2 3) (Vec 7 10 0))) (scale t (add (add (Vec 1 2 3) (Vec 100 0 20)) (Vec 0 10 5))) in
  dot (Vec 0 1 0) (sub (add tip (scale h (Vec 1 0 1))) (Vec 1 2 3)) = 10.
Proof.
  apply (face_keeps_distance 10 1 (Vec 0 1 0) (Vec 1 2 3) (Vec 100 0 20) (Vec 0 0 1) (Vec 3 0 4)); auto; try (values; fail).
  - rewrite (normal_of_face 1 _ _ (Vec 0 1 0)); auto; values.
  - rewrite (normal_of_face 1 _ _ (Vec 0 1 0)); auto; values.
Qed.

(** * Symmetries *)

Lemma across_tool_scaled k VT U : k <> 0 -> across (scale k VT) U = across VT U.
Proof.
  intro K. unfold across.
  assert (E : scale (dot U (scale k VT) / dot (scale k VT) (scale k VT)) (scale k VT) = scale (dot U VT / dot VT VT) VT).
  { rewrite !dot_scale_l, !dot_scale_r, scale_scale. destruct (Req_dec (dot VT VT) 0) as [Z | Z].
    - apply dot_self_zero in Z; subst. rewrite !scale_zero_r; reflexivity.
    - f_equal. field; auto. }
  rewrite E; reflexivity.
Qed.

Lemma n_tool_scaled k s VT U : 0 < k -> n s (scale k VT) U = n s VT U.
Proof.
  intro K. unfold n. rewrite cross_scale_l, norm_scale, Rabs_right, scale_scale by lra.
  destruct (Req_dec (norm (cross VT U)) 0) as [Z | Z].
  - assert (E : cross VT U = zero) by (apply dot_self_zero; rewrite <- norm_sqr, Z; ring).
    rewrite E, !scale_zero_r; reflexivity.
  - f_equal. field; split; lra.
Qed.

Lemma positive_factor k x : 0 < k -> (0 < k * x <-> 0 < x).
Proof. intro K; split; intro H; nra. Qed.
Lemma nonnegative_factor k x : 0 < k -> (0 <= k * x <-> 0 <= x).
Proof. intro K; split; intro H; [apply Rnot_lt_le; intro G | ]; nra. Qed.

(** The same class and the same vectors make the same group. *)
Lemma same_group r s VT U1 U2 s' VT' U1' U2' :
  (0 < S s VT U1 U2 <-> 0 < S s' VT' U1' U2') -> (0 <= C VT U1 U2 <-> 0 <= C VT' U1' U2') ->
  Vi r s VT U1 U2 = Vi r s' VT' U1' U2' -> K1 r s VT U1 = K1 r s' VT' U1' -> K2 r s VT U2 = K2 r s' VT' U2' ->
  group r s VT U1 U2 = group r s' VT' U1' U2'.
Proof.
  intros A B E1 E2 E3. unfold group. rewrite E1, E2, E3.
  destruct (Rlt_dec 0 (S s VT U1 U2)), (Rlt_dec 0 (S s' VT' U1' U2')); try tauto;
    destruct (Rle_dec 0 (C VT U1 U2)), (Rle_dec 0 (C VT' U1' U2')); tauto || reflexivity.
Qed.

(** fanuc.tool-direction.given-directly: the length of the tool direction does not matter, neither to the class nor to the
    vectors. *)
Theorem tool_scaled r s k VT U1 U2 : 0 < k -> group r s (scale k VT) U1 U2 = group r s VT U1 U2.
Proof.
  intro K. apply same_group.
  - unfold S. rewrite dot_scale_l. replace (s * (k * dot VT (cross U1 U2))) with (k * (s * dot VT (cross U1 U2))) by ring.
    apply positive_factor; auto.
  - unfold C. rewrite !cross_scale_l, dot_scale_l, dot_scale_r, <- Rmult_assoc. apply nonnegative_factor.
    apply Rmult_lt_0_compat; auto.
  - unfold Vi, cosine, d. rewrite !n_tool_scaled, !across_tool_scaled by lra. reflexivity.
  - unfold K1, d. rewrite n_tool_scaled, across_tool_scaled by lra. reflexivity.
  - unfold K2, d. rewrite n_tool_scaled, across_tool_scaled by lra. reflexivity.
Qed.

Example tool_scaled_instance :
  group 10 1 (scale 5 (Vec (3/5) 0 (4/5))) (Vec 0 100 0) (Vec 100 0 0) =
  group 10 1 (Vec (3/5) 0 (4/5)) (Vec 0 100 0) (Vec 100 0 0).
Proof. apply tool_scaled; lra. Qed.

Lemma across_scaled k VT U : across VT (scale k U) = scale k (across VT U).
Proof.
  unfold across. rewrite dot_scale_l. unfold Rdiv. rewrite Rmult_assoc.
  set (q := dot U VT * / dot VT VT); clearbody q; vec_ring.
Qed.

Lemma d_scaled k VT U : 0 < k -> d VT (scale k U) = d VT U.
Proof. intro K; unfold d; rewrite across_scaled; apply unit_scale, K. Qed.

Lemma n_scaled k s VT U : 0 < k -> n s VT (scale k U) = n s VT U.
Proof.
  intro K. unfold n. rewrite cross_scale_r, norm_scale, Rabs_right, scale_scale by lra.
  destruct (Req_dec (norm (cross VT U)) 0) as [Z | Z].
  - assert (E : cross VT U = zero) by (apply dot_self_zero; rewrite <- norm_sqr, Z; ring).
    rewrite E, !scale_zero_r; reflexivity.
  - f_equal. field; split; lra.
Qed.

(** fanuc.tool-side.without-basis: nor do the lengths of the displacements. *)
Theorem displacements_scaled r s j k VT U1 U2 : 0 < j -> 0 < k ->
  group r s VT (scale j U1) (scale k U2) = group r s VT U1 U2.
Proof.
  intros J K. apply same_group.
  - unfold S. rewrite cross_scale_l, cross_scale_r, scale_scale, dot_scale_r.
    replace (s * (j * k * dot VT (cross U1 U2))) with (j * k * (s * dot VT (cross U1 U2))) by ring.
    apply positive_factor, Rmult_lt_0_compat; auto.
  - unfold C. rewrite !cross_scale_r, dot_scale_l, dot_scale_r, <- Rmult_assoc. apply nonnegative_factor.
    apply Rmult_lt_0_compat; auto.
  - unfold Vi, cosine. rewrite !n_scaled, !d_scaled by auto. reflexivity.
  - unfold K1. rewrite n_scaled, d_scaled by auto. reflexivity.
  - unfold K2. rewrite n_scaled, d_scaled by auto. reflexivity.
Qed.

Example displacements_scaled_instance :
  group 10 1 (Vec 3 0 4) (scale 100 (Vec 0 1 0)) (scale 2 (Vec 47 (-30) (-4))) =
  group 10 1 (Vec 3 0 4) (Vec 0 1 0) (Vec 47 (-30) (-4)).
Proof. apply displacements_scaled; lra. Qed.

(** fanuc.tool-side.left: seen from the other end of the tool left and right are exchanged. *)
Theorem tool_reversed r s VT U1 U2 : group r s (opp VT) U1 U2 = group r (- s) VT U1 U2.
Proof.
  assert (N : forall U, n s (opp VT) U = n (- s) VT U).
  { intro U. unfold n, opp. rewrite cross_scale_l, norm_scale, (Rabs_left (-1)), scale_scale by lra.
    replace (- (-1) * norm (cross VT U)) with (norm (cross VT U)) by ring. f_equal. unfold Rdiv; ring. }
  assert (D : forall U, d (opp VT) U = d VT U) by (intro U; unfold d, opp; rewrite across_tool_scaled by lra; reflexivity).
  apply same_group.
  - unfold S, opp. rewrite dot_scale_l. replace (s * (-1 * dot VT (cross U1 U2))) with (- s * dot VT (cross U1 U2)) by ring.
    reflexivity.
  - unfold C, opp. rewrite !cross_scale_l, dot_scale_l, dot_scale_r.
    replace (-1 * (-1 * dot (cross VT U1) (cross VT U2))) with (dot (cross VT U1) (cross VT U2)) by ring. tauto.
  - unfold Vi, cosine. rewrite !N, !D. reflexivity.
  - unfold K1. rewrite N, D. reflexivity.
  - unfold K2. rewrite N, D. reflexivity.
Qed.

Example tool_reversed_instance :
  group 10 1 (opp (Vec 3 0 4)) (Vec 0 100 0) (Vec 100 0 0) = group 10 (- (1)) (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0).
Proof. apply tool_reversed. Qed.

Lemma n_other_side s VT U : n (- s) VT U = opp (n s VT U).
Proof. unfold n, opp. rewrite scale_scale. f_equal. unfold Rdiv; ring. Qed.

(** fanuc.tool-side.left: up to 90 degrees of turn the vector of the other side is the opposite one. (Beyond, one side is
    acute and the other inner.) *)
Theorem other_side_is_opposite r s VT U1 U2 : 0 <= C VT U1 U2 ->
  group r (- s) VT U1 U2 = map opp (group r s VT U1 U2).
Proof.
  intro H. assert (E : Vi r (- s) VT U1 U2 = opp (Vi r s VT U1 U2)).
  { unfold Vi. rewrite !n_other_side. unfold opp. rewrite <- scale_add, !scale_scale. f_equal. ring. }
  unfold group. destruct (Rlt_dec 0 (S (- s) VT U1 U2)), (Rlt_dec 0 (S s VT U1 U2)), (Rle_dec 0 (C VT U1 U2));
    try lra; cbn [map]; rewrite E; reflexivity.
Qed.

Example other_side_is_opposite_instance :
  group 10 (- (1)) (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0) = map opp (group 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0)).
Proof. apply other_side_is_opposite; values. Qed.

(** A rotation keeps cross products; a mirror turns them round. *)
Definition rotation m := rigid m /\ e3 m = cross (e1 m) (e2 m).

Lemma move_cross m u v : rotation m -> cross (move m u) (move m v) = move m (cross u v).
Proof.
  intros [(A & B & D & E & F & G) H].
  assert (X : cross (e2 m) (e3 m) = e1 m).
  { rewrite H. transitivity (sub (scale (dot (e2 m) (e2 m)) (e1 m)) (scale (dot (e1 m) (e2 m)) (e2 m))).
    - set (a := e1 m); set (b := e2 m); clearbody a b; vec_ring.
    - rewrite B, E. set (a := e1 m); set (b := e2 m); clearbody a b; vec_ring. }
  assert (Y : cross (e3 m) (e1 m) = e2 m).
  { rewrite H. transitivity (sub (scale (dot (e1 m) (e1 m)) (e2 m)) (scale (dot (e1 m) (e2 m)) (e1 m))).
    - set (a := e1 m); set (b := e2 m); clearbody a b; vec_ring.
    - rewrite A, E. set (a := e1 m); set (b := e2 m); clearbody a b; vec_ring. }
  transitivity (add (scale (vx (cross u v)) (cross (e2 m) (e3 m)))
    (add (scale (vy (cross u v)) (cross (e3 m) (e1 m))) (scale (vz (cross u v)) (cross (e1 m) (e2 m))))).
  - unfold move. set (a := e1 m); set (b := e2 m); set (c := e3 m); clearbody a b c; vec_ring.
  - rewrite X, Y, <- H. reflexivity.
Qed.

(** fanuc.tool-side.without-basis: turning tool and path turns the vectors. *)
Theorem rotated r s m VT U1 U2 : rotation m ->
  group r s (move m VT) (move m U1) (move m U2) = map (move m) (group r s VT U1 U2).
Proof.
  intro H. pose proof H as [R _].
  assert (A : forall U, across (move m VT) (move m U) = move m (across VT U)).
  { intro U. unfold across. rewrite !move_dot, move_sub, move_scale by auto. reflexivity. }
  assert (D : forall U, d (move m VT) (move m U) = move m (d VT U)).
  { intro U. unfold d, unit. rewrite A, move_norm, move_scale by auto. reflexivity. }
  assert (N : forall U, n s (move m VT) (move m U) = move m (n s VT U)).
  { intro U. unfold n. rewrite move_cross, move_norm, move_scale by auto. reflexivity. }
  assert (SS : S s (move m VT) (move m U1) (move m U2) = S s VT U1 U2).
  { unfold S. rewrite move_cross, move_dot by auto. reflexivity. }
  assert (CC : C (move m VT) (move m U1) (move m U2) = C VT U1 U2).
  { unfold C. rewrite !move_cross, move_dot by auto. reflexivity. }
  assert (I : Vi r s (move m VT) (move m U1) (move m U2) = move m (Vi r s VT U1 U2)).
  { unfold Vi, cosine. rewrite !N, !D, move_dot, move_scale, move_add by auto. reflexivity. }
  unfold group. rewrite SS, CC, I.
  destruct Rlt_dec; [| destruct Rle_dec]; cbn [map]; auto.
  unfold K1, K2. rewrite !N, !D, !move_scale, move_add, move_sub. reflexivity.
Qed.

Example rotated_instance :
  let m := Motion (Vec (3/5) (4/5) 0) (Vec (-4/5) (3/5) 0) (Vec 0 0 1) in
  group 10 1 (move m (Vec 3 0 4)) (move m (Vec 0 100 0)) (move m (Vec 94 (-60) (-8))) =
  map (move m) (group 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 94 (-60) (-8))).
Proof.
  intro m; apply rotated; unfold m, rotation, rigid, dot, cross; cbn; split; [repeat split; lra | f_equal; lra].
Qed.

(** * The manual's way through C2 *)

Lemma unit_nonzero_factor v : v <> zero -> 0 < / norm v.
Proof. intro H; apply Rinv_0_lt_compat, norm_pos, H. Qed.

(** What Gram and Schmidt take away. *)
Definition rest2 VT a2 := sub a2 (scale (dot a2 (axis1 VT)) (axis1 VT)).
Definition rest3 VT a2 a3 := sub (sub a3 (scale (dot a3 (axis1 VT)) (axis1 VT)))
  (scale (dot a3 (axis2 VT a2)) (axis2 VT a2)).

Lemma handed_nonzero VT a2 a3 : handed VT a2 a3 <> 0 -> VT <> zero /\ rest2 VT a2 <> zero.
Proof.
  intro H. assert (T : VT <> zero) by (intro E; apply H; subst; unfold handed; vec_ring).
  split; auto. intro E. apply H. unfold rest2, axis1, unit in E. rewrite dot_scale_r, scale_scale in E.
  assert (F : a2 = scale (/ norm VT * dot a2 VT * / norm VT) VT) by (symmetry; apply sub_zero; exact E).
  unfold handed. rewrite F. set (k := _ * _). clearbody k. vec_ring.
Qed.

Lemma axis1_unit VT : VT <> zero -> dot (axis1 VT) (axis1 VT) = 1.
Proof. apply unit_unit. Qed.

Lemma axis2_facts VT a2 : VT <> zero -> rest2 VT a2 <> zero ->
  dot (axis2 VT a2) (axis2 VT a2) = 1 /\ dot (axis1 VT) (axis2 VT a2) = 0.
Proof.
  intros T R. split; [apply unit_unit, R |].
  unfold axis2. fold (rest2 VT a2). unfold unit at 1. rewrite dot_scale_r.
  assert (Z : dot (axis1 VT) (rest2 VT a2) = 0).
  { unfold rest2, sub, opp. rewrite dot_add_r, !dot_scale_r, axis1_unit, (dot_comm (axis1 VT)) by auto. ring. }
  rewrite Z; ring.
Qed.

(** The parallelepiped of the auxiliary vectors, in the frame. *)
Lemma handed_in_frame VT a2 a3 : handed VT a2 a3 <> 0 ->
  handed VT a2 a3 = norm VT * norm (rest2 VT a2) * dot (cross (axis1 VT) (axis2 VT a2)) a3.
Proof.
  intro H. destruct (handed_nonzero VT a2 a3 H) as [T R]. pose proof (norm_pos _ T). pose proof (norm_pos _ R).
  unfold axis2. fold (rest2 VT a2). unfold unit. rewrite cross_scale_r, dot_scale_l.
  assert (E : cross (axis1 VT) (rest2 VT a2) = cross (axis1 VT) a2).
  { unfold rest2. set (k := dot a2 (axis1 VT)); set (e := axis1 VT); clearbody k e; vec_ring. }
  rewrite E. unfold axis1, unit. rewrite cross_scale_l, dot_scale_l. unfold handed.
  replace (dot (cross VT a2) a3) with (dot VT (cross a2 a3)) by vec_ring. field; lra.
Qed.

Lemma rest3_by_cross VT a2 a3 : handed VT a2 a3 <> 0 ->
  rest3 VT a2 a3 = scale (dot (cross (axis1 VT) (axis2 VT a2)) a3) (cross (axis1 VT) (axis2 VT a2)).
Proof.
  intro H. destruct (handed_nonzero VT a2 a3 H) as [T R]. destruct (axis2_facts VT a2 T R) as [B D].
  pose proof (by_frame (axis1 VT) (axis2 VT a2) a3 (axis1_unit VT T) B D) as F.
  unfold rest3. rewrite (dot_comm (cross _ _) a3). rewrite F at 1.
  set (i := dot a3 (axis1 VT)); set (j := dot a3 (axis2 VT a2)); set (k := dot a3 (cross (axis1 VT) (axis2 VT a2))).
  set (e := axis1 VT); set (f := axis2 VT a2); set (g := cross e f). clearbody i j k g e f. vec_ring.
Qed.

(** The third axis is the cross product of the first two, or its opposite, by the handedness. *)
Lemma axis3_is VT a2 a3 g : sided g -> 0 < g * handed VT a2 a3 ->
  axis3 VT a2 a3 = scale g (cross (axis1 VT) (axis2 VT a2)).
Proof.
  intros A P. assert (H : handed VT a2 a3 <> 0) by (intro E; rewrite E in P; lra).
  destruct (handed_nonzero VT a2 a3 H) as [T R]. destruct (axis2_facts VT a2 T R) as [B D].
  pose proof (norm_pos _ T). pose proof (norm_pos _ R).
  unfold axis3. fold (rest3 VT a2 a3). rewrite rest3_by_cross by auto.
  pose proof (handed_in_frame VT a2 a3 H) as E. rewrite E in P.
  set (k := dot (cross (axis1 VT) (axis2 VT a2)) a3) in *.
  assert (L : 0 < norm VT * norm (rest2 VT a2)) by (apply Rmult_lt_0_compat; auto).
  assert (K : 0 < g * k) by nra.
  assert (Q : dot (cross (axis1 VT) (axis2 VT a2)) (cross (axis1 VT) (axis2 VT a2)) = 1).
  { rewrite cross_dot_cross, axis1_unit, B, (dot_comm (axis2 VT a2)), D by auto. ring. }
  set (w := cross (axis1 VT) (axis2 VT a2)) in *. clearbody k w. clear E.
  assert (N : norm w = 1) by (unfold norm; rewrite Q; apply sqrt_1).
  unfold unit. rewrite norm_scale, N, scale_scale. f_equal.
  destruct A; subst g; [rewrite Rabs_right by lra | rewrite Rabs_left by lra]; field; lra.
Qed.

(** A frame of the plane: [e] the tool, [f] and [g (e x f)] the axes. *)
Definition flat f k u := Vec (dot f u) (dot k u) 0.
Definition lift f k v := add (scale (vx v) f) (scale (vy v) k).

Lemma lift_scale f k j v : lift f k (scale j v) = scale j (lift f k v).
Proof. unfold lift; vec_ring. Qed.
Lemma lift_add f k u v : lift f k (add u v) = add (lift f k u) (lift f k v).
Proof. unfold lift; vec_ring. Qed.
Lemma lift_sub f k u v : lift f k (sub u v) = sub (lift f k u) (lift f k v).
Proof. unfold lift; vec_ring. Qed.
Lemma flat_sub f k u v : flat f k (sub u v) = sub (flat f k u) (flat f k v).
Proof. unfold flat; vec_ring. Qed.

Lemma across_unit VT U : VT <> zero -> across VT U = sub U (scale (dot U (unit VT)) (unit VT)).
Proof.
  intro T. unfold across, unit. rewrite dot_scale_r, scale_scale, <- norm_sqr. f_equal. f_equal.
  pose proof (norm_pos VT T). field; lra.
Qed.

Lemma lift_flat VT f g U : sided g -> VT <> zero -> dot f f = 1 -> dot (unit VT) f = 0 ->
  lift f (scale g (cross (unit VT) f)) (flat f (scale g (cross (unit VT) f)) U) = across VT U.
Proof.
  intros A T B D. rewrite across_unit by auto.
  pose proof (by_frame (unit VT) f U (unit_unit VT T) B D) as F.
  unfold lift, flat; cbn [vx vy]. rewrite dot_scale_l, scale_scale, (dot_comm f U), (dot_comm (cross (unit VT) f) U).
  replace (g * dot U (cross (unit VT) f) * g) with (g * g * dot U (cross (unit VT) f)) by ring.
  rewrite sided_square, Rmult_1_l by auto.
  set (e := unit VT) in *. rewrite F at 3.
  set (i := dot U e); set (j := dot U f); set (k := dot U (cross e f)); set (w := cross e f). clearbody i j k w e.
  vec_ring.
Qed.

(** Left in the coordinates of C2 is left about the tool, in a right-handed C2. *)
Lemma lift_left e f g v : sided g -> dot e e = 1 -> dot f f = 1 -> dot e f = 0 ->
  lift f (scale g (cross e f)) (CutterCompensationC.left v) = scale g (cross e (lift f (scale g (cross e f)) v)).
Proof.
  intros A E B D. unfold lift, CutterCompensationC.left; cbn [vx vy].
  assert (X : cross e (cross e f) = opp f).
  { transitivity (sub (scale (dot e f) e) (scale (dot e e) f)); [vec_ring |]. rewrite E, D. vec_ring. }
  rewrite cross_add_r, !cross_scale_r, X, scale_add, !scale_scale. unfold opp. rewrite scale_scale.
  set (w := cross e f); clearbody w. destruct A; subst g; vec_ring.
Qed.

Lemma flat_dot VT f g U W : sided g -> VT <> zero -> dot f f = 1 -> dot (unit VT) f = 0 ->
  let k := scale g (cross (unit VT) f) in dot (flat f k U) (flat f k W) = dot (across VT U) (across VT W).
Proof.
  intros A T B D k. unfold k. rewrite <- (lift_flat VT f g U), <- (lift_flat VT f g W) by auto. fold k.
  assert (K1 : dot k k = 1).
  { unfold k. rewrite dot_scale_l, dot_scale_r, cross_dot_cross, unit_unit, B, (dot_comm f), D by auto.
    pose proof (sided_square g A). lra. }
  assert (K2 : dot f k = 0) by (unfold k; rewrite dot_scale_r, dot_comm, dot_cross_r; ring).
  unfold lift. forms. rewrite (dot_comm k f), K1, K2, B. unfold flat, dot at 1; cbn [vx vy vz]. ring.
Qed.

Lemma flat_norm VT f g U : sided g -> VT <> zero -> dot f f = 1 -> dot (unit VT) f = 0 ->
  norm (flat f (scale g (cross (unit VT) f)) U) = norm (across VT U).
Proof. intros A T B D. unfold norm. rewrite (flat_dot VT f g U U) by auto. reflexivity. Qed.

Lemma lift_unit_flat VT f g U : sided g -> VT <> zero -> dot f f = 1 -> dot (unit VT) f = 0 ->
  let k := scale g (cross (unit VT) f) in lift f k (unit (flat f k U)) = d VT U.
Proof.
  intros A T B D k. unfold unit at 1. rewrite lift_scale. unfold k. rewrite lift_flat, flat_norm by auto. reflexivity.
Qed.

Lemma flat_turn VT f g U W : sided g -> VT <> zero -> dot f f = 1 -> dot (unit VT) f = 0 ->
  let k := scale g (cross (unit VT) f) in
  CutterCompensationC.turn (flat f k U) (flat f k W) = g * dot (unit VT) (cross U W).
Proof.
  intros A T B D k. unfold CutterCompensationC.turn, flat; cbn [vx vy].
  transitivity (dot (cross f k) (cross U W)); [rewrite cross_dot_cross; ring |].
  assert (X : cross f k = scale g (unit VT)).
  { unfold k. rewrite cross_scale_r. f_equal.
    transitivity (sub (scale (dot f f) (unit VT)) (scale (dot (unit VT) f) f)).
    - set (e := unit VT); clearbody e; vec_ring.
    - rewrite B, D. set (e := unit VT); clearbody e; vec_ring. }
  rewrite X, dot_scale_l. reflexivity.
Qed.

(** One frame, either handedness: the corner in its coordinates, lifted, is the corner without a basis. *)
Lemma frame_group r s VT f g U1 U2 : 0 < r -> sided s -> sided g -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  dot f f = 1 -> dot (unit VT) f = 0 ->
  let k := scale g (cross (unit VT) f) in
  map (lift f k) (CutterCompensationC.group (s * r) (unit (flat f k U1)) (unit (flat f k U2))) =
  group r (s * g) VT U1 U2.
Proof.
  intros R A G H1 H2 B D k. pose proof (tool_nonzero VT U1 H1) as T.
  assert (GG : g * g = 1) by (apply sided_square; auto).
  assert (E : forall U, ~ parallel VT U -> lift f k (unit (flat f k U)) = d VT U)
    by (intros U HU; apply lift_unit_flat; auto).
  assert (L : forall U, ~ parallel VT U ->
              scale (s * r) (lift f k (CutterCompensationC.left (unit (flat f k U)))) = scale r (n (s * g) VT U)).
  { intros U HU. unfold k at 1 2. rewrite (lift_left (unit VT) f g), n_turned by (auto; apply unit_unit, T).
    fold k. rewrite E by auto. rewrite !scale_scale. f_equal; ring. }
  assert (Abs : Rabs (s * r) = r) by (destruct A; subst s; [rewrite Rabs_right | rewrite Rabs_left]; lra).
  assert (F : forall U, ~ parallel VT U -> 0 < / norm (flat f k U)).
  { intros U HU. apply Rinv_0_lt_compat. unfold k. rewrite flat_norm by auto. apply norm_pos, across_nonzero, HU. }
  assert (Cos : dot (unit (flat f k U1)) (unit (flat f k U2)) = cosine VT U1 U2).
  { unfold cosine, d, unit. rewrite !dot_scale_l, !dot_scale_r. unfold k.
    rewrite !flat_norm, (flat_dot VT f g U1 U2) by auto. reflexivity. }
  assert (Sgn : 0 < s * r * CutterCompensationC.turn (unit (flat f k U1)) (unit (flat f k U2)) <->
                0 < S (s * g) VT U1 U2).
  { replace (s * r * CutterCompensationC.turn (unit (flat f k U1)) (unit (flat f k U2)))
      with (r * (/ norm (flat f k U1) * / norm (flat f k U2) * / norm VT) * S (s * g) VT U1 U2).
    - apply positive_factor. pose proof (F U1 H1). pose proof (F U2 H2). pose proof (unit_nonzero_factor VT T).
      repeat apply Rmult_lt_0_compat; auto.
    - transitivity (s * r * (/ norm (flat f k U1) * / norm (flat f k U2)) *
                    CutterCompensationC.turn (flat f k U1) (flat f k U2)).
      + pose proof (flat_turn VT f g U1 U2 G T B D) as W. cbv zeta in W. fold k in W. rewrite W. unfold S, unit. rewrite dot_scale_l. ring.
      + unfold CutterCompensationC.turn, unit, scale; cbn [vx vy]. ring. }
  assert (Sgn2 : 0 <= dot (unit (flat f k U1)) (unit (flat f k U2)) <-> 0 <= C VT U1 U2).
  { rewrite Cos, cosine_C by auto. symmetry. apply nonnegative_factor. apply Rmult_lt_0_compat; apply norm_pos; auto. }
  assert (EM : lift f k (CutterCompensationC.M (s * r) (unit (flat f k U1)) (unit (flat f k U2))) =
               Vi r (s * g) VT U1 U2).
  { pose proof (L U1 H1) as L1. pose proof (L U2 H2) as L2.
    unfold CutterCompensationC.M, Vi. rewrite Cos, lift_scale, lift_add. unfold Rdiv.
    set (q := / (1 + cosine VT U1 U2)). clearbody q.
    transitivity (scale q (add (scale r (n (s * g) VT U1)) (scale r (n (s * g) VT U2))));
      [rewrite <- L1, <- L2 |]; rewrite !scale_add, !scale_scale; f_equal; f_equal; ring. }
  assert (E1 : lift f k (CutterCompensationC.Q1 (s * r) (unit (flat f k U1))) = K1 r (s * g) VT U1).
  { unfold CutterCompensationC.Q1, CutterCompensationC.perpendicular, K1.
    rewrite Abs, lift_add, !lift_scale, L, E, scale_add by auto. reflexivity. }
  assert (E2 : lift f k (CutterCompensationC.Q2 (s * r) (unit (flat f k U2))) = K2 r (s * g) VT U2).
  { unfold CutterCompensationC.Q2, CutterCompensationC.perpendicular, K2.
    rewrite Abs, lift_sub, !lift_scale, L, E by auto. unfold sub, opp. rewrite scale_add, !scale_scale.
    f_equal. f_equal. ring. }
  unfold CutterCompensationC.group, group.
  destruct (Rlt_dec 0 (s * r * CutterCompensationC.turn (unit (flat f k U1)) (unit (flat f k U2))));
    destruct (Rlt_dec 0 (S (s * g) VT U1 U2)); try tauto; cbn [map]; rewrite ?EM; auto.
  destruct (Rle_dec 0 (dot (unit (flat f k U1)) (unit (flat f k U2)))), (Rle_dec 0 (C VT U1 U2)); try tauto;
    cbn [map]; rewrite ?EM, ?E1, ?E2; reflexivity.
Qed.

Lemma manual_group_by_frame r s VT a2 a3 P Q R g : 0 < r -> sided s -> sided g -> 0 < g * handed VT a2 a3 ->
  ~ parallel VT (sub Q P) -> ~ parallel VT (sub R Q) ->
  manual_group r s VT a2 a3 P Q R = group r (s * g) VT (sub Q P) (sub R Q).
Proof.
  intros A B G H H1 H2. assert (N : handed VT a2 a3 <> 0) by (intro E; rewrite E in H; lra).
  destruct (handed_nonzero VT a2 a3 N) as [T X]. destruct (axis2_facts VT a2 T X) as [U V].
  rewrite <- (frame_group r s VT (axis2 VT a2) g) by auto.
  unfold manual_group, dropped, back. rewrite (axis3_is VT a2 a3 g) by auto.
  fold (axis1 VT). fold (flat (axis2 VT a2) (scale g (cross (axis1 VT) (axis2 VT a2))) P).
  fold (flat (axis2 VT a2) (scale g (cross (axis1 VT) (axis2 VT a2))) Q).
  fold (flat (axis2 VT a2) (scale g (cross (axis1 VT) (axis2 VT a2))) R).
  rewrite <- !flat_sub. reflexivity.
Qed.

(** fanuc.tool-side.projection: the manual's way through C2, with any right-handed auxiliary vectors, gives the same
    vectors as the form without a basis. *)
Theorem manual_way r s VT a2 a3 P Q R : 0 < r -> sided s -> 0 < handed VT a2 a3 ->
  ~ parallel VT (sub Q P) -> ~ parallel VT (sub R Q) ->
  manual_group r s VT a2 a3 P Q R = group r s VT (sub Q P) (sub R Q).
Proof.
  intros. rewrite (manual_group_by_frame r s VT a2 a3 P Q R 1); auto; [f_equal; ring |]. lra.
Qed.

Example manual_way_instance :
  manual_group 10 1 (Vec 3 0 4) (Vec 1 2 0) (Vec 0 1 5) (Vec 0 0 0) (Vec 0 100 0) (Vec 94 40 (-8)) =
  group 10 1 (Vec 3 0 4) (sub (Vec 0 100 0) (Vec 0 0 0)) (sub (Vec 94 40 (-8)) (Vec 0 100 0)).
Proof.
  apply manual_way; auto; try (values; fail); [apply not_parallel_x | apply not_parallel_y];
    unfold sub, opp, add, scale; cbn; lra.
Qed.

(** fanuc.tool-side.without-basis: no choice of the auxiliary vectors of a right-handed C2 changes a vector. *)
Theorem auxiliary_vectors_do_not_matter r s VT a2 a3 b2 b3 P Q R : 0 < r -> sided s ->
  0 < handed VT a2 a3 -> 0 < handed VT b2 b3 -> ~ parallel VT (sub Q P) -> ~ parallel VT (sub R Q) ->
  manual_group r s VT a2 a3 P Q R = manual_group r s VT b2 b3 P Q R.
Proof. intros. rewrite !manual_way by auto. reflexivity. Qed.

Example auxiliary_vectors_do_not_matter_instance :
  manual_group 10 1 (Vec 3 0 4) (Vec 1 2 0) (Vec 0 1 5) (Vec 0 0 0) (Vec 0 100 0) (Vec 94 40 (-8)) =
  manual_group 10 1 (Vec 3 0 4) (Vec 0 1 0) (Vec (-1) 0 0) (Vec 0 0 0) (Vec 0 100 0) (Vec 94 40 (-8)).
Proof.
  apply auxiliary_vectors_do_not_matter; auto; try (values; fail); [apply not_parallel_x | apply not_parallel_y];
    unfold sub, opp, add, scale; cbn; lra.
Qed.

(** fanuc.tool-side.left: a left-handed C2 exchanges G41.2 and G42.2, so the handedness has to be fixed. *)
Theorem left_handed_exchanges_sides r s VT a2 a3 P Q R : 0 < r -> sided s -> handed VT a2 a3 < 0 ->
  ~ parallel VT (sub Q P) -> ~ parallel VT (sub R Q) ->
  manual_group r s VT a2 a3 P Q R = group r (- s) VT (sub Q P) (sub R Q).
Proof.
  intros. rewrite (manual_group_by_frame r s VT a2 a3 P Q R (-1)); auto; [f_equal; ring |]. lra.
Qed.

Example left_handed_exchanges_sides_instance :
  manual_group 10 1 (Vec 3 0 4) (Vec 0 1 5) (Vec 1 2 0) (Vec 0 0 0) (Vec 0 100 0) (Vec 94 40 (-8)) =
  group 10 (- (1)) (Vec 3 0 4) (sub (Vec 0 100 0) (Vec 0 0 0)) (sub (Vec 94 40 (-8)) (Vec 0 100 0)).
Proof.
  apply left_handed_exchanges_sides; auto; try (values; fail); [apply not_parallel_x | apply not_parallel_y];
    unfold sub, opp, add, scale; cbn; lra.
Qed.

(** fanuc.tool-side.no-movement-limit: the length of a projection is that of its coordinates in every C2, so a limit read
    as a length does not depend on the auxiliary vectors; its square is |VT x U|² / |VT|². *)
Theorem length_in_C2 VT a2 a3 U : handed VT a2 a3 <> 0 ->
  norm (dropped VT a2 a3 U) = norm (across VT U) /\
  dot (across VT U) (across VT U) = dot (cross VT U) (cross VT U) / dot VT VT.
Proof.
  intro H. destruct (handed_nonzero VT a2 a3 H) as [T X]. destruct (axis2_facts VT a2 T X) as [B D].
  pose proof (dot_self_pos VT T). split.
  - assert (G : exists g, sided g /\ 0 < g * handed VT a2 a3).
    { destruct (Rlt_dec 0 (handed VT a2 a3)); [exists 1 | exists (-1)]; split; auto; lra. }
    destruct G as [g [A P]]. unfold dropped. rewrite (axis3_is VT a2 a3 g) by auto.
    apply (flat_norm VT (axis2 VT a2) g); auto.
  - rewrite across_products by auto. field; lra.
Qed.

Example length_in_C2_instance :
  norm (dropped (Vec 3 0 4) (Vec 1 2 0) (Vec 0 1 5) (Vec 100 0 0)) = norm (across (Vec 3 0 4) (Vec 100 0 0)) /\
  dot (across (Vec 3 0 4) (Vec 100 0 0)) (across (Vec 3 0 4) (Vec 100 0 0)) =
    dot (cross (Vec 3 0 4) (Vec 100 0 0)) (cross (Vec 3 0 4) (Vec 100 0 0)) / dot (Vec 3 0 4) (Vec 3 0 4).
Proof. apply length_in_C2. unfold handed, dot, cross; cbn; lra. Qed.

(** fanuc.tool-side.arc-corners: with the tool along Z the corner is that of cutter compensation C in the plane of X and Y,
    whatever moves along Z. *)
Theorem upright_tool r s U1 U2 : 0 < r -> sided s -> ~ parallel (Vec 0 0 1) U1 -> ~ parallel (Vec 0 0 1) U2 ->
  group r s (Vec 0 0 1) U1 U2 =
  CutterCompensationC.group (s * r) (unit (Vec (vx U1) (vy U1) 0)) (unit (Vec (vx U2) (vy U2) 0)).
Proof.
  intros R A H1 H2.
  assert (N : unit (Vec 0 0 1) = Vec 0 0 1) by (unfold unit; rewrite (norm_is _ 1) by values; rewrite Rinv_1; apply scale_one).
  pose proof (frame_group r s (Vec 0 0 1) (Vec 1 0 0) 1 U1 U2 R A left_sided H1 H2) as F. rewrite N in F.
  specialize (F ltac:(values) ltac:(values)). cbv zeta in F. rewrite Rmult_1_r in F. rewrite <- F.
  assert (K : scale 1 (cross (Vec 0 0 1) (Vec 1 0 0)) = Vec 0 1 0) by (unfold scale, cross; cbn; f_equal; ring).
  rewrite K.
  assert (E : forall U, flat (Vec 1 0 0) (Vec 0 1 0) U = Vec (vx U) (vy U) 0).
  { intro U. unfold flat, dot; cbn; f_equal; ring. }
  rewrite !E.
  assert (L : forall v, vz v = 0 -> lift (Vec 1 0 0) (Vec 0 1 0) v = v).
  { intros v Z. destruct v as [x y z]; cbn in Z; subst. unfold lift, add, scale; cbn; f_equal; ring. }
  unfold CutterCompensationC.group.
  destruct Rlt_dec; [| destruct Rle_dec]; cbn [map]; rewrite !L; auto;
    unfold CutterCompensationC.M, CutterCompensationC.Q1, CutterCompensationC.Q2, CutterCompensationC.perpendicular,
      CutterCompensationC.left, unit, sub, opp, add, scale; cbn; ring.
Qed.

Example upright_tool_instance :
  group 10 1 (Vec 0 0 1) (Vec 40 0 7) (Vec (-30) (-40) 0) =
  CutterCompensationC.group (1 * 10) (unit (Vec 40 0 0)) (unit (Vec (-30) (-40) 0)).
Proof. apply upright_tool; auto; try lra; [apply not_parallel_y | apply not_parallel_x]; cbn; lra. Qed.

(** * Change of side *)

(** fanuc.tool-side.side-change: the vector lies on A's offset line and on B's, which is on the other side. *)
Theorem side_change_on_both_lines r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  cosine VT U1 U2 <> 1 ->
  dot (side_change r s VT U1 U2) VT = 0 /\
  dot (side_change r s VT U1 U2) (n s VT U1) = r /\ dot (side_change r s VT U1 U2) (n (- s) VT U2) = r.
Proof.
  intros A H1 H2 K. unfold side_change. forms.
  rewrite !n_tool, n_unit, (dot_comm (n (- s) VT U2) (n s VT U1)), n_dot_n_other, n_unit by (auto using sided_opp).
  repeat split; field; lra.
Qed.

Example side_change_on_both_lines_instance :
  dot (side_change 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 0 (-50) 0)) (Vec 3 0 4) = 0 /\
  dot (side_change 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 0 (-50) 0)) (n 1 (Vec 3 0 4) (Vec 0 100 0)) = 10 /\
  dot (side_change 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 0 (-50) 0)) (n (- (1)) (Vec 3 0 4) (Vec 0 (-50) 0)) = 10.
Proof.
  apply side_change_on_both_lines; auto.
  destruct (no_turn_is_straight_or_back 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 0 (-50) 0)) as [[_ X] | [K _]]; auto;
    [values | revert X; values | lra].
Qed.

(** fanuc.tool-side.side-change: straight back both rules agree: the tool goes back on the same line. *)
Theorem side_change_straight_back r s VT U1 U2 : sided s -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  cosine VT U1 U2 = -1 ->
  side_change r s VT U1 U2 = scale r (n s VT U1) /\ scale r (n (- s) VT U2) = scale r (n s VT U1).
Proof.
  intros A H1 H2 K.
  assert (D : sub (n s VT U1) (n (- s) VT U2) = zero).
  { apply dot_self_zero. unfold sub, opp. forms.
    rewrite (dot_comm (n (- s) VT U2) (n s VT U1)), n_dot_n_other, !n_unit, K by (auto using sided_opp). ring. }
  apply sub_zero in D. unfold side_change. rewrite K, D. split; [| reflexivity].
  unfold add, scale; cbn [vx vy vz]; f_equal; field.
Qed.

Example side_change_straight_back_instance :
  side_change 10 1 (Vec 3 0 4) (Vec 100 0 0) (scale (- (2)) (Vec 100 0 0)) = scale 10 (n 1 (Vec 3 0 4) (Vec 100 0 0)) /\
  scale 10 (n (- (1)) (Vec 3 0 4) (scale (- (2)) (Vec 100 0 0))) = scale 10 (n 1 (Vec 3 0 4) (Vec 100 0 0)).
Proof.
  apply side_change_straight_back; auto; [apply tool_345_scaled; lra |].
  apply (cosine_back (Vec 3 0 4) (Vec 100 0 0) 2); auto; lra.
Qed.

(** * Change of the compensation plane *)

(** fanuc.tool-side.plane-change-reversal: the product of the projections is that of the normals, without a root. *)
Theorem projections_by_normals V U1 U2 : V <> zero ->
  dot (cross V U1) (cross V U2) = dot V V * dot (across V U1) (across V U2).
Proof. apply across_products. Qed.

Example projections_by_normals_instance :
  dot (cross (Vec 3 0 4) (Vec 0 100 0)) (cross (Vec 3 0 4) (Vec 94 (-60) (-8))) =
  dot (Vec 3 0 4) (Vec 3 0 4) * dot (across (Vec 3 0 4) (Vec 0 100 0)) (across (Vec 3 0 4) (Vec 94 (-60) (-8))).
Proof. apply projections_by_normals; auto. Qed.

(** fanuc.tool-side.plane-change-side: with one tool direction before and behind the corner, of whatever lengths, the second
    and the third condition exclude each other: without a tilt there is no alarm, whatever the limit. *)
Theorem no_alarm_without_tilt limit k V Ua Ub : V <> zero -> 0 < k -> ~ overcut limit V (scale k V) Ua Ub.
Proof.
  intros T K (_ & W & R). rewrite cross_scale_l, dot_scale_r, across_products in W by auto.
  pose proof (dot_self_pos V T) as P. assert (0 < k * dot V V) by (apply Rmult_lt_0_compat; auto). nra.
Qed.

Example no_alarm_without_tilt_instance :
  ~ overcut 0 (Vec 3 0 4) (scale 5 (Vec 3 0 4)) (Vec 0 100 0) (Vec 0 (-50) 0).
Proof. apply no_alarm_without_tilt; auto; lra. Qed.

(** fanuc.tool-side.plane-change-angle: up to a limit of 90 degrees the test by squares is that of the angle. *)
Theorem tilt_by_squares limit Va Vb : 0 < limit <= PI / 2 -> Va <> zero -> Vb <> zero ->
  (dot Va Vb <= 0 \/ (dot Va Vb)² <= (cos limit)² * (dot Va Va * dot Vb Vb) <-> limit <= angle Va Vb).
Proof.
  intros L A B. pose proof (angle_bounds Va Vb) as [G1 G2]. pose proof (cos_angle Va Vb A B) as E.
  pose proof (norm_pos Va A). pose proof (norm_pos Vb B). pose proof PI_RGT_0.
  assert (P : 0 < norm Va * norm Vb) by (apply Rmult_lt_0_compat; auto).
  assert (Cl : 0 <= cos limit) by (apply cos_ge_0; lra).
  assert (Q : (dot Va Vb)² = (cos (angle Va Vb))² * (dot Va Va * dot Vb Vb)).
  { rewrite <- E, <- !norm_sqr. unfold Rsqr; ring. }
  assert (P2 : 0 < dot Va Va * dot Vb Vb) by (apply Rmult_lt_0_compat; apply dot_self_pos; auto).
  assert (M : cos (angle Va Vb) <= cos limit <-> limit <= angle Va Vb).
  { split; intro M.
    - apply Rnot_lt_le; intro N. assert (cos limit < cos (angle Va Vb)) by (apply cos_decreasing_1; lra). lra.
    - destruct M as [M | M]; [left; apply cos_decreasing_1; lra | rewrite M; lra]. }
  rewrite <- M, Q. clear M Q. set (c := cos (angle Va Vb)) in *. rewrite <- E. split.
  - intros [N | N].
    + assert (c <= 0) by (apply Rnot_lt_le; intro X; assert (0 < c * (norm Va * norm Vb)) by (apply Rmult_lt_0_compat; auto); lra).
      lra.
    + apply Rmult_le_reg_r in N; auto. destruct (Rle_dec c 0); [lra |].
      apply Rsqr_incr_0; auto; lra.
  - intro N. destruct (Rle_dec c 0) as [Z | Z]; [left | right].
    + assert (0 <= - c * (norm Va * norm Vb)) by (apply Rmult_le_pos; lra). lra.
    + apply Rmult_le_compat_r; [lra |]. apply Rsqr_incr_1; lra.
Qed.

Example tilt_by_squares_instance :
  dot (Vec 0 (-4) 3) (Vec 0 4 3) <= 0 \/
  (dot (Vec 0 (-4) 3) (Vec 0 4 3))² <= (cos (PI / 4))² * (dot (Vec 0 (-4) 3) (Vec 0 (-4) 3) * dot (Vec 0 4 3) (Vec 0 4 3)) <->
  PI / 4 <= angle (Vec 0 (-4) 3) (Vec 0 4 3).
Proof.
  apply tilt_by_squares; try (intro E; injection E; intros; lra). pose proof PI_RGT_0; lra.
Qed.

(** fanuc.tool-side.plane-change-alarm: the three conditions by rational tests, for a limit of 45 degrees. *)
Theorem overcut_by_signs Va Vb Ua Ub : Va <> zero -> Vb <> zero ->
  dot Va Vb <= 0 \/ 2 * (dot Va Vb)² <= dot Va Va * dot Vb Vb ->
  0 <= dot (cross Va Ua) (cross Vb Ub) -> dot (cross Va Ua) (cross Va Ub) < 0 -> overcut (PI / 4) Va Vb Ua Ub.
Proof.
  intros A B T W R. split; [| split; [exact W |]].
  - apply tilt_by_squares; auto; [pose proof PI_RGT_0; lra |]. destruct T as [T | T]; [left; auto | right].
    rewrite cos_PI4. replace ((1 / sqrt 2)²) with (1 / 2); [lra |].
    unfold Rsqr. pose proof (sqrt_sqrt 2 ltac:(lra)) as Q. pose proof (sqrt_lt_R0 2 ltac:(lra)).
    replace (1 / sqrt 2 * (1 / sqrt 2)) with (1 / (sqrt 2 * sqrt 2)) by (field; lra). rewrite Q. reflexivity.
  - rewrite across_products in R by auto. pose proof (dot_self_pos Va A). nra.
Qed.

(** Golden example TS9: a tilt of 106 degrees in a groove. *)
Example overcut_by_signs_instance :
  overcut (PI / 4) (Vec 0 (-4) 3) (Vec 0 4 3) (Vec 0 (-200) (-200)) (Vec 0 (-200) 200).
Proof.
  apply overcut_by_signs; try (intro E; injection E; intros; lra); [left | |]; unfold dot, cross; cbn; lra.
Qed.
