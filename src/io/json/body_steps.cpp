#include "body_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "durero/scene/by_name.hpp"
#include "durero/scene/solids.hpp"
#include "part_text.hpp"

namespace durero::io {

BodySteps::BodySteps(const scene::Scene& now, const scene::Scene& from, const scene::Scene& to,
                     std::function<void(AnyStep)> add)
    : now_(now), from_(from), to_(to), add_(std::move(add)) {
  for (const scene::ElementRef element : scene::singles_by_name(now)) {
    const scene::Body* const body = now.body(element);
    const std::string& name = now.name(element).name();
    if (body != nullptr)
      by_geometry_.emplace(part_text(*body), name);
    else
      now.visit(element, [&](const auto& shape) { by_geometry_.emplace(part_text(scene::unmoved(shape)), name); });
  }
}

void BodySteps::add_body(const std::string& name, const scene::Body& body, std::optional<std::uint32_t> material) {
  make(name, body, material);
  by_geometry_.emplace(part_text(body), name);
}

void BodySteps::remove_parts() {
  for (; !made_.empty(); made_.pop_back()) add_(removal_step(now_, made_.back()));
}

void BodySteps::make(const std::string& name, const scene::Body& body, std::optional<std::uint32_t> material) {
  if (const auto* const copy = std::get_if<scene::Instance>(&body.form))
    return add_(scene::Copying{name, part_element(scene::unmoved(copy->shape), {}), copy->mapa, material});
  const auto& solid = std::get<scene::Compound>(body.form);
  std::vector<std::string> de;
  for (const scene::Body& part : solid.parts) {
    std::string element = part_element(part, de);
    de.push_back(std::move(element));
  }
  add_(scene::Joining{solid.operation, name, std::move(de), material});
}

/// An element of that geometry, not of those names: one that is there, or a new one.
std::string BodySteps::part_element(const scene::Body& part, const std::vector<std::string>& not_of) {
  std::string geometry = part_text(part);
  const auto [first, last] = by_geometry_.equal_range(geometry);
  for (auto known = first; known != last; ++known)
    if (std::ranges::find(not_of, known->second) == not_of.end()) return known->second;
  std::string name = free_name();
  const auto* const copy = std::get_if<scene::Instance>(&part.form);
  if (copy != nullptr && model::identidad(copy->mapa))
    std::visit([&](const auto& shape) { add_(addition_step(name, shape, {})); }, copy->shape);
  else
    make(name, part, {});
  by_geometry_.emplace(std::move(geometry), name);
  made_.push_back(name);
  return name;
}

/// A name of nothing: not of a part that is there now, nor of an element of either scene.
std::string BodySteps::free_name() {
  for (;;) {
    std::string name = fmt::format("part:{}", ++last_part_);
    if (!now_.find(name) && !from_.find(name) && !to_.find(name)) return name;
  }
}

}  // namespace durero::io
