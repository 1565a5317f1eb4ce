(* SPDX-License-Identifier: Apache-2.0 *)
(** What a program has come to behind a block, and what a block says. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ToolShift.
From Toolcomp Require Import CutterState SideState EdgeState ControlState CycleState.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Record state (num : Type) := State {
  modes_of : modes;
  feed : option num;
  coordinates_of : coordinates num;
  programmed : values num;               (* the programmed position, workpiece coordinates *)
  shift : values num;                    (* G45 to G48: actual less programmed position *)
  length_of : length_offset num;
  shared : shared_number;
  offsets_of : offsets num;
  intermediate : some_values num;        (* of the last reference return *)
  cutter : cutter_state num;             (* cutter compensation *)
  side : side_state num;                 (* tool side compensation *)
  edge : edge_state num;                 (* leading edge offset *)
  control : control_state num;           (* tool center point control *)
  cycle : cycle_state num                (* canned cycles *)
}.
Arguments State {num}. Arguments modes_of {num}. Arguments feed {num}. Arguments coordinates_of {num}.
Arguments programmed {num}. Arguments shift {num}. Arguments length_of {num}. Arguments shared {num}.
Arguments offsets_of {num}. Arguments intermediate {num}. Arguments cutter {num}. Arguments side {num}.
Arguments edge {num}. Arguments control {num}. Arguments cycle {num}.

(** fanuc.program.initial-state: G00 G17 G90 G94 G40 G49 G54 G80 G98, at the position of the setup, with H0 and D0,
    without F. *)
(** fanuc.program.feed: 1411 is the F at power-on unless it is 0. *)
Definition initial_feed {num} (s : setup num) : option num :=
  match whole_parameter s "1411" with Some 0 => None | _ => parameter s "1411" end.

Definition initial {num} {N : Numbers num} (s : setup num) : state num :=
  State (initial_modes (inches s)) (initial_feed s) (given_coordinates s) (start s) (zeros s) (no_length_offset s) (ByD, 0)
    (given_offsets s) (map (fun _ => None) (axes s)) (initial_cutter s) (initial_side s) (initial_edge s)
    (initial_control s) initial_cycle.

(** With one of them another. *)
Definition at_position {num} (st : state num) (position shift : values num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) position shift (length_of st) (shared st) (offsets_of st)
    (intermediate st) (cutter st) (side st) (edge st) (control st) (cycle st).
Definition with_length {num} (st : state num) (x : length_offset num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) x (shared st) (offsets_of st)
    (intermediate st) (cutter st) (side st) (edge st) (control st) (cycle st).
Definition with_offsets {num} (st : state num) (x : offsets num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) (length_of st) (shared st) x
    (intermediate st) (cutter st) (side st) (edge st) (control st) (cycle st).
Definition with_intermediate {num} (st : state num) (x : some_values num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) (length_of st) (shared st)
    (offsets_of st) x (cutter st) (side st) (edge st) (control st) (cycle st).
Definition with_cutter {num} (st : state num) (x : cutter_state num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) (length_of st) (shared st)
    (offsets_of st) (intermediate st) x (side st) (edge st) (control st) (cycle st).
Definition with_side {num} (st : state num) (x : side_state num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) (length_of st) (shared st)
    (offsets_of st) (intermediate st) (cutter st) x (edge st) (control st) (cycle st).
Definition with_edge {num} (st : state num) (x : edge_state num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) (length_of st) (shared st)
    (offsets_of st) (intermediate st) (cutter st) (side st) x (control st) (cycle st).
Definition with_control {num} (st : state num) (x : control_state num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) (length_of st) (shared st)
    (offsets_of st) (intermediate st) (cutter st) (side st) (edge st) x (cycle st).
Definition in_coordinates {num} (st : state num) (x : coordinates num) : state num :=
  State (modes_of st) (feed st) x (programmed st) (shift st) (length_of st) (shared st) (offsets_of st)
    (intermediate st) (cutter st) (side st) (edge st) (control st) (cycle st).
Definition with_cycle {num} (st : state num) (x : cycle_state num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) (length_of st) (shared st)
    (offsets_of st) (intermediate st) (cutter st) (side st) (edge st) (control st) x.

(** What a block says. *)
Record command (num : Type) := Command {
  block_of : block num;
  codes_said : list Z;
  acting : option action;            (* that acts in this block alone *)
  in_modes : modes;                  (* with the codes of the block *)
  h_number : option Z;
  d_number : option Z;
  axis_words : some_values num;      (* of the axis words *)
  position_words : some_values num;  (* those that are positions *)
  naming_words : some_values num     (* those that name axes *)
}.
Arguments Command {num}. Arguments block_of {num}. Arguments codes_said {num}. Arguments acting {num}. Arguments in_modes {num}.
Arguments h_number {num}. Arguments d_number {num}. Arguments axis_words {num}. Arguments position_words {num}.
Arguments naming_words {num}.

Definition which {A} (numbers : list (option A)) : axis_set := map given numbers.

(** * Axes *)

(** The value of the first axis named. *)
Fixpoint find_named {A} (named : axis_set) (v : list A) : option A :=
  match named, v with
  | true :: _, x :: _ => Some x
  | false :: named, _ :: v => find_named named v
  | _, _ => None
  end.

(** The values of the named axes, of the others those before. *)
Definition on_named {num} (named : axis_set) (new old : values num) : values num :=
  map2 (fun here x => if here : bool then fst x else snd x) named (combine new old).

(** The place of an axis; the machine has X, Y and Z. *)
Fixpoint place (letter : Letter.t) (letters : list Letter.t) : nat :=
  match letters with
  | [] => 0%nat
  | first :: rest => if Letter.eqb first letter then 0%nat else S (place letter rest)
  end.
Definition value_on {num} {N : Numbers num} (s : setup num) (v : values num) (letter : Letter.t) : num :=
  nth (place letter (axes s)) v 0%num.
Definition in_plane_of {num} {N : Numbers num} (s : setup num) (p : plane) (v : values num) : pair num :=
  let '(first, second) := plane_axes p in (value_on s v first, value_on s v second).
Definition with_value {num} (s : setup num) (v : values num) (letter : Letter.t) (x : num) : values num :=
  on_named (the_axis s letter) (map (fun _ => x) v) v.
Definition with_plane {num} (s : setup num) (p : plane) (v : values num) (x : pair num) : values num :=
  let '(first, second) := plane_axes p in with_value s (with_value s v first (fst x)) second (snd x).
