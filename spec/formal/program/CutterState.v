(* SPDX-License-Identifier: Apache-2.0 *)
(** Cutter compensation: what is in force behind a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Arcs Corners.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** G41 and G42. *)
Inductive hand := LeftHand | RightHand.

(** Where the mode stands. B knows the first two: whether a vector has been made. *)
Inductive phase :=
| Off
| Running
| Pending (count : Z)    (* G41 or G42 of type C waits for the next moving block, with so many blocks between *)
| Started                (* no block has moved since the start-up *)
| TakenAway              (* the mode goes on, G52, G92, G53 or a reference return has taken the vector away *)
| Ending.                (* a lone G40 or number 0: the vector waits for its removal *)

(** What a block is to cutter compensation C. *)
Inductive part :=
| Idle (count : Z)       (* it does not move in the plane *)
| LoneStart              (* it may make the vector without motion *)
| LoneCancel
| StartUpBlock
| ModeBlock              (* a moving block of the offset mode *)
| CancelBlock
| MovesFree              (* a moving block without compensation *)
| CornerBlock            (* G39 *)
| ShiftsPlane            (* G52 or G92 of the plane, before which the vector is taken away *)
| GoesAway               (* G53, a reference return or G29 that goes somewhere *)
| WayBlock.              (* a reference return whose way to the intermediate point is a block of the mode *)

Record cutter_state (num : Type) := CutterState {
  hand_in_force : option hand;     (* none: G40 *)
  value_in_force : num;
  in_phase : phase;
  vector_behind : pair num;        (* where no corner follows *)
  reach : num;                     (* the offset, without sign, at the end of the last block that moved *)
  was_left : bool;                 (* and its side *)
  plays : part
}.
Arguments CutterState {num}. Arguments hand_in_force {num}. Arguments value_in_force {num}. Arguments in_phase {num}.
Arguments vector_behind {num}. Arguments reach {num}. Arguments was_left {num}. Arguments plays {num}.

Definition initial_cutter {num} {N : Numbers num} (s : setup num) : cutter_state num :=
  CutterState None 0%num Off zero2 0%num true (Idle 1).
