#include "durero/zed/syntax/word.hpp"

#include <mutex>
#include <ostream>
#include <unordered_set>

#include "zed/syntax/symbols.hpp"

namespace durero::zed {
namespace {

/// Finds entries by their text.
struct ByText {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  std::size_t operator()(const Word::Entry& entry) const { return entry.hash; }
  bool operator()(const Word::Entry& a, const Word::Entry& b) const { return a.text == b.text; }
  bool operator()(std::string_view a, const Word::Entry& b) const { return a == b.text; }
  bool operator()(const Word::Entry& a, std::string_view b) const { return a.text == b; }
};

}  // namespace

// Objects that are made before the program begins may be words, and find it made. Clang makes no string of GCC's
// library while it compiles: there it is the first object that is made.
#if defined(__clang__) && defined(__GLIBCXX__)
[[gnu::init_priority(101)]]
#else
constinit
#endif
const Word::Entry Word::nothing{{}, 0, &no_symbol};

const Word::Entry* Word::kept(std::string_view text) {
  // Both live until the program ends, as words may that are constants of it.
  static auto& all = *new std::unordered_set<Entry, ByText, ByText>;
  static auto& one_at_a_time = *new std::mutex;
  const std::lock_guard guard(one_at_a_time);
  auto at = all.find(text);
  if (at == all.end()) at = all.insert({std::string(text), ByText()(text), &symbol_of(text)}).first;
  return &*at;
}

std::ostream& operator<<(std::ostream& out, const Word& word) { return out << word.text(); }

}  // namespace durero::zed
