(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool posture control: the angles by which the rotary axes follow a great circle.

    On the tool side an angle is told by what it stands beside the one at which the tool is nearest to u_w: above it, up to
    a half turn, or below it. On the work side it is an azimuth about u_w. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Angles ControlState State Space Pose.
From Toolcomp Require Import ControlFrame ControlWords InverseKinematics.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Definition lift_clause := "fanuc.tool-posture.lift".

(** Between -180 and 180 degrees, both not among them. *)
Definition degrees_by {num} {N : Numbers num} (c s : num) : num := (integer 2 * arctangent (s / (1 + c)))%num.

(** With the sign that a sense gives. *)
Definition with_sense {num} {N : Numbers num} (reversed : bool) (x : num) : num := if reversed then (- x)%num else x.

(** * On the tool side *)

(** Cosine and sine of the angle beside the nearest one, times rho. *)
Record beside (num : Type) := Beside { along_nearest : num; across_nearest : num }.
Arguments Beside {num}. Arguments along_nearest {num}. Arguments across_nearest {num}.

(** Of a position. fanuc.tool-posture.branch: B cos tau' - A sin tau' is positive below. *)
Definition beside_of_position {num} {N : Numbers num} (k : kinematics num) (tau : angle num) : beside num :=
  let r := reach_of k in
  let c := cosine_of tau in
  let s := with_sense (tool_reversed k) (sine_of tau) in
  Beside (toward r * c + across r * s)%num (toward r * s - across r * c)%num.

(** Of a direction on a branch. On the edge of reach the root is one of 0. *)
Definition beside_of_direction {num} {N : Numbers num} (k : kinematics num) (edge above : bool) (v : triple num) : beside num :=
  let r := reach_of k in
  let c := (dot3 (about (work_side k)) v / length3 v - along_axis r)%num in
  let h := if edge then 0%num else root (radius_square r - c * c)%num in
  Beside c (if above then h else (- h)%num).

(** Where the tool points along +u_w or -u_w. *)
Definition beside_singular {num} {N : Numbers num} (k : kinematics num) (opposite : bool) : beside num :=
  let rho := root (radius_square (reach_of k)) in
  Beside (if opposite then (- rho)%num else rho) 0%num.

(** Its cosine and sine, not those beside. *)
Definition tool_angle {num} {N : Numbers num} (k : kinematics num) (x : beside num) : num * num :=
  let r := reach_of k in
  (((toward r * along_nearest x - across r * across_nearest x) / radius_square r)%num,
   ((across r * along_nearest x + toward r * across_nearest x) / radius_square r)%num).

(** Its degrees: above from 0 to 180, below from -180 to 0. *)
Definition beside_degrees {num} {N : Numbers num} (k : kinematics num) (above : bool) (x : beside num) : outcome num :=
  let rho := root (radius_square (reach_of k)) in
  let from_far := (rho + along_nearest x)%num in
  far <- is_zero lift_clause from_far ;;
  Got (if far : bool then (if above then integer 180 else (- integer 180)%num)
       else (integer 2 * arctangent (across_nearest x / from_far))%num).

(** * On the work side *)

(** What is across u_w, squared. *)
Definition across_work_axis {num} {N : Numbers num} (k : kinematics num) (v : triple num) : num :=
  let along := dot3 (about (work_side k)) v in (dot3 v v - along * along)%num.

(** Cosine and sine of the azimuth of b less that of a. *)
Definition azimuth_between {num} {N : Numbers num} (k : kinematics num) (a b : triple num) : num * num :=
  let u_w := about (work_side k) in
  let size := root (across_work_axis k a * across_work_axis k b)%num in
  (((dot3 a b - dot3 u_w a * dot3 u_w b) / size)%num, (dot3 u_w (cross3 a b) / size)%num).

(** The direction in which the tool side leaves a singular direction on a branch, seen along it: the limit of its
    azimuth. *)
Definition leaving_singular {num} {N : Numbers num} (k : kinematics num) (opposite above : bool) : triple num :=
  let u_w := about (work_side k) in
  let onward := cross3 (about (tool_side k)) (if opposite then scale3 (0 - 1)%num u_w else u_w) in
  if xorb opposite above then onward else scale3 (0 - 1)%num onward.

(** The position on the work side that turns the azimuth of w to that of v, within one turn. *)
Definition work_turn {num} {N : Numbers num} (k : kinematics num) (w v : triple num) : outcome (angle num) :=
  let '(c, s) := azimuth_between k w v in position_by (work_reversed k) c s.

(** * Whole turns *)

(** The one of the positions of one turn that is this number, which is known but for its form. *)
Definition position_near {num} {N : Numbers num} (one_turn : angle num) (x : num) : outcome (angle num) :=
  count <- whole_turns lift_clause (x - degrees one_turn + integer 180)%num ;; Got (turned_on count one_turn).
(** Whether a position that may differ from it by whole turns is this number. *)
Definition is_position {num} {N : Numbers num} (a : angle num) (x : num) : outcome bool :=
  count <- whole_turns lift_clause (degrees a - x + integer 180)%num ;; Got (count =? 0).

(** * The lift *)

(** fanuc.tool-posture.crossing: through -u_w the angle beside the nearest one goes on over a half turn. *)
Definition turn_of_crossing {num} {N : Numbers num} (crossing : option bool) (above : bool) : num :=
  match crossing with
  | Some true => if above then integer 360 else (- integer 360)%num
  | _ => 0%num
  end.

(** fanuc.tool-posture.lift: the tool-side axis goes on its branch. From a position to the angle beside the nearest one that
    it comes to, in degrees. *)
Definition lifted_tool {num} {N : Numbers num} (k : kinematics num) (crossing : option bool) (above : bool) (from : angle num)
    (degrees_from degrees_to : num) : num :=
  (degrees from +
   with_sense (tool_reversed k) (degrees_to - degrees_from + turn_of_crossing crossing above))%num.

(** fanuc.tool-posture.lift: omega(t) = omega_s0 + sigma_w ([az V(t) - az Vs] - [az c(tau(t)) - az c(tau_s0)]), in degrees,
    by the two brackets. *)
Definition lifted_work {num} {N : Numbers num} (k : kinematics num) (from : angle num) (of_tool of_side : num) : num :=
  (degrees from + with_sense (work_reversed k) (of_tool - of_side))%num.

(** The bracket of the tool side. fanuc.tool-posture.crossing: with a half turn taken off where a singular direction is
    crossed. From one edge of reach to the other it may be a half turn, in the sense in which the tool side turns. *)
Definition bracket_of_side {num} {N : Numbers num} (k : kinematics num) (crossed : bool) (beside_from beside_to : num)
    (from to : triple num) : outcome num :=
  let '(c, s) := azimuth_between k from to in
  let turned x := if crossed then (- x)%num else x in
  let c := turned c in
  let s := turned s in
  half <- is_zero lift_clause (1 + c)%num ;;
  if half : bool then
    sense <- decide lift_clause ((beside_to - beside_from) * dot3 (about (tool_side k)) (about (work_side k)))%num ;;
    Got (match sense with Lt => (- integer 180)%num | _ => integer 180 end)
  else Got (degrees_by c s).
