(** What the generated proofs of golden vectors rest on: the shapes of their statements, and how each is proved. *)
From Coq Require Import Reals Lra List.
From Interval Require Import Tactic.
From Toolcomp Require Import Vectors LeadingEdgeOffset ToolLengthOffset ToolDirection.
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
