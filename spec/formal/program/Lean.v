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

(** fanuc.tool-center-point.lean: d is the programmed travel of the block.
    fanuc.tool-center-point.lean-in-an-arc: in an arc the tangent in space at its end: d = theta (u x r) + h u, with theta
    the sweep in radians, in the sense of the arc, u the normal of the plane, r the radius at the end, h the travel along
    u. Where h is 0 the length of d, and so theta, does not matter. *)
Definition travel_at_end {num} {N : Numbers num} (s : setup num) (p : plane) (clockwise : bool)
    (circle_of : option (circle num)) (from to : triple num) : outcome (triple num) :=
  match circle_of with
  | None => Got (sub3 to from)
  | Some c =>
      let end_in_plane := let '(x, y, z) := to in match p with XY => (x, y) | ZX => (z, x) | YZ => (y, z) end in
      let '(r1, r2) := sub2 end_in_plane (center_at c) in
      let tangent := if clockwise then (r2, (- r1)%num) else ((- r2)%num, r1) in
      let h := across_plane p (sub3 to from) in
      flat <- is_zero "fanuc.tool-center-point.lean-in-an-arc" h ;;
      if flat : bool then Got (plane_in_space p tangent 0%num)
      else
        let theta := (or_else (sweep_of c) 0 * half_turn / integer 180)%num in
        Got (plane_in_space p ((theta * fst tangent)%num, (theta * snd tangent)%num) h)
  end.

(** fanuc.tool-center-point.lean: V' = R((V x d)/|V x d|, Q) V.
    fanuc.tool-center-point.lean-along-the-travel: where V is parallel to d Q has no effect. *)
Definition leaned {num} {N : Numbers num} (q : num) (v d : triple num) : outcome (triple num) :=
  let n := cross3 v d in
  let square := dot3 n n in
  along <- is_zero "fanuc.tool-center-point.lean-along-the-travel" square ;;
  if along : bool then Got v
  else Got (add3 (scale3 (cosine q) v) (scale3 (sine q / root square)%num (cross3 n v))).
