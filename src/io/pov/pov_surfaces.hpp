#pragma once
/// The surfaces of a POV-Ray text that are the zeros of a polynomial.

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/written_elements.hpp"
#include "pov_transform.hpp"
#include "pov_words.hpp"

namespace durero::io {

/// The values of attributes by their words.
using ValuesByWord = std::map<std::string, WrittenValue, std::less<>>;

/// A surface: the place of its type among algebraic_types(), and its attributes but for where it stands.
struct PovSurface {
  std::size_t type;
  ValuesByWord own{};
};

/// The words of such surfaces.
inline constexpr std::array<std::string_view, 5> pov_surface_words{"torus", "quadric", "cubic", "quartic", "poly"};

/// Reads the numbers of the surface of that word, from behind its {. Nothing of a poly of degree five or more,
/// and of a part of a torus that passes through itself.
std::optional<PovSurface> read_pov_surface(PovWords& in, std::string_view word);

/// The attributes of a surface where a transformation puts it, in step with those of its type.
std::vector<WrittenValue> placed_surface(const PovSurface& surface, const PovTransform& by);

}  // namespace durero::io
