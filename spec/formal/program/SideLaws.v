(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of tool side compensation: every vector of a run is at right angles to the tool. *)
From Coq Require Import List String ZArith Bool PeanoNat Reals Lra Psatz.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Arcs Corners LengthOffset SideState ControlState State
  Space Pose.
From Toolcomp Require Import Movements SidePlane SideWords SideBlocks SideGroups SideCheck SidePass.
From Toolcomp Require Import Program OutcomeLaws PlanLaws ProgramLaws PassLaws CutterLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * Vectors across the tool *)

Definition across_tool (vt v : triple R) : Prop := dot3 v vt = 0%R.

Lemma across_scale vt k v : across_tool vt v -> across_tool vt (scale3 k v).
Proof. destruct vt as [[a b] c], v as [[x y] z]. unfold across_tool, scale3, dot3; cbn. intro E.
  transitivity (k * (x * a + y * b + z * c))%R; [ring|rewrite E; ring].
Qed.
Lemma across_add vt v w : across_tool vt v -> across_tool vt w -> across_tool vt (add3 v w).
Proof. destruct vt as [[a b] c], v as [[x y] z], w as [[d e] f]. unfold across_tool, add3, dot3; cbn. intros; lra. Qed.
Lemma across_sub vt v w : across_tool vt v -> across_tool vt w -> across_tool vt (sub3 v w).
Proof. destruct vt as [[a b] c], v as [[x y] z], w as [[d e] f]. unfold across_tool, sub3, dot3; cbn. intros; lra. Qed.
Lemma across_cross vt v : across_tool vt (cross3 vt v).
Proof. destruct vt as [[a b] c], v as [[x y] z]. unfold across_tool, cross3, dot3; cbn. ring. Qed.
Lemma across_cross_behind vt v : across_tool vt (cross3 v vt).
Proof. destruct vt as [[a b] c], v as [[x y] z]. unfold across_tool, cross3, dot3; cbn. ring. Qed.
Lemma across_unit vt v : across_tool vt v -> across_tool vt (unit3 v).
Proof.
  intro A. replace (unit3 v) with (scale3 (/ length3 v)%R v); [now apply across_scale|].
  destruct v as [[x y] z]. unfold unit3, scale3; cbn. unfold Rdiv. f_equal; [f_equal|]; ring.
Qed.
Lemma across_projected vt v : dot3 vt vt <> 0%R -> across_tool vt (projected vt v).
Proof.
  destruct vt as [[a b] c], v as [[x y] z]. unfold across_tool, projected, sub3, scale3, dot3; cbn. intro T. field.
  exact T.
Qed.

(** A block at a corner, in the plane of the tool. *)
Definition leg_across (vt : triple R) (a : leg_in R (triple R)) : Prop :=
  across_tool vt (normal a) /\ across_tool vt (unit_way a) /\
  match bent a with Some b => across_tool vt (to_center b) | None => True end.

Lemma legs_are_across (s : setup R) vt b point rho a : dot3 vt vt <> 0%R -> leg_in_plane s vt b point rho = Got a ->
  leg_across vt a.
Proof.
  intros T H. unfold leg_in_plane in H. destruct (arc_of_block b) as [[clockwise circle]|].
  - apply bound in H as (seen & _ & H). apply same in H as <-.
    set (outward := projected vt (in_selected (arc_plane circle) (radius_vector s circle point))).
    assert (O : across_tool vt outward) by now apply across_projected.
    unfold leg_across; cbn [normal unit_way bent to_center]. repeat split.
    + apply across_unit. destruct seen; auto using across_scale.
    + apply across_unit, across_scale. destruct seen; auto using across_scale, across_cross.
    + now apply across_scale.
  - apply same in H as <-. unfold leg_across, leftward; cbn [normal unit_way bent]. repeat split.
    + apply across_unit, across_cross.
    + apply across_unit, across_cross_behind.
Qed.

(** * Groups *)

Lemma across_perpendicular vt a : leg_across vt a -> across_tool vt (perpendicular (P := plane_of_tool vt) a).
Proof. intros (A & _). now apply across_scale. Qed.
Lemma across_meeting vt a b : leg_across vt a -> leg_across vt b ->
  across_tool vt (tangents_meet (P := plane_of_tool vt) a b).
Proof. intros (A & _) (B & _). apply across_scale. now apply across_add. Qed.
Lemma across_of_arc vt a : leg_across vt a -> Forall (across_tool vt) (of_arc (P := plane_of_tool vt) a).
Proof. intro A. unfold of_arc. destruct (is_arc a); repeat constructor. now apply across_perpendicular. Qed.
Lemma across_prolonged vt a b vs : leg_across vt a -> leg_across vt b ->
  prolonged (P := plane_of_tool vt) a b = Got vs ->
  Forall (across_tool vt) vs.
Proof.
  intros A B H. unfold prolonged in H. apply bound in H as (right & _ & H). apply same in H as <-.
  destruct A as (NA & UA & _), B as (NB & UB & _).
  repeat constructor; [apply across_add|apply across_sub]; now apply across_scale.
Qed.

Definition meets_across (vt : triple R) (m : meeting (triple R)) : Prop :=
  match m with MeetAt v => across_tool vt v | _ => True end.

Lemma across_line_circle vt a b r m : leg_across vt a -> across_tool vt (to_center b) ->
  line_meets_circle (P := plane_of_tool vt) a b r = Got m -> meets_across vt m.
Proof.
  intros A B H. unfold line_meets_circle in H. apply bound in H as (apart & _ & H).
  destruct apart; [apply same in H as <-; exact I|]. apply bound in H as (behind & _ & H). apply same in H as <-.
  cbn [meets_across]. apply across_add; [now apply across_perpendicular|]. apply across_scale.
  now destruct A as (_ & ? & _).
Qed.
Lemma across_circles vt c1 r1 c2 r2 m : across_tool vt c1 -> across_tool vt c2 ->
  circles_meet (P := plane_of_tool vt) c1 r1 c2 r2 = Got m -> meets_across vt m.
Proof.
  intros A B H. unfold circles_meet in H. cbv zeta in H. apply bound in H as (apart & _ & H).
  destruct apart; [apply same in H as <-; exact I|]. apply bound in H as (nested & _ & H).
  destruct nested; [apply same in H as <-; exact I|]. apply bound in H as (right & _ & H). apply same in H as <-.
  cbn [meets_across]. apply across_add; [exact A|]. apply across_add; apply across_scale; [now apply across_sub|].
  apply across_scale, across_cross.
Qed.
Lemma across_paths vt a b m : leg_across vt a -> leg_across vt b -> paths_meet (P := plane_of_tool vt) a b = Got m ->
  meets_across vt m.
Proof.
  intros A B H. unfold paths_meet in H. pose proof A as (_ & _ & CA). pose proof B as (_ & _ & CB).
  unfold is_arc in H. destruct (bent a) as [arc1|] eqn:EA, (bent b) as [arc2|] eqn:EB; cbn [given] in H.
  - apply bound in H as ([r1|] & _ & H); [|apply same in H as <-; exact I].
    apply bound in H as ([r2|] & _ & H); [|apply same in H as <-; exact I]. now apply across_circles in H.
  - apply bound in H as ([r1|] & _ & H); [|apply same in H as <-; exact I]. now apply across_line_circle in H.
  - apply bound in H as ([r1|] & _ & H); [|apply same in H as <-; exact I]. now apply across_line_circle in H.
  - apply same in H as <-. now apply across_meeting.
Qed.

Lemma across_mode vt a b vs : leg_across vt a -> leg_across vt b -> mode_group (P := plane_of_tool vt) a b = Got vs ->
  Forall (across_tool vt) vs.
Proof.
  intros A B H. unfold mode_group in H. apply bound in H as (kind & _ & H). destruct kind.
  - apply same in H as <-. repeat constructor. now apply across_perpendicular.
  - apply bound in H as (m & M & H). apply across_paths in M; auto.
    destruct m; try discriminate; apply same in H as <-; repeat constructor; auto.
    now apply across_perpendicular.
  - apply same in H as <-. repeat (apply Forall_app; split); auto using across_of_arc. repeat constructor.
    now apply across_meeting.
  - apply bound in H as (both & M & H). apply same in H as <-.
    repeat (apply Forall_app; split); eauto using across_of_arc, across_prolonged.
Qed.
Lemma across_start vt type_b a b vs : leg_across vt a -> leg_across vt b ->
  start_up_group (P := plane_of_tool vt) type_b a b = Got vs -> Forall (across_tool vt) vs.
Proof.
  intros A B H. unfold start_up_group in H.
  assert (P : forall ws, Got [perpendicular (P := plane_of_tool vt) b] = Got ws -> Forall (across_tool vt) ws).
  { intros ws E. apply same in E as <-. repeat constructor. now apply across_perpendicular. }
  destruct (negb type_b); [now apply P|]. apply bound in H as (kind & _ & H). destruct kind; try (now apply P).
  - apply same in H as <-. apply Forall_app; split; [|now apply across_of_arc].
    repeat constructor; auto using across_perpendicular, across_meeting.
  - apply bound in H as (tiny & _ & H). destruct tiny; [now apply P|]. apply bound in H as (both & M & H).
    apply same in H as <-.
    constructor; [now apply across_perpendicular|]. apply Forall_app; split; eauto using across_of_arc,
      across_prolonged.
Qed.
Lemma across_cancel vt type_b a b vs : leg_across vt a -> leg_across vt b ->
  cancel_group (P := plane_of_tool vt) type_b a b = Got vs -> Forall (across_tool vt) vs.
Proof.
  intros A B H. unfold cancel_group in H.
  assert (P : forall ws, Got [perpendicular (P := plane_of_tool vt) a] = Got ws -> Forall (across_tool vt) ws).
  { intros ws E. apply same in E as <-. repeat constructor. now apply across_perpendicular. }
  destruct (negb type_b); [now apply P|]. apply bound in H as (kind & _ & H). destruct kind; try (now apply P).
  - apply same in H as <-. apply Forall_app; split; [now apply across_of_arc|].
    repeat constructor; auto using across_perpendicular, across_meeting.
  - apply bound in H as (tiny & _ & H). destruct tiny; [now apply P|]. apply bound in H as (both & M & H).
    apply same in H as <-.
    repeat (apply Forall_app; split); eauto using across_of_arc, across_prolonged. repeat constructor.
    now apply across_perpendicular.
Qed.
Lemma across_change vt a b vs : leg_across vt a -> leg_across vt b ->
  direction_change_group (P := plane_of_tool vt) a b = Got vs -> Forall (across_tool vt) vs.
Proof.
  intros A B H. unfold direction_change_group in H.
  assert (P : across_tool vt (perpendicular (P := plane_of_tool vt) b)) by now apply across_perpendicular.
  apply bound in H as (parallel & _ & H). destruct parallel; [apply same in H as <-; now repeat constructor|].
  destruct (is_arc a || is_arc b).
  - apply bound in H as (m & M & H). apply across_paths in M; auto. apply same in H as <-.
    destruct m; now repeat constructor.
  - apply same in H as <-. repeat constructor. apply across_scale. destruct A as (NA & _), B as (NB & _).
    now apply across_sub.
Qed.

Definition heads_across (vt : triple R) (hs : list (head_vector R)) : Prop :=
  Forall (fun h => across_tool vt (snd h)) hs.

Lemma across_up_to_stop vt count vs : Forall (across_tool vt) vs ->
  heads_across vt (up_to_stop (P := plane_of_tool vt) count vs).
Proof. intro F. revert count; induction F as [|v vs A _ IH]; intro count; constructor; auto. apply IH. Qed.

Lemma removed_last {A} (Q : A -> Prop) l : Forall Q l -> Forall Q (removelast l).
Proof. induction 1 as [|a l H F IH]; [constructor|]. destruct l; [constructor|]. cbn. now constructor. Qed.

Lemma across_group vt (s : setup R) r q a b hs : leg_across vt a -> leg_across vt b ->
  group_of (P := plane_of_tool vt) s r q a b = Got hs -> heads_across vt hs.
Proof.
  intros A B H. unfold group_of, asked_of_lines in H.
  match type of H with match ?x with _ => _ end = _ => destruct x as [got|number|clause] eqn:X end;
    try discriminate.
  2: { repeat match type of H with (if ?c then _ else _) = _ => destruct c; try discriminate end. }
  apply same in H as <-. assert (P : across_tool vt (perpendicular (P := plane_of_tool vt) a)) by now apply
    across_perpendicular.
  destruct r; try (apply same in X as <-; now repeat constructor).
  - apply same in X as <-. repeat constructor. destruct vt as [[x y] z]. unfold across_tool, dot3; cbn. ring.
  - apply bound in X as (group & G & X). apply same in X as <-. apply across_up_to_stop. now apply across_change in G.
  - apply bound in X as (group & G & X). apply same in X as <-. apply across_up_to_stop. apply across_cancel in G; auto.
    destruct group as [|v [|w rest]]; auto. destruct (without_perpendicular s); auto. now apply removed_last.
  - apply bound in X as (group & G & X). apply same in X as <-. apply across_start in G; auto.
    destruct group as [|v [|w rest]]; try (now apply across_up_to_stop).
    destruct (without_perpendicular s); apply across_up_to_stop; auto. now inversion G.
  - apply bound in X as (group & G & X). apply same in X as <-. apply across_up_to_stop. apply across_mode in G; auto.
    destruct group as [|v [|w [|x rest]]]; auto; destruct q as [[|p|p]|]; auto.
    destruct p as [p|p|]; auto. destruct p; auto. destruct (is_arc a || is_arc b); auto.
    inversion G; now repeat constructor.
Qed.

(** * A run *)

Lemma apart_is_part limit : forall (vs : list (head_vector R)) last kept, apart_from limit last vs = Got kept ->
  incl kept vs.
Proof.
  induction vs as [|[mine v] vs IH]; intros last kept H; cbn [apart_from] in H; [apply same in H as <-; easy|].
  apply bound in H as (over & _ & H). destruct over.
  - apply bound in H as (later & L & H). apply same in H as <-. apply IH in L.
    intros x [<-|I]; [now left|right; now apply L].
  - apply IH in H. intros x I. right. now apply H.
Qed.
Lemma kept_is_part (s : setup R) b vs kept : without_small_differences s b vs = Got kept -> incl kept vs.
Proof.
  unfold without_small_differences; intro H. destruct vs as [|v [|w rest]]; try (apply same in H as <-;
    apply incl_refl).
  apply bound in H as (negative & _ & H). apply bound in H as (half & _ & H).
  destruct half; [apply same in H as <-; apply incl_refl|].
  apply bound in H as (later & L & H). apply same in H as <-. apply apart_is_part in L.
  intros x [<-|I]; [now left|right; now apply L].
Qed.

(** The tool has a direction. *)
Definition has_tool (s : setup R) (b : planned R) : Prop := dot3 (tool_behind s b) (tool_behind s b) <> 0%R.

(** fanuc.tool-side.plane: every vector at the end of a block is at right angles to the tool there: of lines and arcs,
    at the start, at a change of side, in the mode and before the cancel. *)
Theorem side_vectors_across_the_tool (s : setup R) a rest v :
  has_tool s a -> standing_at_end s a rest = Got v -> heads_across (tool_behind s a) (heads v).
Proof.
  intros T H. unfold standing_at_end in H. apply bound in H as (zero & _ & H). apply bound in H as (negative & _ & H).
  apply bound in H as (f & _ & H). destruct f as [f|].
  - destruct zero.
    + apply same in H as <-. repeat constructor. destruct (tool_behind s a) as [[x y] z]. unfold across_tool, dot3; cbn.
      ring.
    + apply bound in H as (leg_a & A & H). apply legs_are_across in A; [|exact T].
      apply bound in H as (leg_b & B & H). apply legs_are_across in B; [|exact T].
      apply bound in H as (group & G & H). apply across_group in G; auto.
      apply bound in H as (kept & K & H). apply kept_is_part in K. apply bound in H as (u & _ & H).
      apply same in H as <-.
      cbn [heads]. unfold heads_across in *. rewrite Forall_forall in *. intros x I. apply G, K, I.
  - apply bound in H as (leg_a & A & H). apply legs_are_across in A; [|exact T]. apply same in H as <-.
    repeat constructor. now apply across_perpendicular.
Qed.

Lemma standing_tool : has_tool plain_setup standing_block.
Proof. unfold has_tool. cbn. lra. Qed.

Example side_vectors_across_the_tool_instance rest v :
  standing_at_end plain_setup standing_block rest = Got v -> heads_across (0, 0, 1)%R (heads v).
Proof. intro H. exact (side_vectors_across_the_tool plain_setup standing_block rest v standing_tool H). Qed.

Lemma start_across (s : setup R) b rest v : has_tool s b -> standing_at_start s b rest = Got v ->
  heads_across (tool_behind s b) (heads v).
Proof.
  intros T H. unfold standing_at_start in H. destruct rest as [|next rest]; [discriminate|].
  apply bound in H as (negative & _ & H). apply bound in H as (leg & L & H). apply legs_are_across in L; [|exact T].
  apply same in H as <-. repeat constructor. now apply across_perpendicular.
Qed.

Lemma dropped_are_parts (s : setup R) b : forall tries test vs ws vs' ws' line,
  dropped_pairs s tries b test vs ws = Got (vs', ws', line) -> incl vs' vs /\ incl ws' ws.
Proof.
  induction tries as [|tries IH]; intros test vs ws vs' ws' line H; cbn [dropped_pairs] in H.
  - apply same in H. injection H as <- <- _. split; apply incl_refl.
  - destruct vs as [|v vs], ws as [|w ws]; try (apply same in H; injection H as <- <- _; split; apply incl_refl).
    apply bound in H as (hit & _ & H). destruct (negb hit); [apply same in H; injection H as <- <- _; split;
      apply incl_refl|].
    destruct vs as [|v' vs], ws as [|w' ws]; try discriminate; apply IH in H as [V W]; split; intros x I;
      try (apply V in I); try (apply W in I); auto; now right.
Qed.

Lemma interference_drops (s : setup R) b v w v' w' line : interference s b v w = Got (v', w', line) ->
  incl (heads v') (heads v) /\ incl (heads w') (heads w).
Proof.
  unfold interference; intro H. destruct (bit s "5008#0"); [apply same in H; injection H as <- <- _; split;
    apply incl_refl|].
  apply bound in H as ([[vs ws] line'] & D & H). apply same in H. injection H as <- <- _.
  apply dropped_are_parts in D as [V W]. cbn [heads]. split; [|exact W].
  intros x I. apply in_rev in I. apply V in I. now apply in_rev.
Qed.

(** What is left of the vectors at the start of a block. *)
Lemma left_is_part (s : setup R) bs : forall v w, left_at_start (offset_from s (Some v) bs) = Some w ->
  incl (heads w) (heads v).
Proof.
  induction bs as [|b rest IH]; intros v w H; cbn [offset_from] in H; [injection H as <-; apply incl_refl|].
  destruct (starts_at_once s b).
  { destruct (standing_at_start s b rest); cbn [left_at_start] in H; try discriminate; injection H as <-;
      apply incl_refl. }
  destruct (makes_corner b).
  { match type of H with left_at_start (match ?x with _ => _ end) = _ => destruct x as [[[v' w']
      line]|number|clause] eqn:X end;
      cbn [left_at_start] in H; try (injection H as <-; apply incl_refl). subst v'.
    apply bound in X as (e & _ & X). apply bound in X as ([[v' e'] line'] & D & X). apply same in X.
    injection X as -> _ _.
    now apply interference_drops in D as [D _]. }
  destruct (made (side_at_end b)); [destruct (is_b_of b v)|]; cbn [left_at_start] in H.
  - injection H as <-. apply incl_refl.
  - now apply IH in H.
  - injection H as <-. apply incl_refl.
Qed.

(** The block of a vector makes it at its own end. *)
Definition vectors_across (s : setup R) (o : offset_block R) : Prop :=
  let '(b, at_end, _) := o in
  match at_end with Some v => heads_across (tool_behind s b) (heads v) | None => True end.

(** fanuc.tool-side.plane: so are all the vectors with which a plan is run, at the end of each of its blocks, behind the
    check of interference. *)
Theorem side_plan_across_the_tool (s : setup R) bs : Forall (has_tool s) bs ->
  forall at_start, Forall (vectors_across s) (compensated_blocks (offset_from s at_start bs)).
Proof.
  assert (PART : forall vt (hs hs' : list (head_vector R)), incl hs' hs -> heads_across vt hs -> heads_across vt hs').
  { intros vt hs hs' I F. unfold heads_across in *. rewrite Forall_forall in *. auto. }
  assert (LEFT : forall b v rest line, heads_across (tool_behind s b) (heads v) ->
    vectors_across s (b, left_at_start (offset_from s (Some v) rest), line)).
  { intros b v rest line A. unfold vectors_across. destruct (left_at_start (offset_from s (Some v) rest)) as [w|] eqn:L;
      [|exact I].
    apply left_is_part in L. now apply (PART _ (heads v)). }
  induction 1 as [|b rest T F IH]; intro at_start; cbn [offset_from]; [constructor|].
  destruct (starts_at_once s b).
  { destruct (standing_at_start s b rest) as [v| |] eqn:E; cbn [compensated_blocks]; constructor; auto.
    apply LEFT. now apply start_across in E. }
  destruct (makes_corner b).
  { match goal with |- context [match ?x with Got _ => _ | _ => _ end] => destruct x as [[[v w] line]| |] eqn:X end;
      cbn [compensated_blocks]; constructor; auto. apply LEFT.
    apply bound in X as (e & E & X). apply side_vectors_across_the_tool in E; [|exact T]. destruct at_start as [v0|].
    - apply bound in X as ([[v' e'] line'] & D & X). apply same in X. injection X as _ <- _.
      apply interference_drops in D as [_ D]. now apply (PART _ (heads e)).
    - apply same in X. injection X as _ <- _. exact E. }
  destruct (made (side_at_end b)), at_start as [v|]; [destruct (is_b_of b v)|..]; cbn [compensated_blocks];
    (constructor; [exact I|apply IH]).
Qed.

Example side_plan_across_the_tool_instance :
  Forall (vectors_across plain_setup) (compensated_blocks (offset_from plain_setup None [standing_block])).
Proof. apply side_plan_across_the_tool. repeat constructor. exact standing_tool. Qed.

(** * The value 0, and behind a cancel *)

Lemma perpendicular_of_none vt (a : leg_in R (triple R)) : rho a = 0%R ->
  perpendicular (P := plane_of_tool vt) a = (0, 0, 0)%R.
Proof.
  intro E. unfold perpendicular. rewrite E. cbn. destruct (normal a) as [[x y] z]. unfold scale3; cbn.
  f_equal; [f_equal|]; ring.
Qed.
Lemma rho_in_plane (s : setup R) vt b point rho_ a : leg_in_plane s vt b point rho_ = Got a -> rho a = rho_.
Proof.
  unfold leg_in_plane; intro H. destruct (arc_of_block b) as [[clockwise circle]|]; [apply bound in H as (? & _ & H)|];
    now apply same in H as <-.
Qed.

(** fanuc.cutter-c.value-zero: with the value 0 tool side compensation makes the vector zero alone, at every corner. *)
Theorem side_value_zero_is_programmed (s : setup R) a rest v :
  side_value (side_at_end a) = 0%R -> standing_at_end s a rest = Got v -> heads v = [(true, (0, 0, 0)%R)].
Proof.
  intros Z H. unfold standing_at_end in H. apply bound in H as (zero & O & H). apply zero_sign in O.
  assert (zero = true) as -> by now apply O.
  apply bound in H as (negative & N & H). apply negative_sign in N.
  assert (negative = false) as -> by (destruct negative; [exfalso; rewrite Z in N; assert (0 < 0)%R by (now apply N);
    lra|reflexivity]).
  apply bound in H as (f & _ & H). destruct f as [f|]; [now apply same in H as <-|].
  apply bound in H as (leg & L & H). apply rho_in_plane in L. apply same in H as <-. cbn [heads].
  rewrite perpendicular_of_none; [reflexivity|]. rewrite L, Z. unfold to_left. destruct (SideState.on_left _); cbn; lra.
Qed.

Example side_value_zero_is_programmed_instance rest v :
  standing_at_end plain_setup standing_block rest = Got v -> heads v = [(true, (0, 0, 0)%R)].
Proof. now apply side_value_zero_is_programmed. Qed.

Lemma own_go_inside {num} (b : planned num) m : own_go b = Some m -> In (Go m) (items b).
Proof.
  unfold own_go. induction (items b) as [|i rest IH]; cbn; [discriminate|].
  destruct i; try (intro H; right; now apply IH).
  intro H. injection H as <-. now left.
Qed.

(** fanuc.tool-side.cancel: a block behind which no vector is left ends where it is programmed, and so do those behind
    it. *)
Theorem side_cancelled_is_programmed {num} {N : Numbers num} (s : setup num) t b line b' t' :
  made (side_at_end b) = false -> Forall (bare_item s) (items b) ->
    SidePass.moves_of_block s t (b, None, line) = Got (b', t') ->
  Forall (own_without_head s) (items b') /\ (made (side (before b)) = true -> t' = at_point).
Proof.
  intros M B H. assert (OWN : Forall (own_without_head s) (items b)).
  { eapply Forall_impl; [|exact B]. intros [] E; cbn in *; auto. }
  unfold SidePass.moves_of_block, starts_at_once in H. rewrite M in H. rewrite andb_false_r in H. cbn [andb] in H.
  destruct (removes_at_once s b).
  - apply same in H. injection H as <- <-. split; [|reflexivity]. cbn [items with_items]. unfold move_at_once.
    assert (Z : head_of s (0%num, 0%num, 0%num) = zeros s) by apply zeros_of_space.
    rewrite Z. destruct (own_go b); [|destruct (made_zero _)]; repeat constructor; right; reflexivity.
  - destruct (own_go b) as [m|] eqn:G; [|apply same in H; injection H as <- <-; auto].
    cbn [orb] in H. destruct (made (side (before b))) eqn:MB; cbn [negb] in H; [|apply same in H; injection H as <- <-;
      split; [exact OWN|discriminate]].
    apply bound in H as (warning & _ & H). apply same in H. injection H as <- <-. split; [|reflexivity].
    cbn [items with_items]. apply Forall_app; split.
    + apply Forall_map, Forall_forall. intros v _. now left.
    + apply own_go_inside in G. rewrite Forall_forall in B. specialize (B _ G). cbn in B.
      constructor; [|constructor]. destruct (crosses (side_at_end b)); right; exact B.
Qed.

Example side_cancelled_is_programmed_instance t line b' t' :
  SidePass.moves_of_block plain_setup t (standing_block, None, line) = Got (b', t') ->
    Forall (own_without_head plain_setup) (items b').
Proof. intro H. apply side_cancelled_is_programmed in H as [H _]; [exact H|reflexivity|repeat constructor]. Qed.

(** * The side *)

(** A block with the other code and the negative value behind it: the tool is on the same side. *)
Definition other_code (b : planned R) : planned R :=
  let x := side (behind b) in
  Planned (at_place b) (command_of b) (before b)
    (with_side (behind b)
       (SideState (match side_in_force x with Some ToolLeft => Some ToolRight | Some ToolRight => Some ToolLeft |
         None => None end)
          (side_number x) (- side_value x)%R (asked x) (made x) (made_zero x) (crosses x) (SideState.on_left x)
            (since_start x)))
    (items b).

(** fanuc.cutter.side: G41.2 with a value has the tool on the side of G42.2 with its negative,
    and at the end of every block
    the same vectors. *)
Theorem side_of_negative_value (s : setup R) a rest (v : R) : v <> 0%R ->
  is_on_left (Some ToolLeft) (- v)%R = is_on_left (Some ToolRight) v /\
  standing_at_end s (other_code a) rest = standing_at_end s a rest.
Proof.
  intro D. split.
  - unfold is_on_left, is_negative. destruct (decides "fanuc.cutter.side" (- v)%R) as [c C],
      (decides "fanuc.cutter.side" v) as [c' C'].
    rewrite C, C'. apply decided in C, C'. destruct c, c'; try reflexivity; exfalso; lra.
  - unfold standing_at_end. change (side_value (side_at_end (other_code a))) with (- side_value (side_at_end a))%R.
    rewrite zero_either_way. destruct (is_zero "fanuc.cutter-c.value-zero" (side_value (side_at_end a))) as [zero| |];
      try reflexivity.
    cbn [bind].
    generalize (side_value (side_at_end a)) as x. intro x.
    assert (NEG : (- x < 0)%R -> is_negative "fanuc.cutter.side" (- x)%R = Got true /\
      is_negative "fanuc.cutter.side" x = Got false).
    { intro L. split; [|apply not_negative; lra]. unfold is_negative.
      destruct (decides "fanuc.cutter.side" (- x)%R) as [c C].
      rewrite C. apply decided in C. destruct c; try reflexivity; lra. }
    assert (POS : (x < 0)%R -> is_negative "fanuc.cutter.side" (- x)%R = Got false /\
      is_negative "fanuc.cutter.side" x = Got true).
    { intro L. split; [apply not_negative; lra|]. unfold is_negative. destruct (decides "fanuc.cutter.side" x) as [c C].
      rewrite C. apply decided in C. destruct c; try reflexivity; lra. }
    destruct (Rtotal_order x 0) as [L|[->|L]].
    + destruct (POS L) as [-> ->]. cbn [bind]. now replace (- x)%num with (- x)%R by (cbn; ring).
    + now rewrite Ropp_0.
    + destruct NEG as [-> ->]; [lra|]. cbn [bind]. now replace (- (- x)%R)%num with x by (cbn; ring).
Qed.

Example side_of_negative_value_instance rest :
  standing_at_end plain_setup (other_code standing_block) rest = standing_at_end plain_setup standing_block rest.
Proof. apply (side_of_negative_value plain_setup standing_block rest 1%R). lra. Qed.
