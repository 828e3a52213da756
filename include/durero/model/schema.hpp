#pragma once
/// The forms that the predicates of an addition, of a removal and of a change have (spec/operaciones.tex,
/// historia.tex). The schema of each type is a struct of its inputs with two tables of such forms: what it requires of
/// the inputs, and its effects on the attributes. The model and the compact scene evaluate the same tables, each over
/// its own states.

#include <functional>

#include "durero/model/escena.hpp"

namespace durero::number {
struct Surd;
}

namespace durero::model {

using contract::clause;
using number::Surd;

// What a type declares of its points, puntos.hpp and exact_point.hpp define.
struct ExactPoint;
class Puntos;
/// w ↦ potencia(θEscena, e, w)
using Potencia = std::function<Surd(const ExactPoint&)>;

/// input? ∈ Set, where `Denial` is the error that says that it is not; it names the attribute.
template <class Set, class DenialType>
struct Required {
  using Denial = DenialType;  ///< the error that denies it
  const clause* what;         ///< where the text says so

  /// input? of an operation.
  static const auto& input(const auto& in) { return attribute_of<Denial::component>().input(in); }
  /// Whether it is in the set.
  static bool holds(const auto& in) { return Set::contains(input(in)); }
};

/// c' = c ∪ { e? ↦ input? }
template <auto of_component, auto of_input>
struct Joined {
  static constexpr auto component = of_component;  ///< c, such as &Escena::mi_radio
  static constexpr auto input = of_input;          ///< the member of the operation
  const clause* what;                              ///< where the text says so
};

/// c' = c ⊕ { e? ↦ input? }
template <auto of_component, auto of_input>
struct Replaced {
  static constexpr auto component = of_component;  ///< c, such as &Escena::mi_radio
  static constexpr auto input = of_input;          ///< the member of the operation
  const clause* what;                              ///< where the text says so
};

/// c' = c
template <auto of_component>
struct Kept {
  static constexpr auto component = of_component;  ///< c, such as &Escena::mi_radio
  const clause* what;                              ///< where the text says so
};

/// c' = { e? } ⩤ c
template <auto of_component>
struct Dropped {
  static constexpr auto component = of_component;  ///< c, such as &Escena::mi_radio
  const clause* what;                              ///< where the text says so
};

/// visit(entry) for each entry of a table.
template <class Table, class Visit>
constexpr void for_each_entry(const Table& table, Visit&& visit) {
  std::apply([&](const auto&... entry) { (visit(entry), ...); }, table);
}

}  // namespace durero::model
