#pragma once
/// The words of what a POV-Ray program leaves, one after another, and the values that stand among them.

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "pov_program.hpp"

namespace durero::io {

/// Whether the word is one of these.
bool is_one_of(std::span<const std::string_view> words, std::string_view word);

/// A colour, and the shares that go through it: of the colour, and of all light alike.
struct PovColor {
  glm::dvec3 rgb{0};
  double filter = 0, transmit = 0;
};

class PovWords final : public PovTerms {
 public:
  /// Stands on the first word. The program must outlive it.
  explicit PovWords(const PovProgram& program) : program_(program), words_(program.tokens()) {}

  /// Whether the text ends here.
  bool done() const { return next_ == words_.size(); }
  /// The word that stands here; empty at the end of the text.
  std::string_view word() const { return done() ? std::string_view() : words_[next_].text; }
  /// The number of the word that stands here.
  std::size_t offset() const { return next_; }
  /// The words from that one up to the one that stands here, with a blank between.
  std::string passed(std::size_t from) const;

  /// Goes back, or on, to where that one stands in the same text.
  void stand_where(const PovWords& other) { next_ = other.next_; }
  const PovToken* here() override { return done() ? nullptr : &words_[next_]; }
  void pass() override { ++next_; }
  std::optional<PovNumbers> named() override { return std::nullopt; }
  /// Passes a number that stands here by itself, perhaps behind a −.
  std::optional<double> take_number();
  /// Passes a comma, which the language lets one leave out.
  void comma() { take(","); }

  /// @{ The value of an expression: a finite number; three of them, where one stands for all three; a colour. `what`
  /// names it in messages.
  double number(std::string_view what);
  glm::dvec3 triple(std::string_view what);
  PovColor color(std::string_view what);
  /// @}

  /// From behind a { to behind its }.
  void skip_block();
  /// Passes what stands behind a word that is not read: a block, or values and texts; perhaps nothing.
  void skip_value();

  /// Fails at the word of that number.
  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected,
                         const contract::clause* broken = nullptr) const;
  /// `what stands here; expected …`
  void refuse(const std::string& expected) const override;

 private:
  PovNumbers value(std::string_view what);
  void skip_vector();

  const PovProgram& program_;
  const PovTokens& words_;
  std::size_t next_ = 0;
};

}  // namespace durero::io
