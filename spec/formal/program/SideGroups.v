(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-side-compensation: the vectors of a corner. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Arcs Corners LengthOffset SideState State Space Pose.
From Toolcomp Require Import Movements SidePlane SideWords SideBlocks.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Vectors *)

(** A vector, and whether the move to it belongs to the block before the corner, up to the stop point. *)
Definition head_vector (num : Type) := (bool * triple num)%type.

(** What stands at the end of a block, or at the start of the next. *)
Record standing (num : Type) := Standing {
  heads : list (head_vector num);
  corner_axis : option (triple num * num);     (* of a corner of two blocks: VT there, and rho of B *)
  corner_b : option nat                        (* the place of B *)
}.
Arguments Standing {num}. Arguments heads {num}. Arguments corner_axis {num}. Arguments corner_b {num}.

(** * No. 5010 *)

(** fanuc.cutter-c.small-corner-before-half-circle: B is an arc of a half circle or more, in the plane selected. *)
Definition is_half_circle {num} {N : Numbers num} (s : setup num) (b : planned num) : outcome bool :=
  match arc_of_block b with
  | None => Got false
  | Some (clockwise, circle) =>
      let from := radius_vector s circle (uncompensated (before b)) in
      let to := radius_vector s circle (uncompensated (behind b)) in
      let across := if clockwise then cross2 to from else cross2 from to in
      more <- is_positive "fanuc.cutter-c.small-corner-before-half-circle" across ;;
      Got (negb more)
  end.

(** fanuc.tool-side.small-difference: a vector that differs from the last one kept by no more than 5010 is dropped. *)
Fixpoint apart_from {num} {N : Numbers num} (limit : num) (last : triple num) (vs : list (head_vector num)) :
    outcome (list (head_vector num)) :=
  match vs with
  | [] => Got []
  | (mine, v) :: rest =>
      let d := sub3 v last in
      over <- is_negative "fanuc.tool-side.small-difference" (limit * limit - dot3 d d)%num ;;
      if over : bool then later <- apart_from limit v rest ;; Got ((mine, v) :: later)
      else apart_from limit last rest
  end.
Definition without_small_differences {num} {N : Numbers num} (s : setup num) (b : planned num)
    (vs : list (head_vector num)) : outcome (list (head_vector num)) :=
  let limit := or_else (parameter s "5010") 0%num in
  match vs with
  | first :: (_ :: _) as rest =>
      negative <- is_negative "fanuc.tool-side.small-difference" limit ;;
      half <- (if negative : bool then Got true else is_half_circle s b) ;;
      if half : bool then Got vs
      else later <- apart_from limit (snd first) rest ;; Got (first :: later)
  | _ => Got vs
  end.

(** * Which rule *)

(** Q of a block. *)
Definition q_of {num} (b : planned num) : option Z := whole_word Letter.Q (block_of (command_of b)).

(** How the group of a corner comes about. *)
Inductive rule := NoOffset | ByQ1 | SideChange | Repeated | StartThenCancel | CancelRule | StartRule | ModeRule.

(** fanuc.tool-side.which-rule: the first that applies.
    fanuc.tool-side.q-where: Q has no effect in the start-up block and where B is the cancel block. *)
Definition rule_of {num} (a : planned num) (zero : bool) (f : following num) : rule :=
  let starts := is_start_up a in
  let cancels := negb (asked (side_at_end (block_b f))) in
  let q1 := match q_of a with Some q => q =? 1 | None => false end in
  if zero then NoOffset
  else if q1 && negb starts && negb cancels then ByQ1
  else if negb cancels && xorb (on_left (side_at_end a)) (on_left (side_at_end (block_b f))) then SideChange
  else if repeated f then Repeated
  else if starts && cancels then StartThenCancel
  else if cancels then CancelRule
  else if starts then StartRule
  else ModeRule.

(** * Groups *)

Definition side_leg {num} {N : Numbers num} {P : Plane num (triple num)} := leg_in num (triple num).

(** fanuc.tool-side.corner-side, fanuc.tool-side.straight-or-reversal, fanuc.tool-side.obtuse-or-acute: the names of what
    chapter 14 asks of a corner, where two lines meet. *)
Definition asked_of_lines {num} {N : Numbers num} {P : Plane num (triple num)} {A} (a b : side_leg) (x : outcome A) : outcome A :=
  match x with
  | Undecided clause =>
      if is_arc a || is_arc b then x
      else if String.eqb clause "fanuc.cutter-c.corner-side" then Undecided "fanuc.tool-side.corner-side"
      else if String.eqb clause "fanuc.cutter-c.straight-or-reversal" then Undecided "fanuc.tool-side.straight-or-reversal"
      else if String.eqb clause "fanuc.cutter-c.obtuse-or-acute" then Undecided "fanuc.tool-side.obtuse-or-acute"
      else x
  | _ => x
  end.

(** fanuc.tool-side.stop-point: of several vectors the moves up to Vi or K1 belong to A; how many they are. *)
Fixpoint up_to_stop {num} {N : Numbers num} {P : Plane num (triple num)} (count : nat) (vs : list (triple num)) : list (head_vector num) :=
  match vs with
  | [] => []
  | v :: rest => (Nat.ltb 0 count, v) :: up_to_stop (Nat.pred count) rest
  end.

(** fanuc.tool-side.start-up-inner, fanuc.tool-side.start-up-obtuse, fanuc.tool-side.start-up-acute, of type B.
    fanuc.tool-side.type-b-perpendicular: the setup may leave out the vector perpendicular to the start-up block. *)
Definition start_group {num} {N : Numbers num} {P : Plane num (triple num)} (s : setup num) (a b : side_leg) : outcome (list (head_vector num)) :=
  group <- start_up_group (with_tangents s) a b ;;
  Got (match group with
       | first :: (_ :: _) as rest => if without_perpendicular s then up_to_stop 1 rest else up_to_stop 2 group
       | _ => up_to_stop 1 group
       end).

(** fanuc.tool-side.cancel-inner, fanuc.tool-side.cancel-obtuse, fanuc.tool-side.cancel-acute, likewise. *)
Definition end_group {num} {N : Numbers num} {P : Plane num (triple num)} (s : setup num) (a b : side_leg) : outcome (list (head_vector num)) :=
  group <- cancel_group (with_tangents s) a b ;;
  let own := if is_arc a then 2%nat else 1%nat in
  Got (up_to_stop own
         (match group with _ :: _ :: _ => if without_perpendicular s then removelast group else group | _ => group end)).

(** fanuc.tool-side.inner, fanuc.tool-side.outer-obtuse, fanuc.tool-side.outer-acute, fanuc.tool-side.arc-corners.
    fanuc.tool-side.q2: of the two vectors between two lines the second is deleted. *)
Definition group_of_mode {num} {N : Numbers num} {P : Plane num (triple num)} (q : option Z) (a b : side_leg) : outcome (list (head_vector num)) :=
  group <- mode_group a b ;;
  let own := if is_arc a then 2%nat else 1%nat in
  Got (up_to_stop own
         (match group, q with
          | [k1; k2], Some 2 => if is_arc a || is_arc b then group else [k1]
          | _, _ => group
          end)).

(** The vectors of a corner of A and B. *)
Definition group_of {num} {N : Numbers num} {P : Plane num (triple num)} (s : setup num) (r : rule) (q : option Z) (a b : side_leg) :
    outcome (list (head_vector num)) :=
  let alone v := [(true, v)] in
  asked_of_lines a b
    match r with
    | NoOffset => Got (alone (0%num, 0%num, 0%num))
    | ByQ1 | Repeated | StartThenCancel => Got (alone (perpendicular a))
    | SideChange => group <- direction_change_group a b ;; Got (up_to_stop 1 group)
    | CancelRule => end_group s a b
    | StartRule => start_group s a b
    | ModeRule => group_of_mode q a b
    end.

