#pragma once
/// Steps of scripts that add and remove one element.

#include <optional>
#include <string>

#include "durero/io/json/operations_file.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/body.hpp"

namespace durero::io {

/// What a step of a script does.
using AnyStep = decltype(ScriptStep::edit);

/// @{ The removal of a body by its own operation.
inline AnyStep body_removal(const scene::Instance&, const std::string& name) { return scene::CopyRemoval{name}; }
inline AnyStep body_removal(const scene::Compound&, const std::string& name) { return scene::SolidRemoval{name}; }
/// @}

/// The removal of an element by its own operation. Precondition: it is an element by itself.
inline AnyStep removal_step(const scene::Scene& scene, const std::string& name) {
  const scene::ElementRef element = scene.find(name).value();
  if (const scene::Body* const body = scene.body(element))
    return std::visit([&](const auto& form) { return body_removal(form, name); }, body->form);
  return scene.visit(element, [&]<class Shape>(const Shape&) -> AnyStep {
    return scene::Edit{typename Shape::Removal{model::Elemento(name)}, {}};
  });
}

/// The addition of a shape by its own operation.
template <class Shape>
AnyStep addition_step(const std::string& name, const Shape& shape, std::optional<std::uint32_t> material) {
  return scene::Edit{scene::addition(model::Elemento(name), shape), material};
}

}  // namespace durero::io
