(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/program: workpiece systems and the positions in them. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** A workpiece system: G54 to G59 by 1 to 6, and G54.1 by its P. *)
Inductive system := Standard (number : Z) | Additional (number : Z).

Record coordinates (num : Type) := Coordinates {
  selected : system;
  standard_origins : list (Z * values num);     (* 0: added to all of them *)
  additional_origins : list (Z * values num);
  shifted : values num;                           (* G92 *)
  local : values num                              (* G52 *)
}.
Arguments Coordinates {num}. Arguments selected {num}. Arguments standard_origins {num}.
Arguments additional_origins {num}. Arguments shifted {num}. Arguments local {num}.

Definition given_coordinates {num} {N : Numbers num} (s : setup num) : coordinates num :=
  Coordinates (Standard 1) ((0, external s) :: combine [1; 2; 3; 4; 5; 6] (workpiece s)) (additional s) (zeros s) (zeros s).

Definition origin {num} {N : Numbers num} (s : setup num) (c : coordinates num) (of_ : system) : values num :=
  or_else (match of_ with
           | Standard number => lookup number (standard_origins c)
           | Additional number => lookup number (additional_origins c)
           end) (zeros s).

(** The machine position of programmed position 0. *)
Definition work_zero {num} {N : Numbers num} (s : setup num) (c : coordinates num) : values num :=
  sum (sum (origin s c (Standard 0)) (origin s c (selected c))) (sum (shifted c) (local c)).

(** The machine stays where it is: the programmed position by other coordinates. *)
Definition renamed {num} {N : Numbers num} (s : setup num) (before after : coordinates num) (programmed : values num) :
    values num :=
  difference (sum programmed (work_zero s before)) (work_zero s after).

(** fanuc.program.additional-system: without P it is P1; P beyond 1 to 48 raises PS0030. *)
Definition additional_number {num} (b : block num) : option Z :=
  match last_word Letter.P (words b) with
  | None => Some 1
  | Some w => match whole w with Some p => if (1 <=? p) && (p <=? 48) then Some p else None | None => None end
  end.

(** fanuc.program.additional-system: G54 with a P is G54.1, unless P belongs to another code of the block. *)
Definition takes_p {num} (codes : list Z) (b : block num) : bool :=
  takes_letters codes || existsb (fun code => among code [300; 434; 435]) codes ||
  match last_of cycles codes with Some code => negb (code =? 800) | None => false end ||
  existsb (fun w => match address w, tenths w with Letter.M, Some t => among t [980; 990] | _, _ => false end) (words b).

(** fanuc.program.workpiece-system: G54 to G59 and G54.1 select the workpiece system. *)
Definition select_system {num} (codes : list Z) (b : block num) (c : coordinates num) : outcome (coordinates num) :=
  let with_system chosen :=
    Coordinates chosen (standard_origins c) (additional_origins c) (shifted c) (local c) in
  match last_of systems codes with
  | None => Got c
  | Some code =>
      if (code =? 541) || ((code =? 540) && given (last_word Letter.P (words b)) && negb (takes_p codes b))
      then match additional_number b with Some p => Got (with_system (Additional p)) | None => Alarm "workpiece-number" end
      else Got (with_system (Standard (code / 10 - 53)))
  end.

(** fanuc.program.local-system: G52 moves the origin of the local system, for the axes that it names, to the values of
    its words. *)
Definition with_local {num} (numbers : some_values num) (c : coordinates num) : coordinates num :=
  Coordinates (selected c) (standard_origins c) (additional_origins c) (shifted c) (replace (local c) numbers).

(** fanuc.program.shift: G92 gives the programmed position of the axes that it names the values of its words; the local
    system of these axes ends. *)
Definition with_shift {num} {N : Numbers num} (s : setup num) (numbers : some_values num) (programmed : values num)
    (c : coordinates num) : coordinates num :=
  let no_local := Coordinates (selected c) (standard_origins c) (additional_origins c) (shifted c)
    (replace (local c) (map (option_map (fun _ => 0%num)) numbers)) in
  let now := renamed s c no_local programmed in
  let moved := map2 (fun wanted position => option_map (fun x => (position - x)%num) wanted) numbers now in
  Coordinates (selected c) (standard_origins c) (additional_origins c)
    (sum (shifted c) (map (fun x => or_else x 0%num) moved)) (local no_local).

(** fanuc.program.origin: G10 L2 and L20 write the origin of the axes that they name: under G90 the words replace it,
    under G91 they are added.
    fanuc.program.origin-number: P of L2 is 0 to 6, of L20 that of G54.1; another number, or no P, raises PS0031. *)
Definition with_origin {num} {N : Numbers num} (s : setup num) (incremental : bool) (l : Z) (b : block num)
    (numbers : some_values num) (c : coordinates num) : outcome (coordinates num) :=
  let new old := map2 (fun x number =>
    match number with Some y => if incremental then (x + y)%num else y | None => x end) old numbers in
  match whole_word Letter.P b with
  | None => Alarm "g10-workpiece"
  | Some p =>
      if l =? 2 then
        _ <- alarm_if (6 <? p) "g10-workpiece" ;;
        Got (Coordinates (selected c) ((p, new (origin s c (Standard p))) :: standard_origins c)
               (additional_origins c) (shifted c) (local c))
      else
        _ <- alarm_if ((p =? 0) || (48 <? p)) "g10-workpiece" ;;
        Got (Coordinates (selected c) (standard_origins c)
               ((p, new (origin s c (Additional p))) :: additional_origins c) (shifted c) (local c))
  end.
