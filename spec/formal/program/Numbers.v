(* SPDX-License-Identifier: Apache-2.0 *)
(** The numbers a program computes with: whatever has these operations. Coq's reals do, for theorems; exact numbers whose
    signs are certified do, for running. *)
From Coq Require Import ZArith Reals.

Class Numbers (num : Type) := {
  integer : Z -> num;
  plus : num -> num -> num;
  minus : num -> num -> num;
  times : num -> num -> num;
  over : num -> num -> num;           (* by what is not 0 *)
  root : num -> num;                  (* of what is not negative *)
  sine : num -> num;                  (* of degrees *)
  cosine : num -> num;                (* of degrees *)
  arctangent : num -> num;            (* in degrees, between -90 and 90 *)
  half_turn : num;                    (* 180 degrees as the length of an arc of radius 1 *)
  sign : num -> option comparison     (* compared with 0; None where it cannot be decided *)
}.

Declare Scope num_scope.
Delimit Scope num_scope with num.
Infix "+" := plus : num_scope.
Infix "-" := minus : num_scope.
Infix "*" := times : num_scope.
Infix "/" := over : num_scope.
Notation "0" := (integer 0) : num_scope.
Notation "1" := (integer 1) : num_scope.
Notation "- x" := (minus (integer 0) x) : num_scope.

(** Every sign of a real number is known. *)
Definition real_sign (x : R) : option comparison :=
  Some (match total_order_T x 0 with
        | inleft (left _) => Lt
        | inleft (right _) => Eq
        | inright _ => Gt
        end).

#[global] Instance reals : Numbers R := {
  integer := IZR;
  plus := Rplus;
  minus := Rminus;
  times := Rmult;
  over := Rdiv;
  root := sqrt;
  sine x := sin (x * PI / 180)%R;
  cosine x := cos (x * PI / 180)%R;
  arctangent x := (atan x * 180 / PI)%R;
  half_turn := PI;
  sign := real_sign
}.
