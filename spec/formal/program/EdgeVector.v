(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/leading-edge-offset: the vector at the end of a block, of the tool direction there and a movement. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes State Space.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** How the tool stands to the movement. *)
Inductive angle := Along | Across | Leaning.

(** fanuc.leading-edge.fluctuation: D, in degrees; 1 where the setup gives none.
    fanuc.leading-edge.exact-only: at 0 or below only exact angles count. *)
Definition fluctuation {num} {N : Numbers num} (s : setup num) : outcome num :=
  let d := or_else (parameter s "19631") 1%num in
  positive <- is_positive "fanuc.leading-edge.exact-only" d ;;
  Got (if positive then d else 0%num).

(** fanuc.leading-edge.near-0, fanuc.leading-edge.near-180, fanuc.leading-edge.near-90: the ranges include their ends.
    fanuc.leading-edge.order-of-ranges: they are tested in the order 0, 180, 90. *)
Definition angle_class {num} {N : Numbers num} (s : setup num) (leaning : comparison) (vm vt : triple num) :
    outcome angle :=
  d <- fluctuation s ;;
  let product := dot3 vm vt in
  let square := (product * product)%num in
  let lengths := (dot3 vm vm * dot3 vt vt)%num in
  let c := cosine d in
  near_end <-
    match leaning with
    | Eq => Got false
    | Gt => under <- is_negative "fanuc.leading-edge.near-0" (square - c * c * lengths)%num ;; Got (negb under)
    | Lt => under <- is_negative "fanuc.leading-edge.near-180" (square - c * c * lengths)%num ;; Got (negb under)
    end ;;
  if near_end : bool then Got Along
  else
    far <- is_negative "fanuc.leading-edge.near-90" ((1 - c * c) * lengths - square)%num ;;
    Got (if far then Leaning else Across).

(** The side of a vector that has been made, and the vector. *)
Record leading (num : Type) := Leading { backward : bool; leading_vector : triple num }.
Arguments Leading {num}. Arguments backward {num}. Arguments leading_vector {num}.

(** fanuc.leading-edge.vector: VC = R V/|V| where the tool leans forward, -R V/|V| where it leans back, with
    V = (VM x VT) x VT.
    fanuc.leading-edge.negative-radius: a negative value reverses the vector, not the side. *)
Definition leading_by {num} {N : Numbers num} (back : bool) (r : num) (vm vt : triple num) : leading num :=
  let v := cross3 (cross3 vm vt) vt in
  let r := if back then r else (- r)%num in
  Leading back (scale3 (r / length3 v)%num v).

(** The vector of a pair; none where it stays as it was.
    fanuc.leading-edge.sign: below 90 degrees the vector points backward, above it forward.
    fanuc.leading-edge.kept-along-the-tool: at 0 and 180 degrees the vector before is kept.
    fanuc.leading-edge.across-keeps-sense: at 90 degrees the side of the last vector that was computed.
    fanuc.leading-edge.start-across: at the start the sign itself decides, an exact right angle as if it leaned forward. *)
Definition leading_vector_of {num} {N : Numbers num} (s : setup num) (last : option (leading num)) (r : num)
    (vm vt : triple num) : outcome (option (leading num)) :=
  leaning <- decide "fanuc.leading-edge.sign" (dot3 vm vt) ;;
  a <- angle_class s leaning vm vt ;;
  let by_sign := match leaning with Lt => false | _ => true end in
  Got (match a, last with
       | Along, _ => None
       | Across, Some v => Some (leading_by (backward v) r vm vt)
       | _, _ => Some (leading_by by_sign r vm vt)
       end).
