#pragma once
/// The steps that the edits of instances and of solids share.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "durero/contract/contract.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/edit.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/solids.hpp"

namespace durero::scene {

/// The geometry of an element as a body: its own, or its shape where it stands.
inline Body body_of(const Scene& scene, ElementRef element) {
  if (const Body* const body = scene.body(element)) return *body;
  return scene.visit(element, [](const auto& shape) { return unmoved(shape); });
}

/// Adds an element with a body. Preconditions: the name is a name and no element has it.
inline void add_body(Scene& scene, const std::string& name, Body body, std::optional<std::uint32_t> material) {
  scene.apply_total(Edit{addition(model::Elemento(name), stand_in), material});
  scene.set_body(scene.find(name).value(), std::move(body));
}

/// The removal of an element with a body of that form: Form is one of Body::form. `exists` and `has_form` are its
/// preconditions.
template <class Form>
Outcome remove_body(Scene& scene, const std::string& name, const contract::clause& exists,
                    const contract::clause& has_form, std::string_view answer) {
  const auto element = scene.find(name);
  if (!element) return {model::name(model::Respuesta::elemento_no_existe), &exists};
  const Body* const body = scene.body(*element);
  if (body == nullptr || !std::holds_alternative<Form>(body->form))
    return {model::name(model::Respuesta::tipo_incorrecto), &has_form};
  scene.apply_total(Edit{model::Eliminar_Elemento{model::Elemento(name)}});
  return {answer};
}

}  // namespace durero::scene
