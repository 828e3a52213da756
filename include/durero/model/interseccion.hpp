#pragma once
/// spec/interseccion.tex: the intersection of sets of points, its reduction, and the closest intersection.

#include <cstdint>
#include <string_view>

namespace durero::model {

/// The three outcomes of the closest intersection (Resultado).
enum class Resultado : std::uint8_t { hit, miss, no_minimum };

constexpr std::string_view name(Resultado resultado) noexcept {
  constexpr std::string_view names[] = {"hit", "miss", "no_minimum"};
  return names[static_cast<int>(resultado)];
}

}  // namespace durero::model
