#pragma once
/// The words of a POV-Ray text: numbers and names up to a blank or a sign, texts in quotes, and signs, one byte each.
/// Comments are left out. Of the language's expressions the literal ones are read: a number, <x, y, z> of numbers,
/// and the axes x, y and z, or one times a number.

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "durero/io/source.hpp"

namespace durero::io {

/// Whether the word is one of these.
bool is_one_of(std::span<const std::string_view> words, std::string_view word);

/// A colour, and the shares that go through it: of the colour, and of all light alike.
struct PovColor {
  glm::dvec3 rgb{0};
  double filter = 0, transmit = 0;
};

class PovWords {
 public:
  /// Stands on the first word.
  explicit PovWords(const Source& source) : source_(source) { stand(0); }

  /// Whether the text ends here.
  bool done() const { return word_.empty(); }
  /// What stands here; empty at the end of the text.
  std::string_view word() const { return word_; }
  /// Where it stands; the end of the text where there is none.
  std::size_t offset() const { return at_; }
  /// What has been passed since that offset.
  std::string_view passed(std::size_t from) const { return source_.text().substr(from, end_ - from); }

  /// Goes back, or on, to where that one stands in the same text.
  void stand_where(const PovWords& other) { word_ = other.word_, at_ = other.at_, end_ = other.end_; }
  /// Passes what stands here. Precondition: !done().
  void pass();
  /// Passes that word, if it stands here.
  bool take(std::string_view word);
  /// Passes that word, or fails: `what stands here; expected word where`.
  void expect(std::string_view word, std::string_view where);
  /// Passes a finite number, if one stands here.
  std::optional<double> take_number();
  /// Passes a comma, which the language lets one leave out; it is missed where a sign makes a sum of both numbers.
  void comma(std::string_view where);

  /// @{ A finite number; three of them, or one for all three, or an axis; the same of colours. `what` names it in
  /// messages.
  double number(std::string_view what);
  glm::dvec3 triple(std::string_view what);
  PovColor color(std::string_view what);
  /// @}

  /// From behind a { to behind its }.
  void skip_block();
  /// What stands behind a word that is not read: a block, or numbers, texts and switches; perhaps nothing.
  void skip_value();

  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected,
                         const contract::clause* broken = nullptr) const {
    source_.fail(offset, wrong, expected, broken);
  }
  /// `what stands here; expected …`
  [[noreturn]] void fail_here(const std::string& expected) const;

 private:
  void stand(std::size_t from);
  std::size_t behind_comments(std::size_t from) const;
  std::size_t behind_comment(std::size_t from) const;
  std::size_t word_end(std::size_t from) const;
  std::string here() const;
  bool is_value() const;

  const Source& source_;
  std::string_view word_;
  std::size_t at_ = 0;   // of the word
  std::size_t end_ = 0;  // of the word before it
};

}  // namespace durero::io
