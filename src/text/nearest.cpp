#include "durero/text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "durero/text/spanish.hpp"
#include "durero/text/utf8.hpp"

namespace durero::text {
namespace {

std::vector<std::string_view> characters(std::string_view text) {
  std::vector<std::string_view> characters;
  for (; !text.empty(); text.remove_prefix(characters.back().size())) characters.push_back(first(text));
  return characters;
}

}  // namespace

std::size_t apart(std::string_view a, std::string_view b) {
  const auto x = characters(a), y = characters(b);
  // Row i has how far the first i characters of a are from the first j of b.
  std::vector<std::size_t> before, last(y.size() + 1), row(y.size() + 1);
  std::iota(last.begin(), last.end(), 0U);
  for (std::size_t i = 1; i <= x.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= y.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (x[i - 1] == y[j - 1] ? 0 : 1)});
      const bool exchanged = i > 1 && j > 1 && x[i - 1] == y[j - 2] && x[i - 2] == y[j - 1];
      if (exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last.back();
}

std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& list) {
  const auto same = std::ranges::find(list, word, english_of);
  if (same != list.end() && !word.empty()) return *same;
  std::optional<std::string> best;
  std::size_t least = 0;
  const std::size_t length = characters(word).size();
  for (const std::string& candidate : list) {
    const std::size_t other = characters(candidate).size();
    const std::size_t most = std::max<std::size_t>(1, other / 3);
    if (std::max(length, other) - std::min(length, other) > most) continue;  // they are at least so far apart
    const std::size_t off = apart(word, candidate);
    if (off > most || 2 * off >= other || (best && off >= least)) continue;
    best = candidate;
    least = off;
  }
  return best;
}

std::string expected_of(std::string_view word, const std::vector<std::string>& list) {
  if (const auto meant = nearest(word, list)) return with_english(*meant);
  std::vector<std::string> shown;
  for (const std::string& known : list) shown.push_back(with_english(known));
  return fmt::format("one of {}", fmt::join(shown, ", "));
}

}  // namespace durero::text
