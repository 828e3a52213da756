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

std::string add_operator(Operators& to, OperatorTemplate added) {
  const auto is_word = [](const std::string& part) { return part != "_" && part != ",,"; };
  const auto is_taken = [&](const std::string& word) {
    const auto is_same = [&word](const std::string& part) { return part == word; };
    return to.contains(word) || !may_be_name(word) || find_operator(word, Fixity::postfix) ||
           std::count_if(added.parts.begin(), added.parts.end(), is_same) > 1;
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
