(* SPDX-License-Identifier: Apache-2.0 *)
(** The compensations of a plan, one behind the other. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes State Movements CutterB CutterC SidePass EdgePass ControlMoves.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** fanuc.cutter.kind: the setup decides between B and C. *)
Definition cutter_pass {num} {N : Numbers num} (s : setup num) (p : plan num) : passed num :=
  if cutter_b s then pass_b s p else pass_c s p.

(** What is done with a plan, in this order. *)
Definition passes {num} {N : Numbers num} (s : setup num) : list (plan num -> passed num) :=
  [cutter_pass s; side_pass s; edge_pass s; control_pass s].

(** All of them, until one ends the run. *)
Fixpoint through {num} (passes : list (plan num -> passed num)) (p : plan num) : passed num :=
  match passes with
  | [] => Through p
  | pass :: rest => match pass p with Through p' => through rest p' | ended => ended end
  end.

(** fanuc.cutter.order-of-alarms: where a compensation ends the run, the blocks before that block are given as if it and
    everything after it were absent, and an alarm that then appears in an earlier block ends the run instead. *)
Fixpoint until_it_runs {num} {N : Numbers num} (s : setup num) (tries : nat) (p : plan num) : plan num :=
  match tries, through (passes s) p with
  | _, Through p' => p'
  | O, AsIfAbsent _ how => ([], how)
  | S fewer, AsIfAbsent from how =>
      until_it_runs s fewer (filter (fun b => Nat.ltb (at_place b) from) (fst p), how)
  end.

(** Each try leaves a block out. *)
Definition compensated {num} {N : Numbers num} (s : setup num) (p : plan num) : plan num :=
  until_it_runs s (List.length (fst p)) p.
