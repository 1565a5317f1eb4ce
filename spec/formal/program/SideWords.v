(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-side-compensation: what the words of a block do to it, and their alarms. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ToolShift SideState State.
From Toolcomp Require Import Space Pose Movements OwnMove ControlWords SidePlane.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Commands *)

(** fanuc.tool-side.commands: G41.2 is on the left, G42.2 on the right; G41.6 and G42.6 mean the same. *)
Definition side_of_code (code : Z) : option hand_of_tool :=
  if among code [412; 416] then Some ToolLeft else if among code [422; 426] then Some ToolRight else None.

(** The code of the group in a block. *)
Definition compensation_said {num} (c : command num) : option Z := last_of compensations (codes_said c).
Definition side_behind_words {num} (c : command num) (before : option hand_of_tool) : option hand_of_tool :=
  match compensation_said c with Some code => side_of_code code | None => before end.

Definition same_side (a b : option hand_of_tool) : bool :=
  match a, b with
  | Some ToolLeft, Some ToolLeft | Some ToolRight, Some ToolRight => true
  | _, _ => false
  end.
(** fanuc.tool-side.repeated: a word equal to the code in force before it. *)
Definition repeats_code {num} (c : command num) (before : side_state num) : bool :=
  match compensation_said c with
  | Some code => same_side (side_of_code code) (side_in_force before)
  | None => false
  end.

(** fanuc.cutter.number: the last D; with OFH = 1 an H gives it as well. *)
Definition number_behind {num} (s : setup num) (c : command num) (st : state num) : shared_number :=
  next_shared s (d_number c) (h_number c) (shared st).

(** fanuc.cutter.value-edited: the value is read where the number is given, where a code comes into force after G40, and
    with EVR = 1 in every block. *)
Definition reads_side_value {num} (s : setup num) (c : command num) (before : side_state num) : bool :=
  given (d_number c) || (ofh s && given (h_number c)) || bit s "5001#4" ||
  (given (side_behind_words c (side_in_force before)) && negb (given (side_in_force before))).

Definition side_value_behind {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : num :=
  if reads_side_value s c (side st) then
    let '(by_, number) := number_behind s c st in
    let '(geometry, wear) := entry_of by_ (offsets_of st) number in
    (geometry + wear)%num
  else side_value (side st).

(** fanuc.tool-side.number: number 0 acts as G40. *)
Definition asked_behind {num} (s : setup num) (c : command num) (st : state num) : bool :=
  given (side_behind_words c (side_in_force (side st))) && negb (snd (number_behind s c st) =? 0).

(** fanuc.tool-side.on: before a block; after it a code with a number other than 0 is in force. *)
Definition side_on {num} (x : side_state num) : bool := asked x || made x.

(** fanuc.tool-side.type-c, fanuc.tool-side.type-b: SUV = 1 is type C, else SUP chooses A or B. *)
Definition makes_at_once {num} (s : setup num) : bool := bit s "5003#1".
Definition with_tangents {num} (s : setup num) : bool := bit s "5003#0".

(** A block of type C that makes or removes the vector. *)
Definition makes_vector {num} (s : setup num) (c : command num) (st : state num) : bool :=
  makes_at_once s && asked_behind s c st && negb (made (side st)).
Definition removes_vector {num} (s : setup num) (c : command num) (st : state num) : bool :=
  makes_at_once s && negb (asked_behind s c st) && made (side st).

(** * Alarms *)

Definition in_arc {num} (c : command num) : bool :=
  match motion (in_modes c) with Clockwise | Counterclockwise => true | _ => false end.
(** fanuc.cutter-c.start-or-cancel-in-arc: I J K of a tool direction count too. *)
Definition arc_by_words {num} (s : setup num) (c : command num) : bool :=
  match acting c with
  | None => runs_arc (in_modes c) s (position_words c) (takes_letters (codes_said c)) (block_of c)
  | _ => false
  end.
Definition planes_differ (a b : plane) : bool :=
  match a, b with XY, XY | ZX, ZX | YZ, YZ => false | _, _ => true end.

(** fanuc.tool-side.forbidden, fanuc.tool-side.forbidden-while-a-vector-waits: codes in a block after which compensation
    is on; of group 00 before or after which it is on; of other compensations before which it is on. *)
Definition forbidden_with_side {num} (s : setup num) (c : command num) (on_before on_after moves : bool) : bool :=
  let b := block_of c in
  let has letter := given (last_word letter (words b)) in
  let high_speed := match whole_word Letter.P b with Some p => p =? 10000 | None => false end in
  let says codes := existsb (fun code => among code codes) (codes_said c) in
  (on_after && (says [540; 541; 550; 560; 570; 580; 590; 200; 210; 960; 970; 1600] || (says [50] && negb high_speed) ||
                (moves && existsb has [Letter.M; Letter.S; Letter.T]))) ||
  ((on_before || on_after) &&
   says [40; 100; 280; 290; 300; 301; 370; 390; 450; 460; 470; 480; 520; 530; 920]) ||
  (on_before && match compensation_said c with Some code => among code [410; 420; 413] | None => false end).

(** The alarms that the words and the state before the block raise, in the order of fanuc.program.alarm-order.
    fanuc.tool-side.code-for-the-mode: TOOL_SIDE_MODE.
    fanuc.tool-side.plane-selected: a change of the plane raises PS0037.
    fanuc.tool-side.q-format: Q of another value than 1, 2 or 3.
    fanuc.tool-side.type-c-format: an axis word, G02 or G03, and with a start what stops the look-ahead.
    fanuc.cutter-c.start-or-cancel-in-arc: PS0034.
    fanuc.tool-side.arc-on-mixed-machine: PS5461 on the 30i.
    fanuc.cutter.value-too-large: PS0029. *)
Definition side_alarms {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : outcome unit :=
  let x := side st in
  let b := block_of c in
  let on_before := side_on x in
  let on_after := asked_behind s c st in
  let axis_word := moving_word s c st in
  let arc := arc_by_words s c in
  let makes := makes_vector s c st in
  let removes := removes_vector s c st in
  let q_known := match whole_word Letter.Q b with Some q => (1 <=? q) && (q <=? 3) | None => false end in
  let of_vector := if under_vector c st then [412; 422] else [416; 426] in
  _ <- alarm_if (match compensation_said c with Some code => among code of_vector | None => false end)
         "side-mode" ;;
  _ <- alarm_if (on_before && planes_differ (in_plane (in_modes c)) (in_plane (modes_of st))) "plane-change" ;;
  _ <- alarm_if (forbidden_with_side s c on_before on_after (axis_word || arc)) "forbidden-in-compensation" ;;
  _ <- alarm_if (on_after && given (last_word Letter.Q (words b)) && negb q_known) "treatment" ;;
  _ <- alarm_if ((makes || removes) && (axis_word || in_arc c) || (makes && stops_look_ahead s b)) "type-c-format" ;;
  _ <- alarm_if (negb (makes_at_once s) && negb (Bool.eqb (made x) on_after) && arc) "arc-at-start-or-cancel" ;;
  let mixed := match kinematics_of s with
               | Some k => match machine_of k with Mixed => true | _ => false end
               | None => false
               end in
  _ <- alarm_if (arc && on_after && series_30i s && mixed) "arc-in-compensation" ;;
  if given (side_behind_words c (side_in_force x)) && reads_side_value s c x && negb (snd (number_behind s c st) =? 0)
  then let '(by_, number) := number_behind s c st in _ <- applied s by_ (offsets_of st) number ;; Got tt
  else Got tt.

(** * The state behind a block *)

(** The arc that a block runs. *)
Definition arc_of_moves {num} (moves : list (movement num)) : option (arc num) :=
  match find (fun m => given (circle_of m)) moves with Some m => circle_of m | None => None end.

(** fanuc.cutter.side: a negative value exchanges the codes; 0 counts as positive. *)
Definition is_on_left {num} {N : Numbers num} (code : option hand_of_tool) (value : num) : outcome bool :=
  reversed <- is_negative "fanuc.cutter.side" value ;;
  Got (xorb reversed (match code with Some ToolRight => false | _ => true end)).

(** fanuc.tool-side.side-change-after-start, fanuc.cutter-c.direction-change-at-start-up: neither the first block that
    moves after a start, at its own end or, while its vector is still to be made, at that of the start, nor B of the start
    may change the side.
    What is left of the start behind the block. *)
Definition after_start {num} {N : Numbers num} (s : setup num) (c : command num) (left crosses : bool) (arc : bool)
    (travel : triple num) (start : side_start num) : outcome (option (side_start num)) :=
  let can_follow := if stops_look_ahead s (block_of c) then 0 else may_follow start in
  follows <-
    (if can_follow <=? 0 then Got false
     else if arc then Got true
     else line_crosses s (start_axis start) travel) ;;
  let awaits := awaits_first start && negb crosses in
  _ <- alarm_if ((follows || (awaits_first start && crosses)) && xorb left (starts_left start))
         "side-change-at-start" ;;
  Got (if follows || (negb awaits && (can_follow <=? 1)) then None
       else Some (SideStart (start_axis start) (starts_left start) awaits (can_follow - 1))).

(** fanuc.tool-side.start-up, fanuc.tool-side.start-type-c: types A and B start in the next block that moves, type C in
    the block with which a code and a number other than 0 come into force.
    fanuc.tool-side.cancel, fanuc.tool-side.cancel-without-movement, fanuc.tool-side.cancel-type-c: the vector goes in the
    first block that moves without them, with type C at once; one that is exactly zero at once.
    fanuc.cutter-c.restart-before-removal: a code in force again before that leaves the run undecided.
    fanuc.cutter-c.arc-ends-in-center: PS0038. *)
Definition side_behind {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num)
    (moves : list (movement num)) : outcome (side_state num) :=
  let x := side before in
  let code := side_behind_words c (side_in_force x) in
  let number := snd (number_behind s c before) in
  let value := side_value_behind s c before in
  let asked_now := asked_behind s c before in
  let idle := SideState code number value asked_now false false false true None in
  if negb (asked_now || made x) then Got idle
  else
    _ <- (if made x && negb (asked x) && asked_now then Undecided "fanuc.cutter-c.restart-before-removal" else Got tt) ;;
    let arc := arc_of_moves moves in
    let in_center := match arc with Some a => negb (given (sweep a)) | None => false end in
    _ <- alarm_if (asked_now && in_center) "arc-ends-in-center" ;;
    let travel := sub3 (in_space s (programmed after)) (in_space s (programmed before)) in
    let vt := tool_of s after in
    crosses <- (if given arc then Got true else line_crosses s vt travel) ;;
    left <- is_on_left code value ;;
    zero <- is_zero "fanuc.cutter-c.value-zero" value ;;
    let starts := asked_now && negb (made x) && (crosses || makes_at_once s) in
    since <-
      (if starts then Got (Some (SideStart vt left true (idle_limit s)))
       else match since_start x with
            | Some start => if asked_now then after_start s c left crosses (given arc) travel start else Got None
            | None => Got None
            end) ;;
    let vector_stays :=
      made x && negb asked_now && negb crosses && negb (makes_at_once s) && negb (made_zero x) in
    Got (if asked_now && (made x || starts)
         then SideState code number value true true (if crosses || starts then zero else made_zero x) crosses left since
         else if vector_stays then SideState code number value false true false crosses left None
         else SideState code number value asked_now false false crosses left None).
