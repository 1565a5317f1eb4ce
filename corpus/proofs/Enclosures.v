(** Numbers that Coq computes with: a rational, a sum of square roots with rational coefficients, or an interval of
    floating-point numbers, each with the real number that it encloses. What their signs decide is decided for the real
    number. *)
From Coq Require Import ZArith QArith Qreals Qabs Reals Lra Lia Psatz List.
From Interval Require Specific_bigint Specific_ops Float_full Xreal Basic.
From Toolcomp Require Import Numbers Roots.

Module Floats := Specific_ops.SpecificFloat Specific_bigint.BigIntRadix2.
Module Intervals := Float_full.FloatIntervalFull Floats.

Definition bits := Floats.PtoP 160.

Inductive enclosure := Exact (q : Q) | Sum (terms : list term) | Near (i : Intervals.type).

Import ListNotations.
Local Open Scope R_scope.

Definition in_interval (i : Intervals.type) (x : R) : Prop := Interval.contains (Intervals.convert i) (Xreal.Xreal x).

Definition encloses (e : enclosure) (x : R) : Prop :=
  match e with Exact q => Q2R q = x | Sum terms => value terms = x | Near i => in_interval i x end.

Definition interval_of_rational (q : Q) : Intervals.type :=
  Intervals.div bits (Intervals.fromZ bits (Qnum q)) (Intervals.fromZ bits (Zpos (Qden q))).
Definition interval_of (e : enclosure) : Intervals.type :=
  match e with
  | Exact q => interval_of_rational q
  | Sum terms =>
      fold_right
        (fun t i => Intervals.add bits
          (Intervals.mul bits (interval_of_rational (fst t)) (Intervals.sqrt bits (Intervals.fromZ bits (Zpos (snd t))))) i)
        (Intervals.fromZ bits 0) terms
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

Lemma in_sum i j x y : in_interval i x -> in_interval j y -> in_interval (Intervals.add bits i j) (x + y).
Proof. intros A B. now apply Intervals.add_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y). Qed.
Lemma in_product i j x y : in_interval i x -> in_interval j y -> in_interval (Intervals.mul bits i j) (x * y).
Proof. intros A B. now apply Intervals.mul_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y). Qed.

Lemma rational_in q : in_interval (interval_of_rational q) (Q2R q).
Proof. unfold Q2R. apply in_quotient; apply Intervals.fromZ_correct. Qed.

Lemma interval_encloses e x : encloses e x -> in_interval (interval_of e) x.
Proof.
  destruct e as [q|terms|i]; [| |exact (fun H => H)]; intros <-; [apply rational_in|].
  unfold interval_of, value. induction terms as [|[c d] terms IH]; cbn [fold_right fst snd].
  { apply Intervals.fromZ_correct. }
  apply in_sum; [|exact IH]. apply in_product; [apply rational_in|]. apply in_root, Intervals.fromZ_correct.
Qed.

(** Sums of roots, where both are. A long one is not worth it. *)
Definition terms_of (e : enclosure) : option (list term) :=
  match e with Exact q => Some [(q, 1%positive)] | Sum terms => Some terms | Near _ => None end.
Definition of_terms (terms : list term) : enclosure :=
  match terms with
  | [] => Exact 0
  | [(q, 1%positive)] => Exact q
  | _ => if (length terms <=? 8)%nat then Sum terms else Near (interval_of (Sum terms))
  end.

Lemma terms_of_value e l x : terms_of e = Some l -> encloses e x -> value l = x.
Proof.
  destruct e as [q|terms|i]; cbn; intros [= <-] A; [|exact A]. cbn. rewrite sqrt_1. lra.
Qed.
Lemma of_terms_encloses l x : value l = x -> encloses (of_terms l) x.
Proof.
  intro A. unfold of_terms. destruct l as [|[q d] l]; [cbn in *; unfold Q2R; cbn; lra|].
  assert (G : encloses (if (length ((q, d) :: l) <=? 8)%nat then Sum ((q, d) :: l) else
                        Near (interval_of (Sum ((q, d) :: l)))) x).
  { destruct (_ <=? _)%nat; [exact A|]. exact (interval_encloses (Sum ((q, d) :: l)) x A). }
  destruct d, l as [|t l]; try exact G. cbn in *. rewrite sqrt_1 in A. lra.
Qed.

(** * Operations *)

Definition plus_e (a b : enclosure) : enclosure :=
  match a, b with
  | Exact p, Exact q => Exact (Qred (p + q))
  | _, _ =>
      match terms_of a, terms_of b with
      | Some l, Some m => of_terms (terms_plus l m)
      | _, _ => Near (Intervals.add bits (interval_of a) (interval_of b))
      end
  end.
Definition minus_e (a b : enclosure) : enclosure :=
  match a, b with
  | Exact p, Exact q => Exact (Qred (p - q))
  | _, _ =>
      match terms_of a, terms_of b with
      | Some l, Some m => of_terms (terms_minus l m)
      | _, _ => Near (Intervals.sub bits (interval_of a) (interval_of b))
      end
  end.
Definition is_0 (e : enclosure) : bool := match e with Exact q => Qeq_bool q 0 | _ => false end.
Definition times_e (a b : enclosure) : enclosure :=
  if is_0 a || is_0 b then Exact 0
  else match a, b with
  | Exact p, Exact q => Exact (Qred (p * q))
  | _, _ =>
      match terms_of a, terms_of b with
      | Some l, Some m => of_terms (terms_times l m)
      | _, _ => Near (Intervals.mul bits (interval_of a) (interval_of b))
      end
  end.
Definition over_e (a b : enclosure) : enclosure :=
  if is_0 a then Exact 0
  else match a, b with
  | Exact p, Exact q => if is_0 b then Near Intervals.nai else Exact (Qred (p / q))
  | _, _ =>
      match terms_of a, match terms_of b with Some m => terms_inverse m | None => None end with
      | Some l, Some m => of_terms (terms_times l m)
      | _, _ => Near (Intervals.div bits (interval_of a) (interval_of b))
      end
  end.

Definition root_e (a : enclosure) : enclosure :=
  match a with
  | Exact q => if Qle_bool 0 q then of_terms (terms_root q) else Near (Intervals.sqrt bits (interval_of a))
  | _ => Near (Intervals.sqrt bits (interval_of a))
  end.

Definition radians (a : enclosure) : Intervals.type :=
  Intervals.div bits (Intervals.mul bits (interval_of a) (Intervals.pi bits)) (Intervals.fromZ bits 180).

(** Sines and cosines of the angles that have simple ones. *)
Definition wrapped (q : Q) : Q := Qred (q - inject_Z (360 * (Qnum q / (360 * Zpos (Qden q))))).
Definition table (rows : list (Q * list term)) (q : Q) : option (list term) :=
  match List.find (fun row => Qeq_bool (fst row) (wrapped q)) rows with Some row => Some (snd row) | None => None end.
Definition half : list term := [((1 # 2)%Q, 1%positive)].
Definition half_root2 : list term := [((1 # 2)%Q, 2%positive)].
Definition half_root3 : list term := [((1 # 2)%Q, 3%positive)].
Definition one : list term := [(1%Q, 1%positive)].
Definition opposite (l : list term) : list term := map (fun t => (Qopp (fst t), snd t)) l.
Definition sines : list (Q * list term) :=
  [(0, []); (30, half); (45, half_root2); (60, half_root3); (90, one); (120, half_root3); (135, half_root2); (150, half);
   (180, []); (210, opposite half); (225, opposite half_root2); (240, opposite half_root3); (270, opposite one);
   (300, opposite half_root3); (315, opposite half_root2); (330, opposite half)]%Q.
Definition cosines : list (Q * list term) :=
  [(0, one); (30, half_root3); (45, half_root2); (60, half); (90, []); (120, opposite half); (135, opposite half_root2);
   (150, opposite half_root3); (180, opposite one); (210, opposite half_root3); (225, opposite half_root2);
   (240, opposite half); (270, []); (300, half); (315, half_root2); (330, half_root3)]%Q.
Definition sine_e (a : enclosure) : enclosure :=
  match match a with Exact q => table sines q | _ => None end with
  | Some s => of_terms s
  | None => Near (Intervals.sin bits (radians a))
  end.
Definition cosine_e (a : enclosure) : enclosure :=
  match match a with Exact q => table cosines q | _ => None end with
  | Some c => of_terms c
  | None => Near (Intervals.cos bits (radians a))
  end.
Definition arctangent_e (a : enclosure) : enclosure :=
  if is_0 a then Exact 0
  else Near (Intervals.div bits (Intervals.mul bits (Intervals.atan bits (interval_of a)) (Intervals.fromZ bits 180))
               (Intervals.pi bits)).

Definition sign_e (a : enclosure) : option comparison :=
  match a with
  | Exact q => Some (Qnum q ?= 0)%Z
  | _ =>
      match Intervals.sign_strict (interval_of a) with
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
  intros A B. unfold plus_e.
  assert (G : encloses match terms_of a, terms_of b with
                       | Some l, Some m => of_terms (terms_plus l m)
                       | _, _ => Near (Intervals.add bits (interval_of a) (interval_of b))
                       end (x + y)).
  { destruct (terms_of a) as [l|] eqn:La, (terms_of b) as [m|] eqn:Lb;
      try (apply Intervals.add_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y); now apply interval_encloses).
    apply of_terms_encloses. rewrite terms_plus_value.
    now rewrite (terms_of_value _ _ _ La A), (terms_of_value _ _ _ Lb B). }
  destruct a as [p| |], b as [q| |]; [|exact G..].
  cbn [encloses] in *. now rewrite red, Q2R_plus, A, B.
Qed.

Lemma minus_encloses a b x y : encloses a x -> encloses b y -> encloses (minus_e a b) (x - y).
Proof.
  intros A B. unfold minus_e.
  assert (G : encloses match terms_of a, terms_of b with
                       | Some l, Some m => of_terms (terms_minus l m)
                       | _, _ => Near (Intervals.sub bits (interval_of a) (interval_of b))
                       end (x - y)).
  { destruct (terms_of a) as [l|] eqn:La, (terms_of b) as [m|] eqn:Lb;
      try (apply Intervals.sub_correct with (x := Xreal.Xreal x) (y := Xreal.Xreal y); now apply interval_encloses).
    apply of_terms_encloses. rewrite terms_minus_value.
    now rewrite (terms_of_value _ _ _ La A), (terms_of_value _ _ _ Lb B). }
  destruct a as [p| |], b as [q| |]; [|exact G..].
  cbn [encloses] in *. now rewrite red, Q2R_minus, A, B.
Qed.

Lemma is_0_encloses a x : encloses a x -> is_0 a = true -> x = 0.
Proof.
  destruct a as [q| |]; cbn; [|discriminate..]. intros <- E. apply Qeq_bool_eq, Qeq_eqR in E. rewrite E. unfold Q2R; cbn; lra.
Qed.

Lemma zero_encloses : encloses (Exact 0) 0.
Proof. cbn. unfold Q2R; cbn; lra. Qed.

Lemma times_encloses a b x y : encloses a x -> encloses b y -> encloses (times_e a b) (x * y).
Proof.
  intros A B. unfold times_e. destruct (is_0 a) eqn:Ea.
  { apply (is_0_encloses _ _ A) in Ea as ->. rewrite Rmult_0_l. apply zero_encloses. }
  destruct (is_0 b) eqn:Eb.
  { apply (is_0_encloses _ _ B) in Eb as ->. rewrite Rmult_0_r. apply zero_encloses. }
  cbn [orb].
  assert (G : encloses match terms_of a, terms_of b with
                       | Some l, Some m => of_terms (terms_times l m)
                       | _, _ => Near (Intervals.mul bits (interval_of a) (interval_of b))
                       end (x * y)).
  { destruct (terms_of a) as [l|] eqn:La, (terms_of b) as [m|] eqn:Lb; try (apply in_product; now apply interval_encloses).
    apply of_terms_encloses. rewrite terms_times_value.
    now rewrite (terms_of_value _ _ _ La A), (terms_of_value _ _ _ Lb B). }
  destruct a as [p| |], b as [q| |]; [|exact G..].
  cbn [encloses] in *. now rewrite red, Q2R_mult, A, B.
Qed.

Lemma nai_encloses x : in_interval Intervals.nai x.
Proof. apply of_nothing. rewrite Intervals.nai_correct. exact I. Qed.

Lemma over_encloses a b x y : encloses a x -> encloses b y -> encloses (over_e a b) (x / y).
Proof.
  intros A B. unfold over_e. destruct (is_0 a) eqn:Ea.
  { apply (is_0_encloses _ _ A) in Ea as ->. unfold Rdiv; rewrite Rmult_0_l. apply zero_encloses. }
  assert (G : encloses match terms_of a, match terms_of b with Some m => terms_inverse m | None => None end with
                       | Some l, Some m => of_terms (terms_times l m)
                       | _, _ => Near (Intervals.div bits (interval_of a) (interval_of b))
                       end (x / y)).
  { destruct (terms_of a) as [l|] eqn:La; [|apply in_quotient; now apply interval_encloses].
    destruct (terms_of b) as [m|] eqn:Lb; [|apply in_quotient; now apply interval_encloses].
    destruct (terms_inverse m) as [n|] eqn:I; [|apply in_quotient; now apply interval_encloses].
    apply of_terms_encloses. rewrite terms_times_value.
    now rewrite (terms_of_value _ _ _ La A), (terms_inverse_value _ _ I), (terms_of_value _ _ _ Lb B). }
  destruct a as [p| |], b as [q| |]; [|exact G..].
  destruct (is_0 (Exact q)) eqn:Eb; [apply nai_encloses|]. cbn [encloses] in *. rewrite red, Q2R_div, A, B; [reflexivity|].
  cbn [is_0] in Eb. intro E. apply Qeq_bool_iff in E. congruence.
Qed.

Lemma root_encloses a x : encloses a x -> encloses (root_e a) (sqrt x).
Proof.
  intro A. unfold root_e.
  assert (G : encloses (Near (Intervals.sqrt bits (interval_of a))) (sqrt x)) by now apply in_root, interval_encloses.
  destruct a as [q| |]; [|exact G..]. destruct (Qle_bool 0 q) eqn:E; [|exact G].
  apply of_terms_encloses. rewrite terms_root_value by now apply Qle_bool_imp_le. cbn in A. now rewrite A.
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
  List.Forall (fun row => f (Q2R (fst row) * PI / 180) = value (snd row)) rows ->
  table rows q = Some s -> f (Q2R q * PI / 180) = value s.
Proof.
  intros whole rights E. unfold table in E. destruct (List.find _ rows) as [row|] eqn:F; [|discriminate].
  injection E as <-. apply List.find_some in F as [F E]. rewrite List.Forall_forall in rights.
  rewrite (wrapped_angle f whole). rewrite <- (rights _ F). apply Qeq_bool_eq, Qeq_eqR in E. now rewrite E.
Qed.

Lemma whole_turn_sin y : sin (y + 2 * PI) = sin y.
Proof. rewrite <- (sin_period y 1). f_equal. cbn; lra. Qed.
Lemma whole_turn_cos y : cos (y + 2 * PI) = cos y.
Proof. rewrite <- (cos_period y 1). f_equal. cbn; lra. Qed.

Lemma half_of_root2 : / 2 * sqrt 2 = / sqrt 2.
Proof.
  pose proof (sqrt_sqrt 2 ltac:(lra)) as S. assert (P : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  apply (Rmult_eq_reg_r (sqrt 2)); [|lra]. rewrite Rinv_l by lra. nra.
Qed.

Ltac simple_angle angle rest :=
  match goal with
  | |- sin ?x = _ => replace x with angle by lra
  | |- cos ?x = _ => replace x with angle by lra
  end; rest; pose proof half_of_root2; rewrite ?sqrt_1; lra.

Lemma sines_hold : List.Forall (fun row => sin (Q2R (fst row) * PI / 180) = value (snd row)) sines.
Proof.
  unfold sines. repeat apply Forall_cons; try apply Forall_nil;
    unfold opposite, half, half_root2, half_root3, one, value, Q2R, Qopp; cbn [fst snd fold_right map Qnum Qden Z.opp].
  - simple_angle 0 ltac:(rewrite sin_0).
  - simple_angle (PI / 6) ltac:(rewrite sin_PI6).
  - simple_angle (PI / 4) ltac:(rewrite sin_PI4).
  - simple_angle (PI / 3) ltac:(rewrite sin_PI3).
  - simple_angle (PI / 2) ltac:(rewrite sin_PI2).
  - simple_angle (PI - PI / 3) ltac:(rewrite sin_PI_x, sin_PI3).
  - simple_angle (PI - PI / 4) ltac:(rewrite sin_PI_x, sin_PI4).
  - simple_angle (PI - PI / 6) ltac:(rewrite sin_PI_x, sin_PI6).
  - simple_angle PI ltac:(rewrite sin_PI).
  - simple_angle (PI / 6 + PI) ltac:(rewrite neg_sin, sin_PI6).
  - simple_angle (PI / 4 + PI) ltac:(rewrite neg_sin, sin_PI4).
  - simple_angle (PI / 3 + PI) ltac:(rewrite neg_sin, sin_PI3).
  - simple_angle (PI / 2 + PI) ltac:(rewrite neg_sin, sin_PI2).
  - simple_angle (- (PI / 3) + 2 * PI) ltac:(rewrite whole_turn_sin, sin_neg, sin_PI3).
  - simple_angle (- (PI / 4) + 2 * PI) ltac:(rewrite whole_turn_sin, sin_neg, sin_PI4).
  - simple_angle (- (PI / 6) + 2 * PI) ltac:(rewrite whole_turn_sin, sin_neg, sin_PI6).
Qed.

Lemma cosines_hold : List.Forall (fun row => cos (Q2R (fst row) * PI / 180) = value (snd row)) cosines.
Proof.
  unfold cosines. repeat apply Forall_cons; try apply Forall_nil;
    unfold opposite, half, half_root2, half_root3, one, value, Q2R, Qopp; cbn [fst snd fold_right map Qnum Qden Z.opp].
  - simple_angle 0 ltac:(rewrite cos_0).
  - simple_angle (PI / 6) ltac:(rewrite cos_PI6).
  - simple_angle (PI / 4) ltac:(rewrite cos_PI4).
  - simple_angle (PI / 3) ltac:(rewrite cos_PI3).
  - simple_angle (PI / 2) ltac:(rewrite cos_PI2).
  - simple_angle (- (PI / 3) + PI) ltac:(rewrite neg_cos, cos_neg, cos_PI3).
  - simple_angle (- (PI / 4) + PI) ltac:(rewrite neg_cos, cos_neg, cos_PI4).
  - simple_angle (- (PI / 6) + PI) ltac:(rewrite neg_cos, cos_neg, cos_PI6).
  - simple_angle PI ltac:(rewrite cos_PI).
  - simple_angle (PI / 6 + PI) ltac:(rewrite neg_cos, cos_PI6).
  - simple_angle (PI / 4 + PI) ltac:(rewrite neg_cos, cos_PI4).
  - simple_angle (PI / 3 + PI) ltac:(rewrite neg_cos, cos_PI3).
  - simple_angle (PI / 2 + PI) ltac:(rewrite neg_cos, cos_PI2).
  - simple_angle (- (PI / 3) + 2 * PI) ltac:(rewrite whole_turn_cos, cos_neg, cos_PI3).
  - simple_angle (- (PI / 4) + 2 * PI) ltac:(rewrite whole_turn_cos, cos_neg, cos_PI4).
  - simple_angle (- (PI / 6) + 2 * PI) ltac:(rewrite whole_turn_cos, cos_neg, cos_PI6).
Qed.

Lemma sine_encloses a x : encloses a x -> encloses (sine_e a) (sin (x * PI / 180)).
Proof.
  intro A. unfold sine_e.
  assert (I : in_interval (Intervals.sin bits (radians a)) (sin (x * PI / 180))).
  { apply Intervals.sin_correct with (x := Xreal.Xreal (x * PI / 180)). now apply radians_encloses. }
  destruct a as [q| |]; [|exact I..]. destruct (table sines q) eqn:E; [|exact I].
  apply of_terms_encloses. cbn in A. rewrite <- A. symmetry. eapply table_holds; [exact whole_turn_sin|exact sines_hold|exact E].
Qed.
Lemma cosine_encloses a x : encloses a x -> encloses (cosine_e a) (cos (x * PI / 180)).
Proof.
  intro A. unfold cosine_e.
  assert (I : in_interval (Intervals.cos bits (radians a)) (cos (x * PI / 180))).
  { apply Intervals.cos_correct with (x := Xreal.Xreal (x * PI / 180)). now apply radians_encloses. }
  destruct a as [q| |]; [|exact I..]. destruct (table cosines q) eqn:E; [|exact I].
  apply of_terms_encloses. cbn in A. rewrite <- A. symmetry. eapply table_holds; [exact whole_turn_cos|exact cosines_hold|exact E].
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

Lemma interval_sign i x c : in_interval i x ->
  match Intervals.sign_strict i with
  | Xreal.Xlt => Some Lt | Xreal.Xgt => Some Gt | Xreal.Xeq => Some Eq | Xreal.Xund => None
  end = Some c -> real_sign x = Some c.
Proof.
  intros A E. pose proof (Intervals.sign_strict_correct i) as S. apply real_sign_is.
  destruct (Intervals.sign_strict i); try discriminate; injection E as <-; specialize (S _ A); cbn in S.
  - now injection S.
  - tauto.
  - tauto.
Qed.

Lemma sign_encloses a x c : encloses a x -> sign_e a = Some c -> real_sign x = Some c.
Proof.
  intros A E. destruct a as [q|terms|i].
  - cbn in *. injection E as <-. apply real_sign_is. rewrite <- A. unfold Q2R.
    assert (D : 0 < / IZR (Zpos (Qden q))) by (apply Rinv_0_lt_compat, IZR_lt; reflexivity).
    destruct (Z.compare_spec (Qnum q) 0) as [Z|Z|Z].
    + rewrite Z; lra.
    + apply IZR_lt in Z. nra.
    + apply IZR_lt in Z. nra.
  - eapply interval_sign; [apply interval_encloses; exact A|exact E].
  - eapply interval_sign; [exact A|exact E].
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
