(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool center point control of type 2: the lean of the tool by Q. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Angles ControlState State Space.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** A vector of a plane, and one across it, in space. *)
Definition plane_in_space {num} (p : plane) (v : pair num) (across : num) : triple num :=
  let '(first, second) := v in
  match p with
  | XY => (first, second, across)
  | ZX => (second, across, first)
  | YZ => (across, first, second)
  end.
Definition across_plane {num} (p : plane) (v : triple num) : num :=
  let '(x, y, z) := v in match p with XY => z | ZX => y | YZ => x end.

Definition in_plane_of_space {num} (p : plane) (v : triple num) : pair num :=
  let '(x, y, z) := v in match p with XY => (x, y) | ZX => (z, x) | YZ => (y, z) end.

(** fanuc.tool-center-point.lean: d is the programmed travel of the block.
    fanuc.tool-center-point.lean-in-an-arc: in an arc, which is given by R, the tangent in space at its end:
    d = theta (u x r) + h u, with theta the sweep in radians, in the sense of the arc, u the normal of the plane, r the
    radius at the end, h the travel along u. Where h is 0 the length of d, and so theta, does not matter. Nothing in it
    depends on where the arc starts. *)
Definition travel_at_end {num} {N : Numbers num} (p : plane) (clockwise : bool) (arc_radius : option num)
    (travel : triple num) : outcome (triple num) :=
  match arc_radius with
  | None => Got travel
  | Some radius =>
      let clause := "fanuc.tool-center-point.lean-in-an-arc" in
      let chord := in_plane_of_space p travel in
      larger <- is_negative clause radius ;;
      let to_center := to_center_by_radius clockwise larger radius chord in
      let r := sub2 chord to_center in
      let tangent := if clockwise then (snd r, (- fst r)%num) else ((- snd r)%num, fst r) in
      let h := across_plane p travel in
      flat <- is_zero clause h ;;
      if flat : bool then Got (plane_in_space p tangent 0%num)
      else
        swept <- angle_between clockwise (sub2 (0%num, 0%num) to_center) r ;;
        let theta := (or_else swept 0 * half_turn / integer 180)%num in
        Got (plane_in_space p ((theta * fst tangent)%num, (theta * snd tangent)%num) h)
  end.

(** fanuc.tool-center-point.lean: V' = R((V x d)/|V x d|, Q) V.
    fanuc.tool-center-point.lean-along-the-travel: if V is parallel to d, Q has no effect. *)
Definition leaned {num} {N : Numbers num} (q : num) (v d : triple num) : outcome (triple num) :=
  let n := cross3 v d in
  let square := dot3 n n in
  along <- is_zero "fanuc.tool-center-point.lean-along-the-travel" square ;;
  if along : bool then Got v
  else Got (add3 (scale3 (cosine q) v) (scale3 (sine q / root square)%num (cross3 n v))).
