#pragma once
/// The three outcomes of the closest intersection (spec/interseccion.tex).

#include <cstdint>
#include <string_view>

namespace durero::model {

/// hit: there is a nearest point. miss: no point. no_minimum: points as near to the origin as one likes (Resultado).
enum class Resultado : std::uint8_t { hit, miss, no_minimum };

constexpr std::string_view name(Resultado resultado) noexcept {
  constexpr std::string_view names[] = {"hit", "miss", "no_minimum"};
  return names[static_cast<int>(resultado)];
}

}  // namespace durero::model
