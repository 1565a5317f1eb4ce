(* SPDX-License-Identifier: Apache-2.0 *)
(** fanuc/tool-offset: G45, G46, G47 and G48, which make a travel longer or shorter. *)
From Coq Require Import List String ZArith Bool PeanoNat.
From Toolcomp Require Import Numbers Outcomes Words Codes Memory Arcs LengthOffset.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(** fanuc.tool-offset.number: with OFH = 0 the D number, or with TPH = 1 the H number of the length offset; with OFH = 1
    the number that D and H both set. A number given by D reads the table of D, one given by H that of H. *)
Definition tph {num} (s : setup num) : bool := bit s "5001#5".
Definition by_h_number {num} (s : setup num) : bool := tph s && negb (ofh s).

(** The number of cutter compensation, and who has given it. *)
Definition shared_number := (number_by * Z)%type.

(** fanuc.cutter.number: that of the last D; with OFH = 1 an H gives it as well; of a D and an H in one block the D
    counts. *)
Definition next_shared {num} (s : setup num) (d h : option Z) (before : shared_number) : shared_number :=
  match d, h with
  | Some number, _ => (ByD, number)
  | None, Some number => if ofh s then (ByH, number) else before
  | None, None => before
  end.

(** fanuc.tool-offset.double, fanuc.tool-offset.increase: what the travel is made longer by, by the offset value. *)
Definition lengthening {num} {N : Numbers num} (code : option action) (l : num) : option num :=
  match code with
  | Some Lengthen => Some l
  | Some Shorten => Some (- l)%num
  | Some LengthenTwice => Some (integer 2 * l)%num
  | Some ShortenTwice => Some (- (integer 2 * l))%num
  | _ => None
  end.

(** The sense of a travel: none where the axis does not move.
    fanuc.tool-offset.zero-travel, fanuc.tool-offset.sign-of-zero: in G91 a travel of zero has the sense of the sign
    written before it; in G90 the axis does not move. *)
Definition sense {num} {N : Numbers num} (incremental minus_written : bool) (travel : num) : outcome (option bool) :=
  c <- decide "fanuc.tool-offset.zero-travel" travel ;;
  Got (match c with
       | Gt => Some true
       | Lt => Some false
       | Eq => if incremental then Some (negb minus_written) else None
       end).

(** fanuc.tool-offset.direction, fanuc.tool-offset.travel: the offset is added to the magnitude of the travel. By how much
    the shift of an axis grows. *)
Definition growth {num} {N : Numbers num} (longer : num) (s : option bool) : num :=
  match s with Some true => longer | Some false => (- longer)%num | None => 0%num end.

(** fanuc.tool-offset.arc-form: of the two letters of the plane exactly one is not zero, its value is the component of the
    end on its axis, and the other component has the same magnitude. Whether the centre lies along the first axis. *)
Definition quarter {num} {N : Numbers num} (to_center travel : pair num) : outcome (option bool) :=
  let clause := "fanuc.tool-offset.arc-form" in
  let form along across :=
    same <- is_zero clause (fst along - snd along)%num ;;
    magnitude <- is_zero clause (fst along * fst along - across * across)%num ;;
    Got (same && magnitude) in
  no_first <- is_zero clause (fst to_center) ;;
  no_second <- is_zero clause (snd to_center) ;;
  match no_first, no_second with
  | false, true => ok <- form (fst to_center, fst travel) (snd travel) ;; Got (if ok : bool then Some true else None)
  | true, false => ok <- form (snd to_center, snd travel) (fst travel) ;; Got (if ok : bool then Some false else None)
  | _, _ => Got None
  end.

(** With its sense, a magnitude. *)
Definition toward {num} {N : Numbers num} (component magnitude : num) : outcome num :=
  back <- is_negative "fanuc.tool-offset.arc" component ;;
  Got (if back : bool then (- magnitude)%num else magnitude).

(** fanuc.tool-offset.arc: the component that gives the centre, and both components of the end, are lengthened alike. The
    tool's arc begins where the tool stands, has the direction and the sweep of the programmed one, and one radius.
    fanuc.tool-offset.arc-radius: a radius made smaller than zero raises PS0038; one of zero has no sweep.
    The vector to the centre, that to the end, and the sweep. *)
Definition longer_arc {num} {N : Numbers num} (longer : num) (to_center travel : pair num) (swept : option num) :
    outcome (pair num * pair num * option num) :=
  form <- quarter to_center travel ;;
  match form with
  | None => Alarm "tool-offset-arc"
  | Some first =>
      let radius_vector := if first then fst to_center else snd to_center in
      back <- is_negative "fanuc.tool-offset.arc" radius_vector ;;
      let radius := if back : bool then (- radius_vector)%num else radius_vector in
      let new_radius := (radius + longer)%num in
      negative <- is_negative "fanuc.tool-offset.arc-radius" new_radius ;;
      _ <- alarm_if negative "arc-ends-in-center" ;;
      nothing <- is_zero "fanuc.tool-offset.arc-radius" new_radius ;;
      along <- toward radius_vector new_radius ;;
      x <- toward (fst travel) new_radius ;;
      y <- toward (snd travel) new_radius ;;
      Got (if first then (along, 0%num) else (0%num, along), (x, y), if nothing : bool then None else swept)
  end.
