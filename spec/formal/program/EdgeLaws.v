(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the leading edge offset: its vectors in a run. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Psatz.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates LengthOffset EdgeState ControlState State
  Space Pose.
From Toolcomp Require Import Movements EdgeVector EdgePass Program OutcomeLaws PlanLaws ProgramLaws PassLaws CutterLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * A vector *)

Lemma made_by (s : setup R) last r vm vt v : leading_vector_of s last r vm vt = Got (Some v) ->
  exists back, v = leading_by back r vm vt.
Proof.
  unfold leading_vector_of; intro H. apply bound in H as (leaning & _ & H). apply bound in H as (a & _ & H).
  destruct a, last; apply same in H; try discriminate; injection H as <-; eauto.
Qed.

Lemma leading_across back r (vm vt : triple R) : dot3 (leading_vector (leading_by back r vm vt)) vt = 0%R.
Proof.
  unfold leading_by; cbn [leading_vector]. generalize ((if back then r else (- r)%num) / length3 (cross3 (cross3 vm vt)
    vt))%num as k.
  intro k. destruct vm as [[a b] c], vt as [[d e] f]. unfold scale3, cross3, dot3; cbn. ring.
Qed.

(** fanuc.leading-edge.vector: every vector that is made is at right angles to the tool. *)
Theorem edge_vector_across_the_tool (s : setup R) last r vm vt v :
  leading_vector_of s last r vm vt = Got (Some v) -> dot3 (leading_vector v) vt = 0%R.
Proof. intro H. apply made_by in H as [back ->]. apply leading_across. Qed.

Example edge_vector_across_the_tool_instance v :
  leading_vector_of plain_setup None 10%R (100, 0, 0)%R (3, 0, 4)%R = Got (Some v) ->
    dot3 (leading_vector v) (3, 0, 4)%R = 0%R.
Proof. apply edge_vector_across_the_tool. Qed.

Lemma square_of_V (vm vt : triple R) :
  dot3 (cross3 (cross3 vm vt) vt) (cross3 (cross3 vm vt) vt) = (dot3 vt vt * (dot3 vm vm * dot3 vt vt - dot3 vm vt *
    dot3 vm vt))%R.
Proof. destruct vm as [[a b] c], vt as [[d e] f]. unfold cross3, dot3; cbn. ring. Qed.

Lemma cosine_bound d : (cosine d * cosine d <= 1)%R.
Proof. cbn. pose proof (sin2_cos2 (d * PI / 180)). unfold Rsqr in *. pose proof (Rle_0_sqr (sin (d * PI / 180))).
unfold Rsqr in *. lra. Qed.

(** fanuc.leading-edge.vector: it is as long as the offset value, without its sign, for a tool and a movement of any
    length. *)
Theorem edge_vector_as_long_as_the_value (s : setup R) last r vm vt v :
  leading_vector_of s last r vm vt = Got (Some v) -> (0 < dot3 vm vm)%R -> (0 < dot3 vt vt)%R ->
  dot3 (leading_vector v) (leading_vector v) = (r * r)%R.
Proof.
  intros H M T. pose proof H as D. apply made_by in H as [back ->].
  set (p := dot3 vm vt). set (l := (dot3 vm vm * dot3 vt vt)%R). assert (L : (0 < l)%R) by (unfold l; nra).
  assert (Q : (p * p < l)%R).
  { unfold leading_vector_of in D. apply bound in D as (leaning & SG & D). apply decided in SG. fold p in SG.
    apply bound in D as (a & A & D). unfold angle_class in A. apply bound in A as (d & _ & A). fold p in A. fold l in A.
    apply bound in A as (near & NE & A). pose proof (cosine_bound d) as C.
    destruct leaning; [rewrite SG; lra|..];
      apply bound in NE as (under & U & NE); apply negative_sign in U; apply same in NE; subst near;
      (destruct under; cbn [negb] in A;
        [assert (X : (p * p - cosine d * cosine d * l < 0)%R) by (now apply U); nra
        |apply same in A as <-; apply same in D; discriminate]). }
  unfold leading_by; cbn [leading_vector]. set (w := cross3 (cross3 vm vt) vt).
  assert (W : dot3 w w = (dot3 vt vt * (l - p * p))%R) by (unfold w, l, p; apply square_of_V).
  assert (P : (0 < dot3 w w)%R) by (rewrite W; nra).
  assert (S : (length3 w * length3 w)%R = dot3 w w) by (unfold length3; cbn; apply sqrt_sqrt; lra).
  assert (N : length3 w <> 0%R) by (intro E; rewrite E in S; lra).
  transitivity (((if back then r else (- r)%num) / length3 w) * ((if back then r else (- r)%num) / length3 w) * dot3 w
    w)%R.
  - set (k := ((if back then r else (- r)%num) / length3 w)%num).
    change (((if back then r else (- r)%num) / length3 w)%R) with k.
    destruct w as [[a b] c]. unfold scale3, dot3; cbn. ring.
  - rewrite <- S. destruct back; cbn; field; exact N.
Qed.

Example edge_vector_as_long_as_the_value_instance v :
  leading_vector_of plain_setup None (- (10))%R (100, 0, 0)%R (3, 0, 4)%R = Got (Some v) ->
  dot3 (leading_vector v) (leading_vector v) = 100%R.
Proof.
  intro H. apply edge_vector_as_long_as_the_value in H; [rewrite H; lra|cbn; lra..].
Qed.

Definition turned_round (v : leading R) : leading R := Leading (backward v) (scale3 (- (1))%R (leading_vector v)).

(** fanuc.leading-edge.negative-radius: a negative value reverses the vector, not the side. *)
Theorem edge_negative_value (s : setup R) last r vm vt v :
  leading_vector_of s last r vm vt = Got v -> leading_vector_of s last (- r)%R vm vt = Got (option_map turned_round v).
Proof.
  unfold leading_vector_of; intro H. apply bound in H as (leaning & L & H). apply bound in H as (a & A & H).
  rewrite L. cbn [bind]. rewrite A. cbn [bind].
  assert (E : forall back, leading_by back (- r)%R vm vt = turned_round (leading_by back r vm vt)).
  { intro back. unfold leading_by, turned_round. cbn [backward leading_vector]. f_equal.
    set (w := cross3 (cross3 vm vt) vt). destruct w as [[x y] z]. unfold scale3.
    destruct back; cbn; unfold Rdiv; (f_equal; [f_equal|]; ring). }
  destruct a, last; apply same in H; subst v; cbn [option_map]; now rewrite ?E.
Qed.

Example edge_negative_value_instance v :
  leading_vector_of plain_setup None 10%R (100, 0, 0)%R (3, 0, 4)%R = Got v ->
  leading_vector_of plain_setup None (- (10))%R (100, 0, 0)%R (3, 0, 4)%R = Got (option_map turned_round v).
Proof. apply edge_negative_value. Qed.

(** * A run *)

(** fanuc.leading-edge.vector: at the end of every block of the mode the vector is the one before it, or at right angles
    to the tool there; the start makes one at right angles. *)
Theorem edge_blocks_across_the_tool (s : setup R) last b rest b' v :
  led s last b rest = Got (b', Some v) -> last = Some v \/ dot3 (leading_vector v) (tool_behind s b) = 0%R.
Proof.
  unfold led; intro H. destruct last as [w|], (leads (edge (behind b))); try (apply same in H; discriminate).
  - apply bound in H as (made & M & H). apply same in H. injection H as _ ->. unfold vector_at_end in M.
    apply bound in M as (moving & _ & M). destruct (negb moving); [left; f_equal; now apply same in M|].
    apply bound in M as (next & _ & M). apply bound in M as (r & _ & M).
    assert (OF : forall vm, bind (leading_vector_of s (Some w) r vm (tool_behind s b)) (fun made => Got (or_else made
      w)) = Got v ->
      Some w = Some v \/ dot3 (leading_vector v) (tool_behind s b) = 0%R).
    { intros vm O. apply bound in O as ([made|] & O & E); apply same in E; cbn in E; subst; [|now left].
      right. now apply edge_vector_across_the_tool in O. }
    destruct next as [vm| |]; [now apply (OF vm)|now apply (OF (travel_in_space s b))|left; f_equal;
      now apply same in M].
  - apply bound in H as (made & M & H). apply same in H. injection H as _ ->. right. unfold vector_at_start in M.
    destruct (find _ rest) as [next|]; [|discriminate]. apply bound in M as (moving & _ & M).
    apply bound in M as (? & _ & M).
    apply bound in M as (r & _ & M). apply bound in M as ([made|] & O & E); [|discriminate]. apply same in E as <-.
    now apply edge_vector_across_the_tool in O.
Qed.

Example edge_blocks_across_the_tool_instance last b rest b' v :
  led plain_setup last b rest = Got (b', Some v) ->
    last = Some v \/ dot3 (leading_vector v) (tool_behind plain_setup b) = 0%R.
Proof. apply edge_blocks_across_the_tool. Qed.

(** fanuc.leading-edge.cancel: the cancel ends at the programmed point, and the blocks behind it are as they were. *)
Theorem edge_cancelled_is_programmed {num} {N : Numbers num} (s : setup num) last b rest b' :
  led s last b rest = Got (b', None) -> (last = None -> b' = b) /\ (last <> None -> Forall (bare_item s) (items b')).
Proof.
  unfold led; intro H. destruct last as [w|], (leads (edge (behind b)));
    try (apply bound in H as (? & _ & H)); apply same in H; try discriminate; injection H as <-.
  - split; [discriminate|]. intros _. cbn. constructor; [reflexivity|].
    apply Forall_forall. intros i I. apply filter_In in I as [_ I]. now destruct i.
  - split; [reflexivity|]. now intros [].
Qed.

Example edge_cancelled_is_programmed_instance v (b : planned R) rest b' :
  led plain_setup (Some v) b rest = Got (b', None) -> Forall (bare_item plain_setup) (items b').
Proof. intro H. apply edge_cancelled_is_programmed in H as [_ H]. apply H; discriminate. Qed.

Lemma no_length back (vm vt : triple R) : leading_vector (leading_by back 0%R vm vt) = (0, 0, 0)%R.
Proof.
  unfold leading_by; cbn [leading_vector]. destruct (cross3 (cross3 vm vt) vt) as [[x y] z]. unfold scale3.
  destruct back; cbn; unfold Rdiv; (f_equal; [f_equal|]; ring).
Qed.

(** fanuc.leading-edge.start-with-d0: with a number whose value is 0 the mode is on, and the tool stays on the
    programmed path. *)
Theorem edge_value_zero_is_programmed (s : setup R) bs how p :
  Forall (fun b => Forall (bare_item s) (items b) /\ forall r, radius_at s b = Got r -> r = 0%R) bs ->
  led_from s None bs how = Through p -> Forall (fun b => Forall (bare_item s) (items b)) (fst p).
Proof.
  intro F. assert (G : forall last, match last with Some v => leading_vector v = (0, 0, 0)%R | None => True end ->
    led_from s last bs how = Through p -> Forall (fun b => Forall (bare_item s) (items b)) (fst p)); [|now apply G].
  revert p; induction F as [|b rest [B Z] F IH]; intros p last V H; cbn [led_from] in H.
  - injection H as <-. constructor.
  - destruct (led s last b rest) as [[b' w]| |] eqn:L; try discriminate.
    destruct (led_from s w rest how) as [[bs' how']|] eqn:E; [|discriminate]. injection H as <-. cbn [fst].
    assert (K : Forall (bare_item s) (items b') /\
      match w with Some v => leading_vector v = (0, 0, 0)%R | None => True end).
    { unfold led in L. destruct last as [v|], (leads (edge (behind b))).
      - apply bound in L as (made & M & L). apply same in L. injection L as <- <-.
        assert (MZ : leading_vector made = (0, 0, 0)%R).
        { unfold vector_at_end in M. apply bound in M as (moving & _ & M).
          destruct (negb moving); [apply same in M; now subst|].
          apply bound in M as (next & _ & M). apply bound in M as (r & RA & M). apply Z in RA. subst r.
          assert (OF : forall vm, bind (leading_vector_of s (Some v) 0%R vm (tool_behind s b)) (fun x => Got (or_else x
            v)) = Got made ->
            leading_vector made = (0, 0, 0)%R).
          { intros vm O. apply bound in O as ([x|] & O & EQ); apply same in EQ; cbn in EQ; subst; [|exact V].
            apply made_by in O as [back ->]. apply no_length. }
          destruct next as [vm| |]; [now apply (OF vm)|now apply (OF (travel_in_space s b))|apply same in M; now subst].
          }
        split; [|exact MZ]. rewrite MZ. unfold at_heads; cbn [items with_items].
        apply Forall_map, Forall_forall. intros [m| | | |] _; cbn; auto. exact (zeros_of_space (N := reals) s).
      - apply same in L. injection L as <- <-. split; [|exact I]. cbn. constructor; [reflexivity|].
        apply Forall_forall. intros i J. apply filter_In in J as [_ J]. now destruct i.
      - apply bound in L as (made & M & L). apply same in L. injection L as <- <-.
        assert (MZ : leading_vector made = (0, 0, 0)%R).
        { unfold vector_at_start in M. destruct (find _ rest) as [next|]; [|discriminate].
          apply bound in M as (moving & _ & M). apply bound in M as (u & _ & M). apply bound in M as (r & RA & M).
          apply Z in RA. subst r.
          apply bound in M as ([x|] & O & EQ); [|discriminate]. apply same in EQ as <-. apply made_by in O as [back ->].
          apply no_length. }
        split; [|exact MZ]. rewrite MZ. cbn. constructor; [exact (zeros_of_space (N := reals) s)|].
        apply Forall_forall. intros i J. apply filter_In in J as [_ J]. now destruct i.
      - apply same in L. injection L as <- <-. now split. }
    destruct K as [K K']. constructor; [exact K|]. now apply (IH (bs', how') w).
Qed.

Example edge_value_zero_is_programmed_instance how p :
  led_from plain_setup None [standing_block; standing_block] how = Through p ->
  Forall (fun b => Forall (bare_item plain_setup) (items b)) (fst p).
Proof.
  apply edge_value_zero_is_programmed.
  assert (Z : Forall (bare_item plain_setup) (items standing_block) /\
    forall r, radius_at plain_setup standing_block = Got r -> r = 0%R).
  { split; [repeat constructor|]. intros r H. unfold radius_at, applied in H; cbn in H.
    repeat (apply bound in H as (? & _ & H)). apply same in H. lra. }
  now repeat constructor.
Qed.
