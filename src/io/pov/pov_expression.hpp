#pragma once
/// The expressions of POV-Ray's language: numbers, vectors and colours, and what its operators and functions make of
/// them.

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string_view>

#include "pov_token.hpp"

namespace durero::io {

/// A number, or two to five of them: a vector, or the red, green, blue, filter and transmit of a colour.
struct PovNumbers {
  std::array<double, 5> of{};  ///< those behind `count` are 0
  std::size_t count = 1;       ///< how many it has

  PovNumbers() = default;
  PovNumbers(double value) { of[0] = value; }
  PovNumbers(double x, double y, double z) : of{x, y, z}, count(3) {}
  /// A vector of so many numbers: the one number at each place, or those that there are, and 0.
  PovNumbers widened(std::size_t to) const;
  /// The first three, where one stands for all three.
  glm::dvec3 triple() const;
};

/// The tokens that an expression is read from.
class PovTerms {
 public:
  virtual ~PovTerms() = default;
  /// The token that stands here; null at the end of the text.
  virtual const PovToken* here() = 0;
  /// Passes it. Precondition: there is one.
  virtual void pass() = 0;
  /// Passes the name that stands here, with what belongs to it, where a program gives it a value; nothing, and passes
  /// nothing, where none does.
  virtual std::optional<PovNumbers> named() = 0;
  /// Throws InputError: `what stands here; expected …`
  virtual void refuse(const std::string& expected) const = 0;

  /// refuse(), which does not return.
  [[noreturn]] void fail_here(const std::string& expected) const;

  /// Whether that sign or word stands here.
  bool at(std::string_view text) { return here() != nullptr && here()->text == text; }
  /// Passes it, if it does.
  bool take(std::string_view text);
  /// Passes it, or fails: `what stands here; expected text where`.
  void expect(std::string_view text, std::string_view where);
};

/// Passes an expression, as far as + and − go. Throws InputError where none stands here, or where it has no finite
/// value.
PovNumbers pov_sum(PovTerms& in);
/// Passes one that may compare, and choose by ?: at its outside.
PovNumbers pov_condition(PovTerms& in);
/// Whether an expression begins with such a token, where no program names it.
bool begins_pov_expression(const PovToken& token);

}  // namespace durero::io
