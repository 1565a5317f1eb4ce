(* SPDX-License-Identifier: Apache-2.0 *)
(** Intervals of floating-point numbers, and those that sums of roots and cosines lie in. *)
From Coq Require Import ZArith QArith Qreals Reals Lra List.
From Interval Require Specific_bigint Specific_ops Float_full Xreal Basic.
From Toolcomp Require Import Numbers Cosines Roots.
Import ListNotations.
Local Open Scope R_scope.

Module Floats := Specific_ops.SpecificFloat Specific_bigint.BigIntRadix2.
Module Intervals := Float_full.FloatIntervalFull Floats.

Definition bits := Floats.PtoP 160.

Definition in_interval (i : Intervals.type) (x : R) : Prop := Interval.contains (Intervals.convert i) (Xreal.Xreal x).

Definition interval_of_rational (q : Q) : Intervals.type :=
  Intervals.div bits (Intervals.fromZ bits (Qnum q)) (Intervals.fromZ bits (Zpos (Qden q))).
Definition interval_in_radians (i : Intervals.type) : Intervals.type :=
  Intervals.div bits (Intervals.mul bits i (Intervals.pi bits)) (Intervals.fromZ bits 180).
Definition interval_of_term (t : term) : Intervals.type :=
  let multiple :=
    Intervals.mul bits (interval_of_rational (factor t)) (Intervals.sqrt bits (Intervals.fromZ bits (Zpos (under t)))) in
  if without_cosine t then multiple
  else Intervals.mul bits multiple (Intervals.cos bits (interval_in_radians (interval_of_rational (degrees t)))).
Definition interval_of_terms (terms : list term) : Intervals.type :=
  fold_right (fun t i => Intervals.add bits (interval_of_term t) i) (Intervals.fromZ bits 0) terms.

(** Whatever cannot be computed is enclosed by anything. *)
Lemma of_nothing i x : Interval.contains (Intervals.convert i) Xreal.Xnan -> in_interval i x.
Proof. unfold in_interval. destruct (Intervals.convert i); cbn; tauto. Qed.

Lemma in_quotient i j x y : in_interval i x -> in_interval j y -> in_interval (Intervals.div bits i j) (x / y).
Proof.
  intros A B. pose proof (Intervals.div_correct bits i j _ _ A B) as C. cbn in C.
  unfold Xreal.Xdiv' in C. destruct (Xreal.is_zero y); [now apply of_nothing | exact C].
Qed.

Lemma in_root i x : in_interval i x -> in_interval (Intervals.sqrt bits i) (sqrt x).
Proof.
  intro A. pose proof (Intervals.sqrt_correct bits i _ A) as C. cbn in C.
  try (unfold Xreal.Xsqrt' in C; destruct (Xreal.is_negative x); [now apply of_nothing | ]); exact C.
Qed.

Lemma in_sum i j x y : in_interval i x -> in_interval j y -> in_interval (Intervals.add bits i j) (x + y).
Proof. intros A B. now apply Intervals.add_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y). Qed.
Lemma in_product i j x y : in_interval i x -> in_interval j y -> in_interval (Intervals.mul bits i j) (x * y).
Proof. intros A B. now apply Intervals.mul_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y). Qed.

Lemma rational_in q : in_interval (interval_of_rational q) (Q2R q).
Proof. unfold Q2R. apply in_quotient; apply Intervals.fromZ_correct. Qed.

Lemma in_radians i x : in_interval i x -> in_interval (interval_in_radians i) (x * PI / 180).
Proof.
  intro A. unfold interval_in_radians. apply in_quotient; [|apply Intervals.fromZ_correct].
  apply in_product; [exact A|]. apply Intervals.pi_correct.
Qed.

Lemma term_in t : in_interval (interval_of_term t) (term_value t).
Proof.
  unfold interval_of_term, term_value.
  assert (M : in_interval (Intervals.mul bits (interval_of_rational (factor t))
                             (Intervals.sqrt bits (Intervals.fromZ bits (Zpos (under t)))))
                (Q2R (factor t) * sqrt (IZR (Zpos (under t))))).
  { apply in_product; [apply rational_in|]. apply in_root, Intervals.fromZ_correct. }
  destruct (without_cosine t) eqn:E.
  - now rewrite (without_cosine_value _ E), Rmult_1_r.
  - apply in_product; [exact M|].
    apply Intervals.cos_correct with (x := Xreal.Xreal (Q2R (degrees t) * PI / 180)). apply in_radians, rational_in.
Qed.

Lemma terms_in terms : in_interval (interval_of_terms terms) (value terms).
Proof.
  induction terms as [|t terms IH]; [apply Intervals.fromZ_correct|].
  rewrite value_cons. unfold interval_of_terms; cbn [fold_right]. apply in_sum; [apply term_in|exact IH].
Qed.

Definition sign_of_interval (i : Intervals.type) : option comparison :=
  match Intervals.sign_strict i with
  | Xreal.Xlt => Some Lt
  | Xreal.Xgt => Some Gt
  | Xreal.Xeq => Some Eq
  | Xreal.Xund => None
  end.

Lemma real_sign_is x c :
  match c with Lt => x < 0 | Eq => x = 0 | Gt => 0 < x end -> real_sign x = Some c.
Proof.
  unfold real_sign. destruct (total_order_T x 0) as [[L|E]|G], c; intro H; try reflexivity; lra.
Qed.

Lemma interval_sign i x c : in_interval i x -> sign_of_interval i = Some c ->
  match c with Lt => x < 0 | Eq => x = 0 | Gt => 0 < x end.
Proof.
  intros A E. pose proof (Intervals.sign_strict_correct i) as S. unfold sign_of_interval in E.
  destruct (Intervals.sign_strict i); try discriminate; injection E as <-; specialize (S _ A); cbn in S.
  - now injection S.
  - tauto.
  - tauto.
Qed.
