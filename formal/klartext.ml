(* Klartext programs between the extracted specification and who runs it: as run.ml, with its data and numbers. *)

open Run
module K = Klartext_formal

let numbers : number K.numbers =
  {
    K.integer;
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
        | 0 -> Some K.Eq
        | 1 -> Some K.Gt
        | -1 -> Some K.Lt
        | _ -> None);
  }

let letters =
  K.Letter.
    [| A; B; C; D; E; F; G; H; I; J; K; L; M; N; O; P; Q; R; S; T; U; V; W; X; Y; Z |]

let letter d = letters.(int d)
let optional read d = match list d with [] -> None | [ x ] -> Some (read x) | _ -> broken ()
let each read d = List.map read (list d)

let parameter kind index = { K.kind = [| K.OfQ; OfQL; OfQR |].(int kind); index = int index }

let written d =
  match list d with
  | [ x ] -> K.Literal (number x)
  | [ kind; index; minus ] -> K.OfParameter (parameter kind index, bool minus)
  | _ -> broken ()

let deltas read d =
  match list d with
  | [ l; r; r2 ] -> { K.of_length = read l; of_radius = read r; of_corner = read r2 }
  | _ -> broken ()

let axis_word d =
  match list d with
  | [ axis; i; v ] -> { K.axis_letter = letter axis; with_i = bool i; amount = written v }
  | _ -> broken ()

let feed d =
  match list d with
  | [ kind; v ] -> (
      match int kind with 0 -> K.FValue (written v) | 1 -> FMax | 2 -> FAuto | _ -> FZOrFU)
  | _ -> broken ()

let radius d = [| K.R0; RL; RR |].(int d)
let vector d = match values d with [ x; y; z ] -> ((x, y), z) | _ -> broken ()

let words axes r f digits =
  {
    K.axis_words = each axis_word axes;
    radius_given = optional radius r;
    feed_given = optional feed f;
    many_digits = bool digits;
  }

let tool d =
  match list d with
  | [] -> K.NoToolWord
  | [ kind; number; name ] -> (
      match int kind with
      | 0 -> ByNumber (int number)
      | 1 -> ByName (text name)
      | _ -> ByStringParameter)
  | _ -> broken ()

let table d = [| K.Tcs; Wpl; BothTables |].(int d)

(* The statements that are not empty, in the order of klartext.cpp. *)
let statement d =
  match list d with
  | [] -> K.OtherStatement
  | kind :: rest -> (
      match (int kind, rest) with
      | 0, [ inch ] -> BeginProgram (bool inch)
      | 1, [] -> EndProgram
      | 2, [ called; axis; ds; f ] ->
          ToolCall (tool called, optional letter axis, deltas (optional written) ds, optional feed f)
      | 3, [ axes; r; f; digits ] -> Line (words axes r f digits)
      | 4, [ axes; r; f; digits; normal; direction ] ->
          LineWithVectors (words axes r f digits, optional vector normal, optional vector direction)
      | 5, [ reference ] -> FunctionTcpm [| K.TipTip; TipCenter; CenterCenter |].(int reference)
      | 6, [] -> ResetTcpm
      | 7, [ contour ] -> ProgPath (bool contour)
      | 8, [ t; row ] -> CorrectionRow (table t, int row)
      | 9, [ t ] -> CorrectionReset (table t)
      | 10, [ number; part; axes ] -> Cycle (int number, int part, each axis_word axes)
      | 11, [ kind; index; v ] -> Assignment (parameter kind index, written v)
      | _ -> broken ())

let block d =
  match list d with
  | [ alarm; functions; says ] ->
      {
        K.says = statement says;
        functions = each int functions;
        not_read = (if text alarm = "" then None else Some (text alarm));
      }
  | _ -> broken ()

let point d = match list d with [ a; v ] -> (number a, number v) | _ -> broken ()

let tool_row d =
  match list d with
  | [ n; name; r; r2; l; ds; points ] ->
      {
        K.tool_number = int n;
        tool_name = text name;
        radius = number r;
        corner_radius = number r2;
        overall_length = optional number l;
        in_table = deltas number ds;
        deviations = optional (each point) points;
      }
  | _ -> broken ()

let correction_row d =
  match list d with [ n; ds ] -> (int n, deltas number ds) | _ -> broken ()

let setup d =
  match list d with
  | [ axes; inch; start; tools; corrections ] ->
      {
        K.letters = each letter axes;
        in_inch = bool inch;
        start_at = values start;
        tools = each tool_row tools;
        correction_rows = each correction_row corrections;
      }
  | _ -> broken ()

let vector_of ((x, y), z) = numbers_of [ x; y; z ]
let flag b = Integer (if b then 1 else 0)

let contact (c : number K.contact) =
  List
    [
      vector_of c.contact_point;
      vector_of c.contact_normal;
      flag c.on_flat;
      option (fun x -> Number x) c.contact_degrees;
    ]

let cause = function K.StartUp -> 1 | Cancelling -> 3 | _ -> 0

let move (m : number K.klartext_move) =
  [
    flag m.is_rapid;
    Integer (cause m.why);
    numbers_of m.programmed_values;
    numbers_of m.tip_values;
    List (List.map (option (fun x -> Number x)) m.sent_to);
    vector_of m.direction_of_tool;
    vector_of m.center_of_tool;
    vector_of m.shift_of_tip;
    vector_of m.shift_of_tool;
    option vector_of m.carrier_point;
    option contact m.touching;
    option (fun f -> Number f) m.feed_of_move;
  ]

let event (place, e) =
  List
    (Integer place
    ::
    (match e with
    | K.Moved m -> Integer 0 :: move m
    | Warning name -> [ Integer 1; Text name ]
    | AlarmRaised name -> [ Integer 2; Text name ]
    | SignOpen clause -> [ Integer 3; Text clause ]
    | OutOfScope -> [ Integer 4 ]
    | NotSaidYet what -> [ Integer 5; Text what ]))

let run setup_data blocks =
  match K.run_klartext numbers (setup setup_data) (each block blocks) with
  | events -> List [ List (List.map event events); Text "" ]
  | exception Undecided_operand -> List [ List []; Text "an operand whose sign cannot be certified" ]

let () = Callback.register "toolcomp_formal_klartext" run
