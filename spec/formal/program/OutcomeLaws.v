(* SPDX-License-Identifier: Apache-2.0 *)
(** What an outcome tells of its parts, what the sign of a real number tells of the number, and lists of events that
    stop: for the laws. *)
From Coq Require Import List String ZArith Bool Reals Lra.
From Toolcomp Require Import Numbers Outcomes.
Import ListNotations.
Open Scope list_scope.

(** * Outcomes *)

Lemma bound {A B} (x : outcome A) (f : A -> outcome B) y : bind x f = Got y -> exists a, x = Got a /\ f a = Got y.
Proof. destruct x; cbn; intro H; try discriminate; eauto. Qed.

Lemma same {A} (a b : A) : Got a = Got b -> a = b.
Proof. now injection 1. Qed.

Lemma no_alarm (condition : bool) number x : alarm_if condition number = Got x -> condition = false.
Proof. now destruct condition. Qed.

Lemma each_got {A B} (f : A -> outcome B) list all : each f list = Got all -> Forall2 (fun a b => f a = Got b) list all.
Proof.
  revert all; induction list as [|a list IH]; intros all H; cbn in H; [apply same in H as <-; constructor|].
  apply bound in H as (b & E & H). apply bound in H as (bs & E' & H). apply same in H as <-. constructor; auto.
Qed.

(** With its result changed. *)
Definition mapped {A B} (f : A -> B) (x : outcome A) : outcome B :=
  match x with Got a => Got (f a) | Alarm number => Alarm number | Undecided clause => Undecided clause end.

(** * Signs of real numbers *)

Lemma decided clause (x : R) c : decide clause x = Got c -> match c with Lt => x < 0 | Eq => x = 0 | Gt => 0 < x end%R.
Proof.
  unfold decide; cbn. unfold real_sign.
  destruct (total_order_T x 0) as [[L|E]|G]; cbn; intro H; apply same in H as <-; auto.
Qed.
Lemma zero_sign clause (x : R) b : is_zero clause x = Got b -> (b = true <-> x = 0%R).
Proof.
  unfold is_zero; intro H. apply bound in H as (c & D & H). apply decided in D. apply same in H as <-.
  destruct c; split; intro; try discriminate; auto; lra.
Qed.
Lemma negative_sign clause (x : R) b : is_negative clause x = Got b -> (b = true <-> (x < 0)%R).
Proof.
  unfold is_negative; intro H. apply bound in H as (c & D & H). apply decided in D. apply same in H as <-.
  destruct c; split; intro; try discriminate; auto; lra.
Qed.
Lemma positive_sign clause (x : R) b : is_positive clause x = Got b -> (b = true <-> (0 < x)%R).
Proof.
  unfold is_positive; intro H. apply bound in H as (c & D & H). apply decided in D. apply same in H as <-.
  destruct c; split; intro; try discriminate; auto; lra.
Qed.

Lemma no_is b P : (b = true <-> P) -> b = false -> ~ P.
Proof. intros H -> X; apply H in X; discriminate. Qed.

(** The other way round: every sign is known. *)
Lemma decides clause (x : R) : exists c, decide clause x = Got c.
Proof. unfold decide; cbn. unfold real_sign. eexists; reflexivity. Qed.
Lemma is_not_zero clause (x : R) : x <> 0%R -> is_zero clause x = Got false.
Proof.
  intro N. unfold is_zero. destruct (decides clause x) as [c D]. rewrite D. apply decided in D. destruct c; auto; lra.
Qed.
Lemma zero_is_zero clause : is_zero clause 0%R = Got true.
Proof.
  unfold is_zero. destruct (decides clause 0%R) as [c D]. rewrite D. apply decided in D. destruct c; auto; lra.
Qed.

Lemma not_negative clause (x : R) : ~ (x < 0)%R -> is_negative clause x = Got false.
Proof.
  intro N. unfold is_negative. destruct (decides clause x) as [c D]. rewrite D. apply decided in D.
  destruct c; auto; lra.
Qed.
Lemma not_positive clause (x : R) : ~ (0 < x)%R -> is_positive clause x = Got false.
Proof.
  intro N. unfold is_positive. destruct (decides clause x) as [c D]. rewrite D. apply decided in D.
  destruct c; auto; lra.
Qed.

Lemma zero_either_way clause (x : R) : is_zero clause (- x)%R = is_zero clause x.
Proof.
  unfold is_zero. destruct (decides clause (- x)%R) as [c C], (decides clause x) as [c' C']. rewrite C, C'.
  apply decided in C, C'. destruct c, c'; try reflexivity; lra.
Qed.

(** Without its sign. *)
Lemma magnitude_is clause {A} (f : R -> outcome A) (x : R) :
  bind (is_negative clause x) (fun negative => f (if negative then (- x)%num else x)) = f (Rabs x).
Proof.
  destruct (Rlt_dec x 0) as [L|L].
  - assert (N : is_negative clause x = Got true).
    { unfold is_negative. destruct (decides clause x) as [c C]. rewrite C. apply decided in C.
      destruct c; try reflexivity; lra. }
    rewrite N. cbn [bind]. f_equal. rewrite Rabs_left by exact L. cbn. ring.
  - rewrite (not_negative clause x L). cbn [bind]. f_equal. rewrite Rabs_pos_eq; [reflexivity|lra].
Qed.

(** * Events *)

(** Behind the first that ends a run there is nothing. *)
Fixpoint nothing_behind {A} (final : A -> bool) (events : list A) : Prop :=
  match events with
  | [] => True
  | e :: rest => (final e = false /\ nothing_behind final rest) \/ rest = []
  end.

Lemma nothing_behind_app {A} (final : A -> bool) ahead rest :
  existsb final ahead = false -> nothing_behind final rest -> nothing_behind final (ahead ++ rest).
Proof.
  induction ahead as [|e ahead IH]; cbn; intros O L; [assumption|].
  apply orb_false_elim in O as [O O']; left; auto.
Qed.
