#include "rad_written_look.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <initializer_list>
#include <string>

#include "durero/scene/scene.hpp"
#include "rad_looks.hpp"

namespace durero::io {
namespace {

std::vector<double> numbers_of(const glm::dvec3& color, std::initializer_list<double> more = {}) {
  std::vector<double> numbers{color.x, color.y, color.z};
  numbers.insert(numbers.end(), more);
  return numbers;
}

/// A colour times a share, divided by another share: where both are one, it stays bit for bit.
glm::dvec3 scaled(const glm::dvec3& color, double by, double over = 1) {
  if (by == over || over == 0) return color;
  return glm::min(color * by / over, glm::dvec3(1));
}

/// The roughness whose highlight falls as the e-th power of a cosine (set_gleam of rad_looks.cpp), and one where it
/// falls by no power.
double roughness_of(double e) { return e > 0 ? 1 / std::sqrt(2 * e) : 1; }

bool sends_no_light_on(const scene::Material& m) {
  return m.k_a == 0 && m.k_s == 0 && m.k_ps == 0 && m.k_t == 0 && (m.k_d == 0 || m.color == glm::dvec3(0));
}

/// The share of light that goes back by the mirrored way, and how rough the surface is there.
struct RadGleam {
  double share, roughness;
};
RadGleam gleam_of(const scene::Material& m) {
  if (m.k_ps > 0) return {m.k_ps, 0};
  return {m.k_s, m.k_s > 0 ? roughness_of(m.e) : 0};
}

/// Of light that goes straight on, dyed as what Lambert's law sends back.
RadWrittenLook trans_of(const scene::Material& m) {
  const RadGleam gleam = gleam_of(m);
  const double sent = m.k_d + m.k_t;
  return {"trans", numbers_of(scaled(m.color, sent, 1 - gleam.share), {gleam.share, gleam.roughness, m.k_t / sent, 1})};
}

/// A surface by Lambert's law, which is also a mirror or has a highlight.
RadWrittenLook lambert_of(const scene::Material& m) {
  const RadGleam gleam = gleam_of(m);
  const bool is_metal = m.k_ps > 0 && m.M_PS == m.color && m.color != glm::dvec3(1);
  return {is_metal ? "metal" : "plastic",
          numbers_of(scaled(m.color, m.k_d, 1 - gleam.share), {gleam.share, gleam.roughness})};
}

}  // namespace

RadWrittenLook rad_written_look(const scene::Material& m) {
  // A glow of reach 0 lights nothing, as a surface of a scene that shines.
  if (sends_no_light_on(m) && m.emission != glm::dvec3(0)) return {"glow", numbers_of(m.emission, {0})};
  if (m.k_t > 0 && m.k_d > 0 && m.color == m.M_T) return trans_of(m);
  if (m.k_t > 0 && m.k_t >= std::max(m.k_d, m.k_ps)) {
    const glm::dvec3 color = scaled(m.M_T, m.k_t);
    if (m.index == 1) return {"glass", numbers_of(color)};
    return {"dielectric", numbers_of(color, {m.index, 0})};
  }
  if (m.k_ps > 0 && m.k_d == 0) return {"mirror", numbers_of(scaled(m.M_PS, m.k_ps))};
  return lambert_of(m);
}

scene::Material rad_read_look(const RadWrittenLook& written) {
  scene::Scene alone;
  RadLooks looks(alone);
  RadPrimitive primitive{nullptr, 0, "void", std::string(written.type), "m"};
  primitive.numbers = written.numbers;
  looks.define(primitive);
  primitive.modifier = "m";
  scene::Material read = alone.stage().materials.at(looks.of(primitive).value());
  read.name.clear();
  return read;
}

}  // namespace durero::io
