#include "durero/render/bundle/pencil.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "durero/render/light/directions.hpp"
#include "durero/scene/axes_across.hpp"

namespace durero::render {
namespace {

/// The step from the point of the axis to where a ray that is `off` across it meets the plane across n.
glm::dvec3 slid(const glm::dvec3& off, const glm::dvec3& direction, const glm::dvec3& n) {
  return off - direction * (glm::dot(n, off) / glm::dot(n, direction));
}

}  // namespace

Pencil::Pencil(const glm::dvec3& origin, const glm::dvec3& direction) : point_(origin), direction_(direction) {
  const scene::AxesAcross axes = scene::axes_across(direction);
  first_ = axes.first;
  second_ = axes.second;
}

void Pencil::transfer(const glm::dvec3& to) {
  const double t = glm::dot(to - point_, direction_);
  glm::dmat4 way(1);  // x and y grow by t times u and v; a column stands for what it multiplies
  way[2][0] = way[3][1] = t;
  matrix_ = way * matrix_;
  point_ = to;
}

template <class Turned>
void Pencil::turn(const glm::dvec3& n, const glm::dvec3& direction, Turned&& turned) {
  const scene::AxesAcross axes = scene::axes_across(direction);
  glm::dmat4 surface(0);
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3& axis = i % 2 == 0 ? first_ : second_;
    const glm::dvec3 step = i < 2 ? slid(axis, direction_, n) : glm::dvec3(0);
    const glm::dvec3 lean = turned(i < 2 ? glm::dvec3(0) : axis, step);
    surface[i] = {glm::dot(step, axes.first), glm::dot(step, axes.second), glm::dot(lean, axes.first),
                  glm::dot(lean, axes.second)};
  }
  matrix_ = surface * matrix_;
  direction_ = direction;
  first_ = axes.first;
  second_ = axes.second;
}

void Pencil::reflect(const glm::dvec3& n, const glm::dmat3& curvature) {
  const glm::dvec3 d = direction_;
  turn(n, mirrored(d, n), [&](const glm::dvec3& lean, const glm::dvec3& step) {
    const glm::dvec3 turned = curvature * step;  // of the normal
    return lean - 2.0 * ((glm::dot(lean, n) + glm::dot(d, turned)) * n + glm::dot(d, n) * turned);
  });
}

bool Pencil::refract(const glm::dvec3& n, const glm::dmat3& curvature, double ratio) {
  const glm::dvec3 d = direction_;
  const auto beyond = refracted(d, n, ratio);
  if (!beyond) return false;
  // t = ratio·d + g·n, where g = ratio·c − far, and c and far are the cosines on the two sides (refraccion.def.1).
  const double c = -glm::dot(d, n), far = -glm::dot(*beyond, n), g = ratio * c - far;
  turn(n, *beyond, [&](const glm::dvec3& lean, const glm::dvec3& step) {
    const glm::dvec3 turned = curvature * step;
    const double of_c = -(glm::dot(lean, n) + glm::dot(d, turned));
    const double of_g = (ratio - ratio * ratio * c / far) * of_c;
    return ratio * lean + g * turned + of_g * n;
  });
  return true;
}

glm::dvec3 Pencil::offset(const Deviation& at_start) const {
  const Deviation here = matrix_ * at_start;
  return here.x * first_ + here.y * second_;
}

glm::dvec3 Pencil::leaning(const Deviation& at_start) const {
  const Deviation here = matrix_ * at_start;
  return direction_ + here.z * first_ + here.w * second_;
}

glm::dvec3 Pencil::on_plane(const Deviation& at_start, const glm::dvec3& n) const {
  return slid(offset(at_start), direction_, n);
}

double second_order(const glm::dvec3& at_first, const glm::dvec3& at_second, const glm::dvec3& at_both) {
  return glm::length(at_first) + glm::length(at_second) + glm::length(at_both - at_first - at_second);
}

}  // namespace durero::render
