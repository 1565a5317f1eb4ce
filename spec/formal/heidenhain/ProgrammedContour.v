(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/programmed-contour: the programmed coordinates as those of the contour, and that this is the same
    compensation as that of the tool path.

    Letters as in FaceMilling.v. *)
From Coq Require Import Reals Lra Psatz.
From Toolcomp Require Import Vectors FaceMilling PeripheralMilling.
Open Scope R_scope.

(** * Definitions *)

(** The tip of the effective tool under PROG PATH IS CONTOUR: the programmed point is where it touches. *)
Definition contour_tip k d q N T := tip q N T (corner k + dR2 d) (effective_ring k d).

(** The programmed point of the nominal tool that touches [q]: its tip or its centre. *)
Definition nominal_point r k q N T :=
  match r with
  | TIP => tip q N T (corner k) (ring k)
  | CNT => center (tip q N T (corner k) (ring k)) T (corner k)
  end.

(** * Theorems *)

(** heidenhain.contour.same-as-off: the contour point q is the same as the nominal tool's tip, or centre, where that touches
    q, without IS CONTOUR. *)
Theorem contour_is_off_at_the_nominal_tool r k d q N T :
  contour_tip k d q N T = effective_tip r k d (nominal_point r k q N T) N T.
Proof.
  unfold contour_tip, effective_tip. f_equal. destruct r; cbn [nominal_tip nominal_point].
  - symmetry. apply contact_of_tip.
  - rewrite <- (contact_of_tip q N T (corner k) (ring k)) at 1. f_equal.
    unfold center. set (p := tip q N T (corner k) (ring k)); set (t := unit T). clearbody p t. vec_ring.
Qed.

Example contour_is_off_at_the_nominal_tool_instance q :
  contour_tip (Tool 5 2) (Deltas (1/4) (3/10) (1/10)) q (Vec (3/5) 0 (4/5)) (Vec 0 0 1) =
  effective_tip CNT (Tool 5 2) (Deltas (1/4) (3/10) (1/10))
    (nominal_point CNT (Tool 5 2) q (Vec (3/5) 0 (4/5)) (Vec 0 0 1)) (Vec (3/5) 0 (4/5)) (Vec 0 0 1).
Proof. apply contour_is_off_at_the_nominal_tool. Qed.

(** heidenhain.contour.same-as-off: those points, in the terms of the tool path. *)
Theorem nominal_points k q N T :
  nominal_point TIP k q N T =
    sub (add q (add (scale (corner k) (unit N)) (scale (ring k) (u N T)))) (scale (corner k) (unit T)) /\
  nominal_point CNT k q N T = add q (add (scale (corner k) (unit N)) (scale (ring k) (u N T))).
Proof.
  cbn [nominal_point]. unfold center, tip. set (n := unit N); set (t := unit T); set (x := u N T).
  clearbody n t x. split; vec_ring.
Qed.

Example nominal_points_instance q :
  nominal_point CNT (Tool 3 3) q (Vec 3 0 4) (Vec 0 0 1) =
  add q (add (scale 3 (unit (Vec 3 0 4))) (scale (ring (Tool 3 3)) (u (Vec 3 0 4) (Vec 0 0 1)))).
Proof. exact (proj2 (nominal_points (Tool 3 3) q _ _)). Qed.

(** heidenhain.contour.shift: the shift means the same in both modes: from the tip of the nominal tool at the same
    contact. *)
Theorem shift_of_contour k d q N T :
  sub (contour_tip k d q N T) (tip q N T (corner k) (ring k)) = D_tip k d N T.
Proof.
  rewrite (contour_is_off_at_the_nominal_tool TIP), tip_moves_by_D_tip. cbn [nominal_tip nominal_point].
  set (p := tip q N T (corner k) (ring k)); set (x := D_tip k d N T). clearbody p x. vec_ring.
Qed.

Example shift_of_contour_instance q :
  sub (contour_tip (Tool 6 1) (Deltas 0 0 (1/5)) q (Vec 3 0 4) (Vec 0 0 1)) (tip q (Vec 3 0 4) (Vec 0 0 1) 1 (6 - 1)) =
  D_tip (Tool 6 1) (Deltas 0 0 (1/5)) (Vec 3 0 4) (Vec 0 0 1).
Proof. exact (shift_of_contour (Tool 6 1) (Deltas 0 0 (1/5)) q _ _). Qed.

(** heidenhain.contour.face: the effective tool touches the plane through the programmed point with the programmed normal,
    and cuts nothing beyond it. *)
Theorem contour_is_touched k d q e f h N T : N <> zero -> T <> zero -> 0 <= corner k + dR2 d ->
  0 <= dot (unit N) (unit T) -> dot e (unit T) = 0 -> dot e e <= (effective_ring k d)² ->
  dot f f <= (corner k + dR2 d)² -> 0 <= h ->
  0 <= dot (sub (add (add (center (contour_tip k d q N T) T (corner k + dR2 d)) (add e f)) (scale h (unit T))) q)
         (unit N).
Proof.
  intros. apply effective_tool_touches_the_plane; auto. unfold effective_ring. apply Rmax_l.
Qed.

Example contour_is_touched_instance q :
  0 <= dot (sub (add (add (center (contour_tip (Tool 3 3) (Deltas 0 0 0) q (Vec (3/5) 0 (4/5)) (Vec 0 0 1)) (Vec 0 0 1)
    (3 + 0)) (add zero (Vec 1 2 1))) (scale 7 (unit (Vec 0 0 1)))) q) (unit (Vec (3/5) 0 (4/5))).
Proof.
  apply (contour_is_touched (Tool 3 3) (Deltas 0 0 0)); try apply XZ_nonzero; try apply Z_nonzero; cbn [corner dR2];
    rewrite ?(unit_of_unit _ norm_XZ), ?(unit_of_unit _ norm_Z); unfold dot, Rsqr; cbn; try lra.
  unfold effective_ring; cbn. rewrite Rmax_left by lra. lra.
Qed.

(** heidenhain.contour.face: where the normal is along the tool the tip stands on the programmed point. *)
Theorem contour_along_the_normal k d q N T b : 0 < b -> N <> zero -> T = scale b N -> contour_tip k d q N T = q.
Proof.
  intros B HN E.
  assert (HT : T <> zero).
  { intro Z. apply HN. rewrite <- (scale_one N), <- (Rinv_l b), <- scale_scale, <- E, Z by lra. apply scale_zero_r. }
  assert (U : u N T = zero) by (apply u_along_the_tool; auto; subst T; unfold parallel; vec_ring).
  unfold contour_tip, tip. rewrite U, E, unit_scale_any by auto. set (n := unit N); clearbody n.
  set (r := corner k + dR2 d); set (e := effective_ring k d). clearbody r e. vec_ring.
Qed.

Example contour_along_the_normal_instance q :
  contour_tip (Tool 6 1) (Deltas 0 (-1/10) (-1/50)) q (Vec (3/5) 0 (4/5)) (scale 2 (Vec (3/5) 0 (4/5))) = q.
Proof. apply (contour_along_the_normal _ _ _ _ _ 2); [lra | apply XZ_nonzero | reflexivity]. Qed.

(** heidenhain.contour.flank: at right angles to the tool the axis is by the effective radius away from the contour: by
    normal the same as by RL and RR with the full radius. *)
Theorem contour_of_the_flank k d q N T : N <> zero -> T <> zero -> dot N T = 0 -> corner k + dR2 d <= radius k + dR d ->
  center (contour_tip k d q N T) T (corner k + dR2 d) = add q (scale (radius k + dR d) (unit N)).
Proof.
  intros HN HT E H. unfold center, contour_tip, tip. rewrite u_of_right_angle by auto.
  unfold effective_ring. rewrite Rmax_right by lra.
  set (n := unit N); set (t := unit T). clearbody n t. vec_ring.
Qed.

Example contour_of_the_flank_instance q :
  center (contour_tip (Tool 6 0) (Deltas 0 (-1/10) 0) q (Vec (3/5) 0 (4/5)) (Vec 0 1 0)) (Vec 0 1 0) (0 + 0) =
  add q (scale (6 + -1/10) (unit (Vec (3/5) 0 (4/5)))).
Proof.
  apply (contour_of_the_flank (Tool 6 0) (Deltas 0 (-1/10) 0)); [apply XZ_nonzero | | unfold dot; cbn; lra | cbn; lra].
  intro E; injection E; intros; lra.
Qed.

(** heidenhain.contour.flank: between two compensated blocks the full radius is the delta of RL and RR: both modes differ by
    the nominal radius in the direction of the mitre. *)
Theorem full_radius_of_the_mitre r d0 c1 c2 : mitre (r + d0) c1 c2 = add (mitre r c1 c2) (mitre d0 c1 c2).
Proof. unfold mitre, Rdiv. rewrite Rmult_plus_distr_r. set (k := / (1 + dot c1 c2)). clearbody k. vec_ring. Qed.

Example full_radius_of_the_mitre_instance :
  mitre (6 + -1/10) (Vec 1 0 0) (Vec 0 1 0) = add (mitre 6 (Vec 1 0 0) (Vec 0 1 0)) (mitre (-1/10) (Vec 1 0 0) (Vec 0 1 0)).
Proof. apply full_radius_of_the_mitre. Qed.
