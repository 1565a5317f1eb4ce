(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/program: the arc of a block in G02 or G03, in the plane. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** A point or a vector of the plane. *)
Definition pair (num : Type) := (num * num)%type.


Definition add2 {num} {N : Numbers num} (a b : pair num) : pair num := ((fst a + fst b)%num, (snd a + snd b)%num).
Definition sub2 {num} {N : Numbers num} (a b : pair num) : pair num := ((fst a - fst b)%num, (snd a - snd b)%num).
Definition dot2 {num} {N : Numbers num} (a b : pair num) : num := (fst a * fst b + snd a * snd b)%num.
Definition cross2 {num} {N : Numbers num} (a b : pair num) : num := (fst a * snd b - snd a * fst b)%num.

(** An arc from its start: centre, and what is told of it. *)
Record circle (num : Type) := Circle { center_at : pair num; sweep_of : option num; ends : option (num * num) }.
Arguments Circle {num}. Arguments center_at {num}. Arguments sweep_of {num}. Arguments ends {num}.

(** The letters of a plane: its axes in order, and those of the centre. *)
Definition plane_axes (p : plane) : Letter.t * Letter.t :=
  match p with XY => (Letter.X, Letter.Y) | ZX => (Letter.Z, Letter.X) | YZ => (Letter.Y, Letter.Z) end.
Definition center_letters (p : plane) : Letter.t * Letter.t :=
  match p with XY => (Letter.I, Letter.J) | ZX => (Letter.K, Letter.I) | YZ => (Letter.J, Letter.K) end.

(** fanuc.program.arc-sweep: the angle from one radius to the other in the direction of the arc, more than 0 and at most
    360 degrees; on one ray it is a whole turn.
    fanuc.program.arc-ends-in-center: no sweep where one of them is nothing. *)
Definition angle_between {num} {N : Numbers num} (clockwise : bool) (from to : pair num) : outcome (option num) :=
  let clause := "fanuc.program.arc-sweep" in
  from_length <- decide clause (dot2 from from) ;;
  to_length <- decide clause (dot2 to to) ;;
  match from_length, to_length with
  | Eq, _ | _, Eq => Got None
  | _, _ =>
      let along := dot2 from to in
      let across := if clockwise then cross2 to from else cross2 from to in
      side <- decide clause across ;;
      ahead <- decide clause along ;;
      let half := integer 180 in
      Got (Some
        match side, ahead with
        | Eq, Lt => half
        | Eq, _ => integer 360
        | Gt, Eq => integer 90
        | Lt, Eq => integer 270
        | Gt, Gt => arctangent (across / along)%num
        | Gt, Lt | Lt, Lt => (half + arctangent (across / along))%num
        | Lt, Gt => (integer 360 + arctangent (across / along))%num
        end)
  end.

(** fanuc.program.arc-full-circle: an arc whose end is its start is a full circle.
    fanuc.program.arc-spiral: start and end may have different distances from the centre. *)
Definition around {num} {N : Numbers num} (clockwise : bool) (center start finish : pair num) : outcome (circle num) :=
  let from := sub2 start center in
  let to := sub2 finish center in
  turn <- angle_between clockwise from to ;;
  equal <- is_zero "fanuc.program.arc-spiral" (dot2 to to - dot2 from from)%num ;;
  Got (Circle center turn (if equal then None else Some (root (dot2 from from), root (dot2 to to)))).

(** fanuc.program.arc-radii: the radii differ by no more than 3410, if it is given and not 0. *)
Definition radii_allowed {num} {N : Numbers num} (most : num) (c : circle num) : outcome unit :=
  unlimited <- is_zero "fanuc.program.arc-radii" most ;;
  match ends c with
  | Some (first, last) =>
      let apart := (first - last)%num in
      too_far <- is_negative "fanuc.program.arc-radii" (most * most - apart * apart)%num ;;
      alarm_if (negb unlimited && too_far) "arc-radii-differ"
  | None => Got tt
  end.

(** The vector from the start to the centre by R, where the end is that chord away. The centre of the smaller arc lies to
    the left of the chord where it runs counterclockwise. *)
Definition to_center_by_radius {num} {N : Numbers num} (clockwise larger : bool) (r : num) (chord : pair num) : pair num :=
  let height := root (r * r / dot2 chord chord - 1 / integer 4)%num in
  let height := if xorb clockwise larger then (- height)%num else height in
  let half x := (x / integer 2)%num in
  ((half (fst chord) - height * snd chord)%num, (half (snd chord) + height * fst chord)%num).

(** fanuc.program.arc-radius: an arc exists if R is at least half the chord, else PS0020.
    fanuc.program.arc-larger: a positive R means the arc of at most 180 degrees, a negative one the larger arc. *)
Definition by_radius {num} {N : Numbers num} (clockwise : bool) (r : num) (start finish : pair num) :
    outcome (circle num) :=
  let chord := sub2 finish start in
  let square := dot2 chord chord in
  too_small <- is_negative "fanuc.program.arc-radius" (integer 4 * r * r - square)%num ;;
  larger <- is_negative "fanuc.program.arc-larger" r ;;
  _ <- alarm_if too_small "arc-radius-too-short" ;;
  let to_center := to_center_by_radius clockwise larger r chord in
  turn <- angle_between clockwise (sub2 (0%num, 0%num) to_center) (sub2 chord to_center) ;;
  Got (Circle (add2 start to_center) turn None).

(** The vector from the start to the centre. fanuc.program.arc-center-in-start: I J K raise PS0022 if those of the plane
    are zero or missing; if cutter compensation C raises PS0038 instead, that comes later. *)
Definition by_center {num} {N : Numbers num} (most_apart : num) (refused_later clockwise : bool) (to_center start finish : pair num) :
    outcome (circle num) :=
  in_start <- is_zero "fanuc.program.arc-center-in-start" (dot2 to_center to_center) ;;
  _ <- alarm_if (in_start && negb refused_later) "arc-without-center" ;;
  c <- around clockwise (add2 start to_center) start finish ;;
  _ <- (if in_start then Got tt else radii_allowed most_apart c) ;;
  Got c.
