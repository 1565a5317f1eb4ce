(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-side-compensation: the compensation plane, at right angles to the tool. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Arcs Corners State Space.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** u(U): what is left of a displacement in the plane. *)
Definition projected {num} {N : Numbers num} (vt u : triple num) : triple num :=
  sub3 u (scale3 (dot3 u vt / dot3 vt vt)%num vt).

(** Whether a line moves in the plane.
    fanuc.tool-side.no-movement-limit: with 19630 positive where its projection is not shorter than that.
    fanuc.tool-side.along-the-tool: else where its displacement is neither zero nor parallel to the tool. *)
Definition line_crosses {num} {N : Numbers num} (s : setup num) (vt u : triple num) : outcome bool :=
  let across := cross3 vt u in
  let square := dot3 across across in
  let limit := or_else (parameter s "19630") 0%num in
  limited <- is_positive "fanuc.tool-side.no-movement-limit" limit ;;
  if limited : bool
  then under <- is_negative "fanuc.tool-side.no-movement-limit" (square - limit * limit * dot3 vt vt)%num ;;
       Got (negb under)
  else none <- is_zero "fanuc.tool-side.along-the-tool" square ;; Got (negb none).

(** fanuc.tool-side.left: left of a movement U is VT x U. *)
Definition leftward {num} {N : Numbers num} (vt u : triple num) : triple num :=
  let left := cross3 vt u in unit3 left.

(** fanuc.tool-side.without-basis: chapter 14 in the compensation plane, without axes in it. A cross product is that of
    space, seen along the tool. *)
Definition plane_of_tool {num} {N : Numbers num} (vt : triple num) : Plane num (triple num) := {|
  add := add3;
  subtract := sub3;
  scale := scale3;
  dot := dot3;
  cross a b := (dot3 vt (cross3 a b) / length3 vt)%num;
  left_normal a := scale3 (1 / length3 vt)%num (cross3 vt a);
  ahead a b := dot3 (cross3 vt a) (cross3 vt b);
  aside a b := (length3 vt * dot3 vt (cross3 a b))%num
|}.

(** * Arcs *)

(** The part of a vector along the normal of the plane selected: Z of G17, Y of G18, X of G19. *)
Definition along_normal {num} (p : plane) (v : triple num) : num :=
  let '(x, y, z) := v in match p with XY => z | ZX => y | YZ => x end.

(** A vector of the plane selected. *)
Definition in_selected {num} {N : Numbers num} (p : plane) (v : pair num) : triple num :=
  let '(a, b) := v in
  match p with XY => (a, b, 0%num) | ZX => (b, 0%num, a) | YZ => (0%num, a, b) end.

(** fanuc.tool-side.arc-plane: N tells the sense in which an arc is seen from the tool; on edge it has none. *)
Definition seen_clockwise {num} {N : Numbers num} (vt : triple num) (p : plane) (clockwise : bool) : outcome bool :=
  c <- decide "fanuc.tool-side.arc-plane" (along_normal p vt) ;;
  match c with
  | Gt => Got clockwise
  | Lt => Got (negb clockwise)
  | Eq => Undecided "fanuc.tool-side.arc-plane"
  end.

(** fanuc.tool-side.arc-plane-mismatch: the tool is not at right angles to the plane selected. *)
Definition plane_differs {num} {N : Numbers num} (vt : triple num) (p : plane) : outcome bool :=
  let n := match p with
           | XY => (0%num, 0%num, 1%num) | ZX => (0%num, 1%num, 0%num) | YZ => (1%num, 0%num, 0%num)
           end in
  let across := cross3 vt n in
  is_positive "fanuc.tool-side.arc-plane-mismatch" (dot3 across across).
