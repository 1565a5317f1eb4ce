(** The formal specification as OCaml, over numbers that whoever runs it gives. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZInt ExtrOcamlNativeString.
From Toolcomp Require Program.
Extraction Language OCaml.
Extraction "formal.ml" Program.run_program.
