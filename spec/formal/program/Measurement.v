(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-length-measurement: G37, which measures a tool and corrects its offset. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory LengthOffset.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** fanuc.length-measurement.zones: 20 mm and 5 mm if the setup does not give them. *)
Definition length_parameter {num} {N : Numbers num} (s : setup num) (number : string) (millimetres : Z) : num :=
  let default := integer millimetres in
  or_else (parameter s number) (if inches s then (default * integer 10 / integer 254)%num else default).
Definition slow_distance {num} {N : Numbers num} (s : setup num) : num := length_parameter s "6251" 20.
Definition zone {num} {N : Numbers num} (s : setup num) : num := length_parameter s "6254" 5.

(** The alarms of its words, in their order.
    fanuc.length-measurement.number-in-block: an H word in the block raises PS0082.
    fanuc.length-measurement.number-zero: PS0081 if the H number of the length offset is 0.
    fanuc.length-measurement.axis: exactly one axis word, of a linear axis, and G90, else PS0083.
    fanuc.length-measurement.with-length-code: G43, G44 or G49 in the block raises MEASUREMENT_FORMAT.
    fanuc.length-measurement.in-cutter-compensation: while cutter compensation is on PS0036.
    fanuc.length-measurement.parameters-in-order: 6251 > 6254 >= 0, and 6241 above 0, else MEASUREMENT_PARAMETERS. *)
Definition measurement_words {num} {N : Numbers num} (s : setup num) (m : modes) (c : length_command)
    (in_cutter_compensation : bool) (l : length_offset num) : outcome unit :=
  let clause := "fanuc.length-measurement.parameters-in-order" in
  _ <- alarm_if (given (h c)) "measurement-number-in-block" ;;
  _ <- alarm_if (number_in_force l =? 0) "measurement-without-number" ;;
  let linear := map2 andb (named c) (map Letter.linear (axes s)) in
  _ <- alarm_if (incremental m || negb (size (named c) =? 1) || empty linear) "measurement-axis" ;;
  _ <- alarm_if (given (code c)) "measurement-format" ;;
  _ <- alarm_if in_cutter_compensation "measurement-in-cutter-compensation" ;;
  apart <- is_positive clause (slow_distance s - zone s)%num ;;
  negative_zone <- is_negative clause (zone s) ;;
  feed <- match parameter s "6241" with Some f => is_positive clause f | None => Got true end ;;
  alarm_if (negb apart || negative_zone || negb feed) "measurement-parameters".

(** Where the two parts of the motion end, and what is measured. *)
Record measurement_path (num : Type) := MeasurementPath {
  rapid_to : option num;          (* B, where there is a rapid part *)
  measuring_to : option num;      (* the position reached, or F, where there is a measuring part *)
  reached : num;                  (* where the axis stands then *)
  in_zone : bool                  (* else PS0080 *)
}.
Arguments MeasurementPath {num}. Arguments rapid_to {num}. Arguments measuring_to {num}. Arguments reached {num}.
Arguments in_zone {num}.

(** From A to D; the signal at the programmed coordinate p, if there is one.
    fanuc.length-measurement.start-on-the-coordinate: if A is D, the run ends undecided.
    fanuc.length-measurement.rapid-part: if A is B or lies between B and D, the measuring part begins at A.
    fanuc.length-measurement.signal-from-the-start: if the signal is on at B, the position reached is B.
    fanuc.length-measurement.too-late: if the signal has not come up to F, the axis stops there.
    fanuc.length-measurement.too-early: a signal before C raises PS0080 too. *)
Definition measure {num} {N : Numbers num} (s : setup num) (a d : num) (signal : option num) :
    outcome (measurement_path num) :=
  way <- decide "fanuc.length-measurement.start-on-the-coordinate" (d - a)%num ;;
  match way with
  | Eq => Undecided "fanuc.length-measurement.start-on-the-coordinate"
  | _ =>
      let ahead x := match way with Gt => x | _ => (- x)%num end in    (* along the motion *)
      far <- is_positive "fanuc.length-measurement.rapid-part" (ahead (d - a) - slow_distance s)%num ;;
      let b := if far : bool then (d - ahead (slow_distance s))%num else a in
      let rapid := if far : bool then Some b else None in
      let f := (d + ahead (zone s))%num in
      match signal with
      | None => Got (MeasurementPath rapid (Some f) f false)
      | Some p =>
          later <- is_positive "fanuc.length-measurement.signal-from-the-start" (ahead (p - b))%num ;;
          let p := if later : bool then p else b in
          too_late <- is_negative "fanuc.length-measurement.too-late" (zone s - ahead (p - d))%num ;;
          if too_late : bool then Got (MeasurementPath rapid (Some f) f false)
          else
            too_early <- is_negative "fanuc.length-measurement.too-early" (ahead (p - d) + zone s)%num ;;
            Got (MeasurementPath rapid (if later : bool then Some p else None) p (negb too_early))
      end
  end.

(** fanuc.length-measurement.value, fanuc.length-measurement.sign, fanuc.length-measurement.store,
    fanuc.length-measurement.range: what G10 L11 with the difference would do under G91, without a check of the range. *)
Definition measured {num} {N : Numbers num} (s : setup num) (o : offsets num) (number : Z) (difference : num) :
    writing num :=
  let wear := match memory s with MemoryA => false | _ => true end in
  let new by_ :=
    let '(geometry, old_wear) := entry_of by_ o number in ((if wear then old_wear else geometry) + difference)%num in
  Writing ByH wear number (new ByH) (new ByD).
