(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/program: a run, block by block, to events. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool KlartextPeripheral
  KlartextState KlartextMoves KlartextDrilling.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * A block *)

Definition has_function {num} (code : Z) (b : klartext_block num) : bool := existsb (Z.eqb code) (functions b).

(** heidenhain.program.oversize-switch, heidenhain.program.tcpm-on: M107 and M128 act at the start of their block.
    heidenhain.program.m128-reference: the reference point of M128 is that of the setup. *)
Definition starts {num} {N : Numbers num} (s : klartext_setup num) (b : klartext_block num) (st : klartext_state num) :
    klartext_state num :=
  let st := if has_function 128 b then tcpm_from_here s (m128_at_center s) st else st in
  if has_function 107 b then with_m107 true st else st.
(** M108 and M129 act at the end. *)
Definition closes {num} {N : Numbers num} (b : klartext_block num) (st : klartext_state num) : klartext_state num :=
  let st := if has_function 129 b then no_tcpm st else st in
  if has_function 108 b then with_m107 false st else st.

(** heidenhain.program.machine-coordinates-under-tcpm: under TCPM a block with M91 or M92 raises E_TCPM_M91; M128 in the
    same block is on already, M129 not yet off.
    A cycle that the block calls comes behind. *)
Definition klartext_step {num} {N : Numbers num} (s : klartext_setup num) (b : klartext_block num)
    (st : klartext_state num) : outcome (klartext_state num * option (planned num)) :=
  _ <- match not_read b with Some name => Alarm name | None => Got tt end ;;
  let st := starts s b st in
  let machine_datum := has_function 91 b || has_function 92 b in
  _ <- alarm_if (machine_datum && tcpm_on (tcpm_of st)) "machine-coordinates-under-tcpm" ;;
  let only st : outcome (klartext_state num * option (planned num)) := Got (st, None) in
  '(st, p) <-
    match says b with
    | ToolCall tool axis d f => st <- call_tool s tool axis d f st ;; only st
    | Line w => plan s machine_datum false w None None st
    | LineWithVectors w normal tool_vector => plan s machine_datum true w normal tool_vector st
    | FunctionTcpm reference =>
        only (tcpm_from_here s (match reference with CenterCenter => true | _ => false end) st)
    | ResetTcpm => only (no_tcpm st)
    | ProgPath is_contour => only (with_contour is_contour st)
    | CorrectionRow Tcs row =>
        only (with_correction (option_map (deltas_from_table st) (lookup row (correction_rows s))) st)
    | CorrectionReset Tcs | CorrectionReset BothTables => only (with_correction None st)
    | Cycle number part shifts sets =>
        only (assigned sets (if (number =? 7) && negb (part =? 0) then with_datum (shifted_datum s shifts st) st else st))
    | Assignment p v => only (with_parameter p (value_of st v) st)
    | CallProgram => only (without_radius_compensation st)
    | _ => only st
    end ;;
  Got (closes b st, p).

(** heidenhain.program.cycle-call: CYCL CALL, and M99 at the end of its block, run the drilling cycle. A block that cannot
    run to its end gives nothing. *)
Definition calls_cycle {num} (b : klartext_block num) : bool :=
  has_function 99 b || match says b with CycleCall => true | _ => false end.
Definition whole_block {num} {N : Numbers num} (s : klartext_setup num) (b : klartext_block num)
    (st : klartext_state num) : outcome (klartext_state num * option (planned num) * option (drilled num)) :=
  '(st, p) <- klartext_step s b st ;;
  '(st, d) <- (if calls_cycle b then drill s st else Got (st, None)) ;;
  Got (st, p, d).

(** heidenhain.program.end: M2, M30 and END PGM end the program after their block. *)
Definition ends_program {num} (b : klartext_block num) : bool :=
  has_function 2 b || has_function 30 b || match says b with EndProgram => true | _ => false end.

(** * A run *)

(** Blocks that move and holes, with the place of their block, and what a run ends in. *)
Inductive item (num : Type) :=
| Moving (place : nat) (p : planned num)
| Drilling (place : nat) (d : drilled num)
| Stopped (place : nat) (by_ : list (klartext_event num)).
Arguments Moving {num} place p.
Arguments Drilling {num} place d.
Arguments Stopped {num} place by_.

(** What a step ends the run with that has no result. *)
Definition end_in {num A} (x : outcome A) : list (klartext_event num) :=
  match x with
  | Got _ => []
  | Alarm name => [AlarmRaised name]
  | Undecided clause => [SignOpen clause]
  end.

Fixpoint plans {num} {N : Numbers num} (s : klartext_setup num) (bs : list (klartext_block num)) (place : nat)
    (st : klartext_state num) : list (item num) :=
  match bs with
  | [] => []
  | b :: rest =>
      match whole_block s b st with
      | Got (st, p, d) =>
          let later := if ends_program b then [] else plans s rest (S place) st in
          let later := match d with Some d => Drilling place d :: later | None => later end in
          match p with Some p => Moving place p :: later | None => later end
      | stops => [Stopped place (end_in stops)]
      end
  end.

(** heidenhain.peripheral.first-block: the next block that moves, whatever its compensation; none at the end of the run,
    and at an alarm.
    heidenhain.program.cycle-call: a hole is a motion of L under R0. *)
Definition following_of {num} (items : list (item num)) : option (following num) :=
  match items with
  | Moving _ p :: _ =>
      Some (Following (travel (ends (motion_of p)))
              match way_of p with Beside _ l _ _ => Some (left_side l) | _ => None end)
  | Drilling _ d :: _ => Some (Following (travel_to_hole d) None)
  | _ => None
  end.

(** heidenhain.peripheral.first-block: its move has the cause start-up.
    heidenhain.peripheral.cancel: that of the first moving block behind the last compensated one has the cause cancel; a
    hole is such a block without a move.
    heidenhain.peripheral.former-direction, heidenhain.peripheral.reversal: alarms name the block whose end point is wanted,
    of which nothing is given. *)
Fixpoint events_of {num} {N : Numbers num} (s : klartext_setup num) (items : list (item num))
    (before : option (option (triple num))) : list (nat * klartext_event num) :=
  match items with
  | [] => []
  | Stopped place es :: _ => map (pair place) es
  | Drilling place d :: rest => (place, HoleMade (hole_of d)) :: events_of s rest None
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
