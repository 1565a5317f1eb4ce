(* SPDX-License-Identifier: Apache-2.0 *)
(** What a step of a program comes to, and what a run yields (docs/events.md). *)
From Coq Require Import List String ZArith.
From Toolcomp Require Import Numbers.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** A result, an alarm by its number, or a decision by its clause that could not be made. *)
Inductive outcome (A : Type) :=
| Got (a : A)
| Alarm (number : string)
| Undecided (clause : string).
Arguments Got {A} a.
Arguments Alarm {A} number.
Arguments Undecided {A} clause.

Definition bind {A B} (x : outcome A) (f : A -> outcome B) : outcome B :=
  match x with
  | Got a => f a
  | Alarm number => Alarm number
  | Undecided clause => Undecided clause
  end.
Notation "x <- a ;; b" := (bind a (fun x => b)) (at level 61, a at next level, right associativity).
Notation "' p <- a ;; b" := (bind a (fun x => let p := x in b))
  (at level 61, p pattern, a at next level, right associativity).

(** Where the condition holds. *)
Definition alarm_if (condition : bool) (number : string) : outcome unit :=
  if condition then Alarm number else Got tt.

(** The sign that a clause asks for. *)
Definition decide {num} {N : Numbers num} (clause : string) (x : num) : outcome comparison :=
  match sign x with
  | Some c => Got c
  | None => Undecided clause
  end.
Definition is_zero {num} {N : Numbers num} (clause : string) (x : num) : outcome bool :=
  c <- decide clause x ;; Got (match c with Eq => true | _ => false end).
Definition is_negative {num} {N : Numbers num} (clause : string) (x : num) : outcome bool :=
  c <- decide clause x ;; Got (match c with Lt => true | _ => false end).
Definition is_positive {num} {N : Numbers num} (clause : string) (x : num) : outcome bool :=
  c <- decide clause x ;; Got (match c with Gt => true | _ => false end).

(** Of every element in turn. *)
Fixpoint each {A B} (f : A -> outcome B) (list : list A) : outcome (List.list B) :=
  match list with
  | [] => Got []
  | a :: rest => b <- f a ;; bs <- each f rest ;; Got (b :: bs)
  end.

(** One number for each controlled axis, in the order of the setup. *)
Definition values (num : Type) := list num.
(** The same for some of them. *)
Definition some_values (num : Type) := list (option num).

Inductive plane := XY | ZX | YZ.
Inductive travel := Rapid | Linear | Clockwise | Counterclockwise.
Inductive cause := Programmed | StartUp | Cancelling | Corner | PreTurn | PostTurn | Reference | Measuring.

Record arc (num : Type) := Arc {
  center : num * num;                  (* in the plane *)
  arc_plane : plane;
  sweep : option num;                  (* degrees *)
  radii : option (num * num)           (* at start and end, where they differ *)
}.
Arguments Arc {num}. Arguments center {num}. Arguments arc_plane {num}. Arguments sweep {num}. Arguments radii {num}.

Record move (num : Type) := Move {
  travel_of : travel;
  cause_of : cause;
  programmed_end : values num;
  tool_point : values num;             (* before the length offset *)
  axis_positions : values num;
  machine_positions : option (values num);
  arc_of : option (arc num);
  feed_of : option num;
  tool_axis : option (num * num * num)  (* from the tip to the holder, of length 1; where there is one *)
}.
Arguments Move {num}. Arguments travel_of {num}. Arguments cause_of {num}. Arguments programmed_end {num}.
Arguments tool_point {num}. Arguments axis_positions {num}. Arguments machine_positions {num}. Arguments arc_of {num}.
Arguments feed_of {num}. Arguments tool_axis {num}.

(** What a canned cycle drills. *)
Record hole (num : Type) := Hole {
  drilled_along : nat;                 (* the place of the drilling axis *)
  hole_point : values num;             (* before the length offset, the drilling axis at the level of the return *)
  point_r_level : num;                 (* along the drilling axis, before the length offset *)
  bottom_level : num;
  return_level : num;
  positions_behind : values num        (* what the axes stand at behind the hole *)
}.
Arguments Hole {num}. Arguments drilled_along {num}. Arguments hole_point {num}. Arguments point_r_level {num}.
Arguments bottom_level {num}. Arguments return_level {num}. Arguments positions_behind {num}.

Inductive event (num : Type) :=
| Moves (m : move num)
| Sampled (part : Z * Z) (at_point positions : values num) (axis : num * num * num)   (* inside a block *)
| Setting (name : string) (value : num)
| Warned (name : string)
| Raised (number : string)
| NotDecided (clause : string)
| Drilled (h : hole num).
Arguments Moves {num} m.
Arguments Sampled {num} part at_point positions axis.
Arguments Setting {num} name value.
Arguments Warned {num} name.
Arguments Raised {num} number.
Arguments NotDecided {num} clause.
Arguments Drilled {num} h.

(** By place. *)
Fixpoint map2 {A B C} (f : A -> B -> C) (xs : list A) (ys : list B) : list C :=
  match xs, ys with
  | x :: xs, y :: ys => f x y :: map2 f xs ys
  | _, _ => []
  end.
Definition given {A} (x : option A) : bool := match x with Some _ => true | None => false end.
Definition or_else {A} (x : option A) (otherwise : A) : A := match x with Some a => a | None => otherwise end.
(** The new value where there is one. *)
Definition replace {A} (olds : list A) (news : list (option A)) : list A := map2 (fun old new => or_else new old) olds news.
Definition sum {num} {N : Numbers num} : values num -> values num -> values num := map2 plus.
Definition difference {num} {N : Numbers num} : values num -> values num -> values num := map2 minus.
