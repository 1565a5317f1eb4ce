(* Between the extracted specification and who runs it: trees, and numbers as model/exact has them. *)

type number

external integer : int -> number = "toolcomp_spec_engine_integer"
external plus : number -> number -> number = "toolcomp_spec_engine_plus"
external minus : number -> number -> number = "toolcomp_spec_engine_minus"
external times : number -> number -> number = "toolcomp_spec_engine_times"
external over : number -> number -> number = "toolcomp_spec_engine_over"
external root : number -> number = "toolcomp_spec_engine_root"
external sine : number -> number = "toolcomp_spec_engine_sine"
external cosine : number -> number = "toolcomp_spec_engine_cosine"
external arctangent : number -> number = "toolcomp_spec_engine_arctangent"
external half_turn : unit -> number = "toolcomp_spec_engine_half_turn"

(* -1, 0, 1; 2: not decided. *)
external sign : number -> int = "toolcomp_spec_engine_sign"

(* An operation whose operand has no certified sign (division, root). *)
exception Undecided_operand

let () = Callback.register_exception "toolcomp_spec_engine_undecided" Undecided_operand

(* Small ones are asked for all the time. *)
let small = Array.init 1024 integer
let whole i = if 0 <= i && i < Array.length small then small.(i) else integer i

let numbers : number Formal.numbers =
  {
    Formal.integer = whole;
    plus;
    minus;
    times;
    over;
    root;
    sine;
    cosine;
    arctangent;
    half_turn = half_turn ();
    sign =
      (fun x ->
        match sign x with
        | 0 -> Some Formal.Eq
        | 1 -> Some Formal.Gt
        | -1 -> Some Formal.Lt
        | _ -> None);
  }

(* The kinds of Data in data.h, in their order. *)
type data = Number of number | Integer of int | Text of string | List of data list

let rec case_of = function
  | Integer i -> Formal.Whole i
  | Text s -> Formal.Text s
  | List l -> Formal.Tree (List.map case_of l)
  | Number _ -> invalid_arg "toolcomp: a case is made of whole numbers and texts"

let rec said = function
  | Formal.Number x -> Number x
  | Says i -> Integer i
  | Names s -> Text s
  | Several parts -> List (List.map said parts)

(* The events, and why there are none. *)
let run case =
  match Formal.run_case numbers (case_of case) with
  | events -> List [ said events; Text "" ]
  | exception Undecided_operand -> List [ List []; Text "an operand whose sign cannot be certified" ]
  | exception Stack_overflow -> List [ List []; Text "a program of that many blocks" ]

let () = Callback.register "toolcomp_spec_engine_run" run
