(* SPDX-License-Identifier: Apache-2.0 *)
(** The interference check of a block: the vectors at its start against those at its end, in a plane. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Codes Arcs Corners.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** The programmed path of a block. *)
Record path (num : Type) := Path {
  starts : pair num;
  finishes : pair num;
  about : option (bool * pair num)     (* of an arc: whether clockwise, and the centre *)
}.
Arguments Path {num}. Arguments starts {num}. Arguments finishes {num}. Arguments about {num}.

(** fanuc.cutter-c.interference-direction: a straight block interferes where the tool goes by more than 90 degrees from
    the programmed direction. *)
Definition line_interferes {num} {N : Numbers num} (p : path num) (v w : pair num) : outcome bool :=
  let travel := sub2 (finishes p) (starts p) in
  is_negative "fanuc.cutter-c.interference-direction" (dot2 travel (add2 travel (sub2 w v))).

(** fanuc.cutter-c.interference-radius: the offset against the radius at an end. *)
Definition radius_left {num} {N : Numbers num} (clockwise : bool) (radius : pair num) (rho : num) :
    outcome comparison :=
  let clause := "fanuc.cutter-c.interference-radius" in
  let inward := if clockwise then (- rho)%num else rho in
  smaller <- is_positive clause inward ;;
  if smaller : bool then decide clause (square2 radius - inward * inward)%num else Got Gt.

(** Sine and cosine of a sweep, by the same positive number, and whether it is over 180 degrees. *)
Definition turn {num} {N : Numbers num} (clockwise : bool) (from to : pair num) : outcome (num * num * bool) :=
  let clause := "fanuc.cutter-c.interference-sweep" in
  let across := if clockwise then cross2 to from else cross2 from to in
  let along := dot2 from to in
  side <- decide clause across ;;
  over <- match side with Gt => Got false | Lt => Got true | Eq => is_positive clause along end ;;
  Got (across, along, over).

(** fanuc.cutter-c.interference-sweep: the sweep of the tool's arc differs from the programmed one by more than 180
    degrees. *)
Definition sweep_interferes {num} {N : Numbers num} (clockwise : bool) (from to tool_from tool_to : pair num) :
    outcome bool :=
  '(sin1, cos1, over1) <- turn clockwise from to ;;
  '(sin2, cos2, over2) <- turn clockwise tool_from tool_to ;;
  (* The sine of the smaller less the larger one. *)
  let difference := match over1, over2 with
                    | false, true => Some (sin1 * cos2 - cos1 * sin2)%num
                    | true, false => Some (sin2 * cos1 - cos2 * sin1)%num
                    | _, _ => None
                    end in
  match difference with
  | Some x => is_positive "fanuc.cutter-c.interference-sweep" x
  | None => Got false
  end.

(** An arc block in its first pair; rho of the corner at its start and of its own end. *)
Definition arc_interferes {num} {N : Numbers num} (p : path num) (clockwise : bool) (center : pair num)
    (rho_at_start rho_at_end : num) (v w : pair num) : outcome bool :=
  let clause := "fanuc.cutter-c.interference-radius" in
  let from := sub2 (starts p) center in
  let to := sub2 (finishes p) center in
  at_start <- radius_left clockwise from rho_at_start ;;
  match at_start with
  | Lt => Got true
  | _ =>
      at_end <- radius_left clockwise to rho_at_end ;;
      match at_start, at_end with
      | _, Lt => Got true
      | Eq, _ | _, Eq => Got false
      | _, _ =>
          let tool_from := add2 from v in
          let tool_to := add2 to w in
          from_center <- is_zero clause (square2 tool_from) ;;
          to_center <- is_zero clause (square2 tool_to) ;;
          if from_center || to_center then Got false
          else sweep_interferes clockwise from to tool_from tool_to
      end
  end.

(** One element alone. *)
Definition single {A} (l : list A) : bool := match l with [_] => true | _ => false end.

(** fanuc.cutter-c.interference-pairs: from the corner moves inward to outward; a pair with interference is dropped, but
    never the first vector at the start and the last at the end. The vectors at the start stand in reverse.
    fanuc.cutter-c.interference-alarm: interference of the last pair raises PS0041.
    fanuc.cutter-c.interference-without-alarm: but not with CNC = 1 ([silent]), for it is one of direction.
    fanuc.cutter-c.interference-straightened: these pairs are tested as of a line. *)
Fixpoint next_pairs {num} {N : Numbers num} (tries : list (pair num)) (silent : bool) (p : path num)
    (vs ws : list (pair num)) : outcome (list (pair num) * list (pair num)) :=
  match tries with
  | [] => Alarm "interference"
  | _ :: fewer =>
      if single vs && single ws then (if silent then Got (vs, ws) else Alarm "interference")
      else
        let vs := if single vs then vs else tl vs in
        let ws := if single ws then ws else tl ws in
        interferes <- line_interferes p (hd zero2 vs) (hd zero2 ws) ;;
        if interferes : bool then next_pairs fewer silent p vs ws else Got (vs, ws)
  end.

(** The vectors that are left at the start and at the end, and whether the block was an arc that is a line now.
    fanuc.cutter-c.interference-at-once: with CNV = 1 ([first_only]) none is dropped.
    fanuc.cutter-c.interference-without-alarm: [silent]; an arc whose only pair interferes raises the alarm. *)
Definition checked {num} {N : Numbers num} (first_only silent : bool) (p : path num) (rho_at_start rho_at_end : num) (vs ws : list (pair num)) :
    outcome (list (pair num) * list (pair num) * bool) :=
  let backward := rev vs in
  let v := hd zero2 backward in
  let w := hd zero2 ws in
  interferes <- match about p with
                | None => line_interferes p v w
                | Some (clockwise, center) => arc_interferes p clockwise center rho_at_start rho_at_end v w
                end ;;
  if interferes : bool then
    if first_only || (single vs && single ws) then
      if silent && negb (given (about p)) then Got (vs, ws, false) else Alarm "interference"
    else
      '(vs, ws) <- next_pairs (vs ++ ws) silent p backward ws ;;
      Got (rev vs, ws, given (about p))
  else Got (vs, ws, false).
