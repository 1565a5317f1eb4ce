(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/cutter-compensation-b: the vectors of program/, over the real numbers, are those of the definitions. *)
From Coq Require Import Reals Lra Psatz Bool ZArith.
From Toolcomp Require Import Vectors CutterCompensationB OutcomeLaws.
From Toolcomp Require Numbers Outcomes Words Arcs Corners State CutterRules CutterB SpecifiedCorners.
Import Outcomes(outcome(..)).
Open Scope R_scope.

(** * Definitions *)

Definition vector : Arcs.pair R -> vec := SpecifiedCorners.vector.
Definition sigma (clockwise : bool) : R := if clockwise then -1 else 1.

Lemma perpendicular_is_V u rho : vector (Corners.perpendicular (Corners.line_leg u rho)) = V rho (vector u).
Proof.
  unfold vector, SpecifiedCorners.vector, V, left, scale, norm, dot; cbn. unfold Arcs.dot2; cbn.
  replace (fst u * fst u + snd u * snd u + 0 * 0) with (fst u * fst u + snd u * snd u) by ring.
  f_equal; unfold Rdiv; ring.
Qed.

Lemma arc_perpendicular_is_arc_V clockwise (o q : Arcs.pair R) rho :
  vector (Corners.perpendicular (Corners.arc_leg (Corners.Bow clockwise (Arcs.sub2 o q)) rho)) =
  arc_V (sigma clockwise) rho (vector o) (vector q).
Proof.
  destruct o as [ox oy], q as [qx qy].
  assert (N : norm (sub (vector (qx, qy)) (vector (ox, oy))) =
              sqrt ((qx - ox) * (qx - ox) + (qy - oy) * (qy - oy))).
  { unfold norm, vector, SpecifiedCorners.vector, sub, add, opp, scale, dot; cbn. f_equal. ring. }
  unfold arc_V. rewrite N. set (n := sqrt ((qx - ox) * (qx - ox) + (qy - oy) * (qy - oy))).
  unfold vector, SpecifiedCorners.vector, sub, add, opp, scale, sigma.
  destruct clockwise; cbn; unfold Arcs.dot2; cbn; unfold Corners.left_of; cbn;
    match goal with |- context [sqrt ?x] =>
      replace (sqrt x) with n by (unfold n; f_equal; ring) end;
    f_equal; unfold Rdiv; ring.
Qed.

(** * Vectors *)

(** fanuc.cutter-b.vector: the vector that a straight block makes is the one of the definitions, of the letters' direction
    or of its travel. *)
Theorem straight_vector_is_V s c before after rho v :
  CutterB.straight_vector s c before after rho = Got (Some v) ->
  vector v = V rho (vector (Outcomes.or_else (CutterRules.plane_letters s c)
                              (CutterRules.travel_in_plane s c before after))).
Proof.
  unfold CutterB.straight_vector; intro H. apply bound in H as (nothing & _ & H).
  destruct nothing; [discriminate|]. apply same in H.
  assert (E : Corners.perpendicular (Corners.line_leg (Outcomes.or_else (CutterRules.plane_letters s c)
                (CutterRules.travel_in_plane s c before after)) rho) = v) by congruence.
  rewrite <- E. apply perpendicular_is_V.
Qed.

Example straight_vector_is_V_instance s c before after v :
  CutterB.straight_vector s c before after 10 = Got (Some v) -> CutterRules.plane_letters s c = Some (3, 4) ->
  vector v = V 10 (Vec 3 4 0).
Proof. intros H L. apply straight_vector_is_V in H. now rewrite L in H. Qed.

(** fanuc.cutter-b.arc-vector: so is that at the end of an arc, on the line of centre and end. *)
Theorem arc_vector_is_arc_V s clockwise a after rho v :
  CutterB.arc_vector s clockwise a after rho = Got v ->
  vector v = arc_V (sigma clockwise) rho (vector (Outcomes.center a))
               (vector (CutterRules.plane_point s (Outcomes.arc_plane a) after)).
Proof.
  unfold CutterB.arc_vector; intro H. apply bound in H as (nothing & _ & H).
  apply bound in H as (tt_ & _ & H). apply same in H as <-.
  apply arc_perpendicular_is_arc_V.
Qed.

Example arc_vector_is_arc_V_instance s a after v :
  CutterB.arc_vector s true a after 10 = Got v -> Outcomes.center a = (0, 5) ->
  vector v = arc_V (sigma true) 10 (Vec 0 5 0) (vector (CutterRules.plane_point s (Outcomes.arc_plane a) after)).
Proof. intros H C. apply arc_vector_is_arc_V in H. now rewrite C in H. Qed.
