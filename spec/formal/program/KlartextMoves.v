(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/program: the events of a run, and the blocks that move. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool KlartextFace
  KlartextPeripheral KlartextState.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Events *)

Record klartext_move (num : Type) := KlartextMove {
  is_rapid : bool;
  why : cause;
  programmed_values : values num;
  tip_values : values num;                     (* the tip of the effective tool, and the other linear axes *)
  sent_to : some_values num;                   (* rotary axes where the block names them *)
  direction_of_tool : triple num;
  center_of_tool : triple num;
  shift_of_tip : triple num;                      (* against the nominal tool *)
  shift_of_tool : triple num;                     (* of the real tool against one without deltas *)
  carrier_point : option (triple num);            (* where the tool table gives the length *)
  touching : option (contact num);
  feed_of_move : option num
}.
Arguments KlartextMove {num}. Arguments is_rapid {num}. Arguments why {num}. Arguments programmed_values {num}.
Arguments tip_values {num}. Arguments sent_to {num}. Arguments direction_of_tool {num}. Arguments center_of_tool {num}.
Arguments shift_of_tip {num}. Arguments shift_of_tool {num}. Arguments carrier_point {num}. Arguments touching {num}.
Arguments feed_of_move {num}.

Inductive klartext_event (num : Type) :=
| Moved (m : klartext_move num)
| Warning (name : string)
| AlarmRaised (name : string)
| SignOpen (clause : string)                   (* it could not be decided *)
| OutOfScope.                                  (* heidenhain.peripheral.out-of-scope *)
Arguments Moved {num} m. Arguments Warning {num} name. Arguments AlarmRaised {num} name.
Arguments SignOpen {num} clause. Arguments OutOfScope {num}.

(** * Blocks that move *)

(** What of a block its end point is made with. *)
Record motion (num : Type) := Motion {
  rapid_here : bool;
  feed_here : option num;
  end_values : values num;
  rotary_named : list (axis_word num);
  tool_direction_at_end : triple num;             (* of length 1 *)
  length_delta : num;                          (* dL *)
  table_length : option num;                   (* L *)
  corner_in_force : num                        (* R2' *)
}.
Arguments Motion {num}. Arguments rapid_here {num}. Arguments feed_here {num}. Arguments end_values {num}.
Arguments rotary_named {num}. Arguments tool_direction_at_end {num}. Arguments length_delta {num}.
Arguments table_length {num}. Arguments corner_in_force {num}.

(** heidenhain.program.length-along-the-tool: axes = point + dL t, tool shift = shift + dL t, carrier = point + (L + dL) t.
    TCP' = TIP' + R2' t. *)
Definition move_to_tip {num} {N : Numbers num} (s : klartext_setup num) (m : motion num) (because : cause)
    (tip shift : triple num) (touch : option (contact num)) : klartext_move num :=
  let t := tool_direction_at_end m in
  let along := scale3 (length_delta m) t in
  let machine_point := add3 tip along in
  let sent := with_space s machine_point (end_values m) in
  KlartextMove (rapid_here m) because (end_values m) (with_space s tip (end_values m))
    (map2 (fun letter x => if rotary letter && negb (given (word_of letter (rotary_named m))) then None else Some x)
       (letters s) sent)
    t (add3 tip (scale3 (corner_in_force m) t)) shift (add3 shift along)
    (option_map (fun l => add3 machine_point (scale3 l t)) (table_length m)) touch
    (if rapid_here m then None else feed_here m).

(** How a block gets to its end. *)
Inductive way (num : Type) :=
| Known (tip shift : triple num) (touch : option (contact num))
| Beside (nominal : triple num) (l : lateral num) (by_delta by_radius : num)     (* the tip is nominal + by_delta m *)
| NotModelled.
Arguments Known {num} tip shift touch.
Arguments Beside {num} nominal l by_delta by_radius.
Arguments NotModelled {num}.

Record planned (num : Type) := Planned {
  warnings : list string;
  moved_by : triple num;                          (* between programmed points *)
  motion_of : motion num;
  way_of : way num
}.
Arguments Planned {num}. Arguments warnings {num}. Arguments moved_by {num}. Arguments motion_of {num}.
Arguments way_of {num}.

(** heidenhain.face.tool-vector, heidenhain.peripheral.tool-vector: under TCPM the tool takes the direction T where the
    block gives it, and else that of the normal; it stays for the blocks that follow.
    heidenhain.program.direction-of-rotary-axes: L with a rotary word turns the tool; rotary axes without a word keep the
    value programmed last. Without any rotary word the tool keeps its direction. *)
Definition direction_at_end {num} {N : Numbers num} (s : klartext_setup num) (st : klartext_state num)
    (words : list (axis_word num)) (normal tool_vector : option (triple num)) (to : values num) : direction_in_space num :=
  if negb (tcpm_on (tcpm_of st)) then tool_direction st else
  match tool_vector, normal with
  | Some t, _ => direction_along t
  | None, Some n => direction_along n
  | None, None =>
      if existsb (fun w => rotary (axis_letter w)) words
      then turned_to s to st
      else tool_direction st
  end.

Definition warn (condition : bool) (name : string) : list string := if condition then [name] else [].

(** heidenhain.program.reference-point, heidenhain.contour.nominal-tip: under CNT-CNT the programmed point is the centre of
    the tool, tip = P - R2 t; else it is the tip.
    heidenhain.contour.reference-ignored: under IS CONTOUR a block that is compensated starts from the programmed point
    itself. *)
Definition nominal_tip {num} {N : Numbers num} (st : klartext_state num) (t p : triple num) : triple num :=
  if tcpm_on (tcpm_of st) && reference_is_center (tcpm_of st)
  then sub3 p (scale3 (corner_radius (table_row (tool_now st))) t) else p.
Definition compensation_starts {num} {N : Numbers num} (st : klartext_state num) (t p : triple num) : triple num :=
  if contour (tcpm_of st) then p else nominal_tip st t p.

(** How a block gets to its end, and what goes with it. *)
Record end_made (num : Type) := EndMade {
  way_made : way num;
  corner_made : num;                                  (* R2' *)
  ring : option (option (triple num));                (* of a normal: its part across the tool *)
  contact_jumped : bool
}.
Arguments EndMade {num}. Arguments way_made {num}. Arguments corner_made {num}. Arguments ring {num}.
Arguments contact_jumped {num}.

(** heidenhain.face.applies, heidenhain.face.without-tcpm, heidenhain.peripheral.by-normal: LN with a normal is compensated
    by the contact rule, with the tool along its axis without TCPM, and with a normal at right angles to the tool too. *)
Definition end_with_normal {num} {N : Numbers num} (st : klartext_state num) (e : effective_tool num)
    (direction : direction_in_space num) (normal p : triple num) : outcome (end_made num) :=
  let t := of_length_1 direction in
  w <- ring_direction normal (as_given direction) ;;
  has_flat <- is_positive "heidenhain.tool.effective-flat" (flat e) ;;
  jumps <- contact_jumps has_flat (contact_before st) w ;;
  let cut := cut_face (contour (tcpm_of st)) (compensation_starts st t p) (corner_radius (table_row (tool_now st))) e
               (unit3 normal) t w in
  Got (EndMade (Known (tip_of_cut cut) (shift_of_cut cut) (Some (contact_of cut))) (full_corner e) (Some w) jumps).

(** heidenhain.peripheral.applies: RL and RR under TCPM, in L and in LN without a normal; dR2 has no effect.
    heidenhain.contour.mode, heidenhain.contour.flank: the tip stands beside the contour by R', else by dR; the shift is dR
    in both modes (heidenhain.contour.shift).
    heidenhain.peripheral.out-of-scope: without TCPM it is not modelled.
    heidenhain.program.no-compensation: without RL and RR the point is the tip of the nominal tool, with a shift of 0. *)
Definition end_without_normal {num} {N : Numbers num} (st : klartext_state num) (effective : option (effective_tool num))
    (direction : direction_in_space num) (p d : triple num) : end_made num :=
  let t := of_length_1 direction in
  let tool := tool_now st in
  let left := match radius_mode st with RL => true | _ => false end in
  let way :=
    match radius_mode st, tcpm_on (tcpm_of st), effective with
    | R0, _, _ => Known (nominal_tip st t p) zero3 None
    | _, true, Some e =>
        let dR := of_radius (delta e) in
        Beside (compensation_starts st t p) (Lateral left (as_given direction) d)
          (if contour (tcpm_of st) then full_radius e else dR) dR
    | _, _, _ => NotModelled
    end in
  EndMade way (corner_radius (table_row tool) + of_corner (total_deltas tool))%num None false.

(** heidenhain.program.own-move: every LN block, and every L block with an axis word, makes exactly one move.
    heidenhain.tool.order-of-checks: the tool is checked in every LN block, and in L under RL or RR and TCPM.
    heidenhain.face.order-of-warnings: warnings stand in this order; a block that raises an alarm gives none.
    heidenhain.program.many-digits, heidenhain.face.tool-vector-ignored, heidenhain.peripheral.no-lateral: W_DIGITS,
    W_T_IGNORED, W_NO_LATERAL. *)
Definition plan {num} {N : Numbers num} (s : klartext_setup num) (machine_datum with_vectors : bool) (w : line_words num)
    (normal tool_vector : option (triple num)) (st : klartext_state num) :
    outcome (klartext_state num * option (planned num)) :=
  let st := with_line_modes (or_else (radius_given w) (radius_mode st)) (next_feeds st (feed_given w)) st in
  if negb with_vectors && match axis_words w with [] => true | _ => false end then Got (st, None) else
  let tcpm := tcpm_on (tcpm_of st) in
  let compensating := match radius_mode st with R0 => false | _ => true end in
  let to := end_position s machine_datum (axis_words w) st in
  let p := space_of s to in
  let d := sub3 p (space_of s (position st)) in
  let direction := direction_at_end s st (axis_words w) normal tool_vector to in
  let tool := tool_now st in
  let off v := match v with Some v => not_normalized v | None => Got false end in
  normal_off <- off normal ;;
  tool_off <- off (if tcpm then tool_vector else None) ;;
  effective <-
    (if with_vectors || (compensating && tcpm)
     then e <- usable_tool tool (option_map (fun n => angle_of_contact n (as_given direction)) normal) compensating ;;
          Got (Some e)
     else Got None) ;;
  below <- match normal with Some n => leans_below n (as_given direction) | None => Got false end ;;
  made <- match effective, normal with
          | Some e, Some n => end_with_normal st e direction n p
          | _, _ => Got (end_without_normal st effective direction p d)
          end ;;
  let m := Motion (match feed_given w with Some FMax => true | _ => false end) (feed_in_force (feeds_of st)) to
             (filter (fun w => rotary (axis_letter w)) (axis_words w)) (of_length_1 direction)
             (of_length (total_deltas tool)) (overall_length (table_row tool)) (corner_made made) in
  let all := warn (many_digits w) "W_DIGITS" ++ warn (given tool_vector && negb tcpm) "W_T_IGNORED" ++
             warn normal_off "W_NOT_NORMALIZED" ++ warn tool_off "W_NOT_NORMALIZED" ++ warn below "W_N_BELOW" ++
             warn (contact_jumped made) "W_CONTACT_JUMP" ++
             warn (with_vectors && negb (given normal) && negb compensating) "W_NO_LATERAL" in
  let turns := existsb (fun w => rotary (axis_letter w)) (axis_words w) in
  let held := tcpm_of st in
  let of_vector := (tcpm && with_vectors) || (by_vector held && negb turns) in
  let st := at_end_of_motion to (ring made)
              (with_direction (if tcpm then direction else direction_held held) of_vector st) in
  Got (st, Some (Planned all d m (way_made made))).
