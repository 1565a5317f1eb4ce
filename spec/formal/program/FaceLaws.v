(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of blocks with a surface normal in a Klartext run: face milling, and the programmed contour. *)
From Coq Require Import List String ZArith Bool Reals Lra Psatz.
From Toolcomp Require Import Numbers Outcomes Words Space KlartextSpace KlartextBlocks KlartextTool KlartextFace.
From Toolcomp Require Import KlartextPeripheral KlartextState KlartextMoves KlartextProgram OutcomeLaws KlartextLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * The tool that may be used *)

(** What holds of every tool that may be used: the corner radius is that of the table and the delta. *)
Lemma full_corner_is {num} {N : Numbers num} (tool : tool_in_force num) a compensating e :
  usable_tool tool a compensating = Got e ->
  full_corner e = (corner_radius (table_row tool) + of_corner (delta e))%num.
Proof.
  unfold usable_tool; intro H. cbv zeta in H.
  destruct a as [a|], (deviations (table_row tool)) as [points|];
    repeat (apply bound in H as (? & _ & H)); apply same in H as <-; reflexivity.
Qed.

(** Without a table of deviations and with deltas of zero the flat is that of the table. *)
Lemma flat_without_deltas (tool : tool_in_force R) a compensating e : usable_tool tool (Some a) compensating = Got e ->
  deviations (table_row tool) = None -> total_deltas tool = no_deltas ->
  of_corner (delta e) = 0%R /\ flat e = flat_of_table e.
Proof.
  unfold usable_tool; intros H D Z. cbv zeta in H. rewrite D, Z in H.
  apply bound in H as (? & _ & H). apply bound in H as (? & _ & H). apply bound in H as (u & C & H).
  apply bound in H as (? & _ & H). apply bound in H as (? & _ & H). apply bound in H as (? & _ & H).
  apply bound in H as (? & _ & H).
  apply bound in H as (with_flat & F & H). apply positive_sign in F. apply same in H as <-.
  unfold check_table in C. do 4 (apply bound in C as (? & _ & C)). apply bound in C as (no_shape & S & C).
  apply negative_sign in S. apply no_alarm in C. subst no_shape. pose proof (no_is _ _ S eq_refl) as P. cbn in *.
  split; [reflexivity|].
  destruct with_flat; [lra|]. pose proof (no_is _ _ F eq_refl). lra.
Qed.

(** * Where the tool goes *)

(** heidenhain.face.effective-tip: without deltas a block with a normal ends with the nominal tool where it is
    programmed, whatever the normal. *)
Theorem without_deltas_no_shift (tool : tool_in_force R) a compensating e p n t w :
  usable_tool tool (Some a) compensating = Got e -> deviations (table_row tool) = None ->
    total_deltas tool = no_deltas ->
  let cut := cut_face false p (corner_radius (table_row tool)) e n t w in
  tip_of_cut cut = p /\ shift_of_cut cut = zero3.
Proof.
  intros U D Z cut. destruct (flat_without_deltas _ _ _ _ U D Z) as [C F].
  assert (S : shift_of_cut cut = zero3).
  { unfold cut, cut_face; cbn [shift_of_cut]. rewrite C, F. set (u := match w with Some w => unit3 w |
      None => zero3 end).
    destruct u as [[x y] z], n as [[a1 b1] c1], t as [[d1 e1] f1]. unfold add3, scale3, sub3, zero3; cbn.
    f_equal; [f_equal|]; ring. }
  split; [|exact S]. unfold cut, cut_face in *; cbn [tip_of_cut shift_of_cut] in *. rewrite S.
  destruct p as [[x y] z]. unfold add3, zero3; cbn. f_equal; [f_equal|]; ring.
Qed.

Definition ball_end : tool_in_force R := ToolInForce (Some (ToolRow 10 "" 6%R 1%R None no_deltas None)) no_deltas false.

Example without_deltas_no_shift_instance a e n w :
  usable_tool ball_end (Some a) false = Got e ->
  tip_of_cut (cut_face false (5, 0, 0)%R 1%R e n (0, 0, 1)%R w) = (5, 0, 0)%R.
Proof.
  intro U. apply (without_deltas_no_shift ball_end a false e (5, 0, 0)%R n (0, 0, 1)%R w U); [reflexivity|].
  unfold total_deltas, ball_end, no_deltas, add_deltas; cbn. f_equal; lra.
Qed.

(** heidenhain.face.contact-point: a program that is moved has its tips and contacts moved as far, and the same shifts;
    the programmed contour too. *)
Theorem moved_program_moved_tips is_contour (p x : triple R) corner e n t w :
  let cut := cut_face is_contour p corner e n t w in
  let cut' := cut_face is_contour (add3 p x) corner e n t w in
  tip_of_cut cut' = add3 (tip_of_cut cut) x /\ shift_of_cut cut' = shift_of_cut cut /\
  contact_point (contact_of cut') = add3 (contact_point (contact_of cut)) x.
Proof.
  cbv zeta. unfold cut_face; cbn [tip_of_cut shift_of_cut contact_of contact_point].
  set (u := match w with Some w => unit3 w | None => zero3 end).
  destruct p as [[px py] pz], x as [[x y] z], u as [[ux uy] uz], n as [[a1 b1] c1], t as [[d1 e1] f1].
  destruct is_contour; repeat split; unfold add3, scale3, sub3; cbn; (f_equal; [f_equal|]; ring).
Qed.

Example moved_program_moved_tips_instance e w :
  tip_of_cut (cut_face false (add3 (5, 0, 0) (0, 1, 0))%R 1%R e (0, 0, 1)%R (0, 0, 1)%R w) =
  add3 (tip_of_cut (cut_face false (5, 0, 0)%R 1%R e (0, 0, 1)%R (0, 0, 1)%R w)) (0, 1, 0)%R.
Proof. apply (moved_program_moved_tips false (5, 0, 0)%R (0, 1, 0)%R 1%R e (0, 0, 1)%R (0, 0, 1)%R w). Qed.

(** heidenhain.contour.same-as-off: a program of the contacts under IS CONTOUR sends the tool where the program of the
    nominal tips does, with every tool that may be used. *)
Theorem contacts_are_the_contour (tool : tool_in_force R) a compensating e p n t w :
  usable_tool tool a compensating = Got e ->
  let corner := corner_radius (table_row tool) in
  let off := cut_face false p corner e n t w in
  let on := cut_face true (contact_point (contact_of off)) corner e n t w in
  tip_of_cut on = tip_of_cut off /\ shift_of_cut on = shift_of_cut off /\ contact_of on = contact_of off.
Proof.
  intros U corner off on. apply full_corner_is in U. unfold on, off, cut_face;
    cbn [tip_of_cut shift_of_cut contact_of contact_point].
  repeat split. rewrite U. fold corner. set (u := match w with Some w => unit3 w | None => zero3 end).
  destruct p as [[px py] pz], u as [[ux uy] uz], n as [[a1 b1] c1], t as [[d1 e1] f1].
  unfold add3, scale3, sub3; cbn; (f_equal; [f_equal|]; ring).
Qed.

Example contacts_are_the_contour_instance a e n w :
  usable_tool ball_end (Some a) false = Got e ->
  let off := cut_face false (5, 0, 0)%R 1%R e n (0, 0, 1)%R w in
  tip_of_cut (cut_face true (contact_point (contact_of off)) 1%R e n (0, 0, 1)%R w) = tip_of_cut off.
Proof. intro U. apply (contacts_are_the_contour ball_end (Some a) false e (5, 0, 0)%R n (0, 0, 1)%R w U). Qed.

(** heidenhain.contour.shift: the shift of a block is the same whether IS CONTOUR is on or not, wherever the block ends.
    *)
Theorem contour_keeps_the_shift {num} {N : Numbers num} (p q : triple num) corner e n t w :
  shift_of_cut (cut_face true p corner e n t w) = shift_of_cut (cut_face false q corner e n t w).
Proof. reflexivity. Qed.

Example contour_keeps_the_shift_instance e w :
  shift_of_cut (cut_face true (1, 2, 3)%R 1%R e (0, 0, 1)%R (0, 0, 1)%R w) =
  shift_of_cut (cut_face false (5, 0, 0)%R 1%R e (0, 0, 1)%R (0, 0, 1)%R w).
Proof. apply contour_keeps_the_shift. Qed.
