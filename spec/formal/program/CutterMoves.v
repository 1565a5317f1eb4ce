(* SPDX-License-Identifier: Apache-2.0 *)
(** Moves of cutter compensation: heads, causes, and the arcs between heads. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners LengthOffset.
From Toolcomp Require Import CutterState State Movements CutterRules.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** With a vector of the plane for its head. *)
Definition at_vector {num} {N : Numbers num} (s : setup num) (p : plane) (v : pair num) (m : movement num) :
    movement num :=
  with_head m (with_plane s p (zeros s) v).
Definition for_cause {num} (c : cause) (m : movement num) : movement num :=
  Movement (going m) c (ends_at m) (tip m) (head m) (length_vector m) (machine_zero m) (circle_of m) (at_feed m)
    (along_tool m).
Definition on_circle {num} (a : option (arc num)) (m : movement num) : movement num :=
  Movement (going m) (because m) (ends_at m) (tip m) (head m) (length_vector m) (machine_zero m) a (at_feed m)
    (along_tool m).

(** fanuc.cutter-b.arc-sweep, fanuc.cutter-c.arc-sweep: from the old head to the new one about the centre, over 0 up to
    360 degrees.
    fanuc.cutter-b.arc-head-in-center: none where a head lies in the centre.
    fanuc.cutter-b.arc-radii, fanuc.cutter-c.arc-radii: both distances where they differ. *)
Definition arc_of_heads {num} {N : Numbers num} (p : plane) (clockwise : bool) (center from to : pair num) :
    outcome (arc num) :=
  c <- around clockwise center from to ;; Got (Arc center p (sweep_of c) (ends c)).

(** The move of a block that has none of its own, or that changes the length offset alone. *)
Definition move_at {num} {N : Numbers num} (s : setup num) (t : travel) (c : cause) (p : plane) (v : pair num)
    (a : option (arc num)) (st : state num) : movement num :=
  at_vector s p v (move_to s t c false a st (vector (length_of st))).

(** What is no move. *)
Definition still {num} (items : list (item num)) : list (item num) :=
  filter (fun i => match i with Go _ => false | _ => true end) items.

(** The moves of a block that have no arc, with one head. *)
Definition at_head {num} {N : Numbers num} (s : setup num) (p : plane) (v : pair num) (items : list (item num)) :
    list (item num) :=
  map (fun i => match i with Go m => Go (at_vector s p v m) | _ => i end) items.

(** The own move of a block, from the head v to the head w, with this cause where it has not its own. *)
Definition own_move_between {num} {N : Numbers num} (s : setup num) (p : plane) (b : planned num) (why : cause)
    (v w : pair num) : outcome (list (item num)) :=
  each
    (fun i =>
      match i with
      | Go m =>
          let why := match because m with Programmed => why | its_own => its_own end in
          let m := for_cause why (at_vector s p w m) in
          match circle_of m with
          | None => Got (Go m)
          | Some a =>
              let clockwise := match going m with Clockwise => true | _ => false end in
              a' <- arc_of_heads p clockwise (center a) (add2 (plane_point s p (before b)) v)
                      (add2 (plane_point s p (behind b)) w) ;;
              Got (Go (on_circle (Some a') m))
          end
      | _ => Got i
      end)
    (items b).
