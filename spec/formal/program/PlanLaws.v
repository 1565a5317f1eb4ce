(* SPDX-License-Identifier: Apache-2.0 *)
(** What a block that runs is in the plan: the parts of a step. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ToolShift Measurement.
From Toolcomp Require Import CutterState EdgeState SideState ControlState CycleState State Pose.
From Toolcomp Require Import Movements OwnMove CutterRules CutterModes CutterWords SideWords EdgeWords ControlWords.
From Toolcomp Require Import ControlStep DrillingCycle Compensation Program OutcomeLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * The moves of a block *)

(** What nothing has compensated yet. *)
Definition without_head {num} {N : Numbers num} (s : setup num) (m : movement num) : Prop := head m = zeros s.

(** One move, of the block itself. *)
Definition one_programmed {num} (moves : list (movement num)) : Prop :=
  exists m, moves = [m] /\ because m = Programmed.

Lemma own_move_is_bare {num} {N : Numbers num} (s : setup num) numbers b circle_of changed longer st st' moves :
  own_move s numbers b circle_of changed longer st = Got (st', moves) ->
  control st' = control st /\ Forall (without_head s) moves /\
  (empty (which numbers) = false -> one_programmed moves).
Proof.
  unfold own_move; intro H. destruct circle_of as [c|].
  - apply bound in H as ([[[center after] swept] radii] & _ & H). apply same in H.
    injection H as <- <-. repeat split; [now repeat constructor|]. intros _; eexists; split; reflexivity.
  - apply bound in H as (growth & _ & H). apply same in H. injection H as <- <-. split; [reflexivity|].
    split; [destruct (negb _ || changed); repeat constructor|]. intros ->. eexists; split; reflexivity.
Qed.

Lemma measurement_is_bare {num} {N : Numbers num} (s : setup num) numbers st st' moves alarm writing :
  measurement s numbers st = Got (st', moves, alarm, writing) ->
  control st' = control st /\ Forall (without_head s) moves.
Proof.
  unfold measurement; intro H. apply bound in H as (path & _ & H). apply same in H. injection H as <- <- _ _.
  split; [reflexivity|]. apply Forall_app; split.
  - destruct (rapid_to path), (measuring_to path); repeat constructor.
  - destruct (measuring_to path); repeat constructor.
Qed.

Lemma under_control_is_bare {num} {N : Numbers num} (s : setup num) c behind st moves st' moves' :
  under_control s c behind st moves = (st', moves') ->
  (in_control behind = None -> control st' = control st) /\
  (Forall (without_head s) moves -> Forall (without_head s) moves') /\
  (one_programmed moves -> one_programmed moves').
Proof.
  unfold under_control. destruct (in_control behind) as [m|]; intro H.
  - injection H as _ <-. split; [discriminate|]. split.
    + intro F. apply Forall_map. eapply Forall_impl; [|exact F]. intros g E. exact E.
    + intros (g & -> & P). eexists; split; [reflexivity|exact P].
  - injection H as <- <-. auto.
Qed.

(** Codes whose moves are not the own move of the block. *)
Definition goes_elsewhere (code : option action) : bool :=
  goes_to_machine_position code || match code with Some ReturnFromReference | Some Measure => true | _ => false end.

Lemma reference_code {num} {N : Numbers num} (s : setup num) code b x :
  reference_position s code b = Got x -> x <> None -> goes_to_machine_position code = true.
Proof. unfold reference_position; intros H D. destruct code as [[]|]; try reflexivity; apply same in H; congruence. Qed.

Ltac parts_of H := match type of H with (?a, ?m, _, _) = (?a', ?m', _, _) =>
  assert (FIRST : a' = a) by congruence; assert (SECOND : m' = m) by congruence end.

Lemma moves_of_block_are {num} {N : Numbers num} (s :
  setup num) c path circle_of changed longer target on_way run writing
    st st' moves alarm writing' :
  moves_of_block s c path circle_of changed longer target on_way run writing st = Got (st', moves, alarm, writing') ->
  (target <> None -> goes_to_machine_position (acting c) = true) -> control st = run ->
  (in_control run = None -> control st' = run) /\ Forall (without_head s) moves /\
  (goes_elsewhere (acting c) = false -> empty (which (position_words c)) = false -> one_programmed moves).
Proof.
  unfold moves_of_block; intros H T <-.
  assert (OWN : forall x, own_move s (position_words c) path circle_of changed longer st = Got x ->
    let y := under_control s c (control st) (fst x) (snd x) in
    (in_control (control st) = None -> control (fst y) = control st) /\ Forall (without_head s) (snd y) /\
    (empty (which (position_words c)) = false -> one_programmed (snd y))).
  { intros [st4 first] O. apply own_move_is_bare in O as (O & F & P). cbn [fst snd].
    destruct (under_control s c (control st) st4 first) as [st5 second] eqn:W.
    apply under_control_is_bare in W as (W & F' & P'). rewrite <- O. cbn [fst snd]. rewrite <- O in W. auto. }
  assert (GO : forall y, (exists x, own_move s (position_words c) path circle_of changed longer st = Got x /\
      under_control s c (control st) (fst x) (snd x) = y) -> st' = fst y -> moves = snd y ->
    (in_control (control st) = None -> control st' = control st) /\ Forall (without_head s) moves /\
    (goes_elsewhere (acting c) = false -> empty (which (position_words c)) = false -> one_programmed moves)).
  { intros y (x & O & <-) -> ->. specialize (OWN x O). cbv zeta in OWN. tauto. }
  assert (TWO : forall x : state num * list (movement num), control (fst x) = control st ->
    Forall (without_head s) (snd x) ->
    st' = fst x -> moves = snd x -> (empty (which (position_words c)) = false -> goes_elsewhere (acting c) = true) ->
    (in_control (control st) = None -> control st' = control st) /\ Forall (without_head s) moves /\
    (goes_elsewhere (acting c) = false -> empty (which (position_words c)) = false -> one_programmed moves)).
  { intros x K F -> -> E. repeat split; auto. intros O E'. rewrite E in O by exact E'. discriminate. }
  destruct (empty (which (position_words c))) eqn:E; cbn [negb] in H.
  - destruct (acting c) as [[]|] eqn:A;
      first [ apply measurement_is_bare in H as [H F]; repeat split; [intros _; exact H|exact F|intros; discriminate]
            | apply bound in H as ([st4 first] & O & H); apply same in H; parts_of H;
              eapply GO; [eexists; split; [exact O|reflexivity]|exact FIRST|exact SECOND] ].
  - destruct (acting c) as [[]|] eqn:A, target as [t|];
      first [ apply measurement_is_bare in H as [H F]; repeat split; [intros _; exact H|exact F|intros; discriminate]
            | apply same in H; parts_of H;
              eapply TWO; [| |exact FIRST|exact SECOND|intros _;
                first [reflexivity|now specialize (T ltac:(discriminate))]];
              [reflexivity|repeat constructor]
            | apply bound in H as ([st4 first] & O & H); apply same in H; parts_of H;
              eapply GO; [eexists; split; [exact O|reflexivity]|exact FIRST|exact SECOND] ].
Qed.

Lemma no_words_are_empty {num A} (list : list A) : empty (which (map (fun _ => None : option num) list)) = true.
Proof. unfold empty, size, which. induction list as [|a list IH]; [reflexivity|exact IH]. Qed.

(** Without a word, an arc and a change of an offset, and where nothing is measured, nothing moves. *)
Lemma nothing_moves {num} {N : Numbers num} (s : setup num) c path longer target on_way run writing st st' moves alarm
    writing' :
  moves_of_block s c path None false longer target on_way run writing st = Got (st', moves, alarm, writing') ->
  empty (which (position_words c)) = true -> acting c <> Some Measure -> moves = [].
Proof.
  unfold moves_of_block; intros H E A. rewrite E in H. cbn [negb] in H.
  assert (OWN : forall x, own_move s (position_words c) path None false longer st = Got x -> snd x = []).
  { intros x O. unfold own_move in O. rewrite E in O. cbn [negb orb] in O. apply bound in O as (growth & _ & O).
    now apply same in O as <-. }
  destruct (acting c) as [[]|]; try contradiction;
    (apply bound in H as ([st4 first] & O & H); apply same in H; apply OWN in O; cbn [snd] in O; subst first;
     unfold under_control in H; destruct (in_control run); cbn in H; congruence).
Qed.

(** * A step *)

Definition is_no_move {num} (i : item num) : bool := match i with Go _ => false | _ => true end.
Definition is_no_hole {num} (i : item num) : bool := match i with Drill _ => false | _ => true end.

(** The parts that the laws use. *)
Record stepped {num} {N : Numbers num} (s : setup num) (place : nat) (b : block num) (st : state num) (p : planned num)
    (after : state num) (moves : list (movement num)) (others : list (item num)) : Prop := Stepped {
  read : unreadable b = None;
  its_place : at_place p = place;
  its_block : block_of (command_of p) = b;
  its_codes : codes_of b = Some (codes_said (command_of p));
  its_acting : acting (command_of p) = action_of (codes_said (command_of p));
  cutter_allowed : cutter_alarms s (command_of p) (control_left s (codes_said (command_of p)) st) = Got tt;
  side_allowed : side_alarms s (command_of p) (control_left s (codes_said (command_of p)) st) = Got tt;
  edge_allowed : edge_alarms s (command_of p) (control_left s (codes_said (command_of p)) st) = Got tt;
  cutter_kept : cutter (before p) = cutter st;
  side_kept : side (before p) = side st;
  edge_kept : edge (before p) = edge st;
  control_kept : control (before p) = control st;
  its_items : items p = map Go moves ++ others;
  its_others : forallb is_no_move others = true;
  bare : Forall (without_head s) moves;
  one_move : goes_elsewhere (acting (command_of p)) = false -> empty (which (position_words (command_of p))) = false ->
             one_programmed moves;
  drills_only : makes_holes s (codes_said (command_of p)) b (cycle (before p)) = false ->
                forallb is_no_hole others = true;
  drills_alone : makes_holes s (codes_said (command_of p)) b (cycle (before p)) = true -> moves = [];
  cutter_found : cutter_behind s (command_of p) (before p) after moves = Got (cutter (behind p));
  side_found : side_behind s (command_of p) (before p) after moves = Got (side (behind p));
  edge_found : edge (behind p) = EdgeState (leads_behind (command_of p) (edge st)) (next_leading_number (command_of p)
    (edge st));
  control_found : control (behind p) = control after;
  control_none : type_with (codes_said (command_of p)) (before p) = None -> in_control (control after) = None
}.

Lemma control_of_left {num} {N : Numbers num} (s : setup num) codes st : control (control_left s codes st) = control st.
Proof. unfold control_left. destruct (in_control (control st)); [|reflexivity]. now destruct (last_of lengths codes).
Qed.
Lemma cutter_of_left {num} {N : Numbers num} (s : setup num) codes st : cutter (control_left s codes st) = cutter st.
Proof. unfold control_left. destruct (in_control (control st)); [|reflexivity]. now destruct (last_of lengths codes).
Qed.
Lemma side_of_left {num} {N : Numbers num} (s : setup num) codes st : side (control_left s codes st) = side st.
Proof. unfold control_left. destruct (in_control (control st)); [|reflexivity]. now destruct (last_of lengths codes).
Qed.
Lemma edge_of_left {num} {N : Numbers num} (s : setup num) codes st : edge (control_left s codes st) = edge st.
Proof. unfold control_left. destruct (in_control (control st)); [|reflexivity]. now destruct (last_of lengths codes).
Qed.

Lemma without_control_is_none {num} {N : Numbers num} (s : setup num) c numbers st x :
  without_control s c numbers st = Got x -> in_control x = None.
Proof.
  unfold without_control; intro H.
  destruct (kinematics_of s) as [k|]; [|apply same in H as <-; reflexivity].
  destruct (stands_at (control st)) as [here|]; [|apply same in H as <-; reflexivity].
  destruct (_ && (names s rotary c || _)); [apply same in H as <-; reflexivity|].
  apply bound in H as (? & _ & H). now apply same in H as <-.
Qed.

Ltac parts H := repeat first
  [ apply bound in H as (? & ? & H)
  | match type of H with match ?x with (_, _) => _ end = _ => destruct x eqn:? end ].

(** A block that drills leaves everything but the position and the mode. *)
Lemma cycle_step_keeps {num} {N : Numbers num} (s : setup num) c drills numbers st :
  control (fst (cycle_step s c drills numbers st)) = control st.
Proof.
  unfold cycle_step.
  destruct (drilling (cycle st)) as [d|], drills, (hole_count (block_of c)) as [count|]; try reflexivity.
  cbv zeta. destruct (hole_places _ _ _ _); reflexivity.
Qed.

Lemma no_holes {num} {N : Numbers num} (s : setup num) c drills numbers st :
  drills && negb (no_hole (block_of c)) = false -> snd (cycle_step s c drills numbers st) = [].
Proof.
  intro NONE. unfold cycle_step. destruct (drilling (cycle st)) as [d|]; [|reflexivity].
  destruct drills; [|reflexivity]. unfold no_hole in NONE.
  destruct (hole_count (block_of c)) as [[|count|count]|]; try discriminate NONE; reflexivity.
Qed.

Lemma step_is_stepped {num} {N : Numbers num} decimal (s : setup num) place b st p alarm :
  step decimal s place b st = Got (p, alarm) ->
  exists after moves others, stepped s place b st p after moves others.
Proof.
  unfold step. intro H.
  apply bound in H as (u & U & H). 
  destruct (codes_of b) as [codes|] eqn:C; [|discriminate].
  cbv zeta in H. parts H. apply same in H. assert (P := f_equal fst H). cbn [fst] in P. clear H.
  match type of P with Planned _ ?c ?a _ (map Go ?m ++ ?w) = _ =>
    set (said := c) in *; set (at_start := a) in *; set (moves := m) in *; set (others := w) in * end.
  match goal with H : edge_behind _ _ _ ?a = _ |- _ => set (after := a) in * end.
  exists after, moves, others.
  assert (ALONE : makes_holes s codes b (cycle at_start) = true -> moves = []).
  { intro D. change (cycle at_start) with (cycle_with s codes (in_plane (select codes (modes_of st))) (cycle st)) in D.
    set (cycling := cycle_with s codes (in_plane (select codes (modes_of st))) (cycle st)) in *.
    rewrite D in *. unfold makes_holes in D. destruct (drilling cycling) as [d0|] eqn:E; [|discriminate D].
    cbn [given andb] in *.
    apply andb_prop in D as [NAMES _]. rewrite NAMES in *.
    assert (T : type_with codes (control_left s codes st) = None).
    { match goal with H : control_alarms _ _ _ _ _ = Got _ |- _ => unfold control_alarms in H; cbv zeta in H;
        apply bound in H as (? & H & _); apply no_alarm in H; change (codes_said said) with codes in H;
        rewrite !orb_true_r, andb_true_r in H; apply orb_false_elim in H as [H _] end.
      now destruct (type_with codes (control_left s codes st)). }
    assert (M : acting said <> Some Measure).
    { match goal with H : cycle_alarms _ _ _ _ _ _ _ = Got _ |- _ => unfold cycle_alarms in H; rewrite E in H;
        cbv zeta in H; do 3 apply bound in H as (? & _ & H); apply bound in H as (? & H & _) end.
      intro A. match goal with H : (if _ then Undecided _ else _) = Got _ |- _ => rewrite A in H; discriminate H end. }
    change (type_with codes (control_left s codes st)) with (type_with (codes_said said) at_start) in T.
    match goal with H : control_step _ _ _ _ _ _ = Got ?controlled |- _ =>
      unfold control_step in H; rewrite T in H; apply same in H; subst controlled end.
    match goal with H : (if negb (_ || _ || _) && _ then _ else Got None) = Got ?circle |- _ =>
      rewrite orb_true_r in H; cbn [negb andb] in H; apply same in H; subst circle end.
    match goal with H : bind (if shifts_system s || _ then _ else _) _ = Got ?changed |- _ =>
      rewrite orb_true_r in H; cbn [bind negb orb] in H; rewrite andb_false_r in H; apply same in H; subst changed end.
    match goal with H : moves_of_block _ _ _ _ _ _ _ _ _ _ _ = Got (_, moves, _, _) |- _ =>
      apply nothing_moves in H; [exact H| |exact M] end.
    apply no_words_are_empty. }
  match goal with H : moves_of_block _ _ _ _ _ _ ?target _ ?run _ ?st3 = Got (?a, _, _, _) |- _ =>
    apply moves_of_block_are in H as (K & F & O);
      [replace (control a) with (control after) in K by
         (match goal with E : cycle_step ?s ?c ?d ?n ?x = (_, _) |- _ =>
            rewrite <- (cycle_step_keeps s c d n x), E; reflexivity end)
      |intro T; change (acting said) with (action_of codes);
        match goal with E : (if _ then _ else reference_position _ _ _) = Got target |- _ =>
          destruct (empty _) in E; [apply same in E; congruence|now apply (reference_code _ _ _ _ E)] end|reflexivity]
  end.
  assert (NONE : type_with codes at_start = None -> in_control (control after) = None).
  { intro T. match goal with H : control_step _ _ _ _ _ _ = Got _ |- _ => unfold control_step in H;
      change (codes_said said) with codes in H; rewrite T in H; apply same in H; subst end.
    match goal with H : without_control _ _ _ _ = Got ?x |- _ => apply without_control_is_none in H;
      rewrite K by exact H; exact H end. }
  repeat match goal with u : unit |- _ => destruct u end.
  subst p. constructor; try assumption; try reflexivity.
  - destruct (unreadable b); [discriminate U|reflexivity].
  - apply (cutter_of_left s codes).
  - apply (side_of_left s codes).
  - apply (edge_of_left s codes).
  - apply (control_of_left s codes).
  - subst others. rewrite forallb_app. apply andb_true_intro; split; [|now destruct o].
    apply forallb_forall. intros i I. now apply in_map_iff in I as (h & <- & _).
  - intro OFF. change (makes_holes s codes b (cycle_with s codes (in_plane (select codes (modes_of st))) (cycle st))
                       = false) in OFF.
    subst others. rewrite forallb_app. apply andb_true_intro; split; [|now destruct o].
    match goal with E : cycle_step _ _ ?drills ?numbers ?before = (_, ?holes) |- _ =>
      assert (W := no_holes s said drills numbers before OFF); rewrite E in W; cbn [snd] in W; now rewrite W end.
  - match goal with H : edge_behind _ _ _ _ = Got ?x |- _ => unfold edge_behind in H; apply same in H; subst x end.
    change (edge at_start) with (edge (control_left s codes st)). now rewrite edge_of_left.
  - match goal with H : control_behind _ _ _ _ = Got ?x |- _ => unfold control_behind in H; now apply same in H end.
Qed.

(** * A plan *)

(** What holds before the first block and is kept by every block holds of all of them. *)
Lemma planned_all {num} {N : Numbers num} decimal (s : setup num) (I : state num -> Prop) (W : block num -> Prop)
    (Q : planned num -> Prop) :
  (forall place b st p after moves others, W b -> I st -> stepped s place b st p after moves others ->
    I (behind p) /\ Q p) ->
  forall bs place st, Forall W bs -> I st -> Forall Q (fst (planned_from decimal s bs place st)).
Proof.
  intro K. induction bs as [|b bs IH]; intros place st F H; cbn -[step]; [constructor|].
  inversion F as [|? ? W0 F']; subst.
  destruct (step decimal s place b st) as [[p alarm]| |] eqn:E; try constructor.
  apply step_is_stepped in E as (after & moves & others & E).
  destruct (K _ _ _ _ _ _ _ W0 H E) as [H' Q'].
  destruct alarm; [now constructor|]. destruct (ends b); [now constructor|].
  specialize (IH (S place) (behind p) F' H').
  destruct (planned_from decimal s bs (S place) (behind p)). cbn in *. now constructor.
Qed.
