#include "zed/types/known_names.hpp"

#include <algorithm>

#include "durero/text/nearest.hpp"
#include "durero/zed/syntax/operators.hpp"

namespace durero::zed {

KnownNames::KnownNames(std::vector<std::string> names) : names_(std::move(names)) {
  std::ranges::sort(names_);  // of several as near the first is named, whatever the tables' order
  for (const std::string& name : names_) {
    for (std::size_t at = 0; at <= name.size();) {
      const std::size_t end = std::min(name.find(' ', at), name.size());
      const std::string word = name.substr(at, end - at);
      if (word != "_" && word != ",,") words_[word] = is_template_name(name);
      at = end + 1;
    }
  }
}

std::optional<std::string> KnownNames::with_strokes(std::string_view word) const {
  auto at = std::ranges::upper_bound(names_, word, std::less<>());
  for (; at != names_.end() && at->starts_with(word); ++at)
    if (at->find_first_not_of("'?!", word.size()) == at->npos) return *at;
  return std::nullopt;
}

const std::optional<std::string>& KnownNames::nearest(const std::string& word) const {
  const auto at = found_.find(word);
  return at != found_.end() ? at->second : found_.emplace(word, text::nearest(word, names_)).first->second;
}

std::optional<bool> KnownNames::is_of_operator(std::string_view text) const {
  const auto at = words_.find(text);
  return at == words_.end() ? std::nullopt : std::optional(at->second);
}

std::optional<std::string> with_strokes(std::string_view word, const KnownNames& a, const KnownNames& b) {
  auto first = a.with_strokes(word), second = b.with_strokes(word);
  if (!first || !second) return first ? first : second;
  return std::min(*first, *second);
}

std::optional<std::string> nearest(const std::string& word, const KnownNames& a, const KnownNames& b) {
  std::vector<std::string> of_each;  // the nearest of all is one of them
  for (const KnownNames* names : {&a, &b})
    if (const auto& near = names->nearest(word)) of_each.push_back(*near);
  std::ranges::sort(of_each);
  return text::nearest(word, of_each);
}

std::string taken_apart(std::string_view word, const KnownNames& a, const KnownNames& b, int most) {
  for (std::size_t length = word.size() - 1; most > 1 && length > 0; --length) {
    const std::string_view head = word.substr(0, length), rest = word.substr(length);
    auto of_operator = a.is_of_operator(head);
    if (!of_operator) of_operator = b.is_of_operator(head);
    if (!of_operator) continue;
    const bool numeral = *of_operator && rest.find_first_not_of("0123456789") == rest.npos;
    if (numeral || a.is_of_operator(rest) || b.is_of_operator(rest)) return std::string(head) + " " + std::string(rest);
    if (const std::string behind = taken_apart(rest, a, b, most - 1); !behind.empty())
      return std::string(head) + " " + behind;
  }
  return {};
}

}  // namespace durero::zed
