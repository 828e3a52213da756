#include "durero/scene/motion.hpp"

#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "durero/scene/addition.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/stage.hpp"

namespace durero::scene {
namespace {

glm::dvec3 moved_by(const glm::dvec3& p, const glm::dvec3& way) {
  const glm::dvec3 there = p + way;
  if (!std::isfinite(there.x) || !std::isfinite(there.y) || !std::isfinite(there.z))
    throw std::domain_error("an element moves beyond binary64; expected a shorter way");
  return there;
}

/// Moves the points of a shape: its centre, or its vertices.
template <class Shape>
void move_shape(Shape& shape, const glm::dvec3& way) {
  for_each_attribute<Shape>([&]<class Attribute>(const Attribute& attribute) {
    if constexpr (std::is_same_v<typename Attribute::Stored, Corners>) {
      Corners& corners = shape.*attribute.field;
      for (glm::dvec3& corner : corners) corner = moved_by(corner, way);
      if (!model::Vertices::contains(input_of<model::Terna>(corners)))
        throw std::domain_error("the vertices of a triangle that moves lie on one line then; expected a shorter way");
    } else if constexpr (std::is_same_v<typename Attribute::Stored, glm::dvec3>) {
      if (attribute.word == "centro") shape.*attribute.field = moved_by(shape.*attribute.field, way);
    }
  });
}

}  // namespace

Scene Scene::at_time(double time) const {
  Scene then = *this;
  then.audited_ = nullptr;
  for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    Table<Shape>& rows = then.table<Shape>();
    for (std::uint32_t i = 0; i < rows.size(); ++i)
      if (const auto& rare = rows.labels[i].rare; rare && rare->motion)
        move_shape(rows.shapes[i], time * *rare->motion);
  });
  if (stage().camera && stage().camera->motion != glm::dvec3(0)) {
    Camera& camera = *then.stage().camera;
    camera.eye = moved_by(camera.eye, time * camera.motion);
    camera.look_at = moved_by(camera.look_at, time * camera.motion);
  }
  return then;
}

std::size_t moving_elements(const Scene& scene) {
  std::size_t count = 0;
  scene.for_each([&](ElementRef element, const auto&) { count += scene.motion(element) != nullptr; });
  return count;
}

bool moves(const Scene& scene) {
  const auto& camera = scene.stage().camera;
  return camera && camera->shutter > 0 && (camera->motion != glm::dvec3(0) || moving_elements(scene) > 0);
}

}  // namespace durero::scene
