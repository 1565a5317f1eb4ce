(** Points and directions of the Heidenhain sections: X, Y and Z, and the direction of the tool. *)
From Toolcomp Require Import Numbers Words.
From Coq Require Import ZArith.
Open Scope Z_scope.

(** A point or a vector. *)
Record vec (num : Type) := Vec { x_of : num; y_of : num; z_of : num }.
Arguments Vec {num}. Arguments x_of {num}. Arguments y_of {num}. Arguments z_of {num}.

Definition zero3 {num} {N : Numbers num} : vec num := Vec 0%num 0%num 0%num.
Definition add3 {num} {N : Numbers num} (a b : vec num) : vec num :=
  Vec (x_of a + x_of b)%num (y_of a + y_of b)%num (z_of a + z_of b)%num.
Definition sub3 {num} {N : Numbers num} (a b : vec num) : vec num :=
  Vec (x_of a - x_of b)%num (y_of a - y_of b)%num (z_of a - z_of b)%num.
Definition scale3 {num} {N : Numbers num} (k : num) (a : vec num) : vec num :=
  Vec (k * x_of a)%num (k * y_of a)%num (k * z_of a)%num.
Definition dot3 {num} {N : Numbers num} (a b : vec num) : num :=
  (x_of a * x_of b + y_of a * y_of b + z_of a * z_of b)%num.
Definition cross3 {num} {N : Numbers num} (a b : vec num) : vec num :=
  Vec (y_of a * z_of b - z_of a * y_of b)%num (z_of a * x_of b - x_of a * z_of b)%num
      (x_of a * y_of b - y_of a * x_of b)%num.

(** Of length 1, of a vector that is not 0. *)
Definition unit3 {num} {N : Numbers num} (a : vec num) : vec num :=
  let length := root (dot3 a a) in
  Vec (x_of a / length)%num (y_of a / length)%num (z_of a / length)%num.

(** A direction as it was given, and of length 1. *)
Record direction_in_space (num : Type) := Direction { as_given : vec num; of_length_1 : vec num }.
Arguments Direction {num}. Arguments as_given {num}. Arguments of_length_1 {num}.
Definition direction_along {num} {N : Numbers num} (a : vec num) : direction_in_space num := Direction a (unit3 a).

(** heidenhain.program.tool-axis: X, Y or Z of TOOL CALL is the direction of the tool where nothing turns it. *)
Definition along_axis {num} {N : Numbers num} (letter : Letter.t) : direction_in_space num :=
  let e := match letter with
           | Letter.X => Vec 1%num 0%num 0%num
           | Letter.Y => Vec 0%num 1%num 0%num
           | _ => Vec 0%num 0%num 1%num
           end in
  Direction e e.

(** Turned about a fixed axis by degrees. *)
Definition about_x {num} {N : Numbers num} (degrees : num) (a : vec num) : vec num :=
  let c := cosine degrees in
  let s := sine degrees in
  Vec (x_of a) (c * y_of a - s * z_of a)%num (s * y_of a + c * z_of a)%num.
Definition about_y {num} {N : Numbers num} (degrees : num) (a : vec num) : vec num :=
  let c := cosine degrees in
  let s := sine degrees in
  Vec (c * x_of a + s * z_of a)%num (y_of a) (c * z_of a - s * x_of a)%num.
Definition about_z {num} {N : Numbers num} (degrees : num) (a : vec num) : vec num :=
  let c := cosine degrees in
  let s := sine degrees in
  Vec (c * x_of a - s * y_of a)%num (s * x_of a + c * y_of a)%num (z_of a).

(** heidenhain.program.direction-of-rotary-axes: t = Rz(C) Ry(B) Rx(A) e. *)
Definition turned {num} {N : Numbers num} (a b c : num) (e : vec num) : direction_in_space num :=
  let t := about_z c (about_y b (about_x a e)) in Direction t t.
