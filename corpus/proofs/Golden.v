(** What the generated proofs of golden vectors rest on: the shapes of their statements, and how each is proved. *)
From Coq Require Import Reals Lra List.
From Interval Require Import Tactic.
From Toolcomp Require Import Vectors LeadingEdgeOffset ToolLengthOffset ToolDirection.
From Toolcomp Require CutterCompensationC.
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
