#include "mitsuba_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "durero/text/shown.hpp"
#include "io/simple_looks.hpp"

namespace durero::io {
namespace {

constexpr int deepest_bsdf = 32;

/// How a type of bsdf is shown here.
enum class LookKind { diffuse, mirror, glass, clear, nested };
struct BsdfType {
  std::string_view type;
  LookKind kind;
  std::string_view color{};  ///< the property that tells of it
};
constexpr std::array<BsdfType, 18> bsdf_types{{{"diffuse", LookKind::diffuse, "reflectance"},
                                               {"roughdiffuse", LookKind::diffuse, "reflectance"},
                                               {"plastic", LookKind::diffuse, "diffuse_reflectance"},
                                               {"roughplastic", LookKind::diffuse, "diffuse_reflectance"},
                                               {"pplastic", LookKind::diffuse, "diffuse_reflectance"},
                                               {"phong", LookKind::diffuse, "diffuse_reflectance"},
                                               {"principled", LookKind::diffuse, "base_color"},
                                               {"principledthin", LookKind::diffuse, "base_color"},
                                               {"conductor", LookKind::mirror, "specular_reflectance"},
                                               {"roughconductor", LookKind::mirror, "specular_reflectance"},
                                               {"dielectric", LookKind::glass, "specular_transmittance"},
                                               {"roughdielectric", LookKind::glass, "specular_transmittance"},
                                               {"thindielectric", LookKind::clear, "specular_transmittance"},
                                               {"null", LookKind::clear},
                                               {"twosided", LookKind::nested},
                                               {"bumpmap", LookKind::nested},
                                               {"normalmap", LookKind::nested},
                                               {"mask", LookKind::nested}}};

/// Indices of refraction that Mitsuba knows by names.
struct NamedIndex {
  std::string_view name;
  double index;
};
constexpr std::array<NamedIndex, 12> named_indices{{{"vacuum", 1.0},
                                                    {"air", 1.000277},
                                                    {"water ice", 1.31},
                                                    {"water", 1.333},
                                                    {"ethanol", 1.361},
                                                    {"fused quartz", 1.458},
                                                    {"pyrex", 1.47},
                                                    {"acrylic glass", 1.49},
                                                    {"bk7", 1.5046},
                                                    {"amber", 1.55},
                                                    {"pet", 1.575},
                                                    {"diamond", 2.419}}};

const MitsubaNode* bsdf_property(const MitsubaNode& node, std::string_view name) {
  const auto found =
      std::ranges::find_if(node.children, [&](const MitsubaNode& child) { return child.name() == name; });
  return found == node.children.end() ? nullptr : &*found;
}

}  // namespace

scene::Material MitsubaLooks::usual() const { return {.color = glm::dvec3(0.5)}; }

scene::Material MitsubaLooks::material(const MitsubaNode& bsdf, int depth) {
  if (depth > deepest_bsdf)
    bsdf.fail(fmt::format("bsdf within each other, deeper than {}", deepest_bsdf),
              fmt::format("expected {} at most", deepest_bsdf));
  if (bsdf.tag == "ref") return material(target_(bsdf), depth + 1);
  const std::string type(bsdf.required("type"));
  if (type != "diffuse" && type != "twosided") ++simplified_[type];
  const auto* const known = std::ranges::find(bsdf_types, type, &BsdfType::type);
  if (known == bsdf_types.end()) return usual();
  const auto shade = [&](double usual) { return losses_.share_of(color(bsdf, known->color, usual)); };
  switch (known->kind) {
    case LookKind::diffuse:
      break;
    case LookKind::mirror:
      return mirror_of(shade(1));
    case LookKind::glass: {
      const double index = refraction(bsdf);
      return glass_of(shade(1), index);
    }
    case LookKind::clear:
      return glass_of(shade(1));
    case LookKind::nested:
      return of_nested(bsdf, depth);
  }
  return {.color = shade(0.5)};
}

/// The look of the first bsdf within another.
scene::Material MitsubaLooks::of_nested(const MitsubaNode& bsdf, int depth) {
  for (const MitsubaNode& child : bsdf.children) {
    const bool is_bsdf = child.tag == "bsdf" || (child.tag == "ref" && target_(child).tag == "bsdf");
    if (is_bsdf) return material(child, depth + 1);
  }
  return usual();
}

/// By how much light is bent that goes in.
double MitsubaLooks::refraction(const MitsubaNode& bsdf) {
  const auto index = [&](std::string_view name, double usual) {
    const MitsubaNode* const told = bsdf_property(bsdf, name);
    if (told == nullptr) return usual;
    if (told->tag == "float") {
      const double number = mitsuba_number(*told);
      if (!is_index(number)) told->fail(fmt::format("an index of {}", number), "expected a number above 0", "value");
      return number;
    }
    const auto* const known = std::ranges::find(named_indices, told->value_of("value"), &NamedIndex::name);
    if (known != named_indices.end()) return known->index;
    ++indices_;
    return usual;
  };
  return index("int_ior", 1.5046) / index("ext_ior", 1.000277);
}

glm::dvec3 MitsubaLooks::light(const MitsubaNode& node, std::string_view name, double usual) {
  return losses_.light_of(color(node, name, usual));
}

glm::dvec3 MitsubaLooks::color(const MitsubaNode& node, std::string_view name, double usual) {
  const MitsubaNode* const told = name.empty() ? nullptr : bsdf_property(node, name);
  return told == nullptr ? glm::dvec3(usual) : color_of(*told);
}

/// Of a texture, the mean of its two colours where it is a checkerboard.
glm::dvec3 MitsubaLooks::color_of(const MitsubaNode& node) {
  if (const auto read = mitsuba_color(node)) {
    losses_.spectra += read->is_mean;
    return read->rgb;
  }
  ++losses_.patterns;
  const MitsubaNode& texture = node.tag == "ref" ? target_(node) : node;
  if (texture.tag != "texture" || texture.type() != "checkerboard") return glm::dvec3(0.5);
  const auto part = [&](std::string_view name, double usual) {
    const MitsubaNode* const told = bsdf_property(texture, name);
    const auto read = told == nullptr ? std::nullopt : mitsuba_color(*told);
    return read ? read->rgb : glm::dvec3(usual);
  };
  return (part("color0", 0.4) + part("color1", 0.2)) * 0.5;
}

void MitsubaLooks::name_losses(std::vector<std::string>& lost) const {
  losses_.name_losses(lost);
  for (const auto& [type, count] : simplified_)
    add_loss(lost, count, fmt::format("use of a bsdf {}", text::shown(type)),
             fmt::format("uses of a bsdf {}", text::shown(type)),
             "simplified: a material has one colour, or is a mirror or glass");
  add_loss(lost, indices_, "index of refraction", "indices of refraction",
           "of a name that is not known: the usual one");
}

}  // namespace durero::io
