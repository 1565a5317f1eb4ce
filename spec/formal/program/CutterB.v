(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/cutter-compensation-b: every block by itself, from head to head. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners LengthOffset.
From Toolcomp Require Import CutterState State Movements CutterRules CutterMoves.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * G39 *)

(** fanuc.cutter-b.corner-arc-direction: that of I J K, else that of the axis words: in G91 as written, in G90 from the
    programmed position to the point named. *)
Definition corner_direction {num} {N : Numbers num} (s : setup num) (c : command num) (position : values num) :
    option (pair num) :=
  let p := in_plane (in_modes c) in
  let '(first, second) := plane_axes p in
  let word letter := or_else (find_named (the_axis s letter) (naming_words c)) None in
  let from letter := if incremental (in_modes c) then 0%num else value_on s position letter in
  let part letter := match word letter with Some x => (x - from letter)%num | None => 0%num end in
  match plane_letters s c, word first, word second with
  | Some d, _, _ => Some d
  | None, None, None => None
  | None, _, _ => Some (part first, part second)
  end.

(** fanuc.cutter-b.corner-arc-format: PS0035 before a vector has been made, with G40, G41, G42 or another number, with an
    axis word outside the plane, with a direction that is zero or missing. *)
Definition corner_arc_alarm {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  let outside := without (which (naming_words c)) (plane_axis_set s (in_plane (in_modes c))) in
  let made := given (hand_in_force (cutter st)) && match in_phase (cutter st) with Running => true | _ => false end in
  _ <- alarm_if (negb made || says_cancel c || says_hand c || gives_other_number s c (shared st) ||
                 negb (empty outside)) "corner-arc" ;;
  system <- select_system (codes_said c) (block_of c) (coordinates_of st) ;;
  match corner_direction s c (renamed s (coordinates_of st) system (programmed st)) with
  | None => Alarm "corner-arc"
  | Some d => nothing <- is_zero "fanuc.cutter-b.corner-arc-format" (square2 d) ;; alarm_if nothing "corner-arc"
  end.

(** * Alarms *)

(** fanuc.cutter-b.arc-with-code, fanuc.cutter-b.arc-with-number, fanuc.cutter-b.arc-at-start-up: PS0034.
    fanuc.cutter-b.arc-at-cancel: while the vector is not zero. *)
Definition arc_alarm_b {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  let x := cutter st in
  _ <- alarm_if (says_hand c) "arc-at-start-or-cancel" ;;
  match hand_behind c (hand_in_force x) with
  | Some _ =>
      alarm_if (gives_other_number s c (shared st) || match in_phase x with Running => false | _ => true end) "arc-at-start-or-cancel"
  | None =>
      nothing <- is_zero "fanuc.cutter-b.arc-at-cancel" (square2 (vector_behind x)) ;;
      alarm_if (negb nothing) "arc-at-start-or-cancel"
  end.

(** By words and state, in the order of fanuc.cutter.order-of-alarms. *)
Definition alarms_b {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  _ <- (if is_corner_arc c then corner_arc_alarm s c st else Got tt) ;;
  if is_arc_block s c then arc_alarm_b s c st else Got tt.

(** * Vectors *)

(** fanuc.cutter-b.vector: at right angles to a direction: of I J K where the block has them, else of its travel.
    fanuc.cutter-b.direction-words: a missing letter is 0.
    fanuc.cutter-b.direction-zero, fanuc.cutter-b.no-travel: none is made where that direction is zero. *)
Definition straight_vector {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num)
    (rho : num) : outcome (option (pair num)) :=
  let letters := plane_letters s c in
  let clause := if given letters then "fanuc.cutter-b.direction-zero" else "fanuc.cutter-b.no-travel" in
  let u := or_else letters (travel_in_plane s c before after) in
  nothing <- is_zero clause (square2 u) ;;
  Got (if nothing : bool then None else Some (perpendicular (line_leg u rho))).

(** fanuc.cutter-b.arc-vector: on the line of centre and end.
    fanuc.cutter-b.arc-ends-in-center: PS0038. *)
Definition arc_vector {num} {N : Numbers num} (s : setup num) (clockwise : bool) (a : arc num) (after : state num)
    (rho : num) : outcome (pair num) :=
  let to_center := sub2 (center a) (plane_point s (arc_plane a) after) in
  nothing <- is_zero "fanuc.cutter-b.arc-ends-in-center" (square2 to_center) ;;
  _ <- alarm_if nothing "arc-ends-in-center" ;;
  Got (perpendicular (arc_leg (Bow clockwise to_center) rho)).

(** The vector behind the block in the mode, and whether a start-up has been made.
    fanuc.cutter-b.machine-position: G28, G29, G30, G30.1 and G53 that name an axis of the plane take it away.
    fanuc.cutter-b.start-up: the first vector made is the start-up.
    fanuc.cutter-b.kept: a block without an axis word of the plane that is no arc keeps it.
    fanuc.cutter-b.number-zero, fanuc.cutter-b.switch, fanuc.cutter-b.number-changed: number and side count for the
    vectors made in the block and behind it. *)
Definition vector_b {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num)
    (moves : list (movement num)) (rho : num) : outcome (pair num * phase) :=
  let x := cutter before in
  let kept := (vector_behind x, in_phase x) in
  if goes_away c then Got (if names_plane s c then (zero2, Off) else kept)
  else if is_corner_arc c then
    match corner_direction s c (programmed before) with
    | Some u => Got (perpendicular (line_leg u rho), Running)
    | None => Got kept
    end
  else
    match arc_run moves with
    | Some (clockwise, a) => v <- arc_vector s clockwise a after rho ;; Got (v, Running)
    | None =>
        if names_plane s c then
          made <- straight_vector s c before after rho ;;
          Got (match made with Some v => (v, Running) | None => kept end)
        else Got kept
    end.

(** fanuc.cutter-b.mode: on from the block with G41 or G42 to the one with G40.
    fanuc.cutter-b.cancel, fanuc.cutter-b.cancel-alone: G40 removes the vector at once. *)
Definition behind_b {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num)
    (moves : list (movement num)) : outcome (cutter_state num) :=
  let h := hand_behind c (hand_in_force (cutter before)) in
  let value := value_behind s c before in
  '(v, stands) <- match h with
                  | None => Got (zero2, Off)
                  | Some hand => vector_b s c before after moves (to_the_left hand value)
                  end ;;
  Got (CutterState h value stands v 0%num true (Idle 1)).

(** * Moves *)

(** fanuc.cutter-b.corner-arc: from the old head to the new one about the programmed point.
    fanuc.cutter-b.corner-arc-sense: clockwise where the offset to the left is positive.
    fanuc.cutter-b.corner-arc-none: no move where the vectors are equal. *)
Definition corner_arc_b {num} {N : Numbers num} (s : setup num) (p : plane) (b : planned num) (v w : pair num) :
    outcome (list (item num)) :=
  let x := cutter (behind b) in
  same_first <- is_zero "fanuc.cutter-b.corner-arc-none" (fst w - fst v)%num ;;
  same_second <- is_zero "fanuc.cutter-b.corner-arc-none" (snd w - snd v)%num ;;
  if same_first && same_second then
    Got (at_head s p v (items b))
  else
    clockwise <- match hand_in_force x with
                 | Some h => is_positive "fanuc.cutter-b.corner-arc-sense" (to_the_left h (value_in_force x))
                 | None => Got false
                 end ;;
    let corner := plane_point s p (behind b) in
    a <- arc_of_heads p clockwise corner (add2 corner v) (add2 corner w) ;;
    let t := if clockwise : bool then Clockwise else Counterclockwise in
    Got (Go (move_at s t Corner p w (Some a) (behind b)) :: still (items b)).

(** fanuc.cutter-b.start-up, fanuc.cutter-b.cancel: the cause of the own move, that of a full circle too.
    fanuc.cutter-b.machine-position: the causes of those of G53, G28, G29 and G30 stay theirs. *)
Definition cause_b {num} (s : setup num) (b : planned num) : cause :=
  let made := match in_phase (cutter (before b)) with Running => true | _ => false end in
  let makes := match in_phase (cutter (behind b)) with Running => true | _ => false end in
  let cancels := negb (given (hand_in_force (cutter (behind b)))) in
  if goes_away (command_of b) then Programmed
  else if negb made && makes then StartUp
  else if made && cancels && (has_axis_word (command_of b) || is_arc_block s (command_of b)) then Cancelling
  else Programmed.

(** fanuc.cutter-b.head-to-head: a block goes from the old head to the new one.
    fanuc.cutter-b.arc-inside: nothing is checked.
    fanuc.cutter-b.cancel-alone: G40 in a block without an axis word moves the tool back by the vector, the length offset
    along with it. fanuc.cutter-b.coordinate-systems: with G52 or G92 in the coordinates after the renaming. *)
Definition items_b {num} {N : Numbers num} (s : setup num) (b : planned num) : outcome (list (item num)) :=
  let c := command_of b in
  let p := in_plane (in_modes c) in
  let v := vector_behind (cutter (before b)) in
  let w := vector_behind (cutter (behind b)) in
  let on x := given (hand_in_force (cutter x)) in
  if negb (on (before b)) && negb (on (behind b)) then Got (items b)
  else if is_corner_arc c then corner_arc_b s p b v w
  else
    nothing <- is_zero "fanuc.cutter-b.cancel-alone" (square2 v) ;;
    if negb (on (behind b)) && negb (has_axis_word c) && negb nothing then
      Got (Go (move_at s (straight (motion (in_modes c))) Cancelling p zero2 None (behind b)) :: still (items b))
    else own_move_between s p b (cause_b s b) v w.

(** fanuc.cutter-b.no-look-ahead: a block is compensated by itself. *)
Fixpoint compensated_b {num} {N : Numbers num} (s : setup num) (bs : list (planned num)) :
    list (planned num) + (nat * ending) :=
  match bs with
  | [] => inl []
  | b :: rest =>
      match items_b s b, compensated_b s rest with
      | Got new, inl later => inl (with_items b new :: later)
      | Got _, inr ended => inr ended
      | stopped, _ => inr (at_place b, ends_in (at_place b) stopped)
      end
  end.
Definition pass_b {num} {N : Numbers num} (s : setup num) (p : plan num) : passed num :=
  match compensated_b s (fst p) with
  | inl bs => Through (bs, snd p)
  | inr (place, how) => AsIfAbsent place how
  end.
