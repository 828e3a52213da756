#include "durero/scene/body.hpp"

namespace durero::scene {
namespace {

Instance copied(const model::Mapa& by, const Instance& instance) {
  return {instance.shape, model::compuesto(by, instance.mapa)};
}

Compound copied(const model::Mapa& by, const Compound& solid) {
  Compound copy{solid.operation, {}};
  for (const Body& part : solid.parts) copy.parts.push_back(scene::copied(by, part));
  return copy;
}

std::string_view word_of(const Instance&) { return "instancia"; }

std::string_view word_of(const Compound& solid) {
  switch (solid.operation) {
    case Compound::Operation::united:
      return "union";
    case Compound::Operation::intersected:
      return "interseccion";
    case Compound::Operation::subtracted:
      return "diferencia";
  }
  __builtin_unreachable();  // an operation is one of its enumerators
}

template <class Shape>
constexpr bool closes_a_solid = true;
template <>
constexpr bool closes_a_solid<Disc> = false;
template <>
constexpr bool closes_a_solid<Triangle> = false;

bool bounds_one(const Compound&) { return true; }

bool bounds_one(const Instance& instance) {
  return std::visit([]<class Shape>(const Shape&) { return closes_a_solid<Shape>; }, instance.shape);
}

}  // namespace

Body copied(const model::Mapa& by, const Body& body) {
  return std::visit([&](const auto& form) { return Body{copied(by, form)}; }, body.form);
}

bool bounds_a_solid(const Body& body) {
  return std::visit([](const auto& form) { return bounds_one(form); }, body.form);
}

std::string_view word_of(const Body& body) {
  return std::visit([](const auto& form) { return word_of(form); }, body.form);
}

}  // namespace durero::scene
