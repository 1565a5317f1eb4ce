(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool center point control: what a block under it comes to: length, pose and direction. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset Angles ControlState State.
From Toolcomp Require Import Space Pose ControlFrame Movements ControlWords InverseKinematics ChoiceOfPair PostureAngles
  PostureControl Lean.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * The length along the tool *)

(** fanuc.tool-center-point.length: the offset of the H number plus the tool holder offset 19666. H and edited values
    follow the rules of G43, except that no G43 or G44 adds or subtracts the offset: fanuc.length-offset.ofh,
    fanuc.length-offset.ofh-first-without-number, fanuc.length-offset.evo. No axis has an offset. *)
Definition length_under_control {num} {N : Numbers num} (s : setup num) (o : offsets num) (c : length_command)
    (of_code : bool) (st : state num) : outcome (length_offset num * num) :=
  let l := length_of st in
  let on := given (in_force l) || given (in_control (control st)) in
  let number := match h c with
                | Some number => if ofh s && negb of_code then None else Some number
                | None => if of_code && ofh s && negb on then Some 0 else None
                end in
  let now := or_else number (number_in_force l) in
  let edited := match type_of s with TypeC => false | _ => evo s && has_words c end in
  along <- match in_control (control st), of_code || given number || edited with
           | Some m, false => Got (tool_length m)
           | _, _ => x <- applied s ByH o now ;; Got (x + parameter_of s "19666")%num
           end ;;
  Got (LengthOffset None now (zeros s) (no_axes s) (no_axes s), along).

(** * The block of the code *)

(** fanuc.tool-center-point.direction-words, fanuc.tool-center-point.again: the direction that is kept if the block
    gives none: that of the rotary positions; without kinematics the one in force. *)
Definition kept_without_kinematics {num} {N : Numbers num} (s : setup num) (st : state num) (position : values num) :
    triple num :=
  match in_control (control st) with
  | Some m => direction m
  | None => tool_direction s (coordinates_of st) position
  end.

(** The direction at a pose, which is the frozen one too; of a head that has not turned since, the one it has come to. *)
Definition direction_at_start {num} {N : Numbers num} (k : kinematics num) (along : option (triple num)) (p : pose num) :
    directed num :=
  let told := match machine_of k, along with
              | ToolRotation, Some v => v
              | _, _ => programmed_direction k true p p
              end in
  Directed told (match machine_of k with TableRotation => by_tool_side k p | _ => told end).

(** fanuc.tool-center-point.block: each of its axes goes to its end by itself.
    fanuc.tool-center-point.direction-at-start: I J K turn a tool rotation machine, without a lean.
    fanuc.tool-center-point.frozen-pose: the pose at which it ends is the frozen one. *)
Definition control_starts {num} {N : Numbers num} (s : setup num) (c : command num) (type : control_type) (along : num)
    (to : values num) (st : state num) : outcome (control_state num) :=
  posture <- chooses_posture s c ;;
  let workpiece_system := bit s "19696#5" in
  let vector := match type with ByVector => direction_words s c | ByAxes => None end in
  let lean := match type with ByVector => lean_word c | ByAxes => 0%num end in
  match kinematics_of s with
  | None =>
      let d := or_else vector (kept_without_kinematics s st to) in
      let nowhere := angle_of_degrees 0%num in
      Got (ControlState
             (Some (ControlMode type false lean false (nowhere, nowhere) along (Directed d d) (Directed d d))) None None None)
  | Some k =>
      let present := pose_of s k st in
      let standing := match in_control (control st) with Some m => Some (direction m) | None => stands_along (control st) end in
      pose <- match vector with
              | Some v => choose s k present (as_programmed (direction_at_start k standing present)) v v
              | None => commanded_pose s k (coordinates_of st) (incremental (in_modes c)) (position_words c) present
              end ;;
      (* fanuc.tool-center-point.not-invertible: every block runs under conventional control. *)
      no_inverse <- (if posture : bool then not_invertible k else Got false) ;;
      let d := match vector with
               | Some v => Directed v v
               | None => direction_at_start k (if names s rotary c then None else standing) pose
               end in
      Got (ControlState (Some (ControlMode type (posture && negb no_inverse) lean workpiece_system pose along d d))
             (Some pose) None None)
  end.

(** * The blocks that follow *)

Definition with_direction {num} (m : control_mode num) (along : num) (kept d : directed num) : control_mode num :=
  ControlMode (control_by m) (posture_control m) (lean_angle m) (in_workpiece_system m) (frozen_pose m) along kept d.

(** A vector of the programming system. *)
Definition directed_by {num} {N : Numbers num} (s : setup num) (m : control_mode num) (v : triple num) : directed num :=
  Directed v (match kinematics_of s with Some k => in_work_frame k (frozen_pose m) v | None => v end).
(** The direction at a pose. *)
Definition directed_at {num} {N : Numbers num} (k : kinematics num) (m : control_mode num) (p : pose num) : directed num :=
  Directed (programmed_direction k (in_workpiece_system m) (frozen_pose m) p) (work_frame_direction k (frozen_pose m) p).

(** fanuc.tool-center-point.direction-words: the direction of I J K, or the one kept; none if the rotary axes stand
    still: without I J K, if Q is 0 or the tip has no travel. And what is kept of it.
    fanuc.tool-center-point.lean: leaned where the tip moves. *)
Definition direction_to {num} {N : Numbers num} (s : setup num) (c : command num) (circle_of : option (circle num))
    (m : control_mode num) (from to : values num) : outcome (option (directed num * directed num)) :=
  let words := option_map (directed_by s m) (direction_words s c) in
  let travel := sub3 (in_space s to) (in_space s from) in
  let radius := match circle_of with
                | Some _ => last_number s (in_inches (in_modes c)) Letter.R (block_of c)
                | None => None
                end in
  let clockwise := match motion (in_modes c) with Clockwise => true | _ => false end in
  let kept := or_else words (kept_direction m) in
  upright <- is_zero "fanuc.tool-center-point.lean" (lean_angle m) ;;
  stands <- (if upright : bool then Got true
             else is_zero "fanuc.tool-center-point.lean-along-the-travel" (dot3 travel travel)) ;;
  if stands : bool then Got (option_map (fun w => (w, w)) words)
  else
    d <- travel_at_end (in_plane (in_modes c)) clockwise radius travel ;;
    let d := directed_by s m d in
    v <- leaned (lean_angle m) (as_programmed kept) (as_programmed d) ;;
    u <- leaned (lean_angle m) (under_work_side kept) (under_work_side d) ;;
    Got (Some (Directed v u, kept)).

(** A block of type 1 goes to the pose commanded, one of type 2 to a pair of its direction.
    fanuc.tool-center-point.conventional: without posture control the rotary axes go evenly to their end. *)
Definition control_runs {num} {N : Numbers num} (s : setup num) (c : command num) (circle_of : option (circle num))
    (along : num) (to : values num) (m : control_mode num) (st : state num) : outcome (control_state num) :=
  let standing := pointing m in
  match kinematics_of s with
  | None =>
      target <- direction_to s c circle_of m (programmed st) to ;;
      let '(v, kept) := or_else target (standing, kept_direction m) in
      let nowhere := frozen_pose m in
      Got (ControlState (Some (with_direction m along kept v)) None None
             (Some (RotaryRun nowhere nowhere nowhere nowhere false false
                      (DirectionAlone (as_programmed standing) (as_programmed v)) false)))
  | Some k =>
      let from := pose_of s k st in
      match control_by m with
      | ByAxes =>
          pose <- commanded_pose s k (coordinates_of st) (incremental (in_modes c)) (position_words c) from ;;
          let d := directed_at k m pose in
          (* Without a rotary word the direction is the same: fanuc.tool-posture.no-plane. *)
          '(run, _) <- (if posture_control m && names s rotary c
                        then posture_run s k from (Some pose) (by_tool_side k from) (work_side_turned k from pose)
                               (direction_at k from) (direction_at k pose)
                        else Got (conventionally false from pose, false)) ;;
          Got (ControlState (Some (with_direction m along d d)) (Some pose) None (Some run))
      | ByVector =>
          target <- direction_to s c circle_of m (programmed st) to ;;
          match target with
          | None => Got (ControlState (Some (with_direction m along (kept_direction m) standing)) (Some from) None
                           (Some (conventionally false from from)))
          | Some (v, kept) =>
              let vs := under_work_side standing in
              let ve := under_work_side v in
              let from_zero := from_work_frame k (frozen_pose m) in
              '(run, changed) <- (if posture_control m then posture_run s k from None vs ve (from_zero vs) (from_zero ve)
                                  else to <- choose s k from vs ve (from_zero ve) ;; Got (conventionally false from to, false)) ;;
              (* fanuc.tool-posture.changed: the direction of the changed pair is the one kept. *)
              let actual := directed_at k m (pose_behind run) in
              let m := if changed : bool then with_direction m along actual actual else with_direction m along kept v in
              Got (ControlState (Some m) (Some (pose_behind run)) None (Some run))
          end
      end
  end.

(** * Arcs in the workpiece system *)

(** fanuc.tool-center-point.arc-in-workpiece-system: a table axis that turns in an arc, or stands elsewhere at its start
    than at the frozen pose, raises PS5421 if it is not normal to the plane as it stands at the start.
    fanuc.tool-center-point.arc-with-table-turned: else ARC_WITH_TABLE_TURNED. *)
Definition arc_in_workpiece_system {num} {N : Numbers num} (s : setup num) (p : plane) (k : kinematics num)
    (frozen from to : pose num) : outcome unit :=
  let clause := "fanuc.tool-center-point.arc-in-workpiece-system" in
  let table_axes :=
    let line := match machine_of k with
                | TableRotation => carried (first_axis k) (fst from) (about (second_axis k))
                | _ => about (second_axis k)
                end in
    let first := (about (first_axis k), (fst frozen, fst from, fst to)) in
    let second := (line, (snd frozen, snd from, snd to)) in
    match machine_of k with ToolRotation => [] | TableRotation => [first; second] | Mixed => [second] end in
  turned <- each
    (fun a =>
      let '(standing, (there, start, finish)) := a in
      at_start <- is_zero clause (degrees start - degrees there)%num ;;
      at_end <- is_zero clause (degrees finish - degrees start)%num ;;
      let '(x, y, z) := standing in
      let beside := match p with XY => (x * x + y * y)%num | ZX => (z * z + x * x)%num | YZ => (y * y + z * z)%num end in
      normal <- is_zero clause beside ;;
      Got (negb (at_start && at_end), normal))
    table_axes ;;
  _ <- alarm_if (existsb (fun t => fst t && negb (snd t)) turned) "table-turned-in-arc" ;;
  alarm_if (existsb fst turned) "arc-with-table-turned".

(** * A block *)

(** The state of control behind a block under it, none where it is not; with the length offset. *)
Definition control_step {num} {N : Numbers num} (s : setup num) (c : command num) (l : length_command)
    (circle_of : option (circle num)) (to : values num) (st : state num) :
    outcome (option (length_offset num * control_state num)) :=
  let code := control_code (codes_said c) in
  match type_with (codes_said c) st with
  | None => Got None
  | Some type =>
      '(length, along) <- length_under_control s (offsets_of st) l (given code) st ;;
      _ <- (match in_control (control st), kinematics_of s, circle_of with
            | Some m, Some k, Some _ =>
                if in_workpiece_system m && negb (given code) then
                  let from := pose_of s k st in
                  pose <- commanded_pose s k (coordinates_of st) (incremental (in_modes c)) (position_words c) from ;;
                  arc_in_workpiece_system s (in_plane (in_modes c)) k (frozen_pose m) from pose
                else Got tt
            | _, _, _ => Got tt
            end) ;;
      behind <- match code, in_control (control st) with
                | None, Some m => control_runs s c circle_of along to m st
                | _, _ => control_starts s c type along to st
                end ;;
      Got (Some (length, behind))
  end.

(** fanuc.tool-center-point.block: the block of the code always makes a move; fanuc.tool-center-point.direction-words: I J K
    alone make one; and so does a new length. *)
Definition control_moves {num} {N : Numbers num} (s : setup num) (c : command num) (behind : control_state num)
    (st : state num) : outcome bool :=
  match in_control behind, in_control (control st), control_code (codes_said c) with
  | Some new, Some old, None =>
      same <- is_zero "fanuc.tool-center-point.length" (tool_length new - tool_length old)%num ;;
      let directed := match control_by new with ByVector => given (direction_words s c) | ByAxes => false end in
      Got (directed || negb same)
  | _, _, _ => Got true
  end.

(** Behind a block that is not under control, by the words that move its axes. The pose stays known, by its turns, until
    a code takes a rotary axis to a machine position. *)
Definition without_control {num} {N : Numbers num} (s : setup num) (c : command num) (numbers : some_values num)
    (st : state num) : outcome (control_state num) :=
  let elsewhere := match acting c with
                   | Some (FirstReference | OtherReference | FloatingReference | ReturnFromReference | MachinePosition) => true
                   | _ => false
                   end in
  let moved := map2 (fun letter number => rotary letter && given number) (axes s) numbers in
  let turns := names s rotary c || existsb (fun here => here) moved in
  match kinematics_of s, stands_at (control st) with
  | Some k, Some _ =>
      if elsewhere && turns then Got (ControlState None None None None)
      else
        p <- commanded_pose s k (coordinates_of st) (incremental (in_modes c)) numbers (pose_of s k st) ;;
        let along := match in_control (control st) with
                     | Some m => Some (direction m)
                     | None => stands_along (control st)
                     end in
        Got (ControlState None (Some p) (if turns || negb (pose_is_known s k st) then None else along) None)
  | _, _ => Got (ControlState None None None None)
  end.

(** The programmed position behind a block, and its movement: with the rotary positions of the pose; machine coordinates
    (fanuc.tool-center-point.machine-coordinates); the direction of the tool.
    fanuc.tool-center-point.tip-alone-in-workpiece-system: without a word of X Y Z the programmed X Y Z become those of
    the place where the tip is. *)
Definition under_control {num} {N : Numbers num} (s : setup num) (c : command num) (behind : control_state num)
    (st : state num) (moves : list (movement num)) : state num * list (movement num) :=
  match in_control behind with
  | None => (st, moves)
  | Some m =>
      let coordinates := coordinates_of st in
      let alone := negb (names s (fun letter => match letter with Letter.X | Letter.Y | Letter.Z => true | _ => false end) c) in
      let at_end position :=
        match kinematics_of s, stands_at behind with
        | Some k, Some p =>
            let position :=
              match alone && in_workpiece_system m, run_of_block behind with
              | true, Some run =>
                  let tip := kept_on_table s k coordinates m (pose_before run) p (in_space s (sum position (shift st))) in
                  with_space s position (sub3 tip (in_space s (shift st)))
              | _, _ => position
              end in
            with_pose s k coordinates p position
        | _, _ => position
        end in
      let position := at_end (programmed st) in
      let st := match moves with
                | [] => with_control st (ControlState (Some m) (stands_at behind) None None)
                | _ => st
                end in
      let toward := Some (unit3 (direction m)) in
      (at_position st position (shift st),
       map (fun g => Movement (going g) (because g) position (sum position (shift st)) (head g) (length_vector g)
                       (Some (work_zero s coordinates)) (circle_of g) (at_feed g) toward) moves)
  end.
