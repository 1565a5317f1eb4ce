(** What the generated proofs of golden vectors rest on: the shapes of their statements, and how each is proved. *)
From Coq Require Import Reals Lra List.
From Interval Require Import Tactic.
From Toolcomp Require Import Vectors LeadingEdgeOffset ToolLengthOffset ToolDirection.
From Toolcomp Require CutterCompensationC FaceMilling PeripheralMilling ProgrammedContour.
Import ListNotations.
Open Scope R_scope.

(** * Numbers *)

Definition degrees a := a * PI / 180.

(** The recorded decimal [v] is right to within [r]. *)
Definition recorded x v r := Rabs (x - v) <= r.

Lemma norm_is u m : 0 <= m -> dot u u = m * m -> norm u = m.
Proof. intros H E; unfold norm; rewrite E; apply sqrt_square, H. Qed.

Ltac expand :=
  unfold recorded, VC, V, norm, scale, cross, dot, degrees, Rsqr in *; cbn [vx vy vz] in *.

(** A tool direction from rotary axes, in components. *)
Ltac directions := cbv zeta; rotation; cbn [vx vy vz ex ey ez].

(** By intervals of 90 bits: twenty more than the recorded decimals need. *)
Ltac by_intervals := expand; interval with (i_prec 90).

(** By computation over Q, where the length [m] of V is rational. *)
Ltac by_computation m :=
  unfold VC; rewrite (norm_is _ m) by (expand; lra); unfold V, scale, cross; cbn [vx vy vz]; lra.

(** A component that vanishes whatever the length of V is; or all of them, for the offset value 0. *)
Ltac by_zero :=
  first
    [ rewrite VC_offset_zero; cbn [vx vy vz zero]; lra
    | unfold VC, scale; cbn [vx vy vz];
      match goal with |- context [?k * ?component (V ?a ?b)] =>
        replace (component (V a b)) with 0 by (unfold V, cross; cbn [vx vy vz]; lra) end; lra ].

(** * Leading edge offset *)

Lemma is_oblique_forward delta VM VT :
  0 < dot VM VT -> (dot VM VT)² < (cos delta)² * (dot VM VM * dot VT VT) ->
  (sin delta)² * (dot VM VM * dot VT VT) < (dot VM VT)² -> classify delta VM VT = oblique /\ sense VM VT = 1.
Proof.
  intros A B C; unfold classify, sense; split.
  - destruct Rlt_dec; [| lra]. destruct Rle_dec; [lra |]. destruct Rle_dec; [lra | reflexivity].
  - destruct Rlt_dec; [lra | reflexivity].
Qed.

Lemma is_oblique_back delta VM VT :
  dot VM VT < 0 -> (dot VM VT)² < (cos delta)² * (dot VM VM * dot VT VT) ->
  (sin delta)² * (dot VM VM * dot VT VT) < (dot VM VT)² -> classify delta VM VT = oblique /\ sense VM VT = -1.
Proof.
  intros A B C; unfold classify, sense; split.
  - destruct Rlt_dec; [lra |]. destruct Rlt_dec; [| lra]. destruct Rle_dec; [lra |]. destruct Rle_dec; [lra | reflexivity].
  - destruct Rlt_dec; [reflexivity | lra].
Qed.

Lemma is_along delta VM VT :
  0 < dot VM VT -> (cos delta)² * (dot VM VM * dot VT VT) <= (dot VM VT)² -> classify delta VM VT = along.
Proof. intros A B; unfold classify. destruct Rlt_dec; [| lra]. destruct Rle_dec; [reflexivity | lra]. Qed.

Lemma is_against delta VM VT :
  dot VM VT < 0 -> (cos delta)² * (dot VM VM * dot VT VT) <= (dot VM VT)² -> classify delta VM VT = against.
Proof.
  intros A B; unfold classify. destruct Rlt_dec; [lra |]. destruct Rlt_dec; [| lra]. destruct Rle_dec; [reflexivity | lra].
Qed.

Lemma is_square_near delta VM VT :
  (dot VM VT)² < (cos delta)² * (dot VM VM * dot VT VT) ->
  (dot VM VT)² <= (sin delta)² * (dot VM VM * dot VT VT) -> classify delta VM VT = square.
Proof.
  intros B C; unfold classify. destruct Rlt_dec; [| destruct Rlt_dec; [| reflexivity]];
    (destruct Rle_dec; [lra |]); (destruct Rle_dec; [reflexivity | lra]).
Qed.

Lemma is_square_exactly delta VM VT : dot VM VT = 0 -> classify delta VM VT = square.
Proof. intro E; unfold classify; rewrite E. destruct (Rlt_dec 0 0); [lra | reflexivity]. Qed.

(** * Tool length offset *)

(** Where the axes X Y Z are sent after each group of blocks. *)
Fixpoint targets s groups :=
  match groups with
  | [] => []
  | g :: rest => let s' := run g s in (target s' X, target s' Y, target s' Z) :: targets s' rest
  end.

Definition at_rest x y z :=
  State (fun a => match a with X => x | Y => y | Z => z end) (fun _ => 0) None.

Lemma cons_equal (a b : R * R * R) l m : a = b -> l = m -> a :: l = b :: m.
Proof. intros; subst; reflexivity. Qed.

Lemma place_equal (x y z u v w : R) : x = u -> y = v -> z = w -> (x, y, z) = (u, v, w).
Proof. intros; subst; reflexivity. Qed.

(** The positions are sums of the program's own decimals. *)
Ltac by_sums :=
  cbn; unfold target, set; cbn; repeat (apply cons_equal; [apply place_equal; lra |]); reflexivity.

(** * Cutter compensation C *)

Definition unit u := scale (/ norm u) u.

(** The group between two lines that go along [a] and [b], of any length. *)
Definition corner rho a b := CutterCompensationC.group rho (unit a) (unit b).

Lemma norm_inverse u : 0 < dot u u -> 0 < / norm u.
Proof. intro H; apply Rinv_0_lt_compat, sqrt_lt_R0, H. Qed.

Lemma turn_unit a b :
  CutterCompensationC.turn (unit a) (unit b) = / norm a * / norm b * CutterCompensationC.turn a b.
Proof. unfold CutterCompensationC.turn, unit, scale; cbn [vx vy vz]; ring. Qed.

Lemma dot_unit a b : dot (unit a) (unit b) = / norm a * / norm b * dot a b.
Proof. unfold unit; rewrite dot_scale_l, dot_scale_r; ring. Qed.

Lemma corner_meets rho a b : 0 < dot a a -> 0 < dot b b ->
  0 < rho * CutterCompensationC.turn a b \/ 0 <= dot a b ->
  corner rho a b = [CutterCompensationC.M rho (unit a) (unit b)].
Proof.
  intros A B H; unfold corner, CutterCompensationC.group.
  pose proof (Rmult_lt_0_compat _ _ (norm_inverse a A) (norm_inverse b B)) as P.
  rewrite turn_unit, dot_unit. destruct Rlt_dec as [T | T]; [reflexivity |].
  destruct Rle_dec as [D | D]; [reflexivity | exfalso].
  destruct H as [H | H].
  - apply T. rewrite <- Rmult_assoc, (Rmult_comm rho), Rmult_assoc. apply Rmult_lt_0_compat; auto.
  - apply D, Rmult_le_pos; lra.
Qed.

Lemma corner_acute rho a b : 0 < dot a a -> 0 < dot b b ->
  rho * CutterCompensationC.turn a b <= 0 -> dot a b < 0 ->
  corner rho a b = [CutterCompensationC.Q1 rho (unit a); CutterCompensationC.Q2 rho (unit b)].
Proof.
  intros A B H K; unfold corner, CutterCompensationC.group.
  pose proof (Rmult_lt_0_compat _ _ (norm_inverse a A) (norm_inverse b B)) as P.
  rewrite turn_unit, dot_unit. destruct Rlt_dec as [T | T].
  - exfalso. rewrite <- Rmult_assoc, (Rmult_comm rho), Rmult_assoc in T.
    assert (0 <= / norm a * / norm b * - (rho * CutterCompensationC.turn a b)) by (apply Rmult_le_pos; lra). lra.
  - destruct Rle_dec as [D | D]; [exfalso | reflexivity].
    assert (0 < / norm a * / norm b * - dot a b) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Ltac vectors :=
  unfold CutterCompensationC.M, CutterCompensationC.Q1, CutterCompensationC.Q2, CutterCompensationC.perpendicular,
    CutterCompensationC.left, unit, sub, opp, add, scale; cbn [vx vy vz].

(** The class of a corner, by signs of rational numbers. *)
Ltac by_signs := unfold CutterCompensationC.turn, dot; cbn [vx vy vz]; lra.
Ltac meets := apply corner_meets; [by_signs | by_signs | first [left; by_signs | right; by_signs]].
Ltac acute := apply corner_acute; by_signs.

(** A head whose blocks have the rational lengths [m] and [n]; or by intervals. *)
Ltac by_lengths a m b n :=
  vectors; rewrite ?(norm_is a m), ?(norm_is b n) by (unfold dot; cbn [vx vy vz]; lra);
  unfold dot; cbn [vx vy vz]; rewrite ?(Rabs_right _), ?(Rabs_left _) by lra; field; lra.
Ltac head_by_intervals :=
  unfold recorded; vectors; unfold norm, dot; cbn [vx vy vz]; interval with (i_prec 90).

(** * Tool offset, tool length measurement, cutter compensation B *)
From Toolcomp Require ToolOffset ToolLengthMeasurement CutterCompensationB.

Ltac magnitude := first [rewrite Rabs_R0 | rewrite Rabs_right by lra | rewrite Rabs_left by lra | idtac].

(** One block on one axis. *)
Ltac by_offset_step :=
  unfold ToolOffset.step, ToolOffset.sense, ToolOffset.travel, ToolOffset.lengthening;
  cbn [ToolOffset.programmed ToolOffset.actual];
  repeat (destruct Rlt_dec; try lra); magnitude; f_equal; lra.

(** The outcome of a measurement, and the value written. *)
Ltac by_measuring :=
  unfold ToolLengthMeasurement.measure, ToolLengthMeasurement.touched, ToolLengthMeasurement.measuring_start,
    ToolLengthMeasurement.sense;
  magnitude; repeat (destruct Rlt_dec; try lra); repeat (destruct Rle_dec; try lra); f_equal; lra.
Ltac by_adding := unfold ToolLengthMeasurement.measured; lra.

(** A vector of type B, where the length [m] of its direction is rational, and where it is not. *)
Ltac in_components := unfold norm, scale, dot, CutterCompensationB.left; cbn [vx vy vz].
Ltac by_length m :=
  unfold CutterCompensationB.side_offset, CutterCompensationB.V; rewrite (norm_is _ m) by (in_components; lra);
  in_components; lra.
Ltac by_root :=
  unfold recorded, CutterCompensationB.side_offset, CutterCompensationB.V; in_components; interval with (i_prec 90).

(** * Tool side compensation *)
From Toolcomp Require ToolSideCompensation.

Section ToolSide.
Import ToolSideCompensation.

Lemma across_the_tool VT U : 0 < dot (cross VT U) (cross VT U) -> ~ parallel VT U.
Proof. intros H E. unfold parallel in E. rewrite E in H. unfold dot, zero in H; cbn in H; lra. Qed.

Lemma norm_positive u : 0 < dot u u -> 0 < norm u.
Proof. intro H; apply sqrt_lt_R0, H. Qed.

Lemma d_closed VT U : 0 < dot (cross VT U) (cross VT U) ->
  d VT U = scale (norm VT / norm (cross VT U)) (across VT U).
Proof.
  intro H. pose proof (across_the_tool VT U H) as N. pose proof (tool_nonzero VT U N) as T.
  pose proof (norm_pos _ T). pose proof (norm_pos _ (across_nonzero VT U N)).
  unfold d, unit. rewrite cross_norm by auto. f_equal. field; lra.
Qed.

Lemma K1_closed r s VT U : 0 < dot (cross VT U) (cross VT U) ->
  K1 r s VT U = scale r (add (n s VT U) (scale (norm VT / norm (cross VT U)) (across VT U))).
Proof. intro H. unfold K1. rewrite d_closed by auto. reflexivity. Qed.

Lemma K2_closed r s VT U : 0 < dot (cross VT U) (cross VT U) ->
  K2 r s VT U = scale r (sub (n s VT U) (scale (norm VT / norm (cross VT U)) (across VT U))).
Proof. intro H. unfold K2. rewrite d_closed by auto. reflexivity. Qed.

Lemma Vi_closed r s VT a b : 0 < dot (cross VT a) (cross VT a) -> 0 < dot (cross VT b) (cross VT b) ->
  Vi r s VT a b =
  scale (r / (1 + dot (cross VT a) (cross VT b) / (norm (cross VT a) * norm (cross VT b)))) (add (n s VT a) (n s VT b)).
Proof.
  intros A B. pose proof (tool_nonzero VT a (across_the_tool VT a A)) as T.
  pose proof (norm_positive _ A). pose proof (norm_positive _ B).
  unfold Vi. f_equal. f_equal. f_equal. pose proof (cosine_C VT a b T) as E. unfold C in E. rewrite E. field; lra.
Qed.

(** The same in coordinates, without a division, where the lengths are rational: [m] and [k] of VT x a and VT x b, [l] of
    VT. *)
Lemma Vi_coordinates r s x y z ax ay az bx by_ bz m k w :
  let p := y * az - z * ay in let q := z * ax - x * az in let o := x * ay - y * ax in
  let p' := y * bz - z * by_ in let q' := z * bx - x * bz in let o' := x * by_ - y * bx in
  0 < m -> 0 < k -> p * p + q * q + o * o = m * m -> p' * p' + q' * q' + o' * o' = k * k ->
  0 < m * k + (p * p' + q * q' + o * o') -> w * (m * k + (p * p' + q * q' + o * o')) = r ->
  Vi r s (Vec x y z) (Vec ax ay az) (Vec bx by_ bz) =
  Vec (w * s * (k * p + m * p')) (w * s * (k * q + m * q')) (w * s * (k * o + m * o')).
Proof.
  intros p q o p' q' o' M K A B P W.
  assert (A' : dot (cross (Vec x y z) (Vec ax ay az)) (cross (Vec x y z) (Vec ax ay az)) = m * m) by exact A.
  assert (B' : dot (cross (Vec x y z) (Vec bx by_ bz)) (cross (Vec x y z) (Vec bx by_ bz)) = k * k) by exact B.
  rewrite Vi_closed by (rewrite ?A', ?B'; apply Rmult_lt_0_compat; auto).
  unfold n. rewrite (norm_is _ m), (norm_is _ k) by (auto; lra). rewrite <- W.
  unfold scale, add, dot, cross; cbn [vx vy vz]. fold p q o p' q' o'. clearbody p q o p' q' o'.
  f_equal; field; lra.
Qed.

(** [h] is 1 for K1, -1 for K2. *)
Lemma K_coordinates r s h x y z ax ay az m l j :
  let p := y * az - z * ay in let q := z * ax - x * az in let o := x * ay - y * ax in let e := ax * x + ay * y + az * z in
  0 < m -> 0 < l -> p * p + q * q + o * o = m * m -> x * x + y * y + z * z = l * l -> j * (m * l) = 1 ->
  scale r (add (n s (Vec x y z) (Vec ax ay az)) (scale h (d (Vec x y z) (Vec ax ay az)))) =
  Vec (r * j * (s * l * p + h * (l * l * ax - e * x))) (r * j * (s * l * q + h * (l * l * ay - e * y)))
      (r * j * (s * l * o + h * (l * l * az - e * z))).
Proof.
  intros p q o e M L A B J.
  assert (A' : dot (cross (Vec x y z) (Vec ax ay az)) (cross (Vec x y z) (Vec ax ay az)) = m * m) by exact A.
  assert (B' : dot (Vec x y z) (Vec x y z) = l * l) by exact B.
  rewrite d_closed by (rewrite A'; apply Rmult_lt_0_compat; auto).
  unfold n, across. rewrite (norm_is _ m), (norm_is _ l), B' by (auto; lra).
  replace j with (/ (m * l)) by (rewrite <- (Rmult_1_l (/ _)), <- J; field; lra).
  unfold sub, opp, scale, add, dot, cross; cbn [vx vy vz]. fold p q o e. clearbody p q o e. f_equal; field; lra.
Qed.

Lemma K1_is r s VT U : K1 r s VT U = scale r (add (n s VT U) (scale 1 (d VT U))).
Proof. unfold K1. rewrite scale_one. reflexivity. Qed.
Lemma K2_is r s VT U : K2 r s VT U = scale r (add (n s VT U) (scale (-1) (d VT U))).
Proof. reflexivity. Qed.

Lemma group_inner r s VT a b : 0 < S s VT a b -> group r s VT a b = [Vi r s VT a b].
Proof. intro H; unfold group; destruct Rlt_dec; [reflexivity | lra]. Qed.

Lemma group_obtuse r s VT a b : 0 <= C VT a b -> group r s VT a b = [Vi r s VT a b].
Proof. intro H; unfold group; destruct Rlt_dec; [reflexivity |]. destruct Rle_dec; [reflexivity | lra]. Qed.

Lemma group_acute r s VT a b : S s VT a b <= 0 -> C VT a b < 0 -> group r s VT a b = [K1 r s VT a; K2 r s VT b].
Proof. intros A B; unfold group; destruct Rlt_dec; [lra |]. destruct Rle_dec; [lra | reflexivity]. Qed.
End ToolSide.

(** Signs: by rational numbers, or by intervals where the tool direction comes from rotary axes. *)
Ltac side_sign :=
  unfold ToolSideCompensation.S, ToolSideCompensation.C, dot, cross; cbn [vx vy vz];
  first [lra | interval with (i_prec 90)].
Ltac side_inner := apply group_inner; side_sign.
Ltac side_obtuse := apply group_obtuse; side_sign.
Ltac side_acute := apply group_acute; side_sign.

(** The components of a tool direction from rotary axes are enclosed once, and are numbers from then on. *)
Ltac side_enclosed x :=
  let B := fresh "B" in let n := fresh "t" in interval_intro x with (i_prec 110) as B; set (n := x) in *; clearbody n.
Ltac side_tool :=
  directions; unfold degrees;
  match goal with |- context [ToolSideCompensation.group _ _ (Vec ?x ?y ?z) _ _] =>
    side_enclosed x; side_enclosed y; side_enclosed z end.

Ltac side_closed := rewrite ?Vi_closed, ?K1_closed, ?K2_closed by side_sign; unfold ToolSideCompensation.n.
Ltac side_expand :=
  unfold recorded, ToolSideCompensation.across, sub, opp, add, scale, cross, dot; cbn [vx vy vz].

(** The lengths are enclosed once, too. *)
Ltac side_length u :=
  let e := eval unfold norm, dot, cross in (norm u) in
  let e := eval cbn [vx vy vz] in e in
  let B := fresh "B" in let m := fresh "m" in
  interval_intro e with (i_prec 110) as B; change e with (norm u) in B; set (m := norm u) in *; clearbody m.
Ltac side_by_intervals :=
  side_closed; repeat match goal with |- context [norm ?u] => side_length u end;
  repeat split; side_expand; interval with (i_prec 90).

(** With rational lengths; [w], [i] and [j] are what the lemmas above ask for. *)
Ltac side_meets m k w :=
  match goal with |- context [ToolSideCompensation.Vi ?r ?s (Vec ?x ?y ?z) (Vec ?a ?b ?c) (Vec ?d ?e ?f)] =>
    rewrite (Vi_coordinates r s x y z a b c d e f m k w) by (cbv zeta; lra) end;
  cbn [vx vy vz]; repeat split; lra.
Ltac side_passes m k l i j :=
  rewrite K1_is, K2_is;
  match goal with |- context [scale ?r (add (ToolSideCompensation.n ?s (Vec ?x ?y ?z) (Vec ?a ?b ?c)) (scale 1 _))] =>
    rewrite (K_coordinates r s 1 x y z a b c m l i) by (cbv zeta; lra) end;
  match goal with |- context [scale ?r (add (ToolSideCompensation.n ?s (Vec ?x ?y ?z) (Vec ?a ?b ?c)) (scale (-1) _))] =>
    rewrite (K_coordinates r s (-1) x y z a b c k l j) by (cbv zeta; lra) end;
  cbn [vx vy vz]; repeat split; lra.

(** * Tool center point control, tool posture control *)
From Toolcomp Require ToolCenterPointControl ToolPostureControl.

(** What is computed from recorded decimals is right to within [e]. *)
Definition within e x y := Rabs (x - y) <= e.
Definition within_vec e u v := within e (vx u) (vx v) /\ within e (vy u) (vy v) /\ within e (vz u) (vz v).

(** The recorded tool axis [v] is the unit vector along [w]. *)
Definition axis_along e w v := within_vec e (cross w v) zero /\ 0 < dot w v /\ within (4 / 10 ^ 15) (dot v v) 1.

Ltac in_coordinates :=
  unfold axis_along, within_vec, within, ToolCenterPointControl.head_control_point, dot, cross, add, scale, zero;
  cbn [vx vy vz].
Ltac by_decimals :=
  cbv zeta; in_coordinates; repeat split; first [lra | apply Rabs_le; split; lra].

(** The direction of recorded rotary positions. *)
Ltac by_forward :=
  unfold ToolCenterPointControl.V; rewrite ?rotate_about_x, ?rotate_about_y, ?rotate_about_z;
  unfold within_vec, within, degrees, ex, ey, ez; cbn [vx vy vz]; repeat split; interval with (i_prec 90).

(** The direction half way between two, of any length. *)
Lemma half_way_between a b : 0 < dot (cross a b) (cross a b) ->
  ToolPostureControl.great_circle (unit a) (unit b) (1/2) =
  scale (/ norm (add (unit a) (unit b))) (add (unit a) (unit b)).
Proof.
  intro H.
  assert (N : cross a b <> zero) by (intro E; rewrite E in H; unfold dot, zero in H; cbn in H; lra).
  assert (A : a <> zero) by (intro E; apply N; rewrite E; vec_ring).
  assert (B : b <> zero) by (intro E; apply N; rewrite E; vec_ring).
  pose proof (norm_pos a A) as Pa. pose proof (norm_pos b B) as Pb.
  assert (U : forall w, w <> zero -> dot (unit w) (unit w) = 1).
  { intros w W. pose proof (norm_pos w W). rewrite dot_unit, <- norm_sqr. field; lra. }
  apply ToolPostureControl.half_way; [apply U, A | apply U, B |].
  intro E. unfold parallel in E. apply N.
  assert (X : cross a b = scale (norm a * norm b) (cross (unit a) (unit b))).
  { unfold unit. replace (cross (scale (/ norm a) a) (scale (/ norm b) b))
      with (scale (/ norm a * / norm b) (cross a b)) by (set (x := / norm a); set (y := / norm b); vec_ring).
    rewrite scale_scale. replace (norm a * norm b * (/ norm a * / norm b)) with 1 by (field; lra).
    symmetry; apply scale_one. }
  rewrite X, E. apply scale_zero_r.
Qed.

Ltac by_half_way :=
  rewrite half_way_between by (unfold dot, cross; cbn [vx vy vz]; lra);
  unfold within_vec, within, unit, add, scale, norm, dot; cbn [vx vy vz]; repeat split; interval with (i_prec 90).

(** * 3D tool compensation of Heidenhain controls *)

(** The unit vector where the length is rational. *)
Lemma space_unit v m : 0 < m -> dot v v = m * m -> FaceMilling.unit v = scale (/ m) v.
Proof. intros P E. unfold FaceMilling.unit. rewrite (norm_is v m) by lra. reflexivity. Qed.

Lemma space_flat_across N T : dot T T * dot (cross N T) (cross N T) = 0 ->
  FaceMilling.u N T = zero.
Proof.
  intro E. unfold FaceMilling.u. rewrite <- FaceMilling.w_squared in E. apply dot_self_zero in E. rewrite E.
  apply FaceMilling.unit_zero.
Qed.

Lemma space_mitre delta c1 c2 k : 1 + dot c1 c2 = k -> PeripheralMilling.mitre delta c1 c2 = scale (delta / k) (add c1 c2).
Proof. intro E. unfold PeripheralMilling.mitre. rewrite E. reflexivity. Qed.

Ltac space_open :=
  cbv zeta;
  unfold ProgrammedContour.contour_tip, FaceMilling.effective_tip, FaceMilling.tip, FaceMilling.contact,
    FaceMilling.nominal_tip, FaceMilling.ring, FaceMilling.effective_ring;
  cbn [FaceMilling.radius FaceMilling.corner FaceMilling.dL FaceMilling.dR FaceMilling.dR2];
  try first [rewrite Rmax_right by lra | rewrite Rmax_left by lra].
Ltac space_components :=
  unfold FaceMilling.u, FaceMilling.w; cbn [vx vy vz add sub opp scale cross];
  unfold norm, dot; cbn [vx vy vz add sub opp scale cross].
Ltac space_side := unfold FaceMilling.w, dot; cbn [vx vy vz add sub opp scale cross]; unfold dot; cbn [vx vy vz]; lra.

(** Where the lengths [n] of the normal, [t] of the tool vector and [k] of the vector across are rational; [k] does not
    matter where there is no flat. *)
Ltac space_units n t :=
  match goal with |- context [FaceMilling.unit (Vec ?a ?b ?c)] =>
    first [rewrite !(space_unit (Vec a b c) n) by space_side | rewrite !(space_unit (Vec a b c) t) by space_side] end.
Ltac space_computed n t k :=
  space_open; repeat space_units n t;
  match goal with |- context [FaceMilling.u ?N ?T] =>
    first [unfold FaceMilling.u; rewrite !(space_unit (FaceMilling.w N T) k) by space_side
          | generalize (FaceMilling.u N T); intros [? ? ?]] end;
  space_components; repeat split; lra.
Ltac space_flat n t :=
  space_open; repeat space_units n t; rewrite !space_flat_across by space_side;
  unfold zero; space_components; repeat split; lra.

(** Otherwise by intervals, near a reversal finer ones; components that are exact by computation whatever the lengths that
    are not 1. *)
Ltac space_of_units := repeat match goal with |- context [sqrt ?x] => replace x with 1 by lra; rewrite sqrt_1 end; lra.
Ltac space_enclosed :=
  unfold PeripheralMilling.mitre, PeripheralMilling.c, FaceMilling.u; unfold FaceMilling.unit, recorded, zero;
  space_components; repeat split; 
    first [lra | space_of_units | interval with (i_prec 90) | interval with (i_prec 200)].
Ltac space_by_intervals := space_open; space_enclosed.
Ltac space_flat_by_intervals := space_open; rewrite !space_flat_across by space_side; space_enclosed.

(** Under RL and RR: [t] the length of the tool vector, [a] and [b] those of its products with the movements. *)
Ltac flank_units a b :=
  match goal with |- context [FaceMilling.unit (cross ?T ?d)] =>
    first [rewrite !(space_unit (cross T d) a) by space_side | rewrite !(space_unit (cross T d) b) by space_side] end.
Ltac flank_computed t a b :=
  space_open; unfold PeripheralMilling.c; repeat flank_units a b; repeat space_units t t;
  unfold PeripheralMilling.mitre; space_components; repeat split; lra.
