(* SPDX-License-Identifier: Apache-2.0 *)
(** The tool direction from the positions of two rotary axes: the front end of every section with a tool vector. *)
From Coq Require Import Reals Lra Psatz.
From Toolcomp Require Import Vectors.
Open Scope R_scope.

(** * Definitions *)

(** Rotation about the unit direction [k] by [theta], right-handed (Rodrigues). *)
Definition rotate k theta v :=
  add (scale (cos theta) v) (add (scale (sin theta) (cross k v)) (scale ((1 - cos theta) * dot k v) k)).

Definition ex := Vec 1 0 0.
Definition ey := Vec 0 1 0.
Definition ez := Vec 0 0 1.

(** The tool direction: the axis carried by the other turns it first. *)
Definition tool_direction first theta second phi v0 := rotate second phi (rotate first theta v0).

(** The reference direction of the tool from the two reference angles. *)
Definition reference_direction ra rb := rotate ey rb (rotate ex ra ez).

(** * Theorems *)

Lemma rotate_about_x a v : rotate ex a v = Vec (vx v) (cos a * vy v - sin a * vz v) (sin a * vy v + cos a * vz v).
Proof. unfold rotate, ex; vec_ring. Qed.

Lemma rotate_about_y b v : rotate ey b v = Vec (cos b * vx v + sin b * vz v) (vy v) (cos b * vz v - sin b * vx v).
Proof. unfold rotate, ey; vec_ring. Qed.

Lemma rotate_about_z c v : rotate ez c v = Vec (cos c * vx v - sin c * vy v) (sin c * vx v + cos c * vy v) (vz v).
Proof. unfold rotate, ez; vec_ring. Qed.

Ltac rotation :=
  unfold tool_direction, reference_direction; rewrite ?rotate_about_x, ?rotate_about_y, ?rotate_about_z; cbn [vx vy vz ez].

Lemma cos_sin_unit theta : (cos theta)² = 1 - (sin theta)².
Proof. pose proof (sin2_cos2 theta); lra. Qed.

Lemma rotate_dot k theta u v : dot k k = 1 -> dot (rotate k theta u) (rotate k theta v) = dot u v.
Proof.
  intro K. assert (C : cos theta * cos theta = 1 - sin theta * sin theta) by (exact (cos_sin_unit theta)).
  assert (L : dot (cross k u) (cross k v) = dot k k * dot u v - dot k u * dot k v) by vec_ring.
  assert (A : dot u (cross k v) = - dot (cross k u) v) by vec_ring.
  assert (B : dot (cross k u) k = 0) by vec_ring.
  assert (D : dot k (cross k v) = 0) by vec_ring.
  unfold rotate. set (c := cos theta) in *; set (s := sin theta) in *.
  rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, L, A, B, D, K.
  rewrite (dot_comm u k). set (p := dot k u); set (q := dot k v); set (w := dot u v).
  ring [C].
Qed.

(** fanuc.tool-direction.mechanism: rotary axes keep the length of the tool direction, so it stays a unit vector. *)
Theorem tool_direction_unit first theta second phi v0 :
  dot first first = 1 -> dot second second = 1 -> norm (tool_direction first theta second phi v0) = norm v0.
Proof. intros A B; unfold tool_direction, norm; rewrite !rotate_dot by auto; reflexivity. Qed.

Example tool_direction_unit_instance theta phi : norm (tool_direction (Vec 0 1 0) theta (Vec (3/5) 0 (4/5)) phi ez) = norm ez.
Proof. apply tool_direction_unit; unfold dot; cbn; lra. Qed.

(** fanuc.tool-direction.mechanism: with C carrying B and the tool along Z, VT = (sin b cos c, sin b sin c, cos b). *)
Theorem tool_direction_BC b c : tool_direction ey b ez c ez = Vec (sin b * cos c) (sin b * sin c) (cos b).
Proof. rotation; f_equal; ring. Qed.

Example tool_direction_BC_instance : tool_direction ey (PI / 2) ez 0 ez = ex.
Proof. rewrite tool_direction_BC, sin_PI2, cos_PI2, sin_0, cos_0; unfold ex; f_equal; ring. Qed.

(** fanuc.tool-direction.mechanism: with C carrying A and the tool along Z, VT = (sin a sin c, -sin a cos c, cos a). *)
Theorem tool_direction_AC a c : tool_direction ex a ez c ez = Vec (sin a * sin c) (- sin a * cos c) (cos a).
Proof. rotation; f_equal; ring. Qed.

Example tool_direction_AC_instance : tool_direction ex (PI / 2) ez 0 ez = opp ey.
Proof. rewrite tool_direction_AC, sin_PI2, cos_PI2, sin_0, cos_0; unfold opp, ey, scale; cbn; f_equal; ring. Qed.

(** fanuc.tool-direction.older-tool-axis: the reference angles RA and RB give v0 = (cos RA sin RB, -sin RA, cos RA cos RB)
    when RA is the rotation about axis 1 and RB, about axis 2, follows it. *)
Theorem reference_direction_components ra rb :
  reference_direction ra rb = Vec (cos ra * sin rb) (- sin ra) (cos ra * cos rb).
Proof. rotation; f_equal; ring. Qed.

Example reference_direction_components_instance : reference_direction 0 (PI / 2) = ex.
Proof. rewrite reference_direction_components, sin_PI2, cos_PI2, sin_0, cos_0; unfold ex; f_equal; ring. Qed.

(** fanuc.tool-direction.mechanism: an axis turned by a and then by b is turned by a + b. *)
Theorem rotate_twice k a b v : dot k k = 1 -> rotate k b (rotate k a v) = rotate k (a + b) v.
Proof.
  intro K. unfold rotate.
  assert (D : dot k (add (scale (cos a) v) (add (scale (sin a) (cross k v)) (scale ((1 - cos a) * dot k v) k))) = dot k v).
  { rewrite !dot_add_r, !dot_scale_r, K. replace (dot k (cross k v)) with 0 by vec_ring. ring. }
  assert (X : cross k (cross k v) = sub (scale (dot k v) k) v).
  { transitivity (sub (scale (dot k v) k) (scale (dot k k) v)); [vec_ring | rewrite K, scale_one; reflexivity]. }
  rewrite D, cos_plus, sin_plus.
  assert (E : cross k (add (scale (cos a) v) (add (scale (sin a) (cross k v)) (scale ((1 - cos a) * dot k v) k))) =
              add (scale (cos a) (cross k v)) (scale (sin a) (cross k (cross k v)))) by vec_ring.
  rewrite E, X. set (p := dot k v). set (w := cross k v). clearbody p w.
  set (ca := cos a); set (sa := sin a); set (cb := cos b); set (sb := sin b). vec_ring.
Qed.

Example rotate_twice_instance v : rotate ez 1 (rotate ez 2 v) = rotate ez (2 + 1) v.
Proof. apply rotate_twice; unfold dot; cbn; lra. Qed.
