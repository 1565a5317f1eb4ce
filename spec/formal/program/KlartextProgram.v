(** heidenhain/program: a run, block by block, to events. *)
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
| OutOfScope                                   (* heidenhain.peripheral.out-of-scope *)
| NotSaidYet (what : string).
Arguments Moved {num} m. Arguments Warning {num} name. Arguments AlarmRaised {num} name.
Arguments SignOpen {num} clause. Arguments OutOfScope {num}. Arguments NotSaidYet {num} what.

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
      then turned (at_letter s Letter.A to) (at_letter s Letter.B to) (at_letter s Letter.C to)
             (of_length_1 (along_axis (axis_of_tool (tool_of st))))
      else tool_direction st
  end.

Definition warn (condition : bool) (name : string) : list string := if condition then [name] else [].

(** heidenhain.program.own-move: every LN block, and every L block with an axis word, makes exactly one move.
    heidenhain.face.order-of-warnings: in this order; a block that raises an alarm gives none.
    heidenhain.program.many-digits, heidenhain.face.tool-vector-ignored, heidenhain.peripheral.no-lateral: W_DIGITS,
    W_T_IGNORED, W_NO_LATERAL.
    heidenhain.program.reference-point, heidenhain.contour.nominal-tip: under CNT-CNT the programmed point is the centre of
    the tool, tip = P - R2 t.
    heidenhain.contour.mode: under IS CONTOUR compensation takes the full radii, and the programmed point is that of the
    contour (heidenhain.contour.reference-ignored, heidenhain.contour.flank).
    heidenhain.peripheral.applies: L with RL or RR, and LN without a normal, under TCPM.
    heidenhain.peripheral.out-of-scope: without TCPM it is not modelled.
    heidenhain.program.no-compensation: else the point is the tip of the nominal tool, with a shift of 0. *)
Definition plan {num} {N : Numbers num} (s : klartext_setup num) (machine_datum with_vectors : bool) (w : line_words num)
    (normal tool_vector : option (triple num)) (st : klartext_state num) :
    outcome (klartext_state num * option (planned num)) :=
  let st := with_line_modes (or_else (radius_given w) (radius_mode st)) (next_feeds st (feed_given w)) st in
  if negb with_vectors && match axis_words w with [] => true | _ => false end then Got (st, None) else
  let tcpm := tcpm_on (tcpm_of st) in
  let is_contour := contour (tcpm_of st) in
  let compensating := match radius_mode st with R0 => false | _ => true end in
  let to := end_position s machine_datum (axis_words w) st in
  let p := space_of s to in
  let d := sub3 p (space_of s (position st)) in
  let direction := direction_at_end s st (axis_words w) normal tool_vector to in
  let t := of_length_1 direction in
  let tool := tool_now st in
  let row := table_row tool in
  let used_vector := if tcpm then tool_vector else None in
  let vector_warning v := match v with Some v => not_normalized v | None => Got false end in
  normal_off <- vector_warning normal ;;
  tool_off <- vector_warning used_vector ;;
  effective <-
    (if with_vectors || (compensating && tcpm)
     then e <- usable_tool tool (option_map (fun n => angle_of_contact n (as_given direction)) normal) compensating ;;
          Got (Some e)
     else Got None) ;;
  below <- match normal with Some n => leans_below n (as_given direction) | None => Got false end ;;
  let nominal := if tcpm && reference_is_center (tcpm_of st) then sub3 p (scale3 (corner_radius row) t) else p in
  '(way, jumps, touching_direction, corner) <-
    match effective, normal with
    | Some e, Some n =>
        w <- ring_direction n (as_given direction) ;;
        has_flat <- is_positive "heidenhain.tool.effective-flat" (flat e) ;;
        jumps <- contact_jumps has_flat (contact_before st) w ;;
        let cut := cut_face is_contour (if is_contour then p else nominal) (corner_radius row) e (unit3 n) t w in
        Got (Known (tip_of_cut cut) (shift_of_cut cut) (Some (contact_of cut)), jumps, Some w, full_corner e)
    | _, _ =>
        let corner := (corner_radius row + of_corner (total_deltas tool))%num in
        let way := match compensating, tcpm, effective with
                   | true, true, Some e =>
                       let dR := of_radius (delta e) in
                       Beside (if is_contour then p else nominal)
                         (Lateral (match radius_mode st with RL => true | _ => false end) (as_given direction) d)
                         (if is_contour then full_radius e else dR) dR
                   | true, _, _ => NotModelled
                   | false, _, _ => Known nominal zero3 None
                   end in
        Got (way, false, None, corner)
    end ;;
  let m := Motion (match feed_given w with Some FMax => true | _ => false end) (feed_in_force (feeds_of st)) to
             (filter (fun w => rotary (axis_letter w)) (axis_words w)) t (of_length (total_deltas tool))
             (overall_length row) corner in
  let all := warn (many_digits w) "W_DIGITS" ++ warn (given tool_vector && negb tcpm) "W_T_IGNORED" ++
             warn normal_off "W_NOT_NORMALIZED" ++ warn tool_off "W_NOT_NORMALIZED" ++ warn below "W_N_BELOW" ++
             warn jumps "W_CONTACT_JUMP" ++
             warn (with_vectors && negb (given normal) && negb compensating) "W_NO_LATERAL" in
  let st := at_end_of_motion to touching_direction (if tcpm then with_direction direction st else st) in
  Got (st, Some (Planned all d m way)).

(** * A block *)

Definition has_function {num} (code : Z) (b : klartext_block num) : bool := existsb (Z.eqb code) (functions b).

(** heidenhain.program.oversize-switch, heidenhain.program.tcpm-on: M107 and M128 act at the start of their block; the
    reference point of M128 is the tip. *)
Definition starts {num} {N : Numbers num} (b : klartext_block num) (st : klartext_state num) : klartext_state num :=
  let st := if has_function 128 b then tcpm_from_here false st else st in
  if has_function 107 b then with_m107 true st else st.
(** M108 and M129 act at the end. *)
Definition closes {num} {N : Numbers num} (b : klartext_block num) (st : klartext_state num) : klartext_state num :=
  let st := if has_function 129 b then no_tcpm st else st in
  if has_function 108 b then with_m107 false st else st.

(** heidenhain.program.machine-coordinates-under-tcpm: under TCPM a block with M91 or M92 raises E_TCPM_M91; M128 in the
    same block is on already, M129 not yet off. *)
Definition klartext_step {num} {N : Numbers num} (s : klartext_setup num) (b : klartext_block num)
    (st : klartext_state num) : outcome (klartext_state num * option (planned num)) :=
  _ <- match not_read b with Some name => Alarm name | None => Got tt end ;;
  let st := starts b st in
  let machine_datum := has_function 91 b || has_function 92 b in
  _ <- alarm_if (machine_datum && tcpm_on (tcpm_of st)) "E_TCPM_M91" ;;
  let only st : outcome (klartext_state num * option (planned num)) := Got (st, None) in
  '(st, p) <-
    match says b with
    | ToolCall tool axis d f => st <- call_tool s tool axis d f st ;; only st
    | Line w => plan s machine_datum false w None None st
    | LineWithVectors w normal tool_vector => plan s machine_datum true w normal tool_vector st
    | FunctionTcpm reference =>
        only (tcpm_from_here (match reference with CenterCenter => true | _ => false end) st)
    | ResetTcpm => only (no_tcpm st)
    | ProgPath is_contour => only (with_contour is_contour st)
    | CorrectionRow Tcs row =>
        only (with_correction (option_map (deltas_from_table st) (lookup row (correction_rows s))) st)
    | CorrectionReset Tcs | CorrectionReset BothTables => only (with_correction None st)
    | Cycle number part shifts =>
        only (if (number =? 7) && negb (part =? 0) then with_datum (shifted_datum s shifts st) st else st)
    | Assignment p v => only (with_parameter p (value_of st v) st)
    | _ => only st
    end ;;
  Got (closes b st, p).

(** heidenhain.program.end: M2, M30 and END PGM end the program after their block. *)
Definition ends_program {num} (b : klartext_block num) : bool :=
  has_function 2 b || has_function 30 b || match says b with EndProgram => true | _ => false end.

(** * A run *)

(** Blocks that move, with the place of their block, and what a run ends in. *)
Inductive item (num : Type) :=
| Moving (place : nat) (p : planned num)
| Stopped (place : nat) (by_ : list (klartext_event num)).
Arguments Moving {num} place p.
Arguments Stopped {num} place by_.

(** What a step ends the run with that has no result. *)
Definition end_in {num A} (x : outcome A) : list (klartext_event num) :=
  match x with
  | Got _ => []
  | Alarm name => [AlarmRaised name]
  | Undecided clause => [SignOpen clause]
  | Beyond what => [NotSaidYet what]
  end.

Fixpoint plans {num} {N : Numbers num} (s : klartext_setup num) (bs : list (klartext_block num)) (place : nat)
    (st : klartext_state num) : list (item num) :=
  match bs with
  | [] => []
  | b :: rest =>
      match klartext_step s b st with
      | Got (st, p) =>
          let later := if ends_program b then [] else plans s rest (S place) st in
          match p with Some p => Moving place p :: later | None => later end
      | stops => [Stopped place (end_in stops)]
      end
  end.

(** The next block with an axis word, whatever its compensation; none at the end of the run, and at an alarm. *)
Definition following_of {num} (items : list (item num)) : option (following num) :=
  match items with
  | Moving _ p :: _ =>
      Some (Following (moved_by p) (match way_of p with Beside _ l _ _ => Some (left_side l) | _ => None end))
  | _ => None
  end.

(** heidenhain.peripheral.first-block: its move has the cause start-up.
    heidenhain.peripheral.cancel: that of the first moving block behind the last compensated one has the cause cancel.
    heidenhain.peripheral.former-direction, heidenhain.peripheral.reversal: alarms name the block whose end point is wanted,
    of which nothing is given. *)
Fixpoint events_of {num} {N : Numbers num} (s : klartext_setup num) (items : list (item num))
    (before : option (option (triple num))) : list (nat * klartext_event num) :=
  match items with
  | [] => []
  | Stopped place es :: _ => map (pair place) es
  | Moving place p :: rest =>
      let m := motion_of p in
      let here last := map (fun name => (place, Warning name)) (warnings p) ++ [(place, last)] in
      match way_of p with
      | Known tip shift touch =>
          here (Moved (move_to_tip s m (if given before then Cancelling else Programmed) tip shift touch)) ++
          events_of s rest None
      | NotModelled => here OutOfScope ++ events_of s rest None
      | Beside nominal l by_delta by_radius =>
          match beside_end l before (following_of rest) with
          | Got (beside, made) =>
              here (Moved (move_to_tip s m (if given before then Programmed else StartUp)
                             (add3 nominal (scale3 by_delta beside)) (scale3 by_radius beside) None)) ++
              events_of s rest (Some (Some made))
          | stops => map (pair place) (end_in stops)
          end
      end
  end.

Definition run_klartext {num} {N : Numbers num} (s : klartext_setup num) (bs : list (klartext_block num)) :
    list (nat * klartext_event num) :=
  events_of s (plans s bs 0%nat (initial_state s (units_of_program s bs))) None.
