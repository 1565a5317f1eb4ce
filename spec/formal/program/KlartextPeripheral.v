(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/peripheral-milling: RL and RR under TCPM, without a surface normal. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** heidenhain.peripheral.direction: c = s (t x d)/|t x d|, perpendicular to movement and tool; none where the tool is
    parallel to the movement or nothing moves. The test is exact.
    heidenhain.peripheral.side: s = 1 for RL, -1 for RR. *)
Definition own_direction {num} {N : Numbers num} (left : bool) (tool movement : triple num) : outcome (option (triple num)) :=
  let across := cross3 tool movement in
  let square := dot3 across across in
  nothing <- is_zero "heidenhain.peripheral.direction" square ;;
  Got (if nothing : bool then None
       else let length := root square in
            Some (scale3 ((if left then 1 else - (1)) / length)%num across)).

(** heidenhain.peripheral.former-direction: where a block has none of its own, the direction made last counts; where none
    was made since the first compensated block, E_NO_DIRECTION. *)
Definition direction_or_last {num} {N : Numbers num} (left : bool) (tool movement : triple num)
    (made_last : option (triple num)) : outcome (triple num) :=
  own <- own_direction left tool movement ;;
  match own, made_last with
  | Some c, _ | None, Some c => Got c
  | None, None => Alarm "no-direction"
  end.

(** heidenhain.peripheral.mitre: the intersection of both offset lines, (c + c')/(1 + c.c').
    heidenhain.peripheral.reversal: opposite directions raise E_REVERSAL. *)
Definition mitre {num} {N : Numbers num} (c next : triple num) : outcome (triple num) :=
  let k := (1 + dot3 c next)%num in
  opposite <- is_zero "heidenhain.peripheral.reversal" k ;;
  _ <- alarm_if opposite "opposite-directions" ;;
  Got (scale3 (1 / k)%num (add3 c next)).

(** What a compensated block is beside its end point by. *)
Record lateral (num : Type) := Lateral {
  left_side : bool;                    (* RL *)
  tool_at_end : triple num;               (* its direction, of any length *)
  movement : triple num                   (* d, between programmed points *)
}.
Arguments Lateral {num}. Arguments left_side {num}. Arguments tool_at_end {num}. Arguments movement {num}.

(** The next block that moves: its movement, where that is known, and its side where it is compensated too. *)
Record following (num : Type) := Following { next_movement : option (triple num); next_left : option bool }.
Arguments Following {num}. Arguments next_movement {num}. Arguments next_left {num}.

(** Where a compensated block ends, as a direction or a mitre to be made delta long, and the direction made last. Before it
    there was no compensation, or there was, and maybe a direction made.
    heidenhain.peripheral.first-block: it ends in the direction of the next block that moves, on the side of that block
    where it has one.
    heidenhain.program.unknown-position: where that needs a position that nobody knows it is not judged.
    heidenhain.peripheral.first-without-next: its own direction counts where none follows.
    heidenhain.peripheral.last-block: so it does where the next block is without this compensation, or there is none.
    heidenhain.peripheral.side-change: each direction takes the side of its own block.
    At a junction both directions are made with the tool there, that of the block first. *)
Definition beside_end {num} {N : Numbers num} (l : lateral num) (before : option (option (triple num)))
    (next : option (following num)) : outcome (triple num * triple num) :=
  let own := direction_or_last (left_side l) (tool_at_end l) (movement l) in
  let of_next n made :=
    match next_movement n with
    | Some d => direction_or_last (or_else (next_left n) (left_side l)) (tool_at_end l) d made
    | None => Alarm "not-judged"
    end in
  match before, next with
  | None, Some n => c <- of_next n None ;; Got (c, c)
  | None, None => c <- own None ;; Got (c, c)
  | Some made, Some n =>
      c <- own made ;;
      if given (next_left n)
      then c' <- of_next n (Some c) ;; m <- mitre c c' ;; Got (m, c')
      else Got (c, c)
  | Some made, None => c <- own made ;; Got (c, c)
  end.
