(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool posture control: the rotary axes inside a block, along the great circle. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Angles ControlState State Space Pose.
From Toolcomp Require Import ControlFrame ControlWords InverseKinematics PostureAngles.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** fanuc.tool-posture.great-circle: V(t) = (sin((1 - t) Theta) Vs/|Vs| + sin(t Theta) Ve/|Ve|)/sin Theta.
    In the middle that is half of their sum.
    fanuc.tool-center-point.without-kinematics: between opposite directions it stays the first one until the end. *)
Definition on_great_circle {num} {N : Numbers num} (t : num) (from to : triple num) : outcome (triple num) :=
  let clause := "fanuc.tool-center-point.without-kinematics" in
  let a := unit3 from in
  let b := unit3 to in
  let n := cross3 from to in
  parallel <- is_zero clause (dot3 n n) ;;
  halfway <- is_zero clause (t - 1 / integer 2)%num ;;
  if parallel : bool then Got a
  else if halfway : bool then Got (unit3 (add3 a b))
  else
    let sine_of_theta := length3 (cross3 a b) in
    let cosine_of_theta := dot3 a b in
    side <- decide clause cosine_of_theta ;;
    let theta :=
      match side with
      | Eq => integer 90
      | Gt => arctangent (sine_of_theta / cosine_of_theta)%num
      | Lt => (integer 180 + arctangent (sine_of_theta / cosine_of_theta))%num
      end in
    Got (add3 (scale3 (sine ((1 - t) * theta) / sine_of_theta)%num a) (scale3 (sine (t * theta) / sine_of_theta)%num b)).

(** An angle several times. *)
Fixpoint several_times {num} {N : Numbers num} (count : nat) (a : angle num) : outcome (angle num) :=
  match count with
  | O => Got (Angle 0%num 1%num 0%num (Some 0))
  | S fewer => rest <- several_times fewer a ;; angle_sum lift_clause rest a
  end.

(** Where a part of a circle stands to the singular direction that it crosses: before it, at it, or behind: t Theta against
    the angle from the start to that direction; where the number does not tell, whole multiples of both, whose sines and
    cosines do. *)
Definition beyond_crossing {num} {N : Numbers num} (k : kinematics num) (g : great_circle num) (part : Z * Z) :
    outcome comparison :=
  match crosses_singular g with
  | None => Got Lt
  | Some opposite =>
      let a := unit3 (circle_from g) in
      let angle_from_start v := angle_of_unit lift_clause (dot3 a v) (length3 (cross3 a v)) in
      let u_w := about (work_side k) in
      theta <- angle_from_start (unit3 (circle_to g)) ;;
      to_singular <- angle_from_start (if opposite then scale3 (0 - 1)%num u_w else u_w) ;;
      match sign (integer (fst part) * degrees theta - integer (snd part) * degrees to_singular)%num with
      | Some c => Got c
      | None =>
          reached <- several_times (Z.to_nat (fst part)) theta ;;
          crossed <- several_times (Z.to_nat (snd part)) to_singular ;;
          compare_angles "fanuc.tool-posture.crossing" reached crossed
      end
  end.

(** On a branch; where the edge of reach is touched there is no root. *)
Definition beside_inside {num} {N : Numbers num} (k : kinematics num) (above : bool) (v : triple num) : outcome (beside num) :=
  let r := reach_of k in
  let c := (dot3 (about (work_side k)) v - along_axis r)%num in
  let square := (radius_square r - c * c)%num in
  inside <- is_positive lift_clause square ;;
  let h := if inside : bool then root square else 0%num in
  Got (Beside c (if above then h else (- h)%num)).

(** fanuc.tool-posture.lift: the positions where the tool has this direction, from those at the start, or from those at the
    end where the start is singular.
    fanuc.tool-posture.crossing: after a singular direction that is crossed the tool side is on its other branch. *)
Definition pose_on_circle {num} {N : Numbers num} (k : kinematics num) (g : great_circle num) (part : Z * Z)
    (v : triple num) : outcome (pose num) :=
  let '(tau, omega) := anchor g in
  let anchor_direction := if anchored_at_end g then circle_to g else circle_from g in
  let above := above_at_anchor g in
  let x_anchor := beside_of_position k tau in
  let '(c, s) := tool_angle k x_anchor in
  let side_anchor := on_tool_side k c s in
  degrees_anchor <- beside_degrees k above x_anchor ;;
  place <- beyond_crossing k g part ;;
  let lifted crossing degrees_now of_tool of_side :=
    pose_of_sides k
      (angle_of_degrees (lifted_tool k crossing above tau degrees_anchor degrees_now),
       angle_of_degrees (lifted_work k omega of_tool of_side)) in
  match place, crosses_singular g with
  | Eq, Some opposite =>
      degrees_now <- beside_degrees k above (beside_singular k opposite) ;;
      of_side <- bracket_of_side k false degrees_anchor degrees_now side_anchor (leaving_singular k opposite above) ;;
      Got (lifted None degrees_now 0%num of_side)
  | _, _ =>
      let crossing := match place with Gt => crosses_singular g | _ => None end in
      let crossed := given crossing in
      x_now <- beside_inside k (xorb above crossed) v ;;
      degrees_now <- beside_degrees k (xorb above crossed) x_now ;;
      let '(c, s) := tool_angle k x_now in
      of_side <- bracket_of_side k crossed degrees_anchor degrees_now side_anchor (on_tool_side k c s) ;;
      let of_tool := if on_meridian g then 0%num
                     else let '(c, s) := azimuth_between k anchor_direction v in degrees_by c s in
      Got (lifted crossing degrees_now of_tool of_side)
  end.
