#include "conform/report/reproducer_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "conform/families/solids.hpp"
#include "conform/judge/draft.hpp"
#include "conform/judge/trial.hpp"
#include "durero/io/number_text.hpp"
#include "durero/number/quotient.hpp"
#include "durero/surface/surfaces.hpp"

namespace durero::conform {
namespace {

using Quaternion = std::array<double, 4>;  // x, y, z and w

/// The number as a literal with a fraction, which any language reads: 4.0, not 4.
std::string literal(double x) {
  std::string text = io::number_text(x);
  if (text.find_first_of(".en") == text.npos) text += ".0";
  return text;
}

void put(Words& words, const std::string& name, double x) { words[name] = literal(x); }
void put(Words& words, const std::string& name, const glm::dvec3& v) {
  words[name] = fmt::format("{}, {}, {}", literal(v.x), literal(v.y), literal(v.z));
  for (int i = 0; i < 3; ++i) words[fmt::format("{}.{}", name, "xyz"[i])] = literal(v[i]);
}
void put(Words& words, const std::string& name, const Quaternion& q) {
  words[name] = fmt::format("{}, {}, {}, {}", literal(q[0]), literal(q[1]), literal(q[2]), literal(q[3]));
  for (std::size_t i = 0; i < 4; ++i) words[fmt::format("{}.{}", name, "xyzw"[i])] = literal(q[i]);
}

/// A rotation that takes the axis of coordinate `from` to the unit vector d, by the least angle.
Quaternion rotation_from(int from, const glm::dvec3& d) {
  const int next = (from + 1) % 3, last = (from + 2) % 3;
  const double along = d[from], across = d[next] * d[next] + d[last] * d[last];
  const double w = along > 0 ? 1 + along : across / (1 - along);
  Quaternion q{};
  if (w == 0) {
    q[static_cast<std::size_t>(next)] = 1;
    return q;
  }
  const double length = length_of({d[next], d[last], w});
  q[static_cast<std::size_t>(next)] = -d[last] / length;
  q[static_cast<std::size_t>(last)] = d[next] / length;
  q[3] = w / length;
  return q;
}

/// Unit vectors at right angles to the unit vector d and to each other: x × y = d.
std::array<glm::dvec3, 2> beside(const glm::dvec3& d) {
  glm::dvec3 least(0);
  const glm::dvec3 size = abs(d);
  least[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
  const glm::dvec3 x = glm::normalize(glm::cross(least, d));
  return {x, glm::cross(d, x)};
}

/// The images of the x and y axes under a rotation that takes the z axis to the unit vector d.
std::array<glm::dvec3, 2> turned(const glm::dvec3& d) {
  const double sign = std::copysign(1.0, d.z), a = -1 / (sign + d.z);
  return {glm::dvec3(1 + sign * d.x * d.x * a, sign * d.x * d.y * a, -sign * d.x),
          glm::dvec3(d.x * d.y * a, sign + d.y * d.y * a, -d.y)};
}

void put_axis(Words& words, const glm::dvec3& centro, const glm::dvec3& vector) {
  const auto [x, y] = beside(vector);
  put(words, "x_axis", x);
  put(words, "y_axis", y);
  const auto [turned_x, turned_y] = turned(vector);
  put(words, "turned_x", turned_x);
  put(words, "turned_y", turned_y);
  put(words, "from_z", rotation_from(2, vector));
  put(words, "from_y", rotation_from(1, vector));
  put(words, "offset", glm::dot(centro, vector));
}

template <class Shape>
Words shape_words(const Shape& shape) {
  Words words;
  if constexpr (std::is_same_v<Shape, scene::Triangle>) {
    for (std::size_t i = 0; i < 3; ++i) put(words, std::string(1, "abc"[i]), shape.vertices[i]);
  } else {
    put(words, "centro", shape.centro);
  }
  if constexpr (requires { shape.radio; }) put(words, "radio", shape.radio);
  if constexpr (requires { shape.proporcion; }) put(words, "proporcion", shape.proporcion);
  if constexpr (requires { shape.vector; }) {
    put(words, "vector", shape.vector);
    put_axis(words, shape.centro, shape.vector);
  }
  if constexpr (surface::Axial<Shape>) {
    put(words, "altura", shape.altura);
    put(words, "half", shape.altura / 2);
    put(words, "middle", shape.centro + shape.altura / 2 * shape.vector);
    put(words, "top", shape.centro + shape.altura * shape.vector);
    put(words, "base_radius", number::round_to_binary64(radius_at_centre(shape)));
    double top_radius = 0;
    if constexpr (requires { shape.radio; }) top_radius = shape.radio;
    put(words, "top_radius", top_radius);
  }
  return words;
}

/// The quaternion of the rotation that takes the axes of coordinates to these unit vectors at right angles.
Quaternion rotation_to(const std::array<glm::dvec3, 3>& axes) {
  const auto& [x, y, z] = axes;
  const std::array<double, 4> four = {1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z,
                                      1 + x.x + y.y + z.z};
  const auto largest_of = static_cast<std::size_t>(std::ranges::max_element(four) - four.begin());
  const std::array<Quaternion, 4> rows = {{{four[0], x.y + y.x, z.x + x.z, y.z - z.y},
                                           {x.y + y.x, four[1], y.z + z.y, z.x - x.z},
                                           {z.x + x.z, y.z + z.y, four[2], x.y - y.x},
                                           {y.z - z.y, z.x - x.z, x.y - y.x, four[3]}}};
  Quaternion q = rows[largest_of];
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& part : q) part /= length;
  return q;
}

/// The words of a body: its sides, their lengths and directions, and the rotation to these where it is one: of
/// x, y and z to x, y and z, or to z, x and y, which puts the axis of z along a capsule.
Words shape_words(const AskedBody& body) {
  Words words;
  put(words, "centro", body.centro);
  std::array<glm::dvec3, 3> axes{};
  glm::dvec3 half(0);
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& side = body.sides[static_cast<std::size_t>(i)];
    half[i] = length_of(side);
    axes[static_cast<std::size_t>(i)] = side / half[i];
    const std::string name(1, "xyz"[i]);
    put(words, "side_" + name, side);
    put(words, "axis_" + name, axes[static_cast<std::size_t>(i)]);
  }
  put(words, "half", half);
  if (has_radius(body.kind)) put(words, "radio", body.radio);
  put(words, "rotation", rotation_to(axes));
  put(words, "along_y", rotation_to({axes[2], axes[0], axes[1]}));
  return words;
}

/// An upper bound on the distance from p to the points of an element that has an end; for a plane, the way to it along
/// v.
double farthest(const scene::Sphere& e, const glm::dvec3& p, const glm::dvec3&) {
  return glm::distance(p, e.centro) + e.radio;
}
double farthest(const scene::Disc& e, const glm::dvec3& p, const glm::dvec3&) {
  return glm::distance(p, e.centro) + e.radio;
}
double farthest(const scene::Plane& e, const glm::dvec3& p, const glm::dvec3& u) {
  const double slope = std::abs(glm::dot(u, e.vector));
  return slope > 0 ? glm::distance(p, e.centro) / slope : 0;
}
double farthest(const scene::Triangle& e, const glm::dvec3& p, const glm::dvec3&) {
  return std::max({glm::distance(p, e.vertices[0]), glm::distance(p, e.vertices[1]), glm::distance(p, e.vertices[2])});
}
double farthest(const AskedBody& e, const glm::dvec3& p, const glm::dvec3&) {
  return glm::distance(p, e.centro) + length_of(e.sides[0]) + length_of(e.sides[1]) + length_of(e.sides[2]) + e.radio;
}
template <surface::Axial Shape>
double farthest(const Shape& e, const glm::dvec3& p, const glm::dvec3&) {
  return glm::distance(p, e.centro) + number::round_to_binary64(radius_at_centre(e)) + e.altura;
}

}  // namespace

std::vector<ElementWords> element_words(const SuiteCase& of) {
  const scene::Scene& scene = of.the_case.scene;
  std::vector<ElementWords> all;
  scene.for_each([&]<class Shape>(scene::ElementRef e, const Shape& shape) {
    if (solid_closed_by(of.solids, e) != nullptr) return;
    const AskedBody* const body = find_body(of.bodies, e);
    ElementWords element = body ? ElementWords{std::string(word(body->kind)), shape_words(*body)}
                                : ElementWords{std::string(Shape::word), shape_words(shape)};
    element.words["name"] = scene.name(e).name();
    element.words["index"] = std::to_string(all.size());
    all.push_back(std::move(element));
  });
  return all;
}

Words ray_words(const SuiteCase& of) {
  const glm::dvec3 &p = of.the_case.rays[0].rayo.p().xyz(), &v = of.the_case.rays[0].rayo.v().xyz();
  const double length = length_of(v);
  double reach = 0;
  std::size_t count = 0;
  of.the_case.scene.for_each([&](scene::ElementRef e, const auto& shape) {
    const AskedBody* const body = find_body(of.bodies, e);
    reach = std::max(reach, body ? farthest(*body, p, v / length) : farthest(shape, p, v / length));
    count += solid_closed_by(of.solids, e) == nullptr;
  });
  Words words{{"count", std::to_string(count)}};
  put(words, "p", p);
  put(words, "v", v);
  put(words, "unit", v / length);
  put(words, "length", length);
  put(words, "segment", std::exp2(std::ceil(std::log2(2 * reach / length))));
  return words;
}

std::string expected_answer(const Finding& finding, const Profile& profile) {
  const SceneFacts facts(finding.of.the_case.scene, 1, finding.of.bodies);
  const ClaimContext trial(finding.of, 0, profile, facts);
  if (trial.truth.hit.resultado == model::Resultado::miss) return "miss";
  if (!trial.has_hit()) return "hit - 0";
  const auto name = trial.scene.name(trial.body(trial.truth.hit.elementos.front())).name();
  const glm::dvec3& w = trial.truth.hit.punto;
  if (profile.measure == Measure::point)
    return fmt::format("hit {} - {} {} {}", name, io::number_text(w.x), io::number_text(w.y), io::number_text(w.z));
  return fmt::format("hit {} {}", name, io::number_text(number_of_truth(trial)));
}

}  // namespace durero::conform
