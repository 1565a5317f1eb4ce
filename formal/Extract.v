(** The formal specification as OCaml, over numbers that whoever runs it gives. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZInt ExtrOcamlNativeString.
From Toolcomp Require Case.
Extraction Language OCaml.
Extraction "formal.ml" Case.run_case.
