(* SPDX-License-Identifier: Apache-2.0 *)
(** Positions of rotary axes: numbers of degrees whose sines, cosines and whole turns are known exactly.

    The degrees of an angle between directions are an arctangent, of which no equality is ever proven; its sine and cosine
    are made of roots alone, and decisions are made by them. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Record angle (num : Type) := Angle {
  degrees : num;
  cosine_of : num;
  sine_of : num;
  turns : option Z       (* degrees less 360 of them are from 0 up to, not with, 360; none: by the number, a rational one *)
}.
Arguments Angle {num}. Arguments degrees {num}. Arguments cosine_of {num}. Arguments sine_of {num}. Arguments turns {num}.

Definition angle_of_degrees {num} {N : Numbers num} (x : num) : angle num := Angle x (cosine x) (sine x) None.

(** The angle of a vector of length 1, from the first axis toward the second, from 0 up to 360 degrees. *)
Definition angle_of_unit {num} {N : Numbers num} (clause : string) (c s : num) : outcome (angle num) :=
  side <- decide clause s ;;
  ahead <- decide clause c ;;
  let half : num := integer 180 in
  Got
    match side, ahead with
    | Eq, Lt => Angle half (0 - 1)%num 0%num (Some 0)
    | Eq, _ => Angle 0%num 1%num 0%num (Some 0)
    | Gt, Eq => Angle (integer 90) 0%num 1%num (Some 0)
    | Lt, Eq => Angle (integer 270) 0%num (0 - 1)%num (Some 0)
    | Gt, Gt => Angle (arctangent (s / c)%num) c s (Some 0)
    | Gt, Lt | Lt, Lt => Angle (half + arctangent (s / c))%num c s (Some 0)
    | Lt, Gt => Angle (integer 360 + arctangent (s / c))%num c s (Some 0)
    end.

(** * Whole turns *)

(** Turns that are tried, each twice the one before: more than fifteen digits of degrees have. *)
Fixpoint doubled (count : nat) (first : Z) : list Z :=
  match count with O => [] | S fewer => first :: doubled fewer (2 * first) end.
Definition powers_of_two : list Z := doubled 44 1.

(** How many of them a number from 0 on has, and what is left. *)
Fixpoint counted {num} {N : Numbers num} (clause : string) (tried : list Z) (x : num) : outcome (Z * num) :=
  match tried with
  | [] => Got (0, x)
  | count :: more =>
      let without y := (y - integer 360 * integer count)%num in
      fewer <- is_negative clause (without x) ;;
      if fewer : bool then Got (0, x)
      else
        '(found, rest) <- counted clause more x ;;
        fewer <- is_negative clause (without rest) ;;
        Got (if fewer : bool then (found, rest) else (found + count, without rest))
  end.

(** The whole turns of a number of degrees: what is left is from 0 up to 360. *)
Definition whole_turns {num} {N : Numbers num} (clause : string) (x : num) : outcome Z :=
  below <- is_negative clause x ;;
  if below : bool then
    '(count, rest) <- counted clause powers_of_two (- x)%num ;;
    even <- is_zero clause rest ;;
    Got (if even : bool then - count else - count - 1)
  else
    '(count, _) <- counted clause powers_of_two x ;;
    Got count.

Definition turns_of {num} {N : Numbers num} (clause : string) (a : angle num) : outcome Z :=
  match turns a with Some count => Got count | None => whole_turns clause (degrees a) end.

(** With its turns told. *)
Definition with_turns {num} {N : Numbers num} (clause : string) (a : angle num) : outcome (angle num) :=
  count <- turns_of clause a ;; Got (Angle (degrees a) (cosine_of a) (sine_of a) (Some count)).

(** By whole turns farther. *)
Definition turned_on {num} {N : Numbers num} (count : Z) (a : angle num) : angle num :=
  if count =? 0 then a
  else Angle (degrees a + integer 360 * integer count)%num (cosine_of a) (sine_of a)
         (option_map (Z.add count) (turns a)).

(** * Comparison *)

(** Whether what is left of whole turns is less than a half turn. *)
Definition in_first_half {num} {N : Numbers num} (clause : string) (a : angle num) : outcome bool :=
  side <- decide clause (sine_of a) ;;
  match side with Gt => Got true | Lt => Got false | Eq => is_positive clause (cosine_of a) end.

Definition sine_between {num} {N : Numbers num} (a b : angle num) : num :=
  (sine_of a * cosine_of b - sine_of b * cosine_of a)%num.
Definition cosine_between {num} {N : Numbers num} (a b : angle num) : num :=
  (cosine_of a * cosine_of b + sine_of a * sine_of b)%num.

(** What is left of whole turns, compared. *)
Definition compare_rest {num} {N : Numbers num} (clause : string) (a b : angle num) : outcome comparison :=
  a_first <- in_first_half clause a ;;
  b_first <- in_first_half clause b ;;
  match a_first, b_first with
  | true, false => Got Lt
  | false, true => Got Gt
  | _, _ => decide clause (sine_between a b)
  end.

Definition compare_angles {num} {N : Numbers num} (clause : string) (a b : angle num) : outcome comparison :=
  a_turns <- turns_of clause a ;;
  b_turns <- turns_of clause b ;;
  match Z.compare a_turns b_turns with Eq => compare_rest clause a b | c => Got c end.

(** * Sums *)

Definition angle_between_positions {num} {N : Numbers num} (clause : string) (a b : angle num) : outcome (angle num) :=
  a_turns <- turns_of clause a ;;
  b_turns <- turns_of clause b ;;
  rest <- compare_rest clause a b ;;
  let borrowed := match rest with Lt => 1 | _ => 0 end in
  Got (Angle (degrees a - degrees b)%num (cosine_between a b) (sine_between a b) (Some (a_turns - b_turns - borrowed))).

(** Whole turns of it are found where they are asked for. *)
Definition angle_negated {num} {N : Numbers num} (clause : string) (a : angle num) : outcome (angle num) :=
  angle_between_positions clause (Angle 0%num 1%num 0%num (Some 0)) a.
Definition angle_sum {num} {N : Numbers num} (clause : string) (a b : angle num) : outcome (angle num) :=
  less <- angle_negated clause b ;; angle_between_positions clause a less.
