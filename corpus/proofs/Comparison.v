(* SPDX-License-Identifier: Apache-2.0 *)
(** What is written down of a run, beside the run: the same words in the same places, and numbers in pairs. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Data Case.
Import ListNotations.
Open Scope Z_scope.
Open Scope list_scope.

(** A tree as a row of marks. *)
Inductive mark (num : Type) := Opens | Closes | SaidWhole (i : Z) | SaidText (s : string) | Numbered (x : num).
Arguments Opens {num}. Arguments Closes {num}. Arguments SaidWhole {num} i. Arguments SaidText {num} s.
Arguments Numbered {num} x.

Fixpoint marks {num} (t : told num) : list (mark num) :=
  match t with
  | Number x => [Numbered x]
  | Says i => [SaidWhole i]
  | Names s => [SaidText s]
  | Several parts => Opens :: flat_map marks parts ++ [Closes]
  end.

(** A number as it is written: a fraction, or a decimal with how far it may be off. *)
Inductive written := Fraction (over under : Z) | Within (digits decimals off off_decimals : Z).

(** What is written of each number, and the number; none where the two are not of one form. *)
Fixpoint compared {num} (row : list (mark written)) (said : list (mark num)) : option (list (written * num)) :=
  match row, said with
  | [], [] => Some []
  | w :: row, s :: said =>
      match w, s, compared row said with
      | Opens, Opens, Some rest | Closes, Closes, Some rest => Some rest
      | SaidWhole i, SaidWhole j, Some rest => if i =? j then Some rest else None
      | SaidText t, SaidText u, Some rest => if String.eqb t u then Some rest else None
      | Numbered w, Numbered x, Some rest => Some ((w, x) :: rest)
      | _, _, _ => None
      end
  | _, _ => None
  end.

Definition compared_run {num} {N : Numbers num} (case : data) (row : list (mark written)) : option (list (written * num)) :=
  compared row (marks (run_case case)).
