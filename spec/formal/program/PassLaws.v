(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the compensations: where a mode is never on its pass changes nothing, and a program without compensation
    runs as it is planned. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners LengthOffset ToolShift.
From Toolcomp Require Import CutterState EdgeState SideState ControlState State Space.
From Toolcomp Require Import Movements CutterRules CutterMoves CutterB CutterModes CutterC CutterWords SideWords
  SideBlocks SidePass.
From Toolcomp Require Import EdgeWords EdgePass ControlWords ControlMoves Compensation Program OutcomeLaws PlanLaws
  ProgramLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Lemmas *)

Lemma same_items {num} (b : planned num) : with_items b (items b) = b.
Proof. now destruct b. Qed.

Lemma same_plan {num} (p : plan num) : (fst p, snd p) = p.
Proof. now destruct p. Qed.

Lemma zeros_of_axis {num} {N : Numbers num} (s : setup num) letter : with_value s (zeros s) letter 0%num = zeros s.
Proof.
  unfold with_value, on_named, the_axis, zeros. induction (axes s) as [|a others IH]; [reflexivity|].
  cbn. cbn in IH. rewrite IH. now destruct (Letter.eqb letter a).
Qed.
Lemma zeros_of_plane {num} {N : Numbers num} (s : setup num) p : with_plane s p (zeros s) zero2 = zeros s.
Proof. unfold with_plane. destruct (plane_axes p) as [first second]. cbn. now rewrite !zeros_of_axis. Qed.
Lemma zeros_of_space {num} {N : Numbers num} (s : setup num) : with_space s (zeros s) (0%num, 0%num, 0%num) = zeros s.
Proof. unfold with_space. now rewrite !zeros_of_axis. Qed.

Definition bare_item {num} {N : Numbers num} (s : setup num) (i : item num) : Prop :=
  match i with Go m => without_head s m | _ => True end.

Lemma at_no_vector {num} {N : Numbers num} (s : setup num) p m : without_head s m -> at_vector s p zero2 m = m.
Proof. unfold without_head, at_vector, with_head. intro E. rewrite zeros_of_plane, <- E. now destruct m. Qed.

Lemma at_no_head {num} {N : Numbers num} (s : setup num) p all : Forall (bare_item s) all ->
  at_head s p zero2 all = all.
Proof.
  induction 1 as [|i all B _ IH]; [reflexivity|]. cbn -[at_vector]. fold (at_head s p zero2 all). rewrite IH.
  destruct i; cbn in B; try reflexivity.
  now rewrite at_no_vector.
Qed.

(** * The passes *)

(** fanuc.cutter-b.mode: where G41 and G42 of type B are never in force nothing is compensated. *)
Theorem cutter_b_off_changes_nothing {num} {N : Numbers num} (s : setup num) (p : plan num) :
  Forall (fun b => hand_in_force (cutter (before b)) = None /\ hand_in_force (cutter (behind b)) = None) (fst p) ->
  pass_b s p = Through p.
Proof.
  intro F. unfold pass_b. rewrite <- (same_plan p) at 2.
  assert (E : compensated_b s (fst p) = inl (fst p)); [|now rewrite E].
  induction F as [|b rest [O O'] _ IH]; [reflexivity|].
  cbn [compensated_b]. unfold items_b. rewrite O, O', IH. cbn. now rewrite same_items.
Qed.

(** A block of cutter compensation C with the mode off. *)
Definition without_c {num} {N : Numbers num} (s : setup num) (b : planned num) : Prop :=
  in_phase (cutter (before b)) = Off /\ in_phase (cutter (behind b)) = Off /\
    vector_behind (cutter (behind b)) = zero2 /\
  match part_of b with Idle _ | MovesFree | GoesAway => True | _ => False end /\ Forall (bare_item s) (items b).

Lemma block_without_c {num} {N : Numbers num} (s : setup num) b rest :
  without_c s b -> block_c s [zero2] b rest = Got (items b, [zero2]).
Proof.
  intros (O & O' & V & P & B). unfold block_c. destruct (part_of b); try contradiction.
  - cbn [hd]. now rewrite at_no_head.
  - reflexivity.
  - unfold going_away. rewrite O, O', V. cbn [hd]. rewrite andb_false_r. cbn [negb andb].
    destruct (items b) as [|[m| | | |] others]; try reflexivity.
    inversion B; subst. now rewrite at_no_vector, at_no_head.
Qed.

(** fanuc.cutter-c.mode: where the mode of type C is never on nothing is compensated. *)
Theorem cutter_c_off_changes_nothing {num} {N : Numbers num} (s : setup num) (p : plan num) :
  Forall (without_c s) (fst p) -> pass_c s p = Through p.
Proof.
  intro F. unfold pass_c. rewrite <- (same_plan p) at 2.
  assert (E : blocks_c s [zero2] (fst p) = (fst p, None)); [|now rewrite E].
  induction F as [|b rest O _ IH]; [reflexivity|].
  cbn [blocks_c]. rewrite block_without_c, IH by exact O. now rewrite same_items.
Qed.

(** fanuc.tool-side.initial-state: where no vector is made nothing is compensated. *)
Theorem side_off_changes_nothing {num} {N : Numbers num} (s : setup num) (p : plan num) :
  Forall (fun b => made (side (behind b)) = false) (fst p) -> side_pass s p = Through p.
Proof.
  intro F. unfold side_pass. destruct (existsb _ (fst p)) eqn:E; [|reflexivity].
  apply existsb_exists in E as (b & I & M). rewrite Forall_forall in F. unfold side_at_end in M.
  rewrite F in M by exact I.
  discriminate.
Qed.

(** fanuc.leading-edge.start: where G41.3 is never in force nothing is compensated. *)
Theorem edge_off_changes_nothing {num} {N : Numbers num} (s : setup num) (p : plan num) :
  Forall (fun b => leads (edge (behind b)) = false) (fst p) -> edge_pass s p = Through p.
Proof.
  intro F. unfold edge_pass. rewrite <- (same_plan p) at 3. generalize (snd p) as how.
  induction F as [|b rest O _ IH]; intro how; [reflexivity|].
  cbn [led_from]. unfold led. now rewrite O, IH.
Qed.

(** fanuc.tool-center-point.commands: where G43.4 and G43.5 are never in force the axes stay over the tip. *)
Theorem control_off_changes_nothing {num} {N : Numbers num} (s : setup num) (p : plan num) :
  Forall (fun b => in_control (control (behind b)) = None) (fst p) -> control_pass s p = Through p.
Proof.
  intro F. unfold control_pass. destruct p as [bs how]; cbn [fst] in F.
  assert (E : forall from, blocks_under_control s bs from = (bs, Ended)); [|now rewrite E].
  induction F as [|b rest O _ IH]; intro from; [reflexivity|].
  cbn [blocks_under_control]. unfold block_under_control. rewrite O, IH. now destruct b.
Qed.

(** * A program without compensation *)

Definition compensation_codes := [410; 412; 413; 416; 420; 422; 426; 434; 435].
(** A block that does not exist raises an alarm. *)
Definition asks_for_none {num} (b : block num) : Prop :=
  match codes_of b with Some codes => existsb (fun code => among code compensation_codes) codes = false |
    None => True end.

(** Nothing has been asked for. *)
Record nothing_on {num} {N : Numbers num} (st : state num) : Prop := NothingOn {
  no_hand : hand_in_force (cutter st) = None;
  no_phase : in_phase (cutter st) = Off;
  no_vector : vector_behind (cutter st) = zero2;
  no_side : side_in_force (side st) = None;
  no_side_vector : made (side st) = false;
  no_edge : leads (edge st) = false;
  no_control : in_control (control st) = None
}.

Lemma last_code (group codes : list Z) code : last_of group codes = Some code -> In code codes /\
  among code group = true.
Proof. unfold last_of; intro H. apply find_some in H as [I A]. split; [now apply in_rev|exact A]. Qed.

Lemma among_in code codes : among code codes = true -> In code codes.
Proof. unfold among; intro H. apply existsb_exists in H as (x & I & E). apply Z.eqb_eq in E. now subst. Qed.

Lemma none_said (group codes : list Z) code : existsb (fun code => among code compensation_codes) codes = false ->
  last_of group codes = Some code -> among code compensation_codes = false.
Proof.
  intros A L. apply last_code in L as [I _]. rewrite <- not_true_iff_false in *. intro M. apply A. apply existsb_exists.
  eauto.
Qed.

Lemma said_is_cancel codes code : existsb (fun code => among code compensation_codes) codes = false ->
  last_of compensations codes = Some code -> code = 400.
Proof.
  intros A L. pose proof (none_said _ _ _ A L) as M. apply last_code in L as [_ I]. apply among_in in I.
  cbn in I. repeat (destruct I as [<-|I]; [first [reflexivity|discriminate M]|]). contradiction.
Qed.

Lemma no_control_said codes {num} (st : state num) :
  existsb (fun code => among code compensation_codes) codes = false ->
  in_control (control st) = None -> type_with codes st = None.
Proof.
  intros A O. unfold type_with, control_code, type_before. rewrite O.
  destruct (last_of lengths codes) as [code|] eqn:L; [|reflexivity].
  pose proof (none_said _ _ _ A L) as M. apply last_code in L as [_ I]. apply among_in in I.
  cbn in I. repeat (destruct I as [<-|I]; [first [reflexivity|discriminate M]|]). contradiction.
Qed.

(** All that a compensation asks of a block to leave it alone. *)
Definition left_alone {num} {N : Numbers num} (s : setup num) (b : planned num) : Prop :=
  (hand_in_force (cutter (before b)) = None /\ hand_in_force (cutter (behind b)) = None) /\
  (cutter_b s = false -> without_c s b) /\ made (side (behind b)) = false /\ leads (edge (behind b)) = false /\
  in_control (control (behind b)) = None.

Lemma others_are_bare {num} {N : Numbers num} (s : setup num) all :
  forallb is_no_move all = true -> Forall (bare_item s) all.
Proof.
  intro W. rewrite forallb_forall in W. apply Forall_forall. intros i I. apply W in I. now destruct i.
Qed.

Lemma stays_off_b {num} {N : Numbers num} (s : setup num) c before after moves x :
  behind_b s c before after moves = Got x -> hand_behind c (hand_in_force (cutter before)) = None ->
  hand_in_force x = None /\ in_phase x = Off /\ vector_behind x = zero2.
Proof. unfold behind_b; intros H E. rewrite E in H. cbn in H. now apply same in H as <-. Qed.

Lemma stays_off_c {num} {N : Numbers num} (s : setup num) c before after moves x :
  behind_c s c before after moves = Got x -> hand_behind c (hand_in_force (cutter before)) = None ->
  in_phase (cutter before) = Off -> vector_behind (cutter before) = zero2 -> is_corner_arc c = false ->
  hand_in_force x = None /\ in_phase x = Off /\ vector_behind x = zero2 /\
  match plays x with Idle _ | MovesFree | GoesAway => True | _ => False end.
Proof.
  unfold behind_c; intros H E O V G. rewrite E, G in H. cbn [asked_for given andb] in H.
  apply bound in H as (moving & _ & H). apply bound in H as ([[[[what ph] v] r] left] & R & H). apply same in H as <-.
  cbn.
  destruct (goes_away c); [|destruct moving].
  - unfold goes_away_step in R. rewrite O in R. apply same in R. injection R as <- <- <- _ _. auto.
  - unfold moving_step in R. rewrite O in R. apply same in R. injection R as <- <- <- _ _. auto.
  - unfold idle_step in R. rewrite O in R. cbn [mode_is_on orb andb] in R. apply same in R.
    injection R as <- <- <- _ _. auto.
Qed.

Lemma nothing_on_stays {num} {N : Numbers num} (s : setup num) place b st p after moves others :
  asks_for_none b -> nothing_on st -> stepped s place b st p after moves others ->
  nothing_on (behind p) /\ left_alone s p.
Proof.
  intros A [H P V S M E C] T. destruct T.
  unfold asks_for_none in A. rewrite its_codes in A. set (c := command_of p) in *.
  assert (HAND : hand_behind c (hand_in_force (cutter (before p))) = None).
  { unfold hand_behind. destruct (last_of compensations (codes_said c)) as [code|] eqn:L; [|now rewrite cutter_kept].
    now rewrite (said_is_cancel _ _ A L). }
  assert (SIDE : side_behind_words c (side_in_force (side (before p))) = None).
  { unfold side_behind_words, compensation_said.
    destruct (last_of compensations (codes_said c)) as [code|] eqn:L; [|now rewrite side_kept].
    now rewrite (said_is_cancel _ _ A L). }
  assert (CUTTER : hand_in_force (cutter (behind p)) = None /\ in_phase (cutter (behind p)) = Off /\
    vector_behind (cutter (behind p)) = zero2 /\
    (cutter_b s = false -> match part_of p with Idle _ | MovesFree | GoesAway => True | _ => False end)).
  { unfold cutter_behind in cutter_found. destruct (cutter_b s) eqn:B.
    - apply stays_off_b in cutter_found as (? & ? & ?); auto. repeat split; auto; discriminate.
    - assert (G : is_corner_arc c = false).
      { destruct (is_corner_arc c) eqn:G; [|reflexivity]. exfalso.
        unfold cutter_alarms in cutter_allowed. rewrite B in cutter_allowed.
        apply bound in cutter_allowed as (? & _ & X). apply bound in X as (? & X & _).
        unfold alarms_c in X. rewrite G in X. apply bound in X as (? & X & _). unfold corner_alarm_c in X.
        apply bound in X as (? & X & _). apply no_alarm in X.
        unfold cutter_on_after in X. rewrite cutter_of_left in X. rewrite cutter_kept in HAND. rewrite HAND in X.
        discriminate. }
      apply stays_off_c in cutter_found as (? & ? & ? & ?); try (now rewrite cutter_kept); auto. }
  destruct CUTTER as (H' & P' & V' & PART).
  assert (SIDE' : side_in_force (side (behind p)) = None /\ made (side (behind p)) = false).
  { unfold side_behind in side_found. unfold asked_behind in side_found. rewrite SIDE in side_found.
    rewrite side_kept, M in side_found. cbn [given andb orb negb] in side_found.
    apply same in side_found. rewrite <- side_found. now split. }
  destruct SIDE' as (S' & M').
  assert (E' : leads (edge (behind p)) = false).
  { rewrite edge_found. cbn. unfold leads_behind. destruct (last_of compensations (codes_said c)) as [code|] eqn:L.
    - now rewrite (said_is_cancel _ _ A L).
    - now rewrite E. }
  assert (C' : in_control (control (behind p)) = None).
  { rewrite control_found. apply control_none. apply no_control_said; [exact A|now rewrite control_kept]. }
  split; [now constructor|]. split; [now rewrite cutter_kept|]. split; [|auto].
  intro B. split; [now rewrite cutter_kept|]. split; [exact P'|]. split; [exact V'|]. split; [now apply PART|].
  rewrite its_items. apply Forall_app; split; [|now apply others_are_bare].
  now apply Forall_map.
Qed.

Lemma planned_left_alone {num} {N : Numbers num} decimal (s : setup num) bs :
  Forall asks_for_none bs -> Forall (left_alone s) (fst (planned_from decimal s bs 0 (initial s))).
Proof.
  intro A. apply (planned_all decimal s nothing_on asks_for_none (left_alone s) (nothing_on_stays s)); [exact A|].
  now constructor.
Qed.

Lemma runs_as_planned {num} {N : Numbers num} (s : setup num) (p : plan num) :
  Forall (left_alone s) (fst p) -> compensated s p = p.
Proof.
  intro F. assert (E : through (passes s) p = Through p).
  { unfold passes. cbn [through].
    assert (T : cutter_pass s p = Through p).
    { unfold cutter_pass. destruct (cutter_b s) eqn:B.
      - apply cutter_b_off_changes_nothing. eapply Forall_impl; [|exact F]. now intros b (? & _).
      - apply cutter_c_off_changes_nothing. eapply Forall_impl; [|exact F]. intros b (_ & O & _). auto. }
    rewrite T. rewrite side_off_changes_nothing by (eapply Forall_impl; [|exact F]; now intros b (_ & _ & ? & _)).
    rewrite edge_off_changes_nothing by (eapply Forall_impl; [|exact F]; now intros b (_ & _ & _ & ? & _)).
    rewrite control_off_changes_nothing; [reflexivity|]. eapply Forall_impl; [|exact F];
      now intros b (_ & _ & _ & _ & ?). }
  unfold compensated. destruct (List.length (fst p)); cbn [until_it_runs]; now rewrite E.
Qed.

(** fanuc.program.initial-state: a program without a code of a compensation runs as it is planned: its events are the
    programmed ones. *)
Theorem without_codes_as_planned {num} {N : Numbers num} decimal (s : setup num) bs :
  Forall asks_for_none bs ->
  let planned := planned_from decimal s bs 0 (initial s) in
  run_program decimal s bs = (events_of planned, snd planned).
Proof.
  intro A. cbv zeta. unfold run_program. rewrite runs_as_planned; [reflexivity|now apply planned_left_alone].
Qed.

Example without_codes_as_planned_instance :
  run_program (fun _ => "") plain_setup [up; last_block] =
  let planned := planned_from (fun _ => "") plain_setup [up; last_block] 0 (initial plain_setup) in
  (events_of planned, snd planned).
Proof. apply without_codes_as_planned. repeat constructor. Qed.

Definition bare_plan : plan R := planned_from (fun _ => "") plain_setup [up; last_block] 0 (initial plain_setup).
Lemma bare_blocks : Forall (left_alone plain_setup) (fst bare_plan).
Proof. apply planned_left_alone. repeat constructor. Qed.

Example cutter_b_off_changes_nothing_instance : pass_b plain_setup bare_plan = Through bare_plan.
Proof. apply cutter_b_off_changes_nothing. eapply Forall_impl; [|exact bare_blocks]. now intros b (? & _). Qed.
Example cutter_c_off_changes_nothing_instance : pass_c plain_setup bare_plan = Through bare_plan.
Proof. apply cutter_c_off_changes_nothing. eapply Forall_impl; [|exact bare_blocks]. intros b (_ & ? & _). auto. Qed.
Example side_off_changes_nothing_instance : side_pass plain_setup bare_plan = Through bare_plan.
Proof. apply side_off_changes_nothing. eapply Forall_impl; [|exact bare_blocks]. now intros b (_ & _ & ? & _). Qed.
Example edge_off_changes_nothing_instance : edge_pass plain_setup bare_plan = Through bare_plan.
Proof. apply edge_off_changes_nothing. eapply Forall_impl; [|exact bare_blocks]. now intros b (_ & _ & _ & ? & _). Qed.
Example control_off_changes_nothing_instance : control_pass plain_setup bare_plan = Through bare_plan.
Proof. apply control_off_changes_nothing. eapply Forall_impl; [|exact bare_blocks]. now intros b (_ & _ & _ & _ & ?).
Qed.
