(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/canned-cycle: the drilling mode, its alarms, and the holes of a block. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes LengthOffset CycleState State Movements.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * The mode *)

(** fanuc.canned-cycle.drilling-axis: Z, or with FXY = 1 the axis at right angles to the plane of the block. *)
Definition axis_to_drill {num} (s : setup num) (p : plane) : Letter.t :=
  if bit s "5101#0" then match p with XY => Letter.Z | ZX => Letter.Y | YZ => Letter.X end else Letter.Z.

(** What is in force with the codes of a block.
    fanuc.canned-cycle.mode: another cycle keeps what the mode has.
    fanuc.canned-cycle.cancel: a code of group 01 ends the mode, whatever else the block says, and so does G80; of G80
    and cycle codes the last one counts.
    fanuc.canned-cycle.initial-level: the mode begins where the drilling axis stands.
    fanuc.canned-cycle.return: G98 and G99 are modal, in the mode and outside it. *)
Definition cycle_with {num} {N : Numbers num} (s : setup num) (codes : list Z) (p : plane) (before : cycle_state num) :
    cycle_state num :=
  CycleState
    (if given (last_of motions codes) then None
     else
       match last_of cycles codes, drilling before with
       | None, mode => mode
       | Some code, mode =>
           if code =? 800 then None
           else Some match mode with
                     | None => DrillingMode code (axis_to_drill s p) 0%num None None None
                     | Some d => DrillingMode code (drilling_axis d) (rise d) (point_r d) (bottom d) (depth_of_cut d)
                     end
       end)
    (match last_of return_levels codes with Some code => code =? 990 | None => to_point_r before end).

(** fanuc.canned-cycle.drills: a block drills if it has an axis word or R. Letters that are data of another code do not
    count, nor do those of a block with G52 or G92. Of a block in the mode. *)
Definition names_hole {num} (s : setup num) (codes : list Z) (b : block num) : bool :=
  let has letter := given (last_word letter (words b)) in
  let renaming := match action_of codes with Some LocalSystem | Some SetPosition => true | _ => false end in
  negb (takes_letters codes) && negb renaming && (existsb has (axes s) || has Letter.R).

(** fanuc.canned-cycle.repeats: by K, else by L, except the L of M98; else one. Without units and increments; none if it
    is no whole number up to 9999. *)
Definition hole_count {num} (b : block num) : option Z :=
  let calls (w : word num) := match address w, tenths w with Letter.M, Some t => t =? 980 | _, _ => false end in
  let said := match last_word Letter.K (words b) with
              | Some w => Some w
              | None => if existsb calls (words b) then None else last_word Letter.L (words b)
              end in
  match said with
  | Some w => match whole w with Some count => if count <=? 9999 then Some count else None | None => None end
  | None => Some 1
  end.
(** fanuc.canned-cycle.no-hole: K0. *)
Definition no_hole {num} (b : block num) : bool := match hole_count b with Some 0 => true | _ => false end.
(** By the mode with its codes and its words, a block makes holes. *)
Definition makes_holes {num} (s : setup num) (codes : list Z) (b : block num) (x : cycle_state num) : bool :=
  given (drilling x) && names_hole s codes b && negb (no_hole b).

(** * Data *)

(** fanuc.canned-cycle.depth-of-cut: Q of a block that drills is kept. *)
Definition depth_behind {num} (b : block num) (d : drilling_mode num) : option num :=
  match last_word Letter.Q (words b) with Some w => Some (value w) | None => depth_of_cut d end.

(** fanuc.canned-cycle.point-r, fanuc.canned-cycle.bottom: kept as they are given, whatever G90 and G91 say later. By
    the axis words of a block that drills. *)
Definition with_data {num} {N : Numbers num} (s : setup num) (c : command num) (numbers : some_values num)
    (d : drilling_mode num) : drilling_mode num :=
  let m := in_modes c in
  let as_given before number :=
    match number with
    | Some x => Some (if incremental m then Distance x else Coordinate x)
    | None => before
    end in
  DrillingMode (cycle_code d) (drilling_axis d) (rise d)
    (as_given (point_r d) (last_number s (in_inches m) Letter.R (block_of c)))
    (as_given (bottom d) (or_else (find_named (the_axis s (drilling_axis d)) numbers) None))
    (depth_behind (block_of c) d).

(** A level, by what it is a distance from; there where none has been given. *)
Definition level_from {num} {N : Numbers num} (from : num) (l : option (level num)) : num :=
  match l with Some (Coordinate x) => x | Some (Distance x) => (from + x)%num | None => from end.

(** * Alarms *)

(** fanuc.canned-cycle.reference-return: PS0044.
    fanuc.canned-cycle.in-compensation: a compensation by radius that is on after the block.
    fanuc.canned-cycle.not-said.
    fanuc.canned-cycle.depth-of-cut: PS0045. *)
Definition cycle_alarms {num} {N : Numbers num} (s : setup num) (c : command num) (x : cycle_state num) (drills : bool)
    (on_before on_after_in_space on_after_in_plane : bool) : outcome unit :=
  match drilling x with
  | None => Got tt
  | Some d =>
      let b := block_of c in
      let axis := axis_to_drill s (in_plane (in_modes c)) in
      let returns := match acting c with
                     | Some (FirstReference | ReturnFromReference | OtherReference | FloatingReference) => true
                     | _ => false
                     end in
      let other_code := match acting c with Some (Measure | CornerArc | MachinePosition) => true | _ => false end in
      let other_axis := negb (Letter.eqb axis (drilling_axis d)) || empty (the_axis s axis) in
      let other_hole := negb (given (hole_count b)) || (to_point_r x && (cycle_code d =? 870) && negb (no_hole b)) in
      _ <- alarm_if returns "reference-in-cycle" ;;
      _ <- alarm_if on_after_in_space "forbidden-in-compensation" ;;
      _ <- alarm_if on_after_in_plane "forbidden-in-cutter-compensation" ;;
      _ <- (if other_code || on_before || other_axis || (drills && other_hole)
            then Undecided "fanuc.canned-cycle.not-said" else Got tt) ;;
      if drills && among (cycle_code d) [730; 830] && negb (no_hole b) then
        lacks <- match depth_behind b d with
                 | Some q => is_zero "fanuc.canned-cycle.depth-of-cut" q
                 | None => Got true
                 end ;;
        alarm_if lacks "cycle-without-depth-of-cut"
      else Got tt
  end.

(** * Holes *)

(** fanuc.canned-cycle.position: the axis words, except that of the drilling axis, give the position of the holes. *)
Definition beside_drilling {num} (s : setup num) (axis : Letter.t) (numbers : some_values num) : some_values num :=
  map2 (fun here number => if here : bool then None else number) (the_axis s axis) numbers.

(** fanuc.canned-cycle.repeats: under G91 each hole is further by the travel of the block, under G90 all holes are in
    one place. *)
Fixpoint hole_places {num} {N : Numbers num} (travels : bool) (numbers : some_values num) (count : nat)
    (from : values num) : list (values num) :=
  match count with
  | O => []
  | S fewer => let here := destination travels from numbers in here :: hole_places travels numbers fewer here
  end.

(** What the words of the block come to with all its holes. *)
Definition numbers_of_all_holes {num} {N : Numbers num} (c : command num) (numbers : some_values num) :
    some_values num :=
  match hole_count (block_of c) with
  | Some count =>
      if count =? 0 then map (fun _ => None) numbers
      else if incremental (in_modes c) then map (option_map (fun x => (integer count * x)%num)) numbers
      else numbers
  | None => numbers
  end.

(** fanuc.canned-cycle.position: an earlier tool offset stays on its axes, the drilling axis included.
    fanuc.canned-cycle.length-offset: the axes are those of the end of the block, with the offset in force there. *)
Definition hole_at {num} {N : Numbers num} (s : setup num) (axis : Letter.t) (r bottom back : num) (st : state num)
    (position : values num) : hole num :=
  let point := sum (with_value s position axis back) (shift st) in
  let shifted x := (x + value_on s (shift st) axis)%num in
  Hole (place axis (axes s)) point (shifted r) (shifted bottom) (shifted back) (sum point (vector (length_of st))).

(** A block that drills, by its axis words, with the length offset of its end: the state behind it and the holes.
    fanuc.canned-cycle.initial-level: G99 does not change it.
    fanuc.canned-cycle.return: under G98 back to the initial level, under G99 to point R; there the axis stands then.
    fanuc.canned-cycle.no-hole: a block with K0 keeps its data alone. *)
Definition cycle_step {num} {N : Numbers num} (s : setup num) (c : command num) (drills : bool)
    (numbers : some_values num) (st : state num) : state num * list (hole num) :=
  let x := cycle st in
  match drilling x, drills, hole_count (block_of c) with
  | Some before, true, Some count =>
      let d := with_data s c numbers before in
      let axis := drilling_axis d in
      let initial := (value_on s (programmed st) axis + rise d)%num in
      let r := level_from initial (point_r d) in
      let back := if to_point_r x then r else initial in
      let positions := hole_places (incremental (in_modes c)) (beside_drilling s axis numbers) (Z.to_nat count)
                         (programmed st) in
      let kept rise := CycleState (Some (DrillingMode (cycle_code d) axis rise (point_r d) (bottom d) (depth_of_cut d)))
                         (to_point_r x) in
      match positions with
      | [] => (with_cycle st (kept (rise d)), [])
      | _ =>
          let st' := at_position st (with_value s (last positions (programmed st)) axis back) (shift st) in
          (with_cycle st' (kept (if to_point_r x then (initial - r)%num else 0%num)),
           map (hole_at s axis r (level_from r (bottom d)) back st) positions)
      end
  | _, _, _ => (st, [])
  end.
