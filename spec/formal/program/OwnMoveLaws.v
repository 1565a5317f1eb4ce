(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of event rule 1: a block with an axis word makes exactly one own move, and no compensation changes that. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Lia.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners LengthOffset ToolShift.
From Toolcomp Require Import CutterState EdgeState SideState ControlState State Space.
From Toolcomp Require Import Movements SideWords SideBlocks SideGroups SidePass.
From Toolcomp Require Import CutterRules CutterMoves CutterB CutterModes CutterC CutterWords.
From Toolcomp Require Import EdgeWords EdgePass ControlWords ControlMoves Compensation Program OutcomeLaws PlanLaws
  ProgramLaws PassLaws.
From Toolcomp Require Import CutterLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** Moves that are inserted beside the own ones: corner moves, and turns of the rotary axes at a standing tip. *)
Definition inserted (c : cause) : bool := match c with Corner | PreTurn | PostTurn => true | _ => false end.
Definition is_own {num} (i : item num) : bool := match i with Go m => negb (inserted (because m)) | _ => false end.
Definition own_moves {num} (all : list (item num)) : nat := List.length (filter is_own all).

Lemma own_app {num} (a b : list (item num)) : own_moves (a ++ b) = (own_moves a + own_moves b)%nat.
Proof. unfold own_moves. now rewrite filter_app, app_length. Qed.

Lemma own_map {num} (f : item num -> item num) all : (forall i, is_own (f i) = is_own i) ->
  own_moves (map f all) = own_moves all.
Proof. intro E. induction all as [|i all IH]; [reflexivity|]. unfold own_moves in *. cbn. rewrite E.
destruct (is_own i); cbn; congruence. Qed.

Lemma own_none {num} (all : list (item num)) : Forall (fun i => is_own i = false) all -> own_moves all = 0%nat.
Proof. unfold own_moves. induction 1 as [|i all E _ IH]; [reflexivity|]. cbn. now rewrite E. Qed.

(** fanuc.program.own-move: in the plan every block with an axis word of its own path makes exactly one own move. *)
Theorem planned_own_move {num} {N : Numbers num} decimal (s : setup num) bs place st :
  Forall (fun p => goes_elsewhere (acting (command_of p)) = false ->
    empty (which (position_words (command_of p))) = false ->
                   own_moves (items p) = 1%nat)
    (fst (planned_from decimal s bs place st)).
Proof.
  apply (planned_all decimal s (fun _ => True) (fun _ => True)); [|apply Forall_forall; auto|exact I].
  intros ? ? ? p after moves others _ _ T. split; [exact I|]. intros G E. destruct T.
  destruct (one_move G E) as (m & -> & P). rewrite its_items, own_app. cbn [map].
  rewrite (own_none others).
  - unfold own_moves. cbn. now rewrite P.
  - rewrite forallb_forall in its_others. apply Forall_forall. intros i M. apply its_others in M. now destruct i.
Qed.

Definition along_z : block R := Block [natural Letter.G 1; natural Letter.Z 10] None.

Example planned_own_move_instance :
  Forall (fun p => goes_elsewhere (acting (command_of p)) = false ->
    empty (which (position_words (command_of p))) = false ->
                   own_moves (items p) = 1%nat)
    (fst (planned_from (fun _ => "") plain_setup [along_z] 0 (initial plain_setup))).
Proof. apply planned_own_move. Qed.

(** * Cutter compensation *)

Lemma own_between {num} {N : Numbers num} (s : setup num) p b why v w own : inserted why = false ->
  own_move_between s p b why v w = Got own -> own_moves own = own_moves (items b).
Proof.
  intros W H. unfold own_move_between in H. apply each_got in H. unfold own_moves.
  induction H as [|i j rest done E _ IH]; [reflexivity|].
  assert (O : is_own j = is_own i).
  { destruct i as [m|part a q x|name|name value|h]; try (now apply same in E as <-).
    destruct (circle_of (for_cause _ _)); [apply bound in E as (? & _ & E)|]; apply same in E as <-; cbn;
      destruct (because m); auto;
      now rewrite W. }
  cbn. rewrite O. destruct (is_own i); cbn; congruence.
Qed.

Lemma own_at_head {num} {N : Numbers num} (s : setup num) p v all : own_moves (at_head s p v all) = own_moves all.
Proof. apply own_map. now intros []. Qed.

(** fanuc.cutter-b.head-to-head: cutter compensation B keeps the number of own moves of a block with an axis word. *)
Theorem cutter_b_keeps_own_moves {num} {N : Numbers num} (s : setup num) b new :
  items_b s b = Got new -> has_axis_word (command_of b) = true -> is_corner_arc (command_of b) = false ->
  own_moves new = own_moves (items b).
Proof.
  unfold items_b; intros H A G. rewrite A, G in H. destruct (_ && _); [now apply same in H as <-|].
  apply bound in H as (nothing & _ & H). cbn [negb andb] in H. rewrite andb_false_r in H. cbn [andb] in H.
  apply own_between in H; [exact H|]. unfold cause_b. destruct (goes_away _); [reflexivity|].
  destruct (negb _ && _); [reflexivity|]. now destruct (_ && _).
Qed.

Lemma corner_moves_are_not_own {num} {N : Numbers num} (s : setup num) b vs : own_moves (corner_moves s b vs) = 0%nat.
Proof. apply own_none, Forall_map, Forall_forall. now intros v _. Qed.

Lemma own_going_away {num} {N : Numbers num} (s : setup num) v b : own_moves (going_away s v b) = own_moves (items b) \/
  existsb (fun i => match i with Go m => inserted (because m) | _ => false end) (items b) = true.
Proof.
  unfold going_away. destruct (items b) as [|[m|part a q x|name|name value|h] rest] eqn:E; try (now left).
  destruct (inserted (because m)) eqn:I; [right; cbn; now rewrite I|left].
  unfold own_moves. cbn [filter is_own]. rewrite I. cbn [negb].
  match goal with |- context [if negb ?x then _ else _] => assert (J : x = false) end.
  { cbn. match goal with |- context [if ?c then _ else _] => destruct c end; [reflexivity|exact I]. }
  rewrite J. cbn [negb List.length]. f_equal. apply (own_at_head s).
Qed.

(** fanuc.cutter-c.corner-movement: so does cutter compensation C: what it inserts are corner moves. *)
Theorem cutter_c_keeps_own_moves {num} {N : Numbers num} (s : setup num) vs b rest new ws :
  block_c s vs b rest = Got (new, ws) -> has_axis_word (command_of b) = true -> part_of b <> CornerBlock ->
  forallb (fun i => match i with Go m => negb (inserted (because m)) | _ => true end) (items b) = true ->
  own_moves new = own_moves (items b).
Proof.
  intros H A G O. assert (NONE : existsb (fun i => match i with Go m => inserted (because m) |
    _ => false end) (items b) = false).
  { apply not_true_iff_false. intro X. apply existsb_exists in X as (i & J & X). rewrite forallb_forall in O.
    specialize (O i J).
    destruct i; try discriminate. rewrite X in O. discriminate. }
  assert (ONCE : forall why v w new, inserted why = false -> at_once s b why v w = Got new ->
    own_moves new = own_moves (items b)).
  { intros why v w made W M. unfold at_once in M. rewrite A in M. apply bound in M as (first & _ & M).
    apply bound in M as (second & _ & M).
    cbn [orb] in M. apply same in M as <-. clear - W O. induction (items b) as [|i all IH]; [reflexivity|].
    cbn in O. apply andb_prop in O as [O O']. specialize (IH O'). unfold own_moves in *.
    destruct i as [m|part a q x|name|name value|h]; cbn in *; try exact IH. rewrite W, O. cbn. now rewrite IH. }
  assert (AWAY : forall v, own_moves (going_away s v b) = own_moves (items b)).
  { intro v. destruct (own_going_away s v b) as [E|E]; [exact E|rewrite E in NONE; discriminate]. }
  unfold block_c in H. destruct (part_of b) eqn:P; try (now destruct G).
  - apply same in H. injection H as <- _. apply own_at_head.
  - unfold lone_start in H.
    match type of H with match ?x with Some _ => _ | None => _ end = _ => destruct x end.
    + apply bound in H as (made & M & H). apply same in H. injection H as <- _. now apply ONCE in M.
    + apply same in H. injection H as <- _. apply own_at_head.
  - destruct (suv s).
    + apply bound in H as (made & M & H). apply same in H. injection H as <- _. now apply ONCE in M.
    + apply same in H. injection H as <- _. apply own_at_head.
  - apply bound in H as (group & _ & H). apply bound in H as (own & M & H). apply same in H. injection H as <- _.
    now apply own_between in M.
  - unfold mode_block in H. apply bound in H as (group & _ & H). apply bound in H as ([[vs' ws'] line] & _ & H).
    apply bound in H as (own & M & H). apply same in H. injection H as <- _. rewrite own_app, corner_moves_are_not_own.
    rewrite ?Nat.add_0_l.
    apply own_between in M; [|reflexivity]. rewrite M. destruct line; [|reflexivity]. cbn [items with_items].
    apply own_map. now intros [].
  - apply bound in H as (own & M & H). apply same in H. injection H as <- _.
    rewrite own_app, corner_moves_are_not_own, Nat.add_0_l.
    now apply own_between in M.
  - apply same in H. now injection H as <- _.
  - unfold shifted in H. apply bound in H as (nothing & _ & H). destruct nothing; cbn [negb] in H; [|discriminate].
    destruct (suv s && _).
    + apply bound in H as (made & M & H). apply same in H. injection H as <- _. now apply ONCE in M.
    + apply same in H. injection H as <- _. apply own_at_head.
  - apply same in H. injection H as <- _. apply AWAY.
  - apply same in H. injection H as <- _. rewrite own_app, corner_moves_are_not_own, Nat.add_0_l. apply AWAY.
Qed.

Example cutter_b_keeps_own_moves_instance (b : planned R) new :
  items_b plain_setup b = Got new -> position_words (command_of b) = [Some 5%R; None; None] ->
    acting (command_of b) = None ->
  own_moves new = own_moves (items b).
Proof.
  intros H W A. apply (cutter_b_keeps_own_moves plain_setup b new H); [unfold has_axis_word;
    now rewrite W|unfold is_corner_arc; now rewrite A].
Qed.

Definition moving_block : planned R :=
  Planned 0 (Command along_z [10%Z] None (initial_modes false) None None [None; None; Some 10%R] [None; None;
    Some 10%R] [None; None; Some 10%R])
    (initial plain_setup) (initial plain_setup)
    [Go (move_to plain_setup Linear Programmed false None (initial plain_setup) [0%R; 0%R; 0%R])].

Example cutter_c_keeps_own_moves_instance vs rest new ws :
  block_c plain_setup vs moving_block rest = Got (new, ws) -> own_moves new = 1%nat.
Proof. intro H. now apply cutter_c_keeps_own_moves in H. Qed.

(** * Tool side compensation *)

Lemma corner_moves_of_side {num} {N : Numbers num} (s : setup num) st vs :
  own_moves (map (SidePass.corner_move s st) vs) = 0%nat.
Proof. apply own_none, Forall_map, Forall_forall. now intros v _. Qed.

Lemma as_run_cause {num} {N : Numbers num} (s : setup num) b from to line m run : as_run s b from to line m = Got run ->
  because run = because m.
Proof.
  unfold as_run; intro H. destruct (arc_of_block b) as [[clockwise a]|]; [|now apply same in H as <-].
  destruct line; [now apply same in H as <-|]. apply bound in H as (c & _ & H). now apply same in H as <-.
Qed.

Lemma mismatch_is_warning {num} {N : Numbers num} (s : setup num) b all : mismatch s b = Got all ->
  own_moves all = 0%nat.
Proof.
  unfold mismatch; intro H. destruct (arc_of_block b) as [[clockwise a]|]; [|now apply same in H as <-].
  destruct (asked _); [|now apply same in H as <-]. apply bound in H as (at_start & _ & H).
  apply bound in H as (at_end & _ & H).
  apply same in H as <-. now destruct at_end.
Qed.

(** fanuc.tool-side.stop-point: so does tool side compensation, of a block whose one move is its own. *)
Theorem side_keeps_own_move {num} {N : Numbers num} (s : setup num) t b at_end line b' t' m :
  SidePass.moves_of_block s t (b, at_end, line) = Got (b', t') -> own_go b = Some m -> inserted (because m) = false ->
  own_moves (items b) = 1%nat -> own_moves (items b') = 1%nat.
Proof.
  intros H G C O. unfold SidePass.moves_of_block in H. unfold move_at_once in H. rewrite G in H.
  assert (ONE : forall run : movement num, because run = because m \/ inserted (because run) = false ->
    own_moves [Go run] = 1%nat).
  { intros run E. unfold own_moves. cbn. assert (X :
      inserted (because run) = false) by (destruct E as [->|E]; assumption). now rewrite X. }
  destruct (starts_at_once s b); [apply same in H; injection H as <- _; cbn [items with_items]; apply ONE; now right|].
  destruct (removes_at_once s b); [apply same in H; injection H as <- _; cbn [items with_items]; apply ONE; now right|].
  destruct (negb _); [apply same in H; now injection H as <- _|].
  apply bound in H as (warning & W & H). apply mismatch_is_warning in W. destruct at_end as [v|].
  - apply bound in H as (run & R & H). apply as_run_cause in R. apply same in H. injection H as <- _.
    cbn [items with_items].
    rewrite own_app, W, own_app, corner_moves_of_side. rewrite ?Nat.add_0_l.
    match goal with |- own_moves (Go run :: ?rest) = _ => change (Go run :: rest) with ([Go run] ++ rest) end.
    rewrite own_app, corner_moves_of_side, Nat.add_0_r. apply ONE. rewrite R.
    destruct (negb (made (side (before b)))); [now right|now left].
  - destruct (made (side_at_end b)).
    + apply bound in H as (run & R & H). apply as_run_cause in R. apply same in H. injection H as <- _.
      cbn [items with_items].
      rewrite own_app, W, own_app, corner_moves_of_side. rewrite ?Nat.add_0_l. apply ONE. now left.
    + apply same in H. injection H as <- _. cbn [items with_items]. rewrite own_app, corner_moves_of_side.
      rewrite ?Nat.add_0_l. apply ONE.
      destruct (crosses _); [now right|now left].
Qed.

Example side_keeps_own_move_instance t at_end line b' t' :
  SidePass.moves_of_block plain_setup t (moving_block, at_end, line) = Got (b', t') -> own_moves (items b') = 1%nat.
Proof. intro H. now apply (side_keeps_own_move plain_setup t moving_block at_end line b' t' _ H eq_refl). Qed.

(** * The leading edge offset *)

(** fanuc.leading-edge.start: and the leading edge offset, its start and its cancel included. *)
Theorem edge_keeps_own_move {num} {N : Numbers num} (s : setup num) last b rest b' v :
  led s last b rest = Got (b', v) -> own_moves (items b) = 1%nat -> own_moves (items b') = 1%nat.
Proof.
  intros H O. assert (INS : forall c head, inserted c = false -> own_moves (items (insert_move s c head b)) = 1%nat).
  { intros c head C. cbn. unfold own_moves. cbn. rewrite C. cbn. f_equal. apply own_none.
    apply Forall_forall. intros i I. apply filter_In in I as [_ I]. now destruct i. }
  unfold led in H. destruct last as [w|], (leads (edge (behind b))).
  - apply bound in H as (v' & _ & H). apply same in H. injection H as <- _. cbn [items at_heads with_items].
    rewrite own_map; [exact O|]. now intros [].
  - apply same in H. injection H as <- _. now apply INS.
  - apply bound in H as (v' & _ & H). apply same in H. injection H as <- _. now apply INS.
  - apply same in H. now injection H as <- _.
Qed.

Example edge_keeps_own_move_instance last rest b' v :
  led plain_setup last moving_block rest = Got (b', v) -> own_moves (items b') = 1%nat.
Proof. intro H. now apply edge_keeps_own_move in H. Qed.

(** * Tool center point control *)

Lemma samples_are_none {num} {N : Numbers num} (s : setup num) c m run g from to l l' all :
  samples s c m run g from to l l' = Got all -> own_moves all = 0%nat.
Proof.
  unfold samples; intro H. apply each_got in H. apply own_none.
  induction H as [|k i ks all E _ IH]; constructor; [|exact IH].
  unfold sample in E. apply bound in E as ([p v] & _ & E). now apply same in E as <-.
Qed.

Lemma own_move_under_control {num} {N : Numbers num} (s : setup num) b m run old from g all :
  own_under_control s b m run old from g = Got all -> own_moves all = own_moves [Go g].
Proof.
  unfold own_under_control; intro H. apply bound in H as (inside & I & H). apply samples_are_none in I.
  apply same in H as <-.
  rewrite !own_app, I.
  match goal with |- context [Go ?x :: ?rest] => change (Go x :: rest) with ([Go x] ++ rest) end. rewrite own_app.
  destruct (turns_before run), (off_the_branch run), (turns_behind run); unfold own_moves; cbn;
    now destruct (inserted (because g)).
Qed.

Lemma items_keep_own {num} {N : Numbers num} (s : setup num) b m old run start finish all :
  forall from own_done done last,
  items_under_control s b m old run start finish from own_done all = Got (done, last) -> own_moves done = own_moves all.
Proof.
  induction all as [|i all IH]; intros from own_done done last H; cbn [items_under_control] in H.
  - apply same in H. now injection H as <- _.
  - destruct i as [g|part a q x|name|name value|h];
      try (apply bound in H as ([later end_] & L & H); apply same in H; injection H as <- _; apply IH in L;
        unfold own_moves in *; cbn; exact L).
    apply bound in H as ([first own'] & F & H). apply bound in H as ([later end_] & L & H). apply same in H.
    injection H as <- _.
    apply IH in L. rewrite own_app, L. change (Go g :: all) with ([Go g] ++ all). rewrite own_app. f_equal.
    destruct (because g) eqn:B, own_done, run as [run|];
      first [apply same in F; injection F as <- _; unfold own_moves; cbn; now rewrite B
            |apply bound in F as (own & W & F); apply same in F; injection F as <- _;
              now apply own_move_under_control in W].
Qed.

(** fanuc.tool-center-point.compensated-tip: and tool center point control: what it inserts are turns at a standing tip.
    *)
Theorem control_keeps_own_moves {num} {N : Numbers num} (s : setup num) b from done last :
  block_under_control s b from = Got (done, last) -> own_moves done = own_moves (items b).
Proof.
  unfold block_under_control; intro H. destruct (in_control (control (behind b))) as [m|].
  - now apply items_keep_own in H.
  - apply same in H. now injection H as <- _.
Qed.

Example control_keeps_own_moves_instance from done last :
  block_under_control plain_setup moving_block from = Got (done, last) -> own_moves done = 1%nat.
Proof. intro H. now apply control_keeps_own_moves in H. Qed.
