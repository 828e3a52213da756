(* The extracted search of Search.v and Occlusion.v as a program: it reads step tables, tests/trace/step_table.hpp, and
   says of each what the search has found, what it publishes, and which elements block a ray and a segment.

   Input: a line of limits, in C's hexadecimal; then a table a line, all in integers:
     elements findings parameters                               how many
     num coef rad den low high rounded                          of each parameter; low and high are places of limits
     triage_low triage_high stable_low stable_high rank certainly_less...      of each finding; 0 or 1 by finding
     in_range triage... stable... improved... rounded... reach  of each element: the steps by limit; the others by finding
   A step says -1, a miss; -2, undecided; or a finding. What is rounded is -1, uncertain, or its name. A reach is -1,
   nothing; -2, no minimum; or a parameter. The elements are tested in their order.
   Output, a line a table:
     LIMIT; ELEMENT and t, s or x by its evidence...; ELEMENT...; miss | hit NAME ELEMENT... | none ELEMENT...; 01...; 01... *)

module S = Search

(* As Flocq writes it: the significand has 53 bits, or the exponent is the least. *)
let binary64 x : S.binary_float =
  let sign = Float.sign_bit x in
  match Float.classify_float x with
  | FP_zero -> B754_zero sign
  | FP_infinite -> B754_infinity sign
  | FP_nan -> B754_nan
  | FP_normal | FP_subnormal ->
      let exponent = max (snd (Float.frexp x) - 53) (-1074) in
      B754_finite (sign, Z.of_float (Float.ldexp (Float.abs x) (-exponent)), Z.of_int exponent)

type element = { in_range : bool; triage : int array; stable : int array; improved : int array; rounded : int array; reach : int }
type finding = { triage_ends : int * int; stable_ends : int * int; rank : int; certainly_less : int array }
type parameter = { surd : S.surd; ends : int * int; name : int }

let verdict = function -1 -> S.Miss | -2 -> S.Undecided | finding -> S.Hit finding

let digits block elements = String.concat "" (List.map (fun e -> if block e then "1" else "0") elements)

let answer limits next =
  let many count read = Array.init count (fun _ -> read ()) in
  let elements = next () in
  let findings = next () in
  let parameters = next () in
  let pair () = let low = next () in (low, next ()) in
  let parameters = many parameters (fun () ->
    let num = next () in let coef = next () in let rad = next () in let den = next () in
    let ends = pair () in
    { surd = { num = Z.of_int num; coef = Z.of_int coef; rad = Z.of_int rad; den = Z.of_int den }; ends; name = next () }) in
  let findings_read = many findings (fun () ->
    let triage_ends = pair () in let stable_ends = pair () in let rank = next () in
    { triage_ends; stable_ends; rank; certainly_less = many findings next }) in
  let rows = many elements (fun () ->
    let in_range = next () = 1 in
    let triage = many (Array.length limits) next in let stable = many (Array.length limits) next in
    let improved = many findings next in let rounded = many findings next in
    { in_range; triage; stable; improved; rounded; reach = next () }) in
  let place x =
    let rec look i = if limits.(i) = x then i else look (i + 1) in
    look 0 in
  let of_surd x = List.find (fun p -> p.surd = x) (Array.to_list parameters) in
  let ends = function
    | S.By_triage f -> findings_read.(f).triage_ends
    | S.By_stable f -> findings_read.(f).stable_ends
    | S.By_exact x -> (of_surd x).ends in
  let low v = limits.(fst (ends v)) and high v = limits.(snd (ends v)) in
  let reach_of e : S.reach = match rows.(e).reach with -1 -> Nothing | -2 -> NoMinimum | i -> At parameters.(i).surd in
  let in_range e = rows.(e).in_range in
  let triage e x = verdict rows.(e).triage.(place x) and stable e x = verdict rows.(e).stable.(place x) in
  let improved e f = verdict rows.(e).improved.(f) in
  let rounded e f = if rows.(e).rounded.(f) < 0 then None else Some rows.(e).rounded.(f) in
  let round_exact x = (of_surd x).name in
  let certainly_less f g = findings_read.(f).certainly_less.(g) = 1 in
  let ahead f g = findings_read.(f).rank < findings_read.(g).rank in

  let all = List.init elements Fun.id in
  let found = List.fold_left (fun st e -> S.take reach_of in_range triage stable low high e st) S.start all in
  let words head tail = String.concat " " (head :: tail) in
  let names es = List.map string_of_int (List.sort compare es) in
  let evidence = function S.By_triage _ -> "t" | S.By_stable _ -> "s" | S.By_exact _ -> "x" in
  let published =
    match S.published reach_of stable improved certainly_less ahead rounded round_exact found with
    | S.Published_miss -> "miss"
    | S.Published_hit (Some name, es) -> words ("hit " ^ string_of_int name) (names es)
    | S.Published_hit (None, es) -> words "hit nothing" (names es)
    | S.Published_no_minimum es -> words "none" (names es) in
  String.concat "; "
    [ words (string_of_int (place found.limit) ^ ";") (List.map (fun (e, v) -> string_of_int e ^ evidence v) found.candidates)
      ^ words ";" (names found.without_minimum);
      published;
      digits (S.blocks reach_of in_range triage stable) all;
      digits (S.blocks_segment reach_of in_range triage stable low high) all ]

let words line = List.filter (( <> ) "") (String.split_on_char ' ' line)

let () =
  let limits = Array.of_list (List.map (fun x -> binary64 (float_of_string x)) (words (input_line stdin))) in
  let rec loop number =
    match input_line stdin with
    | exception End_of_file -> ()
    | line ->
        let rest = ref (words line) in
        let next () =
          match !rest with
          | word :: tail -> rest := tail; int_of_string word
          | [] -> failwith (Printf.sprintf "table %d is cut short" number) in
        print_endline (answer limits next);
        if !rest <> [] then failwith (Printf.sprintf "table %d goes on" number);
        loop (number + 1) in
  loop 0
