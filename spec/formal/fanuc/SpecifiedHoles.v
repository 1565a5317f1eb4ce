(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/canned-cycle: the holes of program/, over the real numbers, are those of the definitions. *)
From Coq Require Import Reals Lra Lia List ZArith Bool.
From Toolcomp Require Import CannedCycle OutcomeLaws.
From Toolcomp Require Numbers Outcomes Words Codes CycleState State Movements DrillingCycle ProgramLaws.
Import ListNotations.
Open Scope R_scope.

(** * Definitions *)

Definition as_word (l : CycleState.level R) : word :=
  match l with CycleState.Coordinate x => Absolute x | CycleState.Distance d => Incremental d end.
Definition as_position (travels : bool) (x : R) : word := if travels then Incremental x else Absolute x.
Definition as_code (to_point_r : bool) : return_code := if to_point_r then G99 else G98.

(** The mode of a state, with where its drilling axis stands. *)
Definition as_mode s (st : State.state R) (d : CycleState.drilling_mode R) : mode :=
  Mode (State.value_on s (State.programmed st) (CycleState.drilling_axis d) + CycleState.rise d)
    (option_map as_word (CycleState.point_r d)) (option_map as_word (CycleState.bottom d)).

Lemma level_is_from base l : DrillingCycle.level_from base l = from base (option_map as_word l).
Proof. now destruct l as [[?|?]|]. Qed.

(** * Levels and places *)

(** fanuc.canned-cycle.return: every hole of a block has point R, the bottom and the return level of the definitions, by
    the data that the block leaves, with the shift of the drilling axis. *)
Theorem levels_are_levels s c numbers st d h : CycleState.drilling (State.cycle st) = Some d ->
  In h (snd (DrillingCycle.cycle_step s c true numbers st)) ->
  let m := as_mode s st (DrillingCycle.with_data s c numbers d) in
  let shifted y := y + State.value_on s (State.shift st) (CycleState.drilling_axis d) in
  Outcomes.point_r_level h = shifted (point_r m) /\ Outcomes.bottom_level h = shifted (bottom m) /\
  Outcomes.return_level h = shifted (return_level (as_code (CycleState.to_point_r (State.cycle st))) m).
Proof.
  intros D I. unfold DrillingCycle.cycle_step in I. rewrite D in I.
  destruct (DrillingCycle.hole_count (State.block_of c)) as [n|]; [|contradiction].
  cbv zeta in I. destruct (DrillingCycle.hole_places _ _ _ _) as [|p ps]; [contradiction|].
  cbn [snd] in I. apply in_map_iff in I as (q & <- & _). cbn. unfold bottom, point_r, as_mode; cbn.
  rewrite !level_is_from. repeat split. now destruct (CycleState.to_point_r (State.cycle st)).
Qed.

Definition drilling_setup := ProgramLaws.plain_setup.
(** G81 X10 R2, where Z stands at 0. *)
Definition two_up : State.command R :=
  State.Command (Words.Block [ProgramLaws.natural Words.Letter.X 10; ProgramLaws.natural Words.Letter.R 2] None) [810%Z]
    None (Codes.initial_modes false) None None [] [] [].
Definition begun : State.state R :=
  State.with_cycle (State.initial drilling_setup)
    (CycleState.CycleState (Some (CycleState.DrillingMode 810 Words.Letter.Z 0 None None None)) true).

Example levels_are_levels_instance h :
  In h (snd (DrillingCycle.cycle_step drilling_setup two_up true [Some 10; None; None] begun)) ->
  Outcomes.point_r_level h = 2 /\ Outcomes.return_level h = 2.
Proof.
  intro I. apply (levels_are_levels _ _ _ begun (CycleState.DrillingMode 810 Words.Letter.Z 0 None None None) h eq_refl)
    in I as (P & _ & B). rewrite P, B. cbn.
  unfold point_r; cbn. split; lra.
Qed.

(** fanuc.canned-cycle.position: on every axis of the position the holes are in the places of the definitions. *)
Theorem places_are_places travels numbers count axis : forall here, (axis < length here)%nat ->
  (length here <= length numbers)%nat ->
  map (fun p => nth axis p 0) (DrillingCycle.hole_places travels numbers count here) =
  places (nth axis here 0) (option_map (as_position travels) (nth axis numbers None)) count.
Proof.
  assert (ONE : forall here numbers axis, (axis < length here)%nat -> (length here <= length numbers)%nat ->
    nth axis (Movements.destination travels here numbers) 0 =
    from (nth axis here 0) (option_map (as_position travels) (nth axis numbers None))).
  { induction here as [|x here IH]; intros [|w numbers'] axis' L L'; cbn in L, L'; try lia.
    destruct axis' as [|axis']; [|exact (IH numbers' axis' ltac:(lia) ltac:(lia))]. cbn. now destruct w, travels. }
  assert (LENGTH : forall (here : list R) (numbers : list (option R)), (length here <= length numbers)%nat ->
    length (Movements.destination travels here numbers) = length here).
  { induction here as [|x here IH]; intros [|w numbers'] L; cbn in *; try lia. f_equal. apply IH. lia. }
  induction count as [|count IH]; intros here L L'; [reflexivity|]. cbn [DrillingCycle.hole_places map places].
  rewrite IH by (rewrite LENGTH; lia). now rewrite ONE.
Qed.

Example places_are_places_instance :
  map (fun p => nth 0 p 0) (DrillingCycle.hole_places true [Some 10; None; None] 2 [100; 20; 50]) =
  places 100 (Some (Incremental 10)) 2.
Proof. apply (places_are_places true [Some 10; None; None] 2 0); cbn; lia. Qed.
