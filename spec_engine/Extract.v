(* SPDX-License-Identifier: Apache-2.0 *)
(** The formal specification as OCaml, over numbers that whoever runs it gives. Whole numbers are those of OCaml, and so are
    these operations on them and on texts: as Coq defines them they go through binary digits, or compare whatever it is. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZInt ExtrOcamlNativeString String ZArith.
From Toolcomp Require Case.
Extraction Language OCaml.
Extract Inlined Constant String.eqb => "Stdlib.String.equal".
Extract Constant Pos.compare => "fun (x : int) y -> if x = y then Eq else if x < y then Lt else Gt".
Extract Constant Pos.compare_cont => "fun c (x : int) y -> if x = y then c else if x < y then Lt else Gt".
Extract Constant Pos.eqb => "fun (x : int) y -> x = y".
Extract Constant Z.compare => "fun (x : int) y -> if x = y then Eq else if x < y then Lt else Gt".
Extract Constant Z.eqb => "fun (x : int) y -> x = y".
Extract Constant Z.leb => "fun (x : int) y -> x <= y".
Extract Constant Z.ltb => "fun (x : int) y -> x < y".
(** Toward minus infinity; what is left has the sign of the divisor. By 0 the quotient is 0. *)
Extract Constant Z.div => "fun a b ->
  if b = 0 then 0 else let r = a mod b in if r <> 0 && (r < 0) <> (b < 0) then a / b - 1 else a / b".
Extract Constant Z.modulo => "fun a b ->
  if b = 0 then a else let r = a mod b in if r <> 0 && (r < 0) <> (b < 0) then r + b else r".
Extract Constant Z.pow => "fun a n ->
  let rec times r k = if k = 0 then r else times (r * a) (k - 1) in if n < 0 then 0 else times 1 n".
Extraction "formal.ml" Case.run_case.
