#pragma once
/// An edit of a scene: an operation of the specification, and the look of what it adds.

#include <cstdint>
#include <optional>
#include <variant>

#include "durero/model/operaciones.hpp"

namespace durero::scene {

/// An operation, and what the specification does not speak of.
struct Edit {
  model::Operation operation;  ///< what the specification speaks of
  /// The material of the new element, as an index into the stage's materials. Precondition: only an addition has one.
  std::optional<std::uint32_t> material{};
};

/// e?
inline const model::Elemento& name_of(const model::Operation& operation) {
  return std::visit([](const auto& in) -> const model::Elemento& { return in.e; }, operation);
}

}  // namespace durero::scene
