(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of whole runs: the order of their events, and where they end. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Lia Sorted.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners LengthOffset ToolShift.
From Toolcomp Require Import CutterState EdgeState SideState ControlState State Space.
From Toolcomp Require Import Movements CutterRules CutterMoves CutterB CutterModes CutterC CutterWords SideWords
  SideBlocks SideGroups SidePass.
From Toolcomp Require Import EdgeWords EdgePass ControlWords ControlMoves Compensation Program OutcomeLaws PlanLaws
  ProgramLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * Places *)

Notation places := (map at_place).

(** The place that an ending names. *)
Definition place_of_end (how : ending) : option nat :=
  match how with EndsInAlarm place _ | EndsUndecided place _ => Some place | Ended => None end.

(** Blocks in the order of their places, and an ending behind them all. *)
Definition in_order {num} (p : plan num) : Prop :=
  StronglySorted lt (places (fst p)) /\
  match place_of_end (snd p) with Some last => Forall (fun place => (place <= last)%nat) (places (fst p)) |
    None => True end.

(** A pass gives blocks with the places of the first ones of the plan, and ends where the plan does, or at a block of it
    that it leaves out. *)
Definition keeps_order {num} (p : plan num) (x : passed num) : Prop :=
  match x with
  | Through (bs, how) => exists later, places (fst p) = places bs ++ later /\
      match place_of_end how with
      | Some place => (how = snd p /\ later = []) \/ In place later
      | None => True
      end
  | AsIfAbsent place how => place_of_end how = Some place \/ place_of_end how = None
  end.

Lemma sorted_prefix (a b : list nat) : StronglySorted lt (a ++ b) -> StronglySorted lt a.
Proof.
  induction a as [|x a IH]; intro S; [constructor|]. cbn in S. inversion S as [|? ? S' F]; subst.
  constructor; [now apply IH|]. apply Forall_app in F as [F _]; exact F.
Qed.
Lemma sorted_behind (a b : list nat) y : StronglySorted lt (a ++ b) -> In y b -> Forall (fun x => (x <= y)%nat) a.
Proof.
  induction a as [|x a IH]; intros S I; [constructor|]. cbn in S. inversion S as [|? ? S' F]; subst.
  constructor; [|now apply IH]. rewrite Forall_forall in F. specialize (F y (in_or_app _ _ _ (or_intror I))). lia.
Qed.

Lemma order_kept {num} (p : plan num) bs how : in_order p -> keeps_order p (Through (bs, how)) -> in_order (bs, how).
Proof.
  intros [S E] (later & P & W). unfold in_order; cbn [fst snd]. rewrite P in S. split; [now apply sorted_prefix in S|].
  destruct (place_of_end how) as [place|] eqn:H; [|exact I].
  destruct W as [[-> ->]|W]; [|now apply (sorted_behind _ later)].
  rewrite H in E. rewrite P, app_nil_r in E. exact E.
Qed.

Lemma end_in_place {A} place (x : outcome A) :
  place_of_end (ends_in place x) = Some place \/ place_of_end (ends_in place x) = None.
Proof. destruct x; cbn; auto. Qed.

(** * Each pass *)

Lemma b_keeps_order {num} {N : Numbers num} (s : setup num) p : keeps_order p (pass_b s p).
Proof.
  unfold pass_b. destruct p as [bs how]; cbn [fst snd].
  assert (K : match compensated_b s bs with
              | inl done => places bs = places done
              | inr (place, how) => place_of_end how = Some place \/ place_of_end how = None
              end).
  { induction bs as [|b rest IH]; [reflexivity|]. cbn [compensated_b].
    destruct (items_b s b) as [new|number|clause]; cbn [ends_in place_of_end]; auto.
    destruct (compensated_b s rest) as [later|[place how']]; [|exact IH]. cbn. now rewrite IH. }
  destruct (compensated_b s bs) as [done|[place how']]; [|exact K].
  exists []. rewrite app_nil_r. split; [exact K|]. destruct (place_of_end how); auto.
Qed.

Lemma c_keeps_order {num} {N : Numbers num} (s : setup num) p : keeps_order p (pass_c s p).
Proof.
  unfold pass_c. destruct p as [bs how]; cbn [fst snd]. generalize ([zero2] : list (pair num)) as vs. intro vs.
  assert (K : exists later, places bs = places (fst (blocks_c s vs bs)) ++ later /\
              match snd (blocks_c s vs bs) with
              | None => later = []
              | Some (place, how) => In place later /\ (place_of_end how = Some place \/ place_of_end how = None)
              end).
  { revert vs; induction bs as [|b rest IH]; intro vs; [now exists []|]. cbn [blocks_c].
    destruct (block_c s vs b rest) as [[new ws]|number|clause];
      [|exists (places (b :: rest)); cbn; auto..].
    destruct (IH ws) as (later & P & W). destruct (blocks_c s ws rest) as [done ended]. exists later. cbn in *.
    rewrite P. auto. }
  destruct K as (later & P & W). destruct (blocks_c s vs bs) as [done [[place how']|]]; cbn [fst snd] in *.
  - destruct W as [I W]. destruct how' as [|place' number|place' clause]; cbn [place_of_end] in W; try exact W;
      exists later; cbn; auto. split; [exact P|]. right. destruct W as [W|W]; congruence.
  - subst later. exists []. split; [exact P|]. destruct (place_of_end how); auto.
Qed.

Lemma edge_keeps_order {num} {N : Numbers num} (s : setup num) p : keeps_order p (edge_pass s p).
Proof.
  unfold edge_pass. destruct p as [bs how]; cbn [fst snd]. generalize (None : option (EdgeVector.leading num)) as last.
  intro last.
  assert (K : match led_from s last bs how with
              | Through (done, how') => places bs = places done /\ how' = how
              | AsIfAbsent place how => place_of_end how = Some place \/ place_of_end how = None
              end).
  { revert last; induction bs as [|b rest IH]; intro last; [now split|]. cbn [led_from].
    destruct (led s last b rest) as [[b' v]|number|clause] eqn:L; cbn; auto.
    specialize (IH v). destruct (led_from s v rest how) as [[done how']|]; [|exact IH].
    destruct IH as [P ->]. split; [|reflexivity]. cbn. rewrite P. f_equal.
    unfold led in L. destruct last as [w|], (leads (edge (behind b)));
      repeat (apply bound in L as (? & _ & L)); apply same in L; now injection L as <- _. }
  destruct (led_from s last bs how) as [[done how']|]; [|exact K]. destruct K as [P ->].
  exists []. rewrite app_nil_r. split; [exact P|]. destruct (place_of_end how); auto.
Qed.

Lemma control_keeps_order {num} {N : Numbers num} (s : setup num) p : keeps_order p (control_pass s p).
Proof.
  unfold control_pass. destruct p as [bs how]; cbn [fst snd]. generalize (start s) as from. intro from.
  assert (K : exists later, places bs = places (fst (blocks_under_control s bs from)) ++ later /\
              match snd (blocks_under_control s bs from) with Ended => later = [] | _ => True end).
  { revert from; induction bs as [|b rest IH]; intro from; [now exists []|]. cbn [blocks_under_control].
    destruct (block_under_control s b from) as [[done last]|number|clause];
      [|exists (places (b :: rest)); cbn; auto..].
    destruct (IH last) as (later & P & W). destruct (blocks_under_control s rest last) as [more how'].
    exists later. cbn in *. rewrite P. auto. }
  destruct K as (later & P & W). destruct (blocks_under_control s bs from) as [done [|place number|place clause]];
    cbn in *; auto.
  - subst later. exists []. split; [exact P|]. destruct (place_of_end how); auto.
Qed.

Definition block_of_offset {num} (o : offset_block num) : planned num := fst (fst o).

Lemma moves_of_block_keeps_place {num} {N : Numbers num} (s : setup num) t o b t' :
  SidePass.moves_of_block s t o = Got (b, t') -> at_place b = at_place (block_of_offset o).
Proof.
  unfold SidePass.moves_of_block, block_of_offset. destruct o as [[b0 at_end] line_now]. cbn [fst]. intro H.
  repeat match type of H with
  | (if ?x then _ else _) = _ => destruct x
  | match ?x with Some _ => _ | None => _ end = _ => destruct x
  | bind _ _ = _ => apply bound in H as (? & _ & H)
  | Got _ = Got _ => apply same in H
  | (_, _) = (_, _) => injection H as <- _
  end; reflexivity.
Qed.

Lemma moves_from_keeps_order {num} {N : Numbers num} (s : setup num) t os how :
  match moves_from s t os how with
  | Through (done, how') => places done = places (map block_of_offset os) /\ how' = how
  | AsIfAbsent place how => place_of_end how = Some place \/ place_of_end how = None
  end.
Proof.
  revert t; induction os as [|o os IH]; intro t; [now split|]. cbn [moves_from].
  destruct (SidePass.moves_of_block s t o) as [[b t']|number|clause] eqn:M; cbn [ends_in place_of_end]; auto.
  specialize (IH t'). destruct (moves_from s t' os how) as [[done how']|]; [|exact IH]. destruct IH as [P ->].
  split; [|reflexivity]. apply moves_of_block_keeps_place in M. cbn. now rewrite M, P.
Qed.

Lemma offset_from_keeps_order {num} {N : Numbers num} (s : setup num) at_start bs :
  let o := offset_from s at_start bs in
  exists later, places bs = places (map block_of_offset (compensated_blocks o)) ++ later /\
    match refused o with
    | None => later = []
    | Some (place, how) => In place later /\ (place_of_end how = Some place \/ place_of_end how = None)
    end.
Proof.
  cbv zeta. revert at_start; induction bs as [|b rest IH]; intro at_start; [now exists []|].
  assert (GO : forall at_start' o line_now next, exists later, places (b :: rest) =
      places (map block_of_offset (compensated_blocks (OffsetBlocks at_start'
        ((b, o, line_now) :: compensated_blocks (offset_from s next rest)) (refused (offset_from s next rest))))) ++
          later /\
      match refused (offset_from s next rest) with
      | None => later = []
      | Some (place, how) => In place later /\ (place_of_end how = Some place \/ place_of_end how = None)
      end).
  { intros at_start' o line_now next. destruct (IH next) as (later & P & W). exists later. split; [|exact W].
    cbn. now rewrite P. }
  assert (STOP : forall A (x : outcome A), exists later, places (b :: rest) = [] ++ later /\
      (In (at_place b) later /\ (place_of_end (ends_in (at_place b) x) = Some (at_place b) \/
                                 place_of_end (ends_in (at_place b) x) = None))).
  { intros A x. exists (places (b :: rest)). split; [reflexivity|]. split; [now left|apply end_in_place]. }
  cbn [offset_from].
  destruct (starts_at_once s b).
  { destruct (standing_at_start s b rest) as [v|number|clause]; [apply GO|apply (STOP unit (Alarm number))|
      apply (STOP unit (Undecided clause))]. }
  destruct (makes_corner b).
  { match goal with |- context [match ?x with Got _ => _ | _ => _ end] =>
      destruct x as [[[v w] line_now]|number|clause] end;
      [apply GO|apply (STOP unit (Alarm number))|apply (STOP unit (Undecided clause))].
      }
  destruct (made (side_at_end b)), at_start as [v|]; try apply GO. destruct (is_b_of b v); apply GO.
Qed.

Lemma side_keeps_order {num} {N : Numbers num} (s : setup num) p : keeps_order p (side_pass s p).
Proof.
  unfold side_pass. destruct (negb _).
  { destruct p as [bs how]. exists []. rewrite app_nil_r. split; [reflexivity|]. cbn. destruct (place_of_end how); auto.
    }
  destruct (commands_refused s [] (fst p)) as [[place how]|] eqn:C.
  { cbn. assert (G : forall w bs, commands_refused s w bs = Some (place, how) ->
      place_of_end how = Some place \/ place_of_end how = None); [|exact (G _ _ C)].
    intros w bs; revert w; induction bs as [|b rest IH]; intros w H; [discriminate|]. cbn [commands_refused] in H.
    match type of H with match ?x with Got _ => _ | _ => _ end = _ => destruct x as [here|number|clause] end;
      [|injection H as <- <-; cbn; auto..].
    destruct (waiting_behind s b w) as [next|number|clause]; [now apply IH in H|injection H as <- <-; cbn; auto..].
    }
  destruct (offset_from_keeps_order s None (fst p)) as (later & P & W).
  set (o := offset_from s None (fst p)) in *. clearbody o.
  destruct (refused o) as [[place how]|].
  - destruct W as [I W].
    assert (G : forall how', (place_of_end how' = Some place \/ place_of_end how' = None) ->
                keeps_order p (moves_from s at_point (compensated_blocks o) how')).
    { intros how' E. pose proof (moves_from_keeps_order s at_point (compensated_blocks o) how') as M.
      destruct (moves_from s at_point (compensated_blocks o) how') as [[done how'']|]; [|exact M]. destruct M as [M ->].
      exists later. rewrite M. split; [exact P|]. destruct E as [->| ->]; auto. }
    destruct how; try exact W; apply G; exact W.
  - subst later. rewrite app_nil_r in P.
    pose proof (moves_from_keeps_order s at_point (compensated_blocks o) (snd p)) as M.
    destruct (moves_from s at_point (compensated_blocks o) (snd p)) as [[done how'']|]; [|exact M].
    destruct M as [M ->].
    exists []. rewrite app_nil_r, M. split; [exact P|]. destruct (place_of_end (snd p)); auto.
Qed.

(** * The run *)

Lemma passes_keep_order {num} {N : Numbers num} (s : setup num) p : in_order p ->
  match through (passes s) p with
  | Through p' => in_order p'
  | AsIfAbsent place how => place_of_end how = Some place \/ place_of_end how = None
  end.
Proof.
  assert (K : forall pass, In pass (passes s) -> forall p, keeps_order p (pass p)).
  { intros pass [<-|[<-|[<-|[<-|[]]]]] p'; [unfold cutter_pass; destruct (cutter_b s)|..].
    - apply b_keeps_order.
    - apply c_keeps_order.
    - apply side_keeps_order.
    - apply edge_keeps_order.
    - apply control_keeps_order. }
  revert p. induction (passes s) as [|pass rest IH]; intros p O; [exact O|].
  assert (K0 := K pass (or_introl eq_refl) p). cbn [through].
  destruct (pass p) as [[bs how]|place how]; [|exact K0].
  apply IH; [intros q I; apply K; now right|]. now apply (order_kept p).
Qed.

Lemma sorted_filter keep (a : list nat) : StronglySorted lt a -> StronglySorted lt (filter keep a).
Proof.
  induction 1 as [|x a S IH F]; [constructor|]. cbn. destruct (keep x); [|exact IH]. constructor; [exact IH|].
  rewrite Forall_forall in *. intros y I. apply F. now apply filter_In in I.
Qed.

Lemma order_of_compensated {num} {N : Numbers num} (s : setup num) p : in_order p -> in_order (compensated s p).
Proof.
  unfold compensated. generalize (List.length (fst p)) as tries. intro tries; revert p.
  induction tries as [|tries IH]; intros p O; cbn [until_it_runs];
    pose proof (passes_keep_order s p O) as K; destruct (through (passes s) p) as [p'|place how]; try exact K.
  - split; [constructor|]. cbn [fst snd]. destruct (place_of_end how); constructor.
  - apply IH. destruct O as [S _]. split; cbn [fst snd].
    + replace (places (filter (fun b => Nat.ltb (at_place b) place) (fst p)))
        with (filter (fun x => Nat.ltb x place) (places (fst p))); [now apply sorted_filter|].
      clear. induction (fst p) as [|b rest IH]; [reflexivity|].
      cbn [filter map]. destruct (Nat.ltb (at_place b) place); cbn [map]; now rewrite IH.
    + destruct (place_of_end how) as [last|]; [|exact I]. assert (last = place) as -> by (destruct K; congruence).
      apply Forall_forall. intros x E. apply in_map_iff in E as (b & <- & E). apply filter_In in E as [_ E].
      apply Nat.ltb_lt in E. lia.
Qed.

Lemma order_of_plan {num} {N : Numbers num} decimal (s : setup num) bs : forall place st,
  let p := planned_from decimal s bs place st in
  in_order p /\ Forall (fun x => (place <= x)%nat) (places (fst p)) /\
  match place_of_end (snd p) with Some last => (place <= last)%nat | None => True end.
Proof.
  induction bs as [|b bs IH]; intros place st; cbv zeta; cbn [planned_from].
  { repeat constructor. }
  destruct (step decimal s place b st) as [[p alarm]|number|clause] eqn:E;
    try (cbn; repeat split; try constructor; lia).
  apply step_is_stepped in E as (after & moves & others & E). apply its_place in E.
  destruct alarm as [number|].
  { cbn. rewrite E. repeat split; repeat constructor; lia. }
  destruct (ends b).
  { cbn. rewrite E. repeat split; repeat constructor; lia. }
  destruct (IH (S place) (behind p)) as ([ASC W] & F & W'). destruct (planned_from decimal s bs (S place) (behind p)) as
    [later how].
  unfold in_order. cbn [fst snd map] in *. rewrite E. repeat split.
  - constructor; [exact ASC|]. eapply Forall_impl; [|exact F]. intros; cbn in *; lia.
  - destruct (place_of_end how); [|exact I]. constructor; [lia|exact W].
  - constructor; [lia|]. eapply Forall_impl; [|exact F]. intros; cbn in *; lia.
  - destruct (place_of_end how); [lia|exact I].
Qed.

Lemma sorted_events {num} {N : Numbers num} (p : plan num) : in_order p -> StronglySorted le (map fst (events_of p)).
Proof.
  intros [S E]. destruct p as [bs how]. unfold events_of. cbn [fst snd] in *. rewrite map_app.
  assert (L : forall last, match how with
            | EndsInAlarm place number => [(place, Raised number)]
            | EndsUndecided place clause => [(place, NotDecided clause)]
            | Ended => []
            end = (last : list (nat * event num)) -> map fst last =
            match place_of_end how with Some x => [x] | None => [] end).
  { intros last <-. now destruct how. }
  rewrite (L _ eq_refl). clear L.
  induction bs as [|b rest IH].
  { cbn. destruct (place_of_end how); repeat constructor. }
  cbn [map] in S. inversion S as [|? ? S' F]; subst.
  assert (E' : match place_of_end how with Some last => Forall (fun place => (place <= last)%nat) (places rest) |
    None => True end).
  { destruct (place_of_end how); [|exact I]. now inversion E. }
  specialize (IH S' E'). cbn [flat_map]. rewrite map_app, map_map. cbn [fst]. rewrite <- app_assoc.
  assert (B : Forall (fun y => (at_place b <= y)%nat)
    (map fst (flat_map (fun b => map (fun i => (at_place b, event_of i)) (items b)) rest) ++
     match place_of_end how with Some x => [x] | None => [] end)).
  { apply Forall_app; split.
    - apply Forall_forall. intros y I. apply in_map_iff in I as (e & <- & I). apply in_flat_map in I as (b' & I & I').
      apply in_map_iff in I' as (i & <- & _). cbn. rewrite Forall_forall in F.
      specialize (F (at_place b') (in_map _ _ _ I)). lia.
    - destruct (place_of_end how); repeat constructor. now inversion E. }
  generalize (items b) as all. intro all. induction all as [|i all IHi]; [exact IH|]. cbn. constructor; [exact IHi|].
  apply Forall_app; split; [|exact B]. apply Forall_forall. intros y I. apply in_map_iff in I as (? & <- & _). lia.
Qed.

(** fanuc.cutter.order-of-alarms: the events of a run come in the order of its blocks, through every compensation; the
    alarm, or what cannot be decided, is of no earlier block than any of them. *)
Theorem events_in_order {num} {N : Numbers num} decimal (s : setup num) bs :
  StronglySorted le (map fst (fst (run_program decimal s bs))).
Proof. unfold run_program; cbn [fst]. apply sorted_events, order_of_compensated, order_of_plan. Qed.

Example events_in_order_instance :
  StronglySorted le (map fst (fst (run_program (fun _ => "") plain_setup [up; unknown_code; up]))).
Proof. apply events_in_order. Qed.

(** fanuc.program.end: a run with blocks behind M02 or M30 is the run without them, whatever is compensated. *)
Theorem nothing_runs_behind_the_end {num} {N : Numbers num} decimal (s : setup num) ahead b more :
  ends b = true -> run_program decimal s (ahead ++ b :: more) = run_program decimal s (ahead ++ [b]).
Proof.
  intro E. unfold run_program.
  assert (P : forall place st, planned_from decimal s (ahead ++ b ::
    more) place st = planned_from decimal s (ahead ++ [b]) place st);
    [|now rewrite P].
  induction ahead as [|a ahead IH]; intros place st; [now apply nothing_behind_the_end|].
  cbn [app planned_from]. destruct (step decimal s place a st) as [[r [number|]]| |]; try reflexivity.
  destruct (ends a); [reflexivity|]. now rewrite IH.
Qed.

Example nothing_runs_behind_the_end_instance :
  run_program (fun _ => "") plain_setup ([up] ++ last_block ::
    [up]) = run_program (fun _ => "") plain_setup ([up] ++ [last_block]).
Proof. now apply nothing_runs_behind_the_end. Qed.
