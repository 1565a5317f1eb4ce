(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/program: what is in force from block to block, and what changes it. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** Of the block before, that of TOOL CALL; none: there is no F, or FZ or FU. *)
Record feeds (num : Type) := Feeds { feed_in_force : option num; feed_of_call : option num }.
Arguments Feeds {num}. Arguments feed_in_force {num}. Arguments feed_of_call {num}.

(** The tool, and what TOOL CALL and the compensation table add to it. *)
Record tool_state (num : Type) := ToolState {
  called : option (tool_row num);
  axis_of_tool : Letter.t;
  of_call : deltas num;
  correction : option (deltas num);     (* the row in force *)
  m107 : bool
}.
Arguments ToolState {num}. Arguments called {num}. Arguments axis_of_tool {num}. Arguments of_call {num}.
Arguments correction {num}. Arguments m107 {num}.

(** TCPM and FUNCTION PROG PATH. *)
Record tcpm_state (num : Type) := TcpmState {
  tcpm_on : bool;
  reference_is_center : bool;
  direction_held : direction_in_space num;      (* under TCPM, or where it ended *)
  by_vector : bool;                             (* a vector turned the tool, and no rotary word came after it *)
  contour : bool
}.
Arguments TcpmState {num}. Arguments tcpm_on {num}. Arguments reference_is_center {num}.
Arguments direction_held {num}. Arguments by_vector {num}. Arguments contour {num}.

Record klartext_state (num : Type) := KlartextState {
  program_in_inch : bool;
  parameters : list (q_parameter * num);
  position : values num;                (* programmed, from the preset; 0 where it is not known *)
  unknown_axes : list Letter.t;         (* of which nobody knows where they stand *)
  datum : values num;                   (* the shift of cycle 7 *)
  radius_mode : radius_word;
  feeds_of : feeds num;
  tool_of : tool_state num;
  tcpm_of : tcpm_state num;
  (* Of the LN block with a normal right before, the part of the normal across the tool. *)
  contact_before : option (option (triple num))
}.
Arguments KlartextState {num}. Arguments program_in_inch {num}. Arguments parameters {num}. Arguments position {num}.
Arguments unknown_axes {num}. Arguments datum {num}. Arguments radius_mode {num}. Arguments feeds_of {num}.
Arguments tool_of {num}. Arguments tcpm_of {num}. Arguments contact_before {num}.

Definition with_parameter {num} (p : q_parameter) (v : num) (st : klartext_state num) : klartext_state num :=
  KlartextState (program_in_inch st) ((p, v) :: parameters st) (position st) (unknown_axes st) (datum st)
    (radius_mode st) (feeds_of st) (tool_of st) (tcpm_of st) (contact_before st).
Definition with_datum {num} (d : values num) (st : klartext_state num) : klartext_state num :=
  KlartextState (program_in_inch st) (parameters st) (position st) (unknown_axes st) d (radius_mode st) (feeds_of st)
    (tool_of st) (tcpm_of st) (contact_before st).
Definition with_tool {num} (t : tool_state num) (st : klartext_state num) : klartext_state num :=
  KlartextState (program_in_inch st) (parameters st) (position st) (unknown_axes st) (datum st) (radius_mode st)
    (feeds_of st) t (tcpm_of st) (contact_before st).
Definition with_tcpm {num} (t : tcpm_state num) (st : klartext_state num) : klartext_state num :=
  KlartextState (program_in_inch st) (parameters st) (position st) (unknown_axes st) (datum st) (radius_mode st)
    (feeds_of st) (tool_of st) t (contact_before st).
Definition with_line_modes {num} (r : radius_word) (f : feeds num) (st : klartext_state num) : klartext_state num :=
  KlartextState (program_in_inch st) (parameters st) (position st) (unknown_axes st) (datum st) r f (tool_of st)
    (tcpm_of st) (contact_before st).
Definition at_end_of_motion {num} (p : values num) (unknown : list Letter.t) (before : option (option (triple num)))
    (st : klartext_state num) : klartext_state num :=
  KlartextState (program_in_inch st) (parameters st) p unknown (datum st) (radius_mode st) (feeds_of st) (tool_of st)
    (tcpm_of st) before.

(** heidenhain.program.initial-state: R0, TCPM off, reference point at the tip, PROG PATH OFF, M108, no tool, the tool along
    Z, no datum shift, rotary axes at 0 and without F, at the position of the setup.
    heidenhain.program.units: the position is in the units of the setup, the program in its own; asked once. *)
Definition units_of_program {num} (s : klartext_setup num) (bs : list (klartext_block num)) : bool :=
  match bs with
  | b :: _ => match says b with BeginProgram inch => inch | _ => in_inch s end
  | [] => in_inch s
  end.
Definition initial_state {num} {N : Numbers num} (s : klartext_setup num) (program_in_inch : bool) : klartext_state num :=
  let in_program x := match program_in_inch, in_inch s with
                      | true, false => (x * integer 5 / integer 127)%num
                      | false, true => (x * integer 127 / integer 5)%num
                      | _, _ => x
                      end in
  let here := map2 (fun letter x => if rotary letter then 0%num else in_program x) (letters s) (start_at s) in
  KlartextState program_in_inch [] here [] (map (fun _ => 0%num) here) R0 (Feeds None None)
    (ToolState None Letter.Z no_deltas None false)
    (TcpmState false false (along_axis Letter.Z) false false) None.

(** heidenhain.program.units: tables are in mm and converted by the exact factor 5/127. *)
Definition from_table {num} {N : Numbers num} (st : klartext_state num) (x : num) : num :=
  if program_in_inch st then (x * integer 5 / integer 127)%num else x.
Definition deltas_from_table {num} {N : Numbers num} (st : klartext_state num) (d : deltas num) : deltas num :=
  Deltas (from_table st (of_length d)) (from_table st (of_radius d)) (from_table st (of_corner d)).
Definition row_from_table {num} {N : Numbers num} (st : klartext_state num) (row : tool_row num) : tool_row num :=
  ToolRow (tool_number row) (tool_name row) (from_table st (radius row)) (from_table st (corner_radius row))
    (option_map (from_table st) (overall_length row)) (deltas_from_table st (in_table row))
    (option_map (map (fun '(angle, deviation) => (angle, from_table st deviation))) (deviations row)).

(** * Values *)

Definition same_parameter (a b : q_parameter) : bool :=
  match kind a, kind b with OfQ, OfQ | OfQL, OfQL | OfQR, OfQR => index a =? index b | _, _ => false end.

(** heidenhain.program.parameter-value: a parameter with its sign; one that was never assigned counts 0. *)
Definition value_of {num} {N : Numbers num} (st : klartext_state num) (w : written num) : num :=
  match w with
  | Literal x => x
  | OfParameter p minus_written =>
      match find (fun entry => same_parameter (fst entry) p) (parameters st) with
      | Some (_, x) => if minus_written then (- x)%num else x
      | None => 0%num
      end
  end.

(** heidenhain.program.drilling-cycle: a definition sets the parameters that it names as assignments do, in the order
    written. *)
Definition assigned {num} {N : Numbers num} (sets : list (q_parameter * written num)) (st : klartext_state num) :
    klartext_state num :=
  fold_left (fun st '(p, v) => with_parameter p (value_of st v) st) sets st.

(** heidenhain.program.incremental: a word with I is a travel from the programmed position, one without the end position.
    heidenhain.program.datum-shift: positions that are programmed count from the shifted datum.
    heidenhain.program.machine-coordinates: in a block with M91 or M92 the datum shift does not count. *)
Definition end_position {num} {N : Numbers num} (s : klartext_setup num) (machine_datum : bool)
    (words : list (axis_word num)) (st : klartext_state num) : values num :=
  map2 (fun letter '(here, shift) =>
          match word_of letter words with
          | None => here
          | Some w =>
              let v := value_of st (amount w) in
              if with_i w then (here + v)%num else if machine_datum then v else (v + shift)%num
          end) (letters s) (combine (position st) (datum st)).

(** heidenhain.program.datum-shift: cycle 7 sets the shift of the axes it names, with I it adds to it. *)
Definition shifted_datum {num} {N : Numbers num} (s : klartext_setup num) (words : list (axis_word num))
    (st : klartext_state num) : values num :=
  map2 (fun letter shift =>
          match word_of letter words with
          | None => shift
          | Some w => let v := value_of st (amount w) in if with_i w then (shift + v)%num else v
          end) (letters s) (datum st).

(** heidenhain.program.feed: F is modal, TOOL CALL sets it too, F AUTO goes back to that of TOOL CALL; FMAX is rapid in its
    block alone; after FZ and FU there is none.
    heidenhain.program.units: F counts tenths of an inch a minute in an INCH program. *)
Definition feed_value {num} {N : Numbers num} (st : klartext_state num) (f : written num) : num :=
  if program_in_inch st then (value_of st f / integer 10)%num else value_of st f.
Definition next_feeds {num} {N : Numbers num} (st : klartext_state num) (w : option (feed_word num)) : feeds num :=
  let before := feeds_of st in
  match w with
  | Some (FValue f) => Feeds (Some (feed_value st f)) (feed_of_call before)
  | Some FAuto => Feeds (feed_of_call before) (feed_of_call before)
  | Some FZOrFU => Feeds None (feed_of_call before)
  | Some FMax | None => before
  end.
Definition feeds_after_call {num} {N : Numbers num} (st : klartext_state num) (w : option (feed_word num)) : feeds num :=
  let next := feed_in_force (next_feeds st w) in
  match w with
  | Some (FValue _) | Some FZOrFU => Feeds next next
  | _ => Feeds next (feed_of_call (feeds_of st))
  end.

(** * TCPM *)

(** heidenhain.program.direction-without-tcpm: without TCPM the tool is along the tool axis. *)
Definition tool_direction {num} {N : Numbers num} (st : klartext_state num) : direction_in_space num :=
  if tcpm_on (tcpm_of st) then direction_held (tcpm_of st) else along_axis (axis_of_tool (tool_of st)).

(** heidenhain.program.direction-of-rotary-axes: A, B and C turn the tool from its axis, of a position. *)
Definition turned_to {num} {N : Numbers num} (s : klartext_setup num) (to : values num) (st : klartext_state num) :
    direction_in_space num :=
  turned (at_letter s Letter.A to) (at_letter s Letter.B to) (at_letter s Letter.C to)
    (of_length_1 (along_axis (axis_of_tool (tool_of st)))).

(** heidenhain.program.tcpm-on: M128 and FUNCTION TCPM switch it on.
    heidenhain.program.tcpm-direction: nothing turns: the tool stands as the rotary axes stand, at the values programmed
    last, or where a vector turned the tool, if no rotary word came after it. *)
Definition tcpm_from_here {num} {N : Numbers num} (s : klartext_setup num) (center : bool) (st : klartext_state num) :
    klartext_state num :=
  let t := tcpm_of st in
  let d := if tcpm_on t || by_vector t then direction_held t else turned_to s (position st) st in
  with_tcpm (TcpmState true center d (by_vector t) (contour t)) st.
(** heidenhain.program.tcpm-off: the tool is then along the tool axis. *)
Definition no_tcpm {num} {N : Numbers num} (st : klartext_state num) : klartext_state num :=
  let t := tcpm_of st in
  with_tcpm (TcpmState false false (direction_held t) (by_vector t) (contour t)) st.
Definition with_direction {num} (d : direction_in_space num) (of_vector : bool) (st : klartext_state num) :
    klartext_state num :=
  let t := tcpm_of st in
  with_tcpm (TcpmState (tcpm_on t) (reference_is_center t) d of_vector (contour t)) st.
(** heidenhain.contour.switch: until OFF, across tool calls. *)
Definition with_contour {num} (is_contour : bool) (st : klartext_state num) : klartext_state num :=
  let t := tcpm_of st in
  with_tcpm (TcpmState (tcpm_on t) (reference_is_center t) (direction_held t) (by_vector t) is_contour) st.

(** * The tool *)

(** heidenhain.program.correction-row: FUNCTION CORRDATA TCS #n puts a row in force, FUNCTION CORRDATA RESET none.
    heidenhain.program.workpiece-corrections: those of WPL change nothing here. *)
Definition with_correction {num} (row : option (deltas num)) (st : klartext_state num) : klartext_state num :=
  let t := tool_of st in
  with_tool (ToolState (called t) (axis_of_tool t) (of_call t) row (m107 t)) st.
(** heidenhain.program.oversize-switch *)
Definition with_m107 {num} (permitted : bool) (st : klartext_state num) : klartext_state num :=
  let t := tool_of st in
  with_tool (ToolState (called t) (axis_of_tool t) (of_call t) (correction t) permitted) st.

(** heidenhain.program.tool-unknown: a number or name without a row, and a string parameter, raise E_NO_TOOL. TOOL CALL 0
    is a tool of zeros. *)
Definition find_tool {num} {N : Numbers num} (s : klartext_setup num) (tool : called_tool) : outcome (tool_row num) :=
  let found row := match row with Some row => Got row | None => Alarm "no-tool" end in
  match tool with
  | ByNumber 0 => Got tool_of_zeros
  | ByNumber n => found (find (fun row => tool_number row =? n) (tools s))
  | ByName name => found (find (fun row => String.eqb (tool_name row) name) (tools s))
  | ByStringParameter | NoToolWord => Alarm "no-tool"
  end.

(** heidenhain.program.tool-call: with a tool it takes over its row, sets R0 and replaces the deltas of the call before by
    its own, 0 where it names none; without a tool it replaces only what it names.
    heidenhain.program.tool-call-under-tcpm: under TCPM a tool raises E_TCPM_TOOLCALL.
    heidenhain.program.tool-axis: without the letter it stays.
    heidenhain.program.correction-row-dropped: a call of a tool puts the row of the compensation table out of force.
    heidenhain.face.contact-before: any TOOL CALL forgets the contact.
    heidenhain.program.unknown-position: what is not known stays so. *)
Definition call_tool {num} {N : Numbers num} (s : klartext_setup num) (tool : called_tool) (axis : option Letter.t)
    (given_deltas : deltas (option (written num))) (f : option (feed_word num)) (st : klartext_state num) :
    outcome (klartext_state num) :=
  let without_tool := match tool with NoToolWord => true | _ => false end in
  _ <- alarm_if (negb without_tool && tcpm_on (tcpm_of st)) "tool-call-under-tcpm" ;;
  row <- (if without_tool then Got (called (tool_of st))
          else row <- find_tool s tool ;; Got (Some (row_from_table st row))) ;;
  let before := if without_tool then of_call (tool_of st) else no_deltas in
  let one given_here b := match given_here with Some w => value_of st w | None => b end in
  let d := Deltas (one (of_length given_deltas) (of_length before)) (one (of_radius given_deltas) (of_radius before))
             (one (of_corner given_deltas) (of_corner before)) in
  let t := ToolState row (or_else axis (axis_of_tool (tool_of st))) d
             (if without_tool then correction (tool_of st) else None) (m107 (tool_of st)) in
  let st := with_tool t (with_line_modes (if without_tool then radius_mode st else R0) (feeds_after_call st f) st) in
  Got (at_end_of_motion (position st) (unknown_axes st) None st).

(** heidenhain.program.program-call-cancels: CALL PGM cancels the radius compensation. *)
Definition without_radius_compensation {num} (st : klartext_state num) : klartext_state num :=
  with_line_modes R0 (feeds_of st) st.

(** heidenhain.program.delta-sum: of TOOL CALL and of the compensation table. *)
Definition tool_now {num} {N : Numbers num} (st : klartext_state num) : tool_in_force num :=
  let t := tool_of st in
  ToolInForce (called t) (match correction t with Some row => add_deltas (of_call t) row | None => of_call t end) (m107 t).
