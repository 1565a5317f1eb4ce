(* SPDX-License-Identifier: Apache-2.0 *)
(** Setups, programs and what runs say as trees of whole numbers, texts and numbers: what whoever reads texts hands over,
    and gets back. Nothing here knows what a program means. *)
From Coq Require Import List String Ascii ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space.
From Toolcomp Require State.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Inductive data := Whole (i : Z) | Text (s : string) | Tree (entries : list data).

(** What is of another form reads as nothing. *)
Definition entries (d : data) : list data := match d with Tree l => l | _ => [] end.
Definition whole_of (d : data) : Z := match d with Whole i => i | _ => 0 end.
Definition text_of (d : data) : string := match d with Text s => s | _ => "" end.
Definition flag_of (d : data) : bool := whole_of d =? 1.
Definition entry_at (d : data) (place : nat) : data := nth place (entries d) (Tree []).

Definition letters_in_order := [Letter.A; Letter.B; Letter.C; Letter.D; Letter.E; Letter.F; Letter.G; Letter.H; Letter.I; Letter.J; Letter.K; Letter.L; Letter.M; Letter.N; Letter.O; Letter.P; Letter.Q; Letter.R; Letter.S; Letter.T; Letter.U; Letter.V; Letter.W; Letter.X; Letter.Y; Letter.Z].
Definition letter_of (d : data) : Letter.t := nth (Z.to_nat (whole_of d)) letters_in_order Letter.A.

(** A decimal: its digits, how many of them stand behind the point. *)
Definition number_of_data {num} {N : Numbers num} (d : data) : num :=
  (integer (whole_of (entry_at d 0)) / integer (10 ^ whole_of (entry_at d 1)))%num.

(** Ten times a decimal, where that is a natural number of few digits. *)
Definition tenths_of (d : data) : option Z :=
  let digits := 10 * whole_of (entry_at d 0) in
  let scale := 10 ^ whole_of (entry_at d 1) in
  if (digits mod scale =? 0) && (0 <=? digits) && (digits / scale <=? 99999999) then Some (digits / scale) else None.

Definition values_of {num} {N : Numbers num} (d : data) : values num := map number_of_data (entries d).
Definition table_of {A} (value : data -> A) (d : data) : list (Z * A) :=
  map (fun row => (whole_of (entry_at row 0), value row)) (entries d).
Fixpoint named {A} (value : data -> A) (rows : list data) (name : string) : option A :=
  match rows with
  | [] => None
  | row :: rest => if String.eqb (text_of (entry_at row 0)) name then Some (value (entry_at row 1)) else named value rest name
  end.
(** The same of rows whose values are made once. *)
Fixpoint found {A} (rows : list (string * A)) (name : string) : option A :=
  match rows with
  | [] => None
  | (of_row, a) :: rest => if String.eqb of_row name then Some a else found rest name
  end.
Definition made {A} (value : data -> A) (rows : list data) : list (string * A) :=
  map (fun row => (text_of (entry_at row 0), value (entry_at row 1))) rows.
Definition maybe_of {A} (value : data -> A) (d : data) : option A :=
  match entries d with [] => None | x :: _ => Some (value x) end.
Definition vector_of {num} {N : Numbers num} (d : data) : triple num :=
  (number_of_data (entry_at d 0), number_of_data (entry_at d 1), number_of_data (entry_at d 2)).
(** The one of these at its place. *)
Definition one_of {A} (things : list A) (otherwise : A) (d : data) : A := nth (Z.to_nat (whole_of d)) things otherwise.

(** * What a run says, as a tree *)

Inductive told (num : Type) := Number (x : num) | Says (i : Z) | Names (s : string) | Several (parts : list (told num)).
Arguments Number {num} x. Arguments Says {num} i. Arguments Names {num} s. Arguments Several {num} parts.

Definition tell_values {num} (v : values num) : told num := Several (map Number v).
Definition tell_maybe {A num} (tell : A -> told num) (x : option A) : told num :=
  Several match x with Some a => [tell a] | None => [] end.

(** Of the linear axes alone. *)
Definition tell_linear {num} (letters : list Letter.t) (v : values num) : told num :=
  tell_values (map snd (filter (fun row => Letter.linear (fst row)) (combine letters v))).
Definition tell_vector {num} (v : triple num) : told num := let '(x, y, z) := v in tell_values [x; y; z].
Definition tell_flag {num} (b : bool) : told num := Says (if b then 1 else 0).

(** Its position is told of the linear axes but the drilling axis; `positions` is what the axes stand at behind it. *)
Definition tell_hole {num} (letters : list Letter.t) (positions : told num) (h : hole num) : list (told num) :=
  let beside row := Letter.linear (fst row) && negb (Nat.eqb (State.place (fst row) letters) (drilled_along h)) in
  [tell_values (map snd (filter beside (combine letters (hole_point h))));
   Number (point_r_level h); Number (bottom_level h); Number (return_level h); positions;
   Says (Z.of_nat (drilled_along h))].
