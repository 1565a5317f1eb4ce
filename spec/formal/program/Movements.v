(* SPDX-License-Identifier: Apache-2.0 *)
(** The movements of blocks, before anything compensates them, and what is done with them. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ControlState State Space Pose.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Record movement (num : Type) := Movement {
  going : travel;
  because : cause;
  ends_at : values num;              (* the programmed end *)
  tip : values num;                  (* with the shift of G45 to G48 *)
  head : values num;                 (* what compensation adds to the tip *)
  length_vector : values num;        (* the length offset *)
  machine_zero : option (values num);  (* where machine coordinates are told: the work zero *)
  circle_of : option (arc num);
  at_feed : option num;
  along_tool : option (num * num * num)
}.
Arguments Movement {num}. Arguments going {num}. Arguments because {num}. Arguments ends_at {num}. Arguments tip {num}.
Arguments head {num}. Arguments length_vector {num}. Arguments machine_zero {num}. Arguments circle_of {num}.
Arguments at_feed {num}. Arguments along_tool {num}.

(** What a block yields that runs: nothing of it is an alarm. *)
Inductive item (num : Type) :=
| Go (m : movement num)
| Inside (part : Z * Z) (at_point positions : values num) (axis : num * num * num)   (* a sample *)
| Warn (name : string)
| Write (name : string) (value : num)
| Drill (h : hole num).
Arguments Go {num} m. Arguments Inside {num} part at_point positions axis. Arguments Warn {num} name. Arguments Write {num} name value.
Arguments Drill {num} h.

(** A block as it runs: by its words and what was before, without anything of blocks behind it. *)
Record planned (num : Type) := Planned {
  at_place : nat;
  command_of : command num;
  before : state num;                (* in the coordinates of the block *)
  behind : state num;
  items : list (item num)
}.
Arguments Planned {num}. Arguments at_place {num}. Arguments command_of {num}. Arguments before {num}.
Arguments behind {num}. Arguments items {num}.

(** How a run ends: with the program, or by an alarm or an open decision of a block. *)
Inductive ending := Ended | EndsInAlarm (place : nat) (number : string) | EndsUndecided (place : nat) (clause : string).

Definition ends_in {A} (place : nat) (x : outcome A) : ending :=
  match x with
  | Got _ => Ended
  | Alarm number => EndsInAlarm place number
  | Undecided clause => EndsUndecided place clause
  end.

Definition plan (num : Type) := (list (planned num) * ending)%type.

(** What a compensation makes of a plan: a plan with its heads and corner moves; or the run ends where it says, and the
    blocks before that block are those of a program that ends there. *)
Inductive passed (num : Type) :=
| Through (p : plan num)
| AsIfAbsent (from : nat) (how : ending).   (* from the block at this place on *)
Arguments Through {num} p. Arguments AsIfAbsent {num} from how.

(** With other heads, with other items. *)
Definition with_head {num} (m : movement num) (head : values num) : movement num :=
  Movement (going m) (because m) (ends_at m) (tip m) head (length_vector m) (machine_zero m) (circle_of m) (at_feed m)
    (along_tool m).
Definition with_items {num} (b : planned num) (items : list (item num)) : planned num :=
  Planned (at_place b) (command_of b) (before b) (behind b) items.
Definition at_heads {num} (head : values num) (b : planned num) : planned num :=
  with_items b (map (fun i => match i with Go m => Go (with_head m head) | i => i end) (items b)).

(** The direction of the tool as a state stands, of any length: under tool center point control the one it has come to.
    fanuc.tool-direction.given-directly: it does not matter where it comes from. *)
Definition tool_of {num} {N : Numbers num} (s : setup num) (st : state num) : triple num :=
  match in_control (control st) with
  | Some m => direction m
  | None => tool_direction s (coordinates_of st) (programmed st)
  end.
(** And at the end of a block. *)
Definition tool_behind {num} {N : Numbers num} (s : setup num) (b : planned num) : triple num := tool_of s (behind b).

(** * Events *)

Definition move_of {num} {N : Numbers num} (m : movement num) : move num :=
  let point := sum (tip m) (head m) in
  let positions := sum point (length_vector m) in
  Move (going m) (because m) (ends_at m) point positions (option_map (sum positions) (machine_zero m)) (circle_of m)
    (at_feed m) (along_tool m).

Definition event_of {num} {N : Numbers num} (i : item num) : event num :=
  match i with
  | Go m => Moves (move_of m)
  | Inside part at_point positions axis => Sampled part at_point positions axis
  | Warn name => Warned name
  | Write name value => Setting name value
  | Drill h => Drilled h
  end.

(** The events of a plan, each with the place of its block. *)
Definition events_of {num} {N : Numbers num} (p : plan num) : list (nat * event num) :=
  flat_map (fun b => map (fun i => (at_place b, event_of i)) (items b)) (fst p) ++
  match snd p with
  | EndsInAlarm place number => [(place, Raised number)]
  | EndsUndecided place clause => [(place, NotDecided clause)]
  | Ended => []
  end.

(** * Movements of a block *)

(** fanuc.program.feed: rapid moves carry none. *)
Definition feed_for {num} (t : travel) (f : option num) : option num := match t with Rapid => None | _ => f end.

(** The kind of motion of a block in G02 or G03 that runs no arc, and of one without an axis word. *)
Definition straight (t : travel) : travel := match t with Rapid => Rapid | _ => Linear end.

(** To a programmed position, as the state stands. Rotary axes take neither shift nor length offset. *)
Definition move_to {num} {N : Numbers num} (s : setup num) (t : travel) (c : cause) (machine : bool) (a : option (arc num))
    (st : state num) (length : values num) : movement num :=
  Movement t c (programmed st) (sum (programmed st) (shift st)) (zeros s) length
    (if machine then Some (work_zero s (coordinates_of st)) else None) a (feed_for t (feed st))
    (if given (in_control (control st)) then None else tool_axis_at s (coordinates_of st) (programmed st)).

(** A move that a compensation inserts, to a vector at the standing tip; the axes, the length offset and the direction of
    the tool as the state has them. *)
Definition inserted_move {num} {N : Numbers num} (s : setup num) (c : cause) (st : state num) (head : values num) :
    movement num :=
  let m := move_to s (straight (motion (modes_of st))) c false None st (vector (length_of st)) in
  let along := match in_control (control st) with
               | Some under => Some (unit3 (direction under))
               | None => along_tool m
               end in
  Movement (going m) c (ends_at m) (tip m) head (length_vector m) (machine_zero m) None (at_feed m) along.

(** fanuc.program.incremental: under G90 an axis word is the end position, under G91 the travel. *)
Definition destination {num} {N : Numbers num} (incremental : bool) (from : values num) (numbers : some_values num) :
    values num :=
  map2 (fun x number => match number with Some y => if incremental then (x + y)%num else y | None => x end) from numbers.

(** fanuc.program.machine-coordinates: G53 goes in rapid traverse to machine coordinates.
    fanuc.tool-offset.machine-position, fanuc.length-offset.position-after: the named axes lose shift and offset; their
    position is then the machine position less the work zero. *)
Definition machine_coordinates {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (st : state num) :
    state num * list (movement num) :=
  let named := which numbers in
  let position := difference (replace (zeros s) numbers) (work_zero s (coordinates_of st)) in
  let st := at_position st (on_named named position (programmed st)) (on_named named (zeros s) (shift st)) in
  (st, [move_to s Rapid Programmed true None st (vector (length_of st))]).

(** fanuc.program.reference-return: without axis words the code does nothing.
    fanuc.program.reference-number: P of G30 names reference position 2, 3 or 4; without P it is 2; another PS0046. *)
Definition reference_position {num} {N : Numbers num} (s : setup num) (code : option action) (b : block num) :
    outcome (option (values num)) :=
  let position number := Got (Some (or_else (lookup number (reference s)) (zeros s))) in
  match code with
  | Some FirstReference => position 1
  | Some OtherReference =>
      match last_word Letter.P (words b), whole_word Letter.P b with
      | None, _ => position 2
      | Some _, Some p => if among p [2; 3; 4] then position p else Alarm "reference-number"
      | Some _, None => Alarm "reference-number"
      end
  | Some FloatingReference => Got (Some (floating s))
  | _ => Got None
  end.

(** fanuc.program.reference-return: through the intermediate point to the reference position, both in rapid traverse. *)
Definition reference_return {num} {N : Numbers num} (s : setup num) (target : values num) (numbers : some_values num)
    (on_way : length_offset num) (st : state num) : state num * list (movement num) :=
  let named := which numbers in
  let between := destination (incremental (modes_of st)) (programmed st) numbers in
  let st := at_position st between (shift st) in
  let first := move_to s Rapid Reference true None st (vector on_way) in
  let position := difference target (work_zero s (coordinates_of st)) in
  let there := at_position st (on_named named position between) (on_named named (zeros s) (shift st)) in
  let second := move_to s Rapid Reference true None there (vector (length_of st)) in
  let kept := map2 (fun here x => if here : bool then Some (fst x) else snd x) named (combine between (intermediate st)) in
  (with_intermediate there kept, [first; second]).

(** fanuc.program.return-from-reference: through the intermediate point of the last reference return to the commanded
    point, both in rapid traverse.
    fanuc.program.return-incremental: under G91 the words count from the intermediate point.
    fanuc.program.return-without-intermediate: an axis without one uses its current position as one. *)
Definition return_from_reference {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (st : state num) :
    state num * list (movement num) :=
  let named := which numbers in
  let between := on_named named (replace (programmed st) (intermediate st)) (programmed st) in
  let st := at_position st between (shift st) in
  let first := move_to s Rapid Programmed false None st (vector (length_of st)) in
  let st := at_position st (destination (incremental (modes_of st)) between numbers) (shift st) in
  (st, [first; move_to s Rapid Programmed false None st (vector (length_of st))]).
