(* SPDX-License-Identifier: Apache-2.0 *)
(** Cutter compensation: what the words of a block do to it, and their alarms. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory LengthOffset CutterState State Movements.
From Toolcomp Require Import CutterRules CutterB CutterModes.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** fanuc.cutter.kind: the setup decides between B and C.
    fanuc.cutter.order-of-alarms: the alarms that the words and the state before the block raise. *)
Definition cutter_alarms {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  _ <- shared_alarms s c st ;;
  _ <- (if cutter_b s then alarms_b s c st else alarms_c s c st) ;;
  value_alarm s c st.

(** What is in force behind a block that has come from `before` to `after` by its moves. *)
Definition cutter_behind {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num)
    (moves : list (movement num)) : outcome (cutter_state num) :=
  if cutter_b s then behind_b s c before after moves else behind_c s c before after moves.
