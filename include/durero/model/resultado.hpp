#pragma once
/// The three outcomes of the closest intersection (spec/interseccion.tex).

#include <cstdint>
#include <string_view>

#include "durero/contract/contract.hpp"

namespace durero::model {

/// hit: there is a nearest point. miss: no point. no_minimum: points as near to the origin as one likes (Resultado).
enum class Resultado : std::uint8_t { hit, miss, no_minimum };

/// Its name in the text.
constexpr std::string_view name(Resultado resultado) noexcept {
  switch (resultado) {
    case Resultado::hit:
      return "hit";
    case Resultado::miss:
      return "miss";
    case Resultado::no_minimum:
      return "no_minimum";
  }
  contract::unreachable();
}

}  // namespace durero::model
