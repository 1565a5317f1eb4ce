(* SPDX-License-Identifier: Apache-2.0 *)
(** What cutter compensation B and C share: codes, number, value, alarms. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners LengthOffset ToolShift.
From Toolcomp Require Import CutterState State Movements OwnMove.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** G41 or G42 in force behind the block. *)
Definition hand_behind {num} (c : command num) (before : option hand) : option hand :=
  match last_of compensations (codes_said c) with
  | None => before
  | Some code => if code =? 410 then Some LeftHand else if code =? 420 then Some RightHand else None
  end.
(** The words G40, and G41 or G42, where they count. *)
Definition says {num} (c : command num) (codes : list Z) : bool :=
  match last_of compensations (codes_said c) with Some code => among code codes | None => false end.
Definition says_cancel {num} (c : command num) : bool := says c [400].
Definition says_hand {num} (c : command num) : bool := says c [410; 420].

(** fanuc.cutter.number: the last D; with OFH = 1 an H gives it as well. *)
Definition gives_number {num} (s : setup num) (c : command num) : bool :=
  given (d_number c) || (ofh s && given (h_number c)).
Definition same_number (a b : shared_number) : bool := snd a =? snd b.
(** The block has a word that gives another number. *)
Definition gives_other_number {num} (s : setup num) (c : command num) (before : shared_number) : bool :=
  gives_number s c && negb (same_number (next_shared s (d_number c) (h_number c) before) before).

(** fanuc.cutter.on: on with G41 or G42 and, in C, a number other than 0, or with a vector that waits for its removal. *)
Definition asked_for {num} (s : setup num) (h : option hand) (number : shared_number) : bool :=
  given h && (cutter_b s || negb (snd number =? 0)).
Definition cutter_on {num} (s : setup num) (x : cutter_state num) (number : shared_number) : bool :=
  asked_for s (hand_in_force x) number || match in_phase x with Ending => true | _ => false end.
Definition cutter_on_after {num} (s : setup num) (c : command num) (st : state num) : bool :=
  asked_for s (hand_behind c (hand_in_force (cutter st))) (next_shared s (d_number c) (h_number c) (shared st)).

(** fanuc.cutter.value-edited: the value is read where the number is given, where G41 or G42 comes into force after G40,
    and with EVR = 1 in every block. *)
Definition reads_value {num} (s : setup num) (c : command num) (x : cutter_state num) : bool :=
  gives_number s c || bit s "5001#4" ||
  (given (hand_behind c (hand_in_force x)) && negb (given (hand_in_force x))).
Definition value_behind {num} {N : Numbers num} (s : setup num) (c : command num) (before : state num) : num :=
  let '(by_, number) := shared before in
  if reads_value s c (cutter before) then
    let '(geometry, wear) := entry_of by_ (offsets_of before) number in (geometry + wear)%num
  else value_in_force (cutter before).

(** The offset to the left: the value under G41, its negative under G42. *)
Definition to_the_left {num} {N : Numbers num} (h : hand) (value : num) : num :=
  match h with LeftHand => value | RightHand => (- value)%num end.

(** * Blocks *)

(** The block is an arc by its words: G02 or G03, no other code that acts in its block alone, and an axis word of the
    plane, I J K or R. *)
Definition is_arc_block {num} (s : setup num) (c : command num) : bool :=
  match acting c with
  | None | Some Lengthen | Some Shorten | Some LengthenTwice | Some ShortenTwice =>
      runs_arc (in_modes c) s (position_words c) (takes_letters (codes_said c)) (block_of c)
  | _ => false
  end.

(** The axes of the plane. *)
Definition plane_axis_set {num} (s : setup num) (p : plane) : axis_set :=
  let '(first, second) := plane_axes p in union (the_axis s first) (the_axis s second).
Definition names_plane {num} (s : setup num) (c : command num) : bool :=
  meets (which (position_words c)) (plane_axis_set s (in_plane (in_modes c))).
Definition has_axis_word {num} (c : command num) : bool := negb (empty (which (position_words c))).

(** G53, a reference return or G29 that goes somewhere. *)
Definition goes_away {num} (c : command num) : bool :=
  match acting c with
  | Some MachinePosition | Some FirstReference | Some OtherReference | Some FloatingReference
  | Some ReturnFromReference => has_axis_word c
  | _ => false
  end.
Definition is_corner_arc {num} (c : command num) : bool := match acting c with Some CornerArc => true | _ => false end.

(** The letters of the plane among I J K: none where both are missing, or are data of a code; a missing one is 0. *)
Definition plane_letters {num} {N : Numbers num} (s : setup num) (c : command num) : option (pair num) :=
  let m := in_modes c in
  let '(i, j) := center_letters (in_plane m) in
  let number letter := last_number s (in_inches m) letter (block_of c) in
  match takes_letters (codes_said c), number i, number j with
  | true, _, _ | _, None, None => None
  | _, x, y => Some (or_else x 0%num, or_else y 0%num)
  end.

(** Where the tool point of a state lies without compensation, in the plane. *)
Definition plane_point {num} {N : Numbers num} (s : setup num) (p : plane) (st : state num) : pair num :=
  in_plane_of s p (sum (programmed st) (shift st)).
Definition travel_in_plane {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num) :
    pair num :=
  let p := in_plane (in_modes c) in sub2 (plane_point s p after) (plane_point s p before).

(** The arc that the block runs. *)
Definition arc_run {num} (moves : list (movement num)) : option (bool * arc num) :=
  match find (fun m => given (circle_of m)) moves with
  | Some m => option_map (fun a => (match going m with Clockwise => true | _ => false end, a)) (circle_of m)
  | None => None
  end.

(** * Alarms *)

(** fanuc.cutter.plane-axes: the machine lacks an axis of the plane. *)
Definition lacks_plane_axis {num} (s : setup num) (p : plane) : bool :=
  let '(first, second) := plane_axes p in empty (the_axis s first) || empty (the_axis s second).

Definition same_plane (a b : plane) : bool :=
  match a, b with XY, XY | ZX, ZX | YZ, YZ => true | _, _ => false end.

(** The alarms of the words before those of B and C, in the order of fanuc.cutter.order-of-alarms.
    fanuc.cutter.plane-axes: PS0028. fanuc.cutter.plane-change: PS0037. fanuc.cutter.excluded.
    fanuc.tool-offset.in-cutter-compensation: PS0042. *)
Definition shared_alarms {num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  let p := in_plane (in_modes c) in
  let on := cutter_on s (cutter st) (shared st) in
  let in_force := given (hand_behind c (hand_in_force (cutter st))) in
  _ <- alarm_if (in_force && lacks_plane_axis s p) "plane-axis-missing" ;;
  _ <- alarm_if (on && negb (same_plane p (in_plane (modes_of st)))) "plane-change" ;;
  let under_tool_direction := match last_of lengths (codes_said c) with
                              | Some code => among code [434; 435] | None => false end in
  _ <- alarm_if ((on && says c [412; 413; 416; 422; 426]) || ((on || in_force) && under_tool_direction))
         "forbidden-in-cutter-compensation" ;;
  let shifts := match acting c with
                | Some Lengthen | Some Shorten | Some LengthenTwice | Some ShortenTwice => true | _ => false end in
  alarm_if (shifts && (on || cutter_on_after s c st)) "tool-offset-in-cutter-compensation".

(** fanuc.cutter.value-too-large: PS0029. *)
Definition value_alarm {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  let '(by_, number) := next_shared s (d_number c) (h_number c) (shared st) in
  if given (hand_behind c (hand_in_force (cutter st))) && reads_value s c (cutter st) && negb (number =? 0)
  then _ <- applied s by_ (offsets_of st) number ;; Got tt
  else Got tt.
