(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/leading-edge-offset: what is in force behind a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Record edge_state (num : Type) := EdgeState {
  leads : bool;              (* the mode of G41.3 is on *)
  leading_number : Z         (* of the last D *)
}.
Arguments EdgeState {num}. Arguments leads {num}. Arguments leading_number {num}.

Definition initial_edge {num} {N : Numbers num} (s : setup num) : edge_state num := EdgeState false 0.
