#include "durero/zed/syntax/operators.hpp"

#include <algorithm>

#include "zed/operators.hpp"
#include "zed/syntax/symbols.hpp"

namespace durero::zed {

std::string OperatorTemplate::name() const {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : " ") + part;
  return text;
}

namespace {

/// Says whether a word is one of the name of an operator in the toolkit: ⟨ is one of ⟨,,⟩.
bool is_word_of(const OperatorRow& row, std::string_view word) {
  const std::size_t at = row.name.find(word);
  if (at == row.name.npos || row.name.find_first_of("_,") == row.name.npos) return false;
  const auto bounds = [&row](std::size_t i) { return row.name[i] == '_' || row.name[i] == ','; };
  const std::size_t end = at + word.size();
  return (at == 0 || bounds(at - 1)) && (end == row.name.size() || bounds(end));
}

/// Says whether a word is the language's, or one of an operator that a section of the toolkit which is seen gives.
bool has_meaning(std::string_view word, ToolkitSections seen) {
  const Symbol& known = symbol_of(word);
  if (known.reserved || known.connective || known.quantifier) return true;
  return std::ranges::any_of(operator_rows(), [&](const OperatorRow& row) {
    return (!row.section || seen.has(*row.section)) && is_word_of(row, word);
  });
}

}  // namespace

std::string word_of_toolkit(const Operators& known, ToolkitSections seen) {
  const auto at = std::ranges::find_if(known, [seen](const auto& each) { return has_meaning(each.first, seen); });
  return at == known.end() ? std::string() : at->first;
}

std::string add_operator(Operators& to, OperatorTemplate added, ToolkitSections seen) {
  const auto is_word = [](const std::string& part) { return part != "_" && part != ",,"; };
  const auto is_taken = [&](const std::string& word) {
    return to.contains(word) || has_meaning(word, seen) || std::ranges::count(added.parts, word) > 1;
  };
  for (const std::string& part : added.parts)
    if (is_word(part) && is_taken(part)) return part;
  const auto shared = std::make_shared<const OperatorTemplate>(std::move(added));
  for (std::size_t i = 0; i < shared->parts.size(); ++i)
    if (is_word(shared->parts[i])) to.emplace(shared->parts[i], OperatorWord{shared, i});
  return {};
}

std::string otherwise_associated(const Operators& known, ToolkitSections seen, const OperatorTemplate& added) {
  const auto has_side = [](const OperatorTemplate& of) { return of.role != Role::relation && of.is_infix(); };
  if (!has_side(added)) return {};
  for (const auto& [word, part] : known)
    if (has_side(*part.of) && part.of->precedence == added.precedence && part.of->right != added.right)
      return part.of->name();
  for (const OperatorRow& row : operator_rows())
    if (row.section && seen.has(*row.section) && row.binding.role && row.binding.role != Role::relation &&
        row.fixity() == Fixity::infix && row.binding.precedence == added.precedence && row.binding.right != added.right)
      return std::string(row.name);
  return {};
}

}  // namespace durero::zed
