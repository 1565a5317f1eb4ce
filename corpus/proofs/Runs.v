(* SPDX-License-Identifier: Apache-2.0 *)
(** Programs that Coq runs: what it computes with enclosures holds of the real numbers. *)
From Coq Require Import List ZArith QArith Qreals Qabs Reals Lra Lia.
From Param Require Import Param.
From Toolcomp Require Import Numbers Data Comparison Roots Bounds Enclosures.
Import ListNotations.

Parametricity Recursive Z qualified.

(** Whole numbers are related to themselves alone. *)
Lemma Z_same z : Coq_o_Numbers_o_BinNums_o_Z_R z z.
Proof.
  assert (P : forall p, Coq_o_Numbers_o_BinNums_o_positive_R p p) by (intro p; induction p; constructor; assumption).
  destruct z; constructor; apply P.
Qed.
Lemma Z_equal y z : Coq_o_Numbers_o_BinNums_o_Z_R y z -> y = z.
Proof.
  assert (P : forall p q, Coq_o_Numbers_o_BinNums_o_positive_R p q -> p = q) by (intros p q H; induction H; congruence).
  intros [| |]; f_equal; auto.
Qed.

(** By that, and not by how it is computed. *)
Lemma gcd_related a b : Coq_o_Numbers_o_BinNums_o_Z_R a b -> forall c d, Coq_o_Numbers_o_BinNums_o_Z_R c d ->
  Coq_o_Numbers_o_BinNums_o_Z_R (Z.gcd a c) (Z.gcd b d).
Proof. intros <-%Z_equal c d <-%Z_equal. apply Z_same. Qed.
Realizer Z.gcd as gcd_related_to_gcd := gcd_related.

(** The free theorem of runs, for numbers that are related in any way that their operations keep. *)
Parametricity Recursive compared_run qualified.

Local Open Scope R_scope.

(** Texts and trees are related to themselves. *)
Lemma string_same s : Coq_o_Strings_o_String_o_string_R s s.
Proof. induction s as [|a s IH]; constructor; [|exact IH]. destruct a as [b0 b1 b2 b3 b4 b5 b6 b7]; constructor; match goal with |- _ ?b _ => destruct b end; constructor. Qed.

Fixpoint data_same (d : data) : Toolcomp_o_Data_o_data_R d d :=
  match d with
  | Whole i => Toolcomp_o_Data_o_data_R_Whole_R i i (Z_same i)
  | Text s => Toolcomp_o_Data_o_data_R_Text_R s s (string_same s)
  | Tree l => Toolcomp_o_Data_o_data_R_Tree_R l l
      ((fix all l : Coq_o_Init_o_Datatypes_o_list_R data data Toolcomp_o_Data_o_data_R l l :=
          match l with
          | [] => Coq_o_Init_o_Datatypes_o_list_R_nil_R _ _ _
          | a :: l => Coq_o_Init_o_Datatypes_o_list_R_cons_R _ _ _ _ _ (data_same a) _ _ (all l)
          end) l)
  end.

Lemma row_same row :
  Coq_o_Init_o_Datatypes_o_list_R (mark written) (mark written)
    (Toolcomp_o_Comparison_o_mark_R written written Toolcomp_o_Comparison_o_written_R) row row.
Proof.
  induction row as [|m row IH]; constructor; [|exact IH].
  destruct m as [| |i|s|[over under|a b c d]]; constructor; try apply Z_same; try apply string_same; constructor; apply Z_same.
Qed.

(** Enclosures and the real numbers that they mean. *)
Lemma enclosures_mean : Toolcomp_o_Numbers_o_Numbers_R enclosed R means enclosures reals.
Proof.
  constructor.
  - intros y z <-%Z_equal. split; [reflexivity|]. cbn. unfold Q2R, inject_Z; cbn. lra.
  - intros a x [<- A] b y [<- B]. split; [reflexivity|]. now apply plus_encloses.
  - intros a x [<- A] b y [<- B]. split; [reflexivity|]. now apply minus_encloses.
  - intros a x [<- A] b y [<- B]. split; [reflexivity|]. now apply times_encloses.
  - intros a x [<- A] b y [<- B]. split; [reflexivity|]. now apply over_encloses.
  - intros a x [<- A]. split; [reflexivity|]. now apply root_encloses.
  - intros a x [<- A]. split; [reflexivity|]. now apply sine_encloses.
  - intros a x [<- A]. split; [reflexivity|]. now apply cosine_encloses.
  - intros a x [<- A]. split; [reflexivity|]. now apply arctangent_encloses.
  - split; [reflexivity|]. apply Intervals.pi_correct.
  - intros a x [<- A].
    assert (same : forall c, Coq_o_Init_o_Datatypes_o_option_R comparison comparison
                               Coq_o_Init_o_Datatypes_o_comparison_R c c)
      by (intros [[]|]; constructor; constructor).
    change (Coq_o_Init_o_Datatypes_o_option_R comparison comparison Coq_o_Init_o_Datatypes_o_comparison_R
              (match sign_e (fst a) with Some c => Some c | None => proj1_sig (left_open (snd a)) end)
              (real_sign (snd a tt))).
    destruct (sign_e (fst a)) as [c|] eqn:E.
    + rewrite (sign_encloses _ _ _ A E). apply same.
    + destruct (left_open (snd a)) as [c ->]. apply same.
Qed.

(** * What is written of a run *)

Definition ten_to (k : Z) : Z := (10 ^ k)%Z.

(** The number is the fraction; or it is not farther from the decimal than it says. *)
Definition is_written (w : written) (x : R) : Prop :=
  match w with
  | Fraction over under => x = IZR over / IZR under
  | Within digits decimals off off_decimals =>
      Rabs (x - IZR digits / IZR (ten_to decimals)) <= IZR off / IZR (ten_to off_decimals)
  end.

(** The run of the case over the real numbers says what is written, every number with it. *)
Definition runs_as_written (case : data) (row : list (mark written)) : Prop :=
  exists pairs, compared_run (num := R) case row = Some pairs /\
                Forall (fun pair => is_written (fst pair) (snd pair)) pairs.

Definition quotient (over under : Z) : enclosure := over_e (Exact (inject_Z over)) (Exact (inject_Z under)).

Lemma quotient_encloses over under : encloses (quotient over under) (IZR over / IZR under).
Proof. unfold quotient. apply over_encloses; cbn; unfold Q2R, inject_Z; cbn; lra. Qed.

Definition not_above_0 (e : enclosure) : bool :=
  match e with
  | Exact q => Qle_bool q 0
  | _ => match Intervals.sign_large (interval_of e) with Xreal.Xlt | Xreal.Xeq => true | _ => false end
  end.

Lemma interval_not_above_0 i x : in_interval i x ->
  match Intervals.sign_large i with Xreal.Xlt | Xreal.Xeq => true | _ => false end = true -> x <= 0.
Proof.
  intros A E. pose proof (Intervals.sign_large_correct i) as S. destruct (Intervals.sign_large i); try discriminate;
    specialize (S _ A); cbn in S; [injection S; lra | lra].
Qed.

Lemma not_above_0_holds e x : encloses e x -> not_above_0 e = true -> x <= 0.
Proof.
  intros A E. destruct e as [q|terms|above below i|i];
    [|eapply interval_not_above_0; [apply interval_encloses; exact A|exact E]..].
  cbn in *. rewrite <- A. apply Qle_bool_imp_le, Qle_Rle in E. unfold Q2R at 2 in E; cbn in E. lra.
Qed.

Definition shown (w : written) (a : enclosure) : bool :=
  match w with
  | Fraction over under =>
      match minus_e a (quotient over under) with Exact q => Qeq_bool q 0 | Sum terms => is_nothing terms | _ => false end
  | Within digits decimals off off_decimals =>
      let distance := minus_e a (quotient digits (ten_to decimals)) in
      let most := quotient off (ten_to off_decimals) in
      not_above_0 (minus_e distance most) && not_above_0 (minus_e (minus_e (Exact 0) most) distance)
  end.

Lemma shown_holds w a x : encloses a x -> shown w a = true -> is_written w x.
Proof.
  intros A. destruct w as [over under|digits decimals off off_decimals]; cbn [shown is_written].
  - pose proof (minus_encloses _ _ _ _ A (quotient_encloses over under)) as D.
    destruct (minus_e a (quotient over under)) as [q|terms| |]; try discriminate; cbn [encloses] in D; intro E.
    + apply Qeq_bool_eq, Qeq_eqR in E. rewrite E in D. unfold Q2R in D at 1; cbn in D. lra.
    + apply is_nothing_value in E. lra.
  - pose proof (minus_encloses _ _ _ _ A (quotient_encloses digits (ten_to decimals))) as D.
    pose proof (quotient_encloses off (ten_to off_decimals)) as M.
    intro E. apply andb_prop in E as [E F].
    pose proof (not_above_0_holds _ _ (minus_encloses _ _ _ _ D M) E) as U.
    pose proof (not_above_0_holds _ _ (minus_encloses _ _ _ _ (minus_encloses _ _ _ _ zero_encloses M) D) F) as L.
    apply Rabs_le. lra.
Qed.

(** What Coq computes of it. *)
Definition computed (case : data) (row : list (mark written)) : bool :=
  match compared_run (num := enclosed) case row with
  | Some pairs => forallb (fun pair => shown (fst pair) (fst (snd pair))) pairs
  | None => false
  end.

Theorem computed_runs case row : computed case row = true -> runs_as_written case row.
Proof.
  unfold computed, runs_as_written. intro C.
  pose proof (Toolcomp_o_Comparison_o_compared_run_R _ _ _ _ _ enclosures_mean case case (data_same case) row row
                (row_same row)) as T.
  destruct T as [ps qs T|]; [|discriminate]. exists qs. split; [reflexivity|].
  revert C. induction T as [|p q H ps qs T IH]; intro C; constructor.
  - cbn in C. apply andb_prop in C as [C _]. destruct H as [w v W a x [_ A]]. cbn in *.
    assert (E : w = v) by (destruct W; f_equal; now apply Z_equal). rewrite <- E. eapply shown_holds; [exact A|exact C].
  - apply IH. cbn in C. now apply andb_prop in C as [_ C].
Qed.

(** * Which runs it can compute *)

(** Enclosures alone: a sign that they do not tell is not told. *)
Definition alone : Numbers enclosure := {|
  integer z := Exact (inject_Z z);
  plus := plus_e;
  minus := minus_e;
  times := times_e;
  over := over_e;
  root := root_e;
  sine := sine_e;
  cosine := cosine_e;
  arctangent := arctangent_e;
  half_turn := Near (Intervals.pi bits);
  sign := sign_e
|}.
Definition can_be_computed (case : data) (row : list (mark written)) : bool :=
  match @compared_run _ alone case row with
  | Some pairs => forallb (fun pair => shown (fst pair) (snd pair)) pairs
  | None => false
  end.

Ltac by_running := apply computed_runs; vm_cast_no_check (eq_refl true).
