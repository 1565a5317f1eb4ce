(* SPDX-License-Identifier: Apache-2.0 *)
(** Corners of two blocks in a plane: the vectors that chapter 14 makes there, of start-up and cancel too. Nothing here
    knows a program. A head is the corner plus a vector; the vectors of a corner, in their order, are its group. The plane
    is the one selected, or that of a tool in space. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Codes Arcs.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Definition scale2 {num} {N : Numbers num} (k : num) (a : pair num) : pair num := ((k * fst a)%num, (k * snd a)%num).
Definition square2 {num} {N : Numbers num} (a : pair num) : num := dot2 a a.
Definition length2 {num} {N : Numbers num} (a : pair num) : num := root (square2 a).
(** To the left of a direction. *)
Definition left_of {num} {N : Numbers num} (t : pair num) : pair num := ((- snd t)%num, fst t).
Definition zero2 {num} {N : Numbers num} : pair num := (0%num, 0%num).

(** The vectors of a plane. *)
Class Plane (num vec : Type) := {
  add : vec -> vec -> vec;
  subtract : vec -> vec -> vec;
  scale : num -> vec -> vec;
  dot : vec -> vec -> num;
  cross : vec -> vec -> num;      (* positive where the second lies to the left of the first *)
  left_normal : vec -> vec;       (* to the left of a vector, of its length *)
  ahead : vec -> vec -> num;      (* dot and cross of tangents, both longer by the same factor *)
  aside : vec -> vec -> num
}.

#[global] Instance plane_of_pairs {num} {N : Numbers num} : Plane num (pair num) := {
  add := add2;
  subtract := sub2;
  scale := scale2;
  dot := dot2;
  cross := cross2;
  left_normal := left_of;
  ahead := dot2;
  aside := cross2
}.

(** * Blocks at a corner *)

(** An arc, seen from the corner. *)
Record bow_in (vec : Type) := Bow { runs_clockwise : bool; to_center : vec }.
Arguments Bow {vec}. Arguments runs_clockwise {vec}. Arguments to_center {vec}.

(** A block where it ends or starts at the corner. *)
Record leg_in (num vec : Type) := Leg {
  way : vec;                       (* tangent, of any length *)
  unit_way : vec;
  normal : vec;                    (* to the left, of length 1 *)
  bent : option (bow_in vec);         (* none: a line *)
  rho : num                        (* by how much it is offset to the left *)
}.
Arguments Leg {num vec}. Arguments way {num vec}. Arguments unit_way {num vec}. Arguments normal {num vec}.
Arguments bent {num vec}. Arguments rho {num vec}.

(** Of the plane selected. *)
Definition bow (num : Type) := bow_in (pair num).
Definition leg (num : Type) := leg_in num (pair num).

Inductive corner := StraightOn | Inner | Obtuse | Acute.

(** Where two offset paths meet. *)
Inductive meeting (vec : Type) :=
| MeetAt (v : vec)
| NoOffsetCircle
| Apart.
Arguments MeetAt {vec} v. Arguments NoOffsetCircle {vec}. Arguments Apart {vec}.

Definition opposite {num vec} {N : Numbers num} {P : Plane num vec} (a : vec) : vec := scale (integer (-1)) a.
Definition square_of {num vec} {P : Plane num vec} (a : vec) : num := dot a a.

Definition leg_along {num vec} {N : Numbers num} {P : Plane num vec} (direction : vec) (b : option (bow_in vec))
    (rho : num) : leg_in num vec :=
  let unit := scale (1 / root (square_of direction))%num direction in
  Leg direction unit (left_normal unit) b rho.
Definition line_leg {num vec} {N : Numbers num} {P : Plane num vec} (direction : vec) (rho : num) : leg_in num vec :=
  leg_along direction None rho.
(** fanuc.cutter-c.corner-side: of an arc the tangent at right angles to the radius at the corner. *)
Definition arc_leg {num vec} {N : Numbers num} {P : Plane num vec} (b : bow_in vec) (rho : num) : leg_in num vec :=
  let outward := left_normal (opposite (to_center b)) in
  leg_along (if runs_clockwise b then opposite outward else outward) (Some b) rho.
Definition with_rho {num vec} (a : leg_in num vec) (rho : num) : leg_in num vec :=
  Leg (way a) (unit_way a) (normal a) (bent a) rho.
Definition is_arc {num vec} (a : leg_in num vec) : bool := given (bent a).

(** P1 of the block before the corner, P2 of the one behind it. *)
Definition perpendicular {num vec} {P : Plane num vec} (a : leg_in num vec) : vec := scale (rho a) (normal a).
(** M: where the offset tangents meet. *)
Definition tangents_meet {num vec} {N : Numbers num} {P : Plane num vec} (a b : leg_in num vec) : vec :=
  scale (rho a / (1 + dot (unit_way a) (unit_way b)))%num (add (normal a) (normal b)).
(** Q1 and Q2: both offset tangents prolonged by the offset. *)
Definition prolonged {num vec} {N : Numbers num} {P : Plane num vec} (a b : leg_in num vec) : outcome (list vec) :=
  right <- is_negative "fanuc.cutter.side" (rho a) ;;
  let r := if right : bool then (- rho a)%num else rho a in
  Got [add (perpendicular a) (scale r (unit_way a)); subtract (perpendicular b) (scale r (unit_way b))].

(** * Classification of a corner *)

(** fanuc.cutter-c.corner-side: over 180 degrees on the side of the workpiece inner, below outer.
    fanuc.cutter-c.straight-or-reversal: straight on is an inner corner of 180 degrees, straight back an acute one of 0.
    fanuc.cutter-c.obtuse-or-acute: an outer corner is obtuse from 90 degrees on. *)
Definition corner_of {num vec} {N : Numbers num} {P : Plane num vec} (a b : leg_in num vec) : outcome corner :=
  side <- decide "fanuc.cutter-c.corner-side" (rho a * aside (way a) (way b))%num ;;
  match side with
  | Gt => Got Inner
  | Eq => back <- is_negative "fanuc.cutter-c.straight-or-reversal" (ahead (way a) (way b)) ;;
          Got (if back : bool then Acute else StraightOn)
  | Lt => acute <- is_negative "fanuc.cutter-c.obtuse-or-acute" (ahead (way a) (way b)) ;;
          Got (if acute : bool then Acute else Obtuse)
  end.

(** The decimal given for tan 1: 31 digits, in three parts. *)
Definition tangent_of_one_degree {num} {N : Numbers num} : num :=
  let part digits rest := ((integer digits + rest) / integer 10000000000)%num in
  part 174550649 (part 2821758576 (part 5128895219 (integer 7 / integer 10)%num)).

(** fanuc.cutter-c.under-one-degree: of an acute outer corner of two lines. *)
Definition under_one_degree {num vec} {N : Numbers num} {P : Plane num vec} (a b : leg_in num vec) : outcome bool :=
  if is_arc a || is_arc b then Got false
  else
    let c := aside (way a) (way b) in
    let near := (tangent_of_one_degree * ahead (way a) (way b))%num in
    is_positive "fanuc.cutter-c.under-one-degree" (near * near - c * c)%num.

(** * Intersections with an arc *)

(** fanuc.cutter-c.offset-radius-at-a-corner: none where the offset is larger than the radius. *)
Definition offset_radius {num vec} {N : Numbers num} {P : Plane num vec} (b : bow_in vec) (rho : num) :
    outcome (option num) :=
  let clause := "fanuc.cutter-c.offset-radius-at-a-corner" in
  let inward := if runs_clockwise b then (- rho)%num else rho in
  let square := square_of (to_center b) in
  smaller <- is_positive clause inward ;;
  none <- (if smaller : bool then is_negative clause (square - inward * inward)%num else Got false) ;;
  Got (if none : bool then None else Some (root square - inward)%num).

(** fanuc.cutter-c.line-meets-arc: where the radius is at least the distance of the centre from the offset line.
    fanuc.cutter-c.line-arc-point: the point on the same side of the foot of the centre as the corner. *)
Definition line_meets_circle {num vec} {N : Numbers num} {P : Plane num vec} (line : leg_in num vec) (b : bow_in vec)
    (radius : num) : outcome (meeting vec) :=
  let h := (dot (to_center b) (normal line) - rho line)%num in
  let square := (radius * radius - h * h)%num in
  apart <- is_negative "fanuc.cutter-c.line-meets-arc" square ;;
  if apart : bool then Got Apart
  else
    let foot := dot (to_center b) (unit_way line) in
    behind <- is_negative "fanuc.cutter-c.line-arc-point" foot ;;
    let s := if behind : bool then (foot + root square)%num else (foot - root square)%num in
    Got (MeetAt (add (perpendicular line) (scale s (unit_way line)))).

(** fanuc.cutter-c.circles-apart: they meet where the distance of the centres is at most the sum of the radii,
    fanuc.cutter-c.circles-nested: and at least their difference.
    fanuc.cutter-c.arc-arc-point: the point on the side of the line through the centres where the corner lies. *)
Definition circles_meet {num vec} {N : Numbers num} {P : Plane num vec} (center1 : vec) (radius1 : num)
    (center2 : vec) (radius2 : num) : outcome (meeting vec) :=
  let e := subtract center2 center1 in
  let square := square_of e in
  let sum := (radius1 + radius2)%num in
  let difference := (radius1 - radius2)%num in
  apart <- is_negative "fanuc.cutter-c.circles-apart" (sum * sum - square)%num ;;
  if apart : bool then Got Apart
  else
    nested <- is_negative "fanuc.cutter-c.circles-nested" (square - difference * difference)%num ;;
    if nested : bool then Got Apart
    else
      right <- is_negative "fanuc.cutter-c.arc-arc-point" (cross e (opposite center1)) ;;
      let a := ((square + radius1 * radius1 - radius2 * radius2) / (integer 2 * square))%num in
      let b := root ((radius1 * radius1 - a * a * square) / square)%num in
      let aside := scale (if right : bool then (- b)%num else b) (left_normal e) in
      Got (MeetAt (add center1 (add (scale a e) aside))).

(** The intersection of two offset paths of which one at least is an arc, each with its own offset. Of two arcs the first
    is asked first whether it has an offset circle. *)
Definition paths_meet {num vec} {N : Numbers num} {P : Plane num vec} (a b : leg_in num vec) : outcome (meeting vec) :=
  match bent a, bent b with
  | Some arc, None | None, Some arc =>
      let line := if is_arc a then b else a in
      radius <- offset_radius arc (if is_arc a then rho a else rho b) ;;
      match radius with Some r => line_meets_circle line arc r | None => Got NoOffsetCircle end
  | Some arc1, Some arc2 =>
      radius1 <- offset_radius arc1 (rho a) ;;
      match radius1 with
      | None => Got NoOffsetCircle
      | Some r1 =>
          radius2 <- offset_radius arc2 (rho b) ;;
          match radius2 with
          | Some r2 => circles_meet (to_center arc1) r1 (to_center arc2) r2
          | None => Got NoOffsetCircle
          end
      end
  | None, None => Got (MeetAt (tangents_meet a b))
  end.

(** * Groups of vectors *)

(** The perpendicular vector beside the others, of an arc alone. *)
Definition of_arc {num vec} {P : Plane num vec} (a : leg_in num vec) : list vec :=
  if is_arc a then [perpendicular a] else [].

(** The corners of the mode.
    fanuc.cutter-c.tangent-join: P1.
    fanuc.cutter-c.outer-obtuse: the intersection of the offset tangents; beside it the perpendicular vector of each arc.
    fanuc.cutter-c.outer-acute: both offset tangents are prolonged; the perpendicular vector of each arc beside them.
    fanuc.cutter-c.inner-lines: the intersection of the offset lines.
    fanuc.cutter-c.no-intersection: an inner corner with an arc whose offset paths do not meet raises PS0033, but one
    without an offset circle has P1. *)
Definition mode_group {num vec} {N : Numbers num} {P : Plane num vec} (a b : leg_in num vec) : outcome (list vec) :=
  kind <- corner_of a b ;;
  match kind with
  | StraightOn => Got [perpendicular a]
  | Obtuse => Got (of_arc a ++ [tangents_meet a b] ++ of_arc b)
  | Acute => both <- prolonged a b ;; Got (of_arc a ++ both ++ of_arc b)
  | Inner =>
      meeting <- paths_meet a b ;;
      match meeting with
      | MeetAt v => Got [v]
      | NoOffsetCircle => Got [perpendicular a]
      | Apart => Alarm "no-intersection"
      end
  end.

(** At the end of a start-up block. fanuc.cutter-c.start-up-type: type A has P2.
    fanuc.cutter-c.start-up-inner: type B too at an inner corner.
    fanuc.cutter-c.start-up-obtuse: the vector perpendicular to the start-up block, the intersection, and before an arc its
    perpendicular vector.
    fanuc.cutter-c.start-up-acute: the first of them, the two prolonged ones, and before an arc its perpendicular vector;
    fanuc.cutter-c.under-one-degree: P2. *)
Definition start_up_group {num vec} {N : Numbers num} {P : Plane num vec} (type_b : bool) (a b : leg_in num vec) :
    outcome (list vec) :=
  if negb type_b then Got [perpendicular b]
  else
    kind <- corner_of a b ;;
    match kind with
    | StraightOn | Inner => Got [perpendicular b]
    | Obtuse => Got ([perpendicular a; tangents_meet a b] ++ of_arc b)
    | Acute =>
        tiny <- under_one_degree a b ;;
        if tiny : bool then Got [perpendicular b]
        else both <- prolonged a b ;; Got ([perpendicular a] ++ both ++ of_arc b)
    end.

(** Before a cancel block. fanuc.cutter-c.start-up-type: type A has P1.
    fanuc.cutter-c.cancel-inner: type B too at an inner corner.
    fanuc.cutter-c.cancel-obtuse: the intersection and the vector perpendicular to the cancel block, behind an arc its
    perpendicular vector first.
    fanuc.cutter-c.cancel-acute: the two prolonged vectors and the one perpendicular to the cancel block, likewise;
    fanuc.cutter-c.under-one-degree: P1. *)
Definition cancel_group {num vec} {N : Numbers num} {P : Plane num vec} (type_b : bool) (a b : leg_in num vec) :
    outcome (list vec) :=
  if negb type_b then Got [perpendicular a]
  else
    kind <- corner_of a b ;;
    match kind with
    | StraightOn | Inner => Got [perpendicular a]
    | Obtuse => Got (of_arc a ++ [tangents_meet a b; perpendicular b])
    | Acute =>
        tiny <- under_one_degree a b ;;
        if tiny : bool then Got [perpendicular a]
        else both <- prolonged a b ;; Got (of_arc a ++ both ++ [perpendicular b])
    end.

(** fanuc.cutter-c.direction-change: the intersection of the offset paths, inner and outer alike.
    fanuc.cutter-c.direction-change-parallel: parallel tangents have none.
    fanuc.cutter-c.direction-change-lines, fanuc.cutter-c.direction-change-arcs: two lines have one, an arc where its path
    meets the other.
    fanuc.cutter-c.direction-change-without-intersection: the vector perpendicular to the block behind the corner. *)
Definition direction_change_group {num vec} {N : Numbers num} {P : Plane num vec} (a b : leg_in num vec) :
    outcome (list vec) :=
  parallel <- is_zero "fanuc.cutter-c.direction-change-parallel" (aside (way a) (way b)) ;;
  if parallel : bool then Got [perpendicular b]
  else if is_arc a || is_arc b then
    meeting <- paths_meet a b ;;
    Got (match meeting with MeetAt v => [v] | NoOffsetCircle | Apart => [perpendicular b] end)
  else
    let k := dot (unit_way a) (unit_way b) in
    Got [scale (rho a / (1 - k))%num (subtract (normal a) (normal b))].

(** fanuc.cutter-c.cancel-direction: the intersection with a line in that direction, offset to the same side.
    fanuc.cutter-c.cancel-direction-parallel: without one P1. *)
Definition directed_cancel_group {num vec} {N : Numbers num} {P : Plane num vec} (a : leg_in num vec)
    (direction : vec) : outcome (list vec) :=
  let line := line_leg direction (rho a) in
  parallel <- is_zero "fanuc.cutter-c.cancel-direction-parallel" (aside (way a) direction) ;;
  if parallel : bool then Got [perpendicular a]
  else
    meeting <- paths_meet a line ;;
    Got [match meeting with MeetAt v => v | NoOffsetCircle | Apart => perpendicular a end].


(** * No. 5010 *)

(** At most the limit, in an axis. *)
Definition within {num} {N : Numbers num} (limit d : num) : outcome bool :=
  let clause := "fanuc.cutter-c.small-corner-movement" in
  over <- is_negative clause (limit - d)%num ;;
  if over : bool then Got false else under <- is_negative clause (limit + d)%num ;; Got (negb under).

(** fanuc.cutter-c.small-corner-movement: going along a group, a vector that differs from the last one kept by at most the
    limit in the first and in the second axis is dropped. *)
Fixpoint kept_behind {num} {N : Numbers num} (limit : num) (last : pair num) (vs : list (pair num)) :
    outcome (list (pair num)) :=
  match vs with
  | [] => Got []
  | v :: rest =>
      let d := sub2 v last in
      first <- within limit (fst d) ;;
      second <- (if first : bool then within limit (snd d) else Got false) ;;
      if second : bool then kept_behind limit last rest
      else later <- kept_behind limit v rest ;; Got (v :: later)
  end.
Definition without_small_moves {num} {N : Numbers num} (limit : num) (vs : list (pair num)) : outcome (list (pair num)) :=
  match vs with
  | [] => Got []
  | v :: rest => later <- kept_behind limit v rest ;; Got (v :: later)
  end.
