(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/leading-edge-offset: the vectors of a plan. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory LengthOffset EdgeState State Space Pose Movements.
From Toolcomp Require Import EdgeVector.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** The travel of a block in X, Y and Z. *)
Definition travel_in_space {num} {N : Numbers num} (s : setup num) (b : planned num) : triple num :=
  sub3 (in_space s (programmed (behind b))) (in_space s (programmed (before b))).

(** fanuc.leading-edge.no-movement: a block counts as one without movement where that is exactly zero. *)
Definition moves_in_space {num} {N : Numbers num} (s : setup num) (b : planned num) : outcome bool :=
  let u := travel_in_space s b in
  still <- is_zero "fanuc.leading-edge.no-movement" (dot3 u u) ;;
  Got (negb still).

(** fanuc.leading-edge.no-movement: a block with N or O alone is no block. *)
Definition is_no_block {num} (b : planned num) : bool :=
  forallb (fun w => match address w with Letter.O => true | _ => false end) (words (block_of (command_of b))).

(** What the blocks behind a block say of the vector at the end of a block. *)
Inductive coming (num : Type) := Moving (vm : triple num) | Cancels | Unknown.
Arguments Moving {num} vm. Arguments Cancels {num}. Arguments Unknown {num}.

Definition is_cancel {num} (b : planned num) : bool := leads (edge (before b)) && negb (leads (edge (behind b))).

(** What follows: the next movement, or the end of the mode.
    fanuc.leading-edge.one-block-without-movement: one block without movement may lie between; before a cancel block too.
    fanuc.leading-edge.two-blocks-without-movement: two or more of them, and the vector made before is kept.
    fanuc.leading-edge.kept-without-look-ahead: so it is before a block that stops the look-ahead.
    fanuc.leading-edge.kept-at-the-end: and before the end, or a block that ends the run. *)
Fixpoint what_comes {num} {N : Numbers num} (s : setup num) (between : bool) (rest : list (planned num)) :
    outcome (coming num) :=
  match rest with
  | [] => Got Unknown
  | b :: rest =>
      if is_no_block b then what_comes s between rest
      else if stops_look_ahead s (block_of (command_of b)) then Got Unknown
      else if is_cancel b then Got Cancels
      else
        moving <- moves_in_space s b ;;
        if moving : bool then Got (Moving (travel_in_space s b))
        else if between then Got Unknown
        else what_comes s true rest
  end.

(** The offset value at the end of a block.
    fanuc.leading-edge.number-changed: another D counts for the vector at the end of the block that holds it. *)
Definition radius_at {num} {N : Numbers num} (s : setup num) (b : planned num) : outcome num :=
  applied s ByD (offsets_of (behind b)) (leading_number (edge (behind b))).

(** The vector at the end of a block of the mode, `last` the one at its start.
    fanuc.leading-edge.before-cancel: the block before G40 makes it from its own movement. *)
Definition vector_at_end {num} {N : Numbers num} (s : setup num) (last : leading num) (b : planned num)
    (rest : list (planned num)) : outcome (leading num) :=
  moving <- moves_in_space s b ;;
  if negb moving then Got last
  else
    next <- what_comes s false rest ;;
    r <- radius_at s b ;;
    let of_movement vm :=
      let vt := tool_behind s b in
      made <- leading_vector_of s (Some last) r vm vt ;;
      Got (or_else made last) in
    match next with
    | Moving vm => of_movement vm
    | Cancels => of_movement (travel_in_space s b)
    | Unknown => Got last
    end.

(** fanuc.leading-edge.no-movement-after-start: the block right after G41.3 moves, else PS5407.
    fanuc.leading-edge.start-along-the-tool: at the start 0 and 180 degrees raise PS5408. *)
Definition vector_at_start {num} {N : Numbers num} (s : setup num) (b : planned num) (rest : list (planned num)) :
    outcome (leading num) :=
  match find (fun b => negb (is_no_block b)) rest with
  | None => Alarm "leading-edge-command"
  | Some next =>
      moving <- moves_in_space s next ;;
      _ <- alarm_if (negb moving) "leading-edge-command" ;;
      r <- radius_at s b ;;
      let vt := tool_behind s b in
      made <- leading_vector_of s None r (travel_in_space s next) vt ;;
      match made with Some v => Got v | None => Alarm "leading-edge-start" end
  end.

(** The one move of a block that starts or cancels.
    fanuc.leading-edge.start, fanuc.leading-edge.cancel: in rapid traverse under G00, else straight with the feed.
    fanuc.leading-edge.length-offset-with-start-or-cancel: it takes a change of the length offset along. *)
Definition insert_move {num} {N : Numbers num} (s : setup num) (c : cause) (head : values num) (b : planned num) :
    planned num :=
  with_items b
    (Go (inserted_move s c (behind b) head) :: filter (fun i => match i with Go _ => false | _ => true end) (items b)).

(** A block, with the vector at its start, and the one at its end. *)
Definition led {num} {N : Numbers num} (s : setup num) (last : option (leading num)) (b : planned num)
    (rest : list (planned num)) : outcome (planned num * option (leading num)) :=
  let head v := with_space s (zeros s) (leading_vector v) in
  match last, leads (edge (behind b)) with
  | None, false => Got (b, None)
  | None, true => v <- vector_at_start s b rest ;; Got (insert_move s StartUp (head v) b, Some v)
  | Some v, false => Got (insert_move s Cancelling (zeros s) b, None)
  | Some v, true => v' <- vector_at_end s v b rest ;; Got (at_heads (head v') b, Some v')
  end.

Fixpoint led_from {num} {N : Numbers num} (s : setup num) (last : option (leading num)) (bs : list (planned num))
    (how : ending) : passed num :=
  match bs with
  | [] => Through ([], how)
  | b :: rest =>
      match led s last b rest with
      | Got (b', v) =>
          match led_from s v rest how with
          | Through (bs', how') => Through (b' :: bs', how')
          | ended => ended
          end
      | stopped => AsIfAbsent (at_place b) (ends_in (at_place b) stopped)
      end
  end.

Definition edge_pass {num} {N : Numbers num} (s : setup num) (p : plan num) : passed num :=
  led_from s None (fst p) (snd p).
