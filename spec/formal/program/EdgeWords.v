(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/leading-edge-offset: what the words of a block do to the leading edge offset, and their alarms. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory LengthOffset EdgeState State Movements ControlWords.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** fanuc.leading-edge.number-changed: the number of the last D, this block included; an H does not give it. *)
Definition next_leading_number {num} (c : command num) (before : edge_state num) : Z :=
  or_else (d_number c) (leading_number before).

Definition is_start {num} (c : command num) : bool :=
  match last_of compensations (codes_said c) with Some code => code =? 413 | None => false end.

(** Whether the mode is on behind a block.
    fanuc.leading-edge.start-with-d0: G41.3 with D0 in force starts nothing; a number whose value is 0 starts the mode.
    fanuc.leading-edge.cancel: G40 ends it. fanuc.leading-edge.d0-cancels: a D0 word ends it too. *)
Definition leads_behind {num} (c : command num) (before : edge_state num) : bool :=
  let number_zero := next_leading_number c before =? 0 in
  match last_of compensations (codes_said c) with
  | Some code => if code =? 413 then negb number_zero
                 else if code =? 400 then false else leads before && negb number_zero
  | None => leads before && negb number_zero
  end.

Definition edge_behind {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num) :
    outcome (edge_state num) :=
  Got (EdgeState (leads_behind c (edge before)) (next_leading_number c (edge before))).

(** * Alarms *)

Definition in_arc_mode {num} (c : command num) : bool :=
  match motion (in_modes c) with Clockwise | Counterclockwise => true | _ => false end.

(** fanuc.leading-edge.forbidden: what is refused in a block after which the mode is on. *)
Definition forbidden_in_edge {num} (c : command num) (axis_word : bool) : bool :=
  let b := block_of c in
  let has letter := given (last_word letter (words b)) in
  let high_speed := match whole_word Letter.P b with Some p => p =? 10000 | None => false end in
  existsb
    (fun code =>
      among code [40; 100; 280; 290; 300; 301; 370; 390; 450; 460; 470; 480; 520; 530; 920; 540; 541; 550; 560; 570; 580;
                  590; 200; 210; 960; 970; 1600] ||
      ((code =? 50) && negb high_speed))
    (codes_said c) ||
  match last_of compensations (codes_said c) with
  | Some code => among code [410; 420; 412; 422; 416; 426]
  | None => false
  end ||
  (axis_word && existsb has [Letter.M; Letter.S; Letter.T]).

(** The alarms that the words and the state before the block raise, in the order of fanuc.program.alarm-order.
    fanuc.leading-edge.start-format: an axis word, M00, M01, M02 or M30 with G41.3 raises PS5406.
    fanuc.leading-edge.cancel-format: so does an axis word in the block that cancels the mode.
    fanuc.leading-edge.start-in-arc-mode: G41.3 under G02 or G03 raises PS5408.
    fanuc.leading-edge.repeated: G41.3 while the mode is on raises PS5407.
    fanuc.leading-edge.arc: G02 or G03 while it is on does too. *)
Definition edge_alarms {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  let before := edge st in
  let on_behind := leads_behind c before in
  let starts := is_start c in
  let axis_word := moving_word s c st in
  let cancels := leads before && negb on_behind in
  _ <- alarm_if ((starts && (axis_word || stops_look_ahead s (block_of c))) || (cancels && axis_word)) "leading-edge-format" ;;
  _ <- alarm_if (starts && in_arc_mode c) "leading-edge-start" ;;
  _ <- alarm_if (leads before && (starts || in_arc_mode c)) "leading-edge-command" ;;
  _ <- alarm_if (on_behind && forbidden_in_edge c axis_word) "forbidden-in-compensation" ;;
  if on_behind then
    _ <- applied s ByD (offsets_of st) (next_leading_number c before) ;; Got tt
  else Got tt.
