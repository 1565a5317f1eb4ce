(** The leading edge offset: what is in force behind a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Definition edge_state (num : Type) := unit.
Definition initial_edge {num} {N : Numbers num} (s : setup num) : edge_state num := tt.
