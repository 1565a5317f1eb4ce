(** Tool center point control: what is in force behind a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Definition control_state (num : Type) := unit.
Definition initial_control {num} {N : Numbers num} (s : setup num) : control_state num := tt.
