(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the choice of rotary positions: what is chosen is one of the pairs of the direction, by whole turns. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Lia.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Angles ControlState State Space Pose.
From Toolcomp Require Import ControlFrame ControlWords InverseKinematics ChoiceOfPair Program OutcomeLaws ProgramLaws
  ChoiceLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** Whole turns apart: the sine and the cosine are the same. *)
Definition same_turn {num} (a b : angle num) : Prop := cosine_of a = cosine_of b /\ sine_of a = sine_of b.

Lemma same_turn_refl {num} (a : angle num) : same_turn a a.
Proof. now split. Qed.
Lemma same_turn_trans {num} (a b c : angle num) : same_turn a b -> same_turn b c -> same_turn a c.
Proof. unfold same_turn. intros [-> ->] [-> ->]. auto. Qed.
Lemma turned_on_same {num} {N : Numbers num} count (a : angle num) : same_turn (turned_on count a) a.
Proof. unfold turned_on. destruct (count =? 0)%Z; now split. Qed.

(** A position that an aim allows. *)
Definition aimed {num} (aim : axis_aim num) (x : angle num) : Prop :=
  match aim with AnyTurn one_turn => same_turn x one_turn | Alone position => x = position end.

Lemma nearest_aimed {num} {N : Numbers num} clause (now one_turn : angle num) cs :
  nearest_candidates clause now one_turn = Got cs -> Forall (fun c => same_turn (goes_to c) one_turn) cs.
Proof.
  unfold nearest_candidates; intro H. apply bound in H as (behind & _ & H). apply bound in H as (half & _ & H).
  destruct half.
  - apply bound in H as (up & U & H). apply same in H as <-. unfold first_up in U. apply bound in U as (count & _ & U).
    apply bound in U as (below & _ & U). apply same in U as <-.
    repeat constructor; cbn [goes_to]; try apply turned_on_same; try (eapply same_turn_trans; apply turned_on_same).
    all: eapply same_turn_trans; apply turned_on_same.
  - apply bound in H as (count & _ & H). apply same in H as <-. repeat constructor; apply turned_on_same.
Qed.

Lemma moving_goes {num} {N : Numbers num} clause (now to : angle num) c : moving_to clause now to = Got c ->
  goes_to c = to.
Proof.
  unfold moving_to; intro H. apply bound in H as (up & _ & H). apply bound in H as (m & _ & H).
  apply bound in H as (count & _ & H).
  apply bound in H as (first & _ & H). now apply same in H as <-.
Qed.

Lemma candidates_aimed {num} {N : Numbers num} clause r (now one_turn : angle num) cs :
  candidates clause r now one_turn = Got cs -> Forall (fun c => same_turn (goes_to c) one_turn) cs.
Proof.
  unfold candidates; intro H. apply bound in H as (nearest & A & H). apply nearest_aimed in A.
  apply bound in H as (fine & F & H).
  apply each_got in F. destruct (filter snd fine) as [|p inside] eqn:FI.
  - unfold candidates_in_range in H. apply bound in H as (from_up & _ & H). apply bound in H as (from_down & _ & H).
    apply bound in H as (up & U & H). apply bound in H as (down & D & H). apply bound in H as (up_fine & _ & H).
    apply bound in H as (down_fine & _ & H). apply each_got in H.
    assert (UP : same_turn up one_turn).
    { unfold first_up in U. apply bound in U as (c & _ & U). apply bound in U as (b & _ & U). apply same in U as <-.
      apply turned_on_same. }
    assert (DOWN : same_turn down one_turn).
    { unfold first_down in D. apply bound in D as (c & _ & D). apply bound in D as (b & _ & D). apply same in D as <-.
      apply turned_on_same. }
    assert (ALL : Forall (fun x => same_turn x one_turn) ((if up_fine then [up] else []) ++ (if down_fine then [down]
      else []))).
    { destruct up_fine, down_fine; cbn; auto. }
    clear - H ALL. revert ALL. induction H as [|x c xs cs M _ IH]; intro ALL; [constructor|]. inversion ALL; subst.
    apply moving_goes in M. constructor; [now rewrite M|now apply IH].
  - apply same in H as <-. apply Forall_forall. intros c I.
    assert (J : In c (map fst fine)).
    { rewrite <- FI in I. apply in_map_iff in I as (q & <- & Q). apply filter_In in Q as [Q _]. now apply in_map. }
    assert (E : map fst fine = nearest).
    { clear - F. induction F as [|a q rest done B _ IH]; [reflexivity|]. apply bound in B as (ok & _ & B).
      apply same in B as <-. cbn. now rewrite IH. }
    rewrite E in J. rewrite Forall_forall in A. now apply A.
Qed.

Lemma moves_aimed {num} {N : Numbers num} clause r (now : angle num) aim cs :
  moves_to clause r now aim = Got cs -> Forall (fun c => aimed aim (goes_to c)) cs.
Proof.
  unfold moves_to; intro H. destruct aim as [one_turn|position], r as [r|].
  - now apply candidates_aimed in H.
  - apply same in H as <-. repeat constructor; apply same_turn_refl.
  - apply bound in H as (c & M & H). apply same in H as <-. apply moving_goes in M. now repeat constructor.
  - apply bound in H as (c & M & H). apply same in H as <-. apply moving_goes in M. now repeat constructor.
Qed.

Lemma positions_aimed {num} {N : Numbers num} clause r (now : angle num) aim c xs : aimed aim (goes_to c) ->
  positions_of clause r now aim c = Got xs -> Forall (aimed aim) xs.
Proof.
  unfold positions_of; intros A H. destruct aim as [one_turn|position], r as [r|];
    try (apply same in H as <-; constructor; [exact A|constructor]).
  apply bound in H as (found & F & H). apply same in H as <-. apply nearest_aimed in F. now apply Forall_map.
Qed.

Lemma each_in {A B} (f : A -> outcome B) l ys y : each f l = Got ys -> In y ys -> exists x, In x l /\ f x = Got y.
Proof.
  intros H I. apply each_got in H. induction H as [|a b rest done E _ IH]; [contradiction|].
  destruct I as [<-|I]; [exists a; split; [now left|exact E]|]. destruct (IH I) as (x & J & K). exists x.
  split; [now right|exact K].
Qed.
Lemma best_in {A} (better : A -> A -> outcome comparison) rest remaining x : best_of better [] rest = Got remaining ->
  In x remaining -> In x rest.
Proof. intros H I. now destruct (best_kept _ _ _ _ H x I) as [[]|]. Qed.

(** Where a position that is chosen comes from: a candidate of its aim, and the position of that. *)
Definition comes_from {num} {N : Numbers num} clause (r : range num) (now : angle num) (aim : axis_aim num) (x :
  angle num) :
    Prop :=
  exists moves c positions, moves_to clause r now aim = Got moves /\ In c moves /\
    positions_of clause r now aim c = Got positions /\ In x positions.

Lemma chosen_comes_from {num} {N : Numbers num} (ranges now : _ * _) pairs (f g : angle num) :
  chosen ranges now pairs = Got (f, g) -> exists pair, In pair pairs /\
    comes_from "fanuc.tool-center-point.choice-first-move" (fst ranges) (fst now) (fst pair) f /\
    comes_from "fanuc.tool-center-point.choice-second-move" (snd ranges) (snd now) (snd pair) g.
Proof.
  unfold chosen; intro H. apply bound in H as (firsts & F & H). apply bound in H as (left1 & L1 & H).
  apply bound in H as (both1 & B1 & H). apply bound in H as (left2 & L2 & H). apply bound in H as (both2 & B2 & H).
  apply bound in H as (left3 & L3 & H). apply bound in H as (left4 & L4 & H). apply bound in H as (left5 & L5 & H).
  apply bound in H as (left6 & L6 & H). destruct left6 as [|best rest]; [discriminate|]. apply same in H. subst best.
  assert (I : In (f, g) left5) by (apply (best_in _ _ _ _ L6); now left). apply (best_in _ _ _ _ L5) in I.
  apply (best_in _ _ _ _ L4) in I.
  apply (best_in _ _ _ _ L3) in I. apply in_concat in I as (group & G & I).
  destruct (each_in _ _ _ _ B2 G) as ([f' [c2 aim2]] & J & E).
  apply bound in E as (positions & P & E). apply same in E as <-. apply in_map_iff in I as (g' & E & I).
  injection E as <- <-. cbn [fst snd] in *.
  apply (best_in _ _ _ _ L2) in J. apply in_concat in J as (group & G' & J).
  destruct (each_in _ _ _ _ B1 G') as ([c1 [aim1 aim2']] & K & E).
  apply bound in E as (ones & O & E). apply bound in E as (seconds & S & E). apply same in E as <-. cbn [fst snd] in *.
  apply in_flat_map in J as (f'' & IF & J). apply in_map_iff in J as (c2' & E & J). injection E as <- <- <-.
  apply (best_in _ _ _ _ L1) in K. apply in_concat in K as (group & G'' & K).
  destruct (each_in _ _ _ _ F G'') as ([a1 a2] & IP & E).
  apply bound in E as (moves & M & E). apply bound in E as (others & _ & E). apply same in E as <-. cbn [fst snd] in *.
  assert (X : In c1 moves /\ (aim1, aim2') = (a1, a2)).
  { destruct others as [|other others]; [contradiction|]. apply in_map_iff in K as (c0 & E0 & K0).
    injection E0 as <- <- <-. now split. }
  destruct X as [IM E]. injection E as -> ->. exists (a1, a2). split; [exact IP|]. cbn [fst snd].
  split; [exists moves, c1, ones|exists seconds, c2', positions]; auto.
Qed.

(** fanuc.tool-center-point.choice: what is chosen is one of the pairs, each axis by whole turns; an axis that keeps its
    position keeps it. *)
Theorem chosen_is_one_of_the_pairs {num} {N : Numbers num} (ranges now : _ * _) pairs (f g : angle num) :
  chosen ranges now pairs = Got (f, g) -> exists pair, In pair pairs /\ aimed (fst pair) f /\ aimed (snd pair) g.
Proof.
  intro H. apply chosen_comes_from in H as (pair & I & F & G). exists pair. split; [exact I|].
  assert (A : forall clause r here aim x, comes_from (N := N) clause r here aim x -> aimed aim x).
  { intros clause r here aim x (moves & c & positions & M & C & P & X). apply moves_aimed in M.
    rewrite Forall_forall in M.
    apply positions_aimed in P; [|now apply M]. rewrite Forall_forall in P. now apply P. }
  split; [exact (A _ _ _ _ _ F)|exact (A _ _ _ _ _ G)].
Qed.

Example chosen_is_one_of_the_pairs_instance now (f g : angle R) :
  let up := Angle 10%R 1%R 0%R (Some 0%Z) in
  chosen (None, None) now [(AnyTurn up, Alone up)] = Got (f, g) -> same_turn f up /\ g = up.
Proof. intros up H. apply chosen_is_one_of_the_pairs in H as (pair & [<-|[]] & F & G). now split. Qed.

(** fanuc.tool-center-point.choice: the pose that is chosen for a direction that is not along the work-side axis, and
    not the present one, is one of its pairs, by whole turns. *)
Theorem chosen_pose_is_a_pair {num} {N : Numbers num} (s : setup num) k (now :
  pose num) now_direction v from_zero_pose to :
  choose s k now now_direction v from_zero_pose = Got to ->
  same_direction "fanuc.tool-center-point.choice" now_direction v = Got false -> parallel_to_work_axis k v = Got None ->
  exists pairs pair, pairs_of k v from_zero_pose = Got pairs /\ In pair pairs /\
    same_turn (fst (sides_of k to)) (fst pair) /\ same_turn (snd (sides_of k to)) (snd pair).
Proof.
  unfold choose; intros H D P. apply bound in H as ([first second] & _ & H). rewrite D, P in H. cbn [bind] in H.
  apply bound in H as (pairs & F & H). apply bound in F as (found & F & E). apply same in E as <-.
  apply bound in H as ([f g] & C & H). apply same in H as <-.
  apply chosen_is_one_of_the_pairs in C as (pair & I & A & B). apply in_map_iff in I as (aims & <- & I).
  apply in_map_iff in I as ([tau omega] & <- & I). exists found, (tau, omega). split; [exact F|]. split; [exact I|].
  unfold sides_of. cbn [fst snd] in *. destruct (judges_second_first s k), (machine_of k); cbn [fst snd aimed] in *;
    now split.
Qed.

Example chosen_pose_is_a_pair_instance k now now_direction v from_zero_pose to :
  choose plain_setup k now now_direction v from_zero_pose = Got to ->
  same_direction "fanuc.tool-center-point.choice" now_direction v = Got false -> parallel_to_work_axis k v = Got None ->
  exists pairs pair, pairs_of k v from_zero_pose = Got pairs /\ In pair pairs /\
    same_turn (fst (sides_of k to)) (fst pair) /\ same_turn (snd (sides_of k to)) (snd pair).
Proof. apply chosen_pose_is_a_pair. Qed.
