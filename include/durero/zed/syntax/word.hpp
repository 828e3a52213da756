#pragma once
/// Words of Z text are kept once in the program, so that they are compared, copied and hashed as one pointer.

#include <compare>
#include <concepts>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace durero::zed {

struct Symbol;
class Word;

/// A text is what is seen as characters, and is no word.
template <class Text>
concept TextOfWord = std::convertible_to<const Text&, std::string_view> && !std::same_as<Text, Word>;

/// A word is text in Unicode that never changes, or nothing: `mi_centro`, `_∪_`, `'`. All words of one text share what
/// the program keeps of it until it ends. Words may be made and read by several threads at once.
class Word {
 public:
  /// An entry is kept of each text.
  struct Entry {
    std::string text;                ///< the word
    std::size_t hash = 0;            ///< that of the text, so that an order of hashing is the same in every run
    const Symbol* symbol = nullptr;  ///< what the language knows of it; never null
  };

  /// Makes the empty word.
  Word() noexcept : entry_(&nothing) {}
  /// @{ Keeps a text as a word.
  Word(std::string_view text) : entry_(text.empty() ? &nothing : kept(text)) {}  // NOLINT: a text is a word
  Word(const std::string& text) : Word(std::string_view(text)) {}                // NOLINT
  Word(const char* text) : Word(std::string_view(text)) {}                       // NOLINT
  /// @}

  /// @{ Returns the text, which stays where it is until the program ends.
  const std::string& text() const { return entry_->text; }
  operator const std::string&() const { return entry_->text; }  // NOLINT: a word is a text
  operator std::string_view() const { return entry_->text; }    // NOLINT
  /// @}
  /// Returns what the language and its toolkit know of it (symbols.hpp).
  const Symbol& symbol() const { return *entry_->symbol; }
  /// Returns the hash of the text.
  std::size_t hash() const { return entry_->hash; }

  /// @{ What a string has of this name.
  static constexpr std::size_t npos = std::string::npos;
  bool empty() const { return entry_->text.empty(); }
  std::size_t size() const { return entry_->text.size(); }
  bool starts_with(std::string_view with) const { return entry_->text.starts_with(with); }
  bool ends_with(std::string_view with) const { return entry_->text.ends_with(with); }
  std::size_t find(std::string_view what) const { return entry_->text.find(what); }
  std::size_t find_first_of(std::string_view any) const { return entry_->text.find_first_of(any); }
  std::string substr(std::size_t from, std::size_t count = npos) const { return entry_->text.substr(from, count); }
  char operator[](std::size_t at) const { return entry_->text[at]; }
  char back() const { return entry_->text.back(); }
  auto begin() const { return entry_->text.begin(); }
  auto end() const { return entry_->text.end(); }
  /// @}

  /// Becomes the word with more behind it.
  Word& operator+=(std::string_view more) {
    if (!more.empty()) *this = Word(entry_->text + std::string(more));
    return *this;
  }

  /// Two words are equal where their texts are.
  friend bool operator==(const Word& a, const Word& b) { return a.entry_ == b.entry_; }
  /// Words are in the order of their bytes, as texts are.
  friend std::strong_ordering operator<=>(const Word& a, const Word& b) {
    return a.entry_ == b.entry_ ? std::strong_ordering::equal : a.entry_->text <=> b.entry_->text;
  }
  /// Compares it with a text, which is not kept.
  template <TextOfWord Text>
  friend bool operator==(const Word& a, const Text& b) {
    return a.entry_->text == std::string_view(b);
  }

  /// @{ Joins texts.
  friend std::string operator+(const Word& a, const Word& b) { return a.text() + b.text(); }
  template <TextOfWord Text>
  friend std::string operator+(const Word& a, const Text& b) {
    return a.text() + b;
  }
  template <TextOfWord Text>
  friend std::string operator+(const Text& a, const Word& b) {
    return a + b.text();
  }
  /// @}

 private:
  static const Entry nothing;
  static const Entry* kept(std::string_view text);

  const Entry* entry_;
};

/// Writes the text.
std::ostream& operator<<(std::ostream& out, const Word& word);

}  // namespace durero::zed

/// Lets words be the keys of unordered containers.
template <>
struct std::hash<durero::zed::Word> {
  /// Returns the hash that is kept with it.
  std::size_t operator()(const durero::zed::Word& word) const noexcept { return word.hash(); }
};
