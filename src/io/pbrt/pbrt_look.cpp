#include "pbrt_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "durero/text/shown.hpp"
#include "io/simple_looks.hpp"

namespace durero::io {
namespace {

/// How a type of material is shown here.
enum class PbrtLook { diffuse, mirror, glass, clear };
struct PbrtMaterial {
  std::string_view type;
  PbrtLook look;
  std::string_view color{};  ///< the parameter that tells of it
  double usual = 1;
};
constexpr std::array<PbrtMaterial, 16> pbrt_materials{{{"diffuse", PbrtLook::diffuse, "reflectance", 0.5},
                                                       {"coateddiffuse", PbrtLook::diffuse, "reflectance", 0.5},
                                                       {"diffusetransmission", PbrtLook::diffuse, "reflectance", 0.25},
                                                       {"matte", PbrtLook::diffuse, "Kd", 0.5},
                                                       {"plastic", PbrtLook::diffuse, "Kd", 0.25},
                                                       {"uber", PbrtLook::diffuse, "Kd", 0.25},
                                                       {"substrate", PbrtLook::diffuse, "Kd", 0.5},
                                                       {"translucent", PbrtLook::diffuse, "Kd", 0.25},
                                                       {"disney", PbrtLook::diffuse, "color", 0.5},
                                                       {"conductor", PbrtLook::mirror, "reflectance"},
                                                       {"mirror", PbrtLook::mirror, "Kr", 0.9},
                                                       {"metal", PbrtLook::mirror},
                                                       {"dielectric", PbrtLook::glass},
                                                       {"glass", PbrtLook::glass, "Kt"},
                                                       {"thindielectric", PbrtLook::clear},
                                                       {"interface", PbrtLook::clear}}};

}  // namespace

scene::Material PbrtLooks::material(const std::string& type, const PbrtParameters& parameters) {
  const bool is_clear = type.empty() || type == "none";  // as pbrt 3 writes an interface
  if (type != "diffuse" && type != "matte") ++simplified_[is_clear ? "interface" : type];
  const auto* const known = std::ranges::find(pbrt_materials, is_clear ? "interface" : type, &PbrtMaterial::type);
  if (known == pbrt_materials.end()) return usual();
  const glm::dvec3 shade = losses_.share_of(color(parameters, known->color, known->usual));
  switch (known->look) {
    case PbrtLook::diffuse:
      break;
    case PbrtLook::mirror:
      return mirror_of(shade);
    case PbrtLook::glass:
      return glass_of(shade, refraction(parameters));
    case PbrtLook::clear:
      return glass_of(shade);
  }
  return {.color = shade};
}

/// By how much light is bent that goes in: `eta`, which pbrt 3 calls index, too.
double PbrtLooks::refraction(const PbrtParameters& parameters) {
  for (const std::string_view name : {"eta", "index"}) {
    const PbrtParameter* const told = parameters.find(name);
    if (told == nullptr) continue;
    if (told->numbers.size() == 1 && is_index(told->numbers.front())) return told->numbers.front();
    ++losses_.patterns;
  }
  return 1.5;
}

void PbrtLooks::add_texture(const std::string& name, const std::string& kind, const PbrtParameters& parameters) {
  std::optional<glm::dvec3>& made = textures_[name];
  made.reset();
  if (kind == "constant") made = color(parameters, "value", 1);
  if (kind == "checkerboard") {
    made = (color(parameters, "tex1", 1) + color(parameters, "tex2", 0)) * 0.5;
    ++losses_.patterns;
  }
}

glm::dvec3 PbrtLooks::light(const PbrtParameters& parameters, std::string_view name, double usual) {
  const glm::dvec3 scale = color(parameters, "scale", 1);
  return losses_.light_of(color(parameters, name, usual) * scale);
}

glm::dvec3 PbrtLooks::color(const PbrtParameters& parameters, std::string_view name, double usual) {
  const PbrtParameter* const told = name.empty() ? nullptr : parameters.find(name);
  if (told == nullptr) return glm::dvec3(usual);
  if (const auto read = value(*told)) return *read;
  ++losses_.patterns;
  return glm::dvec3(std::min(usual, 0.5));
}

/// The colour that a parameter says; nothing where it does not say it itself.
std::optional<glm::dvec3> PbrtLooks::value(const PbrtParameter& told) {
  const std::vector<double>& numbers = told.numbers;
  if (told.type == "texture" && told.words.size() == 1) {
    const auto texture = textures_.find(told.words.front());
    return texture == textures_.end() ? std::nullopt : texture->second;
  }
  if (numbers.size() == 1 && told.type != "blackbody") return glm::dvec3(numbers.front());
  if (numbers.size() == 3 && (told.type == "rgb" || told.type == "color"))
    return glm::dvec3(numbers[0], numbers[1], numbers[2]);
  if (told.type != "spectrum" || numbers.empty() || numbers.size() % 2 != 0) return std::nullopt;
  double sum = 0;  // of wavelengths and values
  for (std::size_t i = 1; i < numbers.size(); i += 2) sum += numbers[i];
  ++losses_.spectra;
  return glm::dvec3(sum / (static_cast<double>(numbers.size()) / 2));
}

void PbrtLooks::name_losses(std::vector<std::string>& lost) const {
  losses_.name_losses(lost);
  for (const auto& [type, count] : simplified_)
    add_loss(lost, count, fmt::format("material {}", text::shown(type)), fmt::format("materials {}", text::shown(type)),
             "simplified: a material has one colour, or is a mirror or glass");
}

}  // namespace durero::io
