(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool posture control, P1 of G43.4 and G43.5: how the rotary axes run in a block. Directions are as the
    work-side axis has them, turned about it by whatever angle; those from zero as seen from the zero pose of the table. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Angles ControlState State Space Pose.
From Toolcomp Require Import ControlFrame ControlWords InverseKinematics ChoiceOfPair PostureAngles.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Singular postures *)

(** +u_w and -u_w. *)
Definition singular_direction {num} {N : Numbers num} (k : kinematics num) (opposite : bool) : triple num :=
  let u_w := about (work_side k) in if opposite then scale3 (0 - 1)%num u_w else u_w.

(** fanuc.tool-posture.at-start, fanuc.tool-posture.at-end: whether a direction is singular, asked of +u_w, then of -u_w, as
    far as they exist. *)
Definition singular_at {num} {N : Numbers num} (clause : string) (k : kinematics num) (v : triple num) :
    outcome (option bool) :=
  let asked opposite :=
    exists_ <- reaches_work_axis k opposite ;;
    if exists_ : bool then same_direction clause (singular_direction k opposite) v else Got false in
  at_first <- asked false ;;
  if at_first : bool then Got (Some false)
  else at_second <- asked true ;; Got (if at_second : bool then Some true else None).

(** * Conventional control *)

(** fanuc.tool-posture.no-plane, fanuc.tool-posture.branch-mismatch: the block runs under conventional control. *)
Definition conventionally {num} (warned : bool) (from to : pose num) : rotary_run num :=
  RotaryRun from from to to false false Evenly warned.

(** fanuc.tool-posture.pre-turn, fanuc.tool-posture.post-turn: made only if the position changes. *)
Definition is_turn (c : comparison) : bool := match c with Eq => false | _ => true end.

(** * A singular start *)

(** The branch on which a pair lies; on the edge of reach, the one toward a position on the tool side. *)
Definition branch_of_pair {num} {N : Numbers num} (k : kinematics num) (opposite : bool) (tau toward : angle num) :
    outcome bool :=
  let x := beside_of_position k tau in
  side <- decide "fanuc.tool-posture.branch" (across_nearest x) ;;
  match side with
  | Gt => Got true
  | Lt => Got false
  | Eq =>
      up <- compare_angles "fanuc.tool-posture.branch" tau toward ;;
      Got (xorb (xorb (match up with Lt => false | _ => true end) (tool_reversed k)) opposite)
  end.

(** fanuc.tool-posture.at-start: the great circle is followed back from the end pair to the start; the work-side axis turns
    to the value found there before the block (fanuc.tool-posture.pre-turn).
    fanuc.tool-posture.branch-mismatch: if the tool-side axis, followed back, does not come to its position at the
    start, the block runs under conventional control. *)
Definition from_singular {num} {N : Numbers num} (k : kinematics num) (opposite : bool) (from to : pose num)
    (vs ve ve_from_zero : triple num) : outcome (rotary_run num) :=
  let '(tau, omega) := sides_of k from in
  let '(tau_e, omega_e) := sides_of k to in
  above <- branch_of_pair k opposite tau_e tau ;;
  let x_e := beside_of_position k tau_e in
  degrees_e <- beside_degrees k above x_e ;;
  degrees_s <- beside_degrees k above (beside_singular k opposite) ;;
  comes <- is_position tau (lifted_tool k None above tau_e degrees_e degrees_s) ;;
  if negb comes then Got (conventionally true from to)
  else
    let leaving := leaving_singular k opposite above in
    let '(c, s) := tool_angle k x_e in
    one_turn <- work_turn k leaving ve_from_zero ;;
    bracket <- bracket_of_side k false degrees_e degrees_s (on_tool_side k c s) leaving ;;
    omega_s <- position_near one_turn (lifted_work k omega_e 0%num bracket) ;;
    turn <- compare_angles "fanuc.tool-posture.pre-turn" omega_s omega ;;
    Got (RotaryRun from (pose_of_sides k (tau, omega_s)) to to (is_turn turn) false
           (OnGreatCircle (GreatCircle vs ve (tau_e, omega_e) true above None true)) false).

(** * The branch *)

(** fanuc.tool-posture.branch: the side on which the tool-side angle lies, seen from the angle at which the tool is
    nearest to u_w, given as a sign. At a start on the edge of reach it is the one toward the pair; if that pair is on
    the same edge, the one above. *)
Definition branch_at_start {num} {N : Numbers num} (k : kinematics num) (tau : angle num) (pair : outcome (pose num)) :
    outcome bool :=
  let clause := "fanuc.tool-posture.branch" in
  let x := beside_of_position k tau in
  side <- decide clause (across_nearest x) ;;
  match side with
  | Gt => Got true
  | Lt => Got false
  | Eq =>
      to <- pair ;;
      let tau_e := fst (sides_of k to) in
      let x_e := beside_of_position k tau_e in
      side <- decide clause (across_nearest x_e) ;;
      match side with
      | Gt => Got true
      | Lt => Got false
      | Eq =>
          same <- is_positive clause (along_nearest x * along_nearest x_e)%num ;;
          if same : bool then Got true
          else
            near <- is_positive clause (along_nearest x) ;;
            up <- compare_angles clause tau_e tau ;;
            let upward := xorb (match up with Gt => true | _ => false end) (tool_reversed k) in
            Got (Bool.eqb upward near)
      end
  end.

(** * A singular end *)

(** fanuc.tool-posture.at-end: the work-side axis ends where the great circle leads it in the limit.
    fanuc.tool-posture.post-turn: type 1: then it turns to the position commanded.
    fanuc.tool-posture.branch-mismatch: type 1, if the tool side is not the one commanded: conventional control.
    fanuc.tool-center-point.range-none: type 2, an end pair outside raises PS5459. *)
Definition end_in_range {num} {N : Numbers num} (s : setup num) (to : pose num) : outcome unit :=
  '(first_range, second_range) <- ranges s ;;
  first_fine <- in_range first_range (fst to) ;;
  second_fine <- in_range second_range (snd to) ;;
  alarm_if (negb (first_fine && second_fine)) "unreachable".

Definition to_singular {num} {N : Numbers num} (s : setup num) (k : kinematics num) (opposite above : bool) (from : pose num)
    (commanded : option (pose num)) (vs ve vs_from_zero : triple num) : outcome (rotary_run num) :=
  let '(tau, omega) := sides_of k from in
  let x := beside_of_position k tau in
  degrees_s <- beside_degrees k above x ;;
  degrees_e <- beside_degrees k above (beside_singular k opposite) ;;
  let tau_number := lifted_tool k None above tau degrees_s degrees_e in
  let leaving := leaving_singular k opposite above in
  let '(cosine_s, sine_s) := tool_angle k x in
  one_turn <- work_turn k leaving vs_from_zero ;;
  bracket <- bracket_of_side k false degrees_s degrees_e (on_tool_side k cosine_s sine_s) leaving ;;
  omega_e <- position_near one_turn (lifted_work k omega 0%num bracket) ;;
  let way := OnGreatCircle (GreatCircle vs ve (tau, omega) false above None true) in
  match commanded with
  | Some to =>
      let '(tau_e, omega_commanded) := sides_of k to in
      comes <- is_position tau_e tau_number ;;
      if comes : bool then
        turn <- compare_angles "fanuc.tool-posture.post-turn" omega_commanded omega_e ;;
        Got (RotaryRun from from (pose_of_sides k (tau_e, omega_e)) to false (is_turn turn) way false)
      else Got (conventionally true from to)
  | None =>
      tau_one_turn <- singular_position k opposite ;;
      tau_e <- position_near tau_one_turn tau_number ;;
      let to := pose_of_sides k (tau_e, omega_e) in
      _ <- end_in_range s to ;;
      Got (RotaryRun from from to to false false way false)
  end.

(** * Where the great circle runs *)

(** Where it lies to the singular directions: of +u_w; for -u_w every sign is the other one. *)
Record circle_place := CirclePlace { plane_side : comparison; behind_start : comparison; before_end : comparison }.

(** fanuc.tool-posture.crossing, fanuc.tool-posture.foot-behind-the-start, fanuc.tool-posture.foot-before-the-end: N . s,
    (Vs x s) . N and (s x Ve) . N. *)
Definition place_of_circle {num} {N : Numbers num} (k : kinematics num) (n vs ve : triple num) : outcome circle_place :=
  let u_w := about (work_side k) in
  side <- decide "fanuc.tool-posture.crossing" (dot3 n u_w) ;;
  behind <- decide "fanuc.tool-posture.foot-behind-the-start" (dot3 (cross3 vs u_w) n) ;;
  before <- decide "fanuc.tool-posture.foot-before-the-end" (dot3 (cross3 u_w ve) n) ;;
  Got (CirclePlace side behind before).
Definition in_work_plane (p : circle_place) : bool := match plane_side p with Eq => true | _ => false end.
(** Whether the foot of a singular direction lies inside; ties count. *)
Definition foot_inside (p : circle_place) (opposite : bool) : bool :=
  let fine c := match c, opposite with Lt, false | Gt, true => false | _, _ => true end in
  fine (behind_start p) && fine (before_end p).

(** fanuc.tool-posture.crossing: a singular direction that the circle goes through exactly, inside the block. *)
Definition crossing_of {num} {N : Numbers num} (k : kinematics num) (p : circle_place) : outcome (option bool) :=
  first <- reaches_work_axis k false ;;
  second <- reaches_work_axis k true ;;
  let through opposite := in_work_plane p && foot_inside p opposite in
  Got (if first && through false then Some false else if second && through true then Some true else None).

(** fanuc.tool-posture.reach-inside: asked at the point nearest to u_w, if the foot of u_w lies inside and alpha differs
    from beta, and at the farthest, if the foot of -u_w lies inside and alpha + beta differs from 180. *)
Definition stays_in_reach {num} {N : Numbers num} (k : kinematics num) (p : circle_place) (n : triple num) : outcome unit :=
  let r := reach_of k in
  let rho := root (radius_square r) in
  let across := dot3 n (about (work_side k)) in
  let nearest := root (1 - across * across / dot3 n n)%num in
  let asked opposite x :=
    exists_ <- reaches_work_axis k opposite ;;
    if foot_inside p opposite && negb exists_ then
      outside <- is_negative "fanuc.tool-posture.reach-inside" x ;; alarm_if outside "unreachable"
    else Got tt in
  _ <- asked false (along_axis r + rho - nearest)%num ;;
  asked true (rho - along_axis r - nearest)%num.

(** * The end pair *)

(** fanuc.tool-posture.lift: what the great circle leads to, both sides in degrees, on the branch that it ends on. *)
Definition led_to {num} {N : Numbers num} (k : kinematics num) (crossing : option bool) (above : bool) (from : sides num)
    (vs ve : triple num) (x_e : beside num) : outcome (num * num) :=
  let '(tau, omega) := from in
  let x := beside_of_position k tau in
  let crossed := given crossing in
  degrees_s <- beside_degrees k above x ;;
  degrees_e <- beside_degrees k (xorb above crossed) x_e ;;
  let '(cosine_s, sine_s) := tool_angle k x in
  let '(cosine_e, sine_e) := tool_angle k x_e in
  of_side <- bracket_of_side k crossed degrees_s degrees_e (on_tool_side k cosine_s sine_s)
               (on_tool_side k cosine_e sine_e) ;;
  let of_tool := if crossed then 0%num else let '(c, s) := azimuth_between k vs ve in degrees_by c s in
  Got (lifted_tool k crossing above tau degrees_s degrees_e, lifted_work k omega of_tool of_side).

(** fanuc.tool-posture.branch-mismatch: type 1: the pair is the one commanded, by whole turns and by the branch. *)
Definition leads_to_commanded {num} {N : Numbers num} (k : kinematics num) (crossing : option bool) (above : bool)
    (from commanded : sides num) (vs ve : triple num) : outcome bool :=
  let '(tau_e, omega_e) := commanded in
  let x_e := beside_of_position k tau_e in
  side <- decide "fanuc.tool-posture.branch-mismatch" (across_nearest x_e) ;;
  let on_branch := match side, xorb above (given crossing) with Gt, false | Lt, true => false | _, _ => true end in
  if negb on_branch then Got false
  else
    '(tau_number, omega_number) <- led_to k crossing above from vs ve x_e ;;
    tau_same <- is_position tau_e tau_number ;;
    if tau_same : bool then is_position omega_e omega_number else Got false.

(** Type 2: the end pair, whole turns included. *)
Definition end_pair {num} {N : Numbers num} (k : kinematics num) (crossing : option bool) (above edge : bool)
    (from : sides num) (vs ve ve_from_zero : triple num) : outcome (sides num) :=
  let x_e := beside_of_direction k edge (xorb above (given crossing)) ve in
  '(tau_number, omega_number) <- led_to k crossing above from vs ve x_e ;;
  let '(c, s) := tool_angle k x_e in
  tau_one_turn <- position_by (tool_reversed k) c s ;;
  omega_one_turn <- work_position k (on_tool_side k c s) ve_from_zero ;;
  tau_e <- position_near tau_one_turn tau_number ;;
  omega_e <- position_near omega_one_turn omega_number ;;
  Got (tau_e, omega_e).

(** * Near a singular posture *)

(** The cosine of the distance of a singular direction from the great circle between the ends: that of the foot where that
    lies inside, else that of the nearer end: of the start where the foot lies before it and not behind the end. *)
Definition cosine_of_distance {num} {N : Numbers num} (k : kinematics num) (p : circle_place) (opposite : bool)
    (n vs ve : triple num) : outcome num :=
  let s := singular_direction k opposite in
  if foot_inside p opposite then
    let across := dot3 n s in Got (root (1 - across * across / dot3 n n)%num)
  else
    let at_start := (dot3 s vs / length3 vs)%num in
    let at_end := (dot3 s ve / length3 ve)%num in
    let outside c := match c, opposite with Lt, false | Gt, true => true | _, _ => false end in
    start_nearer <-
      match outside (behind_start p), outside (before_end p) with
      | true, false => Got true
      | false, _ => Got false
      | true, true => is_positive "fanuc.tool-posture.nearer-singular" (at_start - at_end)%num
      end ;;
    Got (if start_nearer : bool then at_start else at_end).

(** fanuc.tool-posture.near-limit: 19738; at 0 or below none.
    fanuc.tool-posture.nearer-singular: if both exist, the one nearer counts, and +u_w if they are equally near. One
    whose foot lies inside is no farther than the other.
    fanuc.tool-posture.near: strictly smaller than 19738, as an angle from 0 to 180. The singular direction that is near. *)
Definition near_singular {num} {N : Numbers num} (s : setup num) (k : kinematics num) (p : circle_place)
    (n vs ve : triple num) : outcome (option bool) :=
  let limit := parameter_of s "19738" in
  looked_for <- is_positive "fanuc.tool-posture.near-limit" limit ;;
  first <- reaches_work_axis k false ;;
  second <- reaches_work_axis k true ;;
  if negb (looked_for && (first || second)) then Got None
  else
    opposite <-
      (if first && second then
         if foot_inside p false then Got false
         else if foot_inside p true then Got true
         else
           to_first <- cosine_of_distance k p false n vs ve ;;
           to_second <- cosine_of_distance k p true n vs ve ;;
           is_negative "fanuc.tool-posture.nearer-singular" (to_first - to_second)%num
       else Got (negb first)) ;;
    let clause := "fanuc.tool-posture.near" in
    near <-
      (if foot_inside p opposite then
         over <- is_positive clause (limit - integer 90)%num ;;
         if over : bool then Got true
         else
           let across := dot3 n (about (work_side k)) in
           let sine_of_limit := sine limit in
           is_positive clause (sine_of_limit * sine_of_limit * dot3 n n - across * across)%num
       else
         over <- is_positive clause (limit - integer 180)%num ;;
         if over : bool then Got true
         else
           distance <- cosine_of_distance k p opposite n vs ve ;;
           is_positive clause (distance - cosine limit)%num) ;;
    Got (if near : bool then Some opposite else None).

(** fanuc.tool-posture.veto: the end is not changed if |omega_e - omega_s0 - 180| is over 19739; a limit below 0 always
    vetoes, a limit of 180 or more never does. *)
Definition vetoed {num} {N : Numbers num} (s : setup num) (omega omega_e : angle num) : outcome bool :=
  let clause := "fanuc.tool-posture.veto" in
  let limit := parameter_of s "19739" in
  always <- is_negative clause limit ;;
  sometimes <- is_negative clause (limit - integer 180)%num ;;
  if always : bool then Got true
  else if sometimes : bool then is_negative clause (0 - cosine_between omega_e omega - cosine limit)%num
  else Got false.

(** fanuc.tool-posture.changed: tau_e' = 2 S - tau_e; omega_e' = omega_s0.
    fanuc.tool-posture.singular-turn: S is the one nearest to the position at the start, on the side of the branch. *)
Definition changed_end {num} {N : Numbers num} (k : kinematics num) (opposite above : bool) (from : sides num)
    (tau_e : angle num) : outcome (pose num) :=
  let '(tau, omega) := from in
  degrees_s <- beside_degrees k above (beside_of_position k tau) ;;
  degrees_singular <- beside_degrees k above (beside_singular k opposite) ;;
  one_turn <- singular_position k opposite ;;
  singular <- position_near one_turn (lifted_tool k None above tau degrees_s degrees_singular) ;;
  onward <- angle_between_positions lift_clause singular tau_e ;;
  mirrored <- angle_sum lift_clause singular onward ;;
  Got (pose_of_sides k (mirrored, omega)).

(** * A block *)

(** Type 2, where no singular posture is met: the end pair, or near a singular posture the changed one; whether it is.
    fanuc.tool-posture.passing: then the rotary axes run evenly, and the work side stands.
    fanuc.tool-posture.refused: 19696#3: if a near end is not changed, because of the veto or the range, PS5421. *)
Definition to_direction {num} {N : Numbers num} (s : setup num) (k : kinematics num) (crossing : option bool)
    (above edge : bool) (p : circle_place) (from : pose num) (n vs ve ve_from_zero : triple num) :
    outcome (rotary_run num * bool) :=
  let start := sides_of k from in
  '(tau_e, omega_e) <- end_pair k crossing above edge start vs ve ve_from_zero ;;
  near <- (if given crossing then Got None else near_singular s k p n vs ve) ;;
  changed <-
    match near with
    | Some opposite =>
        veto <- vetoed s (snd start) omega_e ;;
        changed <-
          (if veto : bool then Got None
           else
             to <- changed_end k opposite above start tau_e ;;
             '(first_range, second_range) <- ranges s ;;
             first_fine <- in_range first_range (fst to) ;;
             second_fine <- in_range second_range (snd to) ;;
             Got (if first_fine && second_fine then Some to else None)) ;;
        _ <- alarm_if (negb (given changed) && bit s "19696#3") "singular-posture" ;;
        Got changed
    | None => Got None
    end ;;
  match changed with
  | Some to => Got (conventionally false from to, true)
  | None =>
      let to := pose_of_sides k (tau_e, omega_e) in
      _ <- end_in_range s to ;;
      Got (RotaryRun from from to to false false (OnGreatCircle (GreatCircle vs ve start false above crossing (in_work_plane p))) false, false)
  end.

(** fanuc.tool-posture.order: the questions of a block with P1. Type 1 has a pose commanded, type 2 none. How the rotary axes
    run, and whether the end posture is changed. *)
Definition posture_run {num} {N : Numbers num} (s : setup num) (k : kinematics num) (from : pose num)
    (commanded : option (pose num)) (vs ve vs_from_zero ve_from_zero : triple num) : outcome (rotary_run num * bool) :=
  let start := sides_of k from in
  let pair := match commanded with Some to => Got to | None => choose s k from vs ve ve_from_zero end in
  let unchanged x := run <- x ;; Got (run, false) in
  (* The reach of Ve; whether it lies on the edge. *)
  edge <-
    match commanded with
    | Some _ => Got false
    | None =>
        parallel <- parallel_to_work_axis k ve ;;
        match parallel with
        | Some opposite =>
            reached <- reaches_work_axis k opposite ;;
            _ <- alarm_if (negb reached) "unreachable" ;;
            Got false
        | None => angles <- tool_angles k ve ;; Got (match angles with [_] => true | _ => false end)
        end
    end ;;
  let n := cross3 vs ve in
  no_plane <- (if known_same3 vs ve then Got true else is_zero "fanuc.tool-posture.no-plane" (dot3 n n)) ;;
  if no_plane : bool then unchanged (to <- pair ;; Got (conventionally false from to))
  else
    at_start <- singular_at "fanuc.tool-posture.at-start" k vs ;;
    match at_start with
    | Some opposite => unchanged (to <- pair ;; from_singular k opposite from to vs ve ve_from_zero)
    | None =>
        at_end <- singular_at "fanuc.tool-posture.at-end" k ve ;;
        above <- branch_at_start k (fst start) pair ;;
        match at_end with
        | Some opposite => unchanged (to_singular s k opposite above from commanded vs ve vs_from_zero)
        | None =>
            p <- place_of_circle k n vs ve ;;
            crossing <- crossing_of k p ;;
            _ <- stays_in_reach k p n ;;
            match commanded with
            | Some to =>
                leads <- leads_to_commanded k crossing above start (sides_of k to) vs ve ;;
                unchanged (Got (if leads : bool
                                then RotaryRun from from to to false false
                                       (OnGreatCircle (GreatCircle vs ve start false above crossing (in_work_plane p))) false
                                else conventionally true from to))
            | None => to_direction s k crossing above edge p from n vs ve ve_from_zero
            end
        end
    end.
