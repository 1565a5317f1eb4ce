(* SPDX-License-Identifier: Apache-2.0 *)
(** heidenhain/face-milling: LN blocks with a surface normal, and their contact.
    heidenhain/programmed-contour: what the programmed point of such a block is. *)
From Coq Require Import List String ZArith Bool.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** Where the cutter touches the workpiece. *)
Record contact (num : Type) := Contact {
  contact_point : triple num;             (* q *)
  contact_normal : triple num;            (* n *)
  on_flat : bool;                      (* the normal is along the tool *)
  contact_degrees : option num         (* tools with a table of deviations *)
}.
Arguments Contact {num}. Arguments contact_point {num}. Arguments contact_normal {num}. Arguments on_flat {num}.
Arguments contact_degrees {num}.

(** heidenhain.face.not-normalized: every vector is normalised exactly, and one whose square is off by more than 0.0002
    gives W_NOT_NORMALIZED. *)
Definition not_normalized {num} {N : Numbers num} (v : triple num) : outcome bool :=
  let clause := "heidenhain.face.not-normalized" in
  let excess := (dot3 v v - 1)%num in
  let permitted := (1 / integer 5000)%num in
  longer <- is_positive clause (excess - permitted)%num ;;
  shorter <- is_negative clause (excess + permitted)%num ;;
  Got (longer || shorter).

(** heidenhain.face.side, heidenhain.face.below: a normal that leans below the tool, n.t < -0.0002, gives W_N_BELOW. *)
Definition leans_below {num} {N : Numbers num} (normal tool : triple num) : outcome bool :=
  let along := dot3 normal tool in
  below <- is_negative "heidenhain.face.side" along ;;
  if below : bool
  then is_negative "heidenhain.face.below"
         (dot3 normal normal * dot3 tool tool / integer 25000000 - along * along)%num
  else Got false.

(** heidenhain.face.ring-direction: w = (T.T) N - (N.T) T, the part of the normal across the tool.
    heidenhain.face.along-the-tool: none where the normal is parallel or opposite to the tool; the test is exact. *)
Definition ring_direction {num} {N : Numbers num} (normal tool : triple num) : outcome (option (triple num)) :=
  let a := cross3 normal tool in
  parallel <- is_zero "heidenhain.face.along-the-tool" (dot3 a a) ;;
  Got (if parallel : bool then None
       else Some (sub3 (scale3 (dot3 tool tool) normal) (scale3 (dot3 normal tool) tool))).

(** heidenhain.face.contact-before: a jump is looked for against the LN block with a normal right before.
    heidenhain.face.contact-to-flat: where the effective bottom has a flat, a contact that goes between the axis and the
    ring gives W_CONTACT_JUMP.
    heidenhain.face.contact-jump: so does one that goes to the other half of the ring. *)
Definition contact_jumps {num} {N : Numbers num} (has_flat : bool) (before : option (option (triple num)))
    (w : option (triple num)) : outcome bool :=
  match has_flat, before with
  | true, Some before =>
      match before, w with
      | Some b, Some w => is_negative "heidenhain.face.contact-jump" (dot3 w b)
      | None, None => Got false
      | _, _ => Got true
      end
  | _, _ => Got false
  end.

(** What compensation makes of a block: the tip of the effective tool, and how far it is from that of the nominal tool. *)
Record face_cut (num : Type) := FaceCut { tip_of_cut : triple num; shift_of_cut : triple num; contact_of : contact num }.
Arguments FaceCut {num}. Arguments tip_of_cut {num}. Arguments shift_of_cut {num}. Arguments contact_of {num}.

(** heidenhain.face.effective-tip: the effective tool touches the same plane at the same contact point;
    D_tip = dR2 (n - t) + (rho' - rho) u, TIP' = q + R2' n + rho' u - R2' t.
    heidenhain.face.contact-point: without IS CONTOUR q = tip_nom + R2 t - rho u - R2 n.
    heidenhain.contour.face: under IS CONTOUR the programmed point is the contact point.
    heidenhain.contour.shift: the shift is D_tip in both modes. *)
Definition cut_face {num} {N : Numbers num} (is_contour : bool) (programmed_or_tip : triple num) (corner_of_table : num)
    (tool : effective_tool num) (n t : triple num) (w : option (triple num)) : face_cut num :=
  let u := match w with Some w => unit3 w | None => zero3 end in
  let n_less_t := sub3 n t in
  let from_contact corner rho := add3 (scale3 corner n_less_t) (scale3 rho u) in
  let shift := from_contact (of_corner (delta tool)) (flat tool - flat_of_table tool)%num in
  let q := if is_contour then programmed_or_tip
           else sub3 programmed_or_tip (from_contact corner_of_table (flat_of_table tool)) in
  let tip := if is_contour then add3 q (from_contact (full_corner tool) (flat tool)) else add3 programmed_or_tip shift in
  FaceCut tip shift (Contact q n (negb (given w)) (theta tool)).
