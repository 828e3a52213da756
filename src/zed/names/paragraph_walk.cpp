/// The walk over names goes from block to block and from paragraph to paragraph, and gives each name its token.

#include <algorithm>
#include <utility>

#include "zed/names/name_walk.hpp"
#include "zed/syntax/lexer_base.hpp"
#include "zed/syntax/symbols.hpp"
#include "zed/syntax/token_stream.hpp"

namespace durero::zed {
namespace {

std::pair<std::uint32_t, std::uint32_t> order_of(Place place) { return {place.line, place.column}; }

}  // namespace

const Token* NameWalk::take_token(const Name& name, Place place) {
  std::size_t at = next_;
  if (place.line != 0 && (at == names_.size() || names_[at]->place != place)) {
    const auto found = std::ranges::lower_bound(names_, order_of(place), {},
                                                [](const Token* token) { return order_of(token->place); });
    at = static_cast<std::size_t>(found - names_.begin());
  }
  const bool same = at < names_.size() && (place.line == 0 || names_[at]->place == place) &&
                    names_[at]->text == name.word && names_[at]->strokes == name.strokes;
  if (!same || taken_[at]) {
    found_.complete = false;
    return nullptr;
  }
  taken_[at] = true;
  next_ = std::max(next_, at + 1);
  return names_[at];
}

void NameWalk::note(const Token* token, const Name& name, Meaning meaning, std::optional<Type> type, bool declares) {
  if (!token) return;
  Occurrence& added = into_->emplace_back();
  added.from = block_->begin_of(*token);
  added.to = block_->end_of(*token);
  added.place = token->place;
  added.section = section_->name;
  added.name = name;
  added.sign = std::move(meaning.sign);
  added.declares = declares;
  added.referent = meaning.referent;
  added.type = std::move(type);
}

void NameWalk::section(const Section& section, const std::vector<TokenizedBlock>& blocks) {
  section_ = &section;
  into_ = &found_.files[section.file];
  auto next = section.paragraphs.begin();
  for (const TokenizedBlock& each : blocks) {
    if (each.is_header() || each.section != section.name) continue;
    block(each);
    for (; next != section.paragraphs.end() && each.holds(next->place); ++next) paragraph(*next);
    rest_of_names();
  }
  if (next != section.paragraphs.end()) found_.complete = false;
}

void NameWalk::block(const TokenizedBlock& block) {
  block_ = &block;
  names_.clear();
  next_ = 0;
  passed_.clear();
  chained_ = std::ranges::any_of(block.tokens, [](const Token& token) { return token.own != nullptr; });
  for (const Token& token : block.tokens)
    if (TokenStream::is_name(token)) names_.push_back(&token);
  taken_.assign(names_.size(), false);
  first_ = into_->size();
  operator_tokens(block);
}

/// The words and symbols of operators. A sign that may stand before its operand or between two is infix behind what can
/// be an operand.
void NameWalk::operator_tokens(const TokenizedBlock& block) {
  for (std::size_t i = 0; i < block.tokens.size(); ++i) {
    const Token& token = block.tokens[i];
    const Symbol& known = *token.symbol;
    const bool behind_operand = i > 0 && lexing::ends(block.tokens[i - 1]);
    const Operator* op = known.infix && (behind_operand || !known.prefix) ? known.infix : known.prefix;
    if (!op) op = known.postfix;
    if (!token.own && !op) continue;
    const Name name{token.own ? token.own->of->name() : op->name(), {}};
    Meaning meaning = meaning_of(name);
    if (name.word == "_=_" || name.word == "_∈_") meaning.referent = toolkit_name(name);  // the language has them
    if (!meaning.referent) continue;                                                      // as / of a renaming
    note(&token, name, std::move(meaning), std::nullopt, false);
    into_->back().is_operator = true;
  }
}

/// The names that no tree was found for, as in a paragraph that could not be read, are looked up as globals.
void NameWalk::rest_of_names() {
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (taken_[i]) continue;
    found_.complete = false;
    const Name name{names_[i]->text, names_[i]->strokes};
    note(names_[i], name, meaning_of(name), std::nullopt, false);
  }
}

void NameWalk::paragraph(const Paragraph& paragraph) {
  std::visit([&](const auto& form) { this->paragraph(form, paragraph.place); }, paragraph.form);
  scopes_.clear();
}

/// A name that a paragraph declares is the global that the section sees; of two of one name, the second is another.
NameWalk::Meaning NameWalk::declared_global(const Name& name, Place place) {
  const Global* declared = typing_.find(section_->name, name);
  if (declared && declared->place == place && declared->file == section_->file) return {global(*declared), {}, {}};
  return {table_.add({Referent::Form::global, name}), {}, {}};
}

void NameWalk::declare_global(const Name& name, Place place) {
  const Global* declared = typing_.find(section_->name, name);
  if (is_operator_name(name.word)) return declare_operator(name, place);
  const Token* token = take_token(name, place);
  note(token, name, declared_global(name, place), declared ? std::optional(declared->scheme.type) : std::nullopt, true);
}

/// The first word of an operator from a place on declares it.
void NameWalk::declare_operator(const Name& name, Place place) {
  for (std::size_t i = first_; i < into_->size(); ++i) {
    Occurrence& each = (*into_)[i];
    if (!each.is_operator || each.name != name || order_of(each.place) < order_of(place)) continue;
    each.declares = true;
    return;
  }
}

void NameWalk::paragraph(const GivenTypes& given, Place) {
  for (std::size_t i = 0; i < given.names.size(); ++i) declare_global(given.names[i], given.places[i]);
}

void NameWalk::paragraph(const FreeType& type, Place place) {
  declare_global(type.name, place);
  for (const Branch& branch : type.branches) {
    declare_global(branch.name, branch.place);
    if (branch.argument) term(branch.argument);
  }
}

void NameWalk::formals(const std::vector<Name>& names) {
  NameScope scope;
  for (const Name& name : names) {
    const std::size_t referent = table_.add({Referent::Form::formal, name});
    const Type type = Type::power(Type::formal(name));
    note(take_token(name), name, {referent, {}, {}}, type, true);
    scope.push_back({name, referent, type});
  }
  scopes_.push_back(std::move(scope));
}

void NameWalk::paragraph(const Definition& definition, Place place) {
  declare_global(definition.name, place);
  formals(definition.formals);
  auto components = term(definition.value);
  const Global* declared = typing_.find(section_->name, definition.name);
  if (declared && declared->place == place && components) schemas_.emplace(declared, std::move(*components));
}

void NameWalk::paragraph(const Axiomatic& box, Place) {
  formals(box.formals);
  scopes_.push_back(signature(box.text, Referent::Form::global));
  predicates(box.text);
}

void NameWalk::paragraph(const Schema& box, Place place) {
  declare_global(box.name, place);
  formals(box.formals);
  NameScope scope = signature(box.text, Referent::Form::component);
  const ComponentReferents components = components_of(scope);
  scopes_.push_back(std::move(scope));
  predicates(box.text);
  table_.remember(components);
  const Global* declared = typing_.find(section_->name, box.name);
  if (declared && declared->place == place) schemas_.emplace(declared, components);
}

void NameWalk::paragraph(const Conjecture& conjecture, Place) {
  formals(conjecture.formals);
  predicate(conjecture.claim.term);
}

CrossReference NameWalk::take() {
  for (auto& [file, occurrences] : found_.files) {
    std::ranges::stable_sort(occurrences, {}, &Occurrence::from);
    for (Occurrence& each : occurrences)
      if (each.referent) each.referent = table_.root(*each.referent);
  }
  found_.referents = table_.referents();
  return std::move(found_);
}

}  // namespace durero::zed
