(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/tool: the effective tool of 3D compensation, and whether it may be used. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** heidenhain.program.delta-sum: the total of tool management, tool call and compensation table. *)
Definition no_deltas {num} {N : Numbers num} : deltas num := Deltas 0%num 0%num 0%num.
Definition add_deltas {num} {N : Numbers num} (a b : deltas num) : deltas num :=
  Deltas (of_length a + of_length b)%num (of_radius a + of_radius b)%num (of_corner a + of_corner b)%num.

(** TOOL CALL 0 is a tool of zeros. *)
Definition tool_of_zeros {num} {N : Numbers num} : tool_row num := ToolRow 0 "" 0%num 0%num None no_deltas None.

(** What 3D compensation asks of the tool in force. *)
Record tool_in_force (num : Type) := ToolInForce {
  row_of_tool : option (tool_row num);     (* none: no tool was called *)
  programmed_deltas : deltas num;          (* of TOOL CALL and of the compensation table *)
  oversize_permitted : bool                (* M107 *)
}.
Arguments ToolInForce {num}. Arguments row_of_tool {num}. Arguments programmed_deltas {num}.
Arguments oversize_permitted {num}.

Definition table_row {num} {N : Numbers num} (tool : tool_in_force num) : tool_row num :=
  or_else (row_of_tool tool) tool_of_zeros.
Definition total_deltas {num} {N : Numbers num} (tool : tool_in_force num) : deltas num :=
  add_deltas (in_table (table_row tool)) (programmed_deltas tool).

(** * Deviations by the angle of the contact *)

(** Normal and tool, as written: N.T, |N x T|, |N||T|. *)
Record contact_angle (num : Type) := ContactAngle { along : num; across : num; both_lengths : num }.
Arguments ContactAngle {num}. Arguments along {num}. Arguments across {num}. Arguments both_lengths {num}.
Definition angle_of_contact {num} {N : Numbers num} (normal tool : triple num) : contact_angle num :=
  let a := cross3 normal tool in
  ContactAngle (dot3 normal tool) (root (dot3 a a)) (root (dot3 normal normal * dot3 tool tool)%num).

(** heidenhain.tool.deviation-table: theta = atan2(|n x t|, n.t), in degrees, 0 at the tip and 90 at the equator. *)
Definition degrees_of {num} {N : Numbers num} (a : contact_angle num) : outcome num :=
  side <- decide "heidenhain.tool.deviation-table" (along a) ;;
  Got match side with
      | Gt => arctangent (across a / along a)%num
      | Eq => integer 90
      | Lt => (integer 180 + arctangent (across a / along a))%num
      end.

(** The angle compared with b degrees: cos b |N||T| - N.T is positive where it is larger. *)
Definition angle_against {num} {N : Numbers num} (clause : string) (a : contact_angle num) (b : num) :
    outcome comparison :=
  decide clause (cosine b * both_lengths a - along a)%num.

(** Where in the table an angle is: at a support point, or between two of them. *)
Inductive place_in_table (num : Type) :=
| At (value : num)
| Between (from to : num * num).
Arguments At {num} value.
Arguments Between {num} from to.

(** heidenhain.tool.deviation-segment: the support points between first and last are asked in ascending order until one is
    not below the contact angle. *)
Fixpoint segment {num} {N : Numbers num} (a : contact_angle num) (below : num * num) (points : list (num * num)) :
    outcome (place_in_table num) :=
  match points with
  | [] => Got (At (snd below))
  | [last] => Got (Between below last)
  | point :: rest =>
      c <- angle_against "heidenhain.tool.deviation-segment" a (fst point) ;;
      match c with
      | Gt => segment a point rest
      | Eq => Got (At (snd point))
      | Lt => Got (Between below point)
      end
  end.

(** heidenhain.tool.deviation-below, heidenhain.tool.deviation-above: an angle outside the support points raises
    E_3DTC_RANGE. *)
Definition place_of_angle {num} {N : Numbers num} (a : contact_angle num) (points : list (num * num)) :
    outcome (place_in_table num) :=
  let first := hd (0%num, 0%num) points in
  let final := last points first in
  at_first <- angle_against "heidenhain.tool.deviation-below" a (fst first) ;;
  _ <- alarm_if (match at_first with Lt => true | _ => false end) "deviation-range" ;;
  at_last <- angle_against "heidenhain.tool.deviation-above" a (fst final) ;;
  _ <- alarm_if (match at_last with Gt => true | _ => false end) "deviation-range" ;;
  match at_first, at_last with
  | Eq, _ => Got (At (snd first))
  | _, Eq => Got (At (snd final))
  | _, _ => segment a first (tl points)
  end.

(** heidenhain.tool.deviation-segment: tau = v0 + (v1 - v0)(theta - b0)/(b1 - b0). *)
Definition deviation_at {num} {N : Numbers num} (theta : num) (place : place_in_table num) : num :=
  match place with
  | At v => v
  | Between (b0, v0) (b1, v1) => (v0 + (v1 - v0) * (theta - b0) / (b1 - b0))%num
  end.

(** heidenhain.tool.effective-corner-radius: the sign of R2 + dR2. Inside a segment it is that of an angle: the contact
    angle is compared with the one at which R2 + dR2 is 0. *)
Definition sign_of_corner {num} {N : Numbers num} (a : contact_angle num) (corner_without : num)
    (place : place_in_table num) : outcome comparison :=
  let clause := "heidenhain.tool.effective-corner-radius" in
  match place with
  | At v => decide clause (corner_without + v)%num
  | Between (b0, v0) (b1, v1) =>
      let e0 := (corner_without + v0)%num in
      let e1 := (corner_without + v1)%num in
      at_from <- decide clause e0 ;;
      at_to <- decide clause e1 ;;
      match at_from, at_to with
      | Gt, Lt | Lt, Gt =>
          c <- angle_against clause a (b0 + (b1 - b0) * e0 / (e0 - e1))%num ;;
          Got match c with Gt => at_to | Eq => Eq | Lt => at_from end
      | Eq, _ => Got at_to
      | _, _ => Got at_from
      end
  end.

(** * The effective tool *)

Record effective_tool (num : Type) := EffectiveTool {
  delta : deltas num;                 (* with the deviation of the contact, where there is one *)
  full_radius : num;                  (* R' *)
  full_corner : num;                  (* R2' *)
  flat_of_table : num;                (* rho *)
  flat : num;                         (* rho' *)
  theta : option num                  (* with a table of deviations *)
}.
Arguments EffectiveTool {num}. Arguments delta {num}. Arguments full_radius {num}. Arguments full_corner {num}.
Arguments flat_of_table {num}. Arguments flat {num}. Arguments theta {num}.

(** heidenhain.tool.table-radius, heidenhain.tool.table-corner-radius, heidenhain.tool.table-shape: a negative radius or
    corner radius, and a corner radius beyond the radius, raise E_TOOL. *)
Definition check_table {num} {N : Numbers num} (row : tool_row num) : outcome unit :=
  no_radius <- is_negative "heidenhain.tool.table-radius" (radius row) ;;
  _ <- alarm_if no_radius "tool-shape" ;;
  no_corner <- is_negative "heidenhain.tool.table-corner-radius" (corner_radius row) ;;
  _ <- alarm_if no_corner "tool-shape" ;;
  no_shape <- is_negative "heidenhain.tool.table-shape" (radius row - corner_radius row)%num ;;
  alarm_if no_shape "tool-shape".

(** heidenhain.tool.oversize-permitted: under M107 positive deltas and corner radii beyond the radius raise no alarm.
    heidenhain.tool.oversize-radius: dR > 0 raises E_OVERSIZE_DR.
    heidenhain.tool.oversize-corner: in a block with a normal dR2 > 0 raises E_OVERSIZE_DR2; with a table of deviations
    only the deltas that are programmed count.
    heidenhain.tool.corner-beyond-radius: in a block with a normal R2' > R' raises E_R2_GT_R; not with a table. *)
Definition check_oversize {num} {N : Numbers num} (tool : tool_in_force num) (with_normal with_table : bool)
    (d : deltas num) (flat_left : num) : outcome unit :=
  if oversize_permitted tool then Got tt else
  larger <- is_positive "heidenhain.tool.oversize-radius" (of_radius d) ;;
  _ <- alarm_if larger "oversize-radius" ;;
  if negb with_normal then Got tt else
  let corner := if with_table then of_corner (programmed_deltas tool) else of_corner d in
  rounder <- is_positive "heidenhain.tool.oversize-corner" corner ;;
  _ <- alarm_if rounder "oversize-corner" ;;
  if with_table then Got tt else
  beyond <- is_negative "heidenhain.tool.corner-beyond-radius" flat_left ;;
  alarm_if beyond "corner-beyond-radius".

(** heidenhain.tool.order-of-checks: in this order; the first ends the run. The contact is that of a block with a normal.
    heidenhain.tool.none: E_NO_TOOL before any tool call.
    heidenhain.face.radius-compensation: a normal under RL or RR raises E_RC_WITH_N.
    heidenhain.tool.deviation-table: in blocks with a normal the table counts in place of DR2 of the tool table.
    heidenhain.tool.deviation-shape: it is for R2 = R.
    heidenhain.tool.effective-radius: R' < 0 raises E_TOOL_EFF; R2' < 0 raises E_R2_NEG.
    heidenhain.tool.effective-flat: the flat has the radius R' - R2', and none where the corner radius is larger. *)
Definition usable_tool {num} {N : Numbers num} (tool : tool_in_force num) (contact : option (contact_angle num))
    (radius_compensation : bool) : outcome (effective_tool num) :=
  _ <- alarm_if (negb (given (row_of_tool tool))) "no-tool" ;;
  _ <- alarm_if (given contact && radius_compensation) "normal-with-radius-compensation" ;;
  let row := table_row tool in
  let d := total_deltas tool in
  _ <- check_table row ;;
  let rho := (radius row - corner_radius row)%num in
  let R' := (radius row + of_radius d)%num in
  let check_radius :=
    negative <- is_negative "heidenhain.tool.effective-radius" R' ;;
    alarm_if negative "effective-radius" in
  match contact, deviations row with
  | Some a, Some points =>
      ball <- is_zero "heidenhain.tool.deviation-shape" rho ;;
      _ <- alarm_if (negb ball) "deviation-shape" ;;
      _ <- check_radius ;;
      place <- place_of_angle a points ;;
      let added := of_corner (programmed_deltas tool) in
      c <- sign_of_corner a (corner_radius row + added)%num place ;;
      _ <- alarm_if (match c with Lt => true | _ => false end) "corner-radius-negative" ;;
      _ <- check_oversize tool true true d 0%num ;;
      angle <- degrees_of a ;;
      let corner := (deviation_at angle place + added)%num in
      Got (EffectiveTool (Deltas (of_length d) (of_radius d) corner) R' (corner_radius row + corner)%num 0%num 0%num
             (Some angle))
  | _, _ =>
      let R2' := (corner_radius row + of_corner d)%num in
      _ <- check_radius ;;
      negative <- is_negative "heidenhain.tool.effective-corner-radius" R2' ;;
      _ <- alarm_if negative "corner-radius-negative" ;;
      _ <- check_oversize tool (given contact) false d (R' - R2')%num ;;
      with_flat <- match contact with
                   | Some _ => is_positive "heidenhain.tool.effective-flat" (R' - R2')%num
                   | None => Got false
                   end ;;
      Got (EffectiveTool d R' R2' rho (if with_flat : bool then R' - R2' else 0)%num None)
  end.
