(** A FANUC program: from blocks to events.

    What this text says so far: fanuc/program, fanuc/tool-length-offset, fanuc/tool-length-measurement and
    fanuc/tool-offset. A code of another section ends the run with [Beyond]. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ToolShift Measurement.
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
  intermediate : some_values num         (* of the last reference return *)
}.
Arguments State {num}. Arguments modes_of {num}. Arguments feed {num}. Arguments coordinates_of {num}.
Arguments programmed {num}. Arguments shift {num}. Arguments length_of {num}. Arguments shared {num}.
Arguments offsets_of {num}. Arguments intermediate {num}.

(** fanuc.program.initial-state: G00 G17 G90 G94 G40 G49 G54, at the position of the setup, with H0 and D0, without F. *)
Definition initial {num} {N : Numbers num} (s : setup num) : state num :=
  State (initial_modes (inches s)) None (given_coordinates s) (start s) (zeros s) (no_length_offset s) (ByD, 0)
    (given_offsets s) (map (fun _ => None) (axes s)).

(** * What a block says *)

(** fanuc.program.offset-number-range: an H or D number beyond the number of offsets raises PS0030. *)
Definition offset_number {num} (s : setup num) (letter : Letter.t) (b : block num) : outcome (option Z) :=
  match last_word letter (words b) with
  | None => Got None
  | Some w =>
      match whole w with
      | Some number => if offset_count s <? number then Alarm "PS0030" else Got (Some number)
      | None => Alarm "PS0030"
      end
  end.

(** fanuc.program.feed: F is modal. fanuc.program.feed-mode: under G93 and G95 it is no feed per minute. *)
Definition next_feed {num} {N : Numbers num} (s : setup num) (m : modes) (b : block num) (before : option num) :
    option num :=
  if negb (feed_per_minute m) then None
  else match last_number s (in_inches m) Letter.F b with Some f => Some f | None => before end.

(** fanuc.program.incremental: under G90 an axis word is the end position, under G91 the travel. *)
Definition destination {num} {N : Numbers num} (incremental : bool) (from : values num) (numbers : some_values num) :
    values num :=
  map2 (fun x number => match number with Some y => if incremental then (x + y)%num else y | None => x end) from numbers.

Definition which {A} (numbers : list (option A)) : axis_set := map given numbers.

(** The kind of motion of a block in G02 or G03 that runs no arc, and of one without an axis word. *)
Definition straight (t : travel) : travel := match t with Rapid => Rapid | _ => Linear end.

(** fanuc.program.feed: rapid moves carry none. *)
Definition feed_for {num} (t : travel) (f : option num) : option num := match t with Rapid => None | _ => f end.

(** * Moves *)

(** A move to a programmed position, as the state stands. Rotary axes take neither shift nor length offset. *)
Definition move_to {num} {N : Numbers num} (s : setup num) (t : travel) (c : cause) (machine : bool) (a : option (arc num))
    (st : state num) (length : values num) : event num :=
  let point := sum (programmed st) (shift st) in
  let positions := sum point length in
  Moves (Move t c (programmed st) point positions
    (if machine then Some (sum positions (work_zero s (coordinates_of st))) else None) a (feed_for t (feed st))).

Definition at_position {num} (st : state num) (position shift : values num) : state num :=
  State (modes_of st) (feed st) (coordinates_of st) position shift (length_of st) (shared st) (offsets_of st)
    (intermediate st).

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

(** fanuc.program.machine-coordinates: G53 goes in rapid traverse to machine coordinates.
    fanuc.tool-offset.machine-position, fanuc.length-offset.position-after: the named axes lose shift and offset; their
    position is then the machine position less the work zero. *)
Definition machine_coordinates {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (st : state num) :
    state num * list (event num) :=
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
      | Some _, Some p => if among p [2; 3; 4] then position p else Alarm "PS0046"
      | Some _, None => Alarm "PS0046"
      end
  | Some FloatingReference => Got (Some (floating s))
  | _ => Got None
  end.

(** fanuc.program.reference-return: through the intermediate point to the reference position, both in rapid traverse. *)
Definition reference_return {num} {N : Numbers num} (s : setup num) (target : values num) (numbers : some_values num)
    (on_way : length_offset num) (st : state num) : state num * list (event num) :=
  let named := which numbers in
  let between := destination (incremental (modes_of st)) (programmed st) numbers in
  let st := at_position st between (shift st) in
  let first := move_to s Rapid Reference true None st (vector on_way) in
  let position := difference target (work_zero s (coordinates_of st)) in
  let there := at_position st (on_named named position between) (on_named named (zeros s) (shift st)) in
  let second := move_to s Rapid Reference true None there (vector (length_of st)) in
  let kept := map2 (fun here x => if here : bool then Some (fst x) else snd x) named (combine between (intermediate st)) in
  (State (modes_of there) (feed there) (coordinates_of there) (programmed there) (shift there) (length_of there)
     (shared there) (offsets_of there) kept, [first; second]).

(** fanuc.program.return-from-reference: through the intermediate point of the last reference return to the commanded
    point, both in rapid traverse.
    fanuc.program.return-incremental: under G91 the words count from the intermediate point.
    fanuc.program.return-without-intermediate: an axis without one has its current position for one. *)
Definition return_from_reference {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (st : state num) :
    state num * list (event num) :=
  let named := which numbers in
  let between := on_named named (replace (programmed st) (intermediate st)) (programmed st) in
  let st := at_position st between (shift st) in
  let first := move_to s Rapid Programmed false None st (vector (length_of st)) in
  let st := at_position st (destination (incremental (modes_of st)) between numbers) (shift st) in
  (st, [first; move_to s Rapid Programmed false None st (vector (length_of st))]).

(** * Arcs *)

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

(** fanuc.program.arc-radius-wins: where R and I J K are both given, R counts.
    fanuc.program.arc-without-center: without both of them PS0023. *)
Definition arc_between {num} {N : Numbers num} (s : setup num) (m : modes) (b : block num) (from to : pair num) :
    outcome (circle num) :=
  let number letter := last_number s (in_inches m) letter b in
  let clockwise := match motion m with Clockwise => true | _ => false end in
  let '(i, j) := center_letters (in_plane m) in
  match number Letter.R with
  | Some r => by_radius clockwise r from to
  | None =>
      if existsb (fun letter => given (number letter)) [Letter.I; Letter.J; Letter.K]
      then by_center clockwise (or_else (number i) 0%num, or_else (number j) 0%num) from to
      else Alarm "PS0023"
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

(** * Measurement *)

(** fanuc.length-measurement.moves: the rapid part is a rapid move of cause programmed, the measuring part a linear one of
    cause measure; both carry the commanded coordinate in `programmed`. A block that would have neither makes the rapid
    move without travel.
    fanuc.length-measurement.coordinate: the signal's position is that of the axis; less length offset and shift it is a
    programmed coordinate.
    fanuc.length-measurement.feed: the second move carries 6241, or F where the setup does not give it.
    fanuc.length-measurement.position-after: the programmed position is then the one reached.
    fanuc.length-measurement.moves-before-the-alarm: PS0080 comes behind the moves, and the value is not changed. *)
Definition measurement {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (st : state num) :
    outcome (state num * list (event num) * option string * option (writing num)) :=
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
    Moves (Move t c (standing d) point (sum point (vector l)) None None (feed_for t f)) in
  let feed_of_part := match parameter s "6241" with Some f => Some f | None => feed st end in
  let first := match rapid_to path, measuring_to path with
               | Some b, _ => [part Rapid Programmed b None]
               | None, None => [part Rapid Programmed a None]
               | None, Some _ => []
               end in
  let second := match measuring_to path with Some x => [part Linear Measuring x feed_of_part] | None => [] end in
  let st := at_position st (standing (reached path)) (shift st) in
  Got (st, first ++ second, if in_zone path then None else Some "PS0080",
       if in_zone path then Some (measured s (offsets_of st) (number_in_force l) (reached path - d)%num) else None).

(** * A block *)

Definition is_shift (code : option action) : bool :=
  match code with Some Lengthen | Some Shorten | Some LengthenTwice | Some ShortenTwice => true | _ => false end.

(** No path belongs to these. *)
Definition stays (code : option action) : bool :=
  match code with Some Dwell | Some DataInput | Some LocalSystem | Some SetPosition => true | _ => false end.
(** The words of these are theirs, not positions. *)
Definition renames (code : option action) : bool :=
  match code with Some LocalSystem | Some SetPosition => true | _ => false end.
(** They send the axes that they name elsewhere. *)
Definition goes_to_machine_position (code : option action) : bool :=
  match code with
  | Some MachinePosition | Some FirstReference | Some OtherReference | Some FloatingReference => true
  | _ => false
  end.

(** A block without a code that sends axes elsewhere: its own move.
    fanuc.program.own-move, fanuc.length-offset.move-without-axis-word: without an axis word only where the offset
    changes. *)
Definition own_move {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (b : block num)
    (circle_of : option (circle num)) (changed : bool) (longer : option num) (st : state num) :
    outcome (state num * list (event num)) :=
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
          _ <- alarm_if (given (last_word Letter.R (words b))) "G45_ARC" ;;
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

(** Whether two offsets differ on some axis. *)
Definition differs {num} {N : Numbers num} (a b : values num) : outcome bool :=
  equal <- each (is_zero "fanuc.length-offset.move-without-axis-word") (difference a b) ;;
  Got (existsb negb equal).

(** What G10 writes: "H3" in memory A, else "H3.geometry" or "D2.wear"; of two tables that of H. *)
Definition setting {num} (number : Z -> string) (s : setup num) (w : writing num) : event num :=
  let letter := match of_address w with ByH => "H" | ByD => "D" end in
  let part := match memory s, of_wear w with MemoryA, _ => "" | _, true => ".wear" | _, false => ".geometry" end in
  Setting (letter ++ number (at_number w) ++ part)%string (match of_address w with ByH => for_h w | ByD => for_d w end).

(** What a block yields: the state behind it, events, and the alarm that its motion ends in. *)
Record ran (num : Type) := Ran { behind : state num; yields : list (event num); ends_in : option string }.
Arguments Ran {num}. Arguments behind {num}. Arguments yields {num}. Arguments ends_in {num}.

(** fanuc.program.alarm-order: in the order of these steps. *)
Definition step {num} {N : Numbers num} (decimal : Z -> string) (s : setup num) (b : block num) (st : state num) :
    outcome (ran num) :=
  _ <- match unreadable b with Some number => Alarm number | None => Got tt end ;;
  match codes_of b with
  | None => Alarm "PS0010"
  | Some codes =>
    let code := action_of codes in
    let m := select codes (modes_of st) in
    let l := whole_word Letter.L b in
    let input := match code with Some DataInput => true | _ => false end in
    let origins := input && among (or_else l 0) [2; 20] in
    let into := if input then store s l else None in
    _ <- (if existsb (fun c => among c beyond) codes then Beyond "a code of another section" else Got tt) ;;
    _ <- alarm_if (input && negb origins && negb (given into)) "PS0010" ;;
    h <- offset_number s Letter.H b ;;
    d <- offset_number s Letter.D b ;;
    c <- select_system codes b (coordinates_of st) ;;
    let all_numbers := axis_numbers s (in_inches m) b in
    let letters_are_data := takes_letters codes in
    let data := letters_are_data || renames code in
    let ignored := match code with Some MachinePosition => incremental m | _ => false end in
    let no_numbers := map (fun _ => None) (axes s) in
    let numbers := if data || ignored then no_numbers else all_numbers in
    (* The words of G52 and G92 move nothing, and name axes as others do. *)
    let naming := if letters_are_data || ignored then no_numbers else all_numbers in
    let position := renamed s (coordinates_of st) c (programmed st) in
    let command := LengthCommand (length_code_of codes) h (in_plane m) (which naming)
                     (match words b with [] => false | _ => true end) (among 400 codes)
                     (if goes_to_machine_position code then which numbers else no_axes s) in
    let measures := match code with Some Measure => true | _ => false end in
    _ <- (if measures then measurement_words s m command (length_of st) else Got tt) ;;
    c' <- (if origins then with_origin s (incremental m) (or_else l 0) b all_numbers c else Got c) ;;
    writing <- match into with Some store => written s m (offsets_of st) b store | None => Got None end ;;
    target <- (if empty (which numbers) then Got None else reference_position s code b) ;;
    let position := renamed s c c' position in
    let st := State m (next_feed s m b (feed st)) c' position (shift st) (length_of st)
                (next_shared s d h (shared st)) (offsets_of st) (intermediate st) in
    let named := which numbers in
    let to_machine := goes_to_machine_position code in
    let elsewhere := to_machine || match code with Some ReturnFromReference | Some Measure => true | _ => false end in
    let to := destination (incremental m) position numbers in
    circle_of <-
      (if negb (elsewhere || stays code) && runs_arc m s numbers letters_are_data b
       then c <- arc_between s m b (in_plane_of s (in_plane m) position) (in_plane_of s (in_plane m) to) ;; Got (Some c)
       else Got None) ;;
    (* G45 to G48. *)
    let offset_mode := match length_code_of codes with
                       | Some G49 => false | Some _ => true | None => given (in_force (length_of st)) end in
    _ <- alarm_if (is_shift code && by_h_number s && offset_mode) "G45_LENGTH_OFFSET" ;;
    longer <-
      (if is_shift code && (negb (empty named) || given circle_of) then
         let '(by_, number) :=
           if by_h_number s
           then (ByH, or_else (new_number s command (length_of st)) (number_in_force (length_of st)))
           else shared st in
         x <- applied s by_ (offsets_of st) number ;;
         Got (lengthening code x)
       else Got None) ;;
    (* The alarms of the arc of G45 to G48 come before those of the length offset. *)
    _ <- own_move s numbers b circle_of false longer st ;;
    '(on_way, at_end) <- length_step s (offsets_of st) command (length_of st) ;;
    changed <- differs (vector at_end) (vector (length_of st)) ;;
    let st := State (modes_of st) (feed st) (coordinates_of st) (programmed st) (shift st) at_end (shared st)
                (offsets_of st) (intermediate st) in
    let as_moved x := '(st, moves) <- x ;; Got (st, moves, None, writing) in
    '(st, moves, alarm, writing) <-
      match code, negb (empty named), target with
      | Some MachinePosition, true, _ => as_moved (Got (machine_coordinates s numbers st))
      | _, true, Some t => as_moved (Got (reference_return s t numbers on_way st))
      | Some ReturnFromReference, true, _ => as_moved (Got (return_from_reference s numbers st))
      | Some Measure, _, _ => measurement s numbers st
      | _, _, _ => as_moved (own_move s numbers b circle_of changed longer st)
      end ;;
    (* G52, G92 and G10 count behind the block. *)
    let coordinates_behind := match code with
      | Some LocalSystem => with_local all_numbers (coordinates_of st)
      | Some SetPosition => with_shift s all_numbers (programmed st) (coordinates_of st)
      | _ => coordinates_of st
      end in
    let offsets_behind := match writing with Some w => write s w (offsets_of st) | None => offsets_of st end in
    let settings := match writing with Some w => [setting decimal s w] | None => [] end in
    Got (Ran (State (modes_of st) (feed st) coordinates_behind (renamed s (coordinates_of st) coordinates_behind (programmed st))
                (shift st) (length_of st) (shared st) offsets_behind (intermediate st))
           (moves ++ settings) alarm)
  end.

(** fanuc.program.end: M02 and M30 end the program after their block. *)
Definition ends {num} (b : block num) : bool :=
  existsb (fun w => match address w with
                    | Letter.M => match tenths w with Some t => among t [20; 300] | None => false end
                    | _ => false
                    end) (words b).

(** Events with the place of their block; what this text does not say, and where. *)
Inductive run_end := Ended | NotSaid (what : string).

Fixpoint run {num} {N : Numbers num} (decimal : Z -> string) (s : setup num) (bs : list (block num)) (place : nat)
    (st : state num) : list (nat * event num) * run_end :=
  match bs with
  | [] => ([], Ended)
  | b :: rest =>
      match step decimal s b st with
      | Got r =>
          let here := map (fun e => (place, e)) (yields r) in
          match ends_in r with
          | Some number => (here ++ [(place, Raised number)], Ended)
          | None =>
              if ends b then (here, Ended)
              else let '(later, how) := run decimal s rest (S place) (behind r) in (here ++ later, how)
          end
      | Alarm number => ([(place, Raised number)], Ended)
      | Undecided clause => ([(place, NotDecided clause)], Ended)
      | Beyond what => ([], NotSaid what)
      end
  end.

Definition run_program {num} {N : Numbers num} decimal (s : setup num) (bs : list (block num)) :=
  run decimal s bs 0%nat (initial s).
