(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the choice of rotary positions: what remains moves least, and the axes stay for the same direction. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Lia.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Angles ControlState State Space Pose.
From Toolcomp Require Import ControlFrame ControlWords InverseKinematics ChoiceOfPair Program OutcomeLaws ProgramLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * The best of a list *)

(** Better, by numbers that say how good an element is. *)
Lemma best_kept {A} (better : A -> A -> outcome comparison) : forall rest kept remaining,
  best_of better kept rest = Got remaining -> forall x, In x remaining -> In x kept \/ In x rest.
Proof.
  induction rest as [|y rest IH]; intros kept remaining H x I; cbn [best_of] in H; [apply same in H as <-; now left|].
  apply bound in H as (c & _ & H). specialize (IH _ _ H x I). destruct c; destruct IH as [K|K]; cbn; auto.
  - apply in_app_iff in K as [K|[<-|[]]]; auto.
  - destruct K as [<-|[]]; auto.
Qed.

Lemma best_is_some {A} (better : A -> A -> outcome comparison) : forall rest kept remaining,
  best_of better kept rest = Got remaining -> kept <> [] \/ rest <> [] -> remaining <> [].
Proof.
  induction rest as [|y rest IH]; intros kept remaining H N; cbn [best_of] in H; [apply same in H as <-;
    now destruct N|].
  apply bound in H as (c & C & H). apply (IH _ _ H). left. destruct c; try discriminate; destruct kept;
    try discriminate.
Qed.

Lemma best_is_least {A} (better : A -> A -> outcome comparison) (as_good : A -> A -> Prop) :
  (forall a, as_good a a) -> (forall a b c, as_good a b -> as_good b c -> as_good a c) ->
  (forall a b x, better a b = Got x -> match x with Lt => as_good a b | Eq => as_good a b /\
    as_good b a | Gt => as_good b a end) ->
  forall rest kept remaining, best_of better kept rest = Got remaining ->
  (forall x y, In x kept -> In y kept -> as_good x y) -> forall x y, In x remaining -> In y (kept ++ rest) ->
    as_good x y.
Proof.
  intros REFL TRANS BETTER. induction rest as [|y rest IH]; intros kept remaining H K a b I J; cbn [best_of] in H.
  { apply same in H as <-. rewrite app_nil_r in J. now apply K. }
  apply bound in H as (c & C & H).
  assert (HEAD : match kept with [] => c = Lt | best :: _ => match c with Lt => as_good y best | Eq => as_good y best /\
    as_good best y | Gt => as_good best y end end).
  { destruct kept as [|best others]; [now apply same in C|]. now apply BETTER in C. }
  assert (KIN : forall x z, In x (match c with Lt => [y] | Eq => kept ++ [y] | Gt => kept end) ->
                            In z (match c with Lt => [y] | Eq => kept ++ [y] | Gt => kept end) -> as_good x z).
  { destruct kept as [|best others]; [subst c; intros x z [<-|[]] [<-|[]]; apply REFL|].
    destruct c.
    - destruct HEAD as [Y B]. intros x z X Z. apply in_app_iff in X as [X|[<-|[]]], Z as [Z|[<-|[]]]; auto.
      + apply (TRANS _ best); [apply K; [exact X|now left]|exact B].
      + apply (TRANS _ best); [exact Y|apply K; [now left|exact Z]].
    - intros x z [<-|[]] [<-|[]]; apply REFL.
    - exact K. }
  destruct kept as [|best others].
  - subst c. specialize (IH _ _ H KIN a). cbn [app] in *. now apply IH.
  - specialize (IH _ _ H KIN a). pose proof (best_is_some _ _ _ _ H) as SOME.
    destruct (in_app_or _ _ _ J) as [J'|[<-|J']].
    + assert (X : exists x, In x (match c with Lt => [y] | Eq => (best :: others) ++ [y] | Gt => best :: others end) /\
        as_good x best).
      { destruct c; [exists best|exists y|exists best]; split; try (now left); try apply REFL. exact HEAD. }
      destruct X as (x & X & XB). apply (TRANS _ x); [apply IH; [exact I|apply in_app_iff; now left]|].
      apply (TRANS _ best); [exact XB|]. apply K; [now left|exact J'].
    + destruct c.
      * apply IH; [exact I|]. apply in_app_iff; left. apply in_app_iff; right; now left.
      * apply IH; [exact I|]. apply in_app_iff; left. now left.
      * apply (TRANS _ best); [apply IH; [exact I|apply in_app_iff; left; now left]|exact HEAD].
    + apply IH; [exact I|]. apply in_app_iff; now right.
Qed.

(** * The moving angle *)

(** A move is no longer than another: fewer half turns, or as many and no more of the next one: the cosine falls in the
    first half of a turn and rises in the second. *)
Definition no_longer (a b : candidate R) : Prop :=
  half_turns a < half_turns b \/ (half_turns a = half_turns b /\
    (if Z.even (half_turns a) then cosine_of_move b <= cosine_of_move a else cosine_of_move a <= cosine_of_move b)%R).

Lemma moves_compared clause a b x : compare_moves clause a b = Got x ->
  match x with Lt => no_longer a b | Eq => no_longer a b /\ no_longer b a | Gt => no_longer b a end.
Proof.
  unfold compare_moves; intro H. destruct (Z.compare (half_turns a) (half_turns b)) eqn:C.
  - apply Z.compare_eq in C. apply decided in H. unfold no_longer. rewrite C in *.
    destruct (Z.even (half_turns b)), x; cbn in H;
      repeat split; right; split; auto; lra.
  - apply same in H as <-. left. exact C.
  - apply same in H as <-. left. now apply Z.compare_gt_iff in C.
Qed.

Lemma no_longer_trans a b c : no_longer a b -> no_longer b c -> no_longer a c.
Proof.
  unfold no_longer. intros [L|[E L]] [L'|[E' L']]; try (left; lia). right. rewrite E in *. split; [exact E'|].
  rewrite E' in *. destruct (Z.even (half_turns c)); lra.
Qed.

(** fanuc.tool-center-point.choice-first-move: of the positions that are judged those remain than which none moves less,
    and at least one does. *)
Theorem choice_moves_least clause (judged remaining : list (candidate R)) :
  best_of (compare_moves clause) [] judged = Got remaining ->
  (judged <> [] -> remaining <> []) /\ forall x, In x remaining -> In x judged /\ forall y, In y judged ->
    no_longer x y.
Proof.
  intro H. split; [intro N; apply (best_is_some _ _ _ _ H); now right|]. intros x I. split.
  - now destruct (best_kept _ _ _ _ H x I) as [[]|].
  - intros y J. apply (best_is_least (compare_moves clause) no_longer) with (rest := judged) (kept := []) (remaining :=
      remaining); auto.
    + intro a. right. split; [reflexivity|]. destruct (Z.even _); lra.
    + intros a b c. apply no_longer_trans.
    + intros a b c. apply moves_compared.
    + intros ? ? [].
Qed.

Definition at_degrees (x : R) : candidate R := Candidate (Angle x 1%R 0%R (Some 0)) 0 1%R.

Example choice_moves_least_instance clause remaining :
  best_of (compare_moves clause) [] [at_degrees 10; at_degrees 20] = Got remaining ->
  remaining <> [].
Proof. intro H. destruct (choice_moves_least clause _ _ H) as [N _]. apply N. discriminate. Qed.

(** * The same direction *)

Lemma known_same (v : triple R) : known_same3 v v = true.
Proof.
  destruct v as [[x y] z]. unfold known_same3, sub3; cbn. unfold real_sign.
  assert (E : forall a : R, match (match total_order_T (a - a) 0 with inleft (left _) => Lt | inleft (right _) => Eq |
    inright _ => Gt end) with Eq => true | _ => false end = true).
  { intro a. destruct (total_order_T (a - a) 0) as [[L|E]|G]; auto; lra. }
  now rewrite !E.
Qed.

(** fanuc.tool-center-point.choice: for the direction that the tool has the rotary axes stay, wherever in their ranges
    they are. *)
Theorem same_direction_stays (s : setup R) k (now : pose R) v from_zero_pose first second :
  ranges s = Got (first, second) -> in_range first (fst now) = Got true -> in_range second (snd now) = Got true ->
  choose s k now v v from_zero_pose = Got now.
Proof.
  intros R F S. unfold choose. rewrite R. cbn [bind]. unfold same_direction. rewrite known_same. cbn [bind].
  now rewrite F, S.
Qed.

Example same_direction_stays_instance k now v from_zero_pose : choose plain_setup k now v v from_zero_pose = Got now.
Proof.
  apply (same_direction_stays plain_setup k now v from_zero_pose None None); [|reflexivity..].
  unfold ranges, limits_of_axes, limits. cbn [parameter plain_setup]. unfold parameter_of.
  cbn [parameter plain_setup or_else].
  now rewrite !zero_is_zero.
Qed.
