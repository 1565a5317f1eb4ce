(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/cutter-compensation-c: the blocks in order, each with what follows it. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners Interference LengthOffset.
From Toolcomp Require Import CutterState State Movements CutterRules CutterMoves CutterModes.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

Definition plane_of {num} (b : planned num) : plane := in_plane (in_modes (command_of b)).
Definition part_of {num} (b : planned num) : part := plays (cutter (behind b)).
Definition moves_of {num} (b : planned num) : list (movement num) :=
  flat_map (fun i => match i with Go m => [m] | _ => [] end) (items b).

(** * Looking ahead *)

Inductive ahead (num : Type) :=
| Next (b : planned num) (repeated : bool)
| NoNext
| NoVector
| TooFar.
Arguments Next {num} b repeated. Arguments NoNext {num}. Arguments NoVector {num}. Arguments TooFar {num}.

(** fanuc.cutter-c.repeated: a word G41 or G42 equal to the code in force before it. *)
Definition repeats {num} (b : planned num) : bool :=
  says_hand (command_of b) &&
  match hand_in_force (cutter (before b)), hand_in_force (cutter (behind b)) with
  | Some LeftHand, Some LeftHand | Some RightHand, Some RightHand => true
  | _, _ => false
  end.

Definition stops {num} (s : setup num) (b : planned num) : bool := stops_reading s (command_of b).

(** fanuc.cutter-c.one-non-motion-block, fanuc.cutter-c.two-non-motion-blocks: past so many blocks as are read.
    fanuc.cutter-c.look-ahead-stopped, fanuc.cutter-c.no-next-block: what there is no corner with.
    fanuc.cutter-c.coordinate-shift: what takes the vector away. *)
Fixpoint look {num} (s : setup num) (count : Z) (repeated : bool) (bs : list (planned num)) : ahead num :=
  match bs with
  | [] => NoNext
  | b :: rest =>
      let repeated := repeated || repeats b in
      match part_of b with
      | Idle n =>
          if stops s b then NoNext
          else if count + n <? idle_limit s then look s (count + n) repeated rest else TooFar
      | LoneStart => TooFar
      | StartUpBlock | ModeBlock | CancelBlock | WayBlock => Next b repeated
      | LoneCancel | MovesFree | CornerBlock | GoesAway => NoNext
      | ShiftsPlane => NoVector
      end
  end.

(** What is read behind a block before it has run. *)
Definition beyond {num} (s : setup num) (b : planned num) (rest : list (planned num)) : list (planned num) :=
  if stops s b then [] else rest.
Definition loses_vector {num} (s : setup num) (b : planned num) (rest : list (planned num)) : bool :=
  match look s 0 false (beyond s b rest) with NoVector => true | _ => false end.

(** * Corners *)

Definition rho_of {num} {N : Numbers num} (x : cutter_state num) : num := offset_of (was_left x) (reach x).

(** A moving block at its end. *)
Definition leg_behind {num} {N : Numbers num} (s : setup num) (b : planned num) : leg num :=
  end_leg s (command_of b) (before b) (behind b) (moves_of b) (rho_of (cutter (behind b))).
(** And at its start, with the offset of the corner. *)
Definition leg_before {num} {N : Numbers num} (s : setup num) (b : planned num) (rho : num) : leg num :=
  let c := command_of b in
  match arc_run (moves_of b), way_to_intermediate s c (before b) (moves_of b) with
  | Some (clockwise, a), _ =>
      arc_leg (Bow clockwise (sub2 (center a) (plane_point s (arc_plane a) (before b)))) rho
  | None, Some d => line_leg d rho
  | None, None => line_leg (travel_in_plane s c (before b) (behind b)) rho
  end.

(** fanuc.cutter-c.cancel-direction: the letters of the plane beside the word G40. *)
Definition cancel_direction {num} {N : Numbers num} (s : setup num) (b : planned num) : outcome (option (pair num)) :=
  match says_cancel (command_of b), plane_letters s (command_of b) with
  | true, Some u =>
      nothing <- is_zero "fanuc.cutter-c.cancel-direction" (square2 u) ;;
      Got (if nothing : bool then None else Some u)
  | _, _ => Got None
  end.

(** fanuc.cutter-c.small-corner-before-half-circle: whether the block runs 180 degrees or more. *)
Definition half_circle {num} {N : Numbers num} (s : setup num) (b : planned num) : outcome bool :=
  match arc_run (moves_of b) with
  | None => Got false
  | Some (clockwise, a) =>
      let from := sub2 (plane_point s (arc_plane a) (before b)) (center a) in
      let to := sub2 (plane_point s (arc_plane a) (behind b)) (center a) in
      shorter <- is_positive "fanuc.cutter-c.small-corner-before-half-circle"
                   (if clockwise then cross2 to from else cross2 from to) ;;
      Got (negb shorter)
  end.

(** fanuc.cutter-c.small-corner-movement: No. 5010. *)
Definition thinned {num} {N : Numbers num} (s : setup num) (b : planned num) (group : list (pair num)) :
    outcome (list (pair num)) :=
  if single group then Got group
  else
    all_stay <- half_circle s b ;;
    if all_stay : bool then Got group else without_small_moves (or_else (parameter s "5010") 0%num) group.

(** fanuc.cutter-c.which-rule: the group between a and b.
    fanuc.cutter-c.value-at-a-corner: both sides take the offset in force at the end of a, each its own side.
    fanuc.cutter-c.value-zero: without an offset the vector zero alone. *)
Definition corner_group {num} {N : Numbers num} (s : setup num) (a b : planned num) (repeated : bool) :
    outcome (list (pair num)) :=
  let x := cutter (behind a) in
  let leg_a := leg_behind s a in
  let same_side := Bool.eqb (was_left x) (was_left (cutter (behind b))) in
  let cancels := match part_of b with CancelBlock => true | _ => false end in
  let starts := match part_of a with StartUpBlock => true | _ => false end in
  nothing <- is_zero "fanuc.cutter-c.value-zero" (reach x) ;;
  if nothing : bool then Got [zero2]
  else if negb cancels && negb same_side then direction_change_group leg_a (leg_before s b (- rho_of x)%num)
  else if repeated then Got [perpendicular leg_a]
  else
    let leg_b := leg_before s b (rho_of x) in
    if cancels then
      directed <- cancel_direction s b ;;
      match directed with
      | Some u => directed_cancel_group leg_a u
      | None => cancel_group (sup s) leg_a leg_b
      end
    else if starts then start_up_group (sup s) leg_a leg_b
    else mode_group leg_a leg_b.

(** The vectors at the end of a moving block: those of the corner, or P1.
    fanuc.cutter-c.coordinate-shift: before G52 or G92 of the plane it ends where it is programmed to. *)
Definition group_at_end {num} {N : Numbers num} (s : setup num) (a : planned num) (rest : list (planned num)) :
    outcome (list (pair num)) :=
  match look s 0 false (beyond s a rest) with
  | Next b repeated => group <- corner_group s a b repeated ;; thinned s b group
  | NoVector => Got [zero2]
  | NoNext | TooFar => Got [perpendicular (leg_behind s a)]
  end.

(** * Blocks *)

(** fanuc.cutter-c.corner-movement: the moves between the heads belong to the block behind the corner: straight, with its
    feed, and length offset and other axes as before it. *)
Definition corner_moves {num} {N : Numbers num} (s : setup num) (b : planned num) (vs : list (pair num)) :
    list (item num) :=
  let t := match part_of b with WayBlock => Rapid | _ => straight (motion (in_modes (command_of b))) end in
  map (fun v => Go (move_at s t Corner (plane_of b) v None (before b))) (tl vs).

(** fanuc.cutter-c.interference-check: the blocks of the offset mode, but the first after G53 or a reference return, and
    those before and after G52 or G92 of the plane.
    fanuc.cutter-c.interference-straightened: the own move of an arc that has lost a vector is linear. *)
Definition mode_block {num} {N : Numbers num} (s : setup num) (vs : list (pair num)) (b : planned num)
    (rest : list (planned num)) : outcome (list (item num) * list (pair num)) :=
  let p := plane_of b in
  ws <- group_at_end s b rest ;;
  let x := cutter (before b) in
  let y := cutter (behind b) in
  let free := match in_phase x with TakenAway => true | _ => false end in
  '(vs, ws, straightened) <-
    (if cni s || free || loses_vector s b rest then Got (vs, ws, false)
     else
       let way := Path (plane_point s p (before b)) (plane_point s p (behind b))
                    (option_map (fun r => (fst r, center (snd r))) (arc_run (moves_of b))) in
       checked (cnv s) (cnc s) way (offset_of (was_left y) (reach x)) (rho_of y) vs ws) ;;
  let lined m := Movement Linear (because m) (ends_at m) (tip m) (head m) (length_vector m) (machine_zero m) None
                   (at_feed m) (along_tool m) in
  let b' := if straightened : bool
            then with_items b (map (fun i => match i with Go m => Go (lined m) | _ => i end) (items b)) else b in
  own <- own_move_between s p b' Programmed (last vs zero2) (hd zero2 ws) ;;
  Got (corner_moves s b vs ++ own, ws).

(** fanuc.cutter-c.start-without-motion-move: the vector made or removed in a block without motion. *)
Definition at_once {num} {N : Numbers num} (s : setup num) (b : planned num) (why : cause) (v w : pair num) :
    outcome (list (item num)) :=
  let c := command_of b in
  let p := plane_of b in
  first <- is_zero "fanuc.cutter-c.start-without-motion-move" (fst w - fst v)%num ;;
  second <- is_zero "fanuc.cutter-c.start-without-motion-move" (snd w - snd v)%num ;;
  if has_axis_word c || (first && second) then
    Got (map (fun i => match i with Go m => Go (for_cause why (at_vector s p w m)) | _ => i end) (items b))
  else Got (Go (move_at s (straight (motion (in_modes c))) why p w None (behind b)) :: still (items b)).

(** fanuc.cutter-c.corner-arc: G39, from the vector in force to the one at right angles to a direction.
    fanuc.cutter-c.corner-arc-direction: that of the letters, else of the next moving block.
    fanuc.cutter-c.corner-arc-without-next-block: no arc, or undecided. *)
Definition corner_arc_c {num} {N : Numbers num} (s : setup num) (v : pair num) (b : planned num)
    (rest : list (planned num)) : outcome (list (item num) * list (pair num)) :=
  let p := plane_of b in
  let rho := rho_of (cutter (before b)) in
  let no_arc := (at_head s p v (items b), [v]) in
  direction <- match plane_letters s (command_of b), look s 0 false (beyond s b rest) with
               | Some u, _ => Got (Some u)
               | None, Next next _ => Got (Some (way (leg_before s next rho)))
               | None, NoNext | None, NoVector => Got None
               | None, TooFar => Undecided "fanuc.cutter-c.corner-arc-without-next-block"
               end ;;
  nothing <- is_zero "fanuc.cutter-c.corner-arc" rho ;;
  match direction with
  | None => Got no_arc
  | Some u =>
      let w := perpendicular (line_leg u rho) in
      across <- is_zero "fanuc.cutter-c.corner-arc" (cross2 v w) ;;
      along <- is_positive "fanuc.cutter-c.corner-arc" (dot2 v w) ;;
      if nothing || (across && along) then Got no_arc
      else
        clockwise <- is_positive "fanuc.cutter-c.corner-arc" rho ;;
        let corner := plane_point s p (behind b) in
        a <- arc_of_heads p clockwise corner (add2 corner v) (add2 corner w) ;;
        let t := if clockwise : bool then Clockwise else Counterclockwise in
        Got (Go (move_at s t Corner p w (Some a) (behind b)) :: still (items b), [w])
  end.

(** fanuc.cutter-c.start-without-motion: P2 of the next moving block, with the value of this one. *)
Definition lone_start {num} {N : Numbers num} (s : setup num) (v : pair num) (b : planned num)
    (rest : list (planned num)) : outcome (list (item num) * list (pair num)) :=
  let made := match look s 0 false (beyond s b rest) with
              | Next next _ =>
                  match part_of next with
                  | ModeBlock => Some (perpendicular (leg_before s next (rho_of (cutter (behind b)))))
                  | _ => None
                  end
              | _ => None
              end in
  match made with
  | None => Got (at_head s (plane_of b) v (items b), [v])
  | Some w => new <- at_once s b StartUp v w ;; Got (new, [w])
  end.

(** fanuc.cutter-c.machine-position, fanuc.cutter-c.reference-return: the vector goes in the first move.
    fanuc.cutter-c.reference-intersection: with CCN = 1 it goes on the way to the reference position.
    fanuc.cutter-c.start-without-motion-move: where other axes go and SUV = 1 removes it, the first move takes it. *)
Definition going_away {num} {N : Numbers num} (s : setup num) (v : pair num) (b : planned num) : list (item num) :=
  let p := plane_of b in
  let w := vector_behind (cutter (behind b)) in
  let goes_on := match in_phase (cutter (behind b)) with TakenAway => true | _ => false end in
  let mode phase := match phase with Running | Started | TakenAway => true | _ => false end in
  let removed := suv s && mode (in_phase (cutter (before b))) && negb (mode (in_phase (cutter (behind b)))) &&
                 negb (names_plane s (command_of b)) in
  let through_intermediate := given (way_to_intermediate s (command_of b) (before b) (moves_of b)) in
  match items b with
  | Go first :: rest =>
      let first := if removed then for_cause Cancelling first else first in
      Go (at_vector s p (if goes_on && through_intermediate then v else w) first) :: at_head s p w rest
  | none => none
  end.

(** fanuc.cutter-c.coordinate-shift: G52 or G92 of the plane makes no move for the vector; with SUV = 1 it may end the
    mode (fanuc.cutter-c.start-without-motion-move).
    fanuc.cutter-c.coordinate-shift-with-vector: where the tool stands at a vector all the same. *)
Definition shifted {num} {N : Numbers num} (s : setup num) (v : pair num) (b : planned num) :
    outcome (list (item num) * list (pair num)) :=
  nothing <- is_zero "fanuc.cutter-c.coordinate-shift-with-vector" (square2 v) ;;
  if negb nothing then Undecided "fanuc.cutter-c.coordinate-shift-with-vector"
  else if suv s && negb (mode_is_on (in_phase (cutter (behind b)))) then
    new <- at_once s b Cancelling zero2 zero2 ;; Got (new, [zero2])
  else Got (at_head s (plane_of b) zero2 (items b), [zero2]).

(** A block: what it yields where the tool stands at the first of these vectors, and the vectors behind it. *)
Definition block_c {num} {N : Numbers num} (s : setup num) (vs : list (pair num)) (b : planned num)
    (rest : list (planned num)) : outcome (list (item num) * list (pair num)) :=
  let p := plane_of b in
  let v := hd zero2 vs in
  match part_of b with
  | Idle _ => Got (at_head s p v (items b), vs)
  | MovesFree => Got (items b, [zero2])
  | LoneStart => lone_start s v b rest
  | LoneCancel =>
      if suv s then new <- at_once s b Cancelling v zero2 ;; Got (new, [zero2])
      else Got (at_head s p v (items b), [v])
  | StartUpBlock =>
      ws <- group_at_end s b rest ;;
      own <- own_move_between s p b StartUp zero2 (hd zero2 ws) ;;
      Got (own, ws)
  | ModeBlock => mode_block s vs b rest
  | CancelBlock =>
      own <- own_move_between s p b Cancelling (last vs zero2) zero2 ;;
      Got (corner_moves s b vs ++ own, [zero2])
  | CornerBlock => corner_arc_c s v b rest
  | ShiftsPlane => shifted s v b
  | GoesAway => Got (going_away s v b, [vector_behind (cutter (behind b))])
  | WayBlock =>
      let way := perpendicular (leg_before s b (rho_of (cutter (behind b)))) in
      Got (corner_moves s b vs ++ going_away s way b, [vector_behind (cutter (behind b))])
  end.

(** The blocks up to the one that ends the run, if any does: an alarm of the geometry, or an open decision. *)
Fixpoint blocks_c {num} {N : Numbers num} (s : setup num) (vs : list (pair num)) (bs : list (planned num)) :
    list (planned num) * option (nat * ending) :=
  match bs with
  | [] => ([], None)
  | b :: rest =>
      match block_c s vs b rest with
      | Got (new, ws) => let '(later, how) := blocks_c s ws rest in (with_items b new :: later, how)
      | stopped => ([], Some (at_place b, ends_in (at_place b) stopped))
      end
  end.

(** fanuc.cutter.order-of-alarms: PS0033 and PS0041 are alarms of the geometry. *)
Definition pass_c {num} {N : Numbers num} (s : setup num) (p : plan num) : passed num :=
  match blocks_c s [zero2] (fst p) with
  | (bs, None) => Through (bs, snd p)
  | (bs, Some (place, EndsUndecided _ _ as how)) => AsIfAbsent place how
  | (bs, Some (_, how)) => Through (bs, how)
  end.
