(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool center point control: what the words of a block do to it, and their alarms. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset Angles ControlState State Space Pose.
From Toolcomp Require Import ControlFrame Movements.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** fanuc.tool-center-point.commands: G43.4 and G43.5 are in one modal group with G43, G44 and G49, and G49 ends
    them. *)
Definition control_code (codes : list Z) : option control_type :=
  match last_of lengths codes with Some code => lookup code [(434, ByAxes); (435, ByVector)] | None => None end.

Definition type_before {num} (st : state num) : option control_type :=
  option_map control_by (in_control (control st)).
(** The type in force with the codes of a block: it is run under control, or has the code. G49 ends it; G43 and G44 are
    refused (fanuc.tool-center-point.exclusion). *)
Definition type_with {num} (codes : list Z) (st : state num) : option control_type :=
  match control_code codes, last_of lengths codes with
  | Some code, _ => Some code
  | None, Some code => if code =? 490 then None else type_before st
  | None, None => type_before st
  end.
Definition by_vector (t : option control_type) : bool := match t with Some ByVector => true | _ => false end.

(** * Words *)

Definition has {num} (letter : Letter.t) (b : block num) : bool := given (last_word letter (words b)).

(** fanuc.tool-center-point.direction-words: I J K are the direction; if only some of them are given, the missing ones
    are 0.
    fanuc.program.letters-as-data: unless they are data of another code. *)
Definition direction_words {num} {N : Numbers num} (s : setup num) (c : command num) : option (triple num) :=
  let number letter := last_number s (in_inches (in_modes c)) letter (block_of c) in
  let some := existsb (fun letter => has letter (block_of c)) [Letter.I; Letter.J; Letter.K] in
  if some && negb (takes_letters (codes_said c))
  then Some (or_else (number Letter.I) 0%num, or_else (number Letter.J) 0%num, or_else (number Letter.K) 0%num)
  else None.

(** A word that moves an axis, I J K of the direction included. *)
Definition under_vector {num} (c : command num) (st : state num) : bool := by_vector (type_with (codes_said c) st).
Definition moving_word {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) : bool :=
  existsb given (naming_words c) || (under_vector c st && given (direction_words s c)).

(** The block without them: under G43.5 they are no centre of an arc. *)
Definition without_direction {num} (b : block num) : block num :=
  Block (filter (fun w => match address w with Letter.I | Letter.J | Letter.K => false | _ => true end) (words b))
    (unreadable b).

(** Whether the block names an axis of this kind. *)
Definition names {num} (s : setup num) (kind : Letter.t -> bool) (c : command num) : bool :=
  existsb (fun here => here) (map2 (fun letter word => kind letter && given word) (axes s) (naming_words c)).

(** fanuc.tool-posture.word: P and Q of a block whose letters are data of a code are data too. *)
Definition is_data_of_code {num} (c : command num) : bool := takes_letters (codes_said c).

(** fanuc.tool-posture.word: P1 chooses posture control, P0 conventional control.
    fanuc.tool-posture.default: without P 19604#0 decides.
    fanuc.tool-posture.word-value: another value raises PS5421. *)
Definition chooses_posture {num} (s : setup num) (c : command num) : outcome bool :=
  match last_word Letter.P (words (block_of c)) with
  | Some w =>
      if is_data_of_code c then Got (bit s "19604#0")
      else match whole w with
           | Some p => if p =? 0 then Got false else if p =? 1 then Got true else Alarm "tip-control-word"
           | None => Alarm "tip-control-word"
           end
  | None => Got (bit s "19604#0")
  end.

(** fanuc.tool-center-point.lean: Q of the block of G43.5, in degrees. *)
Definition lean_word {num} {N : Numbers num} (c : command num) : num :=
  match last_word Letter.Q (words (block_of c)) with
  | Some w => if is_data_of_code c then 0%num else value w
  | None => 0%num
  end.

(** * The machine *)

(** The axis on the tool side, the one on the work side. *)
Definition tool_side {num} (k : kinematics num) : rotary_axis num :=
  match machine_of k with ToolRotation => second_axis k | _ => first_axis k end.
Definition work_side {num} (k : kinematics num) : rotary_axis num :=
  match machine_of k with ToolRotation => first_axis k | _ => second_axis k end.

(** fanuc.tool-center-point.not-invertible: an axis is hypothetical, or u_t is parallel to t0 or to u_w. *)
Definition not_invertible {num} {N : Numbers num} (k : kinematics num) : outcome bool :=
  let clause := "fanuc.tool-center-point.not-invertible" in
  let parallel a b := let n := cross3 a b in is_zero clause (dot3 n n) in
  if negb (given (at_axis (first_axis k)) && given (at_axis (second_axis k))) then Got true
  else
    along_tool <- parallel (about (tool_side k)) (reference_direction k) ;;
    if along_tool : bool then Got true else parallel (about (tool_side k)) (about (work_side k)).

(** The limits of the first and of the second rotary axis, lower and upper; both 0, or not given: none.
    fanuc.tool-center-point.range-order: 19741 and 19742 are the upper and the lower limit of the first axis. *)
Definition limits {num} {N : Numbers num} (s : setup num) (upper lower : string) : outcome (option (num * num)) :=
  let clause := "fanuc.tool-center-point.range" in
  let below := parameter_of s lower in
  let above := parameter_of s upper in
  no_lower <- is_zero clause below ;;
  no_upper <- is_zero clause above ;;
  Got (if no_lower && no_upper then None else Some (below, above)).
Definition limits_of_axes {num} {N : Numbers num} (s : setup num) :
    outcome (option (num * num) * option (num * num)) :=
  first <- limits s "19741" "19742" ;; second <- limits s "19743" "19744" ;; Got (first, second).

(** fanuc.tool-center-point.range-order: a lower limit above the upper one. *)
Definition limits_in_order {num} {N : Numbers num} (s : setup num) : outcome bool :=
  let fine range :=
    match range with
    | Some (below, above) => wrong <- is_positive "fanuc.tool-center-point.range-order" (below - above)%num ;; Got (negb wrong)
    | None => Got true
    end in
  '(first, second) <- limits_of_axes s ;;
  first_fine <- fine first ;; second_fine <- fine second ;; Got (first_fine && second_fine).

(** * Alarms *)

(** fanuc.tool-center-point.forbidden: these codes, and G10 L2 and L20.
    fanuc.program.last-code-of-group: of one group the last one counts. *)
Definition forbidden_codes := [280; 290; 300; 301; 370; 390; 410; 420; 450; 460; 470; 480; 520; 530; 540; 541; 550; 560;
  570; 580; 590; 920].
Definition is_forbidden (codes : list Z) : bool :=
  existsb
    (fun group => match last_of group codes with Some code => among code forbidden_codes | None => false end)
    [map fst actions; compensations; systems].

(** What compensates the tip beside control: the leading edge offset and tool side compensation. *)
Record beside_control := BesideControl {
  edge_beside : bool;      (* the leading edge offset is on before or after the block *)
  side_beside : bool;      (* tool side compensation is *)
  after_block : bool       (* one of them is on after it *)
}.

(** fanuc.tool-center-point.alarm-order: by words, the first of these. Of a block in the drilling mode, or not. *)
Definition control_alarms {num} {N : Numbers num} (s : setup num) (c : command num) (st : state num) (in_cycle : bool)
    (beside : beside_control) : outcome unit :=
  let codes := codes_said c in
  let code := control_code codes in
  let now := type_with codes st in
  let under := given now in
  let of_code := given code in
  let k := kinematics_of s in
  let arc := match motion (in_modes c) with Clockwise | Counterclockwise => true | _ => false end in
  let origins := match acting c with
                 | Some DataInput => among (or_else (whole_word Letter.L (block_of c)) 0) [2; 20]
                 | _ => false
                 end in
  let length_code := match last_of lengths codes with Some l => among l [430; 440] | None => false end in
  let refuses_length := given (type_before st) && length_code in
  (* fanuc.tool-center-point.forbidden *)
  _ <- alarm_if ((under || refuses_length) && (origins || is_forbidden codes || in_cycle))
         "forbidden-under-tool-direction" ;;
  (* fanuc.tool-center-point.exclusion: G43 or G44 under control, and the code while an axis has a length offset *)
  offset <- (if of_code then offset_axes (vector (length_of st)) else Got (no_axes s)) ;;
  _ <- alarm_if (refuses_length || negb (empty offset)) "length-offset-exclusion" ;;
  (* fanuc.tool-center-point.without-kinematics, fanuc.tool-center-point.type-2-in-workpiece-system *)
  _ <- alarm_if (match code with Some ByAxes => negb (given k) | _ => false end) "tip-control-parameters" ;;
  _ <- alarm_if (by_vector code && given k && bit s "19696#5") "tip-control-parameters" ;;
  posture <- (if of_code then chooses_posture s c else Got false) ;;
  (* fanuc.tool-center-point.not-invertible, fanuc.tool-center-point.range-order *)
  no_inverse <- match k with
                | Some k => if of_code && (by_vector code || posture) then not_invertible k else Got false
                | None => Got false
                end ;;
  _ <- alarm_if (by_vector code && no_inverse) "tip-control-parameters" ;;
  in_order <- (if by_vector code && given k then limits_in_order s else Got true) ;;
  _ <- alarm_if (negb in_order) "rotary-limits" ;;
  (* fanuc.tool-center-point.format *)
  let ends := given (type_before st) && match last_of lengths codes with Some l => l =? 490 | None => false end in
  _ <- alarm_if ((of_code && arc) || ((of_code || ends) && (edge_beside beside || side_beside beside)))
         "tool-direction-format" ;;
  (* fanuc.tool-center-point.compensation-in-workpiece-system *)
  let turns_table := match k with
                     | Some k => match machine_of k with ToolRotation => false | _ => true end
                     | None => false
                     end in
  _ <- alarm_if (under && negb (by_vector now) && bit s "19696#5" && turns_table && after_block beside)
         "compensation-in-workpiece-system" ;;
  (* fanuc.tool-center-point.rotary-word *)
  (* fanuc.tool-side.rotary-word *)
  _ <- alarm_if (by_vector now && names s rotary c) (if side_beside beside then "rotary-word-in-compensation" else "tool-direction") ;;
  (* fanuc.tool-center-point.direction-at-start, fanuc.tool-center-point.zero *)
  let direction := if by_vector now then direction_words s c else None in
  _ <- alarm_if (of_code && given direction && turns_table) "direction-at-start" ;;
  nothing <- match direction with
             | Some d => is_zero "fanuc.tool-center-point.zero" (dot3 d d)
             | None => Got false
             end ;;
  _ <- alarm_if nothing "tool-direction" ;;
  (* fanuc.tool-center-point.arc-by-radius, fanuc.tool-center-point.arc-rotary-only *)
  let '(first, second) := plane_axes (in_plane (in_modes c)) in
  let in_plane := names s (fun letter => Letter.eqb letter first || Letter.eqb letter second) c in
  let with_radius := has Letter.R (block_of c) in
  let turns_alone :=
    negb (names s Letter.linear c) &&
    (if by_vector now then given direction
     else names s rotary c && negb (with_radius || existsb (fun letter => has letter (block_of c)) [Letter.I; Letter.J; Letter.K])) in
  alarm_if (under && arc && ((by_vector now && in_plane && negb with_radius) || turns_alone)) "tip-control-arc".

(** * Before the words of a block count *)

(** fanuc.tool-center-point.end: G49 ends control: the programmed X Y Z become those of the axes, without a shift left by
    G45 to G48.
    fanuc.tool-center-point.again: the code under control ends it first: they become the coordinates of the tip in the
    workpiece system at the present pose.
    fanuc.tool-center-point.end-moves: and so they do if G49 takes the offset back in a move. *)
Definition control_left {num} {N : Numbers num} (s : setup num) (codes : list Z) (st : state num) : state num :=
  match in_control (control st), last_of lengths codes with
  | Some m, Some _ =>
      let c := coordinates_of st in
      let tip := in_space s (sum (programmed st) (shift st)) in
      let p := match kinematics_of s with Some k => pose_of s k st | None => frozen_pose m end in
      let standing :=
        if given (control_code codes) || tip_cancel_moves s
        then match kinematics_of s with Some k => standing_tip s k c m p tip | None => tip end
        else axes_over_tip s c m (tool_length m) p (unit3 (direction m)) tip in
      at_position st (with_space s (programmed st) (sub3 standing (in_space s (shift st)))) (shift st)
  | _, _ => st
  end.

(** fanuc.tool-center-point.end-moves: the G49 that ends control makes a move. *)
Definition cancel_moves {num} (s : setup num) (st : state num) : bool :=
  tip_cancel_moves s && given (in_control (control st)).

(** What is in force behind a block that has come from `before` to `after`. *)
Definition control_behind {num} {N : Numbers num} (s : setup num) (c : command num) (before after : state num) :
    outcome (control_state num) :=
  Got (control after).
