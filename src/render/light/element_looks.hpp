#pragma once
/// The looks of elements, as a tracer asks for them: most rays meet one of the elements that others met shortly before.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "durero/scene/element_ref.hpp"
#include "durero/scene/scene.hpp"
#include "followed.hpp"
#include "render/texture/looks.hpp"

namespace durero::render {

/// The look of an element: all that a picture needs of it beside its shape.
struct ElementLook {
  const TexturedMaterial* worn = nullptr;
  std::optional<std::uint32_t> material{};  ///< its number
  bool has_vertex_normals = false;
};

/// The looks of the elements of a context, which must outlive them. Each of a few places keeps the last one that was
/// asked for and belongs there.
class ElementLooks {
 public:
  explicit ElementLooks(const TracingContext& context) : context_(context) {}

  /// The look of an element. Valid until the next call. Precondition: the element is in the scene.
  const ElementLook& of(scene::ElementRef element) {
    Kept& kept = kept_[(element.index + static_cast<std::size_t>(element.tipo) * kept_.size() / scene::shape_count) %
                       kept_.size()];
    if (kept.element != element) kept = {element, found(element)};
    return kept.look;
  }

  std::optional<Look> varied{};  ///< the look of the last meeting, where its material has textures

 private:
  struct Kept {
    scene::ElementRef element{{}, std::numeric_limits<std::uint32_t>::max()};  // of no element
    ElementLook look{};
  };

  [[gnu::noinline]] ElementLook found(scene::ElementRef element) const {
    const auto material = context_.scene.material(element);
    return {&context_.looks.of(material), material, context_.scene.vertex_normals(element).has_value()};
  }

  const TracingContext& context_;
  std::array<Kept, 64> kept_{};
};

}  // namespace durero::render
