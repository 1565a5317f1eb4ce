(* SPDX-License-Identifier: Apache-2.0 *)
(** Numbers that Coq computes with: a rational, a sum of square roots and cosines with rational coefficients, a ratio of
    such sums, or an interval of floating-point numbers, each with the real number that it encloses. What their signs
    decide is decided for the real number. *)
From Coq Require Import ZArith QArith Qreals Qabs Reals Lra Lia Psatz List.
From Interval Require Xreal Basic.
From Toolcomp Require Import Numbers Cosines Roots Bounds.
Import ListNotations.
Local Open Scope R_scope.

Inductive enclosure := Exact (q : Q) | Sum (terms : list term) | Ratio (above below : list term) (i : Intervals.type)
  | Near (i : Intervals.type).

Definition encloses (e : enclosure) (x : R) : Prop :=
  match e with
  | Exact q => Q2R q = x
  | Sum terms => value terms = x
  | Ratio above below i => value above / value below = x /\ in_interval i x
  | Near i => in_interval i x
  end.

Definition interval_of (e : enclosure) : Intervals.type :=
  match e with
  | Exact q => interval_of_rational q
  | Sum terms => interval_of_terms terms
  | Ratio _ _ i | Near i => i
  end.

Lemma interval_encloses e x : encloses e x -> in_interval (interval_of e) x.
Proof.
  destruct e as [q|terms|above below i|i]; cbn [encloses interval_of].
  - intros <-. apply rational_in.
  - intros <-. apply terms_in.
  - tauto.
  - tauto.
Qed.

(** Sums of roots and cosines, where both are. A long one is not worth it. *)
Definition one : list term := [Term 1 1 0].
Definition terms_of (e : enclosure) : option (list term) :=
  match e with
  | Exact q => Some (if Qeq_bool q 0 then [] else [Term q 1 0])
  | Sum terms => Some terms
  | _ => None
  end.
Definition rational_of (terms : list term) : option Q :=
  match terms with
  | [] => Some 0%Q
  | [Term q 1 w] => if same_degrees w 0 then Some q else None
  | _ => None
  end.
Definition of_terms (terms : list term) : enclosure :=
  match rational_of terms with
  | Some q => Exact q
  | None => if (length terms <=? 8)%nat then Sum terms else Near (interval_of_terms terms)
  end.

Lemma rational_term q : value [Term q 1 0] = Q2R q.
Proof. rewrite value_cons, plain_term. change (value []) with 0. rewrite sqrt_1. ring. Qed.
Lemma one_value : value one = 1.
Proof. unfold one. rewrite rational_term. unfold Q2R; cbn; lra. Qed.
Lemma rational_of_value terms q : rational_of terms = Some q -> value terms = Q2R q.
Proof.
  unfold rational_of. destruct terms as [|[c d w] l]; [intros [= <-]; unfold Q2R; cbn; lra|].
  destruct d; try discriminate. destruct l; [|discriminate]. destruct (same_degrees w 0) eqn:E; [|discriminate].
  apply same_degrees_holds in E. intros [= <-]. rewrite E. apply rational_term.
Qed.
Lemma terms_of_value e l x : terms_of e = Some l -> encloses e x -> value l = x.
Proof.
  destruct e as [q|terms|above below i|i]; cbn [terms_of encloses]; try discriminate; intros [= <-] A; [|exact A].
  destruct (Qeq_bool q 0) eqn:E; [apply zero_value in E; rewrite <- A, E; reflexivity|]. now rewrite rational_term.
Qed.
Lemma of_terms_encloses l x : value l = x -> encloses (of_terms l) x.
Proof.
  intro A. unfold of_terms. destruct (rational_of l) as [q|] eqn:E; [apply rational_of_value in E; cbn; congruence|].
  destruct (_ <=? _)%nat; [exact A|]. rewrite <- A. exact (terms_in l).
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
      let quotient := Intervals.div bits (interval_of a) (interval_of b) in
      match terms_of a, terms_of b with
      | Some l, Some m =>
          match terms_inverse m with
          | Some n => of_terms (terms_times l n)
          | None => Ratio l m quotient
          end
      | _, _ => Near quotient
      end
  end.

(** c(1 + cos q) = 2c (cos q/2)², c(1 - cos q) = 2c (cos (90 - q/2))²: what may be the root of two terms, from the number
    and the multiple of a cosine. *)
Definition as_cosine (t : term) : option (Q * Q) :=
  if without_cosine t then
    match as_multiple (factor t) (under t) 2, as_multiple (factor t) (under t) 3 with
    | Some c, _ => Some (2 * c, 45)%Q
    | None, Some c => Some (2 * c, 30)%Q
    | None, None => None
    end
  else match under t with xH => Some (factor t, degrees t) | _ => None end.
Definition half_angle (s t : term) : option (list term) :=
  match rational_of [s], as_cosine t with
  | Some c, Some (d, q) =>
      let root q := Some (terms_times (terms_root (Qred (2 * c))) (cosine_term 1 1 q)) in
      if Qeq_bool c d then root (q * (1 # 2))%Q
      else if Qeq_bool c (- d) then root (90 - q * (1 # 2))%Q
      else None
  | _, _ => None
  end.
Definition perhaps_root (terms : list term) : option (list term) :=
  match terms with
  | [s; t] => match half_angle s t with Some r => Some r | None => half_angle t s end
  | _ => None
  end.
(** Whether it is. *)
Definition is_root (r terms : list term) : bool :=
  match sign_of_interval (interval_of_terms r) with
  | Some Gt => is_nothing (terms_minus (terms_times r r) terms)
  | _ => false
  end.

Definition root_e (a : enclosure) : enclosure :=
  let near := Near (Intervals.sqrt bits (interval_of a)) in
  let of_rational q := if Qle_bool 0 q then of_terms (terms_root q) else near in
  match a with
  | Exact q => of_rational q
  | Sum terms =>
      match rational_of (opened terms), perhaps_root terms with
      | Some q, _ => of_rational q
      | None, Some r => if is_root r terms then of_terms r else near
      | None, None => near
      end
  | _ => near
  end.

Definition cosine_e (a : enclosure) : enclosure :=
  match a with
  | Exact q => of_terms (cosine_term 1 1 q)
  | _ => Near (Intervals.cos bits (interval_in_radians (interval_of a)))
  end.
Definition sine_e (a : enclosure) : enclosure :=
  match a with
  | Exact q => of_terms (cosine_term 1 1 (90 - q))
  | _ => Near (Intervals.sin bits (interval_in_radians (interval_of a)))
  end.

(** The number of degrees in an interval that may be a whole number over `parts`. *)
Definition perhaps_degrees (i : Intervals.type) (parts : positive) : Q :=
  match Floats.toF (Intervals.midpoint i) with
  | Basic.Float negative m e =>
      let twice := Z.shiftl (2 * Zpos parts * (if negative then Zneg m else Zpos m)) e in
      Qred (((twice + 1) / 2) # parts)
  | _ => 0
  end.
(** Whether above/below is the tangent of such an angle. *)
Definition is_tangent (above below : list term) (q : Q) : bool :=
  match sign_of_interval (interval_of_terms below) with
  | Some Lt | Some Gt =>
      negb (Qle_bool 90 q) && negb (Qle_bool q (-90)) &&
      is_nothing (terms_minus (terms_times above (cosine_term 1 1 q)) (terms_times below (cosine_term 1 1 (90 - q))))
  | _ => false
  end.
Definition known_arctangent (above below : list term) (i : Intervals.type) : option Q :=
  let near q :=
    match sign_of_interval (Intervals.sub bits i (interval_of_rational q)) with Some Lt | Some Gt => false | _ => true end in
  List.find (fun q => near q && is_tangent above below q) (map (perhaps_degrees i) [1000; 3000; 1000000]%positive).

Definition arctangent_e (a : enclosure) : enclosure :=
  if is_0 a then Exact 0
  else
    let i := Intervals.div bits (Intervals.mul bits (Intervals.atan bits (interval_of a)) (Intervals.fromZ bits 180))
               (Intervals.pi bits) in
    let known := match a with
                 | Ratio above below _ => known_arctangent above below i
                 | _ => match terms_of a with Some l => known_arctangent l one i | None => None end
                 end in
    match known with Some q => Exact q | None => Near i end.

Definition sign_e (a : enclosure) : option comparison :=
  match a with
  | Exact q => Some (Qnum q ?= 0)%Z
  | _ =>
      match sign_of_interval (interval_of a), a with
      | Some c, _ => Some c
      | None, Sum terms | None, Ratio terms _ _ => if is_nothing terms then Some Eq else None
      | None, _ => None
      end
  end.

(** * They enclose *)

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
  destruct a as [p| | |], b as [q| | |]; try exact G.
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
  destruct a as [p| | |], b as [q| | |]; try exact G.
  cbn [encloses] in *. now rewrite red, Q2R_minus, A, B.
Qed.

Lemma is_0_encloses a x : encloses a x -> is_0 a = true -> x = 0.
Proof.
  destruct a as [q| | |]; cbn; try discriminate. intros <- E. apply Qeq_bool_eq, Qeq_eqR in E. rewrite E. unfold Q2R; cbn; lra.
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
  destruct a as [p| | |], b as [q| | |]; try exact G.
  cbn [encloses] in *. now rewrite red, Q2R_mult, A, B.
Qed.

Lemma nai_encloses x : in_interval Intervals.nai x.
Proof. apply of_nothing. rewrite Intervals.nai_correct. exact I. Qed.

Lemma over_encloses a b x y : encloses a x -> encloses b y -> encloses (over_e a b) (x / y).
Proof.
  intros A B. unfold over_e. destruct (is_0 a) eqn:Ea.
  { apply (is_0_encloses _ _ A) in Ea as ->. unfold Rdiv; rewrite Rmult_0_l. apply zero_encloses. }
  assert (I : in_interval (Intervals.div bits (interval_of a) (interval_of b)) (x / y))
    by (apply in_quotient; now apply interval_encloses).
  assert (G : encloses (let quotient := Intervals.div bits (interval_of a) (interval_of b) in
                        match terms_of a, terms_of b with
                        | Some l, Some m =>
                            match terms_inverse m with
                            | Some n => of_terms (terms_times l n)
                            | None => Ratio l m quotient
                            end
                        | _, _ => Near quotient
                        end) (x / y)).
  { cbv zeta. destruct (terms_of a) as [l|] eqn:La; [|exact I]. destruct (terms_of b) as [m|] eqn:Lb; [|exact I].
    pose proof (terms_of_value _ _ _ La A) as Va. pose proof (terms_of_value _ _ _ Lb B) as Vb.
    destruct (terms_inverse m) as [n|] eqn:N.
    - apply of_terms_encloses. now rewrite terms_times_value, (terms_inverse_value _ _ N), Va, Vb.
    - split; [now rewrite Va, Vb|exact I]. }
  destruct a as [p| | |], b as [q| | |]; try exact G.
  destruct (is_0 (Exact q)) eqn:Eb; [apply nai_encloses|]. cbn [encloses] in *. rewrite red, Q2R_div, A, B; [reflexivity|].
  cbn [is_0] in Eb. intro E. apply Qeq_bool_iff in E. congruence.
Qed.

Lemma is_root_holds r terms : is_root r terms = true -> sqrt (value terms) = value r.
Proof.
  unfold is_root. destruct (sign_of_interval _) as [[| |]|] eqn:S; try discriminate. intro E.
  apply (interval_sign _ _ _ (terms_in r)) in S. cbn in S. apply is_nothing_value in E.
  rewrite terms_minus_value, terms_times_value in E. replace (value terms) with (value r * value r) by lra.
  apply sqrt_square. lra.
Qed.

Lemma root_encloses a x : encloses a x -> encloses (root_e a) (sqrt x).
Proof.
  intro A. unfold root_e.
  assert (G : encloses (Near (Intervals.sqrt bits (interval_of a))) (sqrt x)) by now apply in_root, interval_encloses.
  assert (P : forall q, Q2R q = x ->
    encloses (if Qle_bool 0 q then of_terms (terms_root q) else Near (Intervals.sqrt bits (interval_of a))) (sqrt x)).
  { intros q Q. destruct (Qle_bool 0 q) eqn:E; [|exact G]. apply of_terms_encloses.
    rewrite terms_root_value by now apply Qle_bool_imp_le. now rewrite Q. }
  destruct a as [q|terms| |]; cbv zeta; [now apply P| |exact G..]. cbn [encloses] in A.
  destruct (rational_of (opened terms)) as [q|] eqn:E.
  - apply P. apply rational_of_value in E. rewrite opened_value in E. congruence.
  - destruct (perhaps_root terms) as [r|]; [|exact G]. destruct (is_root r terms) eqn:R; [|exact G].
    apply of_terms_encloses. apply is_root_holds in R. congruence.
Qed.

Lemma whole_cosine_value q : value (cosine_term 1 1 q) = cosine q.
Proof. rewrite cosine_term_value. replace (Q2R 1) with 1 by (unfold Q2R; cbn; lra). rewrite sqrt_1. ring. Qed.

Lemma cosine_encloses a x : encloses a x -> encloses (cosine_e a) (cos (x * PI / 180)).
Proof.
  intro A. unfold cosine_e.
  assert (I : in_interval (Intervals.cos bits (interval_in_radians (interval_of a))) (cos (x * PI / 180))).
  { apply Intervals.cos_correct with (x := Xreal.Xreal (x * PI / 180)). now apply in_radians, interval_encloses. }
  destruct a as [q| | |]; [|exact I..]. apply of_terms_encloses. rewrite whole_cosine_value. cbn in A. now rewrite <- A.
Qed.
Lemma sine_encloses a x : encloses a x -> encloses (sine_e a) (sin (x * PI / 180)).
Proof.
  intro A. unfold sine_e.
  assert (I : in_interval (Intervals.sin bits (interval_in_radians (interval_of a))) (sin (x * PI / 180))).
  { apply Intervals.sin_correct with (x := Xreal.Xreal (x * PI / 180)). now apply in_radians, interval_encloses. }
  destruct a as [q| | |]; [|exact I..]. apply of_terms_encloses. rewrite whole_cosine_value. cbn in A. rewrite <- A.
  symmetry. apply sine_is_cosine.
Qed.

Lemma is_tangent_holds above below q : is_tangent above below q = true ->
  atan (value above / value below) * 180 / PI = Q2R q.
Proof.
  unfold is_tangent. intro E.
  assert (N : value below <> 0).
  { destruct (sign_of_interval _) as [[| |]|] eqn:S; try discriminate; apply (interval_sign _ _ _ (terms_in below)) in S; lra. }
  assert (H : (negb (Qle_bool 90 q) && negb (Qle_bool q (-90)) &&
    is_nothing (terms_minus (terms_times above (cosine_term 1 1 q)) (terms_times below (cosine_term 1 1 (90 - q)))))%bool = true)
    by (destruct (sign_of_interval _) as [[| |]|]; (exact E || discriminate)).
  apply andb_prop in H as [H Z]. apply andb_prop in H as [U L]. apply Bool.negb_true_iff in U, L.
  assert (Up : Q2R q < 90).
  { replace 90 with (Q2R 90) by (unfold Q2R; cbn; lra). apply Qlt_Rlt, Qnot_le_lt. intro H. apply Qle_bool_iff in H. congruence. }
  assert (Low : -90 < Q2R q).
  { replace (-90) with (Q2R (-90)) by (unfold Q2R; cbn; lra). apply Qlt_Rlt, Qnot_le_lt. intro H.
    apply Qle_bool_iff in H. congruence. }
  apply is_nothing_value in Z. rewrite terms_minus_value, !terms_times_value, !whole_cosine_value, <- sine_is_cosine in Z.
  unfold cosine in Z. set (y := Q2R q * PI / 180) in *. pose proof PI_RGT_0 as Pi.
  assert (B : - (PI / 2) < y < PI / 2) by (unfold y; split; nra).
  assert (C : 0 < cos y) by (apply cos_gt_0; lra).
  replace (value above / value below) with (tan y).
  - rewrite atan_tan by exact B. unfold y. field. lra.
  - unfold tan. apply (Rmult_eq_reg_r (value below * cos y)).
    + replace (sin y / cos y * (value below * cos y)) with (value below * sin y) by (field; lra).
      replace (value above / value below * (value below * cos y)) with (value above * cos y) by (field; exact N). lra.
    + apply Rmult_integral_contrapositive_currified; lra.
Qed.

Lemma known_arctangent_holds above below i q : known_arctangent above below i = Some q ->
  atan (value above / value below) * 180 / PI = Q2R q.
Proof.
  unfold known_arctangent. intro E. apply List.find_some in E as [_ E]. apply andb_prop in E as [_ E].
  now apply is_tangent_holds.
Qed.

Lemma arctangent_encloses a x : encloses a x -> encloses (arctangent_e a) (atan x * 180 / PI).
Proof.
  intro A. unfold arctangent_e. destruct (is_0 a) eqn:E.
  { apply (is_0_encloses _ _ A) in E as ->. rewrite atan_0. unfold Rdiv. rewrite !Rmult_0_l. apply zero_encloses. }
  cbv zeta. set (i := Intervals.div bits _ _).
  assert (I : in_interval i (atan x * 180 / PI)).
  { unfold i. apply in_quotient; [|apply Intervals.pi_correct]. apply in_product; [|apply Intervals.fromZ_correct].
    apply Intervals.atan_correct with (x := Xreal.Xreal x). now apply interval_encloses. }
  assert (T : match (match terms_of a with Some l => known_arctangent l one i | None => None end) with
              | Some q => atan x * 180 / PI = Q2R q
              | None => True
              end).
  { destruct (terms_of a) as [l|] eqn:L; [|exact Logic.I]. destruct (known_arctangent l one i) as [q|] eqn:K; [|exact Logic.I].
    apply known_arctangent_holds in K. rewrite one_value, (terms_of_value _ _ _ L A) in K.
    now replace (x / 1) with x in K by field. }
  destruct a as [p|terms|above below j|j]; cbn [terms_of] in T |- *.
  - destruct (known_arctangent _ _ _); [now symmetry|exact I].
  - destruct (known_arctangent _ _ _); [now symmetry|exact I].
  - destruct (known_arctangent _ _ _) as [q|] eqn:K; [|exact I]. apply known_arctangent_holds in K. destruct A as [A _].
    rewrite A in K. now symmetry.
  - exact I.
Qed.

Lemma sign_encloses a x c : encloses a x -> sign_e a = Some c -> real_sign x = Some c.
Proof.
  intros A E.
  assert (G : forall c, sign_of_interval (interval_of a) = Some c -> real_sign x = Some c).
  { intros d D. apply real_sign_is. eapply interval_sign; [apply interval_encloses; exact A|exact D]. }
  destruct a as [q|terms|above below i|i]; cbn [sign_e] in E.
  - cbn [encloses] in A. injection E as <-. apply real_sign_is. rewrite <- A. unfold Q2R.
    assert (D : 0 < / IZR (Zpos (Qden q))) by (apply Rinv_0_lt_compat, IZR_lt; reflexivity).
    destruct (Z.compare_spec (Qnum q) 0) as [Z|Z|Z].
    + rewrite Z; lra.
    + apply IZR_lt in Z. nra.
    + apply IZR_lt in Z. nra.
  - destruct (sign_of_interval _) as [d|]; [apply G; congruence|].
    destruct (is_nothing terms) eqn:N; [|discriminate]. apply is_nothing_value in N. injection E as <-. apply real_sign_is.
    cbn [encloses] in A. lra.
  - destruct (sign_of_interval _) as [d|]; [apply G; congruence|].
    destruct (is_nothing above) eqn:N; [|discriminate]. apply is_nothing_value in N. injection E as <-. apply real_sign_is.
    destruct A as [A _]. rewrite <- A, N. unfold Rdiv. ring.
  - destruct (sign_of_interval _) as [d|]; [apply G; congruence|discriminate].
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
