(* SPDX-License-Identifier: Apache-2.0 *)
(** Laws of the length offset that shifts the system, of G45 to G48 and of G37: the value 0, and the mirrored
    measurement. *)
From Coq Require Import List String ZArith Bool Reals Lra.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Coordinates Arcs LengthOffset ToolShift Measurement
  State.
From Toolcomp Require Import Movements OwnMove Compensation Program OutcomeLaws ProgramLaws.
Import ListNotations.
Open Scope string_scope.
Open Scope list_scope.

(** * The length offset *)

(** fanuc.length-offset.shifted-system: a position renamed by the change of the offset is where the axes stood: nothing
    moves. *)
Theorem renamed_position_stands (position before after : values R) :
  List.length before = List.length position -> List.length after = List.length position ->
  sum (difference position (difference after before)) after = sum position before.
Proof.
  revert before after. induction position as [|x position IH]; intros [|b before] [|a after] B A; try discriminate;
    [reflexivity|].
  injection B as B. injection A as A. specialize (IH before after B A). unfold sum, difference in *. cbn in *.
  f_equal; [ring|exact IH].
Qed.

Example renamed_position_stands_instance :
  sum (difference [0%R; 0%R; 100%R] (difference [0%R; 0%R; 10%R] [0%R; 0%R; 0%R])) [0%R; 0%R; 10%R] =
  sum [0%R; 0%R; 100%R] [0%R; 0%R; 0%R].
Proof. now apply renamed_position_stands. Qed.

(** * The tool offset *)

Lemma each_of {A B} (f : A -> outcome B) (g : A -> B) l : (forall a, f a = Got (g a)) -> each f l = Got (map g l).
Proof. intro E. induction l as [|a l IH]; [reflexivity|]. cbn. now rewrite E, IH. Qed.

Lemma nothing_grows (s : setup R) m b numbers from to : grown s m b 0%R numbers from to = Got (zeros s).
Proof.
  unfold grown, zeros. apply each_of. intro letter. destruct (Letter.linear letter && _); [|reflexivity].
  unfold sense. destruct (decides "fanuc.tool-offset.zero-travel" (value_on s to letter - value_on s from letter)%num)
    as [c C].
  rewrite C. cbn [bind]. do 2 f_equal. destruct c; [destruct (incremental m); [|reflexivity]|..]; cbn;
    try (destruct (negb _); cbn); try reflexivity; ring.
Qed.

(** fanuc.tool-offset.increase: on a straight block G45 to G48 with the value 0 do nothing. *)
Theorem tool_offset_zero_does_nothing (s : setup R) numbers b changed st :
  own_move s numbers b None changed (Some 0%R) st = own_move s numbers b None changed None st.
Proof. unfold own_move. now rewrite nothing_grows. Qed.

Example tool_offset_zero_does_nothing_instance :
  own_move plain_setup [None; None; Some 10%R] up None false (Some 0%R) (initial plain_setup) =
  own_move plain_setup [None; None; Some 10%R] up None false None (initial plain_setup).
Proof. apply tool_offset_zero_does_nothing. Qed.

(** * The measurement *)

Definition mirrored_path (p : measurement_path R) : measurement_path R :=
  MeasurementPath (option_map Ropp (rapid_to p)) (option_map Ropp (measuring_to p)) (- reached p)%R (in_zone p).

(** fanuc.length-measurement.rapid-part: measured from the other side everything is mirrored: where the rapid part ends,
    where the axis stops, and whether the signal was in the zone. *)
Theorem mirrored_measurement (s : setup R) (a d : R) signal :
  measure s (- a)%R (- d)%R (option_map Ropp signal) = mapped mirrored_path (measure s a d signal).
Proof.
  unfold measure.
  destruct (decides "fanuc.length-measurement.start-on-the-coordinate" (d - a)%R) as [c C].
  destruct (decides "fanuc.length-measurement.start-on-the-coordinate" (- d - - a)%R) as [c' C'].
  cbn [minus reals]. rewrite C, C'. apply decided in C, C'. cbn [bind].
  assert (SAME : forall clause x y, x = y -> is_positive clause (x : R) = is_positive clause y) by (intros; now subst).
  assert (SAME' : forall clause x y, x = y -> is_negative clause (x : R) = is_negative clause y) by (intros; now subst).
  destruct c, c'; try (exfalso; lra); [reflexivity|..].
  all: match goal with |- bind (is_positive ?k ?x) _ = mapped _ (bind (is_positive ?k ?y) _) =>
         rewrite (SAME k x y) by (cbn; ring); destruct (is_positive k y) as [far| |]; try reflexivity end.
  all: cbn [bind]; destruct signal as [p|]; cbn [option_map].
  all: try (cbn [mapped]; unfold mirrored_path; cbn; destruct far; cbn; repeat f_equal; ring).
  all: match goal with |- bind (is_positive ?k ?x) _ = mapped _ (bind (is_positive ?k ?y) _) =>
         rewrite (SAME k x y) by (destruct far; cbn; ring); destruct (is_positive k y) as [later| |];
           try reflexivity end.
  all: cbn [bind].
  all: match goal with |- bind (is_negative ?k ?x) _ = mapped _ (bind (is_negative ?k ?y) _) =>
         rewrite (SAME' k x y) by (destruct far, later; cbn; ring); destruct (is_negative k y) as [too_late| |];
           try reflexivity end.
  all: cbn [bind]; destruct too_late.
  all: try (cbn [mapped]; unfold mirrored_path; cbn; destruct far; cbn; repeat f_equal; ring).
  all: match goal with |- bind (is_negative ?k ?x) _ = mapped _ (bind (is_negative ?k ?y) _) =>
         rewrite (SAME' k x y) by (destruct far, later; cbn; ring); destruct (is_negative k y) as [too_early| |];
           try reflexivity end.
  all: cbn [bind mapped]; unfold mirrored_path; cbn; destruct far, later; cbn; repeat f_equal; ring.
Qed.

Example mirrored_measurement_instance :
  measure plain_setup (- 0)%R (- 200)%R (Some (- 100)%R) = mapped mirrored_path (measure plain_setup 0%R 200%R (Some
    100%R)).
Proof. apply (mirrored_measurement plain_setup 0 200 (Some 100%R)). Qed.
