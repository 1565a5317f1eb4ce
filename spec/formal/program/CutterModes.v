(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/cutter-compensation-c: what a block is to the mode, by itself and by what was before it; the words' alarms. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners LengthOffset.
From Toolcomp Require Import CutterState State Movements CutterRules CutterMoves.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** fanuc.cutter-c.start-up-type, fanuc.cutter-c.suv, fanuc.cutter-c.ccn, fanuc.cutter-c.interference-check,
    fanuc.cutter-c.interference-without-alarm, fanuc.cutter-c.interference-at-once. *)
Definition sup {num} (s : setup num) : bool := bit s "5003#0".
Definition suv {num} (s : setup num) : bool := bit s "5003#1".
Definition ccn {num} (s : setup num) : bool := bit s "5003#2".
Definition cni {num} (s : setup num) : bool := bit s "5008#0".
Definition cnc {num} (s : setup num) : bool := bit s "5008#1".
Definition cnv {num} (s : setup num) : bool := series_30i s && bit s "5008#3".

(** fanuc.cutter-c.three-dimensional: G41 or G42 with all of I, J and K. *)
Definition three_dimensional {num} (s : setup num) (codes : list Z) (b : block num) : bool :=
  negb (cutter_b s) && negb (takes_letters codes) &&
  match last_of compensations codes with Some code => among code [410; 420] | None => false end &&
  forallb (fun letter => given (last_word letter (words b))) [Letter.I; Letter.J; Letter.K].

(** * Alarms by the words *)

Definition mode_is_on (ph : phase) : bool :=
  match ph with Running | Started | TakenAway | Ending => true | Off | Pending _ => false end.

(** fanuc.cutter-c.corner-arc-alarm: PS0035. *)
Definition corner_alarm_c {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  let made := match in_phase (cutter st) with Running | Started => true | _ => false end in
  _ <- alarm_if (negb (cutter_on_after s c st) || negb made || says_cancel c || says_hand c ||
                 negb (empty (which (naming_words c))) || gives_other_number s c (shared st)) "corner-arc" ;;
  match plane_letters s c with
  | None => Got tt
  | Some u => nothing <- is_zero "fanuc.cutter-c.corner-arc-alarm" (square2 u) ;; alarm_if nothing "corner-arc"
  end.

(** fanuc.cutter-c.start-or-cancel-in-arc: PS0034. *)
Definition arc_alarm_c {num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  let asked := cutter_on_after s c st in
  let ph := in_phase (cutter st) in
  let starts := asked && match ph with Off => true | _ => false end in
  let cancels := negb asked && mode_is_on ph in
  alarm_if (is_arc_block s c && (starts || cancels)) "arc-at-start-or-cancel".

Definition alarms_c {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  _ <- (if is_corner_arc c then corner_alarm_c s c st else Got tt) ;;
  arc_alarm_c s c st.

(** * What a block does *)

(** fanuc.cutter.side: whether the tool is on the left; a value of 0 counts as positive. *)
Definition on_left {num} {N : Numbers num} (h : hand) (value : num) : outcome bool :=
  negative <- is_negative "fanuc.cutter.side" value ;;
  Got (xorb negative (match h with LeftHand => true | RightHand => false end)).
(** r: the value without its sign. *)
Definition magnitude {num} {N : Numbers num} (value : num) : outcome num :=
  negative <- is_negative "fanuc.cutter.side" value ;;
  Got (if negative : bool then (- value)%num else value).
Definition offset_of {num} {N : Numbers num} (left : bool) (r : num) : num := if left then r else (- r)%num.

(** fanuc.cutter-c.moving-block: its end differs from its start in an axis of the plane, or it is an arc. *)
Definition moves_in_plane {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num)
    (moves : list (movement num)) : outcome bool :=
  let clause := "fanuc.cutter-c.moving-block" in
  if goes_away c || is_corner_arc c then Got false
  else if given (arc_run moves) then Got true
  else if names_plane s c then
    let d := travel_in_plane s c before after in
    first <- is_zero clause (fst d) ;;
    second <- is_zero clause (snd d) ;;
    Got (negb first || negb second)
  else Got false.

(** fanuc.cutter-c.non-motion-count: one, with an axis word of the plane as many as end the block before. *)
Definition idle_count {num} (s : setup num) (c : command num) : Z := if names_plane s c then idle_limit s else 1.

(** fanuc.cutter-c.look-ahead-stopped: nothing is read beyond an M code that says so, and G53. *)
Definition stops_reading {num} (s : setup num) (c : command num) : bool :=
  stops_look_ahead s (block_of c) || match acting c with Some MachinePosition => true | _ => false end.

(** fanuc.cutter-c.arc-ends-in-center: an arc whose centre is its start or its end raises PS0038. *)
Definition center_alarm {num} {N : Numbers num} (s : setup num) (before after : state num)
    (moves : list (movement num)) : outcome unit :=
  let clause := "fanuc.cutter-c.arc-ends-in-center" in
  match arc_run moves with
  | None => Got tt
  | Some (_, a) =>
      let p := arc_plane a in
      at_start <- is_zero clause (square2 (sub2 (center a) (plane_point s p before))) ;;
      at_end <- is_zero clause (square2 (sub2 (center a) (plane_point s p after))) ;;
      alarm_if (at_start || at_end) "arc-ends-in-center"
  end.

(** P1 of a moving block. *)
Definition end_leg {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num)
    (moves : list (movement num)) (rho : num) : leg num :=
  match arc_run moves with
  | Some (clockwise, a) => arc_leg (Bow clockwise (sub2 (center a) (plane_point s (arc_plane a) after))) rho
  | None => line_leg (travel_in_plane s c before after) rho
  end.

(** The way to the intermediate point of a reference return, in the plane. *)
Definition way_to_intermediate {num} {N : Numbers num} (s : setup num) (c : command num) (before : state num)
    (moves : list (movement num)) : option (pair num) :=
  let p := in_plane (in_modes c) in
  match acting c, moves with
  | Some FirstReference, first :: _ | Some OtherReference, first :: _ | Some FloatingReference, first :: _ =>
      Some (sub2 (in_plane_of s p (tip first)) (plane_point s p before))
  | _, _ => None
  end.

(** What a block makes of the mode: part, phase, vector without a corner, offset and side of the last moving block. *)
Definition result (num : Type) := (part * phase * pair num * num * bool)%type.

(** The mode ends in a block that does not move in the plane.
    fanuc.cutter-c.cancel-without-motion: with SUV = 1 the vector is removed; else it waits, and one that is exactly zero
    is gone at once. *)
Definition ends_alone {num} {N : Numbers num} (s : setup num) (what : part) (x : cutter_state num) :
    outcome (result num) :=
  nothing <- is_zero "fanuc.cutter-c.cancel-without-motion" (square2 (vector_behind x)) ;;
  Got (if suv s || nothing then (what, Off, zero2, 0%num, true)
       else (what, Ending, vector_behind x, reach x, was_left x)).

(** G53, G29 and reference returns that go somewhere.
    fanuc.cutter-c.machine-position: with G40 or number 0, or after them, the vector vanishes and the mode is off.
    fanuc.cutter-c.outside-axes-only: other axes only keep the vector.
    fanuc.cutter-c.ccn: CCN = 0 turns the mode off, CCN = 1 leaves it on.
    fanuc.cutter-c.one-plane-axis: with CCN = 1, too, one axis named takes the whole vector away.
    fanuc.cutter-c.reference-intersection: the way to the intermediate point is a block of the mode then. *)
Definition goes_away_step {num} {N : Numbers num} (s : setup num) (c : command num) (asked : option hand) (value : num)
    (before : state num) (moves : list (movement num)) : outcome (result num) :=
  let x := cutter before in
  let plane_named := names_plane s c in
  let off := (GoesAway, Off, zero2, 0%num, true) in
  match in_phase x, asked with
  | Off, _ | Pending _, _ => Got off
  | Ending, Some _ => Undecided "fanuc.cutter-c.restart-before-removal"
  | Ending, None => Got (if plane_named then off else (GoesAway, Ending, vector_behind x, reach x, was_left x))
  | _, None => if plane_named then Got off else ends_alone s GoesAway x
  | _, Some hand =>
      if negb plane_named then Got (GoesAway, in_phase x, vector_behind x, reach x, was_left x)
      else if negb (ccn s) then Got off
      else
        let taken := (GoesAway, TakenAway, zero2, reach x, was_left x) in
        match way_to_intermediate s c before moves with
        | None => Got taken
        | Some d =>
            nothing <- is_zero "fanuc.cutter-c.reference-intersection" (square2 d) ;;
            if nothing : bool then Got taken
            else
              left <- on_left hand value ;;
              r <- magnitude value ;;
              _ <- alarm_if (match in_phase x with Started => negb (Bool.eqb left (was_left x)) | _ => false end)
                     "side-change-at-start" ;;
              Got (WayBlock, TakenAway, zero2, r, left)
        end
  end.

(** fanuc.cutter-c.start-up: with the mode off the next moving block that asks for it is the start-up block.
    fanuc.cutter-c.cancel: the first one that does not is the cancel block.
    fanuc.cutter-c.direction-change-at-start-up: the first one after a start-up must not change the side.
    fanuc.cutter-c.restart-before-removal. *)
Definition moving_step {num} {N : Numbers num} (s : setup num) (c : command num) (asked : option hand) (value : num)
    (before after : state num) (moves : list (movement num)) : outcome (result num) :=
  let x := cutter before in
  let off what := (what, Off, zero2, 0%num, true) in
  match in_phase x, asked with
  | Off, None | Pending _, None => Got (off MovesFree)
  | _, None => Got (off CancelBlock)
  | Ending, Some _ => Undecided "fanuc.cutter-c.restart-before-removal"
  | ph, Some hand =>
      _ <- center_alarm s before after moves ;;
      left <- on_left hand value ;;
      r <- magnitude value ;;
      let changes := negb (Bool.eqb left (was_left x)) in
      _ <- alarm_if (changes && match ph with Started | Pending _ => true | _ => false end) "side-change-at-start" ;;
      let v := perpendicular (end_leg s c before after moves (offset_of left r)) in
      Got (match ph with Off => (StartUpBlock, Started, v, r, left) | _ => (ModeBlock, Running, v, r, left) end)
  end.

(** A block that does not move in the plane.
    fanuc.cutter-c.start-without-motion: SUV = 1 and the word G41 or G42.
    fanuc.cutter-c.start-without-next-block: too many blocks, one that stops the look-ahead, or the mode not asked for any
    more, and nothing starts; the word in the block that brings the count there, or in G52 or G92 of the plane, starts
    anew.
    fanuc.cutter-c.cancel-by-zero-travel: behind a lone G40 an axis word of the plane takes the vector away.
    fanuc.cutter-c.restart-before-removal, before
    fanuc.cutter-c.coordinate-shift: G52 or G92 of the plane takes the vector away, and the mode goes on. *)
Definition idle_step {num} {N : Numbers num} (s : setup num) (c : command num) (asked : option hand) (value : num)
    (before : state num) : outcome (result num) :=
  let x := cutter before in
  let n := idle_count s c in
  let as_before := (Idle n, in_phase x, vector_behind x, reach x, was_left x) in
  let renames_plane := match acting c with
    | Some LocalSystem | Some SetPosition =>
        meets (which (naming_words c)) (plane_axis_set s (in_plane (in_modes c)))
    | _ => false end in
  let restarts := match in_phase x, asked with Ending, Some _ => true | _, _ => false end in
  if restarts then Undecided "fanuc.cutter-c.restart-before-removal"
  else if mode_is_on (in_phase x) && renames_plane then
    Got (if given asked then (ShiftsPlane, TakenAway, zero2, reach x, was_left x)
         else (ShiftsPlane, Off, zero2, 0%num, true))
  else
    let stays_off := (Idle n, Off, zero2, 0%num, true) in
    let starts hand :=
      if stops_reading s c then Got stays_off else
      left <- on_left hand value ;; r <- magnitude value ;; Got (LoneStart, Pending 0, zero2, r, left) in
    match in_phase x, asked with
    | Off, Some hand => if suv s && says_hand c then starts hand else Got as_before
    | Off, None => Got as_before
    | Pending _, None => Got stays_off
    | Pending k, Some hand =>
        if (k + n <? idle_limit s) && negb (stops_reading s c) && negb renames_plane then Got (Idle n, Pending (k + n), zero2, reach x, was_left x)
        else if says_hand c then starts hand
        else Got stays_off
    | Ending, _ => Got (if names_plane s c then (CancelBlock, Off, zero2, 0%num, true) else as_before)
    | _, Some _ => Got as_before
    | _, None => ends_alone s LoneCancel x
    end.

(** fanuc.cutter-c.corner-arc: the vector behind G39; without letters the next moving block makes its own. *)
Definition corner_step {num} {N : Numbers num} (s : setup num) (c : command num) (x : cutter_state num) : result num :=
  let v := match plane_letters s c with
           | Some u => perpendicular (line_leg u (offset_of (was_left x) (reach x)))
           | None => vector_behind x
           end in
  (CornerBlock, in_phase x, v, reach x, was_left x).

(** Asked while it makes a difference: with the mode off, and not asked for, a block is as it is. *)
Definition is_moving {num} {N : Numbers num} (s : setup num) (c : command num) (asked : option hand)
    (before after : state num) (moves : list (movement num)) : outcome bool :=
  match in_phase (cutter before), asked with
  | Off, None => Got true
  | _, _ => moves_in_plane s c before after moves
  end.

(** fanuc.cutter-c.mode.
    fanuc.cutter-c.number-zero: number 0 does what G40 does. *)
Definition behind_c {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num)
    (moves : list (movement num)) : outcome (cutter_state num) :=
  let h := hand_behind c (hand_in_force (cutter before)) in
  let value := value_behind s c before in
  let asked := if asked_for s h (shared before) then h else None in
  moving <- is_moving s c asked before after moves ;;
  '(what, ph, v, r, was_on_left) <-
    (if goes_away c then goes_away_step s c asked value before moves
     else if is_corner_arc c then Got (corner_step s c (cutter before))
     else if moving : bool then moving_step s c asked value before after moves
     else idle_step s c asked value before) ;;
  Got (CutterState h value ph v r was_on_left what).
