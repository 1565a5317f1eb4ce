(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-length-offset: G43, G44 and G49 as shifts of single axes, and the laws of such shifts.

    An offset is chosen for an axis by type A, B or C; here the choice is made and the axis is given. *)
From Coq Require Import Reals Lra List.
Import ListNotations.
Open Scope R_scope.

(** * Definitions *)

Inductive axis := X | Y | Z.

Definition axis_eq (a b : axis) : {a = b} + {a <> b}.
Proof. decide equality. Defined.

(** The direction of the shift: G43 adds the offset value, G44 subtracts it. *)
Inductive direction := G43 | G44.

Definition signed g v := match g with G43 => v | G44 => - v end.

(** One effect of a block on one axis; a block is a list of them. *)
Inductive command :=
| Absolute (a : axis) (p : R)                (* G90: an axis word *)
| Incremental (a : axis) (t : R)             (* G91: an axis word *)
| Offset (g : direction) (a : axis) (v : R)  (* G43 or G44 with the value v of H, or H alone *)
| CancelAll                                  (* G49 *)
| CancelAxis (a : axis)                      (* H0; G53, G28, G30 or G30.1 naming the axis *)
| Restore (g : direction) (v : R).           (* the vector comes back after G53, G28, G30 or G30.1 *)

(** The programmed position, the offset vector, and the axis that was offset last. *)
Record state := State { programmed : axis -> R; offset : axis -> R; last : option axis }.

Definition set (f : axis -> R) a v b := if axis_eq a b then v else f b.

Definition step s c :=
  match c with
  | Absolute a p => State (set (programmed s) a p) (offset s) (last s)
  | Incremental a t => State (set (programmed s) a (programmed s a + t)) (offset s) (last s)
  | Offset g a v => State (programmed s) (set (offset s) a (signed g v)) (Some a)
  | CancelAll => State (programmed s) (fun _ => 0) (last s)
  | CancelAxis a => State (programmed s) (set (offset s) a 0) (last s)
  | Restore g v =>
      match last s with
      | Some a => State (programmed s) (set (offset s) a (signed g v)) (last s)
      | None => s
      end
  end.

Definition run := fold_left step.

(** What the axes are sent to. *)
Definition target s a := programmed s a + offset s a.

(** States that no later block can tell apart. *)
Definition same s s' :=
  (forall a, programmed s a = programmed s' a) /\ (forall a, offset s a = offset s' a) /\ last s = last s'.

Definition is_motion c := match c with Absolute _ _ | Incremental _ _ => true | _ => false end.

(** The program without any offset command. *)
Definition motions := filter is_motion.

(** The same program in incremental words, written for a start at [s]. *)
Fixpoint incremental s cs :=
  match cs with
  | [] => []
  | Absolute a p :: rest => Incremental a (p - programmed s a) :: incremental (step s (Absolute a p)) rest
  | c :: rest => c :: incremental (step s c) rest
  end.

Ltac cases := unfold target; cbn; unfold set; cbn; repeat destruct axis_eq; subst; try congruence; try lra; auto.

(** * The offset vector *)

(** fanuc.length-offset.direction: the axis is sent to the programmed position plus (G43) or minus (G44) the offset value. *)
Theorem target_of_offset s g a v : target (step s (Offset g a v)) a = programmed s a + signed g v.
Proof. cases. Qed.

(** H1 = 20: programmed 100, sent to 120. *)
Example target_of_offset_instance :
  target (step (State (fun _ => 100) (fun _ => 0) None) (Offset G43 Z 20)) Z = 120.
Proof. rewrite target_of_offset; cbn; lra. Qed.

(** fanuc.length-offset.replaces: a new offset value replaces the old one, it is not added. *)
Theorem offset_replaces s g g' a v v' : same (step (step s (Offset g a v)) (Offset g' a v')) (step s (Offset g' a v')).
Proof. repeat split; intros; cases. Qed.

(** H1 = 20, then H2 = 30 at the same position: a move of 10 to 130, not to 150. *)
Example offset_replaces_instance :
  let s := step (State (fun _ => 100) (fun _ => 0) None) (Offset G43 Z 20) in
  target (step s (Offset G43 Z 30)) Z = 130 /\ target (step s (Offset G43 Z 30)) Z - target s Z = 10.
Proof.
  intro s; subst s.
  pose proof (offset_replaces (State (fun _ => 100) (fun _ => 0) None) G43 G43 Z 20 30) as (_ & E & _).
  specialize (E Z). unfold target. rewrite E. split; cases.
Qed.

(** fanuc.length-offset.direction: G44 with a value is G43 with its negative. *)
Theorem G44_is_G43_of_negative s a v : step s (Offset G44 a v) = step s (Offset G43 a (- v)).
Proof. reflexivity. Qed.

Example G44_is_G43_of_negative_instance :
  target (step (State (fun _ => -30) (fun _ => 0) None) (Offset G44 Z 7)) Z = -37.
Proof. rewrite G44_is_G43_of_negative; cases. Qed.

(** fanuc.length-offset.type-b: the offsets of two axes do not disturb one another, in whichever order they are given. *)
Theorem axes_commute s g h a b v w : a <> b -> forall c,
  target (run [Offset g a v; Offset h b w] s) c = target (run [Offset h b w; Offset g a v] s) c.
Proof. intros H c; cases. Qed.

Example axes_commute_instance s :
  target (run [Offset G43 X 4; Offset G43 Y 2] s) X = target (run [Offset G43 Y 2; Offset G43 X 4] s) X.
Proof. apply axes_commute; discriminate. Qed.

(** * Cancellation *)

Lemma run_app p q s : run (p ++ q) s = run q (run p s).
Proof. apply fold_left_app. Qed.

Lemma programmed_extensional c s s' : (forall a, programmed s a = programmed s' a) ->
  forall a, programmed (step s c) a = programmed (step s' c) a.
Proof. intros H a; destruct c; cbn; auto; try (cases; rewrite H; lra); destruct (last s), (last s'); cbn; auto. Qed.

Lemma programmed_by_motions p : forall s s', (forall a, programmed s a = programmed s' a) ->
  forall a, programmed (run p s) a = programmed (run (motions p) s') a.
Proof.
  unfold run; induction p as [| c p IH]; intros s s' H a; cbn; auto.
  destruct c; cbn [is_motion]; cbn [fold_left]; try (apply IH; intro; apply programmed_extensional, H).
  all: apply IH; intro b; cbn; try destruct (last s); cbn; apply H.
Qed.

(** fanuc.length-offset.cancel: whatever offsets a program used, after G49 the axes are where they would be without them. *)
Theorem cancel_restores p s a : target (run (p ++ [CancelAll]) s) a = programmed (run (motions p) s) a.
Proof.
  rewrite run_app; unfold target; cbn. rewrite Rplus_0_r. apply programmed_by_motions; reflexivity.
Qed.

Example cancel_restores_instance s :
  target (run ([Offset G43 Z 20; Absolute Z 100; Offset G43 Z 30] ++ [CancelAll]) s) Z = 100.
Proof. rewrite cancel_restores; cases. Qed.

(** fanuc.length-offset.cancel: H0 clears the offset of its axis and of no other. *)
Theorem cancel_axis s a b :
  offset (step s (CancelAxis a)) b = if axis_eq a b then 0 else offset s b.
Proof. cases. Qed.

Example cancel_axis_instance : let s := State (fun _ => 0) (fun a => match a with X => 4 | Y => 0 | Z => 20 end) (Some Z) in
  offset (step s (CancelAxis Z)) X = 4 /\ offset (step s (CancelAxis Z)) Z = 0.
Proof. intro s; rewrite !cancel_axis; cases. Qed.

(** * Motion under an offset *)

Lemma run_motions p : forallb is_motion p = true -> forall s, offset (run p s) = offset s.
Proof.
  unfold run; induction p as [| c p IH]; intros H s; cbn in *; auto.
  apply andb_prop in H; destruct H as [C P]; rewrite IH by auto. destruct c; try discriminate; reflexivity.
Qed.

(** fanuc.length-offset.direction: while no offset command comes, the whole path is shifted by one fixed vector. *)
Theorem offset_is_translation p s a : forallb is_motion p = true ->
  target (run p s) a - programmed (run p s) a = target s a - programmed s a.
Proof. intro H; unfold target; rewrite run_motions by auto; lra. Qed.

Example offset_is_translation_instance :
  let s := State (fun _ => 0) (fun a => match a with Z => -4 | _ => 0 end) (Some Z) in
  let s' := run [Incremental Z (-21); Incremental X 30; Incremental Z 21] s in
  target s' Z - programmed s' Z = target s Z - programmed s Z.
Proof. intros s s'; apply offset_is_translation; reflexivity. Qed.

Lemma same_refl s : same s s.
Proof. repeat split. Qed.

Lemma same_trans s t u : same s t -> same t u -> same s u.
Proof. intros (A & B & C) (D & E & F); repeat split; intros; congruence. Qed.

Lemma step_same c s s' : same s s' -> same (step s c) (step s' c).
Proof.
  intros (P & O & L). unfold same. destruct c; cbn; unfold set; try (rewrite L; destruct (last s') eqn:E; cbn);
    repeat split; intros; try destruct axis_eq; rewrite ?P, ?O; auto; congruence.
Qed.

Lemma run_same p : forall s s', same s s' -> same (run p s) (run p s').
Proof. unfold run; induction p; intros s s' H; cbn; auto using step_same. Qed.

Lemma incremental_same p : forall s t, same s t -> same (run (incremental s p) t) (run p s).
Proof.
  induction p as [| c p IH]; intros s t H; [destruct H as (A & B & C); repeat split; auto |].
  assert (K : same (step s c) (step t c)) by (apply step_same, H).
  destruct c; cbn [incremental run fold_left]; try (apply IH; exact K).
  apply IH. destruct H as (P & O & L); repeat split; cbn; auto; intro b. cases. rewrite P; lra.
Qed.

(** fanuc.length-offset.direction: a program in G90 and the same program in G91 send the axes to the same places. *)
Theorem absolute_is_incremental p s a : target (run (incremental s p) s) a = target (run p s) a.
Proof.
  destruct (incremental_same p s s (same_refl s)) as (P & O & _); unfold target; rewrite P, O; reflexivity.
Qed.

Example absolute_is_incremental_instance :
  let s := State (fun _ => 0) (fun _ => 0) None in
  run [Offset G43 Z 5; Incremental Z (-10 - 0); Offset G43 Z 8; Incremental Z (-20 - -10)] s =
    run (incremental s [Offset G43 Z 5; Absolute Z (-10); Offset G43 Z 8; Absolute Z (-20)]) s /\
  target (run (incremental s [Offset G43 Z 5; Absolute Z (-10); Offset G43 Z 8; Absolute Z (-20)]) s) Z = -12.
Proof. intro s; split; [reflexivity |]. rewrite absolute_is_incremental; subst s; cases. Qed.

(** * Restoration after G53, G28, G30 and G30.1 *)

Lemma cancel_axes_last named s : last (run (map CancelAxis named) s) = last s.
Proof. revert s; unfold run; induction named; intro s; cbn; auto. rewrite IHnamed; reflexivity. Qed.

Lemma cancel_axes_offset named : forall s a,
  offset (run (map CancelAxis named) s) a = if in_dec axis_eq a named then 0 else offset s a.
Proof.
  unfold run; induction named as [| b named IH]; intros s a; cbn [map fold_left]; auto.
  rewrite IH. cbn [step offset]. unfold set.
  destruct (in_dec axis_eq a named), (in_dec axis_eq a (b :: named)), (axis_eq b a); cbn in *; auto; exfalso; intuition.
Qed.

(** fanuc.length-offset.restored-last-only: of the axes that a reference return cancelled only the one offset last comes back. *)
Theorem only_last_restored named s a b g v : last s = Some b ->
  offset (run (map CancelAxis named ++ [Restore g v]) s) a =
  if axis_eq b a then signed g v else if in_dec axis_eq a named then 0 else offset s a.
Proof.
  intro H. rewrite run_app. cbn [run fold_left step]. rewrite cancel_axes_last, H. cbn [offset]. unfold set.
  destruct axis_eq; auto. apply cancel_axes_offset.
Qed.

(** X offset 4 first, Z offset 20 last; G28 names both; afterwards Z has its offset again and X has none. *)
Example only_last_restored_instance :
  let s := run [Offset G43 X 4; Offset G43 Z 20] (State (fun _ => 0) (fun _ => 0) None) in
  let s' := run (map CancelAxis [X; Z] ++ [Restore G43 20]) s in
  offset s' Z = 20 /\ offset s' X = 0.
Proof. intros s s'; subst s'; rewrite !(only_last_restored [X; Z] s _ Z) by reflexivity; cbn; auto. Qed.

(** * The manual's three holes *)

(** fanuc.length-offset.direction: the positions of Z in the chapter's boring program with H1 = -4 and a start at 0. *)
Theorem three_holes :
  let n2 := [Offset G43 Z (-4); Incremental Z (-32)] in
  let n3 := n2 ++ [Incremental Z (-21)] in
  let n5 := n3 ++ [Incremental Z 21] in
  let n7 := n5 ++ [Incremental Z (-41)] in
  let n8 := n7 ++ [Incremental Z 41] in
  let n10 := n8 ++ [Incremental Z (-25)] in
  let n12 := n10 ++ [Incremental Z 57; CancelAxis Z] in
  map (fun p => target (run p (State (fun _ => 0) (fun _ => 0) None)) Z) [n2; n3; n5; n7; n8; n10; n12] =
  [-36; -57; -36; -77; -36; -61; 0].
Proof. cbn; unfold target, set; cbn; repeat (apply f_equal2; [lra |]); reflexivity. Qed.

Example three_holes_instance :
  target (run [Offset G43 Z (-4); Incremental Z (-32)] (State (fun _ => 0) (fun _ => 0) None)) Z = -36.
Proof. pose proof three_holes as H; cbn in H; injection H as H _ _ _ _ _ _; exact H. Qed.
