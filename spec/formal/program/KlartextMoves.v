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

(** What 3D compensation makes of the tool. *)
Record tool_in_space (num : Type) := ToolInSpace {
  center_of_tool : triple num;
  shift_of_tip : triple num;                      (* against the nominal tool *)
  shift_of_tool : triple num;                     (* of the real tool against one without deltas *)
  carrier_point : option (triple num);            (* where the tool table gives the length *)
  touching : option (contact num)
}.
Arguments ToolInSpace {num}. Arguments center_of_tool {num}. Arguments shift_of_tip {num}. Arguments shift_of_tool {num}.
Arguments carrier_point {num}. Arguments touching {num}.

(** Without the values of axes that are not known. *)
Record klartext_move (num : Type) := KlartextMove {
  is_rapid : bool;
  why : cause;
  programmed_values : some_values num;
  tip_values : some_values num;                (* the tip of the effective tool, and the other linear axes *)
  sent_to : some_values num;                   (* rotary axes where the block names them *)
  direction_of_tool : triple num;
  tool_stands : option (tool_in_space num);    (* where all axes are known *)
  feed_of_move : option num;
  not_known : list Letter.t
}.
Arguments KlartextMove {num}. Arguments is_rapid {num}. Arguments why {num}. Arguments programmed_values {num}.
Arguments tip_values {num}. Arguments sent_to {num}. Arguments direction_of_tool {num}. Arguments tool_stands {num}.
Arguments feed_of_move {num}. Arguments not_known {num}.

Inductive klartext_event (num : Type) :=
| Moved (m : klartext_move num)
| HoleMade (h : hole num)                      (* what the linear axes alone stand at behind it counts *)
| Warning (name : string)
| AlarmRaised (name : string)
| SignOpen (clause : string)                   (* it could not be decided *)
| OutOfScope.                                  (* heidenhain.peripheral.out-of-scope *)
Arguments Moved {num} m. Arguments HoleMade {num} h. Arguments Warning {num} name. Arguments AlarmRaised {num} name.
Arguments SignOpen {num} clause. Arguments OutOfScope {num}.

(** * Blocks that move *)

(** Where a block ends, and its movement from the point that was programmed before, where that is known. *)
Record ending (num : Type) := Ending {
  end_values : values num;                     (* 0 where it is not known *)
  unknown_at_end : list Letter.t;
  travel : option (triple num)
}.
Arguments Ending {num}. Arguments end_values {num}. Arguments unknown_at_end {num}. Arguments travel {num}.

(** heidenhain.program.retraction: M140 MB n moves the tool by n along itself, P' = P + n t; behind MB MAX the positions of
    X, Y and Z along which the tool has a component are not known.
    heidenhain.program.contour-beside-the-path: behind DEP LT, LN and CT those of the working plane are not known.
    heidenhain.program.unknown-position: a word without I makes the position of its axis known; an increment of an axis
    whose position is not known is not judged. *)
Definition components {num} (t : triple num) : list (Letter.t * num) :=
  let '(x, y, z) := t in [(Letter.X, x); (Letter.Y, y); (Letter.Z, z)].
Definition axes_along {num} {N : Numbers num} (t : triple num) : outcome (list Letter.t) :=
  signs <- each (fun '(letter, c) => nothing <- is_zero "heidenhain.program.retraction" c ;; Got (letter, negb nothing))
             (components t) ;;
  Got (map fst (filter snd signs)).
Definition axes_across (tool_axis : Letter.t) : list Letter.t :=
  filter (fun letter => negb (Letter.eqb letter tool_axis)) [Letter.X; Letter.Y; Letter.Z].
Definition end_of_block {num} {N : Numbers num} (s : klartext_setup num) (machine_datum : bool) (w : line_words num)
    (st : klartext_state num) : outcome (ending num) :=
  let unknown := unknown_axes st in
  let at_end to not_known d :=
    let not_known := filter (among not_known) (letters s) in
    Ending (map2 (fun letter x => if among not_known letter then 0%num else x) (letters s) to) not_known d in
  let here := space_of s (position st) in
  let tool := tool_direction st in
  match to_end w with
  | ByWords =>
      let words := axis_words w in
      _ <- alarm_if (existsb (fun w => with_i w && among unknown (axis_letter w)) words) "not-judged" ;;
      let to := end_position s machine_datum words st in
      Got (at_end to (filter (fun letter => negb (given (word_of letter words))) unknown)
             match unknown with [] => Some (sub3 (space_of s to) here) | _ => None end)
  | AlongTool (Some n) =>
      let d := scale3 (value_of st n) (of_length_1 tool) in
      Got (at_end (with_space s (add3 here d) (position st)) unknown (Some d))
  | AlongTool None =>
      along <- axes_along (as_given tool) ;;
      Got (at_end (position st) (along ++ unknown) (Some (of_length_1 tool)))
  | Departing => Got (at_end (position st) (axes_across (axis_of_tool (tool_of st)) ++ unknown) None)
  end.

(** What of a block its end point is made with. *)
Record motion (num : Type) := Motion {
  rapid_here : bool;
  feed_here : option num;
  ends : ending num;
  rotary_named : list (axis_word num);
  tool_direction_at_end : triple num;             (* of length 1 *)
  length_delta : num;                          (* dL *)
  table_length : option num;                   (* L *)
  corner_in_force : num                        (* R2' *)
}.
Arguments Motion {num}. Arguments rapid_here {num}. Arguments feed_here {num}. Arguments ends {num}.
Arguments rotary_named {num}. Arguments tool_direction_at_end {num}. Arguments length_delta {num}.
Arguments table_length {num}. Arguments corner_in_force {num}.

(** heidenhain.program.length-along-the-tool: axes = point + dL t, tool shift = shift + dL t, carrier = point + (L + dL) t.
    TCP' = TIP' + R2' t.
    heidenhain.program.unknown-position: there are no coordinates of an axis whose position is not known, and no vectors of
    the tool. *)
Definition move_to_tip {num} {N : Numbers num} (s : klartext_setup num) (m : motion num) (because : cause)
    (tip shift : triple num) (touch : option (contact num)) : klartext_move num :=
  let t := tool_direction_at_end m in
  let along := scale3 (length_delta m) t in
  let machine_point := add3 tip along in
  let to := end_values (ends m) in
  let unknown := unknown_at_end (ends m) in
  let but (left_out : Letter.t -> bool) := map2 (fun letter x => if left_out letter then None else Some x) (letters s) in
  let not_sent letter := rotary letter && negb (given (word_of letter (rotary_named m))) in
  let stands := ToolInSpace (add3 tip (scale3 (corner_in_force m) t)) shift (add3 shift along)
                  (option_map (fun l => add3 machine_point (scale3 l t)) (table_length m)) touch in
  KlartextMove (rapid_here m) because (but (among unknown) to) (but (among unknown) (with_space s tip to))
    (but (fun letter => among unknown letter || not_sent letter) (with_space s machine_point to))
    t match unknown with [] => Some stands | _ => None end (if rapid_here m then None else feed_here m) unknown.

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
  motion_of : motion num;
  way_of : way num
}.
Arguments Planned {num}. Arguments warnings {num}. Arguments motion_of {num}. Arguments way_of {num}.

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

(** heidenhain.program.own-move: every LN block, every L block with an axis word, M140, and a departure without
    coordinates, makes exactly one move.
    heidenhain.program.retraction: M140 is a motion as L, rapid where its block has no F.
    heidenhain.program.unknown-position: a block under RL or RR and TCPM without a normal is not judged where an axis is not
    known before it or at its end.
    heidenhain.tool.order-of-checks: the tool is checked in every LN block, and in L and M140 under RL or RR and TCPM.
    heidenhain.face.order-of-warnings: warnings stand in this order; a block that raises an alarm gives none.
    heidenhain.program.many-digits, heidenhain.face.tool-vector-ignored, heidenhain.peripheral.no-lateral: W_DIGITS,
    W_T_IGNORED, W_NO_LATERAL. *)
Definition plan {num} {N : Numbers num} (s : klartext_setup num) (machine_datum with_vectors : bool) (w : line_words num)
    (normal tool_vector : option (triple num)) (st : klartext_state num) :
    outcome (klartext_state num * option (planned num)) :=
  let st := with_line_modes (or_else (radius_given w) (radius_mode st)) (next_feeds st (feed_given w)) st in
  if negb with_vectors && match axis_words w, to_end w with [], ByWords => true | _, _ => false end
  then Got (st, None) else
  let tcpm := tcpm_on (tcpm_of st) in
  let compensating := match radius_mode st with R0 => false | _ => true end in
  here <- end_of_block s machine_datum w st ;;
  let to := end_values here in
  let p := space_of s to in
  let all_known := match unknown_axes st, unknown_at_end here with [], [] => true | _, _ => false end in
  _ <- alarm_if (compensating && tcpm && negb (given normal) && negb all_known) "not-judged" ;;
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
          | _, _ => Got (end_without_normal st effective direction p (or_else (travel here) zero3))
          end ;;
  let rapid := match feed_given w, to_end w with Some FMax, _ | None, AlongTool _ => true | _, _ => false end in
  let m := Motion rapid (feed_in_force (feeds_of st)) here
             (filter (fun w => rotary (axis_letter w)) (axis_words w)) (of_length_1 direction)
             (of_length (total_deltas tool)) (overall_length (table_row tool)) (corner_made made) in
  let all := warn (many_digits w) "W_DIGITS" ++ warn (given tool_vector && negb tcpm) "W_T_IGNORED" ++
             warn normal_off "W_NOT_NORMALIZED" ++ warn tool_off "W_NOT_NORMALIZED" ++ warn below "W_N_BELOW" ++
             warn (contact_jumped made) "W_CONTACT_JUMP" ++
             warn (with_vectors && negb (given normal) && negb compensating) "W_NO_LATERAL" in
  let turns := existsb (fun w => rotary (axis_letter w)) (axis_words w) in
  let held := tcpm_of st in
  let of_vector := (tcpm && with_vectors) || (by_vector held && negb turns) in
  let st := at_end_of_motion to (unknown_at_end here) (ring made)
              (with_direction (if tcpm then direction else direction_held held) of_vector st) in
  Got (st, Some (Planned all m (way_made made))).
