(* SPDX-License-Identifier: Apache-2.0 *)
(** Sums of square roots of natural numbers and cosines of degrees, with rational coefficients: what can be said of them
    without rounding. *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List.
From Toolcomp Require Import Cosines.
Import ListNotations.
Local Open Scope R_scope.

(** factor times the root of what is under it times the cosine of degrees, which are 0 where there is none. *)
Record term := Term { factor : Q; under : positive; degrees : Q }.

Definition term_value (t : term) : R := Q2R (factor t) * sqrt (IZR (Zpos (under t))) * cosine (degrees t).
Definition value (terms : list term) : R := fold_right (fun t x => term_value t + x) 0 terms.

(** * Of one root *)

(** Most numbers that are no squares are found out by remainders: of 8, once fours are taken out, and of small primes. *)
Fixpoint square_by_bits (n : positive) : bool :=
  match n with xO (xO m) => square_by_bits m | xI (xO (xO _)) | xH => true | _ => false end.
Definition square_by_primes (n : positive) : bool :=
  let rest := (Zpos n mod 15015)%Z in
  forallb (fun p => existsb (fun k => (k * k mod p =? rest mod p)%Z) [0; 1; 2; 3; 4; 5; 6]%Z) [3; 5; 7; 11; 13]%Z.

(** The root of a natural number, where it is one. *)
Definition whole_root (n : positive) : option positive :=
  if square_by_bits n && square_by_primes n then
    match Z.sqrt (Zpos n) with Zpos r => if (r * r =? n)%positive then Some r else None | _ => None end
  else None.

(** c√a as a multiple of √b, where a·b is a square. *)
Definition as_multiple (c : Q) (a b : positive) : option Q :=
  if (a =? b)%positive then Some c
  else match whole_root (a * b) with Some r => Some (Qred (c * (Zpos r # b))) | None => None end.

Definition same_degrees (p q : Q) : bool := (Qnum p =? Qnum q)%Z && (Qden p =? Qden q)%positive.
Definition without_cosine (t : term) : bool := same_degrees (degrees t) 0.

(** Added to the term of its kind. *)
Fixpoint add_term (t : term) (terms : list term) : list term :=
  match terms with
  | [] => [t]
  | s :: rest =>
      match (if same_degrees (degrees s) (degrees t) then as_multiple (factor t) (under t) (under s) else None) with
      | Some c =>
          let sum := Qred (factor s + c) in
          if Qeq_bool sum 0 then rest else Term sum (under s) (degrees s) :: rest
      | None => s :: add_term t rest
      end
  end.

(** √a√b = g√n. *)
Definition root_product (a b : positive) : positive * positive :=
  let g := Pos.gcd a b in
  let a' := Z.to_pos (Zpos a / Zpos g) in
  let b' := Z.to_pos (Zpos b / Zpos g) in
  if (g * a' =? a)%positive && (g * b' =? b)%positive then (g, a' * b')%positive else (1, a * b)%positive.

(** c√n times the cosine of any degrees. *)
Definition cosine_term (c : Q) (n : positive) (q : Q) : list term :=
  let '(negative, w) := folded q in
  let c := if negative then Qopp c else c in
  if Qeq_bool w 0 then [Term c n 0]
  else if Qeq_bool w 90 then []
  else if Qeq_bool w 60 then [Term (Qred (c * (1 # 2))) n 0]
  else if Qeq_bool w 45 then [Term (Qred (c * (1 # 2))) (2 * n) 0]
  else if Qeq_bool w 30 then [Term (Qred (c * (1 # 2))) (3 * n) 0]
  else [Term c n w].

(** The product of two terms: 2 cos p cos q = cos (p + q) + cos (p - q). *)
Definition times_term (s t : term) : list term :=
  let '(g, n) := root_product (under s) (under t) in
  let c := Qred (factor s * factor t * (Zpos g # 1)) in
  if without_cosine s then [Term c n (degrees t)]
  else if without_cosine t then [Term c n (degrees s)]
  else
    let half := Qred (c * (1 # 2)) in
    cosine_term half n (degrees s + degrees t) ++ cosine_term half n (degrees s - degrees t).

(** * Of sums *)

Definition opposite (terms : list term) : list term :=
  map (fun t => Term (Qopp (factor t)) (under t) (degrees t)) terms.
Definition terms_plus (l m : list term) : list term := fold_right add_term m l.
Definition terms_minus (l m : list term) : list term := terms_plus (opposite m) l.
Definition terms_times (l m : list term) : list term :=
  fold_right (fun s sum => terms_plus (flat_map (times_term s) m) sum) [] l.

(** √(n/d) = √(nd)/d. *)
Definition terms_root (q : Q) : list term :=
  match Qnum q with
  | Zpos n =>
      match as_multiple (1 # Qden q) (n * Qden q) 1 with
      | Some c => [Term c 1 0]
      | None => [Term (1 # Qden q) (n * Qden q) 0]
      end
  | _ => []
  end.

(** 1 over one term, or over two: 1/(s + t) = (s - t)/(s² - t²), both without cosines. *)
Definition square_of (t : term) : Q := Qred (factor t * factor t * (Zpos (under t) # 1)).
Definition terms_inverse (l : list term) : option (list term) :=
  match l with
  | [t] =>
      if without_cosine t && negb (Qeq_bool (factor t) 0) then Some [Term (Qred (factor t / square_of t)) (under t) 0]
      else None
  | [s; t] =>
      let d := Qred (square_of s - square_of t) in
      if without_cosine s && without_cosine t && negb (Qeq_bool d 0)
      then Some [Term (Qred (factor s / d)) (under s) 0; Term (Qred (- factor t / d)) (under t) 0]
      else None
  | _ => None
  end.

(** * Whether a sum is nothing *)

(** The same with cosines of less than 60 degrees alone: roots of 2 and of 3 are twice the cosines of 45 and of 30
    degrees, and cos (60 + r) = cos r - cos (60 - r). *)
Definition small_term (c : Q) (n : positive) (q : Q) (terms : list term) : list term :=
  let '(negative, w) := folded q in
  let c := if negative then Qopp c else c in
  if Qeq_bool w 0 then add_term (Term c n 0) terms
  else if Qeq_bool w 90 then terms
  else if Qeq_bool w 60 then add_term (Term (Qred (c * (1 # 2))) n 0) terms
  else if Qle_bool 60 w then add_term (Term c n (Qred (w - 60))) (add_term (Term (Qopp c) n (Qred (120 - w))) terms)
  else add_term (Term c n w) terms.
Fixpoint opened_term (fuel : nat) (c : Q) (n : positive) (q : Q) (terms : list term) : list term :=
  match fuel with
  | O => small_term c n q terms
  | S fuel =>
      match n with
      | xO m => opened_term fuel c m (q + 45) (opened_term fuel c m (q - 45) terms)
      | _ =>
          let m := Z.to_pos (Zpos n / 3) in
          if (3 * m =? n)%positive then opened_term fuel c m (q + 30) (opened_term fuel c m (q - 30) terms)
          else small_term c n q terms
      end
  end.
Definition opened (terms : list term) : list term :=
  fold_right (fun t sum => opened_term 4 (factor t) (under t) (degrees t) sum) [] terms.
Definition is_nothing (terms : list term) : bool :=
  match terms with [] => true | _ => match opened terms with [] => true | _ => false end end.

(** * Their values *)

Lemma pos_IZR p : 0 < IZR (Zpos p).
Proof. apply IZR_lt. reflexivity. Qed.

Lemma whole_root_value n r : whole_root n = Some r -> sqrt (IZR (Zpos n)) = IZR (Zpos r).
Proof.
  unfold whole_root. destruct (_ && _)%bool; [|discriminate]. destruct (Z.sqrt (Zpos n)) as [|s|]; try discriminate.
  destruct (s * s =? n)%positive eqn:E; [|discriminate]. intros [= <-]. apply Pos.eqb_eq in E. subst n.
  rewrite Pos2Z.inj_mul, mult_IZR. apply sqrt_square. apply Rlt_le, pos_IZR.
Qed.

Lemma as_multiple_value c a b m : as_multiple c a b = Some m ->
  Q2R c * sqrt (IZR (Zpos a)) = Q2R m * sqrt (IZR (Zpos b)).
Proof.
  unfold as_multiple. destruct (a =? b)%positive eqn:Same; [apply Pos.eqb_eq in Same; intros; congruence|].
  destruct (whole_root (a * b)) as [r|] eqn:E; [|discriminate]. intro M.
  assert (M' : m = Qred (c * (Zpos r # b))) by congruence. rewrite M'. clear M M'.
  apply whole_root_value in E. rewrite red, Q2R_mult. unfold Q2R at 3; cbn [Qnum Qden].
  pose proof (pos_IZR a) as A. pose proof (pos_IZR b) as B.
  rewrite Pos2Z.inj_mul, mult_IZR, sqrt_mult in E by lra. rewrite <- E.
  pose proof (sqrt_sqrt (IZR (Zpos b)) ltac:(lra)) as S.
  assert (N : IZR (Zpos b) <> 0) by lra.
  replace (Q2R c * (sqrt (IZR (Zpos a)) * sqrt (IZR (Zpos b)) * / IZR (Zpos b)) * sqrt (IZR (Zpos b)))
    with (Q2R c * sqrt (IZR (Zpos a)) * ((sqrt (IZR (Zpos b)) * sqrt (IZR (Zpos b))) * / IZR (Zpos b))) by ring.
  rewrite S, Rinv_r by assumption. ring.
Qed.

Lemma zero_value q : Qeq_bool q 0 = true -> Q2R q = 0.
Proof. intro E. apply Qeq_bool_eq, Qeq_eqR in E. rewrite E. unfold Q2R; cbn; lra. Qed.
Lemma not_zero_value q : Qeq_bool q 0 = false -> Q2R q <> 0.
Proof.
  intros E Z. assert (H : q == 0) by (apply eqR_Qeq; rewrite Z; unfold Q2R; cbn; lra).
  apply Qeq_bool_iff in H. congruence.
Qed.
Lemma half_value : Q2R (1 # 2) = / 2.
Proof. unfold Q2R; cbn. lra. Qed.

Lemma same_degrees_holds p q : same_degrees p q = true -> p = q.
Proof.
  destruct p, q. unfold same_degrees; cbn. intro E. apply andb_prop in E as [A B]. apply Z.eqb_eq in A. apply Pos.eqb_eq in B.
  congruence.
Qed.
Lemma without_cosine_value t : without_cosine t = true -> cosine (degrees t) = 1.
Proof. intro E. apply same_degrees_holds in E. rewrite E. apply cosine_0. Qed.

Lemma value_cons t l : value (t :: l) = term_value t + value l.
Proof. reflexivity. Qed.
Lemma value_append l m : value (l ++ m) = value l + value m.
Proof. induction l as [|t l IH]; cbn [app]; [change (value []) with 0; ring|]. rewrite !value_cons, IH. ring. Qed.

Lemma add_term_value t terms : value (add_term t terms) = term_value t + value terms.
Proof.
  induction terms as [|s rest IH]; [reflexivity|]. cbn [add_term].
  destruct (same_degrees _ _) eqn:D; [|rewrite !value_cons, IH; lra].
  destruct (as_multiple _ _ _) as [c|] eqn:E; [|rewrite !value_cons, IH; lra].
  apply as_multiple_value in E. apply same_degrees_holds in D. rewrite value_cons. unfold term_value at 1 2. rewrite E, D.
  pose proof (red (factor s + c)) as S. rewrite Q2R_plus in S.
  destruct (Qeq_bool (Qred (factor s + c)) 0) eqn:Z.
  - apply zero_value in Z. rewrite Z in S. assert (H : Q2R c = - Q2R (factor s)) by lra. rewrite H. lra.
  - rewrite value_cons. unfold term_value; cbn [factor under degrees]. rewrite S. lra.
Qed.

Lemma root_product_value a b g n : root_product a b = (g, n) ->
  sqrt (IZR (Zpos a)) * sqrt (IZR (Zpos b)) = IZR (Zpos g) * sqrt (IZR (Zpos n)).
Proof.
  unfold root_product. set (f := Pos.gcd _ _). set (a' := Z.to_pos _). set (b' := Z.to_pos (Zpos b / Zpos f)).
  destruct (_ && _)%bool eqn:E; intro P.
  - assert (G : g = f) by congruence. assert (N : n = (a' * b')%positive) by congruence. rewrite G, N. clear P G N.
    apply andb_prop in E as [A B]. apply Pos.eqb_eq in A, B.
    generalize dependent b'; generalize dependent a'; generalize dependent f. intros f a' A b' B. rewrite <- A, <- B. clear A B.
    rewrite !Pos2Z.inj_mul, !mult_IZR.
    pose proof (pos_IZR f). pose proof (pos_IZR a'). pose proof (pos_IZR b').
    rewrite !sqrt_mult by lra. pose proof (sqrt_sqrt (IZR (Zpos f)) ltac:(lra)) as S.
    transitivity ((sqrt (IZR (Zpos f)) * sqrt (IZR (Zpos f))) * (sqrt (IZR (Zpos a')) * sqrt (IZR (Zpos b')))).
    { ring. }
    now rewrite S.
  - assert (G : g = 1%positive) by congruence. assert (N : n = (a * b)%positive) by congruence. rewrite G, N.
    rewrite Pos2Z.inj_mul, mult_IZR, sqrt_mult by (apply Rlt_le, pos_IZR). ring.
Qed.

Lemma root_of_multiple p n : sqrt (IZR (Zpos (p * n))) = sqrt (IZR (Zpos p)) * sqrt (IZR (Zpos n)).
Proof. rewrite Pos2Z.inj_mul, mult_IZR. apply sqrt_mult; apply Rlt_le, pos_IZR. Qed.

(** A cosine of folded degrees, with the sign that they have. *)
Lemma folded_term c n q negative w : folded q = (negative, w) ->
  Q2R c * sqrt (IZR (Zpos n)) * cosine q = term_value (Term (if negative then Qopp c else c) n w).
Proof.
  intro F. apply folded_cosine in F. rewrite F. unfold term_value; cbn [factor under degrees].
  destruct negative; rewrite ?Q2R_opp; ring.
Qed.

Lemma equal_degrees p q : Qeq_bool p q = true -> cosine p = cosine q.
Proof. intro E. apply cosine_equal. now apply Qeq_bool_eq. Qed.

Ltac at_degrees E simple :=
  apply equal_degrees in E; unfold term_value; cbn [factor under degrees];
  rewrite ?red, ?Q2R_mult, ?half_value, ?root_of_multiple, ?E, ?simple, ?cosine_0; ring.

Lemma cosine_term_value c n q : value (cosine_term c n q) = Q2R c * sqrt (IZR (Zpos n)) * cosine q.
Proof.
  unfold cosine_term. destruct (folded q) as [negative w] eqn:F. rewrite (folded_term c n q negative w F).
  generalize (if negative then Qopp c else c). intro d. clear F.
  destruct (Qeq_bool w 0) eqn:E0; [rewrite value_cons; change (value []) with 0; at_degrees E0 cosine_0|].
  destruct (Qeq_bool w 90) eqn:E90; [change (value []) with 0; at_degrees E90 cosine_90|].
  destruct (Qeq_bool w 60) eqn:E60; [rewrite value_cons; change (value []) with 0; at_degrees E60 cosine_60|].
  destruct (Qeq_bool w 45) eqn:E45; [rewrite value_cons; change (value []) with 0; at_degrees E45 cosine_45|].
  destruct (Qeq_bool w 30) eqn:E30; [rewrite value_cons; change (value []) with 0; at_degrees E30 cosine_30|].
  rewrite value_cons. change (value []) with 0. ring.
Qed.

Lemma times_term_value s t : value (times_term s t) = term_value s * term_value t.
Proof.
  unfold times_term. destruct (root_product _ _) as [g n] eqn:P. apply root_product_value in P.
  set (c := Qred (factor s * factor t * (Zpos g # 1))).
  assert (C : Q2R c * sqrt (IZR (Zpos n)) =
              (Q2R (factor s) * sqrt (IZR (Zpos (under s)))) * (Q2R (factor t) * sqrt (IZR (Zpos (under t))))).
  { unfold c. rewrite red, !Q2R_mult. unfold Q2R at 3; cbn [Qnum Qden]. rewrite Rinv_1, Rmult_1_r.
    replace (Q2R (factor s) * Q2R (factor t) * IZR (Zpos g) * sqrt (IZR (Zpos n)))
      with (Q2R (factor s) * Q2R (factor t) * (IZR (Zpos g) * sqrt (IZR (Zpos n)))) by ring. rewrite <- P. ring. }
  destruct (without_cosine s) eqn:S; [|destruct (without_cosine t) eqn:T].
  - apply without_cosine_value in S. rewrite value_cons. change (value []) with 0. unfold term_value; cbn [factor under degrees].
    rewrite C, S. ring.
  - apply without_cosine_value in T. rewrite value_cons. change (value []) with 0. unfold term_value; cbn [factor under degrees].
    rewrite C, T. ring.
  - rewrite value_append, !cosine_term_value, red, Q2R_mult, half_value.
    replace (Q2R c * / 2 * sqrt (IZR (Zpos n)) * cosine (degrees s + degrees t) +
             Q2R c * / 2 * sqrt (IZR (Zpos n)) * cosine (degrees s - degrees t))
      with (Q2R c * sqrt (IZR (Zpos n)) * (/ 2 * (cosine (degrees s + degrees t) + cosine (degrees s - degrees t)))) by ring.
    rewrite <- cosine_product, C. unfold term_value. ring.
Qed.

Lemma terms_plus_value l m : value (terms_plus l m) = value l + value m.
Proof.
  unfold terms_plus. induction l as [|t l IH]; cbn [fold_right].
  - change (value []) with 0. ring.
  - rewrite add_term_value, IH, value_cons. ring.
Qed.

Lemma opposite_value m : value (opposite m) = - value m.
Proof.
  unfold opposite. induction m as [|t m IH]; cbn [map]; [change (value []) with 0; ring|].
  rewrite !value_cons, IH. unfold term_value; cbn [factor under degrees]. rewrite Q2R_opp. ring.
Qed.

Lemma terms_minus_value l m : value (terms_minus l m) = value l - value m.
Proof. unfold terms_minus. rewrite terms_plus_value, opposite_value. ring. Qed.

Lemma term_times_value s m : value (flat_map (times_term s) m) = term_value s * value m.
Proof.
  induction m as [|t m IH]; cbn [flat_map]; [change (value []) with 0; ring|].
  rewrite value_append, value_cons, IH, times_term_value. ring.
Qed.

Lemma terms_times_value l m : value (terms_times l m) = value l * value m.
Proof.
  unfold terms_times. induction l as [|s l IH]; cbn [fold_right]; [change (value []) with 0; ring|].
  rewrite terms_plus_value, term_times_value, IH, value_cons. ring.
Qed.

Lemma terms_root_value q : (0 <= q)%Q -> value (terms_root q) = sqrt (Q2R q).
Proof.
  intro P. unfold terms_root. destruct q as [n d]; cbn [Qnum Qden]. destruct n as [|n|n].
  - cbn. unfold Q2R; cbn. rewrite Rmult_0_l, sqrt_0. reflexivity.
  - assert (V : Q2R (1 # d) * sqrt (IZR (Zpos (n * d))) = sqrt (Q2R (Zpos n # d))).
    { unfold Q2R; cbn [Qnum Qden].
      pose proof (pos_IZR n) as N. pose proof (pos_IZR d) as D. assert (I : 0 < / IZR (Zpos d)) by now apply Rinv_0_lt_compat.
      rewrite Pos2Z.inj_mul, mult_IZR, !sqrt_mult by lra.
      pose proof (sqrt_sqrt (IZR (Zpos d)) ltac:(lra)) as S.
      rewrite sqrt_inv by lra.
      assert (Q0 : 0 < sqrt (IZR (Zpos d))) by (apply sqrt_lt_R0; lra).
      rewrite <- S at 1. field. lra. }
    destruct (as_multiple _ _ _) as [c|] eqn:E.
    + apply as_multiple_value in E. rewrite value_cons. change (value []) with 0. unfold term_value; cbn [factor under degrees].
      rewrite <- E, cosine_0. rewrite <- V. ring.
    + rewrite value_cons. change (value []) with 0. unfold term_value; cbn [factor under degrees]. rewrite cosine_0, <- V. ring.
  - exfalso. unfold Qle in P. cbn [Qnum Qden] in P. rewrite Z.mul_1_r in P. lia.
Qed.

Lemma square_value t : Q2R (square_of t) = (Q2R (factor t) * sqrt (IZR (Zpos (under t)))) * (Q2R (factor t) * sqrt (IZR (Zpos (under t)))).
Proof.
  unfold square_of. rewrite red, !Q2R_mult. unfold Q2R at 3; cbn [Qnum Qden]. rewrite Rinv_1, Rmult_1_r.
  pose proof (pos_IZR (under t)). pose proof (sqrt_sqrt (IZR (Zpos (under t))) ltac:(lra)) as S. rewrite <- S at 1. ring.
Qed.

Lemma plain_value t : without_cosine t = true -> term_value t = Q2R (factor t) * sqrt (IZR (Zpos (under t))).
Proof. intro E. unfold term_value. rewrite (without_cosine_value _ E). ring. Qed.
Lemma plain_term c n : term_value (Term c n 0) = Q2R c * sqrt (IZR (Zpos n)).
Proof. now apply plain_value. Qed.

Lemma terms_inverse_value l m : terms_inverse l = Some m -> value m = / value l.
Proof.
  destruct l as [|s [|t [|]]]; cbn [terms_inverse]; try discriminate.
  - destruct (_ && _)%bool eqn:Z; [|discriminate]. intro M. apply andb_prop in Z as [C Z].
    apply Bool.negb_true_iff, not_zero_value in Z.
    assert (M' : m = [Term (Qred (factor s / square_of s)) (under s) 0]) by congruence. rewrite M'. clear M M'.
    rewrite !value_cons. change (value []) with 0. rewrite plain_term, (plain_value _ C). pose proof (square_value s) as S.
    assert (R0 : 0 < sqrt (IZR (Zpos (under s)))) by apply sqrt_lt_R0, pos_IZR.
    assert (R1 : sqrt (IZR (Zpos (under s))) <> 0) by now apply Rgt_not_eq.
    assert (N : Q2R (square_of s) <> 0)
      by (rewrite S; apply Rmult_integral_contrapositive_currified; apply Rmult_integral_contrapositive_currified; assumption).
    rewrite red, Q2R_div, S.
    + rewrite !Rplus_0_r. field. split; assumption.
    + intro E. apply N. apply Qeq_eqR in E. rewrite E. unfold Q2R; cbn; lra.
  - destruct (_ && _)%bool eqn:Z; [|discriminate]. intro M. apply andb_prop in Z as [C Z]. apply andb_prop in C as [C1 C2].
    apply Bool.negb_true_iff, not_zero_value in Z.
    set (d := Qred (square_of s - square_of t)) in *.
    assert (M' : m = [Term (Qred (factor s / d)) (under s) 0; Term (Qred (- factor t / d)) (under t) 0]) by congruence.
    rewrite M'. clear M M'. subst d. rewrite red, Q2R_minus in Z.
    rewrite !value_cons. change (value []) with 0. rewrite !plain_term, (plain_value _ C1), (plain_value _ C2).
    assert (D : ~ Qred (square_of s - square_of t) == 0).
    { intro E. apply Qeq_eqR in E. rewrite red, Q2R_minus in E. apply Z. rewrite E. unfold Q2R; cbn; lra. }
    rewrite !red, !Q2R_div, Q2R_opp, red, Q2R_minus by assumption.
    rewrite !square_value in *. set (x := Q2R (factor s) * sqrt _) in *. set (y := Q2R (factor t) * sqrt _) in *.
    rewrite !Rplus_0_r.
    replace (Q2R (factor s) / (x * x - y * y) * sqrt (IZR (Zpos (under s)))) with (x / (x * x - y * y)) by (unfold x, Rdiv; ring).
    replace (- Q2R (factor t) / (x * x - y * y) * sqrt (IZR (Zpos (under t)))) with (- y / (x * x - y * y))
      by (unfold y, Rdiv; ring).
    assert (x + y <> 0) by (intro E; apply Z; replace (x * x - y * y) with ((x + y) * (x - y)) by ring; rewrite E; ring).
    field. split; assumption.
Qed.

Lemma small_term_value c n q terms :
  value (small_term c n q terms) = Q2R c * sqrt (IZR (Zpos n)) * cosine q + value terms.
Proof.
  unfold small_term. destruct (folded q) as [negative w] eqn:F. rewrite (folded_term c n q negative w F).
  generalize (if negative then Qopp c else c). intro d. clear F.
  destruct (Qeq_bool w 0) eqn:E0; [rewrite add_term_value; at_degrees E0 cosine_0|].
  destruct (Qeq_bool w 90) eqn:E90; [at_degrees E90 cosine_90|].
  destruct (Qeq_bool w 60) eqn:E60; [rewrite add_term_value; at_degrees E60 cosine_60|].
  destruct (Qle_bool 60 w); [|apply add_term_value].
  rewrite !add_term_value. unfold term_value; cbn [factor under degrees].
  rewrite (cosine_beyond_60 w), !cosine_red, Q2R_opp. ring.
Qed.

Lemma opened_term_value fuel : forall c n q terms,
  value (opened_term fuel c n q terms) = Q2R c * sqrt (IZR (Zpos n)) * cosine q + value terms.
Proof.
  induction fuel as [|fuel IH]; intros c n q terms; cbn [opened_term]; [apply small_term_value|].
  assert (T : value (let m := Z.to_pos (Zpos n / 3) in
                     if (3 * m =? n)%positive then opened_term fuel c m (q + 30) (opened_term fuel c m (q - 30) terms)
                     else small_term c n q terms) = Q2R c * sqrt (IZR (Zpos n)) * cosine q + value terms).
  { cbv zeta. generalize (Z.to_pos (Zpos n / 3)). intro m. destruct (3 * m =? n)%positive eqn:E; [|apply small_term_value].
    apply Pos.eqb_eq in E. rewrite !IH, <- E, root_of_multiple.
    replace (Q2R c * (sqrt 3 * sqrt (IZR (Zpos m))) * cosine q)
      with (Q2R c * sqrt (IZR (Zpos m)) * (sqrt 3 * cosine q)) by ring.
    rewrite root_3_cosine. ring. }
  destruct n as [n|m|]; [exact T| |exact T]. clear T. rewrite !IH.
  change (Zpos (xO m)) with (Zpos (2 * m)). rewrite root_of_multiple.
  replace (Q2R c * (sqrt 2 * sqrt (IZR (Zpos m))) * cosine q)
    with (Q2R c * sqrt (IZR (Zpos m)) * (sqrt 2 * cosine q)) by ring.
  rewrite root_2_cosine. ring.
Qed.

Lemma opened_value terms : value (opened terms) = value terms.
Proof.
  induction terms as [|t terms IH]; [reflexivity|]. cbn [opened fold_right]. rewrite opened_term_value.
  change (fold_right _ [] terms) with (opened terms). rewrite IH. reflexivity.
Qed.

Lemma is_nothing_value terms : is_nothing terms = true -> value terms = 0.
Proof.
  unfold is_nothing. destruct terms as [|t terms]; [reflexivity|]. rewrite <- (opened_value (t :: terms)).
  destruct (opened (t :: terms)); [reflexivity|discriminate].
Qed.
