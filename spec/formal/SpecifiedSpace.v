(* SPDX-License-Identifier: Apache-2.0 *)
(** The vectors of program/ in space, over the real numbers, are those of Vectors.v. *)
From Coq Require Import Reals ZArith.
From Toolcomp Require Import Vectors.
From Toolcomp Require Numbers Space.
Open Scope R_scope.

(** A vector of program/. *)
Definition vector (v : Space.triple R) : vec := let '(x, y, z) := v in Vec x y z.

Lemma vector_add a b : vector (Space.add3 a b) = add (vector a) (vector b).
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]; reflexivity. Qed.
Lemma vector_sub a b : vector (Space.sub3 a b) = sub (vector a) (vector b).
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]; cbn; unfold sub, opp, add, scale; cbn; f_equal; ring. Qed.
Lemma vector_scale k a : vector (Space.scale3 k a) = scale k (vector a).
Proof. destruct a as [[? ?] ?]; reflexivity. Qed.
Lemma vector_cross a b : vector (Space.cross3 a b) = cross (vector a) (vector b).
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]; reflexivity. Qed.
Lemma vector_dot a b : Space.dot3 a b = dot (vector a) (vector b).
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]; reflexivity. Qed.
Lemma vector_length a : Space.length3 a = norm (vector a).
Proof. destruct a as [[? ?] ?]; reflexivity. Qed.
Lemma vector_unit a : vector (Space.unit3 a) = scale (/ norm (vector a)) (vector a).
Proof.
  rewrite <- vector_length. unfold Space.unit3. set (l := Space.length3 a). destruct a as [[? ?] ?].
  unfold scale; cbn. f_equal; unfold Rdiv; ring.
Qed.
Lemma vector_zero : vector (0, 0, 0) = zero.
Proof. reflexivity. Qed.
Lemma vector_same a b : vector a = vector b -> a = b.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]; cbn; intro H; now injection H as -> -> ->. Qed.
