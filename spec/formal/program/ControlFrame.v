(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool center point control: the programming system and the control point. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Angles ControlState State Space Pose.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** Three parameters in the order of X, Y and Z. *)
Definition vector_parameter {num} {N : Numbers num} (s : setup num) (x y z : string) : triple num :=
  (parameter_of s x, parameter_of s y, parameter_of s z).

(** The machine coordinates of the zero of the workpiece system, X, Y and Z. *)
Definition zero_in_space {num} {N : Numbers num} (s : setup num) (c : coordinates num) : triple num :=
  in_space s (work_zero s c).

(** * Directions *)

(** What the table turns, seen in the machine: M of a pose. *)
Definition turned_by_table {num} {N : Numbers num} (k : kinematics num) (p : pose num) (v : triple num) : triple num :=
  match machine_of k with
  | ToolRotation => v
  | TableRotation => carried (first_axis k) (fst p) (carried (second_axis k) (snd p) v)
  | Mixed => carried (second_axis k) (snd p) v
  end.

(** fanuc.tool-center-point.frozen-pose: the table system is the copy of the workpiece system at the frozen pose: the
    direction of the tool at a pose is V_P = M deg V.
    fanuc.tool-center-point.programming-system: the workpiece system does not turn. *)
Definition programmed_direction {num} {N : Numbers num} (k : kinematics num) (workpiece_system : bool) (frozen p : pose num) :
    triple num :=
  match machine_of k, workpiece_system with
  | ToolRotation, _ => direction_at k p
  | TableRotation, true => reference_direction k
  | Mixed, true => carried (first_axis k) (fst p) (reference_direction k)
  | _, false => turned_by_table k frozen (direction_at k p)
  end.

(** A direction as the work-side axis has it: (M deg)^-1 V_P but for the turn of that axis. *)
Definition in_work_frame {num} {N : Numbers num} (k : kinematics num) (frozen : pose num) (v : triple num) : triple num :=
  match machine_of k with TableRotation => carried_back (first_axis k) (fst frozen) v | _ => v end.
(** And seen from the table at its zero pose: (M deg)^-1 V_P. *)
Definition from_work_frame {num} {N : Numbers num} (k : kinematics num) (frozen : pose num) (v : triple num) : triple num :=
  match machine_of k with ToolRotation => v | _ => carried_back (second_axis k) (snd frozen) v end.

(** What the tool-side axis makes of the reference direction. *)
Definition by_tool_side {num} {N : Numbers num} (k : kinematics num) (p : pose num) : triple num :=
  match machine_of k with
  | ToolRotation => carried (second_axis k) (snd p) (reference_direction k)
  | TableRotation => carried_back (first_axis k) (fst p) (reference_direction k)
  | Mixed => carried (first_axis k) (fst p) (reference_direction k)
  end.
(** The turn of an angle from another, as it turns a vector. Where its sine is known to be 0 its cosine is 1 or -1. *)
Definition turn_between {num} {N : Numbers num} (from to : angle num) : angle num :=
  let c := cosine_between to from in
  let s := sine_between to from in
  let '(c, s) := match sign s, sign c with
                 | Some Eq, Some Gt => (1%num, 0%num)
                 | Some Eq, Some Lt => ((0 - 1)%num, 0%num)
                 | _, _ => (c, s)
                 end in
  Angle (degrees to - degrees from)%num c s None.
(** The direction at a pose as the work-side axis has it. *)
Definition work_frame_direction {num} {N : Numbers num} (k : kinematics num) (frozen p : pose num) : triple num :=
  match machine_of k with
  | ToolRotation => direction_at k p
  | _ => carried_back (second_axis k) (turn_between (snd frozen) (snd p)) (by_tool_side k p)
  end.
(** The same as it has it at the pose of a block's start: of that pose alone, and of the one commanded. *)
Definition work_side_turned {num} {N : Numbers num} (k : kinematics num) (from p : pose num) : triple num :=
  match machine_of k with
  | ToolRotation => carried (first_axis k) (turn_between (fst from) (fst p)) (by_tool_side k p)
  | _ => carried_back (second_axis k) (turn_between (snd from) (snd p)) (by_tool_side k p)
  end.

(** * Points *)

(** A point of the machine that is fixed to the table, where it comes from one pose to another.
    fanuc.tool-center-point.control-point-table-rotation: the first axis goes through A (19700 to 19702), the second
    through A + d (d: 19703 to 19705) when the first is at 0: q = R2^-1(deg) (R1^-1(deg) (W + T - A) - d);
    T_m = A + R1 (d + R2 q).
    fanuc.tool-center-point.control-point-mixed: q = R2^-1(deg) (W + T - A); T_m = A + R2 q. *)
Definition with_table {num} {N : Numbers num} (s : setup num) (k : kinematics num) (from to : pose num) (point : triple num) :
    triple num :=
  let a := vector_parameter s "19700" "19701" "19702" in
  match machine_of k with
  | ToolRotation => point
  | TableRotation =>
      let d := vector_parameter s "19703" "19704" "19705" in
      let q := carried_back (second_axis k) (snd from)
                 (sub3 (carried_back (first_axis k) (fst from) (sub3 point a)) d) in
      add3 a (carried (first_axis k) (fst to) (add3 d (carried (second_axis k) (snd to) q)))
  | Mixed =>
      let q := carried_back (second_axis k) (snd from) (sub3 point a) in
      add3 a (carried (second_axis k) (snd to) q)
  end.

(** fanuc.tool-center-point.control-point-tool-rotation: from the tip along the tool by L to D, by 19709 to 19711 to E on
    the second axis, by 19712 to 19714 to F on the first axis.
    fanuc.tool-center-point.control-point-table-rotation: the tip plus L along the reference direction.
    fanuc.tool-center-point.control-point-mixed: E, from the tip along the tool by L and then by 19709 to 19711.
    From the tip to it. *)
Definition to_control_point {num} {N : Numbers num} (s : setup num) (k : kinematics num) (length : num) (p : pose num) :
    triple num :=
  let along := scale3 length (reference_direction k) in
  let beside := vector_parameter s "19709" "19710" "19711" in
  match machine_of k with
  | ToolRotation =>
      let to_first := vector_parameter s "19712" "19713" "19714" in
      carried (first_axis k) (fst p) (add3 (carried (second_axis k) (snd p) (add3 along beside)) to_first)
  | TableRotation => along
  | Mixed => carried (first_axis k) (fst p) (add3 along beside)
  end.

(** A point of the programming system where the table has turned to a pose, less the zero of the workpiece system. *)
Definition standing_tip {num} {N : Numbers num} (s : setup num) (k : kinematics num) (c : coordinates num)
    (m : control_mode num) (p : pose num) (tip : triple num) : triple num :=
  if in_workpiece_system m then tip
  else
    let zero := zero_in_space s c in
    sub3 (with_table s k (frozen_pose m) p (add3 zero tip)) zero.

(** The same from what stands there: a point of the table system. *)
Definition table_point {num} {N : Numbers num} (s : setup num) (k : kinematics num) (c : coordinates num)
    (m : control_mode num) (p : pose num) (tip : triple num) : triple num :=
  if in_workpiece_system m
  then let zero := zero_in_space s c in sub3 (with_table s k p (frozen_pose m) (add3 zero tip)) zero
  else tip.

(** A point fixed to the table, by its coordinates in the programming system, with the table turned from a pose to
    another. fanuc.tool-center-point.tip-alone, fanuc.tool-center-point.tip-alone-in-workpiece-system: the tip stays where
    it is on the table. *)
Definition kept_on_table {num} {N : Numbers num} (s : setup num) (k : kinematics num) (c : coordinates num)
    (m : control_mode num) (from to : pose num) (tip : triple num) : triple num :=
  if in_workpiece_system m
  then let zero := zero_in_space s c in sub3 (with_table s k from to (add3 zero tip)) zero
  else tip.

(** Where X, Y and Z of the axes stand: the control point less the zero of the workpiece system. Without rotary axes
    (fanuc.tool-center-point.without-kinematics) the length counts along the direction given. *)
Definition axes_over_tip {num} {N : Numbers num} (s : setup num) (c : coordinates num) (m : control_mode num) (length : num)
    (p : pose num) (along tip : triple num) : triple num :=
  match kinematics_of s with
  | Some k => add3 (standing_tip s k c m p tip) (to_control_point s k length p)
  | None => add3 tip (scale3 length along)
  end.

(** * Positions of the rotary axes *)

(** In the programmed positions of all axes. *)
Definition with_pose {num} {N : Numbers num} (s : setup num) (k : kinematics num) (c : coordinates num) (p : pose num)
    (position : values num) : values num :=
  let zero := angle_zero s c in
  let put (a : rotary_axis num) (x : angle num) (v : values num) :=
    match at_axis a with
    | Some here =>
        firstn here v ++ match skipn here v with
                         | [] => []
                         | _ :: rest => (degrees x - nth here zero 0)%num :: rest
                         end
    | None => v
    end in
  put (first_axis k) (fst p) (put (second_axis k) (snd p) position).

(** The pose that the words of a block command, from a pose: under G91 they are turns from there. *)
Definition commanded_pose {num} {N : Numbers num} (s : setup num) (k : kinematics num) (c : coordinates num)
    (incremental : bool) (words : some_values num) (from : pose num) : outcome (pose num) :=
  let zero := angle_zero s c in
  let turned_by (x : angle num) w :=
    match turns x with
    | None => Got (angle_of_degrees (degrees x + w)%num)
    | Some _ => angle_sum "fanuc.tool-center-point.commands" x (angle_of_degrees w)
    end in
  let next (a : rotary_axis num) (x : angle num) :=
    match at_axis a with
    | Some here =>
        match nth here words None with
        | Some w => if incremental then turned_by x w
                    else Got (angle_of_degrees (w + nth here zero 0)%num)
        | None => Got x
        end
    | None => Got x
    end in
  first <- next (first_axis k) (fst from) ;;
  second <- next (second_axis k) (snd from) ;;
  Got (first, second).

(** Whether the pose is the one to which control has turned: fanuc.tool-direction.rotary-angles: a code may have renamed
    programmed angles since. *)
Definition pose_is_known {num} {N : Numbers num} (s : setup num) (k : kinematics num) (st : state num) : bool :=
  match stands_at (control st) with
  | Some p =>
      let same (a : rotary_axis num) (x : angle num) :=
        match at_axis a with
        | Some here => match sign (nth here (programmed st) 0 - degrees x)%num with Some Eq => true | _ => false end
        | None => true
        end in
      negb (angles_as_programmed s) || (same (first_axis k) (fst p) && same (second_axis k) (snd p))
  | None => false
  end.

(** The pose of a state. *)
Definition pose_of {num} {N : Numbers num} (s : setup num) (k : kinematics num) (st : state num) : pose num :=
  match stands_at (control st), pose_is_known s k st with
  | Some p, true => p
  | _, _ => pose_at s k (coordinates_of st) (programmed st)
  end.
