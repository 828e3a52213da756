#include "rad_looks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>

#include "durero/scene/scene.hpp"
#include "io/json/stage_fields.hpp"
#include "io/losses.hpp"
#include "io/simple_looks.hpp"

namespace durero::io {
namespace {

/// How a material sends light on, by its type.
enum class RadKind : std::uint8_t { shines, mirrors, plastic, metal, trans, dielectric, glass };

struct RadKindRow {
  std::string_view type;
  RadKind kind;
  std::size_t least;  ///< numbers
};
// The types whose numbers begin alike are one kind.
constexpr RadKindRow rad_kinds[] = {
    {"light", RadKind::shines, 3},          {"illum", RadKind::shines, 3},     {"glow", RadKind::shines, 4},
    {"spotlight", RadKind::shines, 7},      {"mirror", RadKind::mirrors, 3},   {"plastic", RadKind::plastic, 5},
    {"plastic2", RadKind::plastic, 6},      {"plasfunc", RadKind::plastic, 4}, {"plasdata", RadKind::plastic, 4},
    {"metal", RadKind::metal, 5},           {"metal2", RadKind::metal, 6},     {"metfunc", RadKind::metal, 4},
    {"metdata", RadKind::metal, 4},         {"trans", RadKind::trans, 7},      {"trans2", RadKind::trans, 8},
    {"dielectric", RadKind::dielectric, 5}, {"glass", RadKind::glass, 3}};

const RadKindRow* row_of(std::string_view type) {
  const auto* const row = std::ranges::find(rad_kinds, type, &RadKindRow::type);
  return row == std::end(rad_kinds) ? nullptr : row;
}

/// The sharpest highlight that is no mirror has an exponent that this roughness gives.
constexpr double least_roughness = 1e-3;

/// What is sent back besides Lambert's law: as a mirror does where the surface is smooth, and as a highlight where it
/// is rough. Ward's lobe of roughness α about the half vector falls as exp(−tan²(δ)/α²), and Phong's of exponent e
/// about the mirrored way, at twice the angle, as exp(−2eδ²) near its middle: e is 1/(2α²).
void set_gleam(scene::Material& look, double specular, double roughness) {
  look.k_d = 1 - specular;
  if (roughness == 0) {
    look.k_ps = specular;
  } else {
    look.k_s = specular;
    look.e = 1 / (2 * std::max(roughness, least_roughness) * std::max(roughness, least_roughness));
  }
}

}  // namespace

void RadLooks::define(const RadPrimitive& primitive) {
  RadPrimitive made = primitive;
  if (primitive.type == "alias") {
    const auto original = defined_.find(primitive.words[0]);
    if (original == defined_.end()) return;  // in a text that is read with this one
    made = original->second;
    if (primitive.modifier != "inherit") made.modifier = primitive.modifier;
    made.identifier = primitive.identifier;
  }
  defined_.insert_or_assign(made.identifier, made);
}

// Each way ends: what a modifier names was there before, but for one that is defined anew.
RadLooks::MaterialSearch RadLooks::find(const std::string& modifier) const {
  MaterialSearch found;
  std::string name = modifier;
  for (std::size_t i = 0; i <= defined_.size() && name != "void"; ++i) {
    const auto known = defined_.find(name);
    if (known == defined_.end()) break;
    const RadPrimitive& primitive = known->second;
    if (is_rad_mixture(primitive.type)) return {nullptr, true, true};
    if (!is_rad_material(primitive.type))
      found.is_changed = true;
    else if (found.material == nullptr)
      found.material = &primitive;
    name = primitive.modifier;
  }
  return found;
}

std::optional<scene::Material> RadLooks::look(const RadPrimitive& material) {
  const RadKindRow* const row = row_of(material.type);
  if (row == nullptr) {
    ++others_[material.type];
    return std::nullopt;
  }
  const std::vector<double>& n = material.numbers;
  if (n.size() < row->least)
    material.fail(fmt::format("{} has {} numbers", material.type, n.size()), fmt::format("expected {}", row->least));
  const glm::dvec3 told(n[0], n[1], n[2]), color = glm::clamp(told, 0.0, 1.0);
  scene::Material look{.k_d = 0};
  if (row->kind == RadKind::shines) {
    if (!is_color(told)) material.fail("a light below 0", "expected red, green and blue, each from 0");
    look.emission = told;
    return look;
  }
  if (color != told) ++bright_;
  const bool has_roughness =
      n.size() > 4 && (row->kind == RadKind::plastic || row->kind == RadKind::metal || row->kind == RadKind::trans);
  const double specular = n.size() > 3 ? std::clamp(n[3], 0.0, 1.0) : 0,
               roughness = has_roughness ? std::max(0.0, n[4]) : 0;
  if (roughness > 0 && specular > 0) ++rough_;
  switch (row->kind) {
    case RadKind::mirrors:
      return mirror_of(color);
    case RadKind::plastic:
    case RadKind::metal:
      look.color = color;
      set_gleam(look, specular, roughness);
      if (row->kind == RadKind::metal) look.M_PS = color;
      break;
    case RadKind::trans: {
      const double through = std::clamp(n[5], 0.0, 1.0), straight = std::clamp(n[6], 0.0, 1.0);
      look.color = color;
      set_gleam(look, specular, roughness);
      look.k_t = look.k_d * through * straight, look.M_T = color;
      look.k_d *= 1 - through;
      if (through * (1 - straight) > 0) ++dyed_;
      break;
    }
    case RadKind::dielectric:
      if (!is_index(n[3])) material.fail("an index of refraction that is not above 0", "expected one above 0");
      return glass_of(color, n[3]);
    default:
      return glass_of(color);  // of a thin pane, which turns no ray
  }
  return look;
}

std::optional<std::uint32_t> RadLooks::of(const RadPrimitive& surface) {
  const MaterialSearch found = find(surface.modifier);
  if (found.material == nullptr) {
    if (surface.modifier != "void") ++(found.is_mixed ? mixed_ : absent_);
    return std::nullopt;
  }
  if (found.is_changed) ++changed_;
  const auto made = look(*found.material);
  return made ? std::optional(materials_.number(*made)) : std::nullopt;
}

std::optional<glm::dvec3> RadLooks::light_of(const RadPrimitive& surface) const {
  const MaterialSearch found = find(surface.modifier);
  if (found.material == nullptr || found.is_changed) return std::nullopt;
  const RadKindRow* const row = row_of(found.material->type);
  const std::vector<double>& n = found.material->numbers;
  if (row == nullptr || row->kind != RadKind::shines || n.size() < row->least) return std::nullopt;
  return glm::dvec3(n[0], n[1], n[2]);
}

void RadLooks::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, absent_, "surface", "surfaces", "of no material: what its modifier names is in no text that was read");
  add_loss(lost, changed_, "surface", "surfaces", "without pattern and texture: its material's own look is kept");
  add_loss(lost, mixed_, "surface", "surfaces", "of no material: a mixture of two is none that a scene has");
  add_loss(lost, bright_, "surface", "surfaces", "of a material with a share of light beyond 0 to 1: cut to it");
  add_loss(lost, rough_, "surface", "surfaces", "of a rough material: its highlight follows another law");
  add_loss(lost, dyed_, "surface", "surfaces", "without the light that shines through and is scattered");
  for (const auto& [type, count] : others_)
    add_loss(lost, count, "surface", "surfaces", fmt::format("without material: {} is none that a scene has", type));
}

}  // namespace durero::io
