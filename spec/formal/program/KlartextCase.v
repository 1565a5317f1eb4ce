(* SPDX-License-Identifier: Apache-2.0 *)
(** Klartext cases: setup and blocks from trees, events to trees. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextBlocks KlartextFace KlartextMoves KlartextProgram Data.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Definition parameter_of (kind index : data) : q_parameter :=
  QParameter (one_of [OfQ; OfQL; OfQR] OfQ kind) (whole_of index).

(** One entry: a number; three: a parameter and its sign. *)
Definition written_of {num} {N : Numbers num} (d : data) : written num :=
  match entries d with
  | [kind; index; minus] => OfParameter (parameter_of kind index) (flag_of minus)
  | _ => Literal (number_of_data (entry_at d 0))
  end.
Definition deltas_of {A} (read : data -> A) (d : data) : deltas A :=
  Deltas (read (entry_at d 0)) (read (entry_at d 1)) (read (entry_at d 2)).

Definition axis_word_of {num} {N : Numbers num} (d : data) : axis_word num :=
  AxisWord (letter_of (entry_at d 0)) (flag_of (entry_at d 1)) (written_of (entry_at d 2)).
Definition feed_of_data {num} {N : Numbers num} (d : data) : feed_word num :=
  one_of [FValue (written_of (entry_at d 1)); FMax; FAuto; FZOrFU] FMax (entry_at d 0).
Definition line_of {num} {N : Numbers num} (d : data) : line_words num :=
  LineWords (map axis_word_of (entries (entry_at d 1))) (maybe_of (one_of [R0; RL; RR] R0) (entry_at d 2))
    (maybe_of feed_of_data (entry_at d 3)) (flag_of (entry_at d 4))
    (one_of [ByWords; AlongTool (Some (written_of (entry_at (entry_at d 5) 1))); AlongTool None; Departing] ByWords
       (entry_at (entry_at d 5) 0)).
Definition called_of (d : data) : called_tool :=
  match entries d with
  | [] => NoToolWord
  | kind :: _ => one_of [ByNumber (whole_of (entry_at d 1)); ByName (text_of (entry_at d 2)); ByStringParameter] NoToolWord kind
  end.
Definition assignment_of {num} {N : Numbers num} (d : data) : q_parameter * written num :=
  (parameter_of (entry_at d 0) (entry_at d 1), written_of (entry_at d 2)).
Definition correction_table_of (d : data) : correction_table := one_of [Tcs; Wpl; BothTables] Tcs d.

(** The statements that are not empty by their places here. *)
Definition statement_of {num} {N : Numbers num} (d : data) : statement num :=
  match entries d with
  | [] => OtherStatement
  | kind :: _ =>
      let at_ := entry_at d in
      one_of
        [BeginProgram (flag_of (at_ 1%nat));
         EndProgram;
         ToolCall (called_of (at_ 1%nat)) (maybe_of letter_of (at_ 2%nat)) (deltas_of (maybe_of written_of) (at_ 3%nat))
           (maybe_of feed_of_data (at_ 4%nat));
         Line (line_of d);
         LineWithVectors (line_of d) (maybe_of vector_of (at_ 6%nat)) (maybe_of vector_of (at_ 7%nat));
         FunctionTcpm (one_of [TipTip; TipCenter; CenterCenter] TipTip (at_ 1%nat));
         ResetTcpm;
         ProgPath (flag_of (at_ 1%nat));
         CorrectionRow (correction_table_of (at_ 1%nat)) (whole_of (at_ 2%nat));
         CorrectionReset (correction_table_of (at_ 1%nat));
         Cycle (whole_of (at_ 1%nat)) (whole_of (at_ 2%nat)) (map axis_word_of (entries (at_ 3%nat)))
           (map assignment_of (entries (at_ 4%nat)));
         Assignment (parameter_of (at_ 1%nat) (at_ 2%nat)) (written_of (at_ 3%nat));
         CallProgram;
         CycleCall]
        OtherStatement kind
  end.

Definition klartext_block_of {num} {N : Numbers num} (d : data) : klartext_block num :=
  let alarm := text_of (entry_at d 0) in
  KlartextBlock (statement_of (entry_at d 2)) (map whole_of (entries (entry_at d 1)))
    (if String.eqb alarm "" then None else Some alarm).

Definition tool_row_of {num} {N : Numbers num} (d : data) : tool_row num :=
  let at_ := entry_at d in
  let point p := (number_of_data (entry_at p 0), number_of_data (entry_at p 1)) in
  ToolRow (whole_of (at_ 0%nat)) (text_of (at_ 1%nat)) (number_of_data (at_ 2%nat)) (number_of_data (at_ 3%nat))
    (maybe_of number_of_data (at_ 4%nat)) (deltas_of number_of_data (at_ 5%nat))
    (maybe_of (fun points => map point (entries points)) (at_ 6%nat)).

Definition klartext_setup_of {num} {N : Numbers num} (d : data) : klartext_setup num :=
  let at_ := entry_at d in
  KlartextSetup (map letter_of (entries (at_ 0%nat))) (flag_of (at_ 1%nat)) (values_of (at_ 2%nat))
    (map tool_row_of (entries (at_ 3%nat))) (table_of (fun row => deltas_of number_of_data (entry_at row 1)) (at_ 4%nat))
    (flag_of (at_ 5%nat)).

(** * What a run says *)

Definition tell_contact {num} (c : contact num) : told num :=
  Several [tell_vector (contact_point c); tell_vector (contact_normal c); tell_flag (on_flat c);
           tell_maybe Number (contact_degrees c)].

(** Of the linear axes alone, and where they are known. *)
Definition tell_known {num} (letters : list Letter.t) (v : some_values num) : told num :=
  let tell '(letter, x) := match x with Some x => if Letter.linear letter then [Number x] else [] | None => [] end in
  Several (flat_map tell (combine letters v)).

Definition tell_klartext_move {num} (letters : list Letter.t) (m : klartext_move num) : list (told num) :=
  let of_tool tell := match tool_stands m with Some t => tell t | None => Several [] end in
  [tell_flag (is_rapid m);
   Says match why m with StartUp => 1 | Cancelling => 3 | _ => 0 end;
   tell_known letters (programmed_values m); tell_known letters (tip_values m);
   Several (map (tell_maybe Number) (sent_to m));
   tell_vector (direction_of_tool m);
   of_tool (fun t => tell_vector (center_of_tool t)); of_tool (fun t => tell_vector (shift_of_tip t));
   of_tool (fun t => tell_vector (shift_of_tool t)); of_tool (fun t => tell_maybe tell_vector (carrier_point t));
   of_tool (fun t => tell_maybe tell_contact (touching t));
   tell_maybe Number (feed_of_move m);
   Several (map (fun letter => tell_flag (among (not_known m) letter)) letters)].

Definition tell_klartext_event {num} (letters : list Letter.t) (e : nat * klartext_event num) : told num :=
  Several
    (Says (Z.of_nat (fst e)) ::
     match snd e with
     | Moved m => Says 0 :: tell_klartext_move letters m
     | Warning name => [Says 1; Names name]
     | AlarmRaised name => [Says 2; Names name]
     | SignOpen clause => [Says 3; Names clause]
     | OutOfScope => [Says 4]
     | HoleMade h => Says 6 :: tell_hole letters (tell_linear letters (positions_behind h)) h
     end).

(** A case, its setup and the blocks of its program: the events. *)
Definition run_klartext_case {num} {N : Numbers num} (case : data) : told num :=
  let s := klartext_setup_of (entry_at case 0) in
  Several (map (tell_klartext_event (letters s)) (run_klartext s (map klartext_block_of (entries (entry_at case 1))))).
