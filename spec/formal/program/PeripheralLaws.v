(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of peripheral milling in a Klartext run: directions, junctions, sides, and the look-ahead. *)
From Coq Require Import List String ZArith Bool Reals Lra Psatz.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool KlartextFace.
From Toolcomp Require Import KlartextPeripheral KlartextState KlartextMoves KlartextProgram OutcomeLaws KlartextLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * Directions *)

Lemma own_direction_is (left : bool) (t d c : triple R) : own_direction left t d = Got (Some c) ->
  exists k, c = scale3 k (cross3 t d) /\ (k * k * dot3 (cross3 t d) (cross3 t d) = 1)%R.
Proof.
  unfold own_direction; intro H. apply bound in H as (nothing & Z & H). apply zero_sign in Z.
  destruct nothing; [discriminate|]. apply same in H. injection H as <-. eexists; split; [reflexivity|].
  set (q := dot3 (cross3 t d) (cross3 t d)) in *.
  assert (P : (0 < q)%R).
  { assert (N : (0 <= q)%R) by (unfold q; destruct (cross3 t d) as [[x y] z]; unfold dot3; cbn; nra).
    assert (q <> 0%R) by (intro E; apply Z in E; discriminate). lra. }
  cbn. assert (S : (sqrt q * sqrt q = q)%R) by (apply sqrt_sqrt; lra).
  assert (sqrt q <> 0%R) by (intro E; rewrite E in S; lra).
  transitivity (((if left then 1 else 0 - 1) * (if left then 1 else 0 - 1)) * (q / (sqrt q * sqrt q)))%R; [field;
    auto|].
  rewrite S. destruct left; field; lra.
Qed.

(** heidenhain.peripheral.direction: the direction of a block is at right angles to tool and movement, and of length 1.
    *)
Theorem direction_across_tool_and_movement left (t d c : triple R) : own_direction left t d = Got (Some c) ->
  dot3 c t = 0%R /\ dot3 c d = 0%R /\ dot3 c c = 1%R.
Proof.
  intro H. apply own_direction_is in H as (k & -> & K). destruct t as [[a b] e], d as [[x y] z].
  unfold scale3, cross3, dot3 in *; cbn in *. repeat split; try ring. rewrite <- K. ring.
Qed.

Example direction_across_tool_and_movement_instance c :
  own_direction true (3, 0, 4)%R (0, 7, 0)%R = Got (Some c) -> dot3 c (3, 0, 4)%R = 0%R.
Proof. intro H. now apply direction_across_tool_and_movement in H. Qed.

(** heidenhain.peripheral.mitre: between two compensated blocks the tool is across the tool axis there and at the
    distance of the offset from both blocks: along the direction of each it is just as far. *)
Theorem junction_keeps_distance (l : lateral R) made (n : following R) left d' c c' at_end last :
  next_left n = Some left -> own_direction (left_side l) (tool_at_end l) (movement l) = Got (Some c) ->
  next_movement n = Some d' -> own_direction left (tool_at_end l) d' = Got (Some c') ->
  beside_end l (Some made) (Some n) = Got (at_end, last) ->
  dot3 at_end (tool_at_end l) = 0%R /\ dot3 at_end c = 1%R /\ dot3 at_end c' = 1%R.
Proof.
  intros L C D C' H. unfold beside_end, direction_or_last in H. rewrite L, C in H. cbn [bind given or_else] in H.
  rewrite D, C' in H.
  cbn [bind] in H. apply bound in H as (m & M & H). apply same in H. injection H as -> _.
  apply direction_across_tool_and_movement in C as (T & _ & U), C' as (T' & _ & U').
  unfold mitre in M. apply bound in M as (opposite & O & M). apply zero_sign in O. apply bound in M as (u & A & M).
  apply no_alarm in A.
  apply same in M as <-. destruct c as [[x y] z], c' as [[x' y'] z'], (tool_at_end l) as [[a b] e].
  unfold scale3, add3, dot3 in *; cbn in *. set (k := (1 + (x * x' + y * y' + z * z'))%R) in *.
  assert (K : k <> 0%R) by (intro E; apply O in E; rewrite E in A; discriminate). repeat split.
  - transitivity (/ k * ((x * a + y * b + z * e) + (x' * a + y' * b + z' * e)))%R; [field; exact K|rewrite T, T'; ring].
  - transitivity (/ k * ((x * x + y * y + z * z) + (x * x' + y * y' + z * z')))%R; [field; exact K|rewrite U; fold k].
    transitivity (/ k * k)%R; [reflexivity|now apply Rinv_l].
  - transitivity (/ k * ((x' * x' + y' * y' + z' * z') + (x * x' + y * y' + z * z')))%R; [field; exact K|rewrite U';
      fold k].
    transitivity (/ k * k)%R; [reflexivity|now apply Rinv_l].
Qed.

Example junction_keeps_distance_instance made c c' at_end last :
  let l := Lateral true (0, 0, 1)%R (5, 0, 0)%R in let n := Following (Some (0, 5, 0)%R) (Some true) in
  own_direction true (0, 0, 1)%R (5, 0, 0)%R = Got (Some c) ->
    own_direction true (0, 0, 1)%R (0, 5, 0)%R = Got (Some c') ->
  beside_end l (Some made) (Some n) = Got (at_end, last) -> dot3 at_end c = 1%R.
Proof.
  intros l n C C' H. now apply (junction_keeps_distance l made n true _ c c' at_end last eq_refl C eq_refl C') in H.
Qed.

(** * Sides *)

Definition opposite (v : triple R) : triple R := scale3 (- (1))%R v.

Lemma opposite_direction left (t d : triple R) c : own_direction left t d = Got c ->
  own_direction (negb left) t d = Got (option_map opposite c).
Proof.
  unfold own_direction; intro H. apply bound in H as (nothing & Z & H). rewrite Z. cbn [bind].
  destruct nothing; apply same in H as <-; [reflexivity|]. cbn [option_map]. do 2 f_equal. unfold opposite.
  destruct (cross3 t d) as [[x y] z]. unfold scale3.
  destruct left; cbn; unfold Rdiv; (f_equal; [f_equal|]; ring).
Qed.

Lemma directions_decided left (t d : triple R) : exists c, own_direction left t d = Got c.
Proof.
  unfold own_direction, is_zero. destruct (decides "heidenhain.peripheral.direction" (dot3 (cross3 t d) (cross3 t d)))
    as [c D].
  rewrite D. cbn. destruct c; eauto.
Qed.

Definition turned_made (m : option (triple R)) : option (triple R) := option_map opposite m.
Lemma opposite_or_last left t d made : direction_or_last (negb left) t d (turned_made made) =
  mapped opposite (direction_or_last left t d made).
Proof.
  unfold direction_or_last. destruct (directions_decided left t d) as [c C]. rewrite C, (opposite_direction _ _ _ _ C).
  destruct c, made; reflexivity.
Qed.

Lemma opposite_mitre (c c' : triple R) : mitre (opposite c) (opposite c') = mapped opposite (mitre c c').
Proof.
  unfold mitre. replace (dot3 (opposite c) (opposite c')) with (dot3 c c').
  2: { destruct c as [[x y] z], c' as [[a b] e]. unfold opposite, scale3, dot3; cbn. ring. }
  destruct (is_zero "heidenhain.peripheral.reversal" (1 + dot3 c c')%num) as [[]| |]; try reflexivity.
  cbn [bind alarm_if mapped].
  f_equal. set (k := (1 / (1 + dot3 c c'))%num). destruct c as [[x y] z], c' as [[a b] e].
  unfold opposite, scale3, add3; cbn. f_equal; [f_equal|]; ring.
Qed.

Definition turned_lateral (l : lateral R) : lateral R := Lateral (negb (left_side l)) (tool_at_end l) (movement l).
Definition turned_next (n : option (following R)) : option (following R) :=
  option_map (fun n => Following (next_movement n) (option_map negb (next_left n))) n.

Lemma turned_end l prior next : beside_end (turned_lateral l) (option_map turned_made prior) (turned_next next) =
  mapped (fun p => (opposite (fst p), opposite (snd p))) (beside_end l prior next).
Proof.
  unfold beside_end, turned_lateral. cbn [left_side tool_at_end movement].
  assert (OWN : forall made, direction_or_last (negb (left_side l)) (tool_at_end l) (movement l) (turned_made made) =
    mapped opposite (direction_or_last (left_side l) (tool_at_end l) (movement l) made)) by (intro;
      apply opposite_or_last).
  assert (NEXT : forall (n : following R) d made,
    direction_or_last (or_else (option_map negb (next_left n)) (negb (left_side l))) (tool_at_end l) d (turned_made made) =
    mapped opposite (direction_or_last (or_else (next_left n) (left_side l)) (tool_at_end l) d made)).
  { intros n d made. destruct (next_left n); cbn [option_map or_else]; apply opposite_or_last. }
  destruct prior as [made|], next as [n|]; cbn [option_map turned_next next_movement next_left].
  - rewrite OWN. destruct (direction_or_last (left_side l) (tool_at_end l) (movement l) made) as [c| |];
      try reflexivity.
    cbn [mapped bind]. replace (given (option_map negb (next_left n))) with (given (next_left n)) by now
      destruct (next_left n).
    destruct (given (next_left n)); [|reflexivity]. change (Some (opposite c)) with (turned_made (Some c)).
    destruct (next_movement n) as [d|]; [|reflexivity]. rewrite NEXT.
    destruct (direction_or_last _ _ d (Some c)) as [c'| |]; try reflexivity.
    cbn [mapped bind].
    rewrite opposite_mitre. now destruct (mitre c c').
  - rewrite OWN. now destruct (direction_or_last _ _ (movement l) made).
  - destruct (next_movement n) as [d|]; [|reflexivity]. change None with (turned_made None) at 1. rewrite NEXT.
    now destruct (direction_or_last _ _ d None).
  - change None with (turned_made None) at 1. rewrite OWN. now destruct (direction_or_last _ _ (movement l) None).
Qed.

(** RL for RR and RR for RL, with negative radii. *)
Definition turned_way (w : way R) : way R :=
  match w with
  | Beside nominal l by_delta by_radius => Beside nominal (turned_lateral l) (- by_delta)%R (- by_radius)%R
  | w => w
  end.
Definition turned_item (i : item R) : item R :=
  match i with
  | Moving place p => Moving place (Planned (warnings p) (motion_of p) (turned_way (way_of p)))
  | i => i
  end.

(** heidenhain.peripheral.side: RL with the negative radius is RR: a whole run with the sides exchanged and the radii
    negated gives the same events. *)
Theorem exchanged_sides_same_events (s : klartext_setup R) items prior :
  events_of s (map turned_item items) (option_map turned_made prior) = events_of s items prior.
Proof.
  revert prior; induction items as [|[place p|place d|place es] items IH]; intro prior; [reflexivity| | |reflexivity].
  cbn [map turned_item events_of way_of warnings motion_of]. destruct (way_of p) as [tip shift touch|nominal l by_delta
    by_radius|]; cbn [turned_way].
  - rewrite <- (IH None). replace (given (option_map turned_made prior)) with (given prior) by now destruct prior.
    reflexivity.
  - assert (F : following_of (map turned_item items) = turned_next (following_of items)).
    { destruct items as [|[place' p'|place' d'|place' es'] rest]; try reflexivity. cbn. now destruct (way_of p'). }
    rewrite F, turned_end. destruct (beside_end l prior (following_of items)) as [[beside made]| |]; try reflexivity.
    cbn [mapped fst snd]. rewrite <- (IH (Some (Some made))).
    replace (given (option_map turned_made prior)) with (given prior) by now destruct prior.
    assert (E : forall k, scale3 (- k)%R (opposite beside) = scale3 k beside).
    { intro k. destruct beside as [[x y] z]. unfold opposite, scale3; cbn. f_equal; [f_equal|]; ring. }
    now rewrite !E.
  - rewrite <- (IH None). reflexivity.
  - cbn [map turned_item events_of]. f_equal. apply (IH None).
Qed.

Definition plain_motion : motion R :=
  Motion false None (Ending [5; 0; 0; 0]%R [] (Some (5, 0, 0)%R)) [] (0, 0, 1)%R 0%R None 1%R.
Definition beside_block : planned R :=
  Planned [] plain_motion (Beside (5, 0, 0)%R (Lateral true (0, 0, 1)%R (5, 0, 0)%R) 6%R 6%R).

Example exchanged_sides_same_events_instance :
  events_of plain_control (map turned_item [Moving 0 beside_block; Moving 1 beside_block]) None =
  events_of plain_control [Moving 0 beside_block; Moving 1 beside_block] None.
Proof. apply (exchanged_sides_same_events plain_control _ None). Qed.

(** * The look-ahead *)

(** heidenhain.peripheral.first-block: a block depends on the next one that moves, and on none behind that. *)
Theorem peripheral_looks_one_block_ahead {num} {N : Numbers num} (s : klartext_setup num) place p next prior :
  exists here goes_on made, forall more,
    events_of s (Moving place p :: next :: more) prior = here ++ (if goes_on : bool then events_of s (next ::
      more) made else []).
Proof.
  cbn [events_of].
  assert (F : forall more, following_of (next :: more) = following_of [next]) by (intro; destruct next; reflexivity).
  destruct (way_of p) as [tip shift touch|nominal l by_delta by_radius|].
  - eexists _, true, None. intro more. reflexivity.
  - destruct (beside_end l prior (following_of [next])) as [[beside made]|number|clause] eqn:E;
      [eexists _, true, (Some (Some made))|eexists (map (pair place) (end_in (A := unit) (Alarm number))), false, None
      |eexists (map (pair place) (end_in (A := unit) (Undecided clause))), false, None]; intro more; rewrite F, E;
      try reflexivity.
  - eexists _, true, None. intro more. reflexivity.
Qed.

Example peripheral_looks_one_block_ahead_instance : exists here goes_on made, forall more,
  events_of plain_control (Moving 0 beside_block :: Moving 1 beside_block :: more) None =
  here ++ (if goes_on : bool then events_of plain_control (Moving 1 beside_block :: more) made else []).
Proof. apply peripheral_looks_one_block_ahead. Qed.
