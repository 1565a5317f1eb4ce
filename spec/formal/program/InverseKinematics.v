(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool center point control of type 2: the pairs of rotary positions of a direction. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Angles ControlState State Space Pose.
From Toolcomp Require Import ControlFrame ControlWords.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** Whether the sense as it acts on the direction is -1: sigma. *)
Definition tool_reversed {num} (k : kinematics num) : bool :=
  xorb (left_handed (tool_side k)) (match machine_of k with TableRotation => true | _ => false end).
Definition work_reversed {num} (k : kinematics num) : bool :=
  xorb (left_handed (work_side k)) (match machine_of k with ToolRotation => false | _ => true end).

(** Positions on the tool side and on the work side. *)
Definition sides (num : Type) := (angle num * angle num)%type.
Definition sides_of {num} (k : kinematics num) (p : pose num) : sides num :=
  match machine_of k with ToolRotation => (snd p, fst p) | _ => p end.
Definition pose_of_sides {num} (k : kinematics num) (p : sides num) : pose num :=
  match machine_of k with ToolRotation => (snd p, fst p) | _ => p end.

(** fanuc.tool-center-point.inverse: p = (t0 . u_t) u_t; q = t0 - p; r = u_t x t0; A = u_w . q; B = u_w . r. *)
Record reach (num : Type) := Reach {
  along_axis : num;      (* u_w . p *)
  toward : num;          (* A *)
  across : num;          (* B *)
  radius_square : num    (* rho^2 *)
}.
Arguments Reach {num}. Arguments along_axis {num}. Arguments toward {num}. Arguments across {num}. Arguments radius_square {num}.
Definition reach_of {num} {N : Numbers num} (k : kinematics num) : reach num :=
  let u_t := about (tool_side k) in
  let u_w := about (work_side k) in
  let t0 := reference_direction k in
  let p := scale3 (dot3 t0 u_t) u_t in
  let a := dot3 u_w (sub3 t0 p) in
  let b := dot3 u_w (cross3 u_t t0) in
  Reach (dot3 u_w p) a b (a * a + b * b)%num.

(** fanuc.tool-posture.singular: +u_w can be reached if alpha = beta, -u_w if alpha + beta = 180, with alpha the angle
    between u_t and t0 and beta the angle between u_t and u_w. *)
Definition reaches_work_axis {num} {N : Numbers num} (k : kinematics num) (opposite : bool) : outcome bool :=
  let alpha := dot3 (about (tool_side k)) (reference_direction k) in
  let beta := dot3 (about (tool_side k)) (about (work_side k)) in
  is_zero "fanuc.tool-posture.singular" (if opposite then alpha + beta else alpha - beta)%num.

(** A position by the cosine and the sine of the angle that it turns the direction by. *)
Definition position_by {num} {N : Numbers num} (reversed : bool) (c s : num) : outcome (angle num) :=
  angle_of_unit "fanuc.tool-center-point.inverse" c (if reversed then (- s)%num else s).

(** The direction that a position on the tool side gives, before the work side turns it: R(u_t, sigma_t tau) t0. *)
Definition on_tool_side {num} {N : Numbers num} (k : kinematics num) (c s : num) : triple num :=
  turned (about (tool_side k)) c s (reference_direction k).

(** fanuc.tool-center-point.inverse: omega' = atan2(u_w . (w' x V), w' . V - (u_w . w') (u_w . V)), of a V that is not
    parallel to u_w. The other component is |V|^2 - (u_w . V)^2 over |V| for w' as for V. *)
Definition work_position {num} {N : Numbers num} (k : kinematics num) (w v : triple num) : outcome (angle num) :=
  let u_w := about (work_side k) in
  let along := dot3 u_w v in
  let size := ((dot3 v v - along * along) / length3 v)%num in
  let c := ((dot3 w v - dot3 u_w w * along) / size)%num in
  let s := (dot3 u_w (cross3 w v) / size)%num in
  position_by (work_reversed k) c s.

(** fanuc.tool-center-point.reach-toward-the-axis: V can be no nearer to u_w than |alpha - beta|; not asked if they are
    equal. fanuc.tool-center-point.reach-away-from-the-axis: and no farther than the smaller of alpha + beta and
    360 - alpha - beta; not asked if alpha + beta is 180.
    fanuc.tool-center-point.unreachable: else PS5459. Whether V is on the edge of reach: then there is one pair. *)
Definition on_edge_of_reach {num} {N : Numbers num} (k : kinematics num) (rho c : num) : outcome bool :=
  let asked clause opposite x :=
    never <- reaches_work_axis k opposite ;;
    if never : bool then Got false
    else
      inside <- decide clause x ;;
      match inside with Lt => Alarm "unreachable" | Eq => Got true | Gt => Got false end in
  near <- asked "fanuc.tool-center-point.reach-toward-the-axis" false (rho - c)%num ;;
  far <- asked "fanuc.tool-center-point.reach-away-from-the-axis" true (rho + c)%num ;;
  Got (near || far).

(** fanuc.tool-center-point.inverse: C = u_w . V/|V| - u_w . p; rho = sqrt(A^2 + B^2); tau' = atan2(B, A) +- acos(C/rho).
    The cosine and the sine of tau' above and below atan2(B, A), or the one of both on the edge of reach. *)
Definition tool_angles {num} {N : Numbers num} (k : kinematics num) (v : triple num) : outcome (list (num * num)) :=
  let r := reach_of k in
  let c := (dot3 (about (work_side k)) v / length3 v - along_axis r)%num in
  edge <- on_edge_of_reach k (root (radius_square r)) c ;;
  let by_root h :=
    (((toward r * c - across r * h) / radius_square r)%num, ((across r * c + toward r * h) / radius_square r)%num) in
  if edge : bool then Got [by_root 0%num]
  else let h := root (radius_square r - c * c)%num in Got [by_root h; by_root (- h)%num].

(** A direction that is not parallel to u_w, as the work-side axis has it and as seen from the zero pose of the table: its
    pairs, each within one turn. *)
Definition pairs_of {num} {N : Numbers num} (k : kinematics num) (v from_zero_pose : triple num) :
    outcome (list (sides num)) :=
  angles <- tool_angles k v ;;
  each
    (fun cs =>
      let '(c, s) := cs in
      tau <- position_by (tool_reversed k) c s ;;
      omega <- work_position k (on_tool_side k c s) from_zero_pose ;;
      Got (tau, omega))
    angles.

(** fanuc.tool-posture.singular: S(+u_w) = sigma_t atan2(B, A), S(-u_w) = that + 180, within one turn. *)
Definition singular_position {num} {N : Numbers num} (k : kinematics num) (opposite : bool) : outcome (angle num) :=
  let r := reach_of k in
  let rho := root (radius_square r) in
  let over x := if opposite then (- x / rho)%num else (x / rho)%num in
  position_by (tool_reversed k) (over (toward r)) (over (across r)).

(** fanuc.tool-center-point.parallel-to-the-work-side: whether V is parallel to u_w; then whether it is opposite. *)
Definition parallel_to_work_axis {num} {N : Numbers num} (k : kinematics num) (v : triple num) : outcome (option bool) :=
  let n := cross3 (about (work_side k)) v in
  parallel <- is_zero "fanuc.tool-center-point.parallel-to-the-work-side" (dot3 n n) ;;
  if parallel : bool then
    opposite <- is_negative "fanuc.tool-center-point.parallel-to-the-work-side" (dot3 (about (work_side k)) v) ;;
    Got (Some opposite)
  else Got None.
