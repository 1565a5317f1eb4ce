(** The formal specification as OCaml, over numbers that whoever runs it gives. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZInt ExtrOcamlNativeString.
From Toolcomp Require Program KlartextProgram.
Extraction Language OCaml.
Extraction "formal.ml" Program.run_program.
Extraction "klartext_formal.ml" KlartextProgram.run_klartext.
