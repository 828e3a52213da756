#pragma once
/// The elements of a Z text that surfaces of POV-Ray become: values of attributes by their words.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "durero/io/json/written_elements.hpp"
#include "pov_polynomial.hpp"
#include "pov_transform.hpp"

namespace durero::io {

/// The values of attributes by their words.
using ValuesByWord = std::map<std::string, WrittenValue, std::less<>>;

/// A clip of surfaces, in a space of its own: the points where one to three polynomials of degree two at most are not
/// above 0, or the points outside of there.
struct PovClip {
  std::vector<PovPolynomial> within{};
  bool is_outside = false;
  PovTransform place{};
  bool is_rounded = false;
};

/// Part of a surface, in a space of its own: the zeros of a polynomial of degree four at most where one or two
/// polynomials of degree two at most are not above 0.
struct PovPiece {
  PovPolynomial equation{};
  std::vector<PovPolynomial> within{};
  PovTransform place{};           ///< of that space
  bool is_rounded = false;        ///< its place is not quite that of the text
  std::optional<PovClip> clip{};  ///< its own, in the space of the whole
  bool is_lid = false;            ///< it is the first polynomial of that clip, clipped by the equation
};

/// An element of a type of algebraic_types(), by its attributes but for its place.
struct PovElement {
  std::size_t type;
  ValuesByWord own{};
  bool is_rounded = false;  ///< its attributes are not quite those of the text
};

/// Makes values of attributes, and tells what of them is rounded.
class PovAttributes {
 public:
  /// The coefficients of a polynomial of degree four at most.
  void set_quartic(const PovPolynomial& polynomial);
  /// The coefficients of one of degree two at most, behind a letter.
  void set_quadric(char letter, const PovPolynomial& polynomial);
  /// @{ A place, by the words of a schema Espacio, or behind `corte`.
  void set_place(const PovTransform& by);
  void set_clip_place(const PovTransform& by);
  /// @}
  void set_number(const std::string& word, const number::Rational& value);
  void set_all(const ValuesByWord& values);

  /// The values, in step with the attributes of that type; nothing where one is beyond binary64.
  std::optional<std::vector<WrittenValue>> of_type(std::size_t type) const;
  bool is_rounded() const noexcept { return is_rounded_; }

 private:
  double rounded(const number::Rational& value);
  glm::dvec3 rounded(const PovPolynomial& polynomial, const std::array<PovPowers, 3>& terms);

  ValuesByWord values_{};
  bool is_rounded_ = false, is_finite_ = true;
};

/// The attributes of an element where a transformation puts it; nothing where that is beyond binary64.
std::optional<std::vector<WrittenValue>> placed_element(const PovElement& element, const PovTransform& by);

/// A piece as an element of the type `recorte`, or `tapa`, where a transformation puts it; perhaps clipped by what is
/// moved already. Nothing where it has two clips, where a number is beyond binary64 or a place has no way back. Sets
/// is_rounded where the element is not quite the piece.
std::optional<std::vector<WrittenValue>> clipped_piece(const PovPiece& piece, const PovClip* clip,
                                                       const PovTransform& by, bool& is_rounded);

}  // namespace durero::io
