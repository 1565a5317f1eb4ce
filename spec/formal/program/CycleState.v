(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/canned-cycle: what is in force behind a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** A level along the drilling axis as it was given: under G90, under G91. *)
Inductive level (num : Type) := Coordinate (x : num) | Distance (x : num).
Arguments Coordinate {num} x. Arguments Distance {num} x.

(** What the drilling mode keeps; the data are none where none have been given since it began. *)
Record drilling_mode (num : Type) := DrillingMode {
  cycle_code : Z;
  drilling_axis : Letter.t;
  rise : num;                          (* the initial level less the programmed position of that axis *)
  point_r : option (level num);        (* a distance from the initial level *)
  bottom : option (level num);         (* a distance from point R *)
  depth_of_cut : option num            (* Q *)
}.
Arguments DrillingMode {num}. Arguments cycle_code {num}. Arguments drilling_axis {num}. Arguments rise {num}.
Arguments point_r {num}. Arguments bottom {num}. Arguments depth_of_cut {num}.

Record cycle_state (num : Type) := CycleState {
  drilling : option (drilling_mode num);    (* none: G80 *)
  to_point_r : bool                         (* G99; else G98 *)
}.
Arguments CycleState {num}. Arguments drilling {num}. Arguments to_point_r {num}.

(** fanuc.program.initial-state: G80, G98. *)
Definition initial_cycle {num} : cycle_state num := CycleState None false.
