(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool center point control of type 2: which of the pairs of a direction, and which whole turns. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Angles ControlState State Space Pose.
From Toolcomp Require Import ControlFrame ControlWords InverseKinematics.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Ranges *)

Definition range (num : Type) := option (angle num * angle num).
(** The ranges of the first and of the second axis. *)
Definition ranges {num} {N : Numbers num} (s : setup num) : outcome (range num * range num) :=
  '(first, second) <- limits_of_axes s ;;
  let told (limits : option (num * num)) : range num :=
    option_map (fun l => (angle_of_degrees (fst l), angle_of_degrees (snd l))) limits in
  Got (told first, told second).

Definition range_clause := "fanuc.tool-center-point.range".

(** fanuc.tool-center-point.range: a position counts only if it is in the range of its axis; the limits are in range. *)
Definition not_above {num} {N : Numbers num} (r : range num) (x : angle num) : outcome bool :=
  match r with
  | Some (_, upper) => c <- compare_angles range_clause x upper ;; Got (match c with Gt => false | _ => true end)
  | None => Got true
  end.
Definition not_below {num} {N : Numbers num} (r : range num) (x : angle num) : outcome bool :=
  match r with
  | Some (lower, _) => c <- compare_angles range_clause x lower ;; Got (match c with Lt => false | _ => true end)
  | None => Got true
  end.
Definition in_range {num} {N : Numbers num} (r : range num) (x : angle num) : outcome bool :=
  below <- not_above r x ;; above <- not_below r x ;; Got (below && above).

(** The position, or the nearest limit where it is outside. *)
Definition nearest_in_range {num} {N : Numbers num} (r : range num) (x : angle num) : outcome (angle num) :=
  match r with
  | Some (lower, upper) =>
      fine_above <- not_above r x ;;
      fine_below <- not_below r x ;;
      if fine_below : bool then if fine_above : bool then Got x else with_turns range_clause upper
      else with_turns range_clause lower
  | None => Got x
  end.

(** * Candidates of an axis *)

(** A position and how far it is from the present one. *)
Record candidate (num : Type) := Candidate { goes_to : angle num; half_turns : Z; cosine_of_move : num }.
Arguments Candidate {num}. Arguments goes_to {num}. Arguments half_turns {num}. Arguments cosine_of_move {num}.

(** fanuc.tool-center-point.choice-first-move: the moving angle of a position above or below the present one. *)
Definition moving_to {num} {N : Numbers num} (clause : string) (now to : angle num) : outcome (candidate num) :=
  up <- compare_angles clause to now ;;
  m <- (match up with Lt => angle_between_positions clause now to | _ => angle_between_positions clause to now end) ;;
  count <- turns_of clause m ;;
  first <- in_first_half clause m ;;
  Got (Candidate to (2 * count + (if first : bool then 0 else 1)) (cosine_of m)).

(** Which of two moves less: by half turns, then by cosines, which fall in the first half of a turn and rise in the
    second. *)
Definition compare_moves {num} {N : Numbers num} (clause : string) (a b : candidate num) : outcome comparison :=
  match Z.compare (half_turns a) (half_turns b) with
  | Eq =>
      let more := (cosine_of_move a - cosine_of_move b)%num in
      decide clause (if Z.even (half_turns a) then (- more)%num else more)
  | c => Got c
  end.

(** The position of one turn that is the first from another on, up or down. *)
Definition first_up {num} {N : Numbers num} (clause : string) (from one_turn : angle num) : outcome (angle num) :=
  count <- turns_of clause from ;;
  below <- compare_rest clause one_turn from ;;
  Got (turned_on (match below with Lt => count + 1 | _ => count end) one_turn).
Definition first_down {num} {N : Numbers num} (clause : string) (from one_turn : angle num) : outcome (angle num) :=
  count <- turns_of clause from ;;
  below <- compare_rest clause one_turn from ;;
  Got (turned_on (match below with Gt => count - 1 | _ => count end) one_turn).

(** The positions of one turn that are nearest to the present one, over at most a half turn: two where they lie just a half
    turn away. Where the axis would not move at all that may be known by its number alone. *)
Definition nearest_candidates {num} {N : Numbers num} (clause : string) (now one_turn : angle num) :
    outcome (list (candidate num)) :=
  let c := cosine_between one_turn now in
  behind <- is_negative clause c ;;
  half <- (if behind : bool then is_zero clause (sine_between one_turn now) else Got false) ;;
  if half : bool then
    up <- first_up clause now one_turn ;;
    Got [Candidate up 0 c; Candidate (turned_on (-1) up) 0 c]
  else
    count <- whole_turns clause (degrees now - degrees one_turn + integer 180)%num ;;
    Got [Candidate (turned_on count one_turn) 0 c].

(** Up and down from the present position, as far as the range goes. *)
Definition candidates_in_range {num} {N : Numbers num} (clause : string) (r : range num) (now one_turn : angle num) :
    outcome (list (candidate num)) :=
  from_up <- match r with
             | Some (lower, _) =>
                 fine <- not_below r now ;; if fine : bool then Got now else with_turns range_clause lower
             | None => Got now
             end ;;
  from_down <- match r with
               | Some (_, upper) =>
                   fine <- not_above r now ;; if fine : bool then Got now else with_turns range_clause upper
               | None => Got now
               end ;;
  up <- first_up clause from_up one_turn ;;
  down <- first_down clause from_down one_turn ;;
  up_fine <- not_above r up ;;
  down_fine <- not_below r down ;;
  each (moving_to clause now) ((if up_fine : bool then [up] else []) ++ (if down_fine : bool then [down] else [])).

(** The nearest ones where they are in range, else those that are. *)
Definition candidates {num} {N : Numbers num} (clause : string) (r : range num) (now one_turn : angle num) :
    outcome (list (candidate num)) :=
  nearest <- nearest_candidates clause now one_turn ;;
  fine <- each (fun c => fine <- in_range r (goes_to c) ;; Got (c, fine)) nearest ;;
  match filter snd fine with
  | [] => candidates_in_range clause r now one_turn
  | inside => Got (map fst inside)
  end.

(** * The choice *)

(** Those than which no other is better. *)
Fixpoint best_of {A} (better : A -> A -> outcome comparison) (kept rest : list A) : outcome (list A) :=
  match rest with
  | [] => Got kept
  | x :: rest =>
      c <- match kept with [] => Got Lt | best :: _ => better x best end ;;
      best_of better (match c with Lt => [x] | Eq => kept ++ [x] | Gt => kept end) rest
  end.

(** fanuc.tool-center-point.choice-order: on tool rotation and table rotation machines the first axis is judged first,
    on the mixed type the second; 19608#5 reverses the order. *)
Definition judges_second_first {num} (s : setup num) (k : kinematics num) : bool :=
  xorb (match machine_of k with Mixed => true | _ => false end) (bit s "19608#5").

(** Where an axis may go: to the positions of one turn, or to one alone. *)
Inductive axis_aim (num : Type) := AnyTurn (one_turn : angle num) | Alone (position : angle num).
Arguments AnyTurn {num} one_turn.
Arguments Alone {num} position.

(** How far: without a range the nearest turn is what counts, and which it is does not matter yet. *)
Definition moves_to {num} {N : Numbers num} (clause : string) (r : range num) (now : angle num) (aim : axis_aim num) :
    outcome (list (candidate num)) :=
  match aim, r with
  | Alone position, _ => c <- moving_to clause now position ;; Got [c]
  | AnyTurn one_turn, Some _ => candidates clause r now one_turn
  | AnyTurn one_turn, None => Got [Candidate one_turn 0 (cosine_between one_turn now)]
  end.
(** The positions of such a candidate. *)
Definition positions_of {num} {N : Numbers num} (clause : string) (r : range num) (now : angle num) (aim : axis_aim num)
    (c : candidate num) : outcome (list (angle num)) :=
  match aim, r with
  | AnyTurn one_turn, None => found <- nearest_candidates clause now one_turn ;; Got (map goes_to found)
  | _, _ => Got [goes_to c]
  end.

(** fanuc.tool-center-point.choice: each step keeps only the best candidates: the smallest moving angle of the axis
    judged first; then that of the other axis; then the axis judged first nearest to 0; then the other axis nearest
    to 0.
    fanuc.tool-center-point.choice-tie: then the greater position of the axis judged first, then of the other one.
    Of pairs, the axis judged first and the other. fanuc.tool-center-point.range-none: none raises PS5459. *)
Definition chosen {num} {N : Numbers num} (ranges now : _ * _) (pairs : list (axis_aim num * axis_aim num)) :
    outcome (angle num * angle num) :=
  let first_clause := "fanuc.tool-center-point.choice-first-move" in
  let second_clause := "fanuc.tool-center-point.choice-second-move" in
  firsts <- each
    (fun pair =>
      firsts <- moves_to first_clause (fst ranges) (fst now) (fst pair) ;;
      seconds <- match snd ranges with
                 | Some _ => moves_to second_clause (snd ranges) (snd now) (snd pair)
                 | None => Got [Candidate (snd now) 0 0%num]
                 end ;;
      Got (match seconds with [] => [] | _ => map (fun c => (c, pair)) firsts end))
    pairs ;;
  left <- best_of (fun a b => compare_moves first_clause (fst a) (fst b)) [] (List.concat firsts) ;;
  both <- each
    (fun c =>
      positions <- positions_of first_clause (fst ranges) (fst now) (fst (snd c)) (fst c) ;;
      seconds <- moves_to second_clause (snd ranges) (snd now) (snd (snd c)) ;;
      Got (flat_map (fun first => map (fun second => (first, (second, snd (snd c)))) seconds) positions))
    left ;;
  left <- best_of (fun a b => compare_moves second_clause (fst (snd a)) (fst (snd b))) [] (List.concat both) ;;
  both <- each
    (fun c =>
      positions <- positions_of second_clause (snd ranges) (snd now) (snd (snd c)) (fst (snd c)) ;;
      Got (map (fun second => (fst c, second)) positions))
    left ;;
  let nearer clause x y := decide clause (cosine_of y - cosine_of x)%num in
  let greater x y := compare_angles "fanuc.tool-center-point.choice-tie" y x in
  left <- best_of (fun a b => nearer "fanuc.tool-center-point.choice-first-near-zero" (fst a) (fst b)) [] (List.concat both) ;;
  left <- best_of (fun a b => nearer "fanuc.tool-center-point.choice-second-near-zero" (snd a) (snd b)) [] left ;;
  left <- best_of (fun a b => greater (fst a) (fst b)) [] left ;;
  left <- best_of (fun a b => greater (snd a) (snd b)) [] left ;;
  match left with
  | [] => Alarm "unreachable"
  | best :: _ => Got best
  end.

(** Whether two directions are equal. *)
Definition same_direction {num} {N : Numbers num} (clause : string) (a b : triple num) : outcome bool :=
  if known_same3 a b then Got true
  else
    let n := cross3 a b in
    parallel <- is_zero clause (dot3 n n) ;;
    if parallel : bool then is_positive clause (dot3 a b) else Got false.

(** The pair of a direction, from the present pose, which gives another one; both as the work-side axis has them, and the
    first as seen from the zero pose of the table too.
    fanuc.tool-center-point.parallel-to-the-work-side: if V is parallel to u_w, the work-side axis keeps its position,
    or goes to the nearest limit of its range if that position is outside.
    fanuc.tool-center-point.choice: if the direction equals the present one and the present position is in range, the
    axes stay. *)
Definition choose {num} {N : Numbers num} (s : setup num) (k : kinematics num) (now : pose num)
    (now_direction v from_zero_pose : triple num) : outcome (pose num) :=
  '(first_range, second_range) <- ranges s ;;
  equal <- same_direction "fanuc.tool-center-point.choice" now_direction v ;;
  stays <- (if equal : bool then
              first_fine <- in_range first_range (fst now) ;;
              second_fine <- in_range second_range (snd now) ;;
              Got (first_fine && second_fine)
            else Got false) ;;
  if stays : bool then Got now
  else
    let second_first := judges_second_first s k in
    let ordered {A} (p : A * A) := if second_first then (snd p, fst p) else p in
    let as_pose {A} (p : A * A) := match machine_of k with ToolRotation => (snd p, fst p) | _ => p end in
    parallel <- parallel_to_work_axis k v ;;
    pairs <-
      match parallel with
      | Some opposite =>
          reached <- reaches_work_axis k opposite ;;
          _ <- alarm_if (negb reached) "unreachable" ;;
          tau <- singular_position k opposite ;;
          let work_range := match machine_of k with ToolRotation => first_range | _ => second_range end in
          kept <- nearest_in_range work_range (snd (sides_of k now)) ;;
          Got [(AnyTurn tau, Alone kept)]
      | None =>
          found <- pairs_of k v from_zero_pose ;;
          Got (map (fun pair => (AnyTurn (fst pair), AnyTurn (snd pair))) found)
      end ;;
    best <- chosen (ordered (first_range, second_range)) (ordered now) (map (fun pair => ordered (as_pose pair)) pairs) ;;
    Got (ordered best).
