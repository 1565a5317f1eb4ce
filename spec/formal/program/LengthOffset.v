(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-length-offset: G43, G44, G49 and H, and what G53, G28, G30 and G30.1 do to the offset. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** G43 adds the offset, G44 subtracts it. *)
Inductive direction := Add | Subtract.

(** Which of the controlled axes, in the order of the setup. *)
Definition axis_set := list bool.
Definition meets (a b : axis_set) : bool := existsb (fun here => here) (map2 andb a b).
Definition without (a b : axis_set) : axis_set := map2 (fun x y => x && negb y) a b.
Definition union (a b : axis_set) : axis_set := map2 orb a b.
Definition size (a : axis_set) : Z := Z.of_nat (List.length (filter (fun here => here) a)).
Definition empty (a : axis_set) : bool := size a =? 0.

Record length_offset (num : Type) := LengthOffset {
  in_force : option direction;      (* none: G49 *)
  number_in_force : Z;
  vector : values num;              (* what is added to each axis *)
  offset_last : axis_set;           (* the axes offset last *)
  taken_away : axis_set             (* those whose vector G53 or a reference return has taken away *)
}.
Arguments LengthOffset {num}. Arguments in_force {num}. Arguments number_in_force {num}. Arguments vector {num}.
Arguments offset_last {num}. Arguments taken_away {num}.

Definition no_axes {num} (s : setup num) : axis_set := map (fun _ => false) (axes s).
Definition the_axis {num} (s : setup num) (letter : Letter.t) : axis_set := map (Letter.eqb letter) (axes s).

(** fanuc.program.initial-state: G49, H0. *)
Definition no_length_offset {num} {N : Numbers num} (s : setup num) : length_offset num :=
  LengthOffset None 0 (zeros s) (no_axes s) (no_axes s).

(** The codes of the group. *)
Inductive length_code := G43 | G44 | G49.
Definition length_code_of (codes : list Z) : option length_code :=
  match last_of lengths codes with Some code => lookup code [(430, G43); (440, G44); (490, G49)] | None => None end.

(** What a block says to the length offset. *)
Record length_command := LengthCommand {
  code : option length_code;
  h : option Z;
  block_plane : plane;
  named : axis_set;                 (* by axis words *)
  has_words : bool;
  cutter_code : bool;               (* G40, G41 or G42 *)
  to_machine_position : axis_set    (* axes that G53, G28, G30 or G30.1 names *)
}.

Definition sets_mode (c : length_command) : bool :=
  match code c with Some G43 | Some G44 => true | _ => false end.

(** fanuc.length-offset.type: type A with TLC = 0 and TLB = 0, type B with TLC = 0 and TLB = 1, type C with TLC = 1. *)
Inductive offset_type := TypeA | TypeB | TypeC.
Definition type_of {num} (s : setup num) : offset_type :=
  if bit s "5001#0" then TypeC else if bit s "5001#1" then TypeB else TypeA.

Definition ofh {num} (s : setup num) : bool := bit s "5001#2".
Definition tal {num} (s : setup num) : bool := bit s "5001#3".
Definition evo {num} (s : setup num) : bool := bit s "5001#6".

(** fanuc.length-offset.direction: under G43 the offset of the H number is added, under G44 it is subtracted; it counts
    with its sign. *)
Definition signed {num} {N : Numbers num} (d : direction) (x : num) : num :=
  match d with Add => x | Subtract => (- x)%num end.

(** The axes with an offset that is not zero. *)
Definition offset_axes {num} {N : Numbers num} (v : values num) : outcome axis_set :=
  each (fun x => zero <- is_zero "fanuc.length-offset.replaces" x ;; Got (negb zero)) v.

(** fanuc.length-offset.replaces: a new offset replaces the one in force on its axis. *)
Definition offset_on {num} (set : axis_set) (x : num) (v : values num) : values num :=
  map2 (fun here old => if here : bool then x else old) set v.

(** fanuc.length-offset.type-c-linear-axes: type C goes by the linear axis words of the block.
    fanuc.length-offset.type-c-no-axis: no axis raises PS0027.
    fanuc.length-offset.tal: a second axis raises PS0027 with TAL = 0.
    fanuc.length-offset.type-c-several-axes: with TAL = 1 all of them get the offset. *)
Definition named_axes {num} {N : Numbers num} (s : setup num) (c : length_command) (l : length_offset num) :
    outcome axis_set :=
  let linear := map2 andb (named c) (map Letter.linear (axes s)) in
  offset <- offset_axes (vector l) ;;
  _ <- alarm_if (empty linear) "length-offset-without-axis" ;;
  let second := (1 <? size linear) || negb (empty (without offset linear)) in
  _ <- alarm_if (second && negb (tal s)) "length-offset-second-axis" ;;
  Got linear.

(** fanuc.length-offset.type-a: type A offsets Z.
    fanuc.length-offset.type-b: type B offsets the axis at right angles to the plane of the block.
    fanuc.length-offset.type-c: type C offsets the axis that the block with G43 or G44 names.
    fanuc.length-offset.type-c-last-axis: in type C an H without G43 or G44 acts on the axis offset last. *)
Definition affected {num} {N : Numbers num} (s : setup num) (c : length_command) (l : length_offset num) :
    outcome axis_set :=
  match type_of s with
  | TypeA => Got (the_axis s Letter.Z)
  | TypeB => Got (the_axis s (match block_plane c with XY => Letter.Z | ZX => Letter.Y | YZ => Letter.X end))
  | TypeC => if sets_mode c then named_axes s c l else Got (offset_last l)
  end.

(** The number that the block brings into force.
    fanuc.length-offset.ofh, fanuc.length-offset.ofh-lone-number: with OFH = 1 an H counts only in a block with G43 or
    G44.
    fanuc.length-offset.ofh-first-without-number: with OFH = 1 a G43 or G44 without H takes H0 if no length offset is in
    force.
    fanuc.length-offset.one-number: with g49_sets_h0 in the setup, a G49 without H makes it 0. *)
Definition new_number {num} (s : setup num) (c : length_command) (l : length_offset num) : option Z :=
  match h c with
  | Some number => if ofh s && negb (sets_mode c) then None else Some number
  | None =>
      if sets_mode c && ofh s && negb (given (in_force l)) then Some 0
      else match code c with Some G49 => if g49_sets_h0 s then Some 0 else None | _ => None end
  end.

(** The value of the number in force on these axes, which have their vector back. *)
Definition apply {num} {N : Numbers num} (s : setup num) (o : offsets num) (set : axis_set) (l : length_offset num) :
    outcome (length_offset num) :=
  match in_force l with
  | Some d =>
      if empty set then Got l
      else
        x <- applied s ByH o (number_in_force l) ;;
        Got (LengthOffset (in_force l) (number_in_force l) (offset_on set (signed d x) (vector l)) (offset_last l)
               (without (taken_away l) set))
  | None => Got l
  end.

(** fanuc.length-offset.cancel: G49 cancels the offset of all axes at once.
    fanuc.length-offset.cancel-three-axes: while three or more axes have an offset that is not zero it raises PS0015. *)
Definition cancel {num} {N : Numbers num} (s : setup num) (l : length_offset num) : outcome (length_offset num) :=
  offset <- offset_axes (vector l) ;;
  _ <- alarm_if (3 <=? size offset) "length-offset-axes" ;;
  Got (LengthOffset None (number_in_force l) (zeros s) (no_axes s) (no_axes s)).

(** A block with G43, G44 or an H that counts.
    fanuc.length-offset.number-while-cancelled: while no length offset is in force an H stores its number.
    fanuc.length-offset.number-only-stored: in a block with G40, G41 or G42 what would restore a vector only stores
    number and mode.
    fanuc.length-offset.restored-by-number: else it restores the vector on the axes on which it acts. *)
Definition take {num} {N : Numbers num} (s : setup num) (o : offsets num) (c : length_command) (l : length_offset num) :
    outcome (length_offset num) :=
  let mode := match code c with Some G43 => Some Add | Some G44 => Some Subtract | _ => in_force l end in
  let l := LengthOffset mode (number_in_force l) (vector l) (offset_last l) (taken_away l) in
  match mode with
  | None => Got l
  | Some _ =>
      set <- affected s c l ;;
      if cutter_code c && meets set (taken_away l) then Got l
      else apply s o set (LengthOffset mode (number_in_force l) (vector l) set (taken_away l))
  end.

(** fanuc.length-offset.evo, fanuc.length-offset.evo-axes, fanuc.length-offset.restored-in-next-block,
    fanuc.length-offset.next-block: types A and B with EVO = 1: in the next block with a word the axes offset last have
    the current value of the number in force.
    fanuc.length-offset.not-restored-with-cutter-code: a block with G40, G41 or G42 does not restore a vector. *)
Definition next_block {num} {N : Numbers num} (s : setup num) (o : offsets num) (c : length_command)
    (l : length_offset num) : outcome (length_offset num) :=
  match type_of s, evo s && has_words c with
  | TypeC, _ | _, false => Got l
  | _, true =>
      apply s o (if cutter_code c then without (offset_last l) (taken_away l) else offset_last l) l
  end.

(** fanuc.length-offset.machine-position-cancels: every offset axis that G53 or a reference return names loses its
    offset; the mode stays. *)
Definition lose {num} {N : Numbers num} (s : setup num) (c : length_command) (l : length_offset num) :
    outcome (length_offset num) :=
  match in_force l with
  | None => Got l
  | Some _ =>
      offset <- offset_axes (vector l) ;;
      let lost := map2 andb (to_machine_position c) (union (offset_last l) offset) in
      Got (LengthOffset (in_force l) (number_in_force l) (offset_on lost 0%num (vector l)) (offset_last l)
             (union (taken_away l) lost))
  end.

(** The offset on the way to an intermediate point, and at the end of the block. *)
Definition length_step {num} {N : Numbers num} (s : setup num) (o : offsets num) (c : length_command)
    (l : length_offset num) : outcome (length_offset num * length_offset num) :=
  let number := new_number s c l in
  let l := LengthOffset (in_force l) (or_else number (number_in_force l)) (vector l) (offset_last l) (taken_away l) in
  on_way <-
    match code c with
    | Some G49 => cancel s l
    | _ => if sets_mode c || given number then take s o c l
           else if given (in_force l) then next_block s o c l else Got l
    end ;;
  at_end <- lose s c on_way ;;
  Got (on_way, at_end).
