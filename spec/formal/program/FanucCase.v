(* SPDX-License-Identifier: Apache-2.0 *)
(** FANUC cases: setup and blocks from trees, events to trees. *)
From Coq Require Import List String Ascii ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Pose Movements Program Data.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Definition word_of {num} {N : Numbers num} (d : data) : word num :=
  let value := entry_at d 1 in
  Word (letter_of (entry_at d 0)) (number_of_data value) (tenths_of value) (flag_of (entry_at d 2)) (flag_of (entry_at d 3)).
Definition block_of_data {num} {N : Numbers num} (d : data) : block num :=
  let alarm := text_of (entry_at d 0) in
  Block (map word_of (entries (entry_at d 1))) (if String.eqb alarm "" then None else Some alarm).


(** A number that is a natural one, written as one. *)
Definition natural_of (d : data) : option Z :=
  let digits := whole_of (entry_at d 0) in
  if (whole_of (entry_at d 1) =? 0) && (0 <=? digits) then Some digits else None.

Definition setup_of {num} {N : Numbers num} (d : data) : setup num :=
  let at_ := entry_at d in
  let bits := made flag_of (entries (at_ 3%nat)) in
  let numbers := made number_of_data (entries (at_ 4%nat)) in
  let naturals := made natural_of (entries (at_ 4%nat)) in
  let offset row := (number_of_data (entry_at row 1), number_of_data (entry_at row 2)) in
  Setup (map letter_of (entries (at_ 0%nat))) (flag_of (at_ 1%nat))
    (one_of [IS_A; IS_B; IS_C] IS_B (at_ 2%nat))
    (found bits) (found numbers) (fun name => or_else (found naturals name) None)
    (one_of [MemoryA; MemoryB; MemoryC] MemoryA (at_ 5%nat))
    (whole_of (at_ 6%nat)) (table_of offset (at_ 7%nat)) (table_of offset (at_ 8%nat)) (flag_of (at_ 9%nat))
    (map values_of (entries (at_ 10%nat))) (values_of (at_ 11%nat))
    (table_of (fun row => values_of (entry_at row 1)) (at_ 12%nat))
    (values_of (at_ 13%nat)) (table_of (fun row => values_of (entry_at row 1)) (at_ 14%nat)) (values_of (at_ 15%nat))
    (map (maybe_of number_of_data) (entries (at_ 16%nat))) (flag_of (at_ 17%nat)) (whole_of (at_ 18%nat))
    (flag_of (at_ 19%nat)) (flag_of (at_ 20%nat)) (flag_of (at_ 21%nat)) (flag_of (at_ 22%nat)) None.

(** A whole number in decimals. *)
Fixpoint digits_of (steps : nat) (i : Z) (behind : string) : string :=
  match steps with
  | O => behind
  | S fewer =>
      let digit := String (ascii_of_nat (Z.to_nat (48 + i mod 10))) behind in
      if i <? 10 then digit else digits_of fewer (i / 10) digit
  end.
Definition decimal_text (i : Z) : string := digits_of 20 i "".

Definition tell_arc {num} (a : arc num) : told num :=
  Several
    [tell_values [fst (center a); snd (center a)];
     Says match arc_plane a with XY => 0 | ZX => 1 | YZ => 2 end;
     tell_maybe Number (sweep a);
     tell_maybe (fun r => tell_values [fst r; snd r]) (radii a)].

Definition tell_move {num} (letters : list Letter.t) (m : move num) : list (told num) :=
  [Says match travel_of m with Rapid => 0 | Linear => 1 | Clockwise => 2 | Counterclockwise => 3 end;
   Says match cause_of m with
        | Programmed => 0 | StartUp => 1 | Corner => 2 | Cancelling => 3 | PreTurn => 4 | PostTurn => 5 | Reference => 6
        | Measuring => 7
        end;
   tell_linear letters (programmed_end m); tell_linear letters (tool_point m); tell_values (axis_positions m);
   tell_maybe tell_values (machine_positions m); tell_maybe tell_arc (arc_of m); tell_maybe Number (feed_of m);
   tell_maybe tell_vector (tool_axis m)].

Definition tell_event {num} (letters : list Letter.t) (e : nat * event num) : told num :=
  Several
    (Says (Z.of_nat (fst e)) ::
     match snd e with
     | Moves m => Says 0 :: tell_move letters m
     | Setting name value => [Says 1; Names name; Number value]
     | Raised number => [Says 2; Names number]
     | NotDecided clause => [Says 3; Names clause]
     | Warned name => [Says 4; Names name]
     | Sampled (numerator, denominator) point positions axis =>
         [Says 5; Says numerator; Says denominator; tell_linear letters point; tell_values positions; tell_vector axis]
     | Drilled h => Says 6 :: tell_hole letters (tell_values (positions_behind h)) h
     end).

(** A case, its setup and the blocks of its program: the events. *)
Definition run_fanuc {num} {N : Numbers num} (case : data) : told num :=
  let s := with_mechanism (setup_of (entry_at case 0)) in
  Several (map (tell_event (axes s)) (fst (run_program decimal_text s (map block_of_data (entries (entry_at case 1)))))).
