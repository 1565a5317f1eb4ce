(* SPDX-License-Identifier: Apache-2.0 *)
(** Points and directions of the Heidenhain sections: X, Y and Z, and the direction of the tool. *)
From Toolcomp Require Import Numbers Words Space.
From Coq Require Import ZArith.
Open Scope Z_scope.

Definition zero3 {num} {N : Numbers num} : triple num := (0%num, 0%num, 0%num).

(** A direction as it was given, and of length 1. *)
Record direction_in_space (num : Type) := Direction { as_given : triple num; of_length_1 : triple num }.
Arguments Direction {num}. Arguments as_given {num}. Arguments of_length_1 {num}.
Definition direction_along {num} {N : Numbers num} (a : triple num) : direction_in_space num := Direction a (unit3 a).

(** heidenhain.program.tool-axis: X, Y or Z of TOOL CALL is the direction of the tool where nothing turns it. *)
Definition along_axis {num} {N : Numbers num} (letter : Letter.t) : direction_in_space num :=
  let e := match letter with
           | Letter.X => (1%num, 0%num, 0%num)
           | Letter.Y => (0%num, 1%num, 0%num)
           | _ => (0%num, 0%num, 1%num)
           end in
  Direction e e.

(** Turned about a fixed axis by degrees. *)
Definition about_x {num} {N : Numbers num} (degrees : num) (a : triple num) : triple num :=
  let c := cosine degrees in
  let s := sine degrees in
  let '(x, y, z) := a in (x, (c * y - s * z)%num, (s * y + c * z)%num).
Definition about_y {num} {N : Numbers num} (degrees : num) (a : triple num) : triple num :=
  let c := cosine degrees in
  let s := sine degrees in
  let '(x, y, z) := a in ((c * x + s * z)%num, y, (c * z - s * x)%num).
Definition about_z {num} {N : Numbers num} (degrees : num) (a : triple num) : triple num :=
  let c := cosine degrees in
  let s := sine degrees in
  let '(x, y, z) := a in ((c * x - s * y)%num, (s * x + c * y)%num, z).

(** heidenhain.program.direction-of-rotary-axes: t = Rz(C) Ry(B) Rx(A) e. *)
Definition turned {num} {N : Numbers num} (a b c : num) (e : triple num) : direction_in_space num :=
  let t := about_z c (about_y b (about_x a e)) in Direction t t.
