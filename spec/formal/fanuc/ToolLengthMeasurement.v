(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-length-measurement: the value that G37 writes, and the zones in which it accepts the signal.

    One axis; [A] is where the block starts, [D] the commanded coordinate, [T] the position of the axis at which the
    approach-end signal comes on, [gamma] the distance of 6251 and [epsilon] the half width of 6254. *)
From Coq Require Import Reals Lra Psatz.
Open Scope R_scope.

(** * Definitions *)

(** The programmed coordinate at which the signal comes on while the length offset [o] is in force. *)
Definition reached T o := T - o.

(** The value that is written. *)
Definition measured old p D := old + (p - D).

(** Where the axis is sent under G43 and under G44 with the value [v]. *)
Definition under_G43 programmed v := programmed + v.
Definition under_G44 programmed v := programmed - v.

(** The sense of the motion, the point B where the measuring part begins, and the position reached. *)
Definition sense A D := if Rlt_dec A D then 1 else -1.
Definition measuring_start gamma A D := if Rlt_dec gamma (Rabs (D - A)) then D - sense A D * gamma else A.
Definition touched gamma A D p :=
  let B := measuring_start gamma A D in if Rle_dec (sense A D * (p - B)) 0 then B else p.

(** What a measurement ends with: a position that counts, or a position at which PS0080 is raised. *)
Inductive result := Measured (p : R) | Failed (q : R).

(** A measurement whose signal comes on at the programmed coordinate [p]. *)
Definition measure gamma epsilon A D p :=
  let t := touched gamma A D p in
  if Rlt_dec epsilon (sense A D * (t - D)) then Failed (D + sense A D * epsilon)
  else if Rlt_dec (sense A D * (t - D)) (- epsilon) then Failed t
  else Measured t.

Ltac signs := repeat (destruct Rlt_dec; try lra); repeat (destruct Rle_dec; try lra); try reflexivity.

Lemma sense_cases A D : sense A D = 1 \/ sense A D = -1.
Proof. unfold sense; destruct Rlt_dec; auto. Qed.

(** * The value *)

(** fanuc.length-measurement.value: measured under G43, a later G43 move to the commanded coordinate touches again. *)
Theorem measured_value_reaches old T D : under_G43 D (measured old (reached T old) D) = T.
Proof. unfold under_G43, measured, reached; ring. Qed.

(** H01 = 15, commanded 200, signal at the axis position 213: 13 is written, and G43 Z200 goes to 213. *)
Example measured_value_reaches_instance :
  measured 15 (reached 213 15) 200 = 13 /\ under_G43 200 (measured 15 (reached 213 15) 200) = 213.
Proof. split; [unfold measured, reached; lra | apply measured_value_reaches]. Qed.

(** fanuc.length-measurement.coordinate: what is missed where another offset than the value was in force. *)
Theorem measured_under_another_offset old o T D : under_G43 D (measured old (reached T o) D) = T + (old - o).
Proof. unfold under_G43, measured, reached; ring. Qed.

(** The manual's example: H01 = 15 and no offset in force, commanded 200, signal at 198. *)
Example measured_under_another_offset_instance :
  measured 15 (reached 198 0) 200 = 13 /\ under_G43 200 (measured 15 (reached 198 0) 200) = 198 + (15 - 0).
Proof. split; [unfold measured, reached; lra | apply measured_under_another_offset]. Qed.

(** fanuc.length-measurement.coordinate: a value that is right and in force is not changed. *)
Theorem right_value_stays v D : measured v (reached (under_G43 D v) v) D = v.
Proof. unfold measured, reached, under_G43; ring. Qed.

Example right_value_stays_instance : measured 13 (reached (under_G43 200 13) 13) 200 = 13.
Proof. apply right_value_stays. Qed.

(** fanuc.length-measurement.effect: once the value written is in force, measuring again changes nothing. *)
Theorem measured_twice old o T D : let v := measured old (reached T o) D in
  o = old -> measured v (reached T v) D = v.
Proof. intros v H; unfold v, measured, reached; subst; ring. Qed.

Example measured_twice_instance :
  measured (measured 15 (reached 213 15) 200) (reached 213 (measured 15 (reached 213 15) 200)) 200 = 13.
Proof. rewrite (measured_twice 15 15 213 200) by reflexivity. unfold measured, reached; lra. Qed.

(** fanuc.length-measurement.sign: under G44 the same formula touches again only where the value was right before. *)
Theorem under_G44_only_if_right old T D :
  under_G44 D (measured old (reached T (- old)) D) = T <-> T = under_G44 D old.
Proof. unfold under_G44, measured, reached; split; intro; lra. Qed.

Example under_G44_only_if_right_instance :
  under_G44 200 (measured 15 (reached 185 (- 15)) 200) = 185 /\
  under_G44 200 (measured 15 (reached 183 (- 15)) 200) <> 183.
Proof. split; [| intro H]; apply under_G44_only_if_right in H || apply under_G44_only_if_right; unfold under_G44 in *; lra. Qed.

(** * The zones *)

(** fanuc.length-measurement.too-late: a position that counts lies in the zone, its ends included. *)
Theorem measured_lies_in_the_zone gamma epsilon A D p q :
  measure gamma epsilon A D p = Measured q -> Rabs (q - D) <= epsilon.
Proof.
  unfold measure. set (t := touched gamma A D p). destruct Rlt_dec as [| L]; [discriminate |].
  destruct Rlt_dec as [| E]; [discriminate |]. intro H; injection H as <-.
  destruct (sense_cases A D) as [S | S]; rewrite S in L, E; apply Rabs_le; lra.
Qed.

Example measured_lies_in_the_zone_instance : measure 20 5 760 200 205 = Measured 205 /\ Rabs (205 - 200) <= 5.
Proof.
  assert (H : measure 20 5 760 200 205 = Measured 205).
  { unfold measure, touched, measuring_start, sense. rewrite Rabs_left by lra. signs. }
  split; [exact H | apply (measured_lies_in_the_zone 20 5 760 200 205 205 H)].
Qed.

Lemma within x e : Rabs x <= e -> - e <= x <= e.
Proof. unfold Rabs; destruct Rcase_abs; lra. Qed.

Lemma start_before_zone gamma A D : 0 <= gamma -> gamma < Rabs (D - A) ->
  measuring_start gamma A D = D - sense A D * gamma.
Proof. intros; unfold measuring_start; destruct Rlt_dec; lra. Qed.

(** fanuc.length-measurement.too-early: from far enough away every signal in the zone is measured where it comes. *)
Theorem signal_in_the_zone_is_measured gamma epsilon A D p :
  0 <= epsilon -> epsilon < gamma -> gamma < Rabs (D - A) -> Rabs (p - D) <= epsilon ->
  measure gamma epsilon A D p = Measured p.
Proof.
  intros E G H Z. apply within in Z. unfold measure, touched.
  rewrite start_before_zone by lra. destruct (sense_cases A D) as [S | S]; rewrite !S; signs.
Qed.

Example signal_in_the_zone_is_measured_instance :
  measure 20 5 760 200 198 = Measured 198 /\ measure 20 5 760 200 195 = Measured 195.
Proof.
  split; apply signal_in_the_zone_is_measured; try lra; rewrite Rabs_left; lra.
Qed.

(** fanuc.length-measurement.too-early: a signal before C ends in PS0080, at B where it was on before. *)
Theorem early_signal_fails gamma epsilon A D p :
  0 <= epsilon -> epsilon < gamma -> gamma < Rabs (D - A) -> sense A D * (p - D) < - epsilon ->
  measure gamma epsilon A D p = Failed (touched gamma A D p).
Proof.
  intros E G H Z. unfold measure, touched.
  rewrite start_before_zone by lra. destruct (sense_cases A D) as [S | S]; rewrite !S in *; signs.
Qed.

Example early_signal_fails_instance :
  measure 20 5 760 200 206 = Failed 206 /\ measure 20 5 760 200 300 = Failed 220.
Proof.
  assert (S : sense 760 200 = -1) by (unfold sense; signs).
  assert (B : measuring_start 20 760 200 = 220).
  { rewrite start_before_zone, S by (try rewrite Rabs_left; lra). lra. }
  split; rewrite early_signal_fails by (rewrite ?S; try rewrite Rabs_left; lra);
    unfold touched; rewrite B, S; f_equal; signs.
Qed.

(** fanuc.length-measurement.too-late: without a signal up to F the axis stops at F, with PS0080. *)
Theorem late_signal_fails gamma epsilon A D p :
  0 <= epsilon -> epsilon < gamma -> gamma < Rabs (D - A) -> epsilon < sense A D * (p - D) ->
  measure gamma epsilon A D p = Failed (D + sense A D * epsilon).
Proof.
  intros E G H Z. unfold measure, touched.
  rewrite start_before_zone by lra. destruct (sense_cases A D) as [S | S]; rewrite !S in *; signs.
Qed.

Example late_signal_fails_instance : measure 20 5 760 200 194 = Failed 195.
Proof.
  assert (S : sense 760 200 = -1) by (unfold sense; signs).
  rewrite late_signal_fails by (rewrite ?S; try rewrite Rabs_left; lra). rewrite S; f_equal; lra.
Qed.

Definition mirrored r := match r with Measured p => Measured (- p) | Failed q => Failed (- q) end.

(** fanuc.length-measurement.zones: the zones lie alike on both sides: mirrored, a measurement has the mirrored end. *)
Theorem zones_are_mirrored gamma epsilon A D p : A <> D ->
  measure gamma epsilon (- A) (- D) (- p) = mirrored (measure gamma epsilon A D p).
Proof.
  intro H. assert (S : sense (- A) (- D) = - sense A D) by (unfold sense; signs).
  assert (B : measuring_start gamma (- A) (- D) = - measuring_start gamma A D).
  { unfold measuring_start. replace (- D - - A) with (- (D - A)) by ring. rewrite Rabs_Ropp, S.
    destruct Rlt_dec; lra. }
  assert (T : touched gamma (- A) (- D) (- p) = - touched gamma A D p).
  { unfold touched. rewrite B, S.
    replace (- sense A D * (- p - - measuring_start gamma A D))
      with (sense A D * (p - measuring_start gamma A D)) by ring.
    destruct Rle_dec; reflexivity. }
  unfold measure. rewrite T, S.
  replace (- sense A D * (- touched gamma A D p - - D)) with (sense A D * (touched gamma A D p - D)) by ring.
  destruct Rlt_dec; [cbn; f_equal; ring |]. destruct Rlt_dec; reflexivity.
Qed.

Example zones_are_mirrored_instance : measure 20 5 (- (760)) (- (200)) (- (198)) = Measured (- (198)).
Proof.
  rewrite zones_are_mirrored by lra.
  rewrite signal_in_the_zone_is_measured by (try rewrite Rabs_left; lra). reflexivity.
Qed.
