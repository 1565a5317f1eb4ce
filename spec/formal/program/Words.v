(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/program: the words of a block and the setup of a control, as the reader of text hands them over. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Module Letter.
  Inductive t := A | B | C | D | E | F | G | H | I | J | K | L | M | N | O | P | Q | R | S | T | U | V | W | X | Y | Z.
  Definition eqb (a b : t) : bool.
  Proof. refine (if (_ : {a = b} + {a <> b}) then true else false). decide equality. Defined.
  Definition linear (a : t) : bool := match a with U | V | W | X | Y | Z => true | _ => false end.
End Letter.


(** A word of a block. *)
Record word (num : Type) := Word {
  address : Letter.t;
  value : num;                 (* as written, in the units written *)
  tenths : option Z;         (* ten times the value, where that is a natural number of seven digits at most *)
  negative : bool;             (* a minus is written, before a zero too *)
  point : bool                 (* a decimal point is written *)
}.
Arguments Word {num}. Arguments address {num}. Arguments value {num}. Arguments tenths {num}. Arguments negative {num}. Arguments point {num}.

Record block (num : Type) := Block {
  words : list (word num);
  unreadable : option string   (* the alarm of reading *)
}.
Arguments Block {num}. Arguments words {num}. Arguments unreadable {num}.

Inductive memory_kind := MemoryA | MemoryB | MemoryC.
Inductive increment := IS_A | IS_B | IS_C.
Inductive number_by := ByH | ByD.

(** Geometry and wear of an offset number. *)
Definition entry (num : Type) := (num * num)%type.
Definition table (num : Type) := list (Z * entry num).

(** A rotary axis that turns tool or table. *)
Record rotary_axis (num : Type) := RotaryAxis {
  at_axis : option nat;      (* its place among the controlled axes; none: hypothetical *)
  stands : num;              (* the angle of a hypothetical axis *)
  about : num * num * num;   (* its direction with both axes at 0, of length 1 *)
  left_handed : bool
}.
Arguments RotaryAxis {num}. Arguments at_axis {num}. Arguments stands {num}. Arguments about {num}.
Arguments left_handed {num}.

(** What 19680 names: both rotary axes turn the tool; both the table; the first the tool and the second the table. *)
Inductive machine_type := ToolRotation | TableRotation | Mixed.

(** The rotary axes of 19680 and the direction of the tool with both at 0. *)
Record kinematics (num : Type) := Kinematics {
  machine_of : machine_type;
  first_axis : rotary_axis num;
  second_axis : rotary_axis num;
  reference_direction : num * num * num
}.
Arguments Kinematics {num}. Arguments machine_of {num}. Arguments first_axis {num}. Arguments second_axis {num}.
Arguments reference_direction {num}.

Record setup (num : Type) := Setup {
  axes : list Letter.t;
  inches : bool;
  least_increment : increment;
  parameter_bit : string -> option bool;   (* "5001#2" *)
  parameter : string -> option num;        (* "6251" *)
  whole_parameter : string -> option Z;    (* the same where it is a natural number *)
  memory : memory_kind;
  offset_count : Z;
  h_offsets : table num;
  d_offsets : table num;
  g49_sets_h0 : bool;
  workpiece : list (values num);                 (* G54 to G59 *)
  external : values num;
  additional : list (Z * values num);          (* G54.1 *)
  start : values num;
  reference : list (Z * values num);           (* 1 to 4 *)
  floating : values num;
  signal_at : some_values num;                   (* [measurement] *)
  angles_as_programmed : bool;                   (* rotary_angles *)
  parts_of_block : Z;                            (* samples of a case; 0: none are asked for *)
  cutter_b : bool;                               (* G39 to G42 are cutter compensation B *)
  without_perpendicular : bool;                  (* type_b_without_perpendicular *)
  series_30i : bool;                             (* series: else 16i *)
  tip_cancel_moves : bool;                       (* tip_control_cancel *)
  mechanism : option (kinematics num)            (* by its parameters: Pose.v *)
}.
Arguments Setup {num}. Arguments axes {num}. Arguments inches {num}. Arguments least_increment {num}. Arguments parameter_bit {num}. Arguments parameter {num}.
Arguments memory {num}. Arguments offset_count {num}. Arguments h_offsets {num}. Arguments d_offsets {num}.
Arguments g49_sets_h0 {num}. Arguments workpiece {num}. Arguments external {num}. Arguments additional {num}.
Arguments start {num}. Arguments reference {num}. Arguments floating {num}. Arguments signal_at {num}.
Arguments mechanism {num}.
Arguments whole_parameter {num}. Arguments angles_as_programmed {num}. Arguments parts_of_block {num}.
Arguments cutter_b {num}. Arguments without_perpendicular {num}.
Arguments series_30i {num}. Arguments tip_cancel_moves {num}.

(** A bit that the setup does not give. *)
Definition bit {num} (s : setup num) (parameter : string) : bool := or_else (parameter_bit s parameter) false.

Definition zeros {num} {N : Numbers num} (s : setup num) : values num := map (fun _ => 0%num) (axes s).

(** fanuc.program.last-word-of-address: if a block has several words with one address, the last one counts. *)
Definition last_word {num} (letter : Letter.t) (ws : list (word num)) : option (word num) :=
  find (fun w => Letter.eqb (address w) letter) (rev ws).

(** A whole number of a word that is not negative; none where it is none. *)
Definition whole {num} (w : word num) : option Z :=
  match tenths w with
  | Some t => if t mod 10 =? 0 then Some (t / 10) else None
  | None => None
  end.

(** The value of a table at a key. *)
Fixpoint lookup {A} (key : Z) (entries : list (Z * A)) : option A :=
  match entries with
  | [] => None
  | (k, a) :: rest => if k =? key then Some a else lookup key rest
  end.
