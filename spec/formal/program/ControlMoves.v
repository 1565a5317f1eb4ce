(* SPDX-License-Identifier: Apache-2.0 *)
(** Tool center point control: the axes over the movements of the tip, behind every compensation of it. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Angles EdgeState ControlState State Space Pose.
From Toolcomp Require Import ControlFrame Movements PosturePath Lean.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * The axes at a standing tool *)

(** A movement whose tip ends at a pose with a length of the tool: the axes stand at the control point. *)
Definition over_tip {num} {N : Numbers num} (s : setup num) (c : coordinates num) (m : control_mode num) (length : num)
    (p : pose num) (g : movement num) : movement num :=
  let with_rotary v := match kinematics_of s with Some k => with_pose s k c p v | None => v end in
  let ends := with_rotary (ends_at g) in
  let tip := with_rotary (tip g) in
  let point := in_space s (sum tip (head g)) in
  let along := or_else (along_tool g) (unit3 (direction m)) in
  let axes := axes_over_tip s c m length p along point in
  Movement (going g) (because g) ends tip (head g) (with_space s (zeros s) (sub3 axes point))
    (Some (work_zero s c)) (circle_of g) (at_feed g) (Some along).

(** * Inside a block *)

(** Between two numbers, points or values, at a fraction of the way. *)
Definition between {num} {N : Numbers num} (t x y : num) : num := ((1 - t) * x + t * y)%num.
Definition between3 {num} {N : Numbers num} (t : num) (a b : triple num) : triple num :=
  add3 (scale3 (1 - t)%num a) (scale3 t b).

(** fanuc.tool-center-point.tip-path: the tip is at the fraction t of its path; on an arc t is the fraction of the
    sweep, and the radius and the travel across the plane go evenly with it. *)
Definition tip_inside {num} {N : Numbers num} (t : num) (g : movement num) (from to : triple num) : triple num :=
  match circle_of g with
  | Some a =>
      match sweep a with
      | Some swept =>
          let p := arc_plane a in
          let start := sub2 (in_plane_of_space p from) (center a) in
          let angle := (t * swept)%num in
          let c := cosine angle in
          let s := match going g with Clockwise => (- sine angle)%num | _ => sine angle end in
          let longer := match radii a with Some (r0, r1) => (between t r0 r1 / r0)%num | None => 1%num end in
          let turned : pair num := ((c * fst start - s * snd start)%num, (s * fst start + c * snd start)%num) in
          plane_in_space p (add2 (center a) ((longer * fst turned)%num, (longer * snd turned)%num))
            (between t (across_plane p from) (across_plane p to))
      | None => between3 t from to
      end
  | None => between3 t from to
  end.

(** fanuc.tool-center-point.conventional: each rotary axis goes by itself, evenly. *)
Definition evenly {num} {N : Numbers num} (t : num) (from to : pose num) : pose num :=
  let at_part (a b : angle num) := angle_of_degrees (between t (degrees a) (degrees b)) in
  (at_part (fst from) (fst to), at_part (snd from) (snd to)).

(** The pose inside a block, and the direction in the programming system. *)
Definition pose_inside {num} {N : Numbers num} (s : setup num) (m : control_mode num) (run : rotary_run num) (part : Z * Z) :
    outcome (pose num * triple num) :=
  let t := (integer (fst part) / integer (snd part))%num in
  match way run, kinematics_of s with
  | DirectionAlone from to, _ => v <- on_great_circle t from to ;; Got (pose_at_end run, v)
  | Evenly, Some k =>
      let p := evenly t (pose_at_start run) (pose_at_end run) in
      Got (p, programmed_direction k (in_workpiece_system m) (frozen_pose m) p)
  | OnGreatCircle g, Some k =>
      v <- on_great_circle t (circle_from g) (circle_to g) ;;
      p <- pose_on_circle k g part v ;;
      Got (p, programmed_direction k (in_workpiece_system m) (frozen_pose m) p)
  | _, None => Got (pose_at_end run, unit3 (direction m))
  end.

(** fanuc.tool-center-point.samples: the positions at t = k/N, k from 1 to N - 1.
    fanuc.tool-center-point.length: the length goes evenly with the path. *)
Fixpoint counting (count : nat) (from : Z) : list Z :=
  match count with O => [] | S fewer => from :: counting fewer (from + 1) end.

Definition sample {num} {N : Numbers num} (s : setup num) (c : coordinates num) (m : control_mode num) (run : rotary_run num)
    (g : movement num) (from to : values num) (length_before length_behind : num) (part : Z * Z) : outcome (item num) :=
  let t := (integer (fst part) / integer (snd part))%num in
  '(p, v) <- pose_inside s m run part ;;
  let start := in_space s from in
  let finish := in_space s to in
  let tip :=
    match kinematics_of s with
    | Some k =>
        if in_workpiece_system m then
          (* On the table the tip runs straight, or on its arc. *)
          let on_table at_pose x := table_point s k c m at_pose x in
          let x := tip_inside t g (on_table (pose_at_start run) start) (on_table (pose_at_end run) finish) in
          kept_on_table s k c m (frozen_pose m) p x
        else tip_inside t g start finish
    | None => tip_inside t g start finish
    end in
  let length := between t length_before length_behind in
  let others := map2 (between t) from to in
  let rotary := match kinematics_of s with Some k => with_pose s k c p others | None => others end in
  Got (Inside part (with_space s others tip) (with_space s rotary (axes_over_tip s c m length p v tip)) v).

Definition samples {num} {N : Numbers num} (s : setup num) (c : coordinates num) (m : control_mode num) (run : rotary_run num)
    (g : movement num) (from to : values num) (length_before length_behind : num) : outcome (list (item num)) :=
  let parts := parts_of_block s in
  each
    (fun k => let common := Z.gcd k parts in
      sample s c m run g from to length_before length_behind (k / common, parts / common))
    (counting (Nat.pred (Z.to_nat parts)) 1).

(** * Blocks *)

(** Where the tip of a movement comes to. *)
Definition point_of {num} {N : Numbers num} (g : movement num) : values num := sum (tip g) (head g).

(** fanuc.tool-posture.pre-turn, fanuc.tool-posture.post-turn: one move in which the work-side axis turns alone at a
    standing tip, with the feed of the block, rapid if the block is rapid, otherwise linear. *)
Definition turn {num} {N : Numbers num} (s : setup num) (c : coordinates num) (m : control_mode num) (why : cause)
    (length : num) (to : pose num) (g : movement num) (ends standing : values num) (along : triple num) : item num :=
  Go (over_tip s c m length to
        (Movement (match going g with Rapid => Rapid | _ => Linear end) why ends standing (zeros s) (zeros s) None None
           (at_feed g) (Some along))).

(** A point fixed to the table, by the coordinates of the programming system. *)
Definition carried_point {num} {N : Numbers num} (s : setup num) (c : coordinates num) (m : control_mode num)
    (from to : pose num) (v : values num) : values num :=
  match kinematics_of s with
  | Some k => with_space s v (kept_on_table s k c m from to (in_space s v))
  | None => v
  end.

(** The block's own move, from the point before it: the turn at a singular start, the samples, the move, the turn at a
    singular end. fanuc.tool-posture.branch-mismatch: the warning comes just before the move and its samples. *)
Definition own_under_control {num} {N : Numbers num} (s : setup num) (b : planned num) (m : control_mode num)
    (run : rotary_run num) (old : control_mode num) (from : values num) (g : movement num) : outcome (list (item num)) :=
  let c := coordinates_of (behind b) in
  let length := tool_length m in
  let start := carried_point s c m (pose_before run) (pose_at_start run) from in
  let before_it := if turns_before run
                   then [turn s c m PreTurn (tool_length old) (pose_at_start run) g (programmed (before b)) start
                           (unit3 (direction old))]
                   else [] in
  let there := carried_point s c m (pose_behind run) (pose_at_end run) (tip g) in
  let g := Movement (going g) (because g) (ends_at g) there (head g) (length_vector g) (machine_zero g) (circle_of g)
             (at_feed g) (along_tool g) in
  inside <- samples s c m run g start (point_of g) (tool_length old) length ;;
  let standing := carried_point s c m (pose_at_end run) (pose_behind run) (point_of g) in
  let behind_it := if turns_behind run
                   then [turn s c m PostTurn length (pose_behind run) g (ends_at g) standing (unit3 (direction m))]
                   else [] in
  Got (before_it ++ (if off_the_branch run then [Warn "posture-branch"] else []) ++ inside ++
       Go (over_tip s c m length (pose_at_end run) g) :: behind_it).

(** The items of a block under control, from the point before: inserted moves at a standing tool before and behind the
    block's own move. *)
Fixpoint items_under_control {num} {N : Numbers num} (s : setup num) (b : planned num) (m : control_mode num)
    (old : control_mode num) (run : option (rotary_run num)) (start finish : pose num) (from : values num)
    (own_done : bool) (items : list (item num)) : outcome (list (item num) * values num) :=
  let c := coordinates_of (behind b) in
  match items with
  | [] => Got ([], from)
  | Go g :: rest =>
      '(done, own_done) <-
        match because g, own_done, run with
        | Corner, false, _ => Got ([Go (over_tip s c m (tool_length old) start g)], false)
        | _, false, Some run => own <- own_under_control s b m run old from g ;; Got (own, true)
        | _, _, _ => Got ([Go (over_tip s c m (tool_length m) finish g)], true)
        end ;;
      '(later, last) <- items_under_control s b m old run start finish (point_of g) own_done rest ;;
      Got (done ++ later, last)
  | i :: rest =>
      '(later, last) <- items_under_control s b m old run start finish from own_done rest ;;
      Got (i :: later, last)
  end.

(** The start or the cancel of the leading edge offset.
    fanuc.leading-edge.length-offset-with-start-or-cancel: its move is an inserted one, with a new length too. *)
Definition inserts_edge_move {num} (b : planned num) : bool :=
  xorb (leads (edge (before b))) (leads (edge (behind b))).

(** A block, from the point before it. *)
Definition block_under_control {num} {N : Numbers num} (s : setup num) (b : planned num) (from : values num) :
    outcome (list (item num) * values num) :=
  let now := control (behind b) in
  match in_control now with
  | None => Got (items b, fold_left (fun last i => match i with Go g => point_of g | _ => last end) (items b) from)
  | Some m =>
      let run := if inserts_edge_move b then None else run_of_block now in
      let p := or_else (stands_at now) (frozen_pose m) in
      let old := match in_control (control (before b)), run with Some old, Some _ => old | _, _ => m end in
      let start := match run with Some run => pose_before run | None => p end in
      items_under_control s b m old run start p from false (items b)
  end.

Fixpoint blocks_under_control {num} {N : Numbers num} (s : setup num) (bs : list (planned num)) (from : values num) :
    list (planned num) * ending :=
  match bs with
  | [] => ([], Ended)
  | b :: rest =>
      match block_under_control s b from with
      | Got (done, last) =>
          let '(later, how) := blocks_under_control s rest last in
          (Planned (at_place b) (command_of b) (before b) (behind b) done :: later, how)
      | stopped => ([], ends_in (at_place b) stopped)
      end
  end.

(** The pass over a plan. *)
Definition control_pass {num} {N : Numbers num} (s : setup num) (p : plan num) : passed num :=
  let '(blocks, how) := p in
  match blocks_under_control s blocks (start s) with
  | (done, Ended) => Through (done, how)
  | (_, EndsInAlarm place number) => AsIfAbsent place (EndsInAlarm place number)
  | (_, EndsUndecided place clause) => AsIfAbsent place (EndsUndecided place clause)
  end.
