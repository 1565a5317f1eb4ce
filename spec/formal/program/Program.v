(* SPDX-License-Identifier: Apache-2.0 *)
(** A FANUC program: from blocks to events. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ToolShift Measurement.
From Toolcomp Require Import EdgeState SideState ControlState CycleState State.
From Toolcomp Require Import Movements OwnMove CutterRules CutterModes CutterWords SideWords EdgeWords ControlWords.
From Toolcomp Require Import ControlStep DrillingCycle Compensation.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * What a block says *)

(** fanuc.program.offset-number-range: an H or D number greater than the number of offsets raises PS0030. *)
Definition offset_number {num} (s : setup num) (letter : Letter.t) (b : block num) : outcome (option Z) :=
  match last_word letter (words b) with
  | None => Got None
  | Some w =>
      match whole w with
      | Some number => if offset_count s <? number then Alarm "offset-number" else Got (Some number)
      | None => Alarm "offset-number"
      end
  end.

(** fanuc.program.feed: F is modal. fanuc.program.feed-mode: under G93 and G95 it is not a feed per minute. *)
Definition next_feed {num} {N : Numbers num} (s : setup num) (m : modes) (b : block num) (before : option num) :
    option num :=
  if negb (feed_per_minute m) then None
  else match last_number s (in_inches m) Letter.F b with Some f => Some f | None => before end.

Definition is_shift (code : option action) : bool :=
  match code with Some Lengthen | Some Shorten | Some LengthenTwice | Some ShortenTwice => true | _ => false end.

(** fanuc.program.no-feed: a cutting move, and in the drilling mode a hole, without F, or with F 0, raises PS0011. *)
Definition feed_alarm {num} {N : Numbers num} (s : setup num) (m : modes) (codes : list Z) (in_cycle holes_made : bool)
    (b : block num) (f : option num) : outcome unit :=
  let code := action_of codes in
  let own := negb (takes_letters codes) in
  let has letter := given (last_word letter (words b)) in
  let moves :=
    match motion m with
    | Rapid => false
    | Linear => own && existsb has (axes s)
    | Clockwise | Counterclockwise =>
        (own && (existsb has (axes s) || existsb has [Letter.I; Letter.J; Letter.K])) || has Letter.R
    end in
  let cuts := if in_cycle then holes_made else (negb (given code) || is_shift code) && moves in
  lacks <- match f with Some x => is_zero "fanuc.program.no-feed" x | None => Got true end ;;
  alarm_if (feed_per_minute m && cuts && lacks) "no-feed".

(** No path belongs to these. *)
Definition stays (code : option action) : bool :=
  match code with
  | Some Dwell | Some DataInput | Some CornerArc | Some LocalSystem | Some SetPosition => true
  | _ => false
  end.
(** The words of these are theirs, not positions. *)
Definition renames (code : option action) : bool :=
  match code with Some CornerArc | Some LocalSystem | Some SetPosition => true | _ => false end.
(** They send the axes that they name elsewhere. *)
Definition goes_to_machine_position (code : option action) : bool :=
  match code with
  | Some MachinePosition | Some FirstReference | Some OtherReference | Some FloatingReference => true
  | _ => false
  end.

(** Whether two offsets differ on some axis. *)
Definition differs {num} {N : Numbers num} (a b : values num) : outcome bool :=
  equal <- each (is_zero "fanuc.length-offset.move-without-axis-word") (difference a b) ;;
  Got (existsb negb equal).

(** fanuc.length-offset.shifted-system: with 5006#6 = 1 the length offset shifts the coordinate system: the position is
    renamed by the change.
    fanuc.length-offset.shifted-in-compensation: while a compensation is on, the run ends undecided. *)
Definition shifts_system {num} (s : setup num) : bool := bit s "5006#6".
Definition in_shifted_system {num} {N : Numbers num} (s : setup num) (c : length_command) (compensates : bool)
    (st : state num) (position : values num) : outcome (values num) :=
  '(on_way, _) <- length_step s (offsets_of st) c (length_of st) ;;
  changed <- differs (vector on_way) (vector (length_of st)) ;;
  if negb changed then Got position
  else if compensates then Undecided "fanuc.length-offset.shifted-in-compensation"
  else Got (difference position (difference (vector on_way) (vector (length_of st)))).

(** What G10 writes: "H3" in memory A, else "H3.geometry" or "D2.wear"; of two tables that of H. *)
Definition setting {num} (number : Z -> string) (s : setup num) (w : writing num) : item num :=
  let letter := match of_address w with ByH => "H" | ByD => "D" end in
  let part := match memory s, of_wear w with MemoryA, _ => "" | _, true => ".wear" | _, false => ".geometry" end in
  Write (letter ++ number (at_number w) ++ part)%string (match of_address w with ByH => for_h w | ByD => for_d w end).

(** The moves of a block and the state behind them; the alarm that they end in; what is written. *)
Definition moves_of_block {num} {N : Numbers num} (s : setup num) (c : command num) (path_block : block num)
    (circle_of : option (circle num)) (changed : bool) (longer : option num) (target : option (values num))
    (on_way : length_offset num) (control_now : control_state num) (writing : option (writing num)) (st : state num) :
    outcome (state num * list (movement num) * option string * option (Memory.writing num)) :=
  let numbers := position_words c in
  let as_moved x := Got (fst x, snd x, None, writing) in
  match acting c, negb (empty (which numbers)), target with
  | Some MachinePosition, true, _ => as_moved (machine_coordinates s numbers st)
  | _, true, Some t => as_moved (reference_return s t numbers on_way st)
  | Some ReturnFromReference, true, _ => as_moved (return_from_reference s numbers st)
  | Some Measure, _, _ => measurement s numbers st
  | _, _, _ =>
      '(st, moves) <- own_move s numbers path_block circle_of changed longer st ;;
      as_moved (under_control s c control_now st moves)
  end.

(** fanuc.program.alarm-order: in the order of these steps. The block as it runs, and the alarm that its motion ends in. *)
Definition step {num} {N : Numbers num} (decimal : Z -> string) (s : setup num) (place : nat) (b : block num)
    (st : state num) : outcome (planned num * option string) :=
  _ <- match unreadable b with Some number => Alarm number | None => Got tt end ;;
  match codes_of b with
  | None => Alarm "unknown-code"
  | Some codes =>
    let code := action_of codes in
    let m := select codes (modes_of st) in
    let l := whole_word Letter.L b in
    let input := match code with Some DataInput => true | _ => false end in
    let origins := input && among (or_else l 0) [2; 20] in
    let into := if input then store s l else None in
    _ <- alarm_if (bit s "3403#6" && repeats codes b) "address-repeated" ;;
    _ <- alarm_if (three_dimensional s codes b) "unknown-code" ;;
    _ <- alarm_if (input && negb origins && negb (given into)) "g10-kind" ;;
    h <- offset_number s Letter.H b ;;
    d <- offset_number s Letter.D b ;;
    c <- select_system codes b (coordinates_of st) ;;
    let x := cycle_with s codes (in_plane m) (cycle st) in
    let in_cycle := given (drilling x) in
    let drills := in_cycle && names_hole s codes b in
    let holes_made := makes_holes s codes b x in
    _ <- feed_alarm s m codes in_cycle holes_made b (next_feed s m b (feed st)) ;;
    let all_numbers := axis_numbers s (in_inches m) b in
    let letters_are_data := takes_letters codes in
    let data := letters_are_data || renames code in
    let ignored := match code with Some MachinePosition => incremental m | _ => false end in
    let no_numbers := map (fun _ => None) (axes s) in
    let moving_numbers := if data || ignored then no_numbers else all_numbers in
    (* fanuc.canned-cycle.drills: in the drilling mode they are those of holes, and name no axis. *)
    let numbers := if in_cycle then no_numbers else moving_numbers in
    (* Of G52, G92, G39 and a G53 that is ignored too. *)
    let naming := if letters_are_data || drills then no_numbers else all_numbers in
    let st := control_left s codes st in
    let position := renamed s (coordinates_of st) c (programmed st) in
    let said := Command b codes code m h d all_numbers numbers naming in
    (* fanuc.canned-cycle.length-offset: type C takes the drilling axis. *)
    let to_offset := match drilling x with
                     | Some d => if drills then the_axis s (drilling_axis d) else which naming
                     | None => which naming
                     end in
    let to_length := LengthCommand (length_code_of codes) h (in_plane m) to_offset
                     (match words b with [] => false | _ => true end) (existsb (fun c => among c [400; 410; 420]) codes)
                     (if goes_to_machine_position code then which numbers else no_axes s) in
    let side_after := asked_behind s said st in
    let edge_after := leads_behind said (edge st) in
    let in_plane_before := cutter_on s (cutter st) (shared st) in
    let in_plane_after := cutter_on_after s said st in
    _ <- control_alarms s said st in_cycle
           (BesideControl (leads (edge st) || edge_after) (side_on (side st) || side_after) (side_after || edge_after)) ;;
    _ <- cycle_alarms s said x drills (in_plane_before || side_on (side st) || leads (edge st))
           (side_after || edge_after) in_plane_after ;;
    _ <- edge_alarms s said st ;;
    _ <- side_alarms s said st ;;
    _ <- cutter_alarms s said st ;;
    let in_plane_on := in_plane_before || in_plane_after in
    let compensates := in_plane_on || side_on (side st) || side_after || leads (edge st) || edge_after in
    let measures := match code with Some Measure => true | _ => false end in
    _ <- (if measures then measurement_words s m to_length in_plane_on (length_of st) else Got tt) ;;
    c' <- (if origins then with_origin s (incremental m) (or_else l 0) b all_numbers c else Got c) ;;
    writing <- match into with Some store => written s m (offsets_of st) b store | None => Got None end ;;
    target <- (if empty (which numbers) then Got None else reference_position s code b) ;;
    (* fanuc.program.return-without-intermediate: on the 30i. *)
    _ <- alarm_if (series_30i s && match code with Some ReturnFromReference => true | _ => false end &&
                   existsb (fun x => fst x && negb (given (snd x))) (combine (which numbers) (intermediate st)))
           "no-intermediate-point" ;;
    (* fanuc.length-offset.shifted-system: the position is renamed, then the block moves. *)
    position <- (let position := renamed s c c' position in
                 if shifts_system s && negb (given (type_with codes st))
                 then in_shifted_system s to_length compensates st position else Got position) ;;
    let st := State m (next_feed s m b (feed st)) c' position (shift st) (length_of st) (next_shared s d h (shared st))
                (offsets_of st) (intermediate st) (cutter st) (side st) (edge st) (control st) x in
    let at_start := st in
    let named := which numbers in
    let to_machine := goes_to_machine_position code in
    let elsewhere := to_machine || match code with Some ReturnFromReference | Some Measure => true | _ => false end in
    let to := destination (incremental m) position numbers in
    let path_block := if by_vector (type_with codes st) then without_direction b else b in
    circle_of <-
      (if negb (elsewhere || stays code || in_cycle) && runs_arc m s numbers letters_are_data path_block
       then
         arc_between s m (negb (cutter_b s) && in_plane_after) path_block
           (in_plane_of s (in_plane m) position) (in_plane_of s (in_plane m) to)
       else Got None) ;;
    (* G45 to G48. fanuc.canned-cycle.tool-offset: in the drilling mode they store their number. *)
    let shifts := is_shift code && negb in_cycle in
    let offset_mode := match length_code_of codes with
                       | Some G49 => false | Some _ => true | None => given (in_force (length_of st)) end in
    _ <- alarm_if (shifts && by_h_number s && offset_mode) "tool-offset-length" ;;
    longer <-
      (if shifts && (negb (empty named) || given circle_of) then
         let '(by_, number) :=
           if by_h_number s
           then (ByH, or_else (new_number s to_length (length_of st)) (number_in_force (length_of st)))
           else shared st in
         x <- applied s by_ (offsets_of st) number ;;
         Got (lengthening code x)
       else Got None) ;;
    (* The alarms of the arc of G45 to G48 come before those of the length offset. *)
    _ <- own_move s numbers path_block circle_of false longer st ;;
    controlled <- control_step s said to_length circle_of to st ;;
    '(on_way, at_end) <- match controlled with
                         | Some (length, _) => Got (length, length)
                         | None => length_step s (offsets_of st) to_length (length_of st)
                         end ;;
    changed <- match controlled with
               | Some (_, run) => control_moves s said run st
               | None =>
                   (* fanuc.length-offset.shifted-system: nothing moves. *)
                   (* fanuc.canned-cycle.length-offset: it counts in the holes. *)
                   other <- (if shifts_system s || holes_made then Got false
                             else differs (vector at_end) (vector (length_of st))) ;;
                   Got (other || (cancel_moves s st && negb holes_made))
               end ;;
    control_now <- match controlled with
                   | Some (_, run) => Got run
                   | None => without_control s said
                               (if drills then numbers_of_all_holes said moving_numbers else numbers) st
                   end ;;
    let st := with_control (with_length st at_end) control_now in
    '(st, moves, alarm, writing) <-
      moves_of_block s said path_block circle_of changed longer target on_way control_now writing st ;;
    let '(st, holes) := cycle_step s said drills moving_numbers st in
    (* G52, G92 and G10 count behind the block. *)
    let coordinates_behind := match code with
      | Some LocalSystem => with_local naming (coordinates_of st)
      | Some SetPosition => with_shift s naming (programmed st) (coordinates_of st)
      | _ => coordinates_of st
      end in
    let offsets_behind := match writing with Some w => write s w (offsets_of st) | None => offsets_of st end in
    let settings := match writing with Some w => [setting decimal s w] | None => [] end in
    let renamed_behind := renamed s (coordinates_of st) coordinates_behind (programmed st) in
    let st := at_position (in_coordinates (with_offsets st offsets_behind) coordinates_behind) renamed_behind (shift st) in
    control' <- control_behind s said at_start st ;;
    edge' <- edge_behind s said at_start st ;;
    side' <- side_behind s said at_start st moves ;;
    cutter' <- cutter_behind s said at_start st moves ;;
    let st := with_control (with_edge (with_side (with_cutter st cutter') side') edge') control' in
    Got (Planned place said at_start st (map Go moves ++ map Drill holes ++ settings), alarm)
  end.

(** fanuc.program.end: M02 and M30 end the program after their block. *)
Definition ends {num} (b : block num) : bool :=
  existsb (fun w => match address w with
                    | Letter.M => match tenths w with Some t => among t [20; 300] | None => false end
                    | _ => false
                    end) (words b).

(** Block by block, each from what those before it have come to. *)
Fixpoint planned_from {num} {N : Numbers num} (decimal : Z -> string) (s : setup num) (bs : list (block num)) (place : nat)
    (st : state num) : plan num :=
  match bs with
  | [] => ([], Ended)
  | b :: rest =>
      match step decimal s place b st with
      | Got (here, Some number) => ([here], EndsInAlarm place number)
      | Got (here, None) =>
          if ends b then ([here], Ended)
          else let '(later, how) := planned_from decimal s rest (S place) (behind here) in (here :: later, how)
      | stopped => ([], ends_in place stopped)
      end
  end.

(** The events, and how the run ends. *)
Definition run_program {num} {N : Numbers num} decimal (s : setup num) (bs : list (block num)) :
    list (nat * event num) * ending :=
  let run := compensated s (planned_from decimal s bs 0%nat (initial s)) in
  (events_of run, snd run).
