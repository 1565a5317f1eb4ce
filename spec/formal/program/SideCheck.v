(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-side-compensation: interference, where the compensation plane changes and in one plane. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Arcs Corners LengthOffset SideState State Space Pose.
From Toolcomp Require Import Movements SidePlane SideWords SideBlocks SideGroups.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Change of the compensation plane *)

(** fanuc.tool-side.plane-change-angle: the tool turns by the limit angle or more; 6261, of which 0 means 45 degrees. *)
Definition turns_by_limit {num} {N : Numbers num} (s : setup num) (va vb : triple num) : outcome bool :=
  let clause := "fanuc.tool-side.plane-change-angle" in
  let given_limit := or_else (parameter s "6261") 0%num in
  none <- is_zero clause given_limit ;;
  let c := cosine (if none : bool then integer 45 else given_limit) in
  let product := dot3 va vb in
  let squares := (c * c * dot3 va va * dot3 vb vb)%num in
  (* The angle is at least the limit where its cosine is at most that of the limit. *)
  limit_sign <- decide clause c ;;
  angle_sign <- decide clause product ;;
  match limit_sign, angle_sign with
  | Gt, Gt => less <- is_negative clause (squares - product * product)%num ;; Got (negb less)
  | Gt, _ => Got true
  | Eq, Gt => Got false
  | Eq, _ => Got true
  | Lt, Lt => less <- is_negative clause (product * product - squares)%num ;; Got (negb less)
  | Lt, _ => Got false
  end.

(** fanuc.tool-side.plane-change-side, fanuc.tool-side.plane-change-reversal: the second and third condition.
    fanuc.tool-side.plane-change-alarm: where all three hold PS0041. *)
Definition plane_change {num} {N : Numbers num} (s : setup num) (a b : planned num) : outcome unit :=
  let va := tool_behind s a in
  let vb := tool_behind s b in
  turns <- turns_by_limit s va vb ;;
  if negb turns then Got tt
  else
    let wa := cross3 va (displacement s a) in
    against <- is_negative "fanuc.tool-side.plane-change-side" (dot3 wa (cross3 vb (displacement s b))) ;;
    if against : bool then Got tt
    else
      back <- is_negative "fanuc.tool-side.plane-change-reversal" (dot3 wa (cross3 va (displacement s b))) ;;
      alarm_if back "interference".

(** fanuc.tool-side.plane-change-check: NIC, and which corners are checked.
    fanuc.tool-side.q3: with Q there is no alarm. *)
Definition checks_plane_change {num} (s : setup num) (a : planned num) (r : rule) : bool :=
  negb (bit s "19605#5") && match r with ModeRule => true | _ => false end && negb (given (q_of a)).

(** * The vectors at the end of a block *)

(** fanuc.tool-side.two-blocks-without-movement, fanuc.tool-side.no-next-block: without B the perpendicular vector. *)
Definition standing_at_end {num} {N : Numbers num} (s : setup num) (a : planned num) (rest : list (planned num)) :
    outcome (standing num) :=
  let x := side_at_end a in
  let vt := tool_behind s a in
  zero <- is_zero "fanuc.cutter-c.value-zero" (side_value x) ;;
  negative <- is_negative "fanuc.cutter.side" (side_value x) ;;
  let r := if negative : bool then (- side_value x)%num else side_value x in
  f <- following_of s vt 0 false rest ;;
  match f with
  | None =>
      leg_a <- leg_in_plane s vt a (uncompensated (behind a)) (to_left (on_left x) r) ;;
      Got (Standing [(true, perpendicular (P := plane_of_tool vt) leg_a)] None None)
  | Some f =>
      let b := block_b f in
      let cancels := negb (asked (side_at_end b)) in
      let left_b := if cancels then on_left x else on_left (side_at_end b) in
      let rule := rule_of a zero f in
      if zero : bool then Got (Standing [(true, (0%num, 0%num, 0%num))] (Some (vt, 0%num)) (Some (at_place b)))
      else
        leg_a <- leg_in_plane s vt a (uncompensated (behind a)) (to_left (on_left x) r) ;;
        leg_b <- leg_in_plane s vt b (uncompensated (before b)) (to_left left_b r) ;;
        group <- group_of (P := plane_of_tool vt) s rule (q_of a) leg_a leg_b ;;
        kept <- without_small_differences s b group ;;
        _ <- (if checks_plane_change s a rule then plane_change s a b else Got tt) ;;
        Got (Standing kept (Some (vt, rho leg_b)) (Some (at_place b)))
  end.

(** * Interference in one plane *)

(** fanuc.cutter-c.interference-direction, fanuc.tool-side.interference-in-the-plane: a straight block against which the
    tool would go, both seen in its plane. *)
Definition goes_against {num} {N : Numbers num} (s : setup num) (b : planned num) (v w : triple num) : outcome bool :=
  let u := displacement s b in
  let moved := sub3 (add3 u w) v in
  is_negative "fanuc.cutter-c.interference-direction" (dot3 (projected (tool_behind s b) u) moved).

(** What an arc shows at one of its ends. *)
Inductive end_of_arc := TooSmall | Nothing | Ample.

(** fanuc.cutter-c.interference-radius: the offset is larger than the radius, as seen in a plane. *)
Definition radius_left {num} {N : Numbers num} (vt : triple num) (rho : num) (clockwise : bool) (p : plane)
    (radius : pair num) : outcome end_of_arc :=
  let clause := "fanuc.cutter-c.interference-radius" in
  seen <- seen_clockwise vt p clockwise ;;
  let inward := if seen then (- rho)%num else rho in
  let outward := projected vt (in_selected p radius) in
  let square := dot3 outward outward in
  smaller <- is_positive clause inward ;;
  if negb smaller then Got Ample
  else
    c <- decide clause (square - inward * inward)%num ;;
    Got (match c with Lt => TooSmall | Eq => Nothing | Gt => Ample end).

(** fanuc.cutter-c.interference-sweep: whether a sweep is more than a half circle. *)
Definition over_half {num} {N : Numbers num} (clockwise : bool) (a b : pair num) : outcome bool :=
  let clause := "fanuc.cutter-c.arc-sweep" in
  side <- decide clause (if clockwise then cross2 b a else cross2 a b) ;;
  match side with
  | Gt => Got false
  | Lt => Got true
  | Eq => is_positive clause (dot2 a b)
  end.

(** fanuc.cutter-c.interference-sweep: the sweep of the tool's arc differs from the programmed one by more than a half
    circle. *)
Definition sweeps_differ {num} {N : Numbers num} (clockwise : bool) (a b a' b' : pair num) : outcome bool :=
  programmed_over <- over_half clockwise a b ;;
  tool_over <- over_half clockwise a' b' ;;
  if Bool.eqb programmed_over tool_over then Got false
  else
    let turn x y := if clockwise then cross2 y x else cross2 x y in
    let '(small_a, small_b, large_a, large_b) := if programmed_over then (a', b', a, b) else (a, b, a', b') in
    let sine_of_difference :=
      (turn small_a small_b * dot2 large_a large_b - dot2 small_a small_b * turn large_a large_b)%num in
    is_positive "fanuc.cutter-c.interference-sweep" sine_of_difference.

Definition seen_selected {num} (p : plane) (v : triple num) : pair num :=
  let '(x, y, z) := v in match p with XY => (x, y) | ZX => (z, x) | YZ => (y, z) end.

(** An arc in its first pair: the radii, at the start in the plane of the corner there; then the sweeps. *)
Definition arc_interferes {num} {N : Numbers num} (s : setup num) (b : planned num) (clockwise : bool) (circle : arc num)
    (at_start : standing num) (v w : triple num) : outcome bool :=
  let p := arc_plane circle in
  let from := radius_vector s circle (uncompensated (before b)) in
  let to := radius_vector s circle (uncompensated (behind b)) in
  let x := side_at_end b in
  negative <- is_negative "fanuc.cutter.side" (side_value x) ;;
  let own := to_left (on_left x) (if negative : bool then (- side_value x)%num else side_value x) in
  let vt := tool_behind s b in
  let '(start_axis, start_rho) := or_else (corner_axis at_start) (vt, own) in
  first <- radius_left start_axis start_rho clockwise p from ;;
  second <- (match first with TooSmall => Got Ample | _ => radius_left vt own clockwise p to end) ;;
  match first, second with
  | TooSmall, _ | _, TooSmall => Got true
  | Nothing, _ | _, Nothing => Got false
  | Ample, Ample =>
      let a := add2 from (seen_selected p v) in
      let b := add2 to (seen_selected p w) in
      a_in_center <- is_zero "fanuc.cutter-c.interference-radius" (dot2 a a) ;;
      b_in_center <- is_zero "fanuc.cutter-c.interference-radius" (dot2 b b) ;;
      if a_in_center || b_in_center then Got false else sweeps_differ clockwise from to a b
  end.

(** fanuc.cutter-c.interference-pairs: from the corner moves outward; a pair with interference is dropped, but never the
    first vector at the start and never the last at the end. The vectors at the start are given from the last one on.
    fanuc.cutter-c.interference-straightened: an arc is a line from its second pair on. *)
Fixpoint dropped_pairs {num} {N : Numbers num} (s : setup num) (tries : nat) (b : planned num)
    (first_test : option (triple num -> triple num -> outcome bool)) (vs ws : list (head_vector num)) :
    outcome (list (head_vector num) * list (head_vector num) * bool) :=
  match tries, vs, ws with
  | S fewer, v :: before_v, w :: behind_w =>
      hit <- (match first_test with Some test => test (snd v) (snd w) | None => goes_against s b (snd v) (snd w) end) ;;
      if negb hit then Got (vs, ws, negb (given first_test))
      else
        match before_v, behind_w with
        | [], [] => Alarm "interference"
        | _, _ =>
            dropped_pairs s fewer b None (match before_v with [] => vs | _ => before_v end)
              (match behind_w with [] => ws | _ => behind_w end)
        end
  | _, _, _ => Got (vs, ws, false)
  end.

(** fanuc.cutter-c.interference-check: CNI. What is left at the start, what is left at the end, and whether an arc is
    straightened. *)
Definition interference {num} {N : Numbers num} (s : setup num) (b : planned num) (at_start at_end : standing num) :
    outcome (standing num * standing num * bool) :=
  if bit s "5008#0" then Got (at_start, at_end, false)
  else
    let test := match arc_of_block b with
                | Some (clockwise, circle) => Some (arc_interferes s b clockwise circle at_start)
                | None => None
                end in
    '(vs, ws, line_now) <-
      dropped_pairs s (List.length (heads at_start) + List.length (heads at_end)) b test (rev (heads at_start))
        (heads at_end) ;;
    Got (Standing (rev vs) (corner_axis at_start) (corner_b at_start),
         Standing ws (corner_axis at_end) (corner_b at_end), line_now && given test).
