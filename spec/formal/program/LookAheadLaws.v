(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the look-ahead: how many blocks behind a block the compensations read. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Lia.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners LengthOffset ToolShift.
From Toolcomp Require Import CutterState EdgeState SideState ControlState State Space.
From Toolcomp Require Import Movements CutterRules CutterMoves CutterB CutterModes CutterC CutterWords SideWords
  SideBlocks SideGroups SideCheck.
From Toolcomp Require Import EdgeWords EdgePass ControlMoves Program OutcomeLaws PlanLaws ProgramLaws PassLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Cutter compensation *)

(** fanuc.cutter-b.no-look-ahead: in type B no block depends on one behind it: where a longer plan runs, it begins as
    the shorter one runs. *)
Theorem cutter_b_looks_at_no_block {num} {N : Numbers num} (s : setup num) bs more all :
  compensated_b s (bs ++ more) = inl all -> exists first later, compensated_b s bs = inl first /\ all = first ++ later.
Proof.
  revert all; induction bs as [|b bs IH]; intros all H; [now exists [], all|].
  cbn [app compensated_b] in *. destruct (items_b s b) as [new| |]; try discriminate.
  destruct (compensated_b s (bs ++ more)) as [later|]; [|discriminate]. injection H as <-.
  destruct (IH _ eq_refl) as (first & rest & -> & ->). now exists (with_items b new :: first), rest.
Qed.

Example cutter_b_looks_at_no_block_instance (b : planned R) all :
  compensated_b plain_setup (fst bare_plan ++ [b]) = inl all ->
  exists first later, compensated_b plain_setup (fst bare_plan) = inl first /\ all = first ++ later.
Proof. apply cutter_b_looks_at_no_block. Qed.

Lemma limit_two {num} (s : setup num) : 2 <= idle_limit s.
Proof. unfold idle_limit, blocks_read. destruct (series_30i s); lia. Qed.

Lemma idle_counts {num} (s : setup num) c : 1 <= idle_count s c.
Proof. unfold idle_count. pose proof (limit_two s). destruct (names_plane s c); lia. Qed.

(** A block that does not move counts at least one. *)
Definition counts {num} (b : planned num) : Prop := match part_of b with Idle n => 1 <= n | _ => True end.

Lemma found_counts {num} {N : Numbers num} (s : setup num) c before after moves x :
  cutter_behind s c before after moves = Got x -> match plays x with Idle n => 1 <= n | _ => True end.
Proof.
  unfold cutter_behind; intro H. destruct (cutter_b s).
  - unfold behind_b in H. apply bound in H as ([v stands] & _ & H). apply same in H as <-. cbn. lia.
  - unfold behind_c in H. apply bound in H as (moving & _ & H).
    apply bound in H as ([[[[what ph] v] r] left] & R & H). apply same in H as <-. cbn.
    destruct (goes_away c); [|destruct (is_corner_arc c); [|destruct moving]].
    + unfold goes_away_step, ends_alone in R.
      repeat match type of R with
      | bind _ _ = _ => apply bound in R as (? & _ & R)
      | Got _ = Got _ => apply same in R
      | (_, _) = (_, _) => injection R as <- _ _ _ _; exact I
      | Undecided _ = _ => discriminate
      | (match ?x with _ => _ end) = _ => destruct x
      end.
    + apply same in R. injection R as <- _ _ _ _. exact I.
    + unfold moving_step in R.
      repeat match type of R with
      | bind _ _ = _ => apply bound in R as (? & _ & R)
      | Got _ = Got _ => apply same in R
      | (_, _) = (_, _) => injection R as <- _ _ _ _; exact I
      | Undecided _ = _ => discriminate
      | (match ?x with _ => _ end) = _ => destruct x
      end.
    + unfold idle_step, ends_alone in R. pose proof (idle_counts s c) as N0.
      repeat match type of R with
      | bind _ _ = _ => apply bound in R as (? & _ & R)
      | Got _ = Got _ => apply same in R
      | (_, _) = (_, _) => injection R as <- _ _ _ _; first [exact I|lia]
      | Undecided _ = _ => discriminate
      | (match ?x with _ => _ end) = _ => destruct x
      end.
Qed.

Lemma planned_counts {num} {N : Numbers num} decimal (s : setup num) bs place st :
  Forall counts (fst (planned_from decimal s bs place st)).
Proof.
  apply (planned_all decimal s (fun _ => True) (fun _ => True)); [|apply Forall_forall; auto|exact I].
  intros ? ? ? p after moves ? _ _ T. split; [exact I|]. apply (found_counts s _ _ _ _ _ (cutter_found _ _ _ _ _ _ _ _
    T)).
Qed.

Lemma look_limited {num} (s : setup num) (bs more : list (planned num)) : Forall counts bs -> forall count repeated,
  0 <= count < idle_limit s -> idle_limit s - count <= Z.of_nat (List.length bs) ->
  look s count repeated (bs ++ more) = look s count repeated bs.
Proof.
  induction 1 as [|b bs C F IH]; intros count repeated P L; [cbn [List.length Z.of_nat] in L; lia|].
  cbn [app look]. revert C; unfold counts. destruct (part_of b); intro C; try reflexivity.
  destruct (stops s b); [reflexivity|].
  destruct (count + count0 <? idle_limit s) eqn:E; [|reflexivity]. apply Z.ltb_lt in E. cbn [List.length] in L.
  rewrite Nat2Z.inj_succ in L.
  apply IH; lia.
Qed.

(** Blocks that are all that is read behind one: they count, and there are as many as end it where none of them moves. *)
Definition all_read {num} (s : setup num) (ahead : list (planned num)) : Prop :=
  Forall counts ahead /\ idle_limit s <= Z.of_nat (List.length ahead).

(** fanuc.cutter-c.one-non-motion-block: in type C a block depends on two blocks behind it, on the 30i on one less than
    No. 19625 says, and no more; every block of a program counts (planned_counts). *)
Theorem cutter_c_reads_so_many_blocks_ahead {num} {N : Numbers num} (s : setup num) vs b ahead more :
  all_read s ahead -> block_c s vs b (ahead ++ more) = block_c s vs b ahead.
Proof.
  intros [C L]. assert (E : look s 0 false (beyond s b (ahead ++ more)) = look s 0 false (beyond s b ahead)).
  { unfold beyond. destruct (stops s b); [reflexivity|]. pose proof (limit_two s). apply look_limited; [exact C|lia|lia]. }
  unfold block_c, mode_block, loses_vector, group_at_end, corner_arc_c, lone_start. now rewrite E.
Qed.

Example cutter_c_reads_so_many_blocks_ahead_instance b more :
  Forall (fun p => block_c plain_setup [zero2] b (p :: p ::
    more) = block_c plain_setup [zero2] b [p; p]) (fst bare_plan).
Proof.
  eapply Forall_impl; [|exact (planned_counts (fun _ => "") plain_setup [up; last_block] 0 (initial plain_setup))].
  intros p C. apply (cutter_c_reads_so_many_blocks_ahead plain_setup [zero2] b [p; p] more).
  split; [now repeat constructor|now cbn].
Qed.

(** fanuc.cutter-c.two-non-motion-blocks: so the blocks of a plan with so many blocks behind them run alike, whatever
    follows these. *)
Theorem cutter_c_so_many_more_blocks {num} {N : Numbers num} (s : setup num) bs ahead more : all_read s ahead ->
  Forall counts bs -> forall vs,
  firstn (List.length bs) (fst (blocks_c s vs (bs ++ ahead ++ more))) =
  firstn (List.length bs) (fst (blocks_c s vs (bs ++ ahead))).
Proof.
  intros [C L]. induction 1 as [|b bs Cb F IH]; intro vs; [reflexivity|].
  assert (E : block_c s vs b (bs ++ ahead ++ more) = block_c s vs b (bs ++ ahead)).
  { rewrite app_assoc. apply cutter_c_reads_so_many_blocks_ahead. split; [now apply Forall_app|].
    rewrite app_length. lia. }
  cbn [app blocks_c]. rewrite E. destruct (block_c s vs b (bs ++ ahead)) as [[new ws]| |]; try reflexivity.
  specialize (IH ws). destruct (blocks_c s ws (bs ++ ahead ++ more)), (blocks_c s ws (bs ++ ahead)).
  cbn in *. now rewrite IH.
Qed.

Example cutter_c_so_many_more_blocks_instance more : let bs := fst bare_plan in
  Forall (fun p => firstn (List.length bs) (fst (blocks_c plain_setup [zero2] (bs ++ [p; p] ++ more))) =
                   firstn (List.length bs) (fst (blocks_c plain_setup [zero2] (bs ++ [p; p])))) bs.
Proof.
  pose proof (planned_counts (fun _ => "") plain_setup [up; last_block] 0 (initial plain_setup)) as F.
  eapply Forall_impl; [|exact F]. intros p C. apply cutter_c_so_many_more_blocks; [|exact F].
  split; [now repeat constructor|now cbn].
Qed.

(** fanuc.cutter-c.look-ahead-stopped: a block depends on nothing beyond one that stops the look-ahead, be that the next
    one or itself. *)
Theorem cutter_c_reads_nothing_beyond_a_stop {num} {N : Numbers num} (s : setup num) vs b next more :
  stops s b = true \/ stops s next = true -> block_c s vs b (next :: more) = block_c s vs b [next].
Proof.
  intro S. assert (E : look s 0 false (beyond s b (next :: more)) = look s 0 false (beyond s b [next])).
  { unfold beyond. destruct S as [S|S].
    - now rewrite S.
    - destruct (stops s b); [reflexivity|]. cbn [look]. rewrite S. now destruct (part_of next). }
  unfold block_c, mode_block, loses_vector, group_at_end, corner_arc_c, lone_start. now rewrite E.
Qed.

Example cutter_c_reads_nothing_beyond_a_stop_instance b next more : stops plain_setup next = true ->
  block_c plain_setup [zero2] b (next :: more) = block_c plain_setup [zero2] b [next].
Proof. intro S. apply cutter_c_reads_nothing_beyond_a_stop. now right. Qed.

(** * The leading edge offset *)

(** The blocks up to the one behind so many that are blocks: N and O alone are none. *)
Fixpoint first_blocks {num} (count : nat) (bs : list (planned num)) : list (planned num) :=
  match bs with
  | [] => []
  | b :: rest =>
      if is_no_block b then b :: first_blocks count rest
      else match count with O => [] | S fewer => b :: first_blocks fewer rest end
  end.

Lemma comes_in_two {num} {N : Numbers num} (s : setup num) rest : forall between,
  what_comes s between (first_blocks (if between then 1 else 2) rest) = what_comes s between rest.
Proof.
  induction rest as [|b rest IH]; intro between; [now destruct between|].
  assert (G : forall count, first_blocks count (b :: rest) = if is_no_block b then b :: first_blocks count rest
    else match count with O => [] | S fewer => b :: first_blocks fewer rest end) by reflexivity.
  rewrite G. destruct (is_no_block b) eqn:O.
  - cbn [what_comes]. rewrite O. apply IH.
  - specialize (IH true). destruct between; cbn [what_comes]; rewrite O; [reflexivity|]. now rewrite IH.
Qed.

(** fanuc.leading-edge.two-blocks-without-movement: a block under the leading edge offset depends on two blocks behind
    it, and no more. *)
Theorem edge_looks_two_blocks_ahead {num} {N : Numbers num} (s : setup num) last b rest :
  led s last b (first_blocks 2 rest) = led s last b rest.
Proof.
  assert (E : find (fun b => negb (is_no_block b)) (first_blocks 2 rest) = find (fun b => negb (is_no_block b)) rest).
  { generalize 1%nat as more. intro more. induction rest as [|a rest IH]; [reflexivity|].
    cbn [first_blocks find]. destruct (is_no_block a) eqn:O; cbn [find]; rewrite O; [exact IH|reflexivity]. }
  unfold led, vector_at_start, vector_at_end. rewrite E. pose proof (comes_in_two s rest false) as C. cbn iota in C.
  now rewrite C.
Qed.

Example edge_looks_two_blocks_ahead_instance last (b : planned R) :
  led plain_setup last b (first_blocks 2 (fst bare_plan)) = led plain_setup last b (fst bare_plan).
Proof. apply edge_looks_two_blocks_ahead. Qed.

(** * Tool side compensation *)

Lemma following_limited {num} {N : Numbers num} (s : setup num) vt (ahead more : list (planned num)) :
  forall count again, 0 <= count < idle_limit s -> idle_limit s - count <= Z.of_nat (List.length ahead) ->
  following_of s vt count again (ahead ++ more) = following_of s vt count again ahead.
Proof.
  induction ahead as [|b bs IH]; intros count again P L; [cbn [List.length Z.of_nat] in L; lia|].
  cbn [app following_of]. destruct (stops_look_ahead s (block_of (command_of b))); [reflexivity|].
  destruct (moves_across s vt b) as [[|]| |]; cbn [bind]; try reflexivity.
  destruct ((idle_limit s <=? count + 1) || negb (asked (side_at_end b))) eqn:E; [reflexivity|].
  apply orb_false_iff in E as [E _]. apply Z.leb_gt in E. cbn [List.length] in L. rewrite Nat2Z.inj_succ in L.
  apply IH; lia.
Qed.

(** fanuc.tool-side.two-blocks-without-movement: so do the vectors at the end of a block under tool side compensation,
    before interference is asked. *)
Theorem side_reads_so_many_blocks_ahead {num} {N : Numbers num} (s : setup num) a ahead more :
  idle_limit s <= Z.of_nat (List.length ahead) -> standing_at_end s a (ahead ++ more) = standing_at_end s a ahead.
Proof.
  intro L. unfold standing_at_end. pose proof (limit_two s). now rewrite following_limited by lia.
Qed.

Example side_reads_so_many_blocks_ahead_instance (a : planned R) more :
  standing_at_end plain_setup a ([a; a] ++ more) = standing_at_end plain_setup a [a; a].
Proof. apply side_reads_so_many_blocks_ahead. now cbn. Qed.

(** * Tool center point control *)

(** fanuc.tool-center-point.compensated-tip: under tool center point control no block depends on one behind it. *)
Theorem control_looks_at_no_block {num} {N : Numbers num} (s : setup num) bs more : forall from first,
  blocks_under_control s bs from = (first, Ended) ->
  exists later how, blocks_under_control s (bs ++ more) from = (first ++ later, how).
Proof.
  induction bs as [|b bs IH]; intros from first H.
  - injection H as <-. cbn. destruct (blocks_under_control s more from). eauto.
  - cbn [app blocks_under_control] in *. destruct (block_under_control s b from) as [[done last]| |];
      try discriminate.
    destruct (blocks_under_control s bs last) as [before how] eqn:E. injection H as <- ->.
    destruct (IH _ _ E) as (later & how & ->). now exists later, how.
Qed.

Example control_looks_at_no_block_instance from (b : planned R) : exists later how,
  blocks_under_control plain_setup (fst bare_plan ++ [b]) from = (fst bare_plan ++ later, how).
Proof.
  apply control_looks_at_no_block. pose proof bare_blocks as F. revert from.
  induction F as [|p rest (_ & _ & _ & _ & O) _ IH]; intro from; [reflexivity|].
  cbn [blocks_under_control]. unfold block_under_control. rewrite O, IH. now destruct p.
Qed.
