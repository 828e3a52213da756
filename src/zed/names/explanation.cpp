#include "durero/zed/names/explanation.hpp"

#include <algorithm>
#include <new>
#include <set>

#include "durero/zed/evaluate/evaluate.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"
#include "zed/names/term_at.hpp"

namespace durero::zed {
namespace {

/// About a thirtieth of a second, as 10^8 steps take about a minute.
constexpr std::uint64_t most_steps = 50000;
/// The longest value that is shown, and the longest paragraph, in bytes.
constexpr std::size_t longest_value = 400, longest_paragraph = 4000;

/// The section and its ancestors, parents first: what a term in it speaks of.
std::vector<Section> seen_by(const std::string& section, const Specification& read) {
  std::set<std::string> seen = {section};
  for (auto each = read.sections.rbegin(); each != read.sections.rend(); ++each)
    if (seen.contains(each->name)) seen.insert(each->parents.begin(), each->parents.end());
  std::vector<Section> sections;
  for (const Section& each : read.sections)
    if (seen.contains(each.name)) sections.push_back(each);
  return sections;
}

std::string short_text(std::string text) { return text.size() <= longest_value ? std::move(text) : std::string(); }

/// The value of a closed term, or the truth of a predicate; empty where it is not found.
std::string quick_value(const CheckedTexts& of, const std::string& section, const Term& term,
                        const std::optional<Type>& type) {
  if (!of.ok()) return {};
  Steps steps(most_steps);
  try {
    const Evaluator evaluator(seen_by(section, of.read), {}, &steps);
    if (!type) {
      const Truth truth = evaluator.holds(term);
      if (truth == Truth::open || !evaluator.taken().empty()) return {};
      return truth == Truth::yes ? "true" : "false";
    }
    const Value value = evaluator.value(term);
    if (value.is_open() || !evaluator.taken().empty() || (value.set() && !value.set()->members())) return {};
    return short_text(value.text(type->settled(), [](const AtomName& atom) { return atom.text; }));
  } catch (const EvaluationError&) {
  } catch (const StepsSpent&) {
  } catch (const std::bad_alloc&) {
  }
  return {};
}

std::string described(const Global& global) {
  switch (global.form) {
    case Global::Form::given:
      return "given set";
    case Global::Form::free_type:
      return "free type";
    case Global::Form::branch:
      return global.scheme.type.is(Type::Kind::given) ? "constant of a free type" : "constructor of a free type";
    case Global::Form::definition:
      return global.scheme.type.is_schema_set() ? "schema" : "definition";
    case Global::Form::axiom:
      return "axiomatic name";
    case Global::Form::schema:
      return "schema";
    case Global::Form::lost:
      return "name in a paragraph that cannot be read";
  }
  return {};
}

std::string described(Referent::Form form) {
  switch (form) {
    case Referent::Form::variable:
      return "variable";
    case Referent::Form::formal:
      return "generic formal";
    case Referent::Form::component:
      return "component";
    case Referent::Form::global:
      return "name of a paragraph";
    case Referent::Form::toolkit:
      return "name of the toolkit";
  }
  return {};
}

/// The paragraph that declares a global.
std::string declaration_of(const Global& global, const Specification& read) {
  const Section* section = read.find(global.section);
  if (!section) return {};
  for (const Paragraph& paragraph : section->paragraphs) {
    const std::vector<Name> names = names_of(paragraph);
    if (std::ranges::find(names, global.name) == names.end()) continue;
    std::string text = to_unicode(paragraph);
    return text.size() <= longest_paragraph ? text : std::string();
  }
  return {};
}

/// What a token makes, with the scopes at it.
struct MadeTerm {
  Term term;
  bool closed = false;
};

MadeTerm term_made_by(const Token& token, const TokenizedBlock& block, const CheckedTexts& of,
                      const std::vector<TokenizedBlock>& blocks) {
  MadeTerm made;
  NameWalk walk(of, [&](const Term& term, const std::vector<NameScope>& scopes) {
    if (!block.holds(term->place) || !is_made_by(token, *term)) return;
    made = {term, is_closed(term, of.typing, scopes)};
  });
  if (const Section* section = of.read.find(block.section)) walk.section(*section, blocks);
  return made;
}

/// The token that a byte is in, or that ends there.
const Token* token_at(const TokenizedBlock& block, std::size_t byte) {
  const Token* found = nullptr;
  for (const Token& token : block.tokens)
    if (token.to > token.from && block.begin_of(token) <= byte && byte <= block.end_of(token)) {
      const bool inside = byte < block.end_of(token);
      if (!found || inside) found = &token;
      if (inside) break;
    }
  return found;
}

void explain_name(const Occurrence& occurrence, const CheckedTexts& of, const CrossReference& names, Explanation& to) {
  to.notation = occurrence.name.text();
  to.from = occurrence.from;
  to.to = occurrence.to;
  if (occurrence.type) to.type = occurrence.type->text();
  if (!occurrence.referent) return;
  const Referent& referent = names.referents[*occurrence.referent];
  to.form = described(referent.form);
  const Name word{occurrence.name.word.substr(occurrence.sign.size()), occurrence.name.strokes};
  const Global* global = of.typing.find(occurrence.section, word);
  if (referent.form != Referent::Form::global || !global || global->name.word != referent.name.word) return;
  to.form = described(*global);
  if (to.type.empty() && occurrence.sign.empty()) to.type = global->scheme.type.text();
  to.declaration = declaration_of(*global, of.read);
}

}  // namespace

std::optional<Explanation> explanation(const CheckedTexts& of, const CrossReference& names, const std::string& file,
                                       std::size_t byte) {
  const std::vector<TokenizedBlock> blocks = tokenized(of.texts.at(file), of.read);
  const auto block = std::ranges::find_if(blocks, [&](const TokenizedBlock& each) {
    return each.offset <= byte && byte <= each.offset + each.block.body.size();
  });
  if (block == blocks.end() || block->is_header()) return std::nullopt;
  const Token* token = token_at(*block, byte);
  if (!token) return std::nullopt;
  const Occurrence* occurrence = names.at(file, block->begin_of(*token));
  if (occurrence && occurrence->from != block->begin_of(*token)) occurrence = nullptr;
  const MadeTerm made = term_made_by(*token, *block, of, blocks);
  Explanation told{block->begin_of(*token), block->end_of(*token), {}, {}, {}, {}, {}};
  if (occurrence && (!occurrence->is_operator || !made.term)) {
    explain_name(*occurrence, of, names, told);
  } else if (made.term) {
    told.notation = short_text(to_unicode(made.term));
    if (const auto type = of.typing.type_of(made.term)) told.type = type->text();
  } else {
    return std::nullopt;
  }
  if (told.form == "schema") return told;
  const Global* declared = occurrence && occurrence->declares && !told.declaration.empty()
                               ? of.typing.find(block->section, occurrence->name)
                               : nullptr;
  if (made.term && made.closed) {
    told.value = quick_value(of, block->section, made.term, of.typing.type_of(made.term));
  } else if (declared && declared->scheme.formals.empty()) {
    told.value = quick_value(of, block->section, reference(occurrence->name), declared->scheme.type);
  }
  if (told.value == told.notation) told.value.clear();
  return told;
}

}  // namespace durero::zed
