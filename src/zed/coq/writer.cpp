#include "zed/coq/writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "durero/text/utf8.hpp"
#include "durero/zed/coq/coq.hpp"
#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/syntax/paragraphs.hpp"
#include "zed/operators.hpp"

namespace durero::zed::coq {
namespace {

constexpr std::size_t width = 118;

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return !text::continues(c); }));
}

int depth_change(const std::string& word) {
  return static_cast<int>(std::count(word.begin(), word.end(), '(') - std::count(word.begin(), word.end(), ')'));
}

/// Says where the line that begins with this word ends. It ends where the text does; else behind a `:=`; else where it
/// is least deep in parentheses, at the last such place behind a third of the line, and of those rather before a
/// connective than before a relation or a sum; else where the line is full.
std::size_t end_of_line(const std::vector<std::string>& words, std::size_t from, std::size_t room) {
  static const std::set<std::string> connectives = {"/\\", "\\/", "->"}, others = {"<=", "=", "≡", "+", "-", "∈"};
  std::size_t to = from, length = 0, good = from;
  int depth = 0, least = 0;
  for (; to < words.size(); ++to) {
    const std::size_t longer = length + characters(words[to]) + (to == from ? 0 : 1);
    if (to > from && longer > room) break;
    const bool connective = connectives.contains(words[to]) || (to > from && words[to - 1] == "=>");
    const int score = 2 * depth + (connective ? 0 : 1);
    if ((connective || others.contains(words[to])) && length > room / 3 && (good == from || score <= least)) {
      good = to;
      least = score;
    }
    depth += depth_change(words[to]);
    length = longer;
  }
  if (to == words.size()) return to;
  for (std::size_t at = from; words[0] == "Definition" && at < to; ++at)
    if (words[at] == ":=") return at + 1;
  return good > from ? good : to;
}

/// Returns the schema that is the state of the text, which may be known from the sections before: some box includes Δ
/// or Ξ of it, or the decorated schema.
std::string state_of(const Section& section, std::string state) {
  for (const Paragraph& paragraph : section.paragraphs) {
    const Schema* form = std::get_if<Schema>(&paragraph.form);
    if (!form) continue;
    for (const Declaration& declaration : form->text.declarations) {
      const auto name = declaration.form == Declaration::Form::included ? schema_name(declaration.term) : std::nullopt;
      if (!name) continue;
      std::string word = name->word;
      const bool sign = word.starts_with("Δ") || word.starts_with("Ξ");
      if (sign) word.erase(0, 2);
      if (!sign && name->strokes != "'") continue;
      if (!state.empty() && state != word)
        uncovered(declaration.place, fmt::format("a second state, {} beside {},", word, state));
      state = word;
    }
  }
  return state;
}

/// Says of what is done in a section which file it stands in, where that has no rule.
template <class Do>
void in_file_of(const Section& section, Do&& what) {
  try {
    what();
  } catch (const ZError& error) {
    throw ExportError(error.in(section.file).text());
  }
}

}  // namespace

CoqWriter::CoqWriter(const Specification& specification, const Typing& typing) : in_(typing) {
  for (const Section& each : specification.sections) in_file_of(each, [&] { in_.state = state_of(each, in_.state); });
  // Coq has these sets already. The text's axioms for them are exported as statements, to be proved.
  for (const auto& [z, ok] : {std::pair{"ℝ", ""}, std::pair{"ℤ", "integers"}}) {
    CoqSymbol symbol;
    symbol.form = CoqSymbol::Form::carrier;
    symbol.type = Carrier::named("R");
    symbol.ok = ok;
    in_.symbols[{z, {}}] = symbol;
  }
  for (const Section& each : specification.sections) section(each);
}

void CoqWriter::section(const Section& section) {
  if (section.paragraphs.empty()) return;
  out_ += fmt::format("(** * {} *)\n", std::filesystem::path(section.file).filename().string());
  for (const Paragraph& each : section.paragraphs) {
    out_ += "\n";
    in_file_of(section, [&] { paragraph(each); });
  }
  out_ += "\n";
}

void CoqWriter::paragraph(const Paragraph& paragraph) {
  for (const Name& name : names_of(paragraph))  // the rules of translation take it for the toolkit's
    if (toolkit_section_of(name.text()))
      uncovered(paragraph.place, fmt::format("{}, which the toolkit declares too,", name.text()));
  if (const auto* form = std::get_if<GivenTypes>(&paragraph.form)) return given(*form);
  if (const auto* form = std::get_if<FreeType>(&paragraph.form)) return free_type(*form);
  if (const auto* form = std::get_if<Definition>(&paragraph.form)) return definition(*form);
  if (const auto* form = std::get_if<Axiomatic>(&paragraph.form)) return axiomatic(*form, paragraph.place);
  if (const auto* form = std::get_if<Schema>(&paragraph.form)) return schema(*form);
  if (const auto* form = std::get_if<Conjecture>(&paragraph.form)) return conjecture(*form);
}

void CoqWriter::sentence(const std::string& text, const std::string& label, const std::string& indent) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  if (!label.empty()) words.push_back("(* " + label + " *)");
  for (std::size_t from = 0; from < words.size();) {
    const std::string margin = from == 0 ? indent : indent + "  ";
    const std::size_t to = end_of_line(words, from, width - margin.size());
    out_ += margin + words[from];
    for (std::size_t i = from + 1; i < to; ++i) out_ += " " + words[i];
    out_ += "\n";
    from = to;
  }
}

void CoqWriter::given(const GivenTypes& form) {
  for (const Name& name : form.names) {
    CoqSymbol symbol;
    symbol.form = CoqSymbol::Form::carrier;
    symbol.type = Carrier::named(variable(name));
    in_.symbols[name] = symbol;
    sentence("Variable " + variable(name) + " : Type.");
  }
}

void CoqWriter::free_type(const FreeType& form) {
  CoqSymbol symbol;
  symbol.form = CoqSymbol::Form::carrier;
  symbol.type = Carrier::named(variable(form.name));
  in_.symbols[form.name] = symbol;
  std::string text = "Inductive " + variable(form.name) + " :=";
  for (const Branch& branch : form.branches) {
    if (branch.argument) uncovered(branch.place, "a constructor");
    CoqSymbol constant;
    constant.text = variable(branch.name);
    constant.type = symbol.type;
    in_.symbols[branch.name] = constant;
    text += " | " + constant.text;
  }
  sentence(text + ".");
}

// A claim is a statement, which a theorem has to prove.
void CoqWriter::conjecture(const Conjecture& form) {
  const Predicate& claim = form.claim;
  if (claim.label.empty()) uncovered(claim.place, "a conjecture without a label");
  sentence(fmt::format("Definition {} : Prop := {}.", identifier(claim.label), in_.predicate(claim.term, {}).text),
           claim.label);
}

void CoqWriter::definition(const Definition& form) {
  if (!form.formals.empty()) uncovered(form.value->place, "a generic definition");
  switch (form.value->kind) {
    case Kind::comprehension:
      return form.value->children.empty() ? set_definition(form) : value_definition(form);
    case Kind::lambda:
      return lambda_definition(form);
    case Kind::reference:
    case Kind::schema_text:
    case Kind::negation:
    case Kind::conjunction:
    case Kind::disjunction:
    case Kind::implication:
    case Kind::equivalence:
    case Kind::hiding:
      return operation_definition(form);
    default:
      return value_definition(form);
  }
}

// { x : S | P } is a set, and { S; x : T | P } is a predicate on its arguments.
void CoqWriter::set_definition(const Definition& form) {
  CoqScope inside;
  const Signature slots = in_.declare(*form.value->text, inside);
  const std::string name = variable(form.name);
  CoqSymbol symbol;
  symbol.text = name;
  if (slots.size() == 1) {
    const Expr value = in_.set(form.value, {});
    symbol.type = value.type;
    sentence(fmt::format("Definition {} : {} := {}.", name, value.type.text(), value.text), form.label);
  } else {
    symbol.form = CoqSymbol::Form::operation;
    symbol.signature = slots;
    const Expr body = all_of(in_.conditions({{}, form.value->text->predicates}, {}, {}, inside));
    sentence(fmt::format("Definition {} {} : Prop := {}.", name, binders(slots, false), body.text), form.label);
  }
  in_.symbols[form.name] = symbol;
}

void CoqWriter::lambda_definition(const Definition& form) {
  CoqScope inside;
  const SchemaText& text = *form.value->text;
  const Signature slots = in_.declare(text, inside);
  const Term& value = form.value->children[0];
  CoqSymbol symbol;
  symbol.text = variable(form.name);
  symbol.arity = slots.size();
  const std::string head = fmt::format("Definition {} {} : ", symbol.text, binders(slots, false));
  std::vector<Expr> conjuncts = in_.conditions({{}, text.predicates}, {}, {}, inside);
  CoqScope branch = inside;
  Frame frame;
  const bool set = in_.is_set(value);
  symbol.form = set ? CoqSymbol::Form::function : CoqSymbol::Form::partial;
  Term leaf = value;
  while (leaf->kind == Kind::conditional) leaf = leaf->children[1];
  symbol.type = in_.term(leaf, branch, frame).type;
  if (set && conjuncts.empty()) {
    sentence(fmt::format("{}{} := {}.", head, symbol.type.text(), in_.set(value, inside).text), form.label);
  } else {
    const bool named = value->kind == Kind::comprehension && value->children.empty();
    const std::string x = named ? variable(value->text->declarations[0].names[0]) : in_.fresh(set ? "x" : "y", inside);
    inside.variables.insert(x);
    const Carrier type = set ? symbol.type : Carrier::set(symbol.type);
    const Expr variable{x, atomic, type.element()};
    conjuncts.push_back(set ? in_.member(variable, value, inside) : in_.is_value(variable, value, inside));
    sentence(fmt::format("{}{} := fun {} => {}.", head, type.text(), x, all_of(conjuncts).text), form.label);
  }
  in_.symbols[form.name] = symbol;
}

void CoqWriter::operation_definition(const Definition& form) {
  CoqSymbol symbol;
  symbol.form = CoqSymbol::Form::operation;
  symbol.text = variable(form.name);
  symbol.signature = in_.signature(form.value);
  CoqScope inside;
  for (const Slot& slot : symbol.signature) in_.declare(slot, inside);
  sentence(fmt::format("Definition {} {} : Prop := {}.", symbol.text, binders(symbol.signature, false),
                       in_.predicate(form.value, inside).text),
           form.label);
  in_.symbols[form.name] = symbol;
}

void CoqWriter::value_definition(const Definition& form) {
  const Expr value = in_.set(form.value, {});
  CoqSymbol symbol;
  symbol.text = variable(form.name);
  symbol.type = value.type;
  sentence(fmt::format("Definition {} : {} := {}.", symbol.text, value.type.text(), value.text), form.label);
  in_.symbols[form.name] = symbol;
}

}  // namespace durero::zed::coq
