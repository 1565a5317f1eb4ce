(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the corners of tool side compensation: between two lines they are those of the section, and keep the
    distance of the offset from both. *)
From Coq Require Import Reals Lra Psatz Bool ZArith List.
From Coq Require String.
From Toolcomp Require Import Vectors SpecifiedSpace ToolSideCompensation OutcomeLaws.
From Toolcomp Require Numbers Outcomes Space Codes State Movements ProgramLaws Corners SidePlane SideBlocks SideGroups.
Import Outcomes(outcome(..)).
Import ListNotations.
Open Scope R_scope.

(** A line at a corner, as leg_in_plane makes it of a displacement. *)
Definition line_across (vt u : Space.triple R) (rho : R) : Corners.leg_in R (Space.triple R) :=
  Corners.Leg u (Space.unit3 (Space.cross3 (Space.cross3 vt u) vt)) (SidePlane.leftward vt u) None rho.

Lemma lines_of_plane s vt b point rho : SideBlocks.arc_of_block b = None ->
  SideBlocks.leg_in_plane s vt b point rho = Got (line_across vt (SideBlocks.displacement s b) rho).
Proof. intro A. unfold SideBlocks.leg_in_plane. now rewrite A. Qed.

Lemma normal_is_n vt u rho : vector (Corners.normal (line_across vt u rho)) = n 1 (vector vt) (vector u).
Proof.
  unfold line_across, SidePlane.leftward; cbn [Corners.normal]. rewrite vector_unit, vector_cross. unfold n, Rdiv.
  now rewrite Rmult_1_l.
Qed.

Lemma way_is_d vt u rho : vector vt <> zero ->
  vector (Corners.unit_way (line_across vt u rho)) = d (vector vt) (vector u).
Proof.
  intro T. unfold line_across; cbn [Corners.unit_way]. rewrite vector_unit, !vector_cross.
  fold (unit (cross (cross (vector vt) (vector u)) (vector vt))).
  pose proof (dot_self_pos _ T) as P.
  replace (cross (cross (vector vt) (vector u)) (vector vt)) with (scale (dot (vector vt) (vector vt)) (across (vector
    vt) (vector u))).
  - now rewrite unit_scale.
  - rewrite triple_product. unfold across. set (t := vector vt) in *. set (w := vector u) in *.
    rewrite (dot_comm w t). apply vec_eq; unfold sub, opp, add, scale; cbn; field; lra.
Qed.

Lemma other_normal s VT U : n s VT U = scale s (n 1 VT U).
Proof. unfold n. rewrite scale_scale. f_equal. unfold Rdiv. ring. Qed.

(** The instance of the plane of the tool. *)
Notation in_plane vt f := (f R (Space.triple R) Numbers.reals (SidePlane.plane_of_tool vt)).

Lemma meeting_is_Vi vt u v s r : ~ parallel (vector vt) (vector u) -> sided s ->
  vector (in_plane vt (@Corners.tangents_meet) (line_across vt u (s * r)) (line_across vt v (s * r))) =
  Vi r s (vector vt) (vector u) (vector v).
Proof.
  intros H S. pose proof (tool_nonzero _ _ H) as T. unfold Corners.tangents_meet.
  cbn [Corners.scale Corners.add Corners.dot SidePlane.plane_of_tool].
  rewrite vector_scale, vector_add, !normal_is_n, vector_dot, !way_is_d by exact T.
  unfold Vi. rewrite !(other_normal s), <- scale_add, scale_scale. cbn [Corners.rho line_across]. unfold cosine.
  f_equal.
  cbn. unfold Rdiv. ring.
Qed.

Lemma perpendicular_is_n vt u s r : vector (Corners.perpendicular (P := SidePlane.plane_of_tool vt) (line_across vt u (s
  * r))) =
  scale r (n s (vector vt) (vector u)).
Proof.
  unfold Corners.perpendicular. cbn [Corners.scale SidePlane.plane_of_tool].
  rewrite vector_scale, normal_is_n, (other_normal s), scale_scale.
  cbn [Corners.rho line_across]. f_equal. ring.
Qed.

(** fanuc.tool-side.which-rule: the group between two lines, in the mode, is the one of the definitions. *)
Theorem side_group_is_group vt u v s r vs : sided s -> 0 < r ->
  ~ parallel (vector vt) (vector u) -> ~ parallel (vector vt) (vector v) ->
  in_plane vt (@Corners.mode_group) (line_across vt u (s * r)) (line_across vt v (s * r)) = Got vs ->
  map vector vs = group r s (vector vt) (vector u) (vector v).
Proof.
  intros SID POS U V H. pose proof (tool_nonzero _ _ U) as T. pose proof (norm_pos _ T) as P.
  assert (SR : s * r <> 0) by (destruct SID; subst; lra).
  unfold Corners.mode_group in H. apply bound in H as (kind & K & H). unfold Corners.corner_of in K.
  apply bound in K as (side & SG & K). apply decided in SG.
  cbn [Corners.aside Corners.ahead SidePlane.plane_of_tool Corners.way Corners.rho line_across] in SG, K.
  rewrite vector_length, vector_dot, vector_cross in SG. cbn in SG.
  assert (AH : Space.dot3 (Space.cross3 vt u) (Space.cross3 vt v) = C (vector vt) (vector u) (vector v)).
  { now rewrite vector_dot, !vector_cross. }
  rewrite AH in K.
  set (x := dot (vector vt) (cross (vector u) (vector v))) in *.
  assert (SS : S s (vector vt) (vector u) (vector v) = s * x) by reflexivity.
  unfold group. rewrite SS.
  assert (Q : s * r * (norm (vector vt) * x) = r * norm (vector vt) * (s * x)) by ring.
  rewrite Q in SG. assert (RP : 0 < r * norm (vector vt)) by nra.
  assert (MEET : forall ws, Got [in_plane vt (@Corners.tangents_meet) (line_across vt u (s * r)) (line_across vt v (s *
    r))] = Got ws ->
    map vector ws = [Vi r s (vector vt) (vector u) (vector v)]).
  { intros ws E. apply same in E as <-. cbn [map]. f_equal. now apply meeting_is_Vi. }
  assert (TWO : forall both, in_plane vt (@Corners.prolonged) (line_across vt u (s * r)) (line_across vt v (s * r)) =
    Got both ->
    map vector both = [K1 r s (vector vt) (vector u); K2 r s (vector vt) (vector v)]).
  { intros both E. unfold Corners.prolonged in E. apply bound in E as (right & N & E). apply negative_sign in N.
    cbn [Corners.rho line_across] in N, E. apply same in E as <-.
    assert (M : (if right then (0 - s * r) else s * r) = r).
    { destruct right.
      - assert (s * r < 0) by now apply N. destruct SID; subst; lra.
      - pose proof (no_is _ _ N eq_refl). destruct SID; subst; lra. }
    cbn [map Corners.add Corners.subtract Corners.scale SidePlane.plane_of_tool Numbers.minus Numbers.integer
      Numbers.reals].
    rewrite M, vector_add, vector_sub, !vector_scale, !perpendicular_is_n, !way_is_d by exact T.
    assert (D1 : forall a b, add (scale r a) (scale r b) = scale r (add a b)) by (intros a b; vec_ring).
    assert (D2 : forall a b, sub (scale r a) (scale r b) = scale r (sub a b)) by (intros a b; vec_ring).
    now rewrite D1, D2. }
  destruct side.
  - assert (Z : s * x = 0) by (apply Rmult_integral in SG as [SG|SG]; lra).
    destruct (Rlt_dec 0 (s * x)) as [LT|LT]; [lra|].
    apply bound in K as (back & B & K). apply negative_sign in B. apply same in K as <-. destruct back.
    + assert (C (vector vt) (vector u) (vector v) < 0) by now apply B.
      destruct (Rle_dec 0 (C (vector vt) (vector u) (vector v))); [lra|].
      apply bound in H as (both & BO & H). apply same in H as <-. cbn. rewrite app_nil_r. now apply TWO.
    + pose proof (no_is _ _ B eq_refl). destruct (Rle_dec 0 (C (vector vt) (vector u) (vector v))); [|lra].
      apply same in H as <-. cbn [map]. rewrite perpendicular_is_n. f_equal.
      destruct (no_turn_is_straight_or_back s (vector vt) (vector u) (vector v)) as [[K _]|[_ K]];
        [exact SID|exact U|exact V|rewrite SS; exact Z| |lra].
      assert (E : n s (vector vt) (vector v) = n s (vector vt) (vector u)).
      { apply sub_zero. apply dot_self_zero. unfold sub, opp.
        rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r,
          (dot_comm (n s (vector vt) (vector v)) (n s (vector vt) (vector u))).
        rewrite !n_unit, n_dot_n, K by assumption. ring. }
      unfold Vi. rewrite K, E. set (w := n s (vector vt) (vector u)).
      replace (add w w) with (scale 2 w) by vec_ring. rewrite scale_scale. f_equal. field.
  - assert (s * x < 0) by nra. destruct (Rlt_dec 0 (s * x)) as [LT|LT]; [lra|].
    apply bound in K as (acute & B & K). apply negative_sign in B. apply same in K as <-. destruct acute.
    + assert (C (vector vt) (vector u) (vector v) < 0) by now apply B.
      destruct (Rle_dec 0 (C (vector vt) (vector u) (vector v))); [lra|].
      apply bound in H as (both & BO & H). apply same in H as <-. cbn. rewrite app_nil_r. now apply TWO.
    + pose proof (no_is _ _ B eq_refl). destruct (Rle_dec 0 (C (vector vt) (vector u) (vector v))); [|lra].
      apply MEET. exact H.
  - assert (0 < s * x) by nra. destruct (Rlt_dec 0 (s * x)) as [LT|LT]; [|lra]. apply same in K as <-.
    apply bound in H as (meeting & M & H). apply same in M as <-. apply MEET. exact H.
Qed.

(** A tool that leans, along Y and then along X, offset to the left by 10. *)
Lemma leaning_tool : ~ parallel (vector (3, 0, 4)) (vector (0, 100, 0)) /\
  ~ parallel (vector (3, 0, 4)) (vector (100, 0, 0)).
Proof. split; [apply not_parallel_x|apply not_parallel_y]; cbn; lra. Qed.

Example side_group_is_group_instance vs :
  in_plane (3, 0, 4) (@Corners.mode_group) (line_across (3, 0, 4) (0, 100, 0) (1 * 10)) (line_across (3, 0, 4) (100, 0,
    0) (1 * 10)) = Got vs ->
  map vector vs = group 10 1 (Vec 3 0 4) (Vec 0 100 0) (Vec 100 0 0).
Proof.
  destruct leaning_tool as [U V]. exact (side_group_is_group (3, 0, 4) (0, 100, 0) (100, 0,
    0) 1 10 vs left_sided ltac:(lra) U V).
Qed.

Lemma group_on_lines r s VT U1 U2 : sided s -> 0 < r -> ~ parallel VT U1 -> ~ parallel VT U2 ->
  dot (hd zero (group r s VT U1 U2)) (n s VT U1) = r /\ dot (last (group r s VT U1 U2) zero) (n s VT U2) = r.
Proof.
  intros SID POS U V. pose proof (cosine_range VT U1 U2 U V) as RANGE.
  assert (M : 1 + cosine VT U1 U2 <> 0 -> dot (Vi r s VT U1 U2) (n s VT U1) = r /\
    dot (Vi r s VT U1 U2) (n s VT U2) = r)
    by now apply Vi_on_both_lines.
  unfold group. destruct (Rlt_dec 0 (S s VT U1 U2)) as [L|L]; [|destruct (Rle_dec 0 (C VT U1 U2)) as [A|A]];
    cbn [hd last].
  - apply M. intro K. pose proof (reversal_has_no_turn s VT U1 U2 U V K) as Z.
    apply turn_of_S in Z; [lra|exact U|exact V].
  - apply M. apply cosine_of_C in A; auto. lra.
  - destruct (K_past_the_corner r s VT U1 U2 SID U V) as (? & _ & ? & _). split; assumption.
Qed.

Lemma heads_of vt count (vs : list (Space.triple R)) :
  map snd (SideGroups.up_to_stop (P := SidePlane.plane_of_tool vt) count vs) = vs.
Proof. revert count; induction vs as [|v vs IH]; intro count; [reflexivity|]. cbn. now rewrite IH. Qed.

Lemma first_head vs : vector (hd (0, 0, 0) vs) = hd zero (map vector vs).
Proof. now destruct vs. Qed.
Lemma last_head vs : vector (last vs (0, 0, 0)) = last (map vector vs) zero.
Proof. induction vs as [|v [|w vs] IH]; [reflexivity..|]. exact IH. Qed.

(** fanuc.tool-side.which-rule: at every corner between two lines of the mode the tool comes to a vector at the distance
    of the offset from the first line, seen along the tool, and leaves from one at that distance from the second;
    whatever the side s, 1 on the left and -1 on the right. *)
Theorem side_corner_keeps_distance setup a b vt s r from to la lb hs : sided s -> 0 < r ->
  SideBlocks.arc_of_block a = None -> SideBlocks.arc_of_block b = None ->
  let u := SideBlocks.displacement setup a in
  let v := SideBlocks.displacement setup b in
  ~ parallel (vector vt) (vector u) -> ~ parallel (vector vt) (vector v) ->
  SideBlocks.leg_in_plane setup vt a from (s * r) = Got la -> SideBlocks.leg_in_plane setup vt b to (s * r) = Got lb ->
  SideGroups.group_of (P := SidePlane.plane_of_tool vt) setup SideGroups.ModeRule None la lb = Got hs ->
  dot (vector (hd (0, 0, 0) (map snd hs))) (n s (vector vt) (vector u)) = r /\
  dot (vector (last (map snd hs) (0, 0, 0))) (n s (vector vt) (vector v)) = r.
Proof.
  intros SID POS A B u v U V LA LB H. rewrite lines_of_plane in LA, LB by assumption. apply same in LA as <-.
  apply same in LB as <-.
  fold u v in H. unfold SideGroups.group_of, SideGroups.asked_of_lines in H.
  match type of H with match ?x with _ => _ end = _ => destruct x as [got|number|clause] eqn:X end;
    try discriminate.
  2: { repeat match type of H with (if ?c then _ else _) = _ => destruct c; try discriminate end. }
  apply same in H as <-. unfold SideGroups.group_of_mode in X. apply bound in X as (vs & G & X). apply same in X.
  assert (E : map snd got = vs).
  { rewrite <- X, heads_of. destruct vs as [|v1 [|v2 [|v3 rest]]]; reflexivity. }
  rewrite E, first_head, last_head. apply side_group_is_group in G; auto. rewrite G. now apply group_on_lines.
Qed.

Definition block_to (x y : R) (x' y' : R) : Movements.planned R :=
  Movements.Planned 0 (State.Command ProgramLaws.up [10%Z] None (Codes.initial_modes false) None None [] [] [])
    (State.at_position (State.initial ProgramLaws.plain_setup) [x; y; 0] [0; 0; 0])
    (State.at_position (State.initial ProgramLaws.plain_setup) [x'; y'; 0] [0; 0; 0]) [].

Example side_corner_keeps_distance_instance la lb hs :
  let s := ProgramLaws.plain_setup in let a := block_to 0 0 0 100 in let b := block_to 0 100 100 100 in
  SideBlocks.leg_in_plane s (3, 0, 4) a [0; 100; 0] (1 * 10) = Got la ->
  SideBlocks.leg_in_plane s (3, 0, 4) b [0; 100; 0] (1 * 10) = Got lb ->
  SideGroups.group_of (P := SidePlane.plane_of_tool (3, 0, 4)) s SideGroups.ModeRule None la lb = Got hs ->
  dot (vector (hd (0, 0, 0) (map snd hs))) (n 1 (Vec 3 0 4) (Vec (0 - 0) (100 - 0) (0 - 0))) = 10.
Proof.
  intros s a b A B H. destruct (side_corner_keeps_distance s a b (3, 0, 4) 1 10 [0; 100; 0] [0; 100;
    0] la lb hs) as [K _]; auto using left_sided;
    [lra|apply not_parallel_x; cbn; lra|apply not_parallel_y; cbn; lra].
Qed.
