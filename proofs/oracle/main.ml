(* The extracted procedure of Exacto.v as a program: reads scenes and rays, and answers or judges.

   Input, one item a line; numbers are read exactly as binary64 (C hexadecimal or decimal), names hold no blank or comma:
     scene                                     a new, empty scene
     esfera NAME cx cy cz radio
     cilindro NAME cx cy cz radio dx dy dz altura
     cono NAME cx cy cz proporcion dx dy dz altura
     tronco NAME cx cy cz radio proporcion dx dy dz altura
     plano NAME cx cy cz dx dy dz
     disco NAME cx cy cz radio dx dy dz
     triangulo NAME ax ay az bx by bz cx cy cz
     ray px py pz vx vy vz [@NAME]...          @NAME: the ray starts on that element
     ray ... = miss
     ray ... = no_minimum NAME,NAME...
     ray ... = hit NAME,NAME... t x y z        the names in any order
   A ray without a claim is answered on stdout, in one line:
     miss | no_minimum NAME,NAME... | hit NAME,NAME... num coef rad den     with t = (num + coef * sqrt rad) / den
   A claim is judged: the bits of t and of the coordinates must be those of the exact ones rounded once to the nearest
   binary64, ties to even; a zero has the sign of what was rounded.
   A wrong claim is a line on stdout. Exit status: 0, 1 if some claim is wrong, 2 if the input is bad. *)

module E = Exacto

exception Bad of string

let bad text = raise (Bad text)

(* A binary64 is mantissa * 2^exponent. *)
type dyadic = { mantissa : Z.t; exponent : int }

let dyadic_of_float x =
  let fraction, exponent = Float.frexp x in
  { mantissa = Z.of_float (Float.ldexp fraction 53); exponent = exponent - 53 }

let read_float word =
  match float_of_string_opt word with
  | Some x when not (Float.is_nan x) -> x
  | _ -> bad ("not a number: " ^ word)

let read word =
  let x = read_float word in
  if Float.is_integer x || Float.abs x < infinity then
    if x = 0. then { mantissa = Z.zero; exponent = 0 }
    else
      let { mantissa; exponent } = dyadic_of_float x in
      let zeros = Z.trailing_zeros mantissa in
      { mantissa = Z.shift_right mantissa zeros; exponent = exponent + zeros }
  else bad ("not finite: " ^ word)

(* How many binary places a number has. *)
let places x = max 0 (-x.exponent)
let most_places = Array.fold_left (fun most x -> max most (places x)) 0
let scaled k x = Z.shift_left x.mantissa (x.exponent + k)
let vec k xs i : E.vec3 = { vx = scaled k xs.(i); vy = scaled k xs.(i + 1); vz = scaled k xs.(i + 2) }

type kind = Esfera | Cilindro | Cono | Tronco | Plano | Disco | Triangulo
type element = { name : string; kind : kind; numbers : dyadic array }

let shape k { kind; numbers = n; _ } =
  match kind with
  | Esfera -> E.Sphere (vec k n 0, scaled k n.(3))
  | Cilindro -> E.Cylinder (vec k n 0, scaled k n.(3), vec k n 4, scaled k n.(7))
  | Cono -> E.Cone (vec k n 0, scaled k n.(3), vec k n 4, scaled k n.(7))
  | Tronco -> E.TruncatedCone (vec k n 0, scaled k n.(3), scaled k n.(4), vec k n 5, scaled k n.(8))
  | Plano -> E.Plane (vec k n 0, vec k n 3)
  | Disco -> E.Disc (vec k n 0, scaled k n.(3), vec k n 4)
  | Triangulo -> E.Triangle (vec k n 0, vec k n 3, vec k n 6)

type scene = { elements : element list; scene_places : int; shapes : (int, (string * E.shape) list) Hashtbl.t }

let empty = { elements = []; scene_places = 0; shapes = Hashtbl.create 1 }

let add scene element =
  { elements = element :: scene.elements;
    scene_places = max scene.scene_places (most_places element.numbers);
    shapes = Hashtbl.create 8 }

(* The shapes over the common denominator 2^k, kept for the next ray. *)
let shapes_at scene k =
  match Hashtbl.find_opt scene.shapes k with
  | Some shapes -> shapes
  | None ->
      let shapes = List.map (fun e -> (e.name, shape k e)) scene.elements in
      Hashtbl.replace scene.shapes k shapes;
      shapes

(* The bits of what is printed of an exact parameter: t, x, y and z, each rounded once by the extracted procedure. The
   claim gives it hints of where to look, which change no result: roots from Zarith, and where the claimed bits end. *)

let bits_of_float f = Z.extract (Z.of_int64 (Int64.bits_of_float f)) 0 64

let place f =
  if f = 0. then -1074 else if Float.abs f = infinity then 900 else snd (Float.frexp f) - 64

let exact_bits s p v exact claimed =
  let guess n = if Z.sign n < 0 then Z.zero else Z.sqrt n in
  let at i = Z.of_int (place claimed.(i)) in
  let out = E.exactly_printed guess (at 0) (at 1) (at 2) (at 3) s p v exact in
  Array.map E.bits [| out.printed_t; out.printed_x; out.printed_y; out.printed_z |]

type claim = None_claimed | Miss | No_minimum of string list | Hit of string list * float array

let names word = List.sort compare (String.split_on_char ',' word)

let read_claim = function
  | [] -> None_claimed
  | [ "="; "miss" ] -> Miss
  | [ "="; "no_minimum"; elements ] -> No_minimum (names elements)
  | [ "="; "hit"; elements; t; x; y; z ] -> Hit (names elements, Array.map read_float [| t; x; y; z |])
  | words -> bad ("not a claim: " ^ String.concat " " words)

let print_surd ({ num; coef; rad; den } : E.surd) = String.concat " " (List.map Z.to_string [ num; coef; rad; den ])

let text = function
  | E.Miss -> "miss"
  | E.NoMin elements -> "no_minimum " ^ String.concat "," (List.sort compare elements)
  | E.Hit (t, elements) -> Printf.sprintf "hit %s %s" (String.concat "," (List.sort compare elements)) (print_surd t)

let holds s (p : E.vec3) (v : E.vec3) claim answer =
  match (claim, answer) with
  | Miss, E.Miss -> true
  | No_minimum claimed, E.NoMin elements -> claimed = List.sort compare elements
  | Hit (claimed, numbers), E.Hit (exact, elements) ->
      claimed = List.sort compare elements
      && Array.for_all2 Z.equal (Array.map bits_of_float numbers) (exact_bits s p v exact numbers)
  | _ -> false

let rec split_origin scene on = function
  | word :: rest when word.[0] = '@' ->
      let name = String.sub word 1 (String.length word - 1) in
      if List.exists (fun e -> e.name = name) scene.elements then split_origin scene (name :: on) rest
      else bad ("no such element: " ^ name)
  | rest -> (on, rest)

(* Whether the claim, if there is one, holds. *)
let ray scene line words rest =
  let numbers = Array.map read (Array.of_list words) in
  let on, rest = split_origin scene [] rest in
  let claim = read_claim rest in
  let k = max scene.scene_places (most_places numbers) in
  if Array.for_all (fun x -> Z.equal x.mantissa Z.zero) (Array.sub numbers 3 3) then bad "the direction is zero";
  let s = Z.shift_left Z.one k and p = vec k numbers 0 and v = vec k numbers 3 in
  let elements = List.map (fun (name, shape) -> ((name, shape), List.mem name on)) (shapes_at scene k) in
  let answer = E.first_hit s p v elements in
  match claim with
  | None_claimed -> print_endline (text answer); true
  | _ when holds s p v claim answer -> true
  | _ -> Printf.printf "line %d: wrong: %s; exact: %s\n" line (String.concat " " rest) (text answer); false

let element scene name kind words =
  if List.exists (fun e -> e.name = name) scene.elements then bad ("name twice: " ^ name);
  add scene { name; kind; numbers = Array.map read (Array.of_list words) }

let step (scene, judged, wrong) number line =
  match List.filter (( <> ) "") (String.split_on_char ' ' line) with
  | [] -> (scene, judged, wrong)
  | [ "scene" ] -> (empty, judged, wrong)
  | "esfera" :: name :: ([ _; _; _; _ ] as words) -> (element scene name Esfera words, judged, wrong)
  | "cilindro" :: name :: ([ _; _; _; _; _; _; _; _ ] as words) -> (element scene name Cilindro words, judged, wrong)
  | "cono" :: name :: ([ _; _; _; _; _; _; _; _ ] as words) -> (element scene name Cono words, judged, wrong)
  | "tronco" :: name :: ([ _; _; _; _; _; _; _; _; _ ] as words) -> (element scene name Tronco words, judged, wrong)
  | "plano" :: name :: ([ _; _; _; _; _; _ ] as words) -> (element scene name Plano words, judged, wrong)
  | "disco" :: name :: ([ _; _; _; _; _; _; _ ] as words) -> (element scene name Disco words, judged, wrong)
  | "triangulo" :: name :: ([ _; _; _; _; _; _; _; _; _ ] as words) -> (element scene name Triangulo words, judged, wrong)
  | "ray" :: px :: py :: pz :: vx :: vy :: vz :: rest ->
      let right = ray scene number [ px; py; pz; vx; vy; vz ] rest in
      (scene, judged + 1, if right then wrong else wrong + 1)
  | _ -> bad ("not an item: " ^ line)

let () =
  let rec loop state number =
    match input_line stdin with
    | exception End_of_file -> state
    | line ->
        let state =
          try step state number line
          with Bad reason -> Printf.eprintf "oracle: line %d: %s\n" number reason; exit 2 in
        loop state (number + 1) in
  let _, rays, wrong = loop (empty, 0, 0) 1 in
  Printf.eprintf "oracle: %d rays, %d wrong claims\n" rays wrong;
  exit (if wrong = 0 then 0 else 1)
