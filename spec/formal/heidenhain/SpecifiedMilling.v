(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain: what program/ says, over the real numbers, is what the definitions of the sections say: their theorems hold
    of what runs. *)
From Coq Require Import Reals Lra Psatz Bool ZArith List.
From Coq Require String.
From Toolcomp Require Import Vectors SpecifiedSpace OutcomeLaws ToolDirection FaceMilling PeripheralMilling ProgrammedContour.
From Toolcomp Require Numbers Outcomes Space KlartextSpace KlartextBlocks KlartextTool KlartextFace KlartextPeripheral.
Import Outcomes(outcome(..)).
Import ListNotations.
Open Scope R_scope.

(** * Vectors *)

Lemma vector_unit a : vector (Space.unit3 a) = unit (vector a).
Proof. apply SpecifiedSpace.vector_unit. Qed.
Lemma vector_zero : vector KlartextSpace.zero3 = zero.
Proof. reflexivity. Qed.

(** * Face milling *)

Lemma vector_ring N T w : KlartextFace.ring_direction N T = Got w -> vector T <> zero ->
  vector (match w with Some w => Space.unit3 w | None => KlartextSpace.zero3 end) = u (vector N) (vector T).
Proof.
  unfold KlartextFace.ring_direction; intros H D. apply bound in H as (parallel_ & Z & H). apply zero_sign in Z.
  rewrite vector_dot, vector_cross in Z. destruct parallel_; injection H as <-.
  - rewrite vector_zero. symmetry. apply u_along_the_tool; [exact D|].
    unfold parallel. apply dot_self_zero. now apply Z.
  - rewrite vector_unit, vector_sub, !vector_scale, !vector_dot. reflexivity.
Qed.

(** The effective tool that is run is the one of the definitions, with these sums of deltas. *)
Definition is_tool (e : KlartextTool.effective_tool R) (k : tool) (d : deltas) : Prop :=
  KlartextBlocks.of_corner (KlartextTool.delta e) = dR2 d /\ KlartextTool.full_corner e = corner k + dR2 d /\
  KlartextTool.flat_of_table e = ring k /\ KlartextTool.flat e = effective_ring k d.

(** heidenhain.tool.effective-flat: without a table of deviations what may be used is that tool: the flat is the larger of
    R' - R2' and 0. *)
Theorem usable_tool_is_effective (t : KlartextTool.tool_in_force R) a compensating e :
  KlartextTool.usable_tool t (Some a) compensating = Got e ->
  KlartextBlocks.deviations (KlartextTool.table_row t) = None ->
  let row := KlartextTool.table_row t in
  let sums := KlartextTool.total_deltas t in
  is_tool e (Tool (KlartextBlocks.radius row) (KlartextBlocks.corner_radius row))
    (Deltas (KlartextBlocks.of_length sums) (KlartextBlocks.of_radius sums) (KlartextBlocks.of_corner sums)).
Proof.
  intros H D. unfold KlartextTool.usable_tool in H. rewrite D in H. cbv zeta in H.
  do 7 (apply bound in H as (? & _ & H)). apply bound in H as (with_flat & F & H). apply positive_sign in F.
  injection H as <-. unfold is_tool, effective_ring, ring; cbn in *. repeat split.
  destruct with_flat.
  - assert (P : 0 < KlartextBlocks.radius (KlartextTool.table_row t) +
                    KlartextBlocks.of_radius (KlartextTool.total_deltas t) -
                    (KlartextBlocks.corner_radius (KlartextTool.table_row t) +
                     KlartextBlocks.of_corner (KlartextTool.total_deltas t))) by now apply F.
    rewrite Rmax_right; [reflexivity|apply Rlt_le; exact P].
  - rewrite Rmax_left; [reflexivity|]. apply Rnot_lt_le. intro P. apply F in P. discriminate.
Qed.

Definition toroid : KlartextTool.tool_in_force R :=
  KlartextTool.ToolInForce
    (Some (KlartextBlocks.ToolRow 10 String.EmptyString 5 2 None (KlartextBlocks.Deltas (1/4) (- (3/10)) (- (1/10))) None))
    KlartextTool.no_deltas false.

Example usable_tool_is_effective_instance a e :
  KlartextTool.usable_tool toroid (Some a) false = Got e ->
  is_tool e (Tool 5 2) (Deltas (1/4 + 0) (- (3/10) + 0) (- (1/10) + 0)).
Proof. intro H. now apply usable_tool_is_effective in H. Qed.

(** heidenhain.face.effective-tip: the tip of a block with a normal is that of the definitions, from the tip of the nominal
    tool; so are the shift and the contact. *)
Theorem cut_face_is_effective_tip e k d P N T w :
  is_tool e k d -> KlartextFace.ring_direction N T = Got w -> vector T <> zero ->
  let cut := KlartextFace.cut_face false P (corner k) e (Space.unit3 N) (Space.unit3 T) w in
  vector (KlartextFace.tip_of_cut cut) = effective_tip TIP k d (vector P) (vector N) (vector T) /\
  vector (KlartextFace.shift_of_cut cut) = D_tip k d (vector N) (vector T) /\
  vector (KlartextFace.contact_point (KlartextFace.contact_of cut)) =
    contact (vector P) (vector N) (vector T) (corner k) (ring k).
Proof.
  intros (D & _ & O & F) W Z. apply vector_ring in W; [|exact Z]. cbv zeta.
  unfold KlartextFace.cut_face, effective_tip, D_tip; cbn [KlartextFace.tip_of_cut KlartextFace.shift_of_cut
    KlartextFace.contact_of KlartextFace.contact_point].
  rewrite D, O, F. cbn [nominal_tip].
  repeat split; rewrite ?vector_add, ?vector_sub, ?vector_add, ?vector_scale, ?vector_sub, ?vector_unit, ?W;
    cbn [Numbers.minus Numbers.reals]; unfold tip, contact;
    set (n := unit (vector N)); set (t := unit (vector T)); set (across := u (vector N) (vector T));
    clearbody n t across; destruct (vector P); vec_ring.
Qed.

Example cut_face_is_effective_tip_instance w :
  let e := KlartextTool.EffectiveTool (KlartextBlocks.Deltas 0 0 0) 5 2 3 3 None in
  KlartextFace.ring_direction (3/5, 0, 4/5) (0, 0, 1) = Got w ->
  vector (KlartextFace.tip_of_cut (KlartextFace.cut_face false (1, 2, 3) 2 e
    (Space.unit3 (3/5, 0, 4/5)) (Space.unit3 (0, 0, 1)) w)) =
  effective_tip TIP (Tool 5 2) (Deltas 0 0 0) (Vec 1 2 3) (Vec (3/5) 0 (4/5)) (Vec 0 0 1).
Proof.
  intros e W. apply (cut_face_is_effective_tip e (Tool 5 2) (Deltas 0 0 0)); [|exact W|].
  - unfold is_tool, ring, effective_ring; cbn. repeat split; try lra. rewrite Rmax_right; lra.
  - intro Z; injection Z; intros; lra.
Qed.

(** heidenhain.contour.face: under IS CONTOUR it is the tip of the effective tool that touches the programmed point. *)
Theorem cut_face_is_contour_tip e k d q N T w :
  is_tool e k d -> KlartextFace.ring_direction N T = Got w -> vector T <> zero ->
  let cut := KlartextFace.cut_face true q (corner k) e (Space.unit3 N) (Space.unit3 T) w in
  vector (KlartextFace.tip_of_cut cut) = contour_tip k d (vector q) (vector N) (vector T) /\
  vector (KlartextFace.shift_of_cut cut) = D_tip k d (vector N) (vector T).
Proof.
  intros (D & C & O & F) W Z. apply vector_ring in W; [|exact Z]. cbv zeta.
  unfold KlartextFace.cut_face, contour_tip, D_tip; cbn [KlartextFace.tip_of_cut KlartextFace.shift_of_cut].
  rewrite C, D, O, F.
  repeat split; rewrite ?vector_add, ?vector_sub, ?vector_add, ?vector_scale, ?vector_sub, ?vector_unit, ?W;
    cbn [Numbers.minus Numbers.reals]; unfold tip;
    set (n := unit (vector N)); set (t := unit (vector T)); set (across := u (vector N) (vector T));
    clearbody n t across; destruct (vector q); vec_ring.
Qed.

Example cut_face_is_contour_tip_instance w :
  let e := KlartextTool.EffectiveTool (KlartextBlocks.Deltas 0 0 0) 5 2 3 3 None in
  KlartextFace.ring_direction (3/5, 0, 4/5) (0, 0, 1) = Got w ->
  vector (KlartextFace.tip_of_cut (KlartextFace.cut_face true (1, 2, 3) 2 e
    (Space.unit3 (3/5, 0, 4/5)) (Space.unit3 (0, 0, 1)) w)) =
  contour_tip (Tool 5 2) (Deltas 0 0 0) (Vec 1 2 3) (Vec (3/5) 0 (4/5)) (Vec 0 0 1).
Proof.
  intros e W. apply (cut_face_is_contour_tip e (Tool 5 2) (Deltas 0 0 0)); [|exact W|].
  - unfold is_tool, ring, effective_ring; cbn. repeat split; try lra. rewrite Rmax_right; lra.
  - intro Z; injection Z; intros; lra.
Qed.

(** * Peripheral milling *)

(** heidenhain.peripheral.direction: the direction that a block makes is that of the definitions. *)
Theorem own_direction_is_c left_ T d made :
  KlartextPeripheral.own_direction left_ T d = Got (Some made) ->
  vector made = c (if left_ then 1 else -1) (vector T) (vector d).
Proof.
  unfold KlartextPeripheral.own_direction; intro H. apply bound in H as (nothing & _ & H).
  destruct nothing; [discriminate|]. injection H as <-.
  rewrite vector_scale, vector_cross, vector_dot, vector_cross. unfold c, unit, norm; cbn. rewrite scale_scale.
  destruct left_; f_equal; unfold Rdiv; ring.
Qed.

Example own_direction_is_c_instance made :
  KlartextPeripheral.own_direction true (0, 0, 1) (0, 7, 0) = Got (Some made) -> vector made = Vec (-1) 0 0.
Proof. intro H. apply own_direction_is_c in H. rewrite H. apply (left_and_right 7). lra. Qed.

(** heidenhain.peripheral.mitre: so is the end point between two blocks. *)
Theorem mitre_is_mitre delta c1 c2 m :
  KlartextPeripheral.mitre c1 c2 = Got m -> scale delta (vector m) = mitre delta (vector c1) (vector c2).
Proof.
  unfold KlartextPeripheral.mitre; intro H. do 2 (apply bound in H as (? & _ & H)). injection H as <-.
  rewrite vector_scale, vector_add, vector_dot. unfold mitre; cbn. rewrite scale_scale. f_equal. unfold Rdiv; ring.
Qed.

Example mitre_is_mitre_instance m :
  KlartextPeripheral.mitre (1, 0, 0) (0, 1, 0) = Got m -> scale 2 (vector m) = mitre 2 (Vec 1 0 0) (Vec 0 1 0).
Proof. apply (mitre_is_mitre 2 (1, 0, 0) (0, 1, 0)). Qed.

(** heidenhain.program.direction-of-rotary-axes: so is the tool turned by rotary words, in degrees there. *)
Theorem turned_is_spatial a b g e :
  vector (KlartextSpace.of_length_1 (KlartextSpace.turned a b g e)) =
  spatial (a * PI / 180) (b * PI / 180) (g * PI / 180) (vector e).
Proof.
  destruct e as [[x y] z]. unfold KlartextSpace.turned, spatial; cbn.
  rewrite rotate_about_x. rewrite rotate_about_y. rewrite rotate_about_z. cbn. f_equal; ring.
Qed.

Example turned_is_spatial_instance :
  vector (KlartextSpace.of_length_1 (KlartextSpace.turned 0 0 0 (0, 0, 1))) =
  spatial (0 * PI / 180) (0 * PI / 180) (0 * PI / 180) ez.
Proof. apply turned_is_spatial. Qed.
