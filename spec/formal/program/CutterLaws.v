(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of cutter compensation: the side, the value 0, and the path behind a cancel. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs Corners Interference LengthOffset
  ToolShift.
From Toolcomp Require Import CutterState State.
From Toolcomp Require Import Movements CutterRules CutterMoves CutterB CutterModes CutterC Program OutcomeLaws PlanLaws
  ProgramLaws PassLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * The side *)

(** fanuc.cutter.side: side and value together are the value to the left: G41 offsets by it, G42 by its negative. B and
    C say the same. *)
Theorem offset_is_signed_value h (v : R) left r :
  CutterModes.on_left h v = Got left -> magnitude v = Got r -> offset_of left r = to_the_left h v.
Proof.
  unfold CutterModes.on_left, magnitude; intros H M. apply bound in H as (negative & N & H). apply negative_sign in N.
  apply same in H as <-. apply bound in M as (negative' & N' & M). apply negative_sign in N'. apply same in M as <-.
  assert (negative' = negative) as ->.
  { destruct negative, negative'; auto; [apply N', N|symmetry; apply N, N']; reflexivity. }
  destruct h, negative; cbn; lra.
Qed.

Example offset_is_signed_value_instance left r :
  CutterModes.on_left RightHand 4%R = Got left -> magnitude 4%R = Got r -> offset_of left r = (0 - 4)%R.
Proof. intros H M. now rewrite (offset_is_signed_value RightHand 4%R left r H M). Qed.

Lemma same_side_of_negative (v : R) : v <> 0%R ->
  CutterModes.on_left LeftHand (- v)%R = CutterModes.on_left RightHand v /\ magnitude (- v)%R = magnitude v.
Proof.
  intro D. unfold CutterModes.on_left, magnitude.
  assert (E : forall clause, exists n, is_negative clause (- v)%R = Got (negb n) /\ is_negative clause v = Got n).
  { intro clause. unfold is_negative.
    destruct (decides clause (- v)%R) as [c C], (decides clause v) as [c' C']. rewrite C, C'. apply decided in C, C'.
    destruct c, c'; try (exfalso; lra); cbn; [exists false|exists true]; auto. }
  destruct (E "fanuc.cutter.side") as (n & -> & ->). cbn [bind]. destruct n; cbn; split; f_equal; lra.
Qed.

(** fanuc.cutter.side: G41 with a value does in every block what G42 does with its negative, in B and in C. *)
Theorem other_side_negative_value s c before after moves (v : R) : v <> 0%R ->
  vector_b s c before after moves (to_the_left LeftHand (- v)%R) = vector_b s c before after moves (to_the_left
    RightHand v) /\
  moving_step s c (Some LeftHand) (- v)%R before after moves = moving_step s c (Some RightHand) v before after moves /\
  goes_away_step s c (Some LeftHand) (- v)%R before moves = goes_away_step s c (Some RightHand) v before moves /\
  idle_step s c (Some LeftHand) (- v)%R before = idle_step s c (Some RightHand) v before.
Proof.
  intro D. destruct (same_side_of_negative v D) as [L M]. repeat split.
  - f_equal. cbn. lra.
  - unfold moving_step. now rewrite L, M.
  - unfold goes_away_step. now rewrite L, M.
  - unfold idle_step. now rewrite L, M.
Qed.

Example other_side_negative_value_instance s c before after moves :
  moving_step s c (Some LeftHand) (- (5))%R before after moves = moving_step s c (Some RightHand) 5%R before after
    moves.
Proof. apply (other_side_negative_value s c before after moves 5%R). lra. Qed.

(** * Behind a cancel *)

(** The block's own moves are without a head. *)
Definition own_without_head {num} {N : Numbers num} (s : setup num) (i : item num) : Prop :=
  match i with Go m => because m = Corner \/ without_head s m | _ => True end.

Lemma own_moves_at {num} {N : Numbers num} (s : setup num) p b why v w all :
  own_move_between s p b why v w = Got all ->
  Forall (fun i => match i with Go m => head m = with_plane s p (zeros s) w | _ => True end) all.
Proof.
  unfold own_move_between; intro H. apply each_got in H. induction H as [|i j rest done E _ IH]; [constructor|].
  constructor; [|exact IH]. destruct i as [m|part a q x|name|name value|h]; try (apply same in E as <-; exact I).
  destruct (circle_of (for_cause _ _)); [apply bound in E as (? & _ & E)|]; apply same in E as <-; reflexivity.
Qed.

(** fanuc.cutter-c.cancel: the cancel block ends where it is programmed, and the tool stays on the programmed path in
    the blocks behind it. *)
Theorem cancelled_c_is_programmed {num} {N : Numbers num} (s : setup num) vs b rest new ws :
  block_c s vs b rest = Got (new, ws) ->
  (part_of b = CancelBlock -> ws = [zero2] /\ Forall (own_without_head s) new) /\
  (part_of b = MovesFree -> ws = [zero2] /\ new = items b).
Proof.
  intro H. split; intro P; unfold block_c in H; rewrite P in H.
  - apply bound in H as (own & O & H). apply same in H. injection H as <- <-. split; [reflexivity|].
    apply Forall_app; split.
    + unfold corner_moves. apply Forall_map, Forall_forall. intros v _. now left.
    + apply own_moves_at in O. rewrite zeros_of_plane in O. eapply Forall_impl; [|exact O]. intros [] E; cbn in *; auto.
  - apply same in H. injection H as <- <-. auto.
Qed.

Example cancelled_c_is_programmed_instance vs (b : planned R) rest new ws :
  block_c plain_setup vs b rest = Got (new, ws) -> part_of b = CancelBlock -> ws = [(0%R, 0%R)].
Proof. intros H P. destruct (cancelled_c_is_programmed plain_setup vs b rest new ws H) as [C _]. now destruct (C P).
Qed.

(** fanuc.cutter-b.cancel: in type B so does every block behind which G40 is in force. *)
Theorem cancelled_b_is_programmed {num} {N : Numbers num} (s : setup num) c before_ after moves x b new :
  behind_b s c before_ after moves = Got x -> hand_in_force x = None -> cutter (behind b) = x ->
  hand_in_force (cutter (before b)) <> None -> is_corner_arc (command_of b) = false -> items_b s b = Got new ->
  Forall (bare_item s) new.
Proof.
  intros H O E ON G I. assert (V : vector_behind x = zero2).
  { unfold behind_b in H. apply bound in H as ([v stands] & W & H). apply same in H as <-. cbn in *.
    rewrite O in W. apply same in W. now injection W as <- _. }
  unfold items_b in I. rewrite E, O, V, G in I. destruct (hand_in_force (cutter (before b))) as [h|];
    [|now destruct ON].
  cbn [given negb andb] in I. apply bound in I as (nothing & _ & I).
  destruct (negb (has_axis_word (command_of b)) && negb nothing).
  - apply same in I as <-. constructor; [apply zeros_of_plane|].
    apply Forall_forall. intros i M. unfold still in M. apply filter_In in M as [_ M]. now destruct i.
  - apply own_moves_at in I. rewrite zeros_of_plane in I. exact I.
Qed.

Example cancelled_b_is_programmed_instance b st new :
  let cancel := Command (Block [natural Letter.G 40] None) [400%Z] None (initial_modes false) None None [] [] [] in
  behind_b plain_setup cancel st st [] = Got (cutter (behind b)) ->
  hand_in_force (cutter (before b)) = Some LeftHand -> command_of b = cancel -> items_b plain_setup b = Got new ->
  Forall (bare_item plain_setup) new.
Proof.
  intros cancel H L C I. apply (cancelled_b_is_programmed plain_setup cancel st st [] (cutter (behind b)) b new H);
    auto.
  - unfold behind_b in H. now apply same in H as <-.
  - rewrite L; discriminate.
  - now rewrite C.
Qed.

(** * The value 0 *)

(** A block of cutter compensation C in which the offset value is 0. *)
Definition value_zero (s : setup R) (b : planned R) : Prop :=
  Forall (bare_item s) (items b) /\ reach (cutter (before b)) = 0%R /\ reach (cutter (behind b)) = 0%R /\
    vector_behind (cutter (behind b)) = zero2.

Lemma no_perpendicular (a : leg R) : rho a = 0%R -> perpendicular a = zero2.
Proof. intro E. unfold perpendicular. rewrite E. unfold zero2; cbn. unfold scale2; cbn. f_equal; ring. Qed.

Lemma no_offset left : offset_of left 0%R = 0%R.
Proof. destruct left; cbn; lra. Qed.

Lemma rho_before (s : setup R) b r : rho (leg_before s b r) = r.
Proof.
  unfold leg_before. destruct (arc_run _) as [[clockwise a]|]; [|now destruct (way_to_intermediate _ _ _ _)].
  unfold arc_leg, leg_along. now destruct (runs_clockwise _).
Qed.
Lemma rho_behind (s : setup R) b : rho (leg_behind s b) = rho_of (cutter (behind b)).
Proof.
  unfold leg_behind, end_leg. destruct (arc_run _) as [[clockwise a]|]; [|reflexivity].
  unfold arc_leg, leg_along. now destruct (runs_clockwise _).
Qed.

Lemma group_of_zero (s : setup R) b rest ws : reach (cutter (behind b)) = 0%R -> group_at_end s b rest = Got ws ->
  ws = [zero2].
Proof.
  unfold group_at_end; intros Z H.
  assert (P : perpendicular (leg_behind s b) = zero2).
  { apply no_perpendicular. rewrite rho_behind. unfold rho_of. now rewrite Z, no_offset. }
  destruct (look s 0 false (beyond s b rest)) as [next repeated| | |];
    [|now apply same in H as <-; rewrite P|now apply same in H as <-|now apply same in H as <-; rewrite P].
  apply bound in H as (group & G & H). unfold corner_group in G. apply bound in G as (nothing & N & G).
  apply zero_sign in N. assert (nothing = true) as -> by now apply N. apply same in G as <-.
  unfold thinned in H. cbn in H. now apply same in H.
Qed.

Lemma sweep_as_programmed clockwise (from to : pair R) x : sweep_interferes clockwise from to from to = Got x ->
  x = false.
Proof.
  unfold sweep_interferes; intro H. apply bound in H as ([[sin1 cos1] over1] & E & H).
  apply bound in H as ([[sin2 cos2] over2] & E' & H). rewrite E in E'. apply same in E'. injection E' as <- <- <-.
  destruct over1; now apply same in H as <-.
Qed.

Lemma plus_zero (a : pair R) : add2 a zero2 = a.
Proof. destruct a as [x y]. unfold add2, zero2; cbn. f_equal; lra. Qed.

Lemma nothing_interferes first_only silent (p : path R) rho_at_start rho_at_end vs ws line :
  rho_at_start = 0%R -> rho_at_end = 0%R ->
  checked first_only silent p rho_at_start rho_at_end [zero2] [zero2] = Got (vs, ws, line) ->
  vs = [zero2] /\ ws = [zero2].
Proof.
  intros -> -> H. unfold checked in H. cbn [rev app hd] in H. apply bound in H as (hit & I & H).
  assert (hit = false) as ->; [|apply same in H; now injection H as <- <- _].
  destruct (about p) as [[clockwise center]|].
  - unfold arc_interferes, radius_left in I.
    rewrite !not_positive in I by (destruct clockwise; cbn; lra). cbn [bind] in I.
    apply bound in I as (from_center & _ & I). apply bound in I as (to_center & _ & I).
    destruct (from_center || to_center); [now apply same in I as <-|].
    rewrite !plus_zero in I. now apply sweep_as_programmed in I.
  - unfold line_interferes in I. apply negative_sign in I. destruct hit; [|reflexivity]. exfalso.
    assert (L : (dot2 (sub2 (finishes p) (starts p)) (add2 (sub2 (finishes p) (starts p)) (sub2 zero2 zero2)) < 0)%R) by
      now apply I.
    revert L. rewrite <- (plus_zero (sub2 zero2 zero2)). generalize (sub2 (finishes p) (starts p)). intros [x y] L.
    unfold dot2, add2, sub2, zero2 in L; cbn in L. nra.
Qed.

Lemma own_moves_of_zero s p (b : planned R) why own : own_move_between s p b why zero2 zero2 = Got own ->
  Forall (bare_item s) own.
Proof. intro O. apply own_moves_at in O. rewrite zeros_of_plane in O. exact O. Qed.

Lemma head_items_of_zero (s : setup R) p all : Forall (bare_item s) (at_head s p zero2 all).
Proof.
  apply Forall_map, Forall_forall. intros [m| | | |] _; cbn; auto. apply zeros_of_plane.
Qed.

Lemma still_items (s : setup R) all : Forall (bare_item s) (still all).
Proof. apply Forall_forall. intros i M. unfold still in M. apply filter_In in M as [_ M]. now destruct i. Qed.

Lemma at_once_of_zero (s : setup R) b why new : at_once s b why zero2 zero2 = Got new -> Forall (bare_item s) new.
Proof.
  unfold at_once; intro H. apply bound in H as (first & _ & H). apply bound in H as (second & _ & H).
  destruct (has_axis_word _ || _); apply same in H as <-.
  - apply Forall_map, Forall_forall. intros [m| | | |] _; cbn; auto. apply zeros_of_plane.
  - constructor; [apply zeros_of_plane|apply still_items].
Qed.

Lemma going_away_of_zero (s : setup R) b : value_zero s b -> Forall (bare_item s) (going_away s zero2 b).
Proof.
  intros (B & _ & _ & V). unfold going_away. rewrite V. destruct (items b) as [|[m|part a q x|name|name value|h] rest];
    try exact B.
  constructor; [|apply head_items_of_zero].
  cbn [bare_item]. unfold without_head, at_vector, with_head. cbn [head].
  match goal with |- with_plane _ _ _ (if ?c then _ else _) = _ => destruct c end; apply zeros_of_plane.
Qed.

Lemma block_of_zero (s : setup R) b rest new ws : value_zero s b -> block_c s [zero2] b rest = Got (new, ws) ->
  Forall (bare_item s) new /\ ws = [zero2].
Proof.
  intros Z H. pose proof Z as (B & R & R' & V).
  assert (RHO : rho_of (cutter (behind b)) = 0%R) by (unfold rho_of; now rewrite R', no_offset).
  assert (WAY : perpendicular (leg_before s b (rho_of (cutter (behind b)))) = zero2).
  { apply no_perpendicular. now rewrite rho_before. }
  unfold block_c in H. destruct (part_of b) eqn:P; cbn [hd last] in H.
  - apply same in H. injection H as <- <-. split; [apply head_items_of_zero|reflexivity].
  - unfold lone_start in H. destruct (look s 0 false (beyond s b rest)) as [next repeated| | |];
      [destruct (part_of next)|..]; try (apply same in H; injection H as <- <-; split;
        [apply head_items_of_zero|reflexivity]).
    rewrite (no_perpendicular (leg_before s next (rho_of (cutter (behind b))))) in H by now rewrite rho_before.
    apply bound in H as (made & M & H). apply same in H. injection H as <- <-. now apply at_once_of_zero in M.
  - destruct (suv s).
    + apply bound in H as (made & M & H). apply same in H. injection H as <- <-. now apply at_once_of_zero in M.
    + apply same in H. injection H as <- <-. split; [apply head_items_of_zero|reflexivity].
  - apply bound in H as (group & G & H). apply bound in H as (own & O & H). apply same in H. injection H as <- <-.
    apply group_of_zero in G; [|exact R']. subst group. now apply own_moves_of_zero in O.
  - unfold mode_block in H. apply bound in H as (group & G & H). apply group_of_zero in G; [|exact R']. subst group.
    apply bound in H as ([[vs' ws'] line] & C & H).
    assert (E : vs' = [zero2] /\ ws' = [zero2]).
    { destruct (_ || loses_vector _ _ rest); [apply same in C; now injection C as <- <- _|].
      apply nothing_interferes in C; [exact C|now rewrite R, no_offset|exact RHO]. }
    destruct E as [-> ->]. apply bound in H as (own & O & H). apply same in H. injection H as <- <-.
    split; [|reflexivity]. cbn [corner_moves tl map app]. now apply own_moves_of_zero in O.
  - apply bound in H as (own & O & H). apply same in H. injection H as <- <-. split; [|reflexivity].
    cbn [corner_moves tl map app]. now apply own_moves_of_zero in O.
  - apply same in H. injection H as <- <-. auto.
  - unfold corner_arc_c in H. apply bound in H as (direction & _ & H). apply bound in H as (nothing & N & H).
    apply zero_sign in N. unfold rho_of in N. rewrite R, no_offset in N. assert (nothing = true) as -> by now apply N.
    destruct direction as [u|].
    + apply bound in H as (across & _ & H). apply bound in H as (along & _ & H). cbn [orb] in H. apply same in H.
      injection H as <- <-. split; [apply head_items_of_zero|reflexivity].
    + apply same in H. injection H as <- <-. split; [apply head_items_of_zero|reflexivity].
  - unfold shifted in H. apply bound in H as (nothing & _ & H). destruct nothing; cbn [negb] in H; [|discriminate].
    destruct (suv s && _).
    + apply bound in H as (made & M & H). apply same in H. injection H as <- <-. now apply at_once_of_zero in M.
    + apply same in H. injection H as <- <-. split; [apply head_items_of_zero|reflexivity].
  - rewrite V in H. apply same in H. assert (N : new = going_away s zero2 b) by congruence.
    assert (W : ws = [zero2]) by congruence. subst new ws. split; [now apply going_away_of_zero|reflexivity].
  - rewrite V, WAY in H. apply same in H. cbn [corner_moves tl map app] in H.
    assert (N : new = going_away s zero2 b) by congruence. assert (W : ws = [zero2]) by congruence. subst new ws.
    split; [now apply going_away_of_zero|reflexivity].
Qed.

(** fanuc.cutter-c.value-zero: with the value 0 the tool goes along the programmed path, corners and all, whatever the
    blocks of the mode do. *)
Theorem value_zero_is_programmed (s : setup R) bs :
  Forall (value_zero s) bs -> Forall (fun b => Forall (bare_item s) (items b)) (fst (blocks_c s [zero2] bs)).
Proof.
  induction 1 as [|b rest Z F IH]; [constructor|]. cbn [blocks_c].
  destruct (block_c s [zero2] b rest) as [[new ws]| |] eqn:B; try constructor.
  apply block_of_zero in B as [B ->]; [|exact Z]. destruct (blocks_c s [zero2] rest). now constructor.
Qed.

Definition standing_block : planned R :=
  Planned 0 (Command up [430%Z] None (initial_modes false) None None [] [] []) (initial plain_setup) (initial
    plain_setup)
    [Go (move_to plain_setup Rapid Programmed false None (initial plain_setup) [0%R; 0%R; 0%R])].

Example value_zero_is_programmed_instance :
  Forall (fun b => Forall (bare_item plain_setup) (items b)) (fst (blocks_c plain_setup [zero2] [standing_block;
    standing_block])).
Proof. apply value_zero_is_programmed. repeat constructor. Qed.

(** * G52 and G92 *)

(** fanuc.cutter-c.coordinate-shift: before G52 or G92 of the plane a block ends where it is programmed to, whatever it
    is, with or without a block of a count of one between. *)
Theorem no_vector_before_a_shift (s : setup R) a still b rest :
  part_of b = ShiftsPlane -> part_of still = Idle 1 -> stops s a = false -> stops s still = false ->
  1 < idle_limit s ->
  group_at_end s a (b :: rest) = Got [zero2] /\ group_at_end s a (still :: b :: rest) = Got [zero2].
Proof.
  intros B S A T L. unfold group_at_end, beyond. rewrite A. cbn [look]. rewrite S, T, B.
  now rewrite (proj2 (Z.ltb_lt (0 + 1) (idle_limit s)) L).
Qed.

Example no_vector_before_a_shift_instance a b :
  part_of b = ShiftsPlane -> stops plain_setup a = false ->
  group_at_end plain_setup a [b; standing_block] = Got [zero2].
Proof. intros B A. now apply (no_vector_before_a_shift plain_setup a standing_block b [standing_block]). Qed.

(** * Interference *)

(** fanuc.cutter-c.interference-without-alarm: with CNC = 1 a line between two vectors runs, whatever they are. *)
Theorem lone_pair_runs first_only (p : path R) rho_at_start rho_at_end v w :
  about p = None -> checked first_only true p rho_at_start rho_at_end [v] [w] = Got ([v], [w], false).
Proof.
  intro A. unfold checked. rewrite A. cbn [rev app hd single andb negb given]. unfold line_interferes, is_negative.
  destruct (decides "fanuc.cutter-c.interference-direction" (dot2 (sub2 (finishes p) (starts p))
    (add2 (sub2 (finishes p) (starts p)) (sub2 w v)))) as [c ->].
  rewrite orb_true_r. now destruct c.
Qed.

(** A line of 5 to the right whose vectors lead the tool 15 back. *)
Example lone_pair_runs_instance :
  checked false true (Path (0%R, 0%R) (5%R, 0%R) None) 10%R 10%R [(10%R, 10%R)] [((-10)%R, 10%R)] =
  Got ([(10%R, 10%R)], [((-10)%R, 10%R)], false).
Proof. now apply lone_pair_runs. Qed.
