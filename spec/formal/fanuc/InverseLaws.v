(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the inverse of tool center point control: with a pair of rotary positions the tool points along its
    direction. *)
From Coq Require Import Reals Lra Psatz Bool ZArith List.
From Coq Require Import String.
From Toolcomp Require Import Vectors ToolDirection SpecifiedSpace ToolCenterPointControl OutcomeLaws ControlLaws.
From Toolcomp Require Numbers Outcomes Words Angles State Space Pose ControlFrame ControlWords InverseKinematics
  ChoiceOfPair Program
  ProgramLaws ReachLaws.
Import Outcomes(outcome(..)).
Import ListNotations.
Open Scope string_scope.
Open Scope R_scope.

(** The directions of the axes and of the tool. *)
Definition u_t (k : Words.kinematics R) : vec := vector (Words.about (ControlWords.tool_side k)).
Definition u_w (k : Words.kinematics R) : vec := vector (Words.about (ControlWords.work_side k)).
Definition t0 (k : Words.kinematics R) : vec := vector (Words.reference_direction k).
Definition all_units (k : Words.kinematics R) : Prop := is_unit (u_t k) /\ is_unit (u_w k) /\ is_unit (t0 k).

(** A position that turns the direction by an angle with this cosine and sine. *)
Lemma position_is c s reversed a : c * c + s * s = 1 -> InverseKinematics.position_by reversed c s = Got a ->
  Angles.cosine_of a = c /\ Angles.sine_of a = (if reversed then - s else s).
Proof.
  intros E H. unfold InverseKinematics.position_by in H.
  match type of H with Angles.angle_of_unit _ _ ?y = _ => set (x := y) in H end.
  assert (XE : x = if reversed then - s else s) by (unfold x; destruct reversed; cbn; ring).
  assert (X : c * c + x * x = 1) by (rewrite XE; destruct reversed; lra).
  rewrite <- XE. clearbody x. unfold Angles.angle_of_unit in H. apply bound in H as (side & S & H).
  apply bound in H as (ahead & A & H).
  apply decided in S, A. apply same in H as <-.
  destruct side, ahead; cbn; try (split; lra).
  - subst; lra.
  - split; [nra|lra].
  - split; [nra|lra].
  - split; [lra|nra].
  - split; [lra|nra].
Qed.

(** * The tool side *)

Definition reach_numbers k : InverseKinematics.reach R := InverseKinematics.reach_of k.

Lemma reach_is k :
  InverseKinematics.along_axis (reach_numbers k) = dot (u_w k) (along (u_t k) (t0 k)) /\
  InverseKinematics.toward (reach_numbers k) = A (u_t k) (u_w k) (t0 k) /\
  InverseKinematics.across (reach_numbers k) = B (u_t k) (u_w k) (t0 k) /\
  InverseKinematics.radius_square (reach_numbers k) = rho (u_t k) (u_w k) (t0 k) * rho (u_t k) (u_w k) (t0 k).
Proof.
  unfold reach_numbers, InverseKinematics.reach_of; cbn [InverseKinematics.along_axis InverseKinematics.toward
    InverseKinematics.across InverseKinematics.radius_square].
  rewrite rho_square. unfold A, B, along, u_t, u_w, t0.
  rewrite !vector_dot, vector_sub, !vector_scale, vector_cross. repeat split.
Qed.

Lemma tool_side_by_angle k c s : c * c + s * s = 1 -> exists tau, cos tau = c /\ sin tau = s /\
  vector (InverseKinematics.on_tool_side k c s) = rotate (u_t k) tau (t0 k).
Proof.
  intro E. destruct (some_angle c s E) as (tau & C & S). exists tau. repeat split; auto.
  unfold InverseKinematics.on_tool_side, u_t, t0.
  rewrite <- C, <- S. apply turned_is_rotate.
Qed.

(** A root of the equation for the tool side. *)
Lemma root_is k (x h : R) : let r := reach_numbers k in
  0 < InverseKinematics.radius_square r -> x * x + h * h = InverseKinematics.radius_square r ->
  let c := (InverseKinematics.toward r * x - InverseKinematics.across r * h) / InverseKinematics.radius_square r in
  let s := (InverseKinematics.across r * x + InverseKinematics.toward r * h) / InverseKinematics.radius_square r in
  c * c + s * s = 1 /\ A (u_t k) (u_w k) (t0 k) * c + B (u_t k) (u_w k) (t0 k) * s = x.
Proof.
  intros r P E c s. destruct (reach_is k) as (_ & RA & RB & RR). pose proof (rho_square (u_t k) (u_w k) (t0 k)) as Q.
  fold r in RA, RB, RR.
  rewrite <- RA, <- RB, <- RR in Q. rewrite <- RA, <- RB. unfold c, s. set (a := InverseKinematics.toward r) in *.
  set (b := InverseKinematics.across r) in *. set (q := InverseKinematics.radius_square r) in *. split.
  - transitivity ((a * a + b * b) * (x * x + h * h) / (q * q)); [field; lra|]. rewrite E, <- Q. field. lra.
  - transitivity ((a * a + b * b) * x / q); [field; lra|]. rewrite <- Q. field. lra.
Qed.

Lemma on_the_edge k rho_ c edge : InverseKinematics.on_edge_of_reach k rho_ c = Got edge ->
  (edge = true -> c = rho_ \/ c = - rho_) /\
  (InverseKinematics.reaches_work_axis k false = Got false \/ c <= rho_ ->
    InverseKinematics.reaches_work_axis k true = Got false \/ - rho_ <= c ->
   - rho_ <= c <= rho_).
Proof.
  unfold InverseKinematics.on_edge_of_reach; intro H. apply bound in H as (near & N & H).
  apply bound in H as (far & F & H). apply same in H as <-.
  apply bound in N as (never & V & N). apply bound in F as (never' & V' & F).
  assert (NN : (near = true -> c = rho_) /\ (never = false -> c <= rho_)).
  { destruct never; [apply same in N as <-; split; discriminate|]. apply bound in N as (inside & D & N).
    apply decided in D. cbn in D.
    destruct inside; try discriminate; apply same in N as <-; split; intros; try discriminate; lra. }
  assert (FF : (far = true -> c = - rho_) /\ (never' = false -> - rho_ <= c)).
  { destruct never'; [apply same in F as <-; split; discriminate|]. apply bound in F as (inside & D & F).
    apply decided in D. cbn in D.
    destruct inside; try discriminate; apply same in F as <-; split; intros; try discriminate; lra. }
  split.
  - intro E. apply orb_prop in E as [E|E]; [left; now apply NN|right; now apply FF].
  - intros [L|L] [L'|L'].
    + rewrite L in V. apply same in V. rewrite L' in V'. apply same in V'. subst. split; [now apply FF|now apply NN].
    + rewrite L in V. apply same in V. subst. split; [exact L'|now apply NN].
    + rewrite L' in V'. apply same in V'. subst. split; [now apply FF|exact L].
    + now split.
Qed.

(** The height of a direction above the plane that the tool side turns in: C. *)
Definition height k (v : Space.triple R) : R :=
  Space.dot3 (Words.about (ControlWords.work_side k)) v / Space.length3 v - InverseKinematics.along_axis (reach_numbers
    k).

(** fanuc.tool-center-point.inverse: with the tool side at an angle of the pair the tool stands as high along the
    work-side axis as the direction does, of every direction in reach. *)
Theorem tool_side_stands_as_high k v found c s : all_units k -> 0 < rho (u_t k) (u_w k) (t0 k) -> vector v <> zero ->
  Rabs (height k v) <= rho (u_t k) (u_w k) (t0 k) ->
  InverseKinematics.tool_angles k v = Got found -> In (c, s) found ->
  c * c + s * s = 1 /\ dot (u_w k) (vector (InverseKinematics.on_tool_side k c s)) = dot (u_w k) (vector v) / norm
    (vector v).
Proof.
  intros (UT & UW & U0) P V W H I. unfold InverseKinematics.tool_angles in H. fold (reach_numbers k) in H.
  fold (height k v) in H.
  change (Numbers.minus (Numbers.over (Space.dot3 (Words.about (ControlWords.work_side k)) v) (Space.length3 v))
    (InverseKinematics.along_axis (reach_numbers k)))
    with (height k v) in H.
  destruct (reach_is k) as (RL & RA & RB & RR). set (r := reach_numbers k) in *.
  set (q := InverseKinematics.radius_square r) in *.
  assert (QP : 0 < q) by (rewrite RR; nra).
  assert (ROOT : sqrt q = rho (u_t k) (u_w k) (t0 k)) by (rewrite RR; apply sqrt_square; lra).
  apply within in W. apply bound in H as (edge & E & H). apply on_the_edge in E as (E & _).
  change (Numbers.root q) with (sqrt q) in E. rewrite ROOT in E.
  assert (X : exists h, height k v * height k v + h * h = q /\
    c = (InverseKinematics.toward r * height k v - InverseKinematics.across r * h) / q /\
    s = (InverseKinematics.across r * height k v + InverseKinematics.toward r * h) / q).
  { destruct edge.
    - apply same in H as <-. destruct I as [I|[]]. injection I as <- <-. exists 0. split; [|split; reflexivity].
      rewrite RR. destruct (E eq_refl) as [->| ->]; ring.
    - apply same in H as <-. assert (S : sqrt (q - height k v * height k v) * sqrt (q - height k v * height k v) = q -
        height k v * height k v)
        by (apply sqrt_sqrt; rewrite RR; nra).
      destruct I as [I|[I|[]]]; injection I as <- <-.
      + exists (sqrt (q - height k v * height k v)). split; [lra|split; reflexivity].
      + exists (0 - sqrt (q - height k v * height k v)). split; [lra|split; reflexivity]. }
  destruct X as (h & EH & -> & ->). destruct (root_is k (height k v) h QP EH) as [ONE HIGH]. fold r q in ONE, HIGH.
  split; [exact ONE|]. destruct (tool_side_by_angle k _ _ ONE) as (tau & CT & ST & T).
  rewrite T, height_swings, CT, ST, HIGH, <- RL.
  unfold height. fold r. rewrite vector_dot, vector_length. unfold u_w. cbn. ring.
Qed.

(** * Reach *)

Definition unit_of (v : Space.triple R) : vec := scale (/ norm (vector v)) (vector v).
Lemma unit_of_is_unit v : vector v <> zero -> is_unit (unit_of v).
Proof.
  intro V. pose proof (norm_pos _ V) as P. unfold is_unit, unit_of. rewrite dot_scale_l, dot_scale_r, <- norm_sqr.
  field. lra.
Qed.
Lemma height_is_C k v : height k v = C (u_t k) (u_w k) (t0 k) (unit_of v).
Proof.
  unfold height, C, unit_of. destruct (reach_is k) as (-> & _). rewrite vector_dot, vector_length, dot_scale_r.
  unfold u_w. cbn.
  unfold Rdiv. ring.
Qed.

Lemma zero_decided clause (x : R) : exists b, Outcomes.is_zero clause x = Got b.
Proof. unfold Outcomes.is_zero. destruct (decides clause x) as [c ->]. eexists; reflexivity. Qed.

(** What is found is in reach. *)
Lemma found_is_in_reach k v edge : all_units k -> vector v <> zero ->
  InverseKinematics.on_edge_of_reach k (rho (u_t k) (u_w k) (t0 k)) (height k v) = Got edge ->
  Rabs (height k v) <= rho (u_t k) (u_w k) (t0 k).
Proof.
  intros (UT & UW & U0) V H. apply on_the_edge in H as (_ & H).
  destruct (reach_by_angles _ _ _ _ UT UW U0 (unit_of_is_unit v V)) as [NEAR FAR]. rewrite <- height_is_C in NEAR, FAR.
  pose proof (unit_cos_angle _ _ UT U0) as CA. pose proof (unit_cos_angle _ _ UT UW) as CB.
  assert (REACH : forall opposite, exists b, InverseKinematics.reaches_work_axis k opposite = Got b /\
    (b = true <-> (if opposite then dot (u_t k) (t0 k) + dot (u_t k) (u_w k) else dot (u_t k) (t0 k) - dot (u_t k) (u_w
      k)) = 0)).
  { intro opposite. unfold InverseKinematics.reaches_work_axis. rewrite !vector_dot. fold (u_t k) (u_w k) (t0 k).
    match goal with |- context [Outcomes.is_zero ?c ?x] => destruct (zero_decided c x) as [b Z] end.
    exists b. split; [exact Z|]. apply zero_sign in Z. destruct opposite; exact Z. }
  assert (B : - rho (u_t k) (u_w k) (t0 k) <= height k v <= rho (u_t k) (u_w k) (t0 k)).
  { apply H.
    - destruct (REACH false) as (b & -> & Z). destruct b; [right|now left].
      assert (E : dot (u_t k) (t0 k) - dot (u_t k) (u_w k) = 0) by now apply Z.
      assert (S : angle (u_t k) (t0 k) = angle (u_t k) (u_w k)).
      { unfold angle. rewrite !norm_unit by assumption. f_equal. f_equal. lra. }
      rewrite S, Rminus_eq_0, cos_0 in NEAR. pose proof (COS_bound (angle (u_w k) (unit_of v))). lra.
    - destruct (REACH true) as (b & -> & Z). destruct b; [right|now left].
      assert (E : dot (u_t k) (t0 k) + dot (u_t k) (u_w k) = 0) by now apply Z.
      assert (S : angle (u_t k) (t0 k) + angle (u_t k) (u_w k) = PI).
      { unfold angle. rewrite !norm_unit by assumption. replace (dot (u_t k) (t0 k) / (1 * 1)) with (- (dot (u_t k) (u_w
          k) / (1 * 1))) by lra.
        rewrite acos_opp. ring. }
      rewrite S, cos_PI in FAR. pose proof (COS_bound (angle (u_w k) (unit_of v))). lra. }
  unfold Rabs. destruct (Rcase_abs _); lra.
Qed.

(** * The work side *)

Definition side_turn (reversed : bool) (a : Words.rotary_axis R) (x : Angles.angle R) (v : Space.triple R) :
  Space.triple R :=
  Pose.turned (Words.about a) (Angles.cosine_of x) (if reversed then 0 - Angles.sine_of x else Angles.sine_of x) v.

Lemma direction_of_sides k tau omega : Pose.direction_at k (InverseKinematics.pose_of_sides k (tau, omega)) =
  side_turn (InverseKinematics.work_reversed k) (ControlWords.work_side k) omega
    (side_turn (InverseKinematics.tool_reversed k) (ControlWords.tool_side k) tau (Words.reference_direction k)).
Proof.
  unfold Pose.direction_at, InverseKinematics.pose_of_sides, InverseKinematics.work_reversed,
    InverseKinematics.tool_reversed,
    ControlWords.work_side, ControlWords.tool_side, side_turn, Pose.carried, Pose.carried_back.
  destruct (Words.machine_of k); cbn [fst snd];
    destruct (Words.left_handed (Words.first_axis k)), (Words.left_handed (Words.second_axis k)); reflexivity.
Qed.

Lemma side_turn_by c s (reversed : bool) a x v : Angles.cosine_of x = c ->
  Angles.sine_of x = (if reversed then - s else s) ->
  side_turn reversed a x v = Pose.turned (Words.about a) c s v.
Proof. intros C S. unfold side_turn. rewrite C, S. f_equal. destruct reversed; ring. Qed.

Lemma work_side_carries u w v : is_unit u -> is_unit w -> vector v <> zero ->
  dot u w = dot u (unit_of v) -> dot u w * dot u w < 1 ->
  let size := (dot (vector v) (vector v) - dot u (vector v) * dot u (vector v)) / norm (vector v) in
  let c := (dot w (vector v) - dot u w * dot u (vector v)) / size in
  let s := dot u (cross w (vector v)) / size in
  exists theta, cos theta = c /\ sin theta = s /\ rotate u theta w = unit_of v.
Proof.
  intros U W V H M size c s. pose proof (norm_pos _ V) as P. pose proof (norm_sqr (vector v)) as Q.
  exists (carrying u w (unit_of v)). pose proof (carried u w (unit_of v) U W (unit_of_is_unit v V) H) as R.
  split; [|split; [|exact R]].
  all: unfold carrying; set (y := dot u (cross w (unit_of v)));
    set (x := dot w (unit_of v) - dot u w * dot u (unit_of v)).
  all: assert (X : y * y = (1 - dot u w * dot u w) * (1 - dot u w * dot u w) - x * x).
  1,3: assert (G : y * y = dot u u * dot w w * dot (unit_of v) (unit_of v) + 2 * dot u w * dot w (unit_of v) * dot u
    (unit_of v)
      - dot u u * (dot w (unit_of v) * dot w (unit_of v)) - dot w w * (dot u (unit_of v) * dot u (unit_of v))
      - dot (unit_of v) (unit_of v) * (dot u w * dot u w)) by (unfold y; set (e := unit_of v); vec_ring);
    rewrite G, (unit_of_is_unit v V), U, W; unfold x; rewrite <- H; ring.
  all: set (m := 1 - dot u w * dot u w) in *; assert (MP : 0 < m) by (unfold m; lra).
  all: assert (S : sqrt (x * x + y * y) = m) by (replace (x * x + y * y) with (m * m) by lra; apply sqrt_square; lra).
  all: assert (SZ : size = norm (vector v) * m).
  1,3: unfold size, m; rewrite H; unfold unit_of; rewrite dot_scale_r, <- Q; field; lra.
  - pose proof (cos_atan2 y x) as C. rewrite S in C. unfold c. rewrite SZ.
    assert (E : dot w (vector v) - dot u w * dot u (vector v) = norm (vector v) * x).
    { unfold x, unit_of. rewrite !dot_scale_r. field. lra. }
    rewrite E. apply (Rmult_eq_reg_l m); [rewrite C; field; lra|lra].
  - pose proof (sin_atan2 y x) as C. rewrite S in C. unfold s. rewrite SZ.
    assert (E : dot u (cross w (vector v)) = norm (vector v) * y).
    { unfold y, unit_of. replace (cross w (scale (/ norm (vector v)) (vector v))) with (scale (/ norm (vector v)) (cross
        w (vector v))) by vec_ring.
      rewrite dot_scale_r. field. lra. }
    rewrite E. apply (Rmult_eq_reg_l m); [rewrite C; field; lra|lra].
Qed.

(** fanuc.tool-center-point.inverse: with every pair of a direction that is not along the work-side axis the tool points
    along it, on machines of every type with axes of every inclination. The second direction is the first one as seen
    from the zero pose of the table: turned about the work-side axis. *)
Theorem pairs_point_along_the_direction k v from_zero pairs tau omega : all_units k -> 0 < rho (u_t k) (u_w k) (t0 k) ->
  vector v <> zero -> vector from_zero <> zero -> dot (u_w k) (unit_of from_zero) = dot (u_w k) (unit_of v) ->
  cross (u_w k) (vector v) <> zero ->
  InverseKinematics.pairs_of k v from_zero = Got pairs -> In (tau, omega) pairs ->
  vector (Pose.direction_at k (InverseKinematics.pose_of_sides k (tau, omega))) = unit_of from_zero.
Proof.
  intros U P V Z SAME N H I. pose proof U as (UT & UW & U0). unfold InverseKinematics.pairs_of in H.
  apply bound in H as (found & F & H).
  destruct (ReachLaws.each_in _ _ _ _ H I) as ([c s] & J & E). apply bound in E as (tau' & T & E).
  apply bound in E as (omega' & W & E).
  apply same in E. injection E as -> ->.
  assert (REACH : Rabs (height k v) <= rho (u_t k) (u_w k) (t0 k)).
  { pose proof F as G. unfold InverseKinematics.tool_angles in G. apply bound in G as (edge & G & _).
    destruct (reach_is k) as (_ & _ & _ & RR). change (InverseKinematics.reach_of k) with (reach_numbers k) in G.
    change (Numbers.root (InverseKinematics.radius_square (reach_numbers k))) with (sqrt
      (InverseKinematics.radius_square (reach_numbers k))) in G.
    rewrite RR, sqrt_square in G by lra. exact (found_is_in_reach k v edge U V G). }
  destruct (tool_side_stands_as_high k v found c s U P V REACH F J) as [ONE HIGH].
  apply position_is in T as [CT ST]; [|exact ONE].
  rewrite direction_of_sides, (side_turn_by c s _ _ tau) by assumption. fold (InverseKinematics.on_tool_side k c s).
  set (w := InverseKinematics.on_tool_side k c s) in *.
  assert (WU : is_unit (vector w)).
  { destruct (tool_side_by_angle k c s ONE) as (t & _ & _ & T). unfold w. rewrite T. unfold is_unit.
    rewrite rotate_dot by exact UT. exact U0. }
  pose proof (norm_pos _ V) as PV. pose proof (norm_sqr (vector v)) as QV.
  assert (HW : dot (u_w k) (vector w) = dot (u_w k) (unit_of from_zero)).
  { rewrite HIGH, SAME. unfold unit_of. rewrite dot_scale_r. unfold Rdiv. ring. }
  assert (LESS : dot (u_w k) (vector w) * dot (u_w k) (vector w) < 1).
  { rewrite HIGH. pose proof (dot_self_pos _ N) as NP. rewrite lagrange, UW in NP. unfold Rsqr in NP.
    rewrite <- QV in NP.
    apply (Rmult_lt_reg_r (norm (vector v) * norm (vector v))); [nra|].
    replace (dot (u_w k) (vector v) / norm (vector v) * (dot (u_w k) (vector v) / norm (vector v)) * (norm (vector v) *
      norm (vector v)))
      with (dot (u_w k) (vector v) * dot (u_w k) (vector v)) by (field; lra). lra. }
  destruct (work_side_carries (u_w k) (vector w) from_zero UW WU Z HW LESS) as (theta & CW & SW & R).
  unfold InverseKinematics.work_position in W. rewrite !vector_dot, vector_cross, vector_length in W. fold (u_w k) in W.
  cbn [Numbers.minus Numbers.times Numbers.over Numbers.reals] in W. rewrite <- CW, <- SW in W.
  apply position_is in W as [CO SO]; [|pose proof (cos_sin_square theta); lra].
  rewrite (side_turn_by (cos theta) (sin theta) _ _ omega) by assumption. rewrite turned_is_rotate. exact R.
Qed.

(** A table that turns about X on one that turns about Z, with the tool along Z. *)
Lemma table_units : all_units some_table /\ 0 < rho (u_t some_table) (u_w some_table) (t0 some_table).
Proof.
  split.
  - repeat split; unfold is_unit, dot; cbn; lra.
  - unfold rho. apply sqrt_lt_R0. unfold A, B, along, dot, cross, sub, opp, add, scale; cbn. lra.
Qed.
Lemma leaning_direction : vector (3, 0, 4) <> zero /\ cross (u_w some_table) (vector (3, 0, 4)) <> zero.
Proof.
  split; intro E; [apply (f_equal vx) in E|apply (f_equal vy) in E]; unfold cross, zero in E; cbn in E; lra.
Qed.

Example tool_side_stands_as_high_instance found c s :
  Rabs (height some_table (3, 0, 4)) <= rho (u_t some_table) (u_w some_table) (t0 some_table) ->
  InverseKinematics.tool_angles some_table (3, 0, 4) = Got found -> In (c, s) found -> c * c + s * s = 1.
Proof.
  intros R F I. destruct table_units as [U P]. destruct leaning_direction as [V _].
  now apply (tool_side_stands_as_high some_table (3, 0, 4) found c s U P V R F I).
Qed.

Example pairs_point_along_the_direction_instance pairs tau omega :
  InverseKinematics.pairs_of some_table (3, 0, 4) (3, 0, 4) = Got pairs -> In (tau, omega) pairs ->
  vector (Pose.direction_at some_table (tau, omega)) = unit_of (3, 0, 4).
Proof.
  intros H I. destruct table_units as [U P]. destruct leaning_direction as [V N].
  exact (pairs_point_along_the_direction some_table (3, 0, 4) (3, 0, 4) pairs tau omega U P V V eq_refl N H I).
Qed.

(** fanuc.tool-center-point.inverse: so with the pose that is chosen the tool points along the direction, in every block
    with I J K but one for the present direction or one along the work-side axis. *)
Theorem chosen_pose_points_along_the_direction s k now now_direction v from_zero to : all_units k ->
  0 < rho (u_t k) (u_w k) (t0 k) -> vector v <> zero -> vector from_zero <> zero ->
  dot (u_w k) (unit_of from_zero) = dot (u_w k) (unit_of v) ->
  ChoiceOfPair.choose s k now now_direction v from_zero = Got to ->
  ChoiceOfPair.same_direction "fanuc.tool-center-point.choice" now_direction v = Got false ->
  InverseKinematics.parallel_to_work_axis k v = Got None ->
  vector (Pose.direction_at k to) = unit_of from_zero.
Proof.
  intros U P V Z SAME H D PAR.
  destruct (ReachLaws.chosen_pose_is_a_pair s k now now_direction v from_zero to H D PAR) as (pairs & [tau omega] & F &
    I & T & W).
  assert (N : cross (u_w k) (vector v) <> zero).
  { unfold InverseKinematics.parallel_to_work_axis in PAR. apply bound in PAR as (parallel & E & PAR).
    apply zero_sign in E.
    destruct parallel; [apply bound in PAR as (opposite & _ & PAR); discriminate|]. intro C.
    assert (false = true); [|discriminate]. apply E. rewrite vector_dot, vector_cross. fold (u_w k). rewrite C.
    unfold dot; cbn. ring. }
  rewrite <- (pairs_point_along_the_direction k v from_zero pairs tau omega U P V Z SAME N F I). f_equal.
  assert (E : to = InverseKinematics.pose_of_sides k (fst (InverseKinematics.sides_of k to),
    snd (InverseKinematics.sides_of k to))).
  { destruct to as [a b]. unfold InverseKinematics.pose_of_sides, InverseKinematics.sides_of.
    now destruct (Words.machine_of k). }
  rewrite E, !direction_of_sides. destruct T as [CT ST], W as [CW SW]. cbn [fst snd] in *. unfold side_turn.
  now rewrite CT, ST, CW, SW.
Qed.

Example chosen_pose_points_along_the_direction_instance now now_direction to :
  ChoiceOfPair.choose ProgramLaws.plain_setup some_table now now_direction (3, 0, 4) (3, 0, 4) = Got to ->
  ChoiceOfPair.same_direction "fanuc.tool-center-point.choice" now_direction (3, 0, 4) = Got false ->
  vector (Pose.direction_at some_table to) = unit_of (3, 0, 4).
Proof.
  intros H D. destruct table_units as [U P]. destruct leaning_direction as [V N].
  apply (chosen_pose_points_along_the_direction ProgramLaws.plain_setup some_table now now_direction (3, 0, 4) (3, 0,
    4) to); auto.
  unfold InverseKinematics.parallel_to_work_axis. rewrite is_not_zero; [reflexivity|].
  unfold Space.dot3, Space.cross3; cbn. lra.
Qed.
