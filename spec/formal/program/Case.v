(* SPDX-License-Identifier: Apache-2.0 *)
(** Cases of both dialects: what is run, and what theorems about runs speak of. *)
From Coq Require Import List ZArith.
From Toolcomp Require Import Numbers Data FanucCase KlartextCase.
Open Scope Z_scope.

(** A case: its dialect (0 FANUC, 1 Klartext), setup, and the blocks of its program. *)
Definition run_case {num} {N : Numbers num} (case : data) : told num :=
  let case' := Tree (tl (entries case)) in
  if whole_of (entry_at case 0) =? 0 then run_fanuc case' else run_klartext_case case'.
