(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-side-compensation: the blocks of a corner, A and B. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Arcs Corners LengthOffset SideState State Space Pose.
From Toolcomp Require Import Movements SidePlane SideWords.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Blocks *)

Definition side_at_end {num} (b : planned num) : side_state num := side (behind b).
Definition start_point {num} {N : Numbers num} (s : setup num) (b : planned num) : triple num :=
  in_space s (programmed (before b)).
Definition end_point {num} {N : Numbers num} (s : setup num) (b : planned num) : triple num :=
  in_space s (programmed (behind b)).
(** fanuc.tool-offset.shift: where a state has the tool point without compensation; centres of arcs are shifted alike. *)
Definition uncompensated {num} {N : Numbers num} (st : state num) : values num := sum (programmed st) (shift st).
Definition displacement {num} {N : Numbers num} (s : setup num) (b : planned num) : triple num :=
  sub3 (end_point s b) (start_point s b).

(** The move of a block. *)
Definition own_go {num} (b : planned num) : option (movement num) :=
  fold_right (fun i rest => match i with Go m => Some m | _ => rest end) None (items b).
Definition arc_of_block {num} (b : planned num) : option (bool * arc num) :=
  match own_go b with
  | Some m => option_map (fun a => (match going m with Clockwise => true | _ => false end, a)) (circle_of m)
  | None => None
  end.

(** fanuc.tool-side.moving-block: asked at each corner by itself; an arc always moves. *)
Definition moves_across {num} {N : Numbers num} (s : setup num) (vt : triple num) (b : planned num) : outcome bool :=
  match arc_of_block b with Some _ => Got true | None => line_crosses s vt (displacement s b) end.

(** A block of the mode that moves in the plane at its own end, or the start-up block. *)
Definition makes_corner {num} (b : planned num) : bool :=
  let x := side_at_end b in asked x && made x && crosses x.
Definition is_start_up {num} (b : planned num) : bool := makes_corner b && negb (made (side (before b))).

(** * The block behind a corner *)

(** B, and whether a word that repeats the code stands in it or in the block between. *)
Record following (num : Type) := Following { block_b : planned num; repeated : bool }.
Arguments Following {num}. Arguments block_b {num}. Arguments repeated {num}.

Definition repeats {num} (b : planned num) : bool := repeats_code (command_of b) (side (before b)).

(** fanuc.tool-side.look-ahead, fanuc.tool-side.one-block-without-movement: past blocks that do not move in the plane of
    the corner, so many as are read.
    fanuc.tool-side.two-blocks-without-movement, fanuc.tool-side.look-ahead-stopped, fanuc.tool-side.no-next-block: too
    many of them, one that stops the look-ahead, the end, G40 or number 0 in a block that does not move: there is no B. *)
Fixpoint following_of {num} {N : Numbers num} (s : setup num) (vt : triple num) (count : Z) (again : bool)
    (rest : list (planned num)) : outcome (option (following num)) :=
  match rest with
  | [] => Got None
  | b :: rest =>
      if stops_look_ahead s (block_of (command_of b)) then Got None
      else
        moves <- moves_across s vt b ;;
        if moves : bool then Got (Some (Following b (repeats b || again)))
        else if (idle_limit s <=? count + 1) || negb (asked (side_at_end b)) then Got None
        else following_of s vt (count + 1) (repeats b || again) rest
  end.

(** * In the plane of the corner *)

(** Offset to the left of a block, by the value at the corner. *)
Definition to_left {num} {N : Numbers num} (left : bool) (r : num) : num := if left then r else (- r)%num.

(** From the centre of an arc to a point of it, in the plane selected.
    fanuc.tool-side.arc-in-the-plane: the centre is taken at the height of the point. *)
Definition radius_vector {num} {N : Numbers num} (s : setup num) (a : arc num) (point : values num) : pair num :=
  sub2 (in_plane_of s (arc_plane a) point) (center a).

(** A block at a corner, in the plane of the tool there; an arc by the end that is the corner.
    fanuc.tool-side.arc-in-the-plane: its tangent is at right angles to the radius, in the sense seen against VT. *)
Definition leg_in_plane {num} {N : Numbers num} (s : setup num) (vt : triple num) (b : planned num)
    (corner_point : values num) (rho : num) : outcome (leg_in num (triple num)) :=
  match arc_of_block b with
  | None =>
      let u := displacement s b in
      Got (Leg u (unit3 (cross3 (cross3 vt u) vt)) (leftward vt u) None rho)
  | Some (clockwise, circle) =>
      clockwise <- seen_clockwise vt (arc_plane circle) clockwise ;;
      let outward := projected vt (in_selected (arc_plane circle) (radius_vector s circle corner_point)) in
      let sense v := if clockwise then v else scale3 (integer (-1)) v in
      let tangent := scale3 (integer (-1)) (sense (cross3 vt outward)) in
      Got (Leg tangent (unit3 tangent) (unit3 (sense outward)) (Some (Bow clockwise (scale3 (integer (-1)) outward))) rho)
  end.

