(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-side-compensation: what is in force behind a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** G41.2 and G41.6, G42.2 and G42.6. *)
Inductive hand_of_tool := ToolLeft | ToolRight.

(** A start, as long as the blocks behind it may not change the side. *)
Record side_start (num : Type) := SideStart {
  start_axis : num * num * num;    (* the tool direction at its end *)
  starts_left : bool;
  awaits_first : bool;             (* no block has moved since *)
  may_follow : Z                   (* how many of the next blocks can be B of the start *)
}.
Arguments SideStart {num}. Arguments start_axis {num}. Arguments starts_left {num}. Arguments awaits_first {num}.
Arguments may_follow {num}.

Record side_state (num : Type) := SideState {
  side_in_force : option hand_of_tool;       (* none: G40 *)
  side_number : Z;
  side_value : num;                       (* the value in force *)
  asked : bool;                           (* a code with a number other than 0 *)
  made : bool;                            (* a vector has been made and is not removed yet *)
  made_zero : bool;                       (* and it is exactly zero *)
  crosses : bool;                         (* the block moves in the plane at its own end *)
  on_left : bool;                         (* where the tool is, code and value together *)
  since_start : option (side_start num)
}.
Arguments SideState {num}. Arguments side_in_force {num}. Arguments side_number {num}. Arguments side_value {num}.
Arguments asked {num}. Arguments made {num}. Arguments made_zero {num}. Arguments crosses {num}. Arguments on_left {num}.
Arguments since_start {num}.

(** fanuc.tool-side.initial-state: cancel mode with the vector zero. *)
Definition initial_side {num} {N : Numbers num} (s : setup num) : side_state num :=
  SideState None 0 0%num false false false false true None.
