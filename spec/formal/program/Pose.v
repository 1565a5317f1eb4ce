(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-direction: the direction of the tool by the positions of the rotary axes. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Coordinates Angles State Space.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** A parameter that the setup does not give is 0. *)
Definition parameter_of {num} {N : Numbers num} (s : setup num) (number : string) : num :=
  or_else (parameter s number) 0%num.
Definition whole_of {num} (s : setup num) (number : string) : Z := or_else (whole_parameter s number) 0.

(** The place of a controlled axis by its number, which counts from 1. *)
Definition place_of_axis (number : Z) : nat := Nat.pred (Z.to_nat number).

(** * The mechanism *)

(** fanuc.tool-direction.axis-direction: 1 X, 2 Y, 3 Z; inclined by the angle a: 4 (cos a, sin a, 0), 5 (0, cos a, sin a),
    6 (sin a, 0, cos a). *)
Definition axis_direction {num} {N : Numbers num} (code : Z) (a : num) : triple num :=
  let o := 0%num in
  if code =? 1 then (1%num, o, o)
  else if code =? 2 then (o, 1%num, o)
  else if code =? 3 then (o, o, 1%num)
  else if code =? 4 then (cosine a, sine a, o)
  else if code =? 5 then (o, cosine a, sine a)
  else (sine a, o, cosine a).

(** A vector turned right-handed about a direction of length 1, by the cosine and the sine of an angle. *)
Definition turned {num} {N : Numbers num} (about : triple num) (c s : num) (v : triple num) : triple num :=
  add3 (add3 (scale3 c v) (scale3 s (cross3 about v))) (scale3 ((1 - c) * dot3 about v)%num about).

(** fanuc.tool-direction.reference-direction: +X, +Y or +Z by 19697, tilted by RA (19698) from the second axis toward the
    third and then by RB (19699) from the third toward the first, in the cyclic order that ends with that axis. *)
Definition tilted {num} {N : Numbers num} (ra rb : num) : triple num :=
  ((cosine ra * sine rb)%num, (- sine ra)%num, (cosine ra * cosine rb)%num).
Definition reference_direction_of {num} {N : Numbers num} (s : setup num) : triple num :=
  let '(first, second, third) := tilted (parameter_of s "19698") (parameter_of s "19699") in
  let code := or_else (whole_parameter s "19697") 3 in
  if code =? 1 then (third, first, second)
  else if code =? 2 then (second, third, first)
  else (first, second, third).

(** fanuc.tool-direction.mechanism: controlled axis numbers, axis directions and senses of rotation.
    fanuc.tool-direction.hypothetical-axis: it stands at an angle that a parameter gives. *)
Definition rotary_axis_by {num} {N : Numbers num} (s : setup num) (hypothetical number direction inclination sense angle :
    string) : rotary_axis num :=
  RotaryAxis (if bit s hypothetical then None else Some (place_of_axis (whole_of s number))) (parameter_of s angle)
    (axis_direction (whole_of s direction) (parameter_of s inclination)) (whole_of s sense =? 1).

(** fanuc.tool-direction.mechanism: 19680 is 2 for tool rotation, 12 for table rotation, 21 for the mixed type. *)
Definition kinematics_by_parameters {num} {N : Numbers num} (s : setup num) : option (kinematics num) :=
  let machine := lookup (whole_of s "19680") [(2, ToolRotation); (12, TableRotation); (21, Mixed)] in
  option_map
    (fun machine =>
      Kinematics machine
        (rotary_axis_by s "19696#0" "19681" "19682" "19683" "19684" "19685")
        (rotary_axis_by s "19696#1" "19686" "19687" "19688" "19689" "19690")
        (reference_direction_of s))
    machine.

(** They are found once, before the first block. *)
Definition kinematics_of {num} (s : setup num) : option (kinematics num) := mechanism s.
Definition with_mechanism {num} {N : Numbers num} (s : setup num) : setup num :=
  Setup (axes s) (inches s) (least_increment s) (parameter_bit s) (parameter s) (whole_parameter s) (memory s)
    (offset_count s) (h_offsets s) (d_offsets s) (g49_sets_h0 s) (workpiece s) (external s) (additional s) (start s)
    (reference s) (floating s) (signal_at s) (angles_as_programmed s) (parts_of_block s) (cutter_b s) (without_perpendicular s)
    (series_30i s) (tip_cancel_moves s) (kinematics_by_parameters s).

(** * Older parameters *)

(** fanuc.tool-direction.older-parameters: a rotation axis of one component turns linear axis 1 toward linear axis 2.
    fanuc.tool-direction.older-inclined-axis: one of two components points along sin(alpha) e1 + cos(alpha) e3. *)
Definition older_axis {num} {N : Numbers num} (s : setup num) (number linear_1 linear_2 linear_3 inclination : string) :
    rotary_axis num :=
  let direction parameter :=
    match nth_error (axes s) (place_of_axis (whole_of s parameter)) with
    | Some Letter.X => axis_direction 1 0%num
    | Some Letter.Y => axis_direction 2 0%num
    | _ => axis_direction 3 0%num
    end in
  let about :=
    match parameter s inclination with
    | Some alpha =>
        match sign alpha with
        | Some Eq => cross3 (direction linear_1) (direction linear_2)
        | _ => add3 (scale3 (sine alpha) (direction linear_1)) (scale3 (cosine alpha) (direction linear_3))
        end
    | None => cross3 (direction linear_1) (direction linear_2)
    end in
  RotaryAxis (Some (place_of_axis (whole_of s number))) 0%num about false.

(** fanuc.tool-direction.older-parameters: 19610 to 19614 turn the tool first, then 19615 to 19619, from their reference
    angles; where 19615 is 0 there is no second group. *)
Definition older_axes {num} {N : Numbers num} (s : setup num) : list (rotary_axis num * num) :=
  if whole_of s "19610" =? 0 then []
  else (older_axis s "19610" "19611" "19612" "19613" "19614", parameter_of s "19620") ::
       if whole_of s "19615" =? 0 then []
       else [(older_axis s "19615" "19616" "19617" "19618" "19619", parameter_of s "19621")].

(** * The direction *)

(** fanuc.tool-direction.rotary-angles: machine coordinates, or by the setup the programmed ones; what is added to a
    programmed position. *)
Definition angle_zero {num} {N : Numbers num} (s : setup num) (c : coordinates num) : values num :=
  if angles_as_programmed s then zeros s else work_zero s c.

(** The degrees of a rotary axis among those of all axes. *)
Definition degrees_of {num} {N : Numbers num} (a : rotary_axis num) (angles : values num) : num :=
  match at_axis a with Some place => nth place angles 0%num | None => stands a end.

(** A vector that an axis carries, turned with it. *)
Definition carried {num} {N : Numbers num} (a : rotary_axis num) (x : angle num) (v : triple num) : triple num :=
  turned (about a) (cosine_of x) (if left_handed a then (- sine_of x)%num else sine_of x) v.
(** And seen from what it carries. *)
Definition carried_back {num} {N : Numbers num} (a : rotary_axis num) (x : angle num) (v : triple num) : triple num :=
  turned (about a) (cosine_of x) (if left_handed a then sine_of x else (- sine_of x)%num) v.

(** The positions of both rotary axes. *)
Definition pose (num : Type) := (angle num * angle num)%type.

(** fanuc.tool-direction.mechanism: V = R(u_w, sigma_w omega) R(u_t, sigma_t tau) t0; a turn of a table acts on the
    direction backwards.
    fanuc.tool-direction.table-outside-tip-control: so it is seen from the table at its zero pose. *)
Definition direction_at {num} {N : Numbers num} (k : kinematics num) (p : pose num) : triple num :=
  let '(a1, a2) := p in
  match machine_of k with
  | ToolRotation => carried (first_axis k) a1 (carried (second_axis k) a2 (reference_direction k))
  | TableRotation => carried_back (second_axis k) a2 (carried_back (first_axis k) a1 (reference_direction k))
  | Mixed => carried_back (second_axis k) a2 (carried (first_axis k) a1 (reference_direction k))
  end.

Definition pose_at {num} {N : Numbers num} (s : setup num) (k : kinematics num) (c : coordinates num)
    (position : values num) : pose num :=
  let angles := sum position (angle_zero s c) in
  (angle_of_degrees (degrees_of (first_axis k) angles), angle_of_degrees (degrees_of (second_axis k) angles)).

(** fanuc.tool-direction.table-stands: on the 30i, outside tool center point control, compensation is programmed in the
    workpiece system, which stands while the table turns; only with 19746#4 = 1 and 19696#5 = 0 does it turn. *)
Definition table_stands {num} (s : setup num) (k : kinematics num) : bool :=
  match machine_of k with
  | ToolRotation => false
  | _ => series_30i s && negb (bit s "19746#4" && negb (bit s "19696#5"))
  end.
Definition direction_in_machine {num} {N : Numbers num} (k : kinematics num) (p : pose num) : triple num :=
  match machine_of k with
  | ToolRotation => direction_at k p
  | TableRotation => reference_direction k
  | Mixed => carried (first_axis k) (fst p) (reference_direction k)
  end.

(** fanuc.tool-direction.of-pose: VT points from the tip to the holder and follows the positions of the rotary axes. A
    setup without rotary axes that turn the tool has none to tell.
    fanuc.tool-direction.older-parameters: 19680 takes precedence over 19610; VT = R2(phi - phi0) R1(theta - theta0) v0.
    fanuc.tool-direction.older-tool-axis: v0 = (cos RA sin RB, -sin RA, cos RA cos RB). *)
Definition tool_axis_at {num} {N : Numbers num} (s : setup num) (c : coordinates num) (position : values num) :
    option (triple num) :=
  match kinematics_of s, older_axes s with
  | Some k, _ =>
      let p := pose_at s k c position in
      Some (if table_stands s k then direction_in_machine k p else direction_at k p)
  | None, [] => None
  | None, groups =>
      let angles := sum position (angle_zero s c) in
      let turned_by v group :=
        let '(a, reference) := group in carried a (angle_of_degrees (degrees_of a angles - reference)%num) v in
      Some (fold_left turned_by groups (tilted (parameter_of s "19622") (parameter_of s "19623")))
  end.

(** fanuc.tool-direction.of-pose: without rotary axes that turn the tool VT = (0, 0, 1). *)
Definition tool_direction {num} {N : Numbers num} (s : setup num) (c : coordinates num) (position : values num) :
    triple num :=
  or_else (tool_axis_at s c position) (axis_direction 3 0%num).
