#pragma once
/// The surfaces of a POV-Ray text that are the zeros of a polynomial.

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "pov_words.hpp"
#include "pov_written.hpp"

namespace durero::io {

/// The radii of a torus: of the circle in the middle of its tube, and of that.
struct PovTorus {
  double major, minor;
};

/// A surface: the polynomial whose zeros it is, and the radii of a torus.
struct PovSurface {
  PovPolynomial polynomial;
  std::optional<PovTorus> torus{};
};

/// The words of such surfaces.
inline constexpr std::array<std::string_view, 5> pov_surface_words{"torus", "quadric", "cubic", "quartic", "poly"};

/// Reads the numbers of the surface of that word, from behind its {. Nothing of a poly of degree five or more,
/// and of a part of a torus that passes through itself.
std::optional<PovSurface> read_pov_surface(PovWords& in, std::string_view word);

/// The place of its type among algebraic_types().
std::size_t type_of(const PovSurface& surface);

/// The attributes of a surface where a transformation puts it, in step with those of its type; nothing where that is
/// beyond binary64.
std::optional<std::vector<WrittenValue>> placed_surface(const PovSurface& surface, const PovTransform& by);

}  // namespace durero::io
