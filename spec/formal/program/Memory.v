(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/program: the tool offset memory and G10. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Record offsets (num : Type) := Offsets { by_h : table num; by_d : table num }.
Arguments Offsets {num}. Arguments by_h {num}. Arguments by_d {num}.


(** fanuc.memory.one-table-given: in memory A and B a number that the setup gives in only one table counts for both H
    and D; if both tables give it, each address reads its own entry. *)
Definition given_offsets {num} (s : setup num) : offsets num :=
  match memory s with
  | MemoryC => Offsets (h_offsets s) (d_offsets s)
  | _ => Offsets (h_offsets s ++ d_offsets s) (d_offsets s ++ h_offsets s)
  end.

(** fanuc.memory.number-zero: Offset number 0 is always 0.
    fanuc.memory.kinds: a number without an entry is 0. *)
Definition entry_of {num} {N : Numbers num} (by_ : number_by) (o : offsets num) (number : Z) : entry num :=
  let nothing := (0%num, 0%num) in
  if number =? 0 then nothing
  else or_else (lookup number (match by_ with ByH => by_h o | ByD => by_d o end)) nothing.

(** The largest value of the memory, in ten thousandths of a mm or hundred thousandths of an inch.
    fanuc.memory.value-too-large: geometry IS-A 999.99 mm, 99.999 inch; IS-B 999.999, 99.9999; IS-C 999.9999, 99.99999.
    fanuc.memory.g10-range: wear one whole digit less. *)
Definition largest {num} {N : Numbers num} (s : setup num) (wear : bool) : num :=
  let digits :=
    match least_increment s, wear with
    | IS_A, false => 9999900 | IS_B, false => 9999990 | IS_C, false => 9999999
    | IS_A, true => 999900 | IS_B, true => 999990 | IS_C, true => 999999
    end in
  (integer digits / integer (if inches s then 100000 else 10000))%num.

Definition beyond_largest {num} {N : Numbers num} (clause : string) (s : setup num) (wear : bool) (x : num) :
    outcome bool :=
  over <- is_positive clause (x - largest s wear)%num ;;
  under <- is_negative clause (x + largest s wear)%num ;;
  Got (over || under).

(** What is applied: geometry plus wear. fanuc.memory.value-too-large: PS0029. *)
Definition applied {num} {N : Numbers num} (s : setup num) (by_ : number_by) (o : offsets num) (number : Z) :
    outcome num :=
  let '(geometry, wear) := entry_of by_ o number in
  let total := (geometry + wear)%num in
  too_large <- beyond_largest "fanuc.memory.value-too-large" s false total ;;
  _ <- alarm_if too_large "offset-value" ;;
  Got total.

(** What G10 writes: of which address, wear or geometry, which number, which value. *)
Record writing (num : Type) := Writing {
  of_address : number_by;
  of_wear : bool;
  at_number : Z;
  for_h : num;     (* the new value in the table of H *)
  for_d : num      (* and in that of D *)
}.
Arguments Writing {num}. Arguments of_address {num}. Arguments of_wear {num}. Arguments at_number {num}.
Arguments for_h {num}. Arguments for_d {num}.

(** fanuc.memory.g10-kind: memory A L11; B L10 geometry, L11 wear; C L10 and L11 for H, L12 and L13 for D; L1 is L11.
    Any other L, or no L, raises PS0010. *)
Definition store {num} (s : setup num) (l : option Z) : option (number_by * bool) :=
  lookup (or_else l 0)
    match memory s with
    | MemoryA => [(11, (ByH, false)); (1, (ByH, false))]
    | MemoryB => [(10, (ByH, false)); (11, (ByH, true)); (1, (ByH, true))]
    | MemoryC => [(10, (ByH, false)); (11, (ByH, true)); (1, (ByH, true)); (12, (ByD, false)); (13, (ByD, true))]
    end.

(** The number of L or P; none where it is not whole. *)
Definition whole_word {num} (letter : Letter.t) (b : block num) : option Z :=
  match last_word letter (words b) with Some w => whole w | None => None end.

(** fanuc.memory.g10-number: a P that is not whole, is 0, is beyond the memory or is missing raises PS0031.
    fanuc.memory.g10-value: without R nothing is written; on the 30i PS0031.
    fanuc.memory.g10-adds: under G90 the value replaces the stored one, under G91 it is added.
    fanuc.memory.g10-range: beyond the range of its store PS0032. *)
Definition written {num} {N : Numbers num} (s : setup num) (m : modes) (o : offsets num) (b : block num)
    (into : number_by * bool) : outcome (option (writing num)) :=
  let '(by_, wear) := into in
  match whole_word Letter.P b with
  | Some number =>
      if (number <? 1) || (offset_count s <? number) then Alarm "g10-number"
      else
        match last_number s (in_inches m) Letter.R b with
        | None => if series_30i s then Alarm "g10-number" else Got None
        | Some r =>
            let new by_ :=
              let '(geometry, old_wear) := entry_of by_ o number in
              let old := if wear then old_wear else geometry in
              if incremental m then (old + r)%num else r in
            h_too_large <- beyond_largest "fanuc.memory.g10-range" s wear (new ByH) ;;
            d_too_large <- beyond_largest "fanuc.memory.g10-range" s wear (new ByD) ;;
            let too_large :=
              match memory s, by_ with
              | MemoryC, ByH => h_too_large
              | MemoryC, ByD => d_too_large
              | _, _ => h_too_large || d_too_large
              end in
            _ <- alarm_if too_large "g10-value" ;;
            Got (Some (Writing by_ wear number (new ByH) (new ByD)))
        end
  | None => Alarm "g10-number"
  end.

(** fanuc.memory.kinds, fanuc.memory.one-table-given: in memory A and B H and D share what is written; if both tables
    have the number, each adds to its own. *)
Definition write {num} {N : Numbers num} (s : setup num) (w : writing num) (o : offsets num) : offsets num :=
  let put by_ t :=
    let '(geometry, wear) := entry_of by_ o (at_number w) in
    let new := match by_ with ByH => for_h w | ByD => for_d w end in
    (at_number w, if of_wear w then (geometry, new) else (new, wear)) :: t in
  match memory s, of_address w with
  | MemoryC, ByH => Offsets (put ByH (by_h o)) (by_d o)
  | MemoryC, ByD => Offsets (by_h o) (put ByD (by_d o))
  | _, _ => Offsets (put ByH (by_h o)) (put ByD (by_d o))
  end.
