(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool center point control: what is in force behind a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Angles.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** G43.4: the rotary axes are commanded; G43.5: the direction of the tool. *)
Inductive control_type := ByAxes | ByVector.

(** A direction of any length in the programming system, and the same as the work-side axis has it, turned back by what
    carries that axis: there decisions about singular directions are exact. *)
Record directed (num : Type) := Directed { as_programmed : num * num * num; under_work_side : num * num * num }.
Arguments Directed {num}. Arguments as_programmed {num}. Arguments under_work_side {num}.

(** What the block of G43.4 or G43.5 has chosen, and what holds until the next block. *)
Record control_mode (num : Type) := ControlMode {
  control_by : control_type;
  posture_control : bool;              (* P1 *)
  lean_angle : num;                    (* Q of G43.5 *)
  in_workpiece_system : bool;          (* 19696#5 *)
  frozen_pose : angle num * angle num;
  tool_length : num;                   (* along the tool *)
  kept_direction : directed num;       (* the one last commanded, without its lean *)
  pointing : directed num              (* the one of the tool *)
}.
Arguments ControlMode {num}. Arguments control_by {num}. Arguments posture_control {num}. Arguments lean_angle {num}.
Arguments in_workpiece_system {num}. Arguments frozen_pose {num}. Arguments tool_length {num}.
Arguments kept_direction {num}. Arguments pointing {num}.

(** A great circle that the rotary axes follow: its directions in the zero frame of the table, and the positions on the
    tool and the work side at its start, or at its end where its start is singular. *)
Record great_circle (num : Type) := GreatCircle {
  circle_from : num * num * num;
  circle_to : num * num * num;
  anchor : angle num * angle num;
  anchored_at_end : bool;
  above_at_anchor : bool;              (* the branch there *)
  crosses_singular : option bool;      (* a singular direction inside, whether it is -u_w *)
  on_meridian : bool                   (* in a plane with u_w *)
}.
Arguments GreatCircle {num}. Arguments circle_from {num}. Arguments circle_to {num}. Arguments anchor {num}.
Arguments anchored_at_end {num}. Arguments above_at_anchor {num}. Arguments crosses_singular {num}. Arguments on_meridian {num}.

(** How the rotary axes run in a block. *)
Inductive rotary_way (num : Type) :=
| Evenly                                        (* each from its start to its end *)
| OnGreatCircle (c : great_circle num)
| DirectionAlone (from to : num * num * num).   (* without rotary axes: on the great circle *)
Arguments Evenly {num}.
Arguments OnGreatCircle {num} c.
Arguments DirectionAlone {num} from to.

(** The poses of a block under control. *)
Record rotary_run (num : Type) := RotaryRun {
  pose_before : angle num * angle num;
  pose_at_start : angle num * angle num;     (* behind the turn at a singular start *)
  pose_at_end : angle num * angle num;       (* before the turn at a singular end *)
  pose_behind : angle num * angle num;
  turns_before : bool;
  turns_behind : bool;
  way : rotary_way num;
  off_the_branch : bool                      (* the warning posture-branch *)
}.
Arguments RotaryRun {num}. Arguments pose_before {num}. Arguments pose_at_start {num}. Arguments pose_at_end {num}.
Arguments pose_behind {num}. Arguments turns_before {num}. Arguments turns_behind {num}. Arguments way {num}. Arguments off_the_branch {num}.

Record control_state (num : Type) := ControlState {
  in_control : option (control_mode num);    (* none: G49, G43 or G44 *)
  stands_at : option (angle num * angle num);  (* the pose, where control has turned to it *)
  stands_along : option (num * num * num);   (* the direction of a head at that pose *)
  run_of_block : option (rotary_run num)     (* of a block under control that moves, behind that of the code *)
}.
Arguments ControlState {num}. Arguments in_control {num}. Arguments stands_at {num}. Arguments stands_along {num}. Arguments run_of_block {num}.

Definition direction {num} (m : control_mode num) : num * num * num := as_programmed (pointing m).

Definition initial_control {num} {N : Numbers num} (s : setup num) : control_state num := ControlState None None None None.
