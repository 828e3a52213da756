#include "by_group.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace durero::io {
namespace {

/// A name's order: what stands before its last digits, then these as a number, then the whole name.
auto order_of(std::string_view name) {
  const std::string_view stem = name.substr(0, name.find_last_not_of("0123456789") + 1);
  std::string_view digits = name.substr(stem.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return std::tuple(stem, digits.size(), digits, name);
}

GroupedElement with_group(const scene::Scene& scene, const scene::Groups& groups, scene::ElementRef element) {
  std::string name = scene.name(element).name();
  const std::string_view group = groups.of_element(name);
  return {element, group, std::move(name)};
}

std::vector<GroupedElement> in_order(std::vector<GroupedElement> elements) {
  std::ranges::sort(elements, {}, [](const GroupedElement& one) { return std::tuple(one.group, order_of(one.name)); });
  return elements;
}

}  // namespace

std::vector<GroupedElement> elements_by_group(const scene::Scene& scene, const scene::Groups& groups) {
  std::vector<GroupedElement> elements;
  scene.for_each([&](scene::ElementRef e, const auto&) { elements.push_back(with_group(scene, groups, e)); });
  return in_order(std::move(elements));
}

std::vector<GroupedElement> triangles_by_group(const scene::Scene& scene, const scene::Groups& groups) {
  std::vector<GroupedElement> triangles;
  for (std::uint32_t i = 0; i < scene.shapes<scene::Triangle>().size(); ++i)
    triangles.push_back(with_group(scene, groups, {model::Tipo::soy_triangulo, i}));
  return in_order(std::move(triangles));
}

std::vector<GroupedElement> others_by_group(const scene::Scene& scene, const scene::Groups& groups) {
  std::vector<GroupedElement> others;
  scene.for_each_single([&](scene::ElementRef e, const auto&) {
    if (e.tipo != scene::Triangle::tipo) others.push_back(with_group(scene, groups, e));
  });
  return in_order(std::move(others));
}

}  // namespace durero::io
