(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-offset: G45 to G48 on one axis, what a code undoes, and what stays.

    Every axis of a block goes by itself, so one axis is enough; an arc has two of them. *)
From Coq Require Import Reals Lra Psatz List.
Import ListNotations.
Open Scope R_scope.

(** * Definitions *)

Inductive code := G45 | G46 | G47 | G48.

(** What a code adds to the magnitude of the travel; [l] is the offset value. *)
Definition lengthening c l :=
  match c with G45 => l | G46 => - l | G47 => 2 * l | G48 => - (2 * l) end.

(** The code that takes back what another one adds. *)
Definition opposite c := match c with G45 => G46 | G46 => G45 | G47 => G48 | G48 => G47 end.

(** An axis word; X-0 is not X0. *)
Inductive word :=
| Absolute (p : R)     (* G90 *)
| Incremental (x : R)  (* G91 *)
| MinusZero.           (* G91, a zero with a minus *)

(** The programmed and the actual position of the axis. *)
Record state := State { programmed : R; actual : R }.

Definition shift s := actual s - programmed s.

(** The programmed travel. *)
Definition travel s w :=
  match w with Absolute p => p - programmed s | Incremental x => x | MinusZero => 0 end.

(** The sense of the travel: 1, -1, or 0 where the code does not act. *)
Definition sense s w :=
  if Rlt_dec 0 (travel s w) then 1
  else if Rlt_dec (travel s w) 0 then -1
  else match w with Absolute _ => 0 | Incremental _ => 1 | MinusZero => -1 end.

(** A block of the program: with one of the codes and its value, or without. *)
Inductive block := Offset (c : code) (l : R) (w : word) | Plain (w : word).

Definition step s b :=
  match b with
  | Offset c l w =>
      State (programmed s + travel s w) (actual s + sense s w * (Rabs (travel s w) + lengthening c l))
  | Plain w => State (programmed s + travel s w) (actual s + travel s w)
  end.

Definition run := fold_left step.

(** An arc of the centre word I and the end words X and Y, in the tool's own coordinates from its start: what the
    lengthening [d] makes of each of these words. *)
Definition lengthened d x := if Rle_dec 0 x then x + d else x - d.

Ltac signs := repeat (destruct Rlt_dec; try lra); repeat (destruct Rle_dec; try lra).

(** * The table *)

Lemma sense_travel s w : sense s w * Rabs (travel s w) = travel s w.
Proof.
  unfold sense. destruct (Rlt_dec 0 (travel s w)).
  - rewrite Rabs_right by lra; ring.
  - destruct (Rlt_dec (travel s w) 0).
    + rewrite Rabs_left by lra; ring.
    + replace (travel s w) with 0 by lra. rewrite Rabs_R0; ring.
Qed.

(** fanuc.tool-offset.travel: a positive travel becomes |x| + d, a negative one -(|x| + d). *)
Theorem travel_is_lengthened s c l w : travel s w <> 0 ->
  actual (step s (Offset c l w)) - actual s =
  (if Rlt_dec 0 (travel s w) then 1 else -1) * (Rabs (travel s w) + lengthening c l).
Proof. intro H; cbn; unfold sense; signs. Qed.

(** x = -1000 and a value of -10 under G48: -1020. *)
Example travel_is_lengthened_instance :
  actual (step (State 0 0) (Offset G48 (-10) (Incremental (-1000)))) - 0 = -1020.
Proof.
  pose proof (travel_is_lengthened (State 0 0) G48 (-10) (Incremental (-1000))) as H; cbn in H.
  cbn; rewrite H by lra. rewrite Rabs_left by lra. signs.
Qed.

(** fanuc.tool-offset.shift: a code changes the shift by its lengthening, in the sense of the travel. *)
Theorem shift_of_code s c l w : shift (step s (Offset c l w)) = shift s + sense s w * lengthening c l.
Proof.
  unfold shift; cbn. pose proof (sense_travel s w) as H.
  replace (sense s w * (Rabs (travel s w) + lengthening c l))
    with (sense s w * Rabs (travel s w) + sense s w * lengthening c l) by ring.
  rewrite H; ring.
Qed.

Example shift_of_code_instance : shift (step (State 100 100) (Offset G45 10 (Absolute 150))) = 10.
Proof. rewrite shift_of_code; unfold shift, sense; cbn; signs. Qed.

(** fanuc.tool-offset.increase: a negative value exchanges G45 and G46, and G47 and G48. *)
Theorem negative_value_exchanges_codes s c l w : step s (Offset c (- l) w) = step s (Offset (opposite c) l w).
Proof. destruct c; cbn; repeat f_equal; ring. Qed.

Example negative_value_exchanges_codes_instance :
  actual (step (State 0 0) (Offset G46 (- (10)) (Incremental 1000))) = 1010.
Proof. rewrite negative_value_exchanges_codes; cbn; unfold sense; cbn; rewrite Rabs_right by lra; signs. Qed.

(** fanuc.tool-offset.double: G47 and G48 shift twice as much as G45 and G46. *)
Theorem double_is_twice s l w :
  shift (step s (Offset G47 l w)) - shift s = 2 * (shift (step s (Offset G45 l w)) - shift s) /\
  shift (step s (Offset G48 l w)) - shift s = 2 * (shift (step s (Offset G46 l w)) - shift s).
Proof. rewrite !shift_of_code; cbn; split; ring. Qed.

Example double_is_twice_instance : shift (step (State 0 0) (Offset G47 10 (Incremental 50))) = 20.
Proof.
  destruct (double_is_twice (State 0 0) 10 (Incremental 50)) as [H _].
  assert (Z : shift (State 0 0) = 0) by (unfold shift; cbn; lra).
  assert (E : shift (step (State 0 0) (Offset G45 10 (Incremental 50))) = 10).
  { rewrite shift_of_code, Z. unfold sense; cbn; signs. }
  rewrite Z, E in H; lra.
Qed.

(** fanuc.tool-offset.reversal: a travel that is decreased below zero goes the other way. *)
Theorem decreased_below_zero_reverses s c l w : 0 < travel s w -> Rabs (travel s w) + lengthening c l < 0 ->
  actual (step s (Offset c l w)) < actual s.
Proof. intros P H; cbn; unfold sense; signs. Qed.

(** G46 X2.5 with 3.7, the tool goes to -1.2. *)
Example decreased_below_zero_reverses_instance :
  actual (step (State 0 0) (Offset G46 3.7 (Incremental 2.5))) < 0 /\
  actual (step (State 0 0) (Offset G46 3.7 (Incremental 2.5))) = -1.2.
Proof.
  split.
  - apply (decreased_below_zero_reverses (State 0 0)); cbn; [lra | rewrite Rabs_right; lra].
  - cbn; unfold sense; cbn; rewrite Rabs_right by lra; signs.
Qed.

(** * A travel of zero *)

(** fanuc.tool-offset.zero-travel-absolute: in G90 a position that is already commanded changes nothing. *)
Theorem zero_travel_absolute s c l : step s (Offset c l (Absolute (programmed s))) = s.
Proof.
  destruct s as [p a]; cbn. unfold sense; cbn. replace (p - p) with 0 by ring.
  destruct Rlt_dec; [lra |]. f_equal; ring.
Qed.

Example zero_travel_absolute_instance : step (State 250 250) (Offset G46 10 (Absolute 250)) = State 250 250.
Proof. apply (zero_travel_absolute (State 250 250)). Qed.

(** fanuc.tool-offset.sign-of-zero: in G91 a zero moves by the offset alone, in the sense of the sign that is written. *)
Theorem zero_travel_incremental s c l :
  actual (step s (Offset c l (Incremental 0))) = actual s + lengthening c l /\
  actual (step s (Offset c l MinusZero)) = actual s - lengthening c l.
Proof. cbn; unfold sense; cbn; rewrite Rabs_R0; split; signs. Qed.

Example zero_travel_incremental_instance :
  actual (step (State 0 0) (Offset G46 12.34 (Incremental 0))) = -12.34 /\
  actual (step (State 0 0) (Offset G46 12.34 MinusZero)) = 12.34.
Proof. destruct (zero_travel_incremental (State 0 0) G46 12.34) as [A B]; rewrite A, B; cbn; lra. Qed.

(** fanuc.tool-offset.value: a value of 0 makes a block without the code. *)
Theorem value_zero s c w : step s (Offset c 0 w) = step s (Plain w).
Proof.
  cbn; f_equal. replace (lengthening c 0) with 0 by (destruct c; cbn; ring).
  rewrite Rplus_0_r, sense_travel; reflexivity.
Qed.

Example value_zero_instance : actual (step (State 0 0) (Offset G47 0 (Incremental (-30)))) = -30.
Proof. rewrite value_zero; cbn; lra. Qed.

(** * What a code undoes, and what stays *)

(** fanuc.tool-offset.increase: the opposite code, with the same value and sense, takes the shift back. *)
Theorem opposite_code_restores s c l w w' : let s' := step s (Offset c l w) in
  sense s' w' = sense s w -> shift (step s' (Offset (opposite c) l w')) = shift s.
Proof. intros s' H. rewrite shift_of_code, H. unfold s'. rewrite shift_of_code. destruct c; cbn; ring. Qed.

(** G90 with a value of 10: X150 under G45 goes to 160, X200 to 210, X250 under G46 to 250. *)
Example opposite_code_restores_instance :
  let s := step (State 100 100) (Offset G45 10 (Absolute 150)) in
  shift (step s (Offset (opposite G45) 10 (Absolute 250))) = 0.
Proof.
  intro s. replace 0 with (shift (State 100 100)) by (unfold shift; cbn; lra).
  apply (opposite_code_restores (State 100 100) G45 10 (Absolute 150) (Absolute 250)).
  unfold sense; cbn; signs.
Qed.

(** fanuc.tool-offset.direction: the same code on the way back takes the shift back: contours close. *)
Theorem way_back_restores s c l w w' : let s' := step s (Offset c l w) in
  sense s' w' = - sense s w -> shift (step s' (Offset c l w')) = shift s.
Proof. intros s' H. rewrite shift_of_code, H. unfold s'. rewrite shift_of_code. ring. Qed.

Example way_back_restores_instance :
  let s := step (State 0 0) (Offset G46 10 (Incremental 80)) in shift (step s (Offset G46 10 (Incremental (-80)))) = 0.
Proof.
  intro s. replace 0 with (shift (State 0 0)) by (unfold shift; cbn; lra).
  apply (way_back_restores (State 0 0) G46 10 (Incremental 80) (Incremental (-80))). unfold sense; cbn; signs.
Qed.

Definition is_plain b := match b with Plain _ => true | Offset _ _ _ => false end.

(** fanuc.tool-offset.shift: blocks without a code keep the shift, however many they are. *)
Theorem shift_persists bs : forallb is_plain bs = true -> forall s, shift (run bs s) = shift s.
Proof.
  unfold run; induction bs as [| b bs IH]; intros H s; cbn in *; auto.
  apply andb_prop in H; destruct H as [B R]. rewrite IH by auto.
  destruct b; try discriminate. unfold shift; cbn; ring.
Qed.

Example shift_persists_instance : shift (run [Plain (Absolute 200); Plain (Incremental (-7))] (State 150 160)) = 10.
Proof. rewrite shift_persists by reflexivity; unfold shift; cbn; lra. Qed.

(** fanuc.tool-offset.travel: the same program in G90 and in G91 goes to the same places, zero travels left out. *)
Theorem absolute_is_incremental s c l p : p <> programmed s ->
  step s (Offset c l (Absolute p)) = step s (Offset c l (Incremental (p - programmed s))).
Proof. intro H; cbn; unfold sense; cbn; f_equal; signs. Qed.

Example absolute_is_incremental_instance :
  actual (step (State 100 100) (Offset G45 10 (Absolute 150))) = 160.
Proof. rewrite absolute_is_incremental by (cbn; lra). cbn; unfold sense; cbn; rewrite Rabs_right by lra; signs. Qed.

(** * Arcs *)

(** fanuc.tool-offset.arc: a quarter or three-quarter circle stays one: start and end at R + d from the centre. *)
Theorem arc_keeps_one_radius d i y : i <> 0 -> Rabs y = Rabs i ->
  (lengthened d i)² = (Rabs i + d)² /\
  (lengthened d i - lengthened d i)² + (lengthened d y)² = (Rabs i + d)².
Proof.
  intros H E. rewrite Rminus_eq_0. unfold lengthened.
  assert (A : forall x, (if Rle_dec 0 x then x + d else x - d)² = (Rabs x + d)²).
  { intro x; unfold Rsqr; destruct Rle_dec; [rewrite Rabs_right by lra | rewrite Rabs_left by lra]; ring. }
  rewrite !A, E. unfold Rsqr; split; ring.
Qed.

(** X30 Y-30 I30 with 10: X40 Y-40 I40. *)
Example arc_keeps_one_radius_instance : (lengthened 10 30)² = 40² /\ lengthened 10 (-30) = -40.
Proof.
  split.
  - destruct (arc_keeps_one_radius 10 30 (-30)) as [H _]; [lra | rewrite Rabs_left, Rabs_right; lra |].
    rewrite H, Rabs_right by lra. f_equal; lra.
  - unfold lengthened; signs.
Qed.

(** * The manual's figure *)

Definition figure_x := [
  Offset G46 10 (Incremental 80); Offset G47 10 (Incremental 50); Offset G48 10 (Incremental 40);
  Offset G45 10 (Incremental 30); Offset G45 10 (Incremental 30); Offset G46 10 (Incremental 0);
  Offset G46 10 (Incremental (-30)); Offset G47 10 (Incremental (-120)); Offset G46 10 (Incremental (-80))].

(** The positions after each block of a program. *)
Fixpoint places s bs := match bs with [] => [] | b :: rest => actual (step s b) :: places (step s b) rest end.

Lemma place_of_code s c l x rest : places s (Offset c l (Incremental x) :: rest) =
  actual s + sense s (Incremental x) * (Rabs x + lengthening c l) ::
  places (State (programmed s + x) (actual s + sense s (Incremental x) * (Rabs x + lengthening c l))) rest.
Proof. reflexivity. Qed.

Lemma sense_positive s x : 0 <= x -> sense s (Incremental x) * (Rabs x + 0) = x /\ sense s (Incremental x) = 1.
Proof. intro H; unfold sense; cbn. rewrite Rabs_right by lra. signs. Qed.

Lemma forward s c l x y rest : 0 <= x -> actual s + (x + lengthening c l) = y ->
  places s (Offset c l (Incremental x) :: rest) = y :: places (State (programmed s + x) y) rest.
Proof.
  intros H E. rewrite place_of_code. destruct (sense_positive s x H) as [_ S]. rewrite S, Rabs_right by lra.
  replace (actual s + 1 * (x + lengthening c l)) with y by lra. reflexivity.
Qed.

Lemma backward s c l x y rest : x < 0 -> actual s - (- x + lengthening c l) = y ->
  places s (Offset c l (Incremental x) :: rest) = y :: places (State (programmed s + x) y) rest.
Proof.
  intros H E. rewrite place_of_code.
  assert (S : sense s (Incremental x) = -1) by (unfold sense; cbn; signs). rewrite S, Rabs_left by lra.
  replace (actual s + -1 * (- x + lengthening c l)) with y by lra. reflexivity.
Qed.

(** fanuc.tool-offset.travel: X of the tool in the chapter's figure, a cutter of 20 with D01 = 10; the figure closes. *)
Theorem figure_closes : places (State 0 0) figure_x = [70; 140; 160; 200; 240; 230; 210; 70; 0].
Proof.
  unfold figure_x.
  rewrite (forward _ _ _ _ 70) by (cbn; lra). rewrite (forward _ _ _ _ 140) by (cbn; lra).
  rewrite (forward _ _ _ _ 160) by (cbn; lra). rewrite (forward _ _ _ _ 200) by (cbn; lra).
  rewrite (forward _ _ _ _ 240) by (cbn; lra). rewrite (forward _ _ _ _ 230) by (cbn; lra).
  rewrite (backward _ _ _ _ 210) by (cbn; lra). rewrite (backward _ _ _ _ 70) by (cbn; lra).
  rewrite (backward _ _ _ _ 0) by (cbn; lra). reflexivity.
Qed.

Example figure_closes_instance : nth 8 (places (State 0 0) figure_x) 1 = 0.
Proof. rewrite figure_closes; reflexivity. Qed.
