(** Tool side compensation: what is in force behind a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Definition side_state (num : Type) := unit.
Definition initial_side {num} {N : Numbers num} (s : setup num) : side_state num := tt.
