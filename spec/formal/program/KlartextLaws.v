(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of whole Klartext programs: they hold for every program and every setup. *)
From Coq Require Import List String ZArith Bool Reals Lra.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool KlartextFace.
From Toolcomp Require Import KlartextPeripheral KlartextState KlartextMoves KlartextProgram OutcomeLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

Definition plain_control : klartext_setup R :=
  KlartextSetup [Letter.X; Letter.Y; Letter.Z; Letter.B] false [0%R; 0%R; 0%R; 0%R]
    [ToolRow 10 "" 6%R 1%R None (Deltas 0%R (- (1 / 10))%R 0%R) None] [] false.
Definition at_start : klartext_state R := initial_state plain_control false.
Definition says_only (st : statement R) : klartext_block R := KlartextBlock st [] None.
Definition to_x (x : R) : line_words R := LineWords [AxisWord Letter.X false (Literal x)] None None false ByWords.
(** M140 MB n, MB MAX. *)
Definition retracting (by_ : option (written R)) : line_words R := LineWords [] None None false (AlongTool by_).

(** * How a run goes *)

(** heidenhain.program.end: nothing comes behind the block with M2, M30 or END PGM. *)
Theorem nothing_behind_the_last_block {num} {N : Numbers num} (s : klartext_setup num) b more place st :
  ends_program b = true -> plans s (b :: more) place st = plans s [b] place st.
Proof. intro E; cbn [plans]. destruct (whole_block s b st) as [[[st' p] d]| |]; try reflexivity. now rewrite E. Qed.

Definition end_block : klartext_block R := KlartextBlock OtherStatement [30%Z] None.

Example nothing_behind_the_last_block_instance :
  plans plain_control [end_block; says_only (Line (to_x 5))] 0 at_start = plans plain_control [end_block] 0 at_start.
Proof. now apply nothing_behind_the_last_block. Qed.

(** An event that ends the run. *)
Definition ends_run {num} (e : klartext_event num) : bool :=
  match e with AlarmRaised _ | SignOpen _ => true | _ => false end.

Lemma end_in_is_last {num A} (x : outcome A) : nothing_behind ends_run (end_in (num := num) x).
Proof. destruct x; cbn; auto. Qed.

Definition stops_once {num} (i : item num) : Prop :=
  match i with Moving _ _ | Drilling _ _ => True | Stopped _ es => nothing_behind ends_run es end.

Lemma plans_stop_once {num} {N : Numbers num} (s : klartext_setup num) bs place st :
  Forall stops_once (plans s bs place st).
Proof.
  revert place st; induction bs as [|b bs IH]; intros place st; cbn [plans]; [constructor|].
  destruct (whole_block s b st) as [[[st' p] d]|number|clause];
    try (constructor; [apply (end_in_is_last (A := unit) (Alarm number)) ||
                       apply (end_in_is_last (A := unit) (Undecided clause))|constructor]).
  assert (L : Forall stops_once (if ends_program b then [] else plans s bs (S place) st')).
  { destruct (ends_program b); [constructor|apply IH]. }
  destruct p as [p|], d as [d|]; repeat (constructor; [exact I|]); exact L.
Qed.

Lemma placed {num} (place : nat) (es : list (klartext_event num)) : map snd (map (pair place) es) = es.
Proof. rewrite map_map. now rewrite map_id. Qed.

Lemma warnings_go_on {num} place (names : list string) (last : klartext_event num) :
  ends_run last = false ->
  existsb ends_run (map snd (map (fun name => (place, Warning name)) names ++ [(place : nat, last)])) = false.
Proof.
  intro L. rewrite map_app, existsb_app, map_map. cbn. rewrite L, !orb_false_r.
  induction names as [|name names IH]; [reflexivity|exact IH].
Qed.

Lemma events_end_once {num} {N : Numbers num} (s : klartext_setup num) items :
  Forall stops_once items -> forall before, nothing_behind ends_run (map snd (events_of s items before)).
Proof.
  induction items as [|[place p|place d|place es] items IH]; intros O before; [exact I| | |].
  - inversion O as [|? ? _ O']; subst. specialize (IH O'). cbn -[nothing_behind].
    destruct (way_of p) as [tip shift touch|nominal l by_delta by_radius|].
    + rewrite map_app. apply nothing_behind_app; [now apply warnings_go_on|apply IH].
    + destruct (beside_end l before (following_of items)) as [[beside made]|number|clause].
      * rewrite map_app. apply nothing_behind_app; [now apply warnings_go_on|apply IH].
      * right; reflexivity.
      * right; reflexivity.
    + rewrite map_app. apply nothing_behind_app; [now apply warnings_go_on|apply IH].
  - inversion O as [|? ? _ O']; subst. left. split; [reflexivity|now apply IH].
  - inversion O as [|? ? E _]; subst. cbn -[nothing_behind]. now rewrite placed.
Qed.

(** heidenhain.program.unreadable-block: every alarm ends the run, and nothing follows it; so does what cannot be decided. *)
Theorem klartext_alarm_is_last {num} {N : Numbers num} (s : klartext_setup num) bs :
  nothing_behind ends_run (map snd (run_klartext s bs)).
Proof. apply events_end_once, plans_stop_once. Qed.

Example klartext_alarm_is_last_instance :
  nothing_behind ends_run (map snd (run_klartext plain_control [KlartextBlock OtherStatement [] (Some "syntax"); end_block])).
Proof. apply klartext_alarm_is_last. Qed.

(** * Moves *)

(** heidenhain.program.own-move: an LN block, an L block with an axis word, M140, and a departure without coordinates, that
    runs makes exactly one move (or is out of scope once); no other does. *)
Theorem one_move_a_block {num} {N : Numbers num} (s : klartext_setup num) machine_datum with_vectors w normal tool_vector st
    st' p :
  plan s machine_datum with_vectors w normal tool_vector st = Got (st', p) ->
  (p <> None <-> with_vectors = true \/ axis_words w <> [] \/ to_end w <> ByWords).
Proof.
  unfold plan.
  destruct (negb with_vectors && match axis_words w, to_end w with [], ByWords => true | _, _ => false end) eqn:E; intro H.
  - injection H as _ <-. split; [congruence|]. apply andb_prop in E as [E E'].
    destruct with_vectors, (axis_words w), (to_end w); try discriminate. intros [O|[O|O]]; congruence.
  - cbv zeta in H. repeat (apply bound in H; destruct H as (? & _ & H)).
    injection H as _ <-. split; [|discriminate].
    intros _. destruct with_vectors; [now left|right]. destruct (axis_words w); [right|left; discriminate].
    destruct (to_end w); discriminate.
Qed.

Example one_move_a_block_instance st p q :
  plan plain_control false false (to_x 5) None None at_start = Got (st, p) ->
  plan plain_control false false (retracting None) None None at_start = Got (st, q) -> p <> None /\ q <> None.
Proof.
  intros P Q. split; [apply (one_move_a_block _ _ _ _ _ _ _ _ _ P)|apply (one_move_a_block _ _ _ _ _ _ _ _ _ Q)]; right;
    [left|right]; discriminate.
Qed.

(** heidenhain.program.direction-without-tcpm: without TCPM the tool is along the tool axis whatever rotary words and tool
    vectors say. *)
Theorem vectors_turn_nothing_without_tcpm {num} {N : Numbers num} (s : klartext_setup num) st words normal tool_vector to :
  tcpm_on (tcpm_of st) = false ->
  direction_at_end s st words normal tool_vector to = along_axis (axis_of_tool (tool_of st)).
Proof. intro O. unfold direction_at_end, tool_direction. now rewrite O. Qed.

Example vectors_turn_nothing_without_tcpm_instance :
  of_length_1 (direction_at_end plain_control at_start [] None (Some (1%R, 0%R, 0%R)) (position at_start)) =
  (0%R, 0%R, 1%R).
Proof. now rewrite vectors_turn_nothing_without_tcpm. Qed.

(** heidenhain.program.tcpm-direction: rotary words and then M128, or M128 and then the words: the tool stands alike. *)
Theorem words_before_or_after_m128 {num} {N : Numbers num} (s : klartext_setup num) center d st words to :
  tcpm_on (tcpm_of st) = false ->
  existsb (fun w => rotary (axis_letter w)) words = true ->
  tool_direction (tcpm_from_here s center (at_end_of_motion to (unknown_axes st) None (with_direction d false st))) =
  direction_at_end s (tcpm_from_here s center st) words None None to.
Proof. intros O W. unfold direction_at_end, tool_direction, tcpm_from_here. cbn. now rewrite O, W. Qed.

Example words_before_or_after_m128_instance :
  let words := [AxisWord Letter.B false (Literal 90%R)] in
  let to := [0%R; 0%R; 0%R; 90%R] in
  tool_direction (tcpm_from_here plain_control false
                    (at_end_of_motion to [] None (with_direction (along_axis Letter.Z) false at_start))) =
  direction_at_end plain_control (tcpm_from_here plain_control false at_start) words None None to.
Proof. now apply words_before_or_after_m128. Qed.

(** heidenhain.program.no-compensation: a straight line without RL and RR ends with the nominal tool where it is programmed,
    whatever the deltas. *)
Theorem without_sides_no_shift {num} {N : Numbers num} (st : klartext_state num) effective direction p d :
  radius_mode st = R0 ->
  way_made (end_without_normal st effective direction p d) = Known (nominal_tip st (of_length_1 direction) p) zero3 None.
Proof. intro O. unfold end_without_normal. now rewrite O. Qed.

Example without_sides_no_shift_instance :
  way_made (end_without_normal at_start None (along_axis Letter.Z) (5%R, 0%R, 0%R) (5%R, 0%R, 0%R)) =
  Known (nominal_tip at_start (0%R, 0%R, 1%R) (5%R, 0%R, 0%R)) zero3 None.
Proof. now apply without_sides_no_shift. Qed.

(** * The tool *)

Definition under_m107 {num} (tool : tool_in_force num) : tool_in_force num :=
  ToolInForce (row_of_tool tool) (programmed_deltas tool) true.

(** heidenhain.tool.oversize-permitted: M107 changes verdicts, never coordinates: a tool that may be used without it is the
    same tool with it. *)
Theorem m107_changes_verdicts_alone {num} {N : Numbers num} (tool : tool_in_force num) contact radius_compensation e :
  usable_tool tool contact radius_compensation = Got e -> usable_tool (under_m107 tool) contact radius_compensation = Got e.
Proof.
  unfold usable_tool, total_deltas, table_row; cbn [row_of_tool programmed_deltas under_m107]. cbv zeta.
  intro H. destruct contact as [a|], (deviations (or_else (row_of_tool tool) tool_of_zeros)) as [points|];
    repeat (apply bound in H; let x := fresh "x" in let E := fresh "E" in destruct H as (x & E & H);
            first [rewrite E | destruct x]; cbn [bind check_oversize under_m107 oversize_permitted]);
    first [exact H | congruence].
Qed.

Example m107_changes_verdicts_alone_instance e :
  let tool := tool_now at_start in
  usable_tool tool None false = Got e -> usable_tool (under_m107 tool) None false = Got e.
Proof. cbv zeta. apply m107_changes_verdicts_alone. Qed.
