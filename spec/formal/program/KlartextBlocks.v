(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/program: the statements of a block and the setup of a control, as the reader of text hands them over. The
    reader follows labels and calls: blocks come in the order in which they run. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Inductive parameter_kind := OfQ | OfQL | OfQR.
Record q_parameter := QParameter { kind : parameter_kind; index : Z }.

(** A number, or a parameter with its sign. *)
Inductive written (num : Type) :=
| Literal (x : num)
| OfParameter (p : q_parameter) (minus_written : bool).
Arguments Literal {num} x.
Arguments OfParameter {num} p minus_written.

(** DL, DR and DR2, or what is given of them. *)
Record deltas (A : Type) := Deltas { of_length : A; of_radius : A; of_corner : A }.
Arguments Deltas {A}. Arguments of_length {A}. Arguments of_radius {A}. Arguments of_corner {A}.

Record axis_word (num : Type) := AxisWord { axis_letter : Letter.t; with_i : bool; amount : written num }.
Arguments AxisWord {num}. Arguments axis_letter {num}. Arguments with_i {num}. Arguments amount {num}.

Inductive radius_word := R0 | RL | RR.
Inductive feed_word (num : Type) :=
| FValue (f : written num)
| FMax
| FAuto
| FZOrFU.
Arguments FValue {num} f. Arguments FMax {num}. Arguments FAuto {num}. Arguments FZOrFU {num}.
Inductive reference_word := TipTip | TipCenter | CenterCenter.
Inductive correction_table := Tcs | Wpl | BothTables.

(** Numbers in tenths: 51 for 5.1. *)
Inductive called_tool := NoToolWord | ByNumber (tenths : Z) | ByName (name : string) | ByStringParameter.

(** By what a block gets to its end. *)
Inductive leading (num : Type) :=
| ByWords                                        (* by its axis words; without one it stays *)
| AlongTool (by_ : option (written num))         (* M140 MB n; none: M140 MB MAX *)
| Departing.                                     (* DEP LT, LN, CT, of which the words say no end *)
Arguments ByWords {num}. Arguments AlongTool {num} by_. Arguments Departing {num}.

(** What L and LN have in common. Only L without axis words gets to its end by anything else. *)
Record line_words (num : Type) := LineWords {
  axis_words : list (axis_word num);
  radius_given : option radius_word;
  feed_given : option (feed_word num);
  many_digits : bool;                   (* more than the control takes *)
  to_end : leading num
}.
Arguments LineWords {num}. Arguments axis_words {num}. Arguments radius_given {num}. Arguments feed_given {num}.
Arguments many_digits {num}. Arguments to_end {num}.

Inductive statement (num : Type) :=
| BeginProgram (inch : bool)
| EndProgram                                     (* of the main program *)
| ToolCall (tool : called_tool) (tool_axis : option Letter.t) (given : deltas (option (written num)))
    (f : option (feed_word num))
| Line (w : line_words num)                                              (* L, M140, DEP *)
| LineWithVectors (w : line_words num) (normal tool_vector : option (triple num))   (* LN *)
| FunctionTcpm (reference : reference_word)
| ResetTcpm
| ProgPath (is_contour : bool)
| CorrectionRow (table : correction_table) (row : Z)
| CorrectionReset (table : correction_table)
| Cycle (number part : Z) (shifts : list (axis_word num)) (sets : list (q_parameter * written num))
| Assignment (p : q_parameter) (v : written num)
| CallProgram
| CycleCall                                      (* CYCL CALL, and M99 alone *)
| OtherStatement.                                (* read, and without effect *)
Arguments BeginProgram {num} inch. Arguments EndProgram {num}. Arguments ToolCall {num} tool tool_axis given f.
Arguments Line {num} w. Arguments LineWithVectors {num} w normal tool_vector. Arguments FunctionTcpm {num} reference.
Arguments ResetTcpm {num}. Arguments ProgPath {num} is_contour. Arguments CorrectionRow {num} table row.
Arguments CorrectionReset {num} table. Arguments Cycle {num} number part shifts sets. Arguments Assignment {num} p v.
Arguments CallProgram {num}. Arguments CycleCall {num}. Arguments OtherStatement {num}.

Record klartext_block (num : Type) := KlartextBlock {
  says : statement num;
  functions : list Z;                   (* M *)
  not_read : option string              (* the alarm of reading *)
}.
Arguments KlartextBlock {num}. Arguments says {num}. Arguments functions {num}. Arguments not_read {num}.

(** A row of the tool table, in mm. *)
Record tool_row (num : Type) := ToolRow {
  tool_number : Z;                      (* in tenths *)
  tool_name : string;                   (* empty: none *)
  radius : num;
  corner_radius : num;
  overall_length : option num;
  in_table : deltas num;
  deviations : option (list (num * num))      (* of DR2TABLE: angle, deviation; the angles ascend *)
}.
Arguments ToolRow {num}. Arguments tool_number {num}. Arguments tool_name {num}. Arguments radius {num}.
Arguments corner_radius {num}. Arguments overall_length {num}. Arguments in_table {num}. Arguments deviations {num}.

Record klartext_setup (num : Type) := KlartextSetup {
  letters : list Letter.t;
  in_inch : bool;
  start_at : values num;
  tools : list (tool_row num);
  correction_rows : list (Z * deltas num);     (* in mm *)
  m128_at_center : bool
}.
Arguments KlartextSetup {num}. Arguments letters {num}. Arguments in_inch {num}. Arguments start_at {num}.
Arguments tools {num}. Arguments correction_rows {num}.
Arguments m128_at_center {num}.

Definition rotary (letter : Letter.t) : bool := negb (Letter.linear letter).

(** The value of an axis; 0 where the control does not have it. *)
Definition at_letter {num} {N : Numbers num} (s : klartext_setup num) (letter : Letter.t) (v : values num) : num :=
  match find (fun entry => Letter.eqb (fst entry) letter) (combine (letters s) v) with
  | Some (_, x) => x
  | None => 0%num
  end.
(** X, Y and Z of a position. *)
Definition space_of {num} {N : Numbers num} (s : klartext_setup num) (v : values num) : triple num :=
  (at_letter s Letter.X v, at_letter s Letter.Y v, at_letter s Letter.Z v).
(** Only X, Y and Z are compensated. *)
Definition with_space {num} (s : klartext_setup num) (p : triple num) (v : values num) : values num :=
  let '(x, y, z) := p in
  map2 (fun letter here => match letter with Letter.X => x | Letter.Y => y | Letter.Z => z | _ => here end)
    (letters s) v.
(** Whether an axis is one of these. *)
Definition among (axes : list Letter.t) (letter : Letter.t) : bool := existsb (Letter.eqb letter) axes.
Definition word_of {num} (letter : Letter.t) (words : list (axis_word num)) : option (axis_word num) :=
  find (fun w => Letter.eqb (axis_letter w) letter) words.
