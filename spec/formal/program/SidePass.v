(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-side-compensation: the moves of a plan. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Arcs Corners LengthOffset SideState State Space Pose.
From Toolcomp Require Import Movements SidePlane SideWords SideBlocks SideGroups SideCheck.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Alarms of commands *)

Definition starts_at_once {num} (s : setup num) (b : planned num) : bool :=
  makes_at_once s && made (side_at_end b) && negb (made (side (before b))).
Definition removes_at_once {num} (s : setup num) (b : planned num) : bool :=
  makes_at_once s && negb (made (side_at_end b)) && made (side (before b)).

(** fanuc.tool-side.type-c-format: TYPE_C_FORMAT where the block right after a start of type C does not move in the
    plane of VT before it, cancels, or is not there. *)
Definition start_has_next {num} {N : Numbers num} (s : setup num) (b : planned num) (rest : list (planned num)) :
    outcome unit :=
  match rest with
  | [] => Alarm "type-c-format"
  | next :: _ =>
      moves <- moves_across s (tool_behind s b) next ;;
      alarm_if (negb (moves && asked (side_at_end next))) "type-c-format"
  end.

(** fanuc.tool-side.arc-plane: seen on edge, at the end of a block whose B is the arc, or at its own end, an arc leaves the
    run undecided. The directions of the tool that wait for block B, each with how many blocks they may still pass. *)
Definition waiting (num : Type) := list (triple num * Z).

Definition arc_on_edge {num} {N : Numbers num} (s : setup num) (w : waiting num) (b : planned num) : outcome unit :=
  match arc_of_block b with
  | Some (clockwise, circle) =>
      if asked (side_at_end b) then
        _ <- each (fun e => seen_clockwise (fst e) (arc_plane circle) clockwise) w ;;
        _ <- seen_clockwise (tool_behind s b) (arc_plane circle) clockwise ;;
        Got tt
      else Got tt
  | None => Got tt
  end.

(** Who still waits behind a block, and the block itself. *)
Fixpoint still_waiting {num} {N : Numbers num} (s : setup num) (b : planned num) (w : waiting num) :
    outcome (waiting num) :=
  match w with
  | [] => Got []
  | (vt, more) :: w =>
      moves <- moves_across s vt b ;;
      later <- still_waiting s b w ;;
      Got (if moves || (more =? 0) then later else (vt, more - 1) :: later)
  end.
Definition waiting_behind {num} {N : Numbers num} (s : setup num) (b : planned num) (w : waiting num) :
    outcome (waiting num) :=
  w <- (if stops_look_ahead s (block_of (command_of b)) then Got [] else still_waiting s b w) ;;
  Got (if makes_corner b || starts_at_once s b then w ++ [(tool_behind s b, idle_limit s - 1)] else w).

Fixpoint commands_refused {num} {N : Numbers num} (s : setup num) (w : waiting num) (bs : list (planned num)) :
    option (nat * ending) :=
  match bs with
  | [] => None
  | b :: rest =>
      let here :=
        _ <- arc_on_edge s w b ;;
        if starts_at_once s b then start_has_next s b rest else Got tt in
      let next := waiting_behind s b w in
      match here, next with
      | Got _, Got w => commands_refused s w rest
      | Got _, stopped => Some (at_place b, ends_in (at_place b) stopped)
      | stopped, _ => Some (at_place b, ends_in (at_place b) stopped)
      end
  end.

(** * Vectors of a plan *)

(** A block, what stands at its end where it makes a vector, and whether its arc is straightened. *)
Definition offset_block (num : Type) := (planned num * option (standing num) * bool)%type.

(** The vectors at the start of the first block as they are left, the blocks, and where their geometry ends the run. *)
Record offset_blocks (num : Type) := OffsetBlocks {
  left_at_start : option (standing num);
  compensated_blocks : list (offset_block num);
  refused : option (nat * ending)
}.
Arguments OffsetBlocks {num}. Arguments left_at_start {num}. Arguments compensated_blocks {num}. Arguments refused {num}.

Definition last_head {num} {N : Numbers num} (at_end : standing num) : triple num :=
  last (map snd (heads at_end)) (0%num, 0%num, 0%num).
(** One vector, without a corner. *)
Definition held {num} (v : triple num) : standing num := Standing [(true, v)] None None.

(** fanuc.tool-side.start-type-c: the vector perpendicular to the next block at its start. *)
Definition standing_at_start {num} {N : Numbers num} (s : setup num) (b : planned num) (rest : list (planned num)) :
    outcome (standing num) :=
  let x := side_at_end b in
  let vt := tool_behind s b in
  match rest with
  | [] => Alarm "type-c-format"
  | next :: _ =>
      negative <- is_negative "fanuc.cutter.side" (side_value x) ;;
      let rho := to_left (on_left x) (if negative : bool then (- side_value x)%num else side_value x) in
      leg <- leg_in_plane s vt next (uncompensated (before next)) rho ;;
      Got (Standing [(true, perpendicular (P := plane_of_tool vt) leg)] (Some (vt, rho)) (Some (at_place next)))
  end.

(** fanuc.tool-side.along-the-tool-at-its-end: B of a corner that does not move at its own end keeps the last vector,
    and there is no corner behind it. *)
Definition is_b_of {num} (b : planned num) (v : standing num) : bool :=
  match corner_b v with Some place => Nat.eqb place (at_place b) | None => false end.

Fixpoint offset_from {num} {N : Numbers num} (s : setup num) (at_start : option (standing num)) (bs : list (planned num)) :
    offset_blocks num :=
  match bs with
  | [] => OffsetBlocks at_start [] None
  | b :: rest =>
      let stop how := OffsetBlocks at_start [] (Some (at_place b, how)) in
      if starts_at_once s b then
        match standing_at_start s b rest with
        | Got v =>
            let later := offset_from s (Some v) rest in
            OffsetBlocks None ((b, left_at_start later, false) :: compensated_blocks later) (refused later)
        | how => stop (ends_in (at_place b) how)
        end
      else if makes_corner b then
        let checked :=
          w <- standing_at_end s b rest ;;
          match at_start with
          | Some v => '(v, w, line_now) <- interference s b v w ;; Got (Some v, w, line_now)
          | None => Got (None, w, false)
          end in
        match checked with
        | Got (v, w, line_now) =>
            let later := offset_from s (Some w) rest in
            OffsetBlocks v ((b, left_at_start later, line_now) :: compensated_blocks later) (refused later)
        | how => stop (ends_in (at_place b) how)
        end
      else
        let go_on next := offset_from s next rest in
        let here := (b, None, false) in
        match made (side_at_end b), at_start with
        | true, Some v =>
            if is_b_of b v then
              let later := go_on (Some (held (last_head v))) in
              OffsetBlocks at_start (here :: compensated_blocks later) (refused later)
            else
              let later := go_on at_start in
              OffsetBlocks (left_at_start later) (here :: compensated_blocks later) (refused later)
        | _, _ =>
            let later := go_on None in
            OffsetBlocks at_start (here :: compensated_blocks later) (refused later)
        end
  end.

(** * Moves *)

(** Where the tool stands: the vector, and corner moves that are still to be made. *)
Record tool_at (num : Type) := ToolAt { vector_now : triple num; corner_moves : list (triple num) }.
Arguments ToolAt {num}. Arguments vector_now {num}. Arguments corner_moves {num}.

Definition at_point {num} {N : Numbers num} : tool_at num := ToolAt (0%num, 0%num, 0%num) [].

Definition head_of {num} {N : Numbers num} (s : setup num) (v : triple num) : values num := with_space s (zeros s) v.

(** fanuc.tool-side.stop-point: a corner move, rapid where its block is in G00, with the axes as they stand. *)
Definition corner_move {num} {N : Numbers num} (s : setup num) (st : state num) (v : triple num) : item num :=
  Go (inserted_move s Corner st (head_of s v)).

(** fanuc.tool-side.arc-as-run: about the programmed centre, from head to head as seen in the plane selected.
    fanuc.cutter-c.interference-straightened: or straight. *)
Definition as_run {num} {N : Numbers num} (s : setup num) (b : planned num) (from to : triple num) (line_now : bool)
    (m : movement num) : outcome (movement num) :=
  let m := with_head m (head_of s to) in
  match arc_of_block b with
  | None => Got m
  | Some (clockwise, a) =>
      if line_now then
        Got (Movement Linear (because m) (ends_at m) (tip m) (head m) (length_vector m) (machine_zero m) None (at_feed m)
               (along_tool m))
      else
        let p := arc_plane a in
        c <- around clockwise (center a) (add2 (in_plane_of s p (uncompensated (before b))) (seen_selected p from))
               (add2 (in_plane_of s p (uncompensated (behind b))) (seen_selected p to)) ;;
        Got (Movement (going m) (because m) (ends_at m) (tip m) (head m) (length_vector m) (machine_zero m)
               (Some (Arc (center a) p (sweep_of c) (ends c))) (at_feed m) (along_tool m))
  end.

Definition with_cause {num} (c : cause) (m : movement num) : movement num :=
  Movement (going m) c (ends_at m) (tip m) (head m) (length_vector m) (machine_zero m) (circle_of m) (at_feed m)
    (along_tool m).

(** The move of a block of type C that makes or removes the vector.
    fanuc.tool-side.length-offset-with-start-or-cancel: one move takes a change of the length too; where the vector is
    exactly zero none is made for it. *)
Definition move_at_once {num} {N : Numbers num} (s : setup num) (b : planned num) (c : cause) (zero : bool)
    (to : triple num) : list (item num) :=
  match own_go b with
  | Some m => [Go (with_head (with_cause c m) (head_of s to))]
  | None =>
      if zero then []
      else [Go (inserted_move s c (behind b) (head_of s to))]
  end.

(** fanuc.tool-side.arc-plane-mismatch: before the first move that belongs to the arc. *)
Definition mismatch {num} {N : Numbers num} (s : setup num) (b : planned num) : outcome (list (item num)) :=
  match arc_of_block b with
  | Some (_, a) =>
      if asked (side_at_end b) then
        at_start <- plane_differs (tool_of s (before b)) (arc_plane a) ;;
        at_end <- (if at_start : bool then Got true else plane_differs (tool_behind s b) (arc_plane a)) ;;
        Got (if at_end then [Warn "ARC_PLANE_MISMATCH"] else [])
      else Got []
  | None => Got []
  end.

(** fanuc.tool-side.stop-point: the corner moves that wait, the block's own move to the first vector at its end, and the
    corner moves that belong to it. *)
Definition moves_of_block {num} {N : Numbers num} (s : setup num) (t : tool_at num) (o : offset_block num) :
    outcome (planned num * tool_at num) :=
  let '(b, at_end, line_now) := o in
  let x := side_at_end b in
  let origin := (0%num, 0%num, 0%num) in
  if starts_at_once s b then
    let v := match at_end with Some v => last_head v | None => origin end in
    Got (with_items b (move_at_once s b StartUp (made_zero x) v), ToolAt v [])
  else if removes_at_once s b then
    Got (with_items b (move_at_once s b Cancelling (made_zero (side (before b))) origin), at_point)
  else
    match own_go b with
    | None => Got (b, if made x then t else at_point)
    | Some m =>
        if negb (made x || made (side (before b))) then Got (b, t)
        else
          let waiting := map (corner_move s (before b)) (corner_moves t) in
          let from := last (corner_moves t) (vector_now t) in
          warning <- mismatch s b ;;
          match at_end with
          | Some v =>
              let first := match heads v with (_, h) :: _ => h | [] => origin end in
              let others := tl (heads v) in
              let mine := map snd (filter fst others) in
              let m := if negb (made (side (before b))) then with_cause StartUp m else m in
              run <- as_run s b from first line_now m ;;
              Got (with_items b (warning ++ waiting ++ Go run :: map (corner_move s (behind b)) mine),
                   ToolAt (last mine first) (map snd (filter (fun h => negb (fst h)) others)))
          | None =>
              if made x then
                run <- as_run s b from from line_now m ;;
                Got (with_items b (warning ++ waiting ++ [Go run]), ToolAt from [])
              else
                (* fanuc.tool-side.cancel *)
                Got (with_items b (waiting ++ [Go (if crosses x then with_cause Cancelling m else m)]), at_point)
          end
    end.

Fixpoint moves_from {num} {N : Numbers num} (s : setup num) (t : tool_at num) (os : list (offset_block num))
    (how : ending) : passed num :=
  match os with
  | [] => Through ([], how)
  | o :: rest =>
      let place := at_place (fst (fst o)) in
      match moves_of_block s t o with
      | Got (b, t) =>
          match moves_from s t rest how with
          | Through (bs, how) => Through (b :: bs, how)
          | ended => ended
          end
      | stopped => AsIfAbsent place (ends_in place stopped)
      end
  end.

(** fanuc.tool-side.plane-change-alarm, fanuc.cutter-c.no-intersection, fanuc.cutter-c.interference-alarm: alarms of the
    geometry name A, the blocks before it are as computed with A present. *)
Definition side_pass {num} {N : Numbers num} (s : setup num) (p : plan num) : passed num :=
  if negb (existsb (fun b => made (side_at_end b)) (fst p)) then Through p
  else
  match commands_refused s [] (fst p) with
  | Some (place, how) => AsIfAbsent place how
  | None =>
      let o := offset_from s None (fst p) in
      match refused o with
      | Some (place, EndsInAlarm at_ number) => moves_from s at_point (compensated_blocks o) (EndsInAlarm at_ number)
      | Some (place, how) => AsIfAbsent place how
      | None => moves_from s at_point (compensated_blocks o) (snd p)
      end
  end.
