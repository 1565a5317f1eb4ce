(** Numbers that Coq computes with: a rational, or an interval of floating-point numbers, each with the real number that
    it encloses. What their signs decide is decided for the real number. *)
From Coq Require Import ZArith QArith Qreals Qabs Reals Lra Lia Psatz.
From Interval Require Specific_bigint Specific_ops Float_full Xreal Basic.
From Toolcomp Require Import Numbers.

Module Floats := Specific_ops.SpecificFloat Specific_bigint.BigIntRadix2.
Module Intervals := Float_full.FloatIntervalFull Floats.

Definition bits := Floats.PtoP 160.

Inductive enclosure := Exact (q : Q) | Near (i : Intervals.type).

Local Open Scope R_scope.

Definition in_interval (i : Intervals.type) (x : R) : Prop := Interval.contains (Intervals.convert i) (Xreal.Xreal x).

Definition encloses (e : enclosure) (x : R) : Prop :=
  match e with Exact q => Q2R q = x | Near i => in_interval i x end.

Definition interval_of (e : enclosure) : Intervals.type :=
  match e with
  | Exact q => Intervals.div bits (Intervals.fromZ bits (Qnum q)) (Intervals.fromZ bits (Zpos (Qden q)))
  | Near i => i
  end.

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

Lemma interval_encloses e x : encloses e x -> in_interval (interval_of e) x.
Proof.
  destruct e as [q|i]; [|exact (fun H => H)]. intros <-. unfold Q2R. cbn [interval_of].
  apply in_quotient; apply Intervals.fromZ_correct.
Qed.

(** * Operations *)

Definition plus_e (a b : enclosure) : enclosure :=
  match a, b with
  | Exact p, Exact q => Exact (Qred (p + q))
  | _, _ => Near (Intervals.add bits (interval_of a) (interval_of b))
  end.
Definition minus_e (a b : enclosure) : enclosure :=
  match a, b with
  | Exact p, Exact q => Exact (Qred (p - q))
  | _, _ => Near (Intervals.sub bits (interval_of a) (interval_of b))
  end.
Definition is_0 (e : enclosure) : bool := match e with Exact q => Qeq_bool q 0 | Near _ => false end.
Definition times_e (a b : enclosure) : enclosure :=
  if is_0 a || is_0 b then Exact 0
  else match a, b with
  | Exact p, Exact q => Exact (Qred (p * q))
  | _, _ => Near (Intervals.mul bits (interval_of a) (interval_of b))
  end.
Definition over_e (a b : enclosure) : enclosure :=
  if is_0 a then Exact 0
  else match a, b with
  | Exact p, Exact q => if is_0 b then Near Intervals.nai else Exact (Qred (p / q))
  | _, _ => Near (Intervals.div bits (interval_of a) (interval_of b))
  end.

(** The root of a square. *)
Definition exact_root (q : Q) : option Q :=
  let q := Qred q in
  let n := Z.sqrt (Qnum q) in
  let d := Z.sqrt (Zpos (Qden q)) in
  if (0 <=? Qnum q)%Z && (n * n =? Qnum q)%Z && (d * d =? Zpos (Qden q))%Z && (0 <? d)%Z
  then Some (n # Z.to_pos d) else None.
Definition root_e (a : enclosure) : enclosure :=
  match a with
  | Exact q => match exact_root q with Some r => Exact r | None => Near (Intervals.sqrt bits (interval_of a)) end
  | Near i => Near (Intervals.sqrt bits i)
  end.

Definition radians (a : enclosure) : Intervals.type :=
  Intervals.div bits (Intervals.mul bits (interval_of a) (Intervals.pi bits)) (Intervals.fromZ bits 180).

(** Sines and cosines of a whole number of half right angles and thirds are not all rational; those that are, by quarter
    turns and the like. *)
Definition wrapped (q : Q) : Q := Qred (q - inject_Z (360 * (Qnum q / (360 * Zpos (Qden q))))).
Definition table (rows : list (Q * Q)) (q : Q) : option Q :=
  match List.find (fun row => Qeq_bool (fst row) (wrapped q)) rows with Some row => Some (snd row) | None => None end.
Definition sines : list (Q * Q) :=
  (cons (0, 0) (cons (30, 1 # 2) (cons (90, 1) (cons (150, 1 # 2) (cons (180, 0)
  (cons (210, - (1 # 2)) (cons (270, - (1)) (cons (330, - (1 # 2)) nil))))))))%Q.
Definition cosines : list (Q * Q) :=
  (cons (0, 1) (cons (60, 1 # 2) (cons (90, 0) (cons (120, - (1 # 2)) (cons (180, - (1))
  (cons (240, - (1 # 2)) (cons (270, 0) (cons (300, 1 # 2) nil))))))))%Q.
Definition sine_e (a : enclosure) : enclosure :=
  match match a with Exact q => table sines q | Near _ => None end with
  | Some s => Exact s
  | None => Near (Intervals.sin bits (radians a))
  end.
Definition cosine_e (a : enclosure) : enclosure :=
  match match a with Exact q => table cosines q | Near _ => None end with
  | Some c => Exact c
  | None => Near (Intervals.cos bits (radians a))
  end.
Definition arctangent_e (a : enclosure) : enclosure :=
  if is_0 a then Exact 0
  else Near (Intervals.div bits (Intervals.mul bits (Intervals.atan bits (interval_of a)) (Intervals.fromZ bits 180))
               (Intervals.pi bits)).

Definition sign_e (a : enclosure) : option comparison :=
  match a with
  | Exact q => Some (Qnum q ?= 0)%Z
  | Near i =>
      match Intervals.sign_strict i with
      | Xreal.Xlt => Some Lt
      | Xreal.Xgt => Some Gt
      | Xreal.Xeq => Some Eq
      | Xreal.Xund => None
      end
  end.

(** * They enclose *)

Lemma red q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma plus_encloses a b x y : encloses a x -> encloses b y -> encloses (plus_e a b) (x + y).
Proof.
  intros A B. destruct a as [p|i], b as [q|j];
    try (apply Intervals.add_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y); now apply interval_encloses).
  cbn [encloses plus_e] in *. now rewrite red, Q2R_plus, A, B.
Qed.

Lemma minus_encloses a b x y : encloses a x -> encloses b y -> encloses (minus_e a b) (x - y).
Proof.
  intros A B. destruct a as [p|i], b as [q|j];
    try (apply Intervals.sub_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y); now apply interval_encloses).
  cbn [encloses minus_e] in *. now rewrite red, Q2R_minus, A, B.
Qed.

Lemma is_0_encloses a x : encloses a x -> is_0 a = true -> x = 0.
Proof.
  destruct a as [q|i]; cbn; [|discriminate]. intros <- E. apply Qeq_bool_eq, Qeq_eqR in E. rewrite E. unfold Q2R; cbn; lra.
Qed.

Lemma zero_encloses : encloses (Exact 0) 0.
Proof. cbn. unfold Q2R; cbn; lra. Qed.

Lemma times_encloses a b x y : encloses a x -> encloses b y -> encloses (times_e a b) (x * y).
Proof.
  intros A B. unfold times_e. destruct (is_0 a) eqn:Ea.
  { apply (is_0_encloses _ _ A) in Ea as ->. rewrite Rmult_0_l. apply zero_encloses. }
  destruct (is_0 b) eqn:Eb.
  { apply (is_0_encloses _ _ B) in Eb as ->. rewrite Rmult_0_r. apply zero_encloses. }
  cbn [orb]. destruct a as [p|i], b as [q|j];
    try (apply Intervals.mul_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y); now apply interval_encloses).
  cbn [encloses] in *. now rewrite red, Q2R_mult, A, B.
Qed.

Lemma nai_encloses x : in_interval Intervals.nai x.
Proof. apply of_nothing. rewrite Intervals.nai_correct. exact I. Qed.

Lemma over_encloses a b x y : encloses a x -> encloses b y -> encloses (over_e a b) (x / y).
Proof.
  intros A B. unfold over_e. destruct (is_0 a) eqn:Ea.
  { apply (is_0_encloses _ _ A) in Ea as ->. unfold Rdiv; rewrite Rmult_0_l. apply zero_encloses. }
  destruct a as [p|i], b as [q|j]; try (apply in_quotient; now apply interval_encloses).
  destruct (is_0 (Exact q)) eqn:Eb; [apply nai_encloses|]. cbn [encloses] in *. rewrite red, Q2R_div, A, B; [reflexivity|].
  cbn [is_0] in Eb. intro E. apply Qeq_bool_iff in E. congruence.
Qed.

Lemma exact_root_encloses q r : exact_root q = Some r -> Q2R r = sqrt (Q2R q).
Proof.
  unfold exact_root. intro E.
  destruct (_ && _)%bool eqn:C in E; [|discriminate]. injection E as <-.
  apply andb_prop in C as [C D]. apply andb_prop in C as [C S]. apply andb_prop in C as [P N].
  apply Z.leb_le in P. apply Z.eqb_eq in N, S. apply Z.ltb_lt in D.
  rewrite <- (red q). set (p := Qred q) in *.
  set (n := Z.sqrt (Qnum p)) in *. set (d := Z.sqrt (Zpos (Qden p))) in *.
  assert (Hn : (0 <= n)%Z) by apply Z.sqrt_nonneg.
  change (IZR n * / IZR (Zpos (Z.to_pos d)) = sqrt (IZR (Qnum p) * / IZR (Zpos (Qden p)))).
  rewrite (Z2Pos.id d) by assumption.
  apply IZR_le in Hn. apply IZR_lt in D.
  symmetry. apply sqrt_lem_1.
  - apply Rmult_le_pos; [now apply IZR_le|]. apply Rlt_le, Rinv_0_lt_compat, IZR_lt. reflexivity.
  - apply Rmult_le_pos; [assumption|]. now apply Rlt_le, Rinv_0_lt_compat.
  - rewrite <- N, <- S, !mult_IZR. field. lra.
Qed.

Lemma root_encloses a x : encloses a x -> encloses (root_e a) (sqrt x).
Proof.
  intro A. unfold root_e. destruct a as [q|i]; [|now apply in_root].
  destruct (exact_root q) eqn:E; [|now apply in_root, interval_encloses].
  cbn in *. rewrite <- A. now apply exact_root_encloses.
Qed.

Lemma radians_encloses a x : encloses a x -> in_interval (radians a) (x * PI / 180).
Proof.
  intro A. unfold radians. apply in_quotient; [|apply Intervals.fromZ_correct].
  apply Intervals.mul_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal PI); [now apply interval_encloses|].
  apply Intervals.pi_correct.
Qed.

Lemma turns (f : R -> R) (whole : forall y, f (y + 2 * PI) = f y) (k : Z) y : f (y + IZR k * (2 * PI)) = f y.
Proof.
  assert (P : forall n y, f (y + INR n * (2 * PI)) = f y).
  { intros n; induction n as [|n IH]; intro z; [now rewrite Rmult_0_l, Rplus_0_r|].
    rewrite S_INR, Rmult_plus_distr_r, Rmult_1_l, <- Rplus_assoc. now rewrite whole. }
  destruct (Z_le_gt_dec 0 k) as [L|G].
  - rewrite <- (Z2Nat.id k L), <- INR_IZR_INZ. apply P.
  - rewrite <- (P (Z.to_nat (- k)) (y + IZR k * (2 * PI))). f_equal.
    rewrite INR_IZR_INZ, Z2Nat.id, opp_IZR by lia. lra.
Qed.

Lemma wrapped_by q : exists k, Q2R q = Q2R (wrapped q) + IZR (360 * k).
Proof.
  unfold wrapped. exists (Qnum q / (360 * Zpos (Qden q)))%Z. rewrite red, Q2R_minus.
  unfold inject_Z. unfold Q2R at 3. cbn [Qnum Qden]. rewrite Rinv_1. lra.
Qed.

Lemma wrapped_angle (f : R -> R) (whole : forall y, f (y + 2 * PI) = f y) q :
  f (Q2R q * PI / 180) = f (Q2R (wrapped q) * PI / 180).
Proof.
  destruct (wrapped_by q) as [k ->]. rewrite mult_IZR.
  replace ((Q2R (wrapped q) + 360 * IZR k) * PI / 180) with (Q2R (wrapped q) * PI / 180 + IZR k * (2 * PI)) by lra.
  now apply turns.
Qed.

Lemma table_holds (f : R -> R) rows q s :
  (forall y, f (y + 2 * PI) = f y) ->
  List.Forall (fun row => f (Q2R (fst row) * PI / 180) = Q2R (snd row)) rows ->
  table rows q = Some s -> f (Q2R q * PI / 180) = Q2R s.
Proof.
  intros whole rights E. unfold table in E. destruct (List.find _ rows) as [row|] eqn:F; [|discriminate].
  injection E as <-. apply List.find_some in F as [F E]. rewrite List.Forall_forall in rights.
  rewrite (wrapped_angle f whole). rewrite <- (rights _ F). apply Qeq_bool_eq, Qeq_eqR in E. now rewrite E.
Qed.

Lemma whole_turn_sin y : sin (y + 2 * PI) = sin y.
Proof. rewrite <- (sin_period y 1). f_equal. cbn; lra. Qed.
Lemma whole_turn_cos y : cos (y + 2 * PI) = cos y.
Proof. rewrite <- (cos_period y 1). f_equal. cbn; lra. Qed.

Lemma sines_hold : List.Forall (fun row => sin (Q2R (fst row) * PI / 180) = Q2R (snd row)) sines.
Proof.
  unfold sines. repeat constructor; cbn [fst snd]; unfold Q2R, Qopp; cbn [Qnum Qden Z.opp].
  - replace (0 * / 1 * PI / 180) with 0 by lra. rewrite sin_0; lra.
  - replace (30 * / 1 * PI / 180) with (PI / 6) by lra. rewrite sin_PI6; lra.
  - replace (90 * / 1 * PI / 180) with (PI / 2) by lra. rewrite sin_PI2; lra.
  - replace (150 * / 1 * PI / 180) with (PI - PI / 6) by lra. rewrite sin_PI_x, sin_PI6; lra.
  - replace (180 * / 1 * PI / 180) with PI by lra. rewrite sin_PI; lra.
  - replace (210 * / 1 * PI / 180) with (PI / 6 + PI) by lra. rewrite neg_sin, sin_PI6; lra.
  - replace (270 * / 1 * PI / 180) with (PI / 2 + PI) by lra. rewrite neg_sin, sin_PI2; lra.
  - replace (330 * / 1 * PI / 180) with (- (PI / 6) + 2 * PI) by lra. rewrite whole_turn_sin, sin_neg, sin_PI6; lra.
Qed.

Lemma cosines_hold : List.Forall (fun row => cos (Q2R (fst row) * PI / 180) = Q2R (snd row)) cosines.
Proof.
  unfold cosines. repeat constructor; cbn [fst snd]; unfold Q2R, Qopp; cbn [Qnum Qden Z.opp].
  - replace (0 * / 1 * PI / 180) with 0 by lra. rewrite cos_0; lra.
  - replace (60 * / 1 * PI / 180) with (PI / 3) by lra. rewrite cos_PI3; lra.
  - replace (90 * / 1 * PI / 180) with (PI / 2) by lra. rewrite cos_PI2; lra.
  - replace (120 * / 1 * PI / 180) with (- (PI / 3) + PI) by lra. rewrite neg_cos, cos_neg, cos_PI3; lra.
  - replace (180 * / 1 * PI / 180) with PI by lra. rewrite cos_PI; lra.
  - replace (240 * / 1 * PI / 180) with (PI / 3 + PI) by lra. rewrite neg_cos, cos_PI3; lra.
  - replace (270 * / 1 * PI / 180) with (PI / 2 + PI) by lra. rewrite neg_cos, cos_PI2; lra.
  - replace (300 * / 1 * PI / 180) with (- (PI / 3) + 2 * PI) by lra. rewrite whole_turn_cos, cos_neg, cos_PI3; lra.
Qed.

Lemma sine_encloses a x : encloses a x -> encloses (sine_e a) (sin (x * PI / 180)).
Proof.
  intro A. unfold sine_e.
  assert (I : in_interval (Intervals.sin bits (radians a)) (sin (x * PI / 180))).
  { apply Intervals.sin_correct with (x := Xreal.Xreal (x * PI / 180)). now apply radians_encloses. }
  destruct a as [q|i]; [|exact I]. destruct (table sines q) eqn:E; [|exact I].
  cbn in *. rewrite <- A. symmetry. eapply table_holds; [exact whole_turn_sin|exact sines_hold|exact E].
Qed.
Lemma cosine_encloses a x : encloses a x -> encloses (cosine_e a) (cos (x * PI / 180)).
Proof.
  intro A. unfold cosine_e.
  assert (I : in_interval (Intervals.cos bits (radians a)) (cos (x * PI / 180))).
  { apply Intervals.cos_correct with (x := Xreal.Xreal (x * PI / 180)). now apply radians_encloses. }
  destruct a as [q|i]; [|exact I]. destruct (table cosines q) eqn:E; [|exact I].
  cbn in *. rewrite <- A. symmetry. eapply table_holds; [exact whole_turn_cos|exact cosines_hold|exact E].
Qed.

Lemma arctangent_encloses a x : encloses a x -> encloses (arctangent_e a) (atan x * 180 / PI).
Proof.
  intro A. unfold arctangent_e. destruct (is_0 a) eqn:E.
  { apply (is_0_encloses _ _ A) in E as ->. rewrite atan_0. unfold Rdiv. rewrite !Rmult_0_l. apply zero_encloses. }
  cbn. apply in_quotient; [|apply Intervals.pi_correct].
  apply Intervals.mul_correct with (x := Xreal.Xreal (atan x)) (y := Xreal.Xreal 180); [|apply Intervals.fromZ_correct].
  apply Intervals.atan_correct with (x := Xreal.Xreal x). now apply interval_encloses.
Qed.

Lemma real_sign_is x c :
  match c with Lt => x < 0 | Eq => x = 0 | Gt => 0 < x end -> real_sign x = Some c.
Proof.
  unfold real_sign. destruct (total_order_T x 0) as [[L|E]|G], c; intro H; try reflexivity; lra.
Qed.

Lemma sign_encloses a x c : encloses a x -> sign_e a = Some c -> real_sign x = Some c.
Proof.
  destruct a as [q|i]; cbn; intros A E.
  - injection E as <-. apply real_sign_is. rewrite <- A. unfold Q2R.
    assert (D : 0 < / IZR (Zpos (Qden q))) by (apply Rinv_0_lt_compat, IZR_lt; reflexivity).
    destruct (Z.compare_spec (Qnum q) 0) as [Z|Z|Z].
    + rewrite Z; lra.
    + apply IZR_lt in Z. nra.
    + apply IZR_lt in Z. nra.
  - pose proof (Intervals.sign_strict_correct i) as S. apply real_sign_is.
    destruct (Intervals.sign_strict i); try discriminate; injection E as <-; specialize (S _ A); cbn in S.
    + now injection S.
    + tauto.
    + tauto.
Qed.

(** * As numbers of programs *)

(** With the real number that is meant: nothing is computed of it. *)
Definition enclosed := (enclosure * (unit -> R))%type.
Definition means (a : enclosed) (x : R) : Prop := snd a tt = x /\ encloses (fst a) x.

(** Where an enclosure does not tell, the sign of the real number: known to be there, and nothing to compute with. *)
Definition left_open (x : unit -> R) : {c : option comparison | c = real_sign (x tt)}.
Proof. now exists (real_sign (x tt)). Qed.

#[global] Instance enclosures : Numbers enclosed := {
  integer z := (Exact (inject_Z z), fun _ => IZR z);
  plus a b := (plus_e (fst a) (fst b), fun _ => snd a tt + snd b tt);
  minus a b := (minus_e (fst a) (fst b), fun _ => snd a tt - snd b tt);
  times a b := (times_e (fst a) (fst b), fun _ => snd a tt * snd b tt);
  over a b := (over_e (fst a) (fst b), fun _ => snd a tt / snd b tt);
  root a := (root_e (fst a), fun _ => sqrt (snd a tt));
  sine a := (sine_e (fst a), fun _ => sin (snd a tt * PI / 180));
  cosine a := (cosine_e (fst a), fun _ => cos (snd a tt * PI / 180));
  arctangent a := (arctangent_e (fst a), fun _ => atan (snd a tt) * 180 / PI);
  half_turn := (Near (Intervals.pi bits), fun _ => PI);
  sign a := match sign_e (fst a) with Some c => Some c | None => proj1_sig (left_open (snd a)) end
}.
