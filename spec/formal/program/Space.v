(* SPDX-License-Identifier: Apache-2.0 *)
(** Points and vectors in space. *)
From Coq Require Import List ZArith.
From Toolcomp Require Import Numbers Outcomes Words State.
Import ListNotations.

Definition triple (num : Type) := (num * num * num)%type.

Definition add3 {num} {N : Numbers num} (a b : triple num) : triple num :=
  let '(ax, ay, az) := a in let '(bx, by_, bz) := b in ((ax + bx)%num, (ay + by_)%num, (az + bz)%num).
Definition sub3 {num} {N : Numbers num} (a b : triple num) : triple num :=
  let '(ax, ay, az) := a in let '(bx, by_, bz) := b in ((ax - bx)%num, (ay - by_)%num, (az - bz)%num).
Definition scale3 {num} {N : Numbers num} (k : num) (a : triple num) : triple num :=
  let '(x, y, z) := a in ((k * x)%num, (k * y)%num, (k * z)%num).
Definition dot3 {num} {N : Numbers num} (a b : triple num) : num :=
  let '(ax, ay, az) := a in let '(bx, by_, bz) := b in (ax * bx + ay * by_ + az * bz)%num.
Definition cross3 {num} {N : Numbers num} (a b : triple num) : triple num :=
  let '(ax, ay, az) := a in let '(bx, by_, bz) := b in
  ((ay * bz - az * by_)%num, (az * bx - ax * bz)%num, (ax * by_ - ay * bx)%num).
Definition length3 {num} {N : Numbers num} (a : triple num) : num := root (dot3 a a).

(** Of length 1, of a vector that is not 0. *)
Definition unit3 {num} {N : Numbers num} (a : triple num) : triple num :=
  let length := length3 a in
  let '(x, y, z) := a in ((x / length)%num, (y / length)%num, (z / length)%num).

(** Whether two are the same, as far as that is known of every component. *)
Definition known_same3 {num} {N : Numbers num} (a b : triple num) : bool :=
  let '(x, y, z) := sub3 a b in
  let nothing c := match sign c with Some Eq => true | _ => false end in
  nothing x && nothing y && nothing z.

(** X, Y and Z of the axes. *)
Definition in_space {num} {N : Numbers num} (s : setup num) (v : values num) : triple num :=
  (value_on s v Letter.X, value_on s v Letter.Y, value_on s v Letter.Z).
Definition with_space {num} (s : setup num) (v : values num) (x : triple num) : values num :=
  let '(x, y, z) := x in
  with_value s (with_value s (with_value s v Letter.X x) Letter.Y y) Letter.Z z.
