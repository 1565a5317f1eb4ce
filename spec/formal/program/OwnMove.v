(* SPDX-License-Identifier: Apache-2.0 *)
(** The own movement of a block: its line or arc, with the tool offset of G45 to G48. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ToolShift Measurement State Pose.
From Toolcomp Require Import Movements.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** What makes an arc of a block in G02 or G03: an axis word of the plane, I J K or R.
    fanuc.program.arc-without-plane-words: without them the other axes move in a straight line. *)
Definition runs_arc {num} (m : modes) (s : setup num) (numbers : some_values num) (letters_are_data : bool)
    (b : block num) : bool :=
  let '(first, second) := plane_axes (in_plane m) in
  let has letter := given (last_word letter (words b)) in
  match motion m with
  | Clockwise | Counterclockwise =>
      negb (empty (map2 andb (which numbers) (union (the_axis s first) (the_axis s second)))) ||
      has Letter.R || (negb letters_are_data && existsb has [Letter.I; Letter.J; Letter.K])
  | _ => false
  end.

(** None: a straight line.
    fanuc.program.arc-radius-wins: if R and I J K are both given, R counts.
    fanuc.program.arc-radius-without-chord: R with an end that is the start is an arc of 0 degrees.
    fanuc.program.arc-without-center: without both of them PS0022, or with CIR = 0 a straight line. *)
Definition arc_between {num} {N : Numbers num} (s : setup num) (m : modes) (refused_later : bool) (b : block num)
    (from to : pair num) :
    outcome (option (circle num)) :=
  let number letter := last_number s (in_inches m) letter b in
  let clockwise := match motion m with Clockwise => true | _ => false end in
  let '(i, j) := center_letters (in_plane m) in
  match number Letter.R with
  | Some r =>
      let way := sub2 to from in
      stands <- is_zero "fanuc.program.arc-radius-without-chord" (dot2 way way) ;;
      if stands then Got None else c <- by_radius clockwise r from to ;; Got (Some c)
  | None =>
      if existsb (fun letter => given (number letter)) [Letter.I; Letter.J; Letter.K]
      then
        c <- by_center (or_else (parameter s "3410") 0%num) refused_later clockwise
               (or_else (number i) 0%num, or_else (number j) 0%num) from to ;;
        Got (Some c)
      else if or_else (parameter_bit s "3403#5") true then Alarm "arc-without-center" else Got None
  end.

(** * Tool offset *)

(** By how much a straight travel grows the shift of each axis. fanuc.tool-offset.linear-axes: of the linear axes named. *)
Definition grown {num} {N : Numbers num} (s : setup num) (m : modes) (b : block num) (longer : num)
    (numbers : some_values num) (from to : values num) : outcome (values num) :=
  each
    (fun letter =>
      if Letter.linear letter && given (last_word letter (words b)) then
        let minus_written := match last_word letter (words b) with Some w => negative w | None => false end in
        let travel := (value_on s to letter - value_on s from letter)%num in
        direction <- sense (incremental m) minus_written travel ;;
        Got (growth longer direction)
      else Got 0%num)
    (axes s).

(** * The movement *)

(** A block without a code that sends axes elsewhere: its own move.
    fanuc.program.own-move, fanuc.length-offset.move-without-axis-word: without an axis word only if the offset
    changes. *)
Definition own_move {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (b : block num)
    (circle_of : option (circle num)) (changed : bool) (longer : option num) (st : state num) :
    outcome (state num * list (movement num)) :=
  let m := modes_of st in
  let p := in_plane m in
  let from := programmed st in
  let to := destination (incremental m) from numbers in
  match circle_of with
  | Some c =>
    let start := in_plane_of s p from in
    let finish := in_plane_of s p to in
    '(center, shift_after, swept, radii) <-
      match longer with
      | None => Got (add2 (center_at c) (in_plane_of s p (shift st)), shift st, sweep_of c, ends c)
      | Some l =>
          _ <- alarm_if (given (last_word Letter.R (words b))) "tool-offset-arc" ;;
          '(to_center, travel, swept) <-
            longer_arc l (sub2 (center_at c) start) (sub2 finish start) (sweep_of c) ;;
          let tool := add2 start (in_plane_of s p (shift st)) in
          others <- grown s m b l numbers from to ;;
          let shift_in_plane := sub2 (add2 tool travel) finish in
          Got (add2 tool to_center, with_plane s p (sum (shift st) others) shift_in_plane, swept, None)
      end ;;
    let st := at_position st to shift_after in
    Got (st, [move_to s (motion m) Programmed false (Some (Arc center p swept radii)) st (vector (length_of st))])
  | None =>
    let has_axis := negb (empty (which numbers)) in
    growth <- match longer with
              | Some l => grown s m b l numbers from to
              | None => Got (zeros s)
              end ;;
    let st := at_position st to (sum (shift st) growth) in
    Got (st, if has_axis || changed
             then [move_to s (straight (motion m)) Programmed false None st (vector (length_of st))] else [])
  end.

(** * Measurement *)

(** fanuc.length-measurement.moves: the rapid part is a rapid move of cause programmed, the measuring part a linear one of
    cause measure; both carry the commanded coordinate in `programmed`. A block that would have neither makes the rapid
    move without travel.
    fanuc.length-measurement.coordinate: the signal's position is that of the axis; less length offset and shift it is a
    programmed coordinate.
    fanuc.length-measurement.feed: the second move carries 6241, or F if the setup does not give it.
    fanuc.length-measurement.position-after: the programmed position is then the one reached.
    fanuc.length-measurement.moves-before-the-alarm: PS0080 comes after the moves, and the value is not changed. *)
Definition measurement {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (st : state num) :
    outcome (state num * list (movement num) * option string * option (writing num)) :=
  let l := length_of st in
  let on_axis (v : values num) : num := or_else (find_named (which numbers) v) 0%num in
  let a := on_axis (programmed st) in
  let d := on_axis (replace (programmed st) numbers) in
  let signal := option_map (fun t => (t - on_axis (vector l) - on_axis (shift st))%num)
                  (or_else (find_named (which numbers) (signal_at s)) None) in
  path <- measure s a d signal ;;
  let standing x := on_named (which numbers) (map (fun _ => x) (programmed st)) (programmed st) in
  let part t c x f :=
    let point := sum (standing x) (shift st) in
    Movement t c (standing d) point (zeros s) (vector l) None None (feed_for t f)
      (tool_axis_at s (coordinates_of st) (standing d)) in
  let feed_of_part := match parameter s "6241" with Some f => Some f | None => feed st end in
  let first := match rapid_to path, measuring_to path with
               | Some b, _ => [part Rapid Programmed b None]
               | None, None => [part Rapid Programmed a None]
               | None, Some _ => []
               end in
  let second := match measuring_to path with Some x => [part Linear Measuring x feed_of_part] | None => [] end in
  let st := at_position st (standing (reached path)) (shift st) in
  Got (st, first ++ second, if in_zone path then None else Some "no-signal",
       if in_zone path then Some (measured s (offsets_of st) (number_in_force l) (reached path - d)%num) else None).
