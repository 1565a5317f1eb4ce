(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of M140, departures without coordinates, and positions that are not known, in a Klartext run. *)
From Coq Require Import List String ZArith Bool Reals Lra.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool.
From Toolcomp Require Import KlartextPeripheral KlartextState KlartextMoves KlartextProgram OutcomeLaws KlartextLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

Lemma eqb_is (a b : Letter.t) : Letter.eqb a b = true <-> a = b.
Proof. unfold Letter.eqb. split; [now destruct a, b|intros ->; now destruct b]. Qed.
Lemma among_is (axes : list Letter.t) letter : among axes letter = true <-> In letter axes.
Proof.
  unfold among. rewrite existsb_exists. split.
  - intros (a & I & E). apply eqb_is in E. now subst.
  - intro I. exists letter. split; [exact I|now apply eqb_is].
Qed.

(** * Along the tool *)

Lemma at_letter_map2 {num} {N : Numbers num} (s : klartext_setup num) (f : Letter.t -> num -> num) v letter :
  List.length v = List.length (letters s) -> In letter (letters s) ->
  at_letter s letter (map2 f (letters s) v) = f letter (at_letter s letter v).
Proof.
  unfold at_letter. generalize (letters s). intro axes; revert v.
  induction axes as [|a axes IH]; intros [|x v] L I; try discriminate; [destruct I|].
  cbn in *. destruct (Letter.eqb a letter) eqn:E.
  - apply eqb_is in E. now subst.
  - apply IH; [now injection L|]. destruct I as [->|I]; [|exact I].
    assert (T : Letter.eqb letter letter = true) by now apply eqb_is. congruence.
Qed.

Lemma with_space_length {num} (s : klartext_setup num) p (v : values num) :
  List.length v = List.length (letters s) -> List.length (with_space s p v) = List.length (letters s).
Proof.
  destruct p as [[x y] z]. unfold with_space. generalize (letters s). intro axes; revert v.
  induction axes as [|a axes IH]; intros [|b v] L; try discriminate; [reflexivity|].
  cbn in *. f_equal. apply IH. now injection L.
Qed.

(** The position behind a block, of an axis that is known there. *)
Lemma known_end {num} {N : Numbers num} (s : klartext_setup num) to unknown letter :
  List.length to = List.length (letters s) -> In letter (letters s) -> among unknown letter = false ->
  at_letter s letter (map2 (fun letter x => if among (filter (among unknown) (letters s)) letter then 0%num else x)
                        (letters s) to) = at_letter s letter to.
Proof.
  intros L I K. rewrite (at_letter_map2 s) by assumption.
  destruct (among (filter (among unknown) (letters s)) letter) eqn:E; [|reflexivity].
  apply among_is, filter_In in E. destruct E as [_ E]. congruence.
Qed.

(** heidenhain.program.retraction: M140 MB n goes by n along the tool: P' = P + n t, in every axis that is known. *)
Theorem retraction_goes_along_the_tool {num} {N : Numbers num} (s : klartext_setup num) machine_datum w st n e letter :
  end_of_block s machine_datum w st = Got e -> to_end w = AlongTool (Some n) ->
  List.length (position st) = List.length (letters s) -> In letter (letters s) -> among (unknown_axes st) letter = false ->
  let t := of_length_1 (tool_direction st) in
  at_letter s letter (end_values e) =
  at_letter s letter (with_space s (add3 (space_of s (position st)) (scale3 (value_of st n) t)) (position st)).
Proof.
  unfold end_of_block. intros H W L I K. rewrite W in H. apply same in H as <-.
  apply known_end; auto using with_space_length.
Qed.

Definition tilted : klartext_state R :=
  with_tcpm (TcpmState true false (direction_along (3, 0, 4)%R) true false) at_start.

Example retraction_goes_along_the_tool_instance e :
  end_of_block plain_control false (retracting (Some (Literal 5%R))) tilted = Got e ->
  at_letter plain_control Letter.Z (end_values e) = (0 + 5 * (4 / sqrt (3 * 3 + 0 * 0 + 4 * 4)))%R.
Proof.
  intro H. rewrite (retraction_goes_along_the_tool _ _ _ _ (Literal 5%R) _ Letter.Z H); try reflexivity. cbn; auto.
Qed.

(** heidenhain.program.retraction, heidenhain.program.direction-without-tcpm: without TCPM it moves the tool axis by n, and
    no other. *)
Theorem retraction_moves_the_tool_axis (s : klartext_setup R) machine_datum w st n e letter :
  end_of_block s machine_datum w st = Got e -> to_end w = AlongTool (Some n) -> tcpm_on (tcpm_of st) = false ->
  In (axis_of_tool (tool_of st)) [Letter.X; Letter.Y; Letter.Z] ->
  List.length (position st) = List.length (letters s) -> In letter (letters s) -> among (unknown_axes st) letter = false ->
  at_letter s letter (end_values e) =
  (at_letter s letter (position st) + if Letter.eqb letter (axis_of_tool (tool_of st)) then value_of st n else 0)%R.
Proof.
  intros H W T A L I K. rewrite (retraction_goes_along_the_tool _ _ _ _ _ _ _ H W L I K).
  unfold tool_direction. rewrite T. unfold with_space, space_of.
  destruct A as [A|[A|[A|[]]]]; rewrite <- A; cbn [along_axis of_length_1 scale3 add3];
    rewrite (at_letter_map2 s) by assumption; destruct letter; cbn; ring.
Qed.

Example retraction_moves_the_tool_axis_instance e :
  end_of_block plain_control false (retracting (Some (Literal 5%R))) at_start = Got e ->
  at_letter plain_control Letter.X (end_values e) = 0%R /\ at_letter plain_control Letter.Z (end_values e) = 5%R.
Proof.
  intro H. assert (P : forall letter, In letter [Letter.X; Letter.Y; Letter.Z; Letter.B] ->
    at_letter plain_control letter (end_values e) =
    (at_letter plain_control letter (position at_start) + if Letter.eqb letter Letter.Z then 5 else 0)%R).
  { intros letter I. apply (retraction_moves_the_tool_axis _ _ _ _ _ _ letter H eq_refl); auto. cbn; auto. }
  rewrite !P by (cbn; auto). cbn. split; ring.
Qed.

(** * What is not known *)

(** heidenhain.program.unknown-position: a block that runs with words of all axes that are not known leaves none unknown, and
    none of these words is an increment. *)
Theorem words_make_known {num} {N : Numbers num} (s : klartext_setup num) machine_datum with_vectors w normal tool_vector st
    st' p :
  plan s machine_datum with_vectors w normal tool_vector st = Got (st', p) -> to_end w = ByWords ->
  (forall letter, In letter (unknown_axes st) -> word_of letter (axis_words w) <> None) -> axis_words w <> [] ->
  unknown_axes st' = [] /\
  (forall word, In word (axis_words w) -> In (axis_letter word) (unknown_axes st) -> with_i word = false).
Proof.
  unfold plan. intros H W A M. rewrite W in H. cbv zeta in H.
  destruct (negb with_vectors && _) eqn:E in H.
  { apply andb_prop in E as [_ E]. now destruct (axis_words w). }
  apply bound in H as (e & G & H). unfold end_of_block in G. rewrite W in G. apply bound in G as (? & I & G).
  apply no_alarm in I. apply same in G.
  assert (U : unknown_at_end e = []).
  { subst e. cbn [unknown_at_end]. cbn in A |- *. generalize (letters s); intro axes.
    induction axes as [|a axes IH]; cbn; [reflexivity|].
    destruct (among (filter (fun letter => negb (given (word_of letter (axis_words w)))) (unknown_axes st)) a) eqn:B;
      [|exact IH].
    apply among_is, filter_In in B as [B B']. specialize (A a B). destruct (word_of a (axis_words w)); now cbn in *. }
  split.
  - repeat (apply bound in H as (? & _ & H)). apply same in H. injection H as <- _. exact U.
  - intros word B B'. destruct (with_i word) eqn:J; [|reflexivity].
    change (existsb (fun w => with_i w && among (unknown_axes st) (axis_letter w)) (axis_words w) = false) in I.
    rewrite <- I. symmetry. apply existsb_exists. exists word. split; [exact B|]. rewrite J. now apply among_is.
Qed.

Definition lost_z : klartext_state R := at_end_of_motion (position at_start) [Letter.Z] None at_start.
Definition to_z (z : R) : line_words R := LineWords [AxisWord Letter.Z false (Literal z)] None None false ByWords.

Example words_make_known_instance st p :
  plan plain_control false false (to_z 5) None None lost_z = Got (st, p) -> unknown_axes st = [].
Proof.
  intro H. apply (words_make_known _ _ _ _ _ _ _ _ _ H); [reflexivity| |discriminate].
  intros letter [<-|[]]. discriminate.
Qed.

Definition of_space : list Letter.t := [Letter.X; Letter.Y; Letter.Z].

Lemma end_of_space {num} {N : Numbers num} (s : klartext_setup num) machine_datum w st e :
  end_of_block s machine_datum w st = Got e -> incl (unknown_axes st) of_space -> incl (unknown_at_end e) of_space.
Proof.
  unfold end_of_block. intros H U.
  assert (F : forall not_known axes, incl not_known of_space -> incl (filter (among not_known) axes) of_space).
  { intros not_known axes I letter B. apply filter_In in B as [_ B]. now apply I, among_is. }
  destruct (to_end w) as [|[n|]|]; repeat (apply bound in H as (? & ?A & H)); apply same in H as <-; cbn [unknown_at_end];
    apply F.
  - intros letter B. apply filter_In in B as [B _]. now apply U.
  - exact U.
  - apply incl_app; [|exact U]. unfold axes_along in A. apply bound in A as (signs & E & A). apply same in A as <-.
    apply each_got in E. intros letter B. apply in_map_iff in B as ([a b] & <- & B). apply filter_In in B as [B _].
    destruct (as_given (tool_direction st)) as [[x y] z]. cbn [components] in E.
    repeat match goal with
           | E : Forall2 _ _ _ |- _ => inversion E; clear E; subst
           | E : bind _ _ = Got _ |- _ => apply bound in E as (? & _ & E); apply same in E; subst
           end.
    destruct B as [B|[B|[B|[]]]]; injection B as <- _; cbn; auto.
  - apply incl_app; [|exact U]. intros letter B. now apply filter_In in B as [B _].
Qed.

Lemma plan_of_space {num} {N : Numbers num} (s : klartext_setup num) machine_datum with_vectors w normal tool_vector st st'
    p :
  plan s machine_datum with_vectors w normal tool_vector st = Got (st', p) -> incl (unknown_axes st) of_space ->
  incl (unknown_axes st') of_space.
Proof.
  unfold plan. intros H U. cbv zeta in H. destruct (negb with_vectors && _) in H.
  { apply same in H. now injection H as <- _. }
  apply bound in H as (e & E & H). apply end_of_space in E; [|exact U].
  repeat (apply bound in H as (? & _ & H)). apply same in H. now injection H as <- _.
Qed.

Lemma assigned_unknown {num} {N : Numbers num} sets (st : klartext_state num) :
  unknown_axes (assigned sets st) = unknown_axes st.
Proof.
  unfold assigned. revert st; induction sets as [|[p v] sets IH]; intro st; [reflexivity|]. cbn. now rewrite IH.
Qed.

(** heidenhain.program.unknown-position, heidenhain.program.retraction: positions of X, Y and Z alone are ever unknown, and
    nothing but a motion changes which. *)
Theorem space_alone_is_unknown {num} {N : Numbers num} (s : klartext_setup num) b st st' p :
  klartext_step s b st = Got (st', p) -> incl (unknown_axes st) of_space ->
  incl (unknown_axes st') of_space /\ (p = None -> unknown_axes st' = unknown_axes st).
Proof.
  unfold klartext_step. intros H U. apply bound in H as (? & _ & H). apply bound in H as (? & _ & H).
  apply bound in H as ([st1 p1] & H & E). apply same in E. injection E as <- <-.
  assert (C : unknown_axes (closes b st1) = unknown_axes st1).
  { unfold closes. destruct (has_function 129 b), (has_function 108 b); reflexivity. }
  rewrite C. clear C.
  assert (A : unknown_axes (starts s b st) = unknown_axes st).
  { unfold starts. destruct (has_function 128 b), (has_function 107 b); reflexivity. }
  rewrite <- A in *. clear A. revert H U. generalize (starts s b st). clear st. intros st H U.
  destruct (says b) as [| |tool axis given_deltas f|w|w normal tool_vector| | | |table row|table|number part shifts sets| | | |];
    try (apply same in H; injection H as <- <-; auto; fail).
  - apply bound in H as (st2 & T & H). apply same in H. injection H as <- <-. unfold call_tool in T.
    apply bound in T as (? & _ & T). apply bound in T as (? & _ & T). apply same in T as <-. auto.
  - split; [now apply plan_of_space in H|]. intros ->. unfold plan in H. cbv zeta in H. destruct (negb false && _) in H.
    + apply same in H. now injection H as <-.
    + repeat (apply bound in H as (? & _ & H)). apply same in H. discriminate.
  - split; [now apply plan_of_space in H|]. intros ->. unfold plan in H. cbv zeta in H. cbn [negb andb] in H.
    repeat (apply bound in H as (? & _ & H)). apply same in H. discriminate.
  - destruct table; apply same in H; injection H as <- <-; auto.
  - destruct table; apply same in H; injection H as <- <-; auto.
  - apply same in H. injection H as <- <-. rewrite assigned_unknown. destruct (_ && _); auto.
Qed.

Example space_alone_is_unknown_instance st p :
  klartext_step plain_control (says_only (Line (retracting None))) at_start = Got (st, p) ->
  incl (unknown_axes st) of_space.
Proof. intro H. apply (space_alone_is_unknown _ _ _ _ _ H). intros letter []. Qed.

(** heidenhain.program.unknown-position: of an axis that is not known an event has no coordinate, and then no vectors of the
    tool. *)
Theorem nothing_told_of_the_unknown {num} {N : Numbers num} (s : klartext_setup num) m because tip shift touch letter x :
  let told := move_to_tip s m because tip shift touch in
  In letter (unknown_at_end (ends m)) ->
  tool_stands told = None /\
  (In (letter, x) (combine (letters s) (programmed_values told)) -> x = None) /\
  (In (letter, x) (combine (letters s) (tip_values told)) -> x = None) /\
  (In (letter, x) (combine (letters s) (sent_to told)) -> x = None).
Proof.
  intros told I.
  assert (P : forall (left_out : Letter.t -> bool) (v : values num), left_out letter = true ->
    In (letter, x) (combine (letters s) (map2 (fun letter y => if left_out letter then None else Some y) (letters s) v)) ->
    x = None).
  { intros left_out v O. generalize (letters s); intro axes; revert v.
    induction axes as [|a axes IH]; intros [|y v] J; try (destruct J; fail).
    destruct J as [J|J]; [|exact (IH v J)]. injection J as -> <-. now rewrite O. }
  split; [|repeat split; apply P; try now apply among_is].
  - unfold told, move_to_tip; cbn [tool_stands]. destruct (unknown_at_end (ends m)); [destruct I|reflexivity].
  - apply orb_true_iff; left. now apply among_is.
Qed.

Definition lost_motion : motion R :=
  Motion true None (Ending [5; 0; 0; 0]%R [Letter.Z] None) [] (0, 0, 1)%R 0%R None 1%R.

Example nothing_told_of_the_unknown_instance :
  nth 2 (sent_to (move_to_tip plain_control lost_motion Programmed (5, 0, 0)%R zero3 None)) None = None.
Proof.
  apply (nothing_told_of_the_unknown plain_control lost_motion Programmed (5, 0, 0)%R zero3 None Letter.Z); cbn; auto.
Qed.

Lemma forgotten_alike {num} {N : Numbers num} (fewer more : Letter.t -> bool) axes (v v' : values num) :
  (forall letter, In letter axes -> fewer letter = true -> more letter = true) ->
  map2 (fun letter x => if fewer letter then 0%num else x) axes v =
  map2 (fun letter x => if fewer letter then 0%num else x) axes v' ->
  map2 (fun letter x => if more letter then 0%num else x) axes v =
  map2 (fun letter x => if more letter then 0%num else x) axes v'.
Proof.
  revert v v'; induction axes as [|a axes IH]; intros [|x v] [|x' v'] M E; try discriminate; [reflexivity..|].
  cbn in *. injection E as E E'. f_equal; [|apply IH; auto].
  specialize (M a (or_introl eq_refl)). destruct (fewer a); [now rewrite M|now rewrite E].
Qed.

(** heidenhain.program.retraction: nothing of a run depends on where the axes stood that M140 MB MAX moves. *)
Theorem limit_forgets_where_axes_stood {num} {N : Numbers num} (s : klartext_setup num) machine_datum w st here along :
  to_end w = AlongTool None -> axis_words w = [] -> axes_along (as_given (tool_direction st)) = Got along ->
  let of_others := map2 (fun letter x => if among along letter then 0%num else x) (letters s) in
  of_others here = of_others (position st) ->
  plan s machine_datum false w None None (at_end_of_motion here (unknown_axes st) (contact_before st) st) =
  plan s machine_datum false w None None st.
Proof.
  intros W A T of_others E.
  set (modes := with_line_modes (or_else (radius_given w) (radius_mode st)) (next_feeds st (feed_given w))).
  assert (G : end_of_block s machine_datum w (modes (at_end_of_motion here (unknown_axes st) (contact_before st) st)) =
              end_of_block s machine_datum w (modes st)).
  { unfold end_of_block, tool_direction, modes in *; cbn [tcpm_of at_end_of_motion with_line_modes tool_of unknown_axes position].
    rewrite W, T. cbn [bind]. do 2 f_equal. apply (forgotten_alike (among along)); [|exact E].
    intros letter I B. apply among_is, filter_In. split; [exact I|]. apply among_is, in_or_app. left. now apply among_is. }
  unfold plan. change (radius_mode (at_end_of_motion _ _ _ st)) with (radius_mode st).
  change (next_feeds (at_end_of_motion _ _ _ st) (feed_given w)) with (next_feeds st (feed_given w)). fold modes.
  rewrite A, W. cbv zeta. cbn [negb andb]. rewrite G. reflexivity.
Qed.

Example limit_forgets_where_axes_stood_instance :
  plan plain_control false false (retracting None) None None (at_end_of_motion [0; 0; 70; 0]%R [] None at_start) =
  plan plain_control false false (retracting None) None None at_start.
Proof.
  apply (limit_forgets_where_axes_stood plain_control false (retracting None) at_start [0; 0; 70; 0]%R [Letter.Z]);
    try reflexivity.
  unfold axes_along. cbn [tool_direction tcpm_on tcpm_of at_start initial_state as_given along_axis axis_of_tool tool_of
    components each]. change (0%num) with 0%R. rewrite zero_is_zero.
  rewrite is_not_zero by (cbn; lra). reflexivity.
Qed.
