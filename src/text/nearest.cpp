#include "durero/text/nearest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "durero/text/spanish.hpp"
#include "durero/text/utf8.hpp"

namespace durero::text {
namespace {

/// The characters of a text, each as the number that its bytes make; a byte that is no part of a character is one.
void take_characters(std::string_view text, std::vector<std::uint32_t>& characters) {
  characters.clear();
  while (!text.empty()) {
    std::uint32_t number = 0;
    const std::string_view character = first(text);
    for (const char byte : character) number = number << 8U | static_cast<unsigned char>(byte);
    characters.push_back(number);
    text.remove_prefix(character.size());
  }
}

/// The distance of a word from many others. The rows of the table are kept, as a message compares a word with all
/// names.
class Distance {
 public:
  explicit Distance(std::string_view word) { take_characters(word, word_); }

  std::size_t length() const { return word_.size(); }
  /// Takes the other word, and returns its number of characters.
  std::size_t take(std::string_view other) {
    take_characters(other, other_);
    return other_.size();
  }
  /// The distance to the other word where it is at most so great; else a number that is greater than that.
  std::size_t up_to(std::size_t most) {
    last_.resize(other_.size() + 1);
    row_.resize(other_.size() + 1);
    before_.resize(other_.size() + 1);
    std::iota(last_.begin(), last_.end(), 0U);
    std::size_t least_of_last = 0;
    for (std::size_t i = 1; i <= word_.size(); ++i) {
      const std::size_t least = fill_row(i);
      std::swap(before_, last_);
      std::swap(last_, row_);
      // Each later number is at least the least of this row, or one more than the least of the row before.
      if (least > most && least_of_last >= most) return most + 1;
      least_of_last = least;
    }
    return last_.back();
  }

 private:
  /// Row i has how far the first i characters of the word are from the first j of the other. Returns its least.
  std::size_t fill_row(std::size_t i) {
    std::size_t least = row_[0] = i;
    for (std::size_t j = 1; j <= other_.size(); ++j) {
      row_[j] = std::min({last_[j] + 1, row_[j - 1] + 1, last_[j - 1] + (word_[i - 1] == other_[j - 1] ? 0 : 1)});
      const bool exchanged = i > 1 && j > 1 && word_[i - 1] == other_[j - 2] && word_[i - 2] == other_[j - 1];
      if (exchanged) row_[j] = std::min(row_[j], before_[j - 2] + 1);
      least = std::min(least, row_[j]);
    }
    return least;
  }

  std::vector<std::uint32_t> word_, other_;
  std::vector<std::size_t> before_, last_, row_;
};

}  // namespace

std::size_t apart(std::string_view a, std::string_view b) {
  Distance distance(a);
  distance.take(b);
  return distance.up_to(std::max(a.size(), b.size()));
}

std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& list) {
  const auto same = std::ranges::find(list, word, english_of);
  if (same != list.end() && !word.empty()) return *same;
  std::optional<std::string> best;
  std::size_t least = 0;
  Distance distance(word);
  const std::size_t length = distance.length();
  for (const std::string& candidate : list) {
    const std::size_t other = distance.take(candidate);
    const std::size_t most = std::max<std::size_t>(1, other / 3);
    if (std::max(length, other) - std::min(length, other) > most) continue;  // they are at least so far apart
    const std::size_t off = distance.up_to(most);
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
