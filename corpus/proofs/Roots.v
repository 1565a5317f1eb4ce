(** Sums of square roots of natural numbers with rational coefficients: what can be said of them without rounding. *)
From Coq Require Import ZArith QArith Qreals Reals Lra Lia List.
Import ListNotations.
Local Open Scope R_scope.

(** A coefficient, and what its root is taken of. *)
Definition term := (Q * positive)%type.

Definition value (terms : list term) : R := fold_right (fun t x => Q2R (fst t) * sqrt (IZR (Zpos (snd t))) + x) 0 terms.

(** * Of one root *)

(** The root of a natural number, where it is one. *)
Definition whole_root (n : positive) : option positive :=
  match Z.sqrt (Zpos n) with Zpos r => if (r * r =? n)%positive then Some r else None | _ => None end.

(** c√a as a multiple of √b, where a·b is a square. *)
Definition as_multiple (c : Q) (a b : positive) : option Q :=
  match whole_root (a * b) with Some r => Some (Qred (c * (Zpos r # b))) | None => None end.

(** Added to the term of its kind. *)
Fixpoint add_term (t : term) (terms : list term) : list term :=
  match terms with
  | [] => [t]
  | s :: rest =>
      match as_multiple (fst t) (snd t) (snd s) with
      | Some c =>
          let sum := Qred (fst s + c) in
          if Qeq_bool sum 0 then rest else (sum, snd s) :: rest
      | None => s :: add_term t rest
      end
  end.

(** The product of two terms: √(ga)√(gb) = g√(ab). *)
Definition times_term (s t : term) : term :=
  let g := Pos.gcd (snd s) (snd t) in
  let a := Z.to_pos (Zpos (snd s) / Zpos g) in
  let b := Z.to_pos (Zpos (snd t) / Zpos g) in
  if (g * a =? snd s)%positive && (g * b =? snd t)%positive
  then (Qred (fst s * fst t * (Zpos g # 1)), a * b)%positive
  else (Qred (fst s * fst t), snd s * snd t)%positive.

(** * Of sums *)

Definition terms_plus (l m : list term) : list term := fold_right add_term m l.
Definition terms_minus (l m : list term) : list term := terms_plus (map (fun t => (Qopp (fst t), snd t)) m) l.
Definition terms_times (l m : list term) : list term :=
  fold_right (fun s sum => terms_plus (map (times_term s) m) sum) [] l.

(** √(n/d) = √(nd)/d. *)
Definition terms_root (q : Q) : list term :=
  match Qnum q with
  | Zpos n => add_term ((1 # Qden q)%Q, (n * Qden q)%positive) [(0%Q, 1%positive)]
  | _ => []
  end.

(** 1 over one term, or over two: 1/(s + t) = (s - t)/(s² - t²). *)
Definition square_of (t : term) : Q := Qred (fst t * fst t * (Zpos (snd t) # 1)).
Definition terms_inverse (l : list term) : option (list term) :=
  match l with
  | [t] => if Qeq_bool (fst t) 0 then None else Some [(Qred (fst t / square_of t), snd t)]
  | [s; t] =>
      let d := Qred (square_of s - square_of t) in
      if Qeq_bool d 0 then None else Some [(Qred (fst s / d), snd s); (Qred (- fst t / d), snd t)]
  | _ => None
  end.

(** * Their values *)

Lemma red_value q : Q2R (Qred q) = Q2R q.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma pos_IZR p : 0 < IZR (Zpos p).
Proof. apply IZR_lt. reflexivity. Qed.

Lemma whole_root_value n r : whole_root n = Some r -> sqrt (IZR (Zpos n)) = IZR (Zpos r).
Proof.
  unfold whole_root. destruct (Z.sqrt (Zpos n)) as [|s|]; try discriminate.
  destruct (s * s =? n)%positive eqn:E; [|discriminate]. intros [= <-]. apply Pos.eqb_eq in E. subst n.
  rewrite Pos2Z.inj_mul, mult_IZR. apply sqrt_square. apply Rlt_le, pos_IZR.
Qed.

Lemma as_multiple_value c a b m : as_multiple c a b = Some m ->
  Q2R c * sqrt (IZR (Zpos a)) = Q2R m * sqrt (IZR (Zpos b)).
Proof.
  unfold as_multiple. destruct (whole_root (a * b)) as [r|] eqn:E; [|discriminate]. intro M.
  assert (M' : m = Qred (c * (Zpos r # b))) by congruence. rewrite M'. clear M M'.
  apply whole_root_value in E. rewrite red_value, Q2R_mult. unfold Q2R at 3; cbn [Qnum Qden].
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

Lemma value_cons t l : value (t :: l) = Q2R (fst t) * sqrt (IZR (Zpos (snd t))) + value l.
Proof. reflexivity. Qed.

Lemma add_term_value t terms : value (add_term t terms) = Q2R (fst t) * sqrt (IZR (Zpos (snd t))) + value terms.
Proof.
  induction terms as [|s rest IH]; [reflexivity|]. cbn [add_term].
  destruct (as_multiple _ _ _) as [c|] eqn:E; [|rewrite !value_cons, IH; lra].
  apply as_multiple_value in E. rewrite E, value_cons.
  pose proof (red_value (fst s + c)) as S. rewrite Q2R_plus in S.
  destruct (Qeq_bool (Qred (fst s + c)) 0) eqn:Z.
  - apply zero_value in Z. rewrite Z in S. assert (H : Q2R c = - Q2R (fst s)) by lra. rewrite H. lra.
  - rewrite value_cons. cbn [fst snd]. rewrite S. lra.
Qed.

Lemma times_term_value s t :
  Q2R (fst (times_term s t)) * sqrt (IZR (Zpos (snd (times_term s t)))) =
  (Q2R (fst s) * sqrt (IZR (Zpos (snd s)))) * (Q2R (fst t) * sqrt (IZR (Zpos (snd t)))).
Proof.
  unfold times_term. set (g := Pos.gcd _ _). set (a := Z.to_pos _). set (b := Z.to_pos (Zpos (snd t) / Zpos g)).
  destruct (_ && _)%bool eqn:E; cbn [fst snd]; rewrite red_value.
  - apply andb_prop in E as [A B]. apply Pos.eqb_eq in A, B.
    generalize dependent b; generalize dependent a; generalize dependent g. intros g a A b B. rewrite <- A, <- B. clear A B.
    rewrite !Q2R_mult. unfold Q2R at 3; cbn [Qnum Qden]. rewrite Rinv_1, Rmult_1_r.
    rewrite !Pos2Z.inj_mul, !mult_IZR.
    pose proof (pos_IZR g). pose proof (pos_IZR a). pose proof (pos_IZR b).
    rewrite !sqrt_mult by lra. pose proof (sqrt_sqrt (IZR (Zpos g)) ltac:(lra)) as S.
    rewrite <- S at 1. ring.
  - rewrite Q2R_mult, Pos2Z.inj_mul, mult_IZR, sqrt_mult by (apply Rlt_le, pos_IZR). ring.
Qed.

Lemma terms_plus_value l m : value (terms_plus l m) = value l + value m.
Proof.
  unfold terms_plus. induction l as [|t l IH]; cbn [fold_right].
  - change (value []) with 0. ring.
  - rewrite add_term_value, IH, value_cons. ring.
Qed.

Lemma opposite_value m : value (map (fun t => (Qopp (fst t), snd t)) m) = - value m.
Proof.
  induction m as [|t m IH]; cbn [map]; [change (value []) with 0; ring|].
  rewrite !value_cons, IH. cbn [fst snd]. rewrite Q2R_opp. ring.
Qed.

Lemma terms_minus_value l m : value (terms_minus l m) = value l - value m.
Proof. unfold terms_minus. rewrite terms_plus_value, opposite_value. ring. Qed.

Lemma term_times_value s m : value (map (times_term s) m) = Q2R (fst s) * sqrt (IZR (Zpos (snd s))) * value m.
Proof.
  induction m as [|t m IH]; cbn [map]; [change (value []) with 0; ring|]. rewrite !value_cons, IH, times_term_value. ring.
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
  - rewrite add_term_value, value_cons. cbn [fst snd value fold_right]. unfold Q2R; cbn [Qnum Qden].
    pose proof (pos_IZR n) as N. pose proof (pos_IZR d) as D. assert (I : 0 < / IZR (Zpos d)) by now apply Rinv_0_lt_compat.
    rewrite Pos2Z.inj_mul, mult_IZR, !sqrt_mult by lra.
    pose proof (sqrt_sqrt (IZR (Zpos d)) ltac:(lra)) as S.
    rewrite sqrt_inv by lra.
    assert (Q0 : 0 < sqrt (IZR (Zpos d))) by (apply sqrt_lt_R0; lra).
    rewrite <- S at 1. field. lra.
  - exfalso. unfold Qle in P. cbn [Qnum Qden] in P. rewrite Z.mul_1_r in P. lia.
Qed.

Lemma square_value t : Q2R (square_of t) = (Q2R (fst t) * sqrt (IZR (Zpos (snd t)))) * (Q2R (fst t) * sqrt (IZR (Zpos (snd t)))).
Proof.
  unfold square_of. rewrite red_value, !Q2R_mult. unfold Q2R at 3; cbn [Qnum Qden]. rewrite Rinv_1, Rmult_1_r.
  pose proof (pos_IZR (snd t)). pose proof (sqrt_sqrt (IZR (Zpos (snd t))) ltac:(lra)) as S. rewrite <- S at 1. ring.
Qed.

Lemma terms_inverse_value l m : terms_inverse l = Some m -> value m = / value l.
Proof.
  destruct l as [|s [|t [|]]]; cbn [terms_inverse]; try discriminate.
  - destruct (Qeq_bool _ _) eqn:Z; [discriminate|]. intro M. apply not_zero_value in Z.
    assert (M' : m = [(Qred (fst s / square_of s), snd s)]) by congruence. rewrite M'. clear M M'.
    cbn [value fold_right fst snd]. pose proof (square_value s) as S.
    assert (R0 : 0 < sqrt (IZR (Zpos (snd s)))) by apply sqrt_lt_R0, pos_IZR.
    assert (R1 : sqrt (IZR (Zpos (snd s))) <> 0) by now apply Rgt_not_eq.
    assert (N : Q2R (square_of s) <> 0)
      by (rewrite S; apply Rmult_integral_contrapositive_currified; apply Rmult_integral_contrapositive_currified; assumption).
    rewrite red_value, Q2R_div, S.
    + rewrite !Rplus_0_r. field. split; assumption.
    + intro E. apply N. apply Qeq_eqR in E. rewrite E. unfold Q2R; cbn; lra.
  - destruct (Qeq_bool _ _) eqn:Z; [discriminate|]. intro M. apply not_zero_value in Z.
    set (d := Qred (square_of s - square_of t)) in *.
    assert (M' : m = [(Qred (fst s / d), snd s); (Qred (- fst t / d), snd t)]) by congruence. rewrite M'. clear M M'.
    subst d. rewrite red_value, Q2R_minus in Z. cbn [value fold_right fst snd].
    assert (D : ~ Qred (square_of s - square_of t) == 0).
    { intro E. apply Qeq_eqR in E. rewrite red_value, Q2R_minus in E. apply Z. rewrite E. unfold Q2R; cbn; lra. }
    rewrite !red_value, !Q2R_div, Q2R_opp, red_value, Q2R_minus by assumption.
    rewrite !square_value in *. set (x := Q2R (fst s) * sqrt _) in *. set (y := Q2R (fst t) * sqrt _) in *.
    rewrite !Rplus_0_r.
    replace (Q2R (fst s) / (x * x - y * y) * sqrt (IZR (Zpos (snd s)))) with (x / (x * x - y * y)) by (unfold x, Rdiv; ring).
    replace (- Q2R (fst t) / (x * x - y * y) * sqrt (IZR (Zpos (snd t)))) with (- y / (x * x - y * y))
      by (unfold y, Rdiv; ring).
    assert (x + y <> 0) by (intro E; apply Z; replace (x * x - y * y) with ((x + y) * (x - y)) by ring; rewrite E; ring).
    field. split; assumption.
Qed.
