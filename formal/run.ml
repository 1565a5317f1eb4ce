(* Between the extracted specification and who runs it: setups, blocks and events as plain data, numbers as model/exact
   has them. Nothing here knows what a program means. *)

type number

external integer : int -> number = "toolcomp_formal_integer"
external plus : number -> number -> number = "toolcomp_formal_plus"
external minus : number -> number -> number = "toolcomp_formal_minus"
external times : number -> number -> number = "toolcomp_formal_times"
external over : number -> number -> number = "toolcomp_formal_over"
external root : number -> number = "toolcomp_formal_root"
external sine : number -> number = "toolcomp_formal_sine"
external cosine : number -> number = "toolcomp_formal_cosine"
external arctangent : number -> number = "toolcomp_formal_arctangent"
external half_turn : unit -> number = "toolcomp_formal_half_turn"

(* -1, 0, 1; 2: not decided. *)
external sign : number -> int = "toolcomp_formal_sign"

(* An operation whose operand has no certified sign (division, root). *)
exception Undecided_operand

let () = Callback.register_exception "toolcomp_formal_undecided" Undecided_operand

(* The tags are those of Data in engine.cpp. *)
type data = Number of number | Integer of int | Text of string | List of data list

let numbers : number Formal.numbers =
  {
    Formal.integer;
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

let broken () = invalid_arg "toolcomp: data of another form"
let list = function List l -> l | _ -> broken ()
let number = function Number x -> x | _ -> broken ()
let int = function Integer i -> i | _ -> broken ()
let text = function Text s -> s | _ -> broken ()
let bool d = int d = 1
let values d = List.map number (list d)

let letters =
  Formal.Letter.
    [| A; B; C; D; E; F; G; H; I; J; K; L; M; N; O; P; Q; R; S; T; U; V; W; X; Y; Z |]

let letter d = letters.(int d)

let word d =
  match list d with
  | [ address; value; tenths; negative; point ] ->
      {
        Formal.address = letter address;
        value = number value;
        tenths = (if int tenths < 0 then None else Some (int tenths));
        negative = bool negative;
        point = bool point;
      }
  | _ -> broken ()

let block d =
  match list d with
  | [ alarm; words ] ->
      {
        Formal.words = List.map word (list words);
        unreadable = (if text alarm = "" then None else Some (text alarm));
      }
  | _ -> broken ()

let numbered value d =
  match list d with n :: rest -> (int n, value rest) | [] -> broken ()

let offset = function
  | [ geometry; wear ] -> (number geometry, number wear)
  | _ -> broken ()

let table value d = List.map (numbered value) (list d)
let position = function [ v ] -> values v | _ -> broken ()

let maybe d = match list d with [] -> None | [ x ] -> Some (number x) | _ -> broken ()

(* By their names. *)
let named value d =
  let known = Hashtbl.create 16 in
  List.iter
    (fun b ->
      match list b with
      | [ name; x ] -> Hashtbl.replace known (text name) (value x)
      | _ -> broken ())
    (list d);
  Hashtbl.find_opt known

let setup d =
  match list d with
  | [ axes; inches; increment; bits_given; parameters; natural; memory; count; h; d; g49; workpiece; external_; additional; start;
      reference; floating; signals; as_programmed; parts ] ->
      {
        Formal.axes = List.map letter (list axes);
        inches = bool inches;
        least_increment = [| Formal.IS_A; IS_B; IS_C |].(int increment);
        parameter_bit = named bool bits_given;
        parameter = named number parameters;
        whole_parameter = named int natural;
        memory = [| Formal.MemoryA; MemoryB; MemoryC |].(int memory);
        offset_count = int count;
        h_offsets = table offset h;
        d_offsets = table offset d;
        g49_sets_h0 = bool g49;
        workpiece = List.map values (list workpiece);
        external0 = values external_;
        additional = table position additional;
        start = values start;
        reference = table position reference;
        floating = values floating;
        signal_at = List.map maybe (list signals);
        angles_as_programmed = bool as_programmed;
        parts_of_block = int parts;
      }
  | _ -> broken ()

let numbers_of v = List (List.map (fun x -> Number x) v)
let option f = function None -> List [] | Some x -> List [ f x ]
let travel = function Formal.Rapid -> 0 | Linear -> 1 | Clockwise -> 2 | Counterclockwise -> 3
let cause = function
  | Formal.Programmed -> 0
  | StartUp -> 1
  | Corner -> 2
  | Cancelling -> 3
  | PreTurn -> 4
  | PostTurn -> 5
  | Reference -> 6
  | Measuring -> 7

let plane = function Formal.XY -> 0 | ZX -> 1 | YZ -> 2

let arc (a : number Formal.arc) =
  let x, y = a.center in
  List
    [
      numbers_of [ x; y ];
      Integer (plane a.arc_plane);
      option (fun s -> Number s) a.sweep;
      option (fun (r, s) -> numbers_of [ r; s ]) a.radii;
    ]

let move (m : number Formal.move) =
  [
    Integer (travel m.travel_of);
    Integer (cause m.cause_of);
    numbers_of m.programmed_end;
    numbers_of m.tool_point;
    numbers_of m.axis_positions;
    option numbers_of m.machine_positions;
    option arc m.arc_of;
    option (fun f -> Number f) m.feed_of;
    option (fun ((x, y), z) -> numbers_of [ x; y; z ]) m.tool_axis;
  ]

let event (place, e) =
  List
    (Integer place
    ::
    (match e with
    | Formal.Moves m -> Integer 0 :: move m
    | Setting (name, value) -> [ Integer 1; Text name; Number value ]
    | Raised number -> [ Integer 2; Text number ]
    | NotDecided clause -> [ Integer 3; Text clause ]
    | Warned name -> [ Integer 4; Text name ]
    | Sampled ((numerator, denominator), point, positions, ((x, y), z)) ->
        [ Integer 5; Integer numerator; Integer denominator; numbers_of point; numbers_of positions; numbers_of [ x; y; z ] ]))

(* The events, and what the specification does not say; empty: nothing. *)
let run setup_data blocks =
  match
    Formal.run_program numbers string_of_int (setup setup_data) (List.map block (list blocks))
  with
  | events, ending ->
      List
        [
          List (List.map event events);
          Text (match ending with Formal.NotSaid what -> what | _ -> "");
        ]
  | exception Undecided_operand -> List [ List []; Text "an operand whose sign cannot be certified" ]

let () = Callback.register "toolcomp_formal_run" run
