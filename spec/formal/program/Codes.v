(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/program: what the G codes of a block select. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** Codes in tenths: 430 is G43, 434 is G43.4. *)
Definition among (code : Z) (codes : list Z) : bool := existsb (Z.eqb code) codes.

(** fanuc.program.without-effect: they change nothing. *)
Definition without_effect := [50; 51; 80; 90; 110; 131; 150; 220; 230; 250; 401; 500; 501; 502; 610; 611; 620; 630; 640;
  670; 690; 960; 970; 1130; 1500; 1600].

(** fanuc.program.unknown-code: supported are these. *)
Definition known := [0; 10; 20; 30; 40; 100; 170; 180; 190; 200; 210; 280; 290; 300; 301; 370; 390; 400; 410; 412; 413;
  416; 420; 422; 426; 430; 434; 435; 440; 450; 460; 470; 480; 490; 520; 530; 540; 541; 550; 560; 570; 580; 590; 730;
  740; 760; 800; 810; 820; 830; 840; 850; 860; 870; 880; 890; 900; 910; 920; 930; 940; 950; 980; 990] ++ without_effect.

(** fanuc.program.last-code-of-group: modal groups. *)
Definition motions := [0; 10; 20; 30].
Definition planes := [170; 180; 190].
Definition units := [200; 210].
Definition distances := [900; 910].
Definition feeds := [930; 940; 950].
Definition lengths := [430; 434; 435; 440; 490].
Definition systems := [540; 541; 550; 560; 570; 580; 590].
Definition compensations := [400; 410; 412; 413; 416; 420; 422; 426].
Definition cycles := [730; 740; 760; 800; 810; 820; 830; 840; 850; 860; 870; 880; 890].
Definition return_levels := [980; 990].

(** The codes that act in their block alone, of which the last counts. *)
Inductive action :=
| Dwell                 (* G04 *)
| DataInput             (* G10 *)
| FirstReference        (* G28 *)
| ReturnFromReference   (* G29 *)
| Measure               (* G37 *)
| CornerArc             (* G39 *)
| OtherReference        (* G30 *)
| FloatingReference     (* G30.1 *)
| Lengthen              (* G45 *)
| Shorten               (* G46 *)
| LengthenTwice         (* G47 *)
| ShortenTwice          (* G48 *)
| LocalSystem           (* G52 *)
| MachinePosition       (* G53 *)
| SetPosition.          (* G92 *)
Definition actions := [(40, Dwell); (100, DataInput); (280, FirstReference); (290, ReturnFromReference);
  (300, OtherReference); (301, FloatingReference); (370, Measure); (390, CornerArc); (450, Lengthen);
  (460, Shorten); (470, LengthenTwice); (480, ShortenTwice); (520, LocalSystem); (530, MachinePosition); (920, SetPosition)].

(** The codes of a block, in their order; none where one does not exist. *)
Definition codes_of {num} (b : block num) : option (list Z) :=
  fold_right
    (fun w rest =>
      match address w, tenths w, rest with
      | Letter.G, Some code, Some codes => if among code known then Some (code :: codes) else None
      | Letter.G, _, _ => None
      | _, _, _ => rest
      end)
    (Some []) (words b).

(** fanuc.program.address-repeated: an address other than G, M, N and O twice, or two codes of one group. *)
Definition repeats {num} (codes : list Z) (b : block num) : bool :=
  let counted (w : word num) := match address w with Letter.G | Letter.M | Letter.N | Letter.O => false | _ => true end in
  let same (a w : word num) := Letter.eqb (address a) (address w) in
  let fix twice (ws : list (word num)) : bool :=
    match ws with [] => false | w :: rest => (counted w && existsb (same w) rest) || twice rest end in
  twice (words b) ||
  existsb (fun group => 1 <? Z.of_nat (List.length (filter (fun code => among code group) codes)))
    [motions; planes; units; distances; feeds; lengths; systems; compensations; cycles; return_levels; map fst actions].

(** The last code of a group. *)
Definition last_of (group codes : list Z) : option Z := find (fun code => among code group) (rev codes).
Definition action_of (codes : list Z) : option action :=
  match last_of (map fst actions) codes with Some code => lookup code actions | None => None end.

(** fanuc.program.stops-reading-ahead: M00, M01, M02 and M30, and the M codes of parameters; one that is not given is 0. *)
Definition stopping_codes :=
  ["3411"; "3412"; "3413"; "3414"; "3415"; "3416"; "3417"; "3418"; "3419"; "3420"].
Definition stopping_ranges :=
  [("3421", "3422"); ("3423", "3424"); ("3425", "3426"); ("3427", "3428"); ("3429", "3430"); ("3431", "3432")].
Definition is_stopping_code {num} (s : setup num) (code : Z) : bool :=
  let given number := or_else (whole_parameter s number) 0 in
  among code [0; 1; 2; 30] || existsb (fun number => code =? given number) stopping_codes ||
  existsb (fun range => (given (fst range) <=? code) && (code <=? given (snd range))) stopping_ranges.
Definition stops_look_ahead {num} (s : setup num) (b : block num) : bool :=
  existsb (fun w => match address w, whole w with Letter.M, Some code => is_stopping_code s code | _, _ => false end)
    (words b).

(** fanuc.cutter-c.two-non-motion-blocks, fanuc.tool-side.look-ahead: how many blocks are read at a time in the mode of a
    compensation, the one before a corner included: three on the 16i, by No. 19625 on the 30i, never fewer. One less end
    that block where they do not move. *)
Definition blocks_read {num} (s : setup num) : Z :=
  if series_30i s then Z.max 3 (or_else (whole_parameter s "19625") 3) else 3.
Definition idle_limit {num} (s : setup num) : Z := blocks_read s - 1.

(** fanuc.program.letters-as-data: axis letters and I J K are data of these codes, not positions. *)
Definition takes_letters (codes : list Z) : bool := existsb (fun code => among code [40; 50; 51; 100; 220; 501]) codes.

(** What is in force until another code of its group comes. *)
Record modes := Modes {
  motion : travel;
  in_plane : plane;
  in_inches : bool;
  incremental : bool;
  feed_per_minute : bool
}.

(** fanuc.program.initial-state: G00 G17 G90 G94, in the units of the setup. *)
Definition initial_modes (setup_in_inches : bool) : modes := Modes Rapid XY setup_in_inches false true.

(** With the codes of a block. *)
Definition select (codes : list Z) (m : modes) : modes :=
  let chosen {A} (group : list Z) (names : list A) (before : A) :=
    match last_of group codes with
    | Some code => or_else (lookup code (combine group names)) before
    | None => before
    end in
  Modes
    (chosen motions [Rapid; Linear; Clockwise; Counterclockwise] (motion m))
    (chosen planes [XY; ZX; YZ] (in_plane m))
    (chosen units [true; false] (in_inches m))
    (chosen distances [false; true] (incremental m))
    (chosen feeds [false; true; false] (feed_per_minute m)).

(** fanuc.program.units: a linear word is converted by the exact factor 25.4.
    fanuc.program.least-increments: with 3401#0 = 0 a number without decimal point counts least input increments, in inch
    input a tenth of them for linear words. *)
Definition in_setup_units {num} {N : Numbers num} (s : setup num) (in_inches : bool) (x : num) : num :=
  match in_inches, inches s with
  | true, false => (x * integer 254 / integer 10)%num
  | false, true => (x * integer 10 / integer 254)%num
  | _, _ => x
  end.

Definition counts_increments {num} (s : setup num) (w : word num) : bool :=
  negb (or_else (parameter_bit s "3401#0") true) && negb (point w) &&
  match address w with
  | Letter.X | Letter.Y | Letter.Z | Letter.A | Letter.B | Letter.C | Letter.U | Letter.V | Letter.W
  | Letter.I | Letter.J | Letter.K | Letter.R => true
  | _ => false
  end.

Definition rotary (letter : Letter.t) : bool := match letter with Letter.A | Letter.B | Letter.C => true | _ => false end.

Definition number_of {num} {N : Numbers num} (s : setup num) (in_inches : bool) (w : word num) : num :=
  let linear := negb (rotary (address w)) in
  let x :=
    if counts_increments s w then
      let x := (value w / integer (match least_increment s with IS_A => 100 | IS_B => 1000 | IS_C => 10000 end))%num in
      if linear && in_inches then (x / integer 10)%num else x
    else value w in
  if linear then in_setup_units s in_inches x else x.

(** The number of the last word with this letter. *)
Definition last_number {num} {N : Numbers num} (s : setup num) (in_inches : bool) (letter : Letter.t) (b : block num) :
    option num :=
  option_map (number_of s in_inches) (last_word letter (words b)).

(** The words of the controlled axes. *)
Definition axis_numbers {num} {N : Numbers num} (s : setup num) (in_inches : bool) (b : block num) : some_values num :=
  map (fun letter => last_number s in_inches letter b) (axes s).
