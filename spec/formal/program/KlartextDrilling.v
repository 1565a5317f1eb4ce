(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/program: the call of a drilling cycle. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool KlartextState.
From Toolcomp Require State.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** A hole, and the movement to the return level from the point that was programmed before, where that is known. *)
Record drilled (num : Type) := DrilledHole { hole_of : hole num; travel_to_hole : option (triple num) }.
Arguments DrilledHole {num}. Arguments hole_of {num}. Arguments travel_to_hole {num}.

Definition q_value {num} {N : Numbers num} (st : klartext_state num) (index : Z) : num :=
  value_of st (OfParameter (QParameter OfQ index) false).

(** A position with another value of one axis. *)
Definition with_axis {num} (s : klartext_setup num) (axis : Letter.t) (x : num) (v : values num) : values num :=
  map2 (fun letter here => if Letter.eqb letter axis then x else here) (letters s) v.

(** heidenhain.program.cycle-call: one hole along the tool axis where the linear axes stand, from the shifted datum:
    r = Q203 + Q200, bottom = Q203 + Q201. With Q201 = 0 the cycle does nothing. To all other rules a hole is a motion of L
    under R0.
    heidenhain.program.cycle-return: return = Q203 + max(Q200, Q204), which is then the programmed position of the tool
    axis.
    heidenhain.program.unknown-position: where the position of another linear axis is not known it is not judged; that of
    the tool axis is known behind the hole.
    heidenhain.program.length-along-the-tool: the tool axis is sent to the return level and the deltas of the length.
    heidenhain.face.contact-before: a hole forgets the contact. *)
Definition drill {num} {N : Numbers num} (s : klartext_setup num) (st : klartext_state num) :
    outcome (klartext_state num * option (drilled num)) :=
  let q := q_value st in
  nothing <- is_zero "heidenhain.program.cycle-call" (q 201) ;;
  if nothing : bool then Got (st, None) else
  let axis := axis_of_tool (tool_of st) in
  let place := State.place axis (letters s) in
  _ <- alarm_if (existsb (fun letter => negb (Letter.eqb letter axis)) (unknown_axes st)) "not-judged" ;;
  second <- is_positive "heidenhain.program.cycle-return" (q 204 - q 200)%num ;;
  let surface := (at_letter s axis (datum st) + q 203)%num in
  let level := (surface + if second : bool then q 204 else q 200)%num in
  let to := with_axis s axis level (position st) in
  let sent := with_axis s axis (level + of_length (total_deltas (tool_now st)))%num to in
  let h := Hole place to (surface + q 200)%num (surface + q 201)%num level sent in
  let travel := match unknown_axes st with
                | [] => Some (sub3 (space_of s to) (space_of s (position st)))
                | _ => None
                end in
  Got (at_end_of_motion to [] None st, Some (DrilledHole h travel)).
