# What Doxygen reads of a header: the header, with the sentences that the code says itself. The first comment of a file is of
# the file. A clause of the text says its label and its predicate. The parts of a schema mean the same in every schema,
# which model/operaciones.hpp says once. Everything else has its sentence in the header.
BEGIN {
  said["e"] = "The element (`e?`)."
  said["t"] = "The type (`t?`), which a total operation does not look at."
  said["centro"] = "The centre (`centro?`)."
  said["radio"] = "The radius (`radio?`), a real: what is not in Rmas is refused by name."
  said["vector"] = "The axis or the normal (`vector?`): what is not in Unitario is refused by name."
  said["altura"] = "The height (`altura?`), a real: what is not in Rmas is refused by name."
  said["proporcion"] = "The radius by height (`proporcion?`), a real: what is not in Rmas is refused by name."
  said["vertices"] = "The vertices (`vertices?`): what is not in Vertices is refused by name."
  said["m"] = "The name of the mesh (`m?`)."
  said["red"] = "The points and faces that are to be a mesh (`red?`): what is not in Malla is refused by name."
  said["n"] = "The number of the vertex (`n?`)."
  said["punto"] = "Where the vertex goes (`punto?`)."
  said["tipo"] = "The type of elements that it is about."
  said["answer"] = "The r! when it is done."
  said["schema"] = "The name of the partial operation in the text."
  said["total"] = "The name of the total operation in the text."
  said["is_of_type"] = "The clause that asks for the type."
  said["is_of_another_type"] = "The clause that the element is of another type."
  said["exists"] = "The clause that the element exists."
  said["requirements"] = "What the inputs must be: a clause each, and the error of the total operation."
  said["effects"] = "What becomes of each component of the scene: a clause each."
  said["has_attribute"] = "The clause that the element has the attribute."
  said["lacks"] = "The clause that it has not."
  said["material"] = "The name of a material (`material?`)."
  said["g"] = "The name of a group (`g?`)."
  said["ops"] = "The steps (`ops?`)."
  said["answers"] = "The clause that says r!."
  said["component"] = "The attribute that it is about."
  said["Denial"] = "The error of the total operation for an element of another type."
  said["Addition"] = "The operation that adds an element of the type."
  said["Removal"] = "The operation that removes an element of the type."
}
BEGIN {
  count = split("centro radio vector altura proporcion vertices", names, " ")
  for (i = 1; i <= count; ++i) of_shape[names[i]] = "The attribute of that name in the text, in binary64."
  of_shape["Addition"] = "The operation of the specification that adds one."
  of_shape["Removal"] = "The operation of the specification that removes one."
  of_shape["tipo"] = "Its type in the text."
  of_shape["word"] = "Its type in files."
  of_shape["attributes"] = "Its attributes, in the order of the text."
}
FNR == 1 {
  documented = 0
  schema = 0
  of_model = FILENAME ~ /durero\/model\//
  of_schemas = FILENAME ~ /durero\/model\/(tipo\/|operaciones|malla|cambio|vista|historia)/
  of_shapes = FILENAME ~ /durero\/scene\/shape\// && FILENAME !~ /attribute/
}
# The first comment of a file is of the file: this line is in the place of one that says nothing.
/^#pragma once/ { print "/// \\file"; next }
# Signs that Doxygen would take for its own.
/\/\/\// && !/@[{}]/ { gsub(/[@#]/, "\\\\&") }
/^struct / { schema = of_schemas || of_shapes }
# say(SENTENCE): on the line itself, so that places stay what they are.
function say(sentence) { match($0, /^ */); $0 = substr($0, 1, RLENGTH) "/** " sentence " */ " substr($0, RLENGTH + 1) }
function is_new() { return !documented && !/\/\/\/|\/\*\*/ }
# A comment behind a line that declares several names is of each of them.
/^ +[A-Za-z][^(]*, [*A-Za-z][^(]*; +\/\/\/< / {
  sentence = $0; sub(/.*; +\/\/\/< /, "", sentence); sub(/ +\/\/\/< .*/, "")
  say("@{ " sentence)
  $0 = $0 " /** @} */"
}
of_model && /^inline constexpr (contract::)?clause [A-Za-z_0-9]+\{/ && is_new() {
  name = $0; sub(/^inline constexpr (contract::)?clause /, "", name); sub(/\{.*/, "", name)
  match(name, /_(pre|post|inv|def)_[0-9]+$/)
  part = substr(name, RSTART); gsub(/_/, ".", part)
  say("The clause " substr(name, 1, RSTART - 1) part " of the text, with its predicate.")
}
of_model && /^(struct|class) [A-Z][a-z]+_[A-Za-z_]+ \{/ && is_new() { say("The schema " $2 " of the text.") }
/^};/ { schema = 0 }
schema && /^  static constexpr const clause \*exists/ {
  say("@{ The clauses that the element exists, that it is of another type, and what r! is.")
  open = 1
}
open && /;$/ { $0 = $0 " /** @} */"; open = 0 }
schema && is_new() && /^  [A-Za-z].*([;{]|=$)/ {
  name = $0
  sub(/(\{| =( |$)| : ).*/, "", name); sub(/;.*/, "", name); sub(/.*[ *]/, "", name)
  if (/^  using /) { name = $2 }
  if (of_schemas && name in said) say(said[name])
  if (of_shapes && name in of_shape) say(of_shape[name])
}
is_new() && /\) *(const)? *(noexcept)? *= default;/ && !/operator/ { say("As the language defines it.") }
is_new() && /operator=\(.*= default;/ { say("As the language defines it.") }
is_new() && / = delete;/ { say("There is none.") }
is_new() && /operator==\(.*\) const.*= default;/ { say("Whether all members are equal.") }
is_new() && /operator<=>\(.*\) const.*= default;/ { say("Compares the members, in their order.") }
{ print }
/^ *\/\/\// { documented = !/@}/; next }
!/^ *template </ { documented = 0 }
