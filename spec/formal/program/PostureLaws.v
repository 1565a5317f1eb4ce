(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of tool posture control: where a block starts and ends, when its axes run evenly, and the great circle inside.
    *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Psatz.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset Angles ControlState State
  Space Pose.
From Toolcomp Require Import ControlFrame Movements ControlWords InverseKinematics ChoiceOfPair PostureAngles
  PostureControl PosturePath.
From Toolcomp Require Import ControlStep Program OutcomeLaws ProgramLaws ChoiceLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * Start and end *)

(** It starts where the axes stand, and ends at the pose commanded, if one is. *)
Definition runs_between {num} (from : pose num) (commanded : option (pose num)) (run : rotary_run num) : Prop :=
  pose_before run = from /\ match commanded with Some to => pose_behind run = to | None => True end.

Lemma conventional_between {num} {N : Numbers num} warned (from to : pose num) :
  runs_between from (Some to) (conventionally warned from to).
Proof. now split. Qed.

Lemma from_singular_between {num} {N : Numbers num} k opposite (from to : pose num) vs ve z run :
  from_singular k opposite from to vs ve z = Got run -> runs_between from (Some to) run.
Proof.
  unfold from_singular; intro H. destruct (sides_of k from) as [tau omega], (sides_of k to) as [tau_e omega_e].
  do 3 (apply bound in H as (? & _ & H)). apply bound in H as (comes & _ & H). destruct comes; cbn [negb] in H.
  - destruct (tool_angle k _) as [c s]. do 4 (apply bound in H as (? & _ & H)). apply same in H as <-. now split.
  - apply same in H as <-. now split.
Qed.

Lemma sides_and_back {num} k (p : pose num) : pose_of_sides k (sides_of k p) = p.
Proof. destruct p. unfold pose_of_sides, sides_of. now destruct (machine_of k). Qed.

Lemma to_singular_between {num} {N : Numbers num} (s : setup num) k opposite above (from :
  pose num) commanded vs ve z run :
  to_singular s k opposite above from commanded vs ve z = Got run -> runs_between from commanded run.
Proof.
  unfold to_singular; intro H. destruct (sides_of k from) as [tau omega].
  do 2 (apply bound in H as (? & _ & H)). destruct (tool_angle k _) as [c1 s1]. do 3 (apply bound in H as (? & _ & H)).
  destruct commanded as [to|].
  - destruct (sides_of k to) as [tau_e omega_c]. apply bound in H as (comes & _ & H). destruct comes.
    + apply bound in H as (turn & _ & H). apply same in H as <-. now split.
    + apply same in H as <-. now split.
  - do 3 (apply bound in H as (? & _ & H)). apply same in H as <-. now split.
Qed.

(** fanuc.tool-posture.type-1: a block with P1 starts where the axes stand, and with rotary words it ends at the
    positions commanded, whatever singular posture it meets: turns at a standing tip included. *)
Theorem posture_ends_where_commanded {num} {N : Numbers num} (s : setup num) k from commanded vs ve vz ez run changed :
  posture_run s k from commanded vs ve vz ez = Got (run, changed) -> runs_between from commanded run.
Proof.
  unfold posture_run; intro H. apply bound in H as (edge & _ & H). apply bound in H as (no_plane & _ & H).
  assert (PAIR : forall to, (match commanded with Some to => Got to | None => choose s k from vs ve ez end) = Got to ->
    forall run, runs_between from (Some to) run -> runs_between from commanded run).
  { intros to E run' R. destruct commanded as [to'|]; [apply same in E as ->; exact R|]. destruct R. now split. }
  destruct no_plane.
  { apply bound in H as (run' & R & H). apply same in H. injection H as -> _. apply bound in R as (to & T & R).
    apply same in R as <-.
    apply (PAIR to T). apply conventional_between. }
  apply bound in H as (at_start & _ & H). destruct at_start as [opposite|].
  { apply bound in H as (run' & R & H). apply same in H. injection H as -> _. apply bound in R as (to & T & R).
    apply (PAIR to T). now apply from_singular_between in R. }
  apply bound in H as (at_end & _ & H). apply bound in H as (above & _ & H). destruct at_end as [opposite|].
  { apply bound in H as (run' & R & H). apply same in H. injection H as -> _. now apply to_singular_between in R. }
  apply bound in H as (p & _ & H). apply bound in H as (crossing & _ & H). apply bound in H as (u & _ & H).
  destruct commanded as [to|].
  - apply bound in H as (leads & _ & H). apply bound in H as (run' & R & H). apply same in R. apply same in H.
    injection H as -> _.
    subst run. destruct leads; now split.
  - unfold to_direction in H. apply bound in H as ([tau_e omega_e] & _ & H). apply bound in H as (near & _ & H).
    apply bound in H as (to & _ & H). destruct to as [to|].
    + apply same in H. injection H as <- _. now split.
    + apply bound in H as (v & _ & H). apply same in H. injection H as <- _. now split.
Qed.

Example posture_ends_where_commanded_instance k (from to : pose R) vs ve vz ez run changed :
  posture_run plain_setup k from (Some to) vs ve vz ez = Got (run, changed) -> pose_before run = from /\
    pose_behind run = to.
Proof. intro H. now apply posture_ends_where_commanded in H. Qed.

(** * Evenly *)

(** fanuc.tool-posture.no-plane: between equal directions a block with P1 runs as one without it: every axis evenly. *)
Theorem equal_directions_run_evenly (s : setup R) k from to v vz ez run changed :
  posture_run s k from (Some to) v v vz ez = Got (run, changed) -> run = conventionally false from to /\
    changed = false.
Proof.
  unfold posture_run; intro H. apply bound in H as (edge & _ & H). rewrite known_same in H. cbn [bind] in H.
  apply same in H.
  injection H as <- <-. now split.
Qed.

Example equal_directions_run_evenly_instance k from to v vz ez run changed :
  posture_run plain_setup k from (Some to) v v vz ez = Got (run, changed) -> way run = Evenly.
Proof. intro H. apply equal_directions_run_evenly in H as [-> _]. reflexivity. Qed.

(** fanuc.tool-center-point.conventional: without posture control no block has turns at a standing tip or a great circle
    that rotary axes follow: they run evenly from where they stand. *)
Theorem without_posture_control_evenly {num} {N : Numbers num} (s : setup num) c circle_of along to m st behind k :
  control_runs s c circle_of along to m st = Got behind -> posture_control m = false -> kinematics_of s = Some k ->
  exists run, run_of_block behind = Some run /\ way run = Evenly /\ pose_before run = pose_of s k st /\
    turns_before run = false /\ turns_behind run = false /\ stands_at behind = Some (pose_behind run).
Proof.
  unfold control_runs; intros H P K. rewrite K, P in H. cbn [andb] in H. destruct (control_by m).
  - apply bound in H as (pose & _ & H). cbn [bind] in H. apply same in H as <-. eexists; repeat split; reflexivity.
  - apply bound in H as (target & _ & H). destruct target as [[v kept]|].
    + apply bound in H as ([run changed] & R & H). apply bound in R as (goal & _ & R). apply same in R.
      injection R as <- <-.
      apply same in H as <-. eexists; repeat split; reflexivity.
    + apply same in H as <-. eexists; repeat split; reflexivity.
Qed.

Example without_posture_control_evenly_instance c circle_of along to m st behind k (s : setup R) :
  control_runs s c circle_of along to m st = Got behind -> posture_control m = false -> kinematics_of s = Some k ->
  exists run, run_of_block behind = Some run /\ way run = Evenly.
Proof.
  intros H P K. destruct (without_posture_control_evenly s c circle_of along to m st behind k H P K) as (run & R & W &
    _). eauto.
Qed.

(** * The great circle *)

Lemma three_parts (a b : triple R) x y : dot3 (add3 (scale3 x a) (scale3 y b)) (cross3 a b) = 0%R.
Proof. destruct a as [[? ?] ?], b as [[? ?] ?]. unfold add3, scale3, dot3, cross3; cbn. ring. Qed.

Lemma unit_is_scaled (a : triple R) : unit3 a = scale3 (/ length3 a)%R a.
Proof.
  unfold unit3. set (l := length3 a). destruct a as [[x y] z]. unfold scale3; cbn. unfold Rdiv.
  f_equal; [f_equal|]; ring.
Qed.

(** fanuc.tool-posture.great-circle: all along a block the direction of the tool stays in the plane of its start and its
    end. *)
Theorem great_circle_in_one_plane t (from to v : triple R) : on_great_circle t from to = Got v ->
  dot3 v (cross3 from to) = 0%R.
Proof.
  assert (G : forall x y, dot3 (add3 (scale3 x (unit3 from)) (scale3 y (unit3 to))) (cross3 from to) = 0%R).
  { intros x y. rewrite !unit_is_scaled.
    assert (E : add3 (scale3 x (scale3 (/ length3 from)%R from)) (scale3 y (scale3 (/ length3 to)%R to)) =
      add3 (scale3 (x * / length3 from)%R from) (scale3 (y * / length3 to)%R to)).
    { generalize (/ length3 from)%R (/ length3 to)%R. intros p q. destruct from as [[? ?] ?], to as [[? ?] ?].
      unfold add3, scale3; cbn.
      f_equal; [f_equal|]; ring. }
    rewrite E. apply three_parts. }
  unfold on_great_circle; intro H. apply bound in H as (parallel & _ & H). apply bound in H as (halfway & _ & H).
  destruct parallel.
  - apply same in H as <-. specialize (G 1%R 0%R).
    assert (E : add3 (scale3 1%R (unit3 from)) (scale3 0%R (unit3 to)) = unit3 from).
    { destruct (unit3 from) as [[? ?] ?], (unit3 to) as [[? ?] ?]. unfold add3, scale3; cbn. f_equal; [f_equal|]; ring.
      }
    now rewrite E in G.
  - destruct halfway.
    + apply same in H as <-. set (l := length3 (add3 (unit3 from) (unit3 to))).
      assert (E : unit3 (add3 (unit3 from) (unit3 to)) = add3 (scale3 (/ l)%R (unit3 from)) (scale3 (/ l)%R (unit3
        to))).
      { rewrite unit_is_scaled. fold l. destruct (unit3 from) as [[? ?] ?], (unit3 to) as [[? ?] ?].
        unfold add3, scale3; cbn.
        f_equal; [f_equal|]; ring. }
      rewrite E. apply G.
    + apply bound in H as (side & _ & H). apply same in H as <-. apply G.
Qed.

Example great_circle_in_one_plane_instance v : on_great_circle (1 / 4)%R (1, 0, 0)%R (0, 0, 1)%R = Got v ->
  dot3 v (cross3 (1, 0, 0) (0, 0, 1))%R = 0%R.
Proof. apply great_circle_in_one_plane. Qed.

(** The angle whose sine and cosine these are. *)
Lemma sine_of_arctangent (s c : R) : (s * s + c * c = 1)%R -> (0 < s)%R -> forall side,
  match side with Lt => c < 0 | Eq => c = 0 | Gt => 0 < c end%R ->
  sine (match side with Eq => integer 90 | Gt => arctangent (s / c)%num |
    Lt => (integer 180 + arctangent (s / c))%num end) = s.
Proof.
  intros E S side C. pose proof PI_RGT_0 as P. destruct side; cbn.
  - replace (90 * PI / 180)%R with (PI / 2)%R by field. rewrite sin_PI2. subst. nra.
  - replace ((180 + atan (s / c) * 180 / PI) * PI / 180)%R with (atan (s / c) + PI)%R by (field; lra).
    rewrite neg_sin, sin_atan. assert (R : (sqrt (1 + (s / c)²) = / - c)%R).
    { replace (1 + (s / c)²)%R with ((/ - c) * (/ - c))%R.
      - apply sqrt_square. left. apply Rinv_0_lt_compat. lra.
      - unfold Rsqr. transitivity ((s * s + c * c) / (c * c))%R; [rewrite E|]; field; lra. }
    rewrite R. field. lra.
  - replace (atan (s / c) * 180 / PI * PI / 180)%R with (atan (s / c))%R by (field; lra).
    rewrite sin_atan. assert (R : (sqrt (1 + (s / c)²) = / c)%R).
    { replace (1 + (s / c)²)%R with ((/ c) * (/ c))%R.
      - apply sqrt_square. left. apply Rinv_0_lt_compat. lra.
      - unfold Rsqr. transitivity ((s * s + c * c) / (c * c))%R; [rewrite E|]; field; lra. }
    rewrite R. field. lra.
Qed.

Lemma length_of_unit (a : triple R) : (dot3 a a <> 0)%R -> dot3 (unit3 a) (unit3 a) = 1%R.
Proof.
  intro N. rewrite unit_is_scaled. unfold length3; cbn. set (q := dot3 a a) in *.
  assert (P : (0 < q)%R) by (assert (0 <= q)%R by (unfold q; destruct a as [[x y] z]; unfold dot3; cbn; nra); lra).
  assert (S : (sqrt q * sqrt q = q)%R) by (apply sqrt_sqrt; lra).
  assert (sqrt q <> 0)%R by (intro E; rewrite E in S; lra).
  transitivity (q * / (sqrt q * sqrt q))%R; [|rewrite S; now field].
  unfold q at 1. destruct a as [[x y] z]. unfold scale3, dot3; cbn. field. auto.
Qed.

(** fanuc.tool-posture.great-circle: it starts at the direction of the start and ends at that of the end. *)
Theorem great_circle_from_start_to_end (from to a b : triple R) : dot3 (cross3 from to) (cross3 from to) <> 0%R ->
  on_great_circle 0%R from to = Got a -> on_great_circle 1%R from to = Got b -> a = unit3 from /\ b = unit3 to.
Proof.
  intros N A B.
  assert (LAG : (dot3 (cross3 from to) (cross3 from to) = dot3 from from * dot3 to to - dot3 from to * dot3 from to)%R).
  { destruct from as [[? ?] ?], to as [[? ?] ?]. unfold cross3, dot3; cbn. ring. }
  assert (NF : dot3 from from <> 0%R).
  { intro E. apply N. assert (Z : from = (0, 0, 0)%R); [|subst; destruct to as [[? ?] ?]; unfold cross3, dot3; cbn;
      ring].
    destruct from as [[x y] z]. unfold dot3 in E; cbn in E. assert (x = 0)%R by nra. assert (y = 0)%R by nra.
    assert (z = 0)%R by nra. now subst. }
  assert (NT : dot3 to to <> 0%R).
  { intro E. apply N. assert (Z : to = (0, 0, 0)%R); [|subst; destruct from as [[? ?] ?]; unfold cross3, dot3; cbn;
      ring].
    destruct to as [[x y] z]. unfold dot3 in E; cbn in E. assert (x = 0)%R by nra. assert (y = 0)%R by nra.
    assert (z = 0)%R by nra. now subst. }
  pose proof (length_of_unit from NF) as UF. pose proof (length_of_unit to NT) as UT.
  set (e := unit3 from) in *. set (f := unit3 to) in *.
  assert (SQ : (dot3 (cross3 e f) (cross3 e f) = 1 - dot3 e f * dot3 e f)%R).
  { transitivity (dot3 e e * dot3 f f - dot3 e f * dot3 e f)%R; [|rewrite UF, UT; ring].
    clearbody e f. destruct e as [[? ?] ?], f as [[? ?] ?]. unfold cross3, dot3; cbn. ring. }
  assert (POS : (0 < dot3 (cross3 e f) (cross3 e f))%R).
  { assert (G : cross3 e f = scale3 (/ length3 from * / length3 to)%R (cross3 from to)).
    { unfold e, f. rewrite !unit_is_scaled. generalize (/ length3 from)%R (/ length3 to)%R. intros p q.
      destruct from as [[? ?] ?], to as [[? ?] ?]. unfold cross3, scale3; cbn. f_equal; [f_equal|]; ring. }
    assert (L : forall v : triple R, (dot3 v v <> 0)%R -> length3 v <> 0%R).
    { intros v NV E. unfold length3 in E; cbn in E. apply sqrt_eq_0 in E; [contradiction|]. destruct v as [[x y] z].
      unfold dot3; cbn. nra. }
    assert (K : (/ length3 from * / length3 to <> 0)%R) by (apply Rmult_integral_contrapositive; split;
      apply Rinv_neq_0_compat; auto).
    rewrite G. set (k := (/ length3 from * / length3 to)%R) in *.
    assert (Q : (dot3 (scale3 k (cross3 from to)) (scale3 k (cross3 from to)) = k * k * dot3 (cross3 from to) (cross3
      from to))%R).
    { destruct (cross3 from to) as [[? ?] ?]. unfold scale3, dot3; cbn. ring. }
    rewrite Q. assert (0 <= dot3 (cross3 from to) (cross3 from to))%R by (destruct (cross3 from to) as [[? ?] ?];
      unfold dot3; cbn; nra).
    apply Rmult_lt_0_compat; [apply (Rsqr_pos_lt k K)|lra]. }
  set (s := length3 (cross3 e f)). assert (S : (0 < s)%R) by (unfold s, length3; cbn; now apply sqrt_lt_R0).
  assert (SS : (s * s + dot3 e f * dot3 e f = 1)%R).
  { unfold s, length3; cbn. rewrite sqrt_sqrt by lra. lra. }
  unfold on_great_circle in A, B. fold e f s in A, B.
  apply bound in A as (pa & PA & A). apply zero_sign in PA. destruct pa; [destruct N; now apply PA|].
  apply bound in B as (pb & PB & B). apply zero_sign in PB. destruct pb; [destruct N; now apply PB|].
  apply bound in A as (ha & HA & A). apply zero_sign in HA. destruct ha.
  { exfalso. assert (X : (0 - 1 / 2 = 0)%R) by now apply HA. lra. }
  apply bound in B as (hb & HB & B). apply zero_sign in HB. destruct hb.
  { exfalso. assert (X : (1 - 1 / 2 = 0)%R) by now apply HB. lra. }
  apply bound in A as (side & SA & A). apply decided in SA. apply bound in B as (side' & SB & B). apply decided in SB.
  pose proof (sine_of_arctangent s (dot3 e f) SS S side SA) as TA.
  pose proof (sine_of_arctangent s (dot3 e f) SS S side' SB) as TB.
  apply same in A. apply same in B.
  set (theta := match side with Eq => integer 90 | Gt => arctangent (s / dot3 e f)%num |
    Lt => (integer 180 + arctangent (s / dot3 e f))%num end) in *.
  set (theta' := match side' with Eq => integer 90 | Gt => arctangent (s / dot3 e f)%num |
    Lt => (integer 180 + arctangent (s / dot3 e f))%num end) in *.
  assert (ONE : forall x, sine (1 * x)%R = sine x) by (intro; f_equal; ring).
  assert (ZERO : forall x, sine (0 * x)%R = 0%R) by (intro; cbn; replace (0 * x * PI / 180)%R with 0%R by (unfold Rdiv;
    ring); apply sin_0).
  assert (E10 : (1 - 0%R)%num = 1%R) by (cbn; ring). assert (E11 : (1 - 1%R)%num = 0%R) by (cbn; ring).
  split.
  - rewrite <- A. change ((1 - 0%R) * theta)%num with ((1 - 0%R)%num * theta)%R.
    change (0%R * theta)%num with (0 * theta)%R. rewrite E10, ONE, ZERO, TA.
    assert (SN : s <> 0%R) by lra. clear - SN. clearbody s. clearbody e f. destruct e as [[x y] z], f as [[x' y'] z'].
    unfold add3, scale3; cbn. f_equal; [f_equal|]; field; exact SN.
  - rewrite <- B. change ((1 - 1%R) * theta')%num with ((1 - 1%R)%num * theta')%R.
    change (1%R * theta')%num with (1 * theta')%R. rewrite E11, ZERO, ONE, TB.
    assert (SN : s <> 0%R) by lra. clear - SN. clearbody s. clearbody e f. destruct e as [[x y] z], f as [[x' y'] z'].
    unfold add3, scale3; cbn. f_equal; [f_equal|]; field; exact SN.
Qed.

Example great_circle_from_start_to_end_instance a b : on_great_circle 0%R (1, 0, 0)%R (0, 0, 1)%R = Got a ->
  on_great_circle 1%R (1, 0, 0)%R (0, 0, 1)%R = Got b -> a = unit3 (1, 0, 0)%R /\ b = unit3 (0, 0, 1)%R.
Proof. apply great_circle_from_start_to_end. unfold dot3, cross3; cbn. lra. Qed.
