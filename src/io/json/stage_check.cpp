#include "durero/io/json/stage_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "durero/io/json/json_pointer.hpp"
#include "durero/model/distribuida.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

using number::exact;

/// A share of a file is stored within 2⁻⁵⁴ of it, and so is a part of its colour: the two products are within 2⁻⁵² of
/// what the file says, and so is their sum within 2⁻⁵¹. What adds up to one in the file is not warned of.
constexpr double as_stored = 0x1p-50;

constexpr std::string_view components[] = {"red", "green", "blue"};

void judge(model::Judgements& all, const model::Judgements& one) {
  if (all.empty()) all = one;
  for (std::size_t i = 0; i < one.size(); ++i) all[i].holds = all[i].holds && one[i].holds;
}

/// A light as a point sees it that it stands above; where it stands, and who sees it, is none of the file's.
model::Judgement judged(const glm::dvec3& color) {
  model::Judgement of_all{&model::Fuente_inv_1, true};
  for (glm::length_t i = 0; i < 3; ++i)
    of_all.holds = of_all.holds && inv(model::Fuente{{0, 0, 1}, exact(color[i]), 1}).front().holds;
  return of_all;
}

/// The lens of a camera, which looks along z here. A focus that the file leaves out is the distance of look_at.
model::Lente lens_of(const scene::Camera& camera) {
  const double focus = camera.focus > 0 ? camera.focus : glm::distance(camera.eye, camera.look_at);
  return {{0, 0, 0}, {0, 0, 1}, exact(camera.aperture), exact(focus)};
}

std::optional<Warning> warning(const scene::Material& material) {
  for (glm::length_t i = 0; i < 3; ++i) {
    const model::Material m = material_of(material, i);
    if (conserva(m)) continue;
    const double sent = number::round_to_binary64(m.k_ps * m.M_PS + m.k_t * m.M_T);
    if (sent <= 1 + as_stored) continue;
    return Warning{fmt::format("material {} sends on {} of the {} light that it receives; expected k_ps * M_PS + k_t * "
                               "M_T ≤ 1 (conserva.def.1)",
                               text::shown(material.name), sent, components[i]),
                   "/materials/" + json::pointer_token(material.name)};
  }
  return std::nullopt;
}

}  // namespace

model::Material material_of(const scene::Material& material, glm::length_t component) {
  return {.k_a = exact(material.k_a),
          .k_d = exact(material.k_d),
          .k_s = exact(material.k_s),
          .k_ps = exact(material.k_ps),
          .k_t = exact(material.k_t),
          .C = exact(material.color[component]),
          .M_PS = exact(material.M_PS[component]),
          .M_T = exact(material.M_T[component]),
          .emisividad = exact(material.emission[component]),
          .A_G = exact(material.ambient[component]),
          .e = exact(material.e),
          .indice = exact(material.index)};
}

model::Judgements stage_invariants(const scene::Stage& stage) {
  model::Judgements all;
  for (const scene::Material& material : stage.materials)
    for (glm::length_t i = 0; i < 3; ++i) judge(all, inv(material_of(material, i)));
  model::Judgements lights;
  for (const scene::Light& light : stage.lights) judge(lights, {judged(light.color)});
  for (const scene::DirectionalLight& light : stage.directional_lights) judge(lights, {judged(light.color)});
  all.insert(all.end(), lights.begin(), lights.end());
  if (stage.camera && stage.camera->aperture > 0) {
    const model::Judgements lens = inv(lens_of(*stage.camera));
    all.insert(all.end(), lens.begin() + 1, lens.end());  // the axis is made a unit vector, up to rounding
  }
  return all;
}

std::vector<Warning> stage_warnings(const scene::Stage& stage) {
  std::vector<Warning> all;
  for (const scene::Material& material : stage.materials)
    if (auto one = warning(material)) all.push_back(std::move(*one));
  return all;
}

}  // namespace durero::io
