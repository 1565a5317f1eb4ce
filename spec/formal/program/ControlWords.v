(** Tool center point control: what the words of a block do to it, and their alarms. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory LengthOffset ControlState State Movements.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** The alarms that the words and the state before the block raise. *)
Definition control_alarms {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  Got tt.

(** What is in force behind a block that has come from `before` to `after`. *)
Definition control_behind {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num) :
    outcome (control_state num) :=
  Got (control after).
