(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the ranges of rotary axes: every position that is judged is in its range. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Lia.
From Toolcomp Require Import Numbers Outcomes Words Codes Angles ControlState ControlFrame ChoiceOfPair OutcomeLaws
  ProgramLaws ReachLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** * Angles compared *)

Definition sign_of (x : R) : comparison :=
  match total_order_T x 0 with inleft (left _) => Lt | inleft (right _) => Eq | inright _ => Gt end.
Lemma decide_is clause (x : R) : decide clause x = Got (sign_of x).
Proof. reflexivity. Qed.
Lemma sign_is (x : R) : match sign_of x with Lt => x < 0 | Eq => x = 0 | Gt => 0 < x end%R.
Proof. unfold sign_of. destruct (total_order_T x 0) as [[L|E]|G]; auto. Qed.
Lemma sign_of_opposite (x : R) : sign_of (- x) = CompOpp (sign_of x).
Proof.
  pose proof (sign_is x) as S. pose proof (sign_is (- x)) as S'.
  destruct (sign_of x), (sign_of (- x)); try reflexivity; exfalso; lra.
Qed.

Definition first_half (a : angle R) : bool :=
  match sign_of (sine_of a) with Gt => true | Lt => false | Eq => match sign_of (cosine_of a) with Gt => true |
    _ => false end end.
Definition rest (a b : angle R) : comparison :=
  match first_half a, first_half b with true, false => Lt | false, true => Gt | _, _ => sign_of (sine_between a b) end.

Lemma half_is clause a : in_first_half clause a = Got (first_half a).
Proof.
  unfold in_first_half, first_half. rewrite decide_is. cbn [bind]. destruct (sign_of (sine_of a)); try reflexivity.
Qed.
Lemma rest_is clause a b : compare_rest clause a b = Got (rest a b).
Proof. unfold compare_rest, rest. rewrite !half_is. cbn [bind]. destruct (first_half a), (first_half b); reflexivity.
Qed.

Lemma counted_by_any clause clause' tried : forall x : R, counted clause tried x = counted clause' tried x.
Proof.
  induction tried as [|count more IH]; intro x; [reflexivity|]. cbn [counted]. unfold is_negative. rewrite !decide_is.
  cbn [bind].
  destruct (match sign_of (x - integer 360 * integer count)%num with Lt => true | _ => false end); [reflexivity|].
  rewrite IH. destruct (counted clause' more x) as [[found left_over]| |]; reflexivity.
Qed.
Lemma turns_by_any clause clause' (a : angle R) : turns_of clause a = turns_of clause' a.
Proof.
  unfold turns_of. destruct (turns a); [reflexivity|]. unfold whole_turns, is_negative. rewrite !decide_is. cbn [bind].
  destruct (match sign_of (degrees a) with Lt => true | _ => false end); now rewrite (counted_by_any clause clause').
Qed.

(** By whole turns first. *)
Definition against (turns_a turns_b : Z) (a b : angle R) : comparison :=
  match Z.compare turns_a turns_b with Eq => rest a b | c => c end.
Lemma compared_is clause a b ta tb : turns_of clause a = Got ta -> turns_of clause b = Got tb ->
  compare_angles clause a b = Got (against ta tb a b).
Proof.
  intros A B. unfold compare_angles, against. rewrite A, B. cbn [bind]. destruct (Z.compare ta tb); try reflexivity.
  apply rest_is.
Qed.

Lemma rest_opposite a b : rest a b = CompOpp (rest b a).
Proof.
  unfold rest. replace (sine_between a b) with (- sine_between b a)%R by (unfold sine_between; cbn; ring).
  destruct (first_half a), (first_half b); try reflexivity; apply sign_of_opposite.
Qed.
Lemma against_opposite ta tb a b : against ta tb a b = CompOpp (against tb ta b a).
Proof. unfold against. rewrite (Z.compare_antisym tb ta). destruct (Z.compare tb ta); try reflexivity.
apply rest_opposite. Qed.

Definition is_one (a : angle R) : Prop := (cosine_of a * cosine_of a + sine_of a * sine_of a = 1)%R.

Lemma not_less (x : R) : sign_of x <> Lt <-> (0 <= x)%R.
Proof. pose proof (sign_is x) as S. destruct (sign_of x); split; intro H; try discriminate; try lra; now destruct H.
Qed.

Lemma rest_passes_on a b c : is_one b -> rest a b <> Lt -> rest b c <> Lt -> rest a c <> Lt.
Proof.
  unfold is_one, rest. intros U AB BC.
  assert (HALF : forall x, if first_half x then (0 < sine_of x \/ sine_of x = 0 /\ 0 < cosine_of x)%R
                           else (sine_of x < 0 \/ sine_of x = 0 /\ cosine_of x <= 0)%R).
  { intro x. unfold first_half. pose proof (sign_is (sine_of x)) as S. pose proof (sign_is (cosine_of x)) as C.
    destruct (sign_of (sine_of x)), (sign_of (cosine_of x)); auto; right; split; auto; lra. }
  pose proof (HALF a) as A. pose proof (HALF b) as B. pose proof (HALF c) as C.
  destruct (first_half a), (first_half b), (first_half c); try discriminate; try (now destruct AB);
    try (now destruct BC);
    rewrite !not_less in *; unfold sine_between in *; cbn in *.
  all: set (sa := sine_of a) in *; set (ca := cosine_of a) in *; set (sb := sine_of b) in *;
    set (cb := cosine_of b) in *;
    set (sc := sine_of c) in *; set (cc := cosine_of c) in *.
  - assert (K : (sb * (sa * cc - sc * ca) = sc * (sa * cb - sb * ca) + sa * (sb * cc - sc * cb))%R) by ring.
    assert (0 <= sa)%R by (destruct A; lra). assert (0 <= sc)%R by (destruct C; lra). destruct B as [B|[B B']].
    + assert (0 <= sb * (sa * cc - sc * ca))%R by (rewrite K; apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra).
      apply Rnot_lt_le. intro L. assert (sb * (sa * cc - sc * ca) < 0)%R by nra. lra.
    + rewrite B in *. assert (sc = 0)%R by nra. assert (0 < cc)%R by (destruct C; lra). nra.
  - assert (K : (sb * (sa * cc - sc * ca) = sc * (sa * cb - sb * ca) + sa * (sb * cc - sc * cb))%R) by ring.
    assert (sa <= 0)%R by (destruct A; lra). assert (sc <= 0)%R by (destruct C; lra). destruct B as [B|[B B']].
    + assert (sb * (sa * cc - sc * ca) <= 0)%R.
      { rewrite K. assert (sc * (sa * cb - sb * ca) <= 0)%R by nra. assert (sa * (sb * cc - sc * cb) <= 0)%R by nra.
        lra. }
      apply Rnot_lt_le. intro L. assert (0 < sb * (sa * cc - sc * ca))%R by nra. lra.
    + rewrite B in *. assert (cb < 0)%R by nra. assert (sc = 0)%R by nra. assert (cc <= 0)%R by (destruct C; lra). nra.
Qed.

Lemma against_passes_on ta tb tc a b c : is_one b -> against ta tb a b <> Lt -> against tb tc b c <> Lt ->
  against ta tc a c <> Lt.
Proof.
  unfold against. intros U AB BC.
  destruct (Z.compare_spec ta tb), (Z.compare_spec tb tc), (Z.compare_spec ta tc); try congruence; try lia;
    try discriminate.
  now apply (rest_passes_on a b c).
Qed.

(** * Positions in range *)

Lemma turned_on_is count (a : angle R) n : turns a = Some n -> turns (turned_on count a) = Some (count + n) /\
  forall b, rest (turned_on count a) b = rest a b.
Proof.
  intro T. unfold turned_on. destruct (count =? 0) eqn:Z; [apply Z.eqb_eq in Z; subst; split; [exact T|reflexivity]|].
  cbn [turns]. rewrite T. split; reflexivity.
Qed.

(** Up from a position, down from it. *)
Lemma first_up_is_up clause (from one_turn up : angle R) tf : turns one_turn = Some 0 ->
  turns_of clause from = Got tf ->
  first_up clause from one_turn = Got up -> exists tu, turns up = Some tu /\ against tu tf up from <> Lt.
Proof.
  unfold first_up; intros T F H. rewrite F in H. cbn [bind] in H. rewrite rest_is in H. cbn [bind] in H.
  apply same in H as <-.
  set (n := match rest one_turn from with Lt => tf + 1 | _ => tf end). destruct (turned_on_is n one_turn 0 T) as [-> R].
  eexists; split; [reflexivity|]. unfold against. rewrite R. unfold n.
  destruct (rest one_turn from) eqn:E; rewrite Z.add_0_r.
  - now rewrite Z.compare_refl.
  - destruct (Z.compare_spec (tf + 1) tf); try discriminate; lia.
  - now rewrite Z.compare_refl.
Qed.
Lemma first_down_is_down clause (from one_turn down : angle R) tf : turns one_turn = Some 0 ->
  turns_of clause from = Got tf ->
  first_down clause from one_turn = Got down -> exists td, turns down = Some td /\ against td tf down from <> Gt.
Proof.
  unfold first_down; intros T F H. rewrite F in H. cbn [bind] in H. rewrite rest_is in H. cbn [bind] in H.
  apply same in H as <-.
  set (n := match rest one_turn from with Gt => tf - 1 | _ => tf end). destruct (turned_on_is n one_turn 0 T) as [-> R].
  eexists; split; [reflexivity|]. unfold against. rewrite R. unfold n.
  destruct (rest one_turn from) eqn:E; rewrite Z.add_0_r.
  - now rewrite Z.compare_refl.
  - now rewrite Z.compare_refl.
  - destruct (Z.compare_spec (tf - 1) tf); try discriminate; lia.
Qed.

Lemma with_turns_is clause (a b : angle R) : with_turns clause a = Got b ->
  exists t, turns_of clause a = Got t /\ turns b = Some t /\ forall x, rest x b = rest x a.
Proof. unfold with_turns; intro H. apply bound in H as (t & T & H). apply same in H as <-. exists t. repeat split.
exact T. Qed.

Lemma opposite_not c : c <> Gt <-> CompOpp c <> Lt.
Proof. destruct c; cbn; split; intros H E; congruence. Qed.

(** fanuc.tool-center-point.range: every position that is judged for an axis with a range is in it, the limits included:
    the
    nearest ones, and those that are found up and down from the present position where the nearest are outside. *)
Theorem judged_positions_in_range clause (lower upper now one_turn : angle R) found :
  is_one now -> turns one_turn = Some 0 -> candidates clause (Some (lower, upper)) now one_turn = Got found ->
  Forall (fun c => in_range (Some (lower, upper)) (goes_to c) = Got true) found.
Proof.
  intros U T H. unfold candidates in H. apply bound in H as (nearest & _ & H). apply bound in H as (fine & F & H).
  destruct (filter snd fine) as [|p inside] eqn:FI.
  2: { apply same in H as <-. apply each_got in F.
       assert (ALL : Forall (fun p => in_range (Some (lower, upper)) (goes_to (fst p)) = Got (snd p)) fine).
       { clear - F. induction F as [|a q rest done A _ IH]; [constructor|]. apply bound in A as (ok & O & A).
         apply same in A as <-. now constructor. }
       rewrite <- FI. apply Forall_forall. intros c I. apply in_map_iff in I as (q & <- & I).
       apply filter_In in I as [I S].
       rewrite Forall_forall in ALL. now rewrite (ALL q I), S. }
  unfold candidates_in_range in H. apply bound in H as (from_up & FU & H). apply bound in H as (from_down & FD & H).
  apply bound in H as (up & UP & H). apply bound in H as (down & DOWN & H). apply bound in H as (up_fine & UF & H).
  apply bound in H as (down_fine & DF & H). apply each_got in H.
  (* Where one starts is not outside; so is what lies beyond it. *)
  assert (TURNS : exists tl tu tn, turns_of range_clause lower = Got tl /\ turns_of range_clause upper = Got tu /\
    turns_of range_clause now = Got tn).
  { unfold not_above in UF. apply bound in UF as (c & C & _). unfold compare_angles in C.
    apply bound in C as (t1 & _ & C). apply bound in C as (tu & TU & _).
    unfold not_below in DF. apply bound in DF as (c' & C' & _). unfold compare_angles in C'.
    apply bound in C' as (t2 & _ & C'). apply bound in C' as (tl & TL & _).
    apply bound in FU as (ok & O & _). unfold not_below in O. apply bound in O as (c'' & C'' & _).
    unfold compare_angles in C''. apply bound in C'' as (tn & TN & _).
    now exists tl, tu, tn. }
  destruct TURNS as (tl & tu & tn & TL & TU & TN).
  assert (UPWARD : exists t, turns up = Some t /\ against t tl up lower <> Lt).
  { apply bound in FU as (ok & O & FU). unfold not_below in O.
    rewrite (compared_is range_clause now lower tn tl TN TL) in O. cbn [bind] in O. apply same in O.
    destruct ok.
    - apply same in FU as <-. destruct (first_up_is_up clause now one_turn up tn T) as (t & TT & A);
        [now rewrite (turns_by_any clause range_clause)|exact UP|].
      exists t. split; [exact TT|]. apply (against_passes_on t tn tl up now lower U A).
      destruct (against tn tl now lower); congruence.
    - apply with_turns_is in FU as (t' & T' & TT' & R). rewrite TL in T'. apply same in T'. subst t'.
      destruct (first_up_is_up clause from_up one_turn up tl T) as (t & TT & A); [unfold turns_of;
        now rewrite TT'|exact UP|].
      exists t. split; [exact TT|]. unfold against in *. now rewrite R in A. }
  assert (DOWNWARD : exists t, turns down = Some t /\ against t tu down upper <> Gt).
  { apply bound in FD as (ok & O & FD). unfold not_above in O.
    rewrite (compared_is range_clause now upper tn tu TN TU) in O. cbn [bind] in O. apply same in O.
    destruct ok.
    - apply same in FD as <-. destruct (first_down_is_down clause now one_turn down tn T) as (t & TT & A);
        [now rewrite (turns_by_any clause range_clause)|exact DOWN|].
      exists t. split; [exact TT|]. apply opposite_not. rewrite <- against_opposite.
      apply (against_passes_on tu tn t upper now down U).
      + rewrite against_opposite. apply opposite_not. destruct (against tn tu now upper); congruence.
      + rewrite against_opposite. now apply opposite_not.
    - apply with_turns_is in FD as (t' & T' & TT' & R). rewrite TU in T'. apply same in T'. subst t'.
      destruct (first_down_is_down clause from_down one_turn down tu T) as (t & TT & A); [unfold turns_of;
        now rewrite TT'|exact DOWN|].
      exists t. split; [exact TT|]. unfold against in *. now rewrite R in A. }
  destruct UPWARD as (t1 & T1 & A1). destruct DOWNWARD as (t2 & T2 & A2).
  assert (UPF : up_fine = true -> in_range (Some (lower, upper)) up = Got true).
  { intros ->. unfold in_range. rewrite UF. cbn [bind]. unfold not_below.
    rewrite (compared_is range_clause up lower t1 tl); [|unfold turns_of; now rewrite T1|exact TL]. cbn [bind].
    destruct (against t1 tl up lower); auto. now destruct A1. }
  assert (DOWNF : down_fine = true -> in_range (Some (lower, upper)) down = Got true).
  { intros ->. unfold in_range, not_above. rewrite (compared_is range_clause down upper t2 tu); [|unfold turns_of;
      now rewrite T2|exact TU].
    cbn [bind]. rewrite DF. cbn [bind]. destruct (against t2 tu down upper); auto. now destruct A2. }
  assert (ALL : Forall (fun x => in_range (Some (lower, upper)) x = Got true) ((if up_fine then [up] else []) ++ (if
    down_fine then [down] else []))).
  { destruct up_fine, down_fine; cbn; auto. }
  clear - H ALL. revert ALL. induction H as [|x c xs cs M _ IH]; intro ALL; [constructor|]. inversion ALL; subst.
  constructor; [|now apply IH]. now rewrite (moving_goes _ _ _ _ M).
Qed.

Example judged_positions_in_range_instance clause found :
  let at_ x := angle_of_degrees (x : R) in let zero := Angle 0%R 1%R 0%R (Some 0) in
  candidates clause (Some (at_ (- 90)%R, at_ 90%R)) zero zero = Got found ->
  Forall (fun c => in_range (Some (at_ (- 90)%R, at_ 90%R)) (goes_to c) = Got true) found.
Proof.
  intros at_ zero H. apply (judged_positions_in_range clause (at_ (- 90)%R) (at_ 90%R) zero zero found);
    [|reflexivity|exact H].
  unfold is_one; cbn. lra.
Qed.

(** fanuc.tool-center-point.range: so is every position that is chosen,
    of each axis that has a range and is not left where
    it stands. *)
Theorem chosen_positions_in_range (ranges : range R * range R) now pairs f g : is_one (fst now) -> is_one (snd now) ->
  Forall (fun pair => exists first second, pair = (AnyTurn first, AnyTurn second) /\ turns first = Some 0 /\
    turns second = Some 0)
    pairs ->
  chosen ranges now pairs = Got (f, g) ->
  (fst ranges <> None -> in_range (fst ranges) f = Got true) /\ (snd ranges <> None ->
    in_range (snd ranges) g = Got true).
Proof.
  intros U1 U2 P H. apply chosen_comes_from in H as (pair & I & F & G). rewrite Forall_forall in P.
  destruct (P pair I) as (first & second & -> & T1 & T2). cbn [fst snd] in *.
  assert (K : forall clause r here one x, is_one here -> turns one = Some 0 ->
    comes_from (N := reals) clause r here (AnyTurn one) x ->
    r <> None -> in_range r x = Got true).
  { intros clause r here one x U T (moves & c & positions & M & C & Q & X) D.
    destruct r as [[lower upper]|]; [|now destruct D].
    cbn [moves_to positions_of] in M, Q. apply same in Q as <-. destruct X as [<-|[]].
    pose proof (judged_positions_in_range clause lower upper here one moves U T M) as ALL. rewrite Forall_forall in ALL.
    now apply ALL. }
  split; [exact (K _ _ _ _ _ U1 T1 F)|exact (K _ _ _ _ _ U2 T2 G)].
Qed.

Example chosen_positions_in_range_instance f g :
  let at_ x := angle_of_degrees (x : R) in let zero := Angle 0%R 1%R 0%R (Some 0) in
  chosen (Some (at_ (- 90)%R, at_ 90%R), None) (zero, zero) [(AnyTurn zero, AnyTurn zero)] = Got (f, g) ->
  in_range (Some (at_ (- 90)%R, at_ 90%R)) f = Got true.
Proof.
  intros at_ zero H. apply chosen_positions_in_range in H as [H _]; [apply H; discriminate|unfold is_one; cbn; lra..|].
  repeat constructor. now exists zero, zero.
Qed.
