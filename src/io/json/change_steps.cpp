#include "change_steps.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>

#include "durero/model/cambio.hpp"
#include "durero/model/vista.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {
namespace {

/// @{ Whether two values of an attribute have the same text.
bool is_same_text(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }
bool is_same_text(const glm::dvec3& a, const glm::dvec3& b) { return is_written_alike(a, b); }
bool is_same_text(const scene::Corners& a, const scene::Corners& b) {
  return std::ranges::equal(a, b, [](const glm::dvec3& p, const glm::dvec3& q) { return is_written_alike(p, q); });
}
/// @}

/// The change of an attribute to the value that a shape has, by the name of its type.
template <class Shape, class Attribute>
AnyStep change_to(const std::string& name, const Shape& shape, const Attribute& attribute) {
  std::optional<AnyStep> step;
  const auto consider = [&]<class Change>(std::type_identity<Change>) {
    const auto& of = model::attribute_of<Change::component>();
    if (of.word != attribute.word) return;
    using Input = std::remove_cvref_t<decltype(of.input(std::declval<Change&>()))>;
    using Stored = std::remove_cvref_t<decltype(scene::stored(std::declval<const Input&>()))>;
    if constexpr (std::is_same_v<Stored, std::remove_cvref_t<decltype(shape.*attribute.field)>>)
      step = model::AttributeChange(
          Change{model::Elemento(name), scene::input_of<Input>(shape.*attribute.field), Shape::tipo});
  };
  [&]<class... Change>(std::type_identity<std::variant<Change...>>) {
    (consider(std::type_identity<Change>()), ...);
  }(std::type_identity<model::AttributeChange>());
  return step.value();
}

/// The names of the elements that are in some group.
std::vector<std::string> grouped_names(const scene::Groups& a, const scene::Groups& b) {
  std::vector<std::string> names;
  for (const scene::Groups* const of : {&a, &b})
    for (const auto& [g, group] : of->table())
      names.insert(names.end(), group.elementos.begin(), group.elementos.end());
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  return names;
}

}  // namespace

bool is_written_alike(const glm::dvec3& a, const glm::dvec3& b) {
  return is_same_text(a.x, b.x) && is_same_text(a.y, b.y) && is_same_text(a.z, b.z);
}

bool has_same_rest(const scene::Scene& from, const scene::Scene& to, const std::string& name) {
  const scene::ElementRef x = from.find(name).value(), y = to.find(name).value();
  const glm::dvec3 *const one = from.motion(x), *const other = to.motion(y);
  const bool same_motion = one == nullptr || other == nullptr ? one == other : is_written_alike(*one, *other);
  return from.body(x) == nullptr && to.body(y) == nullptr && same_motion && from.wrap(x) == to.wrap(y) &&
         from.vertex_normals(x) == to.vertex_normals(y);
}

std::vector<AnyStep> changes_between(const scene::Scene& from, const scene::Scene& to, const std::string& name) {
  const scene::ElementRef x = from.find(name).value(), y = to.find(name).value();
  std::vector<AnyStep> steps;
  from.visit(x, [&]<class Shape>(const Shape& old) {
    const Shape made = to.shapes<Shape>()[y.index];
    scene::for_each_attribute<Shape>([&](const auto& attribute) {
      if (!is_same_text(old.*attribute.field, made.*attribute.field)) steps.push_back(change_to(name, made, attribute));
    });
  });
  const auto material = to.material(y);
  if (material == from.material(x)) return steps;
  const model::Elemento e(name);
  if (material)
    steps.emplace_back(model::LookChange(model::Cambiar_Material{e, to.stage().materials[*material].name}));
  else
    steps.emplace_back(model::LookChange(model::Quitar_Material{e}));
  return steps;
}

std::vector<AnyStep> element_moves(scene::Groups& groups, const scene::Groups& to) {
  const auto is_kept = [&](std::string_view g) {
    return g.empty() || (groups.table().contains(g) && to.table().contains(g));
  };
  std::vector<AnyStep> moves;
  for (const std::string& name : grouped_names(groups, to)) {
    const std::string old(groups.of_element(name)), made(to.of_element(name));
    if (old == made || !is_kept(old) || !is_kept(made)) continue;
    if (made.empty()) {
      moves.emplace_back(model::LookChange(model::Quitar_Grupo{model::Elemento(name)}));
      groups.take_out(name);
    } else {
      moves.emplace_back(model::LookChange(model::Cambiar_Grupo{model::Elemento(name), made}));
      groups.put(name, made);
    }
  }
  return moves;
}

}  // namespace durero::io
