#include "pov_look.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

#include "durero/scene/stage.hpp"
#include "io/json/stage_fields.hpp"
#include "io/losses.hpp"

namespace durero::io {
namespace {

const glm::dvec3 no_light(0);

/// Puts a term into its place. Whether that was free, or held the same.
template <class Value>
bool put(Value& place, const Value& free, const Value& term) {
  if (place != free && place != term) return false;
  place = term;
  return true;
}

/// Adds a layer of so many; what goes through is the part of the whole that it takes from the rest. Whether a material
/// has a place for all of it.
bool add_layer(const PovLayer& layer, double count, scene::Material& m) {
  const PovColor& p = layer.pigment;
  const glm::dvec3 color = p.rgb / count;
  const double whole = 1 - p.filter - p.transmit;
  bool fits = p.filter == 0 || p.transmit == 0;
  const double diffuse = layer.diffuse * whole;
  if (diffuse != 0 && color != no_light)
    fits &= put(m.color, no_light, color) && put(layer.brilliance == 0 ? m.k_a : m.k_d, 0.0, diffuse);
  m.emission += whole * layer.emission * color;
  m.ambient += whole * layer.ambient * color;
  if (const double through = p.filter + p.transmit; through != 0)
    fits &= put(m.k_t, 0.0, through) && put(m.M_T, glm::dvec3(1), p.filter != 0 ? color : glm::dvec3(1 / count));
  if (layer.phong != 0) fits &= put(m.k_s, 0.0, layer.phong / count) && put(m.e, 1.0, layer.phong_size);
  if (const glm::dvec3 mirror = layer.reflection / count; mirror != no_light) {
    const double most = std::max({mirror.x, mirror.y, mirror.z});
    fits &= put(m.k_ps, 0.0, most) && put(m.M_PS, glm::dvec3(1), mirror / most);
  }
  return fits;
}

}  // namespace

bool PovLooks::read(PovLook& look) {
  const std::size_t at = in_.offset();
  if (in_.take("interior")) {
    read_interior(look);
    return true;
  }
  if (in_.take("texture")) {
    look.is_other |= look.at.has_value();  // one over another
    read_texture(look);
  } else {
    PovLayer layer = look.layers.empty() ? PovLayer() : look.layers.front();
    if (!read_layer(layer, look.is_other)) return false;
    look.is_other |= look.layers.size() > 1;
    look.layers.assign(1, layer);
  }
  if (!look.at) look.at = at;
  return true;
}

void PovLooks::read_texture(PovLook& look) {
  in_.expect("{", "behind texture");
  if (in_.take("average")) return read_average(look);
  PovLayer& layer = look.layers.emplace_back();
  while (!in_.take("}")) {
    if (read_layer(layer, look.is_other)) continue;
    look.is_other = true;
    return in_.skip_block();
  }
}

void PovLooks::read_average(PovLook& look) {
  in_.expect("texture_map", "behind average");
  in_.expect("{", "behind texture_map");
  while (in_.take("[")) {
    if (in_.number("texture_map") != 1) look.is_other = true;
    PovLayer& layer = look.layers.emplace_back();
    while (!look.is_other && read_layer(layer, look.is_other)) continue;
    if (in_.take("]")) continue;
    look.is_other = true;
    break;
  }
  if (look.is_other)
    in_.skip_block();
  else
    in_.expect("}", "behind texture_map");
  in_.expect("}", "behind average");
}

bool PovLooks::read_layer(PovLayer& layer, bool& is_other) {
  if (in_.take("pigment")) {
    read_pigment(layer, is_other);
  } else if (in_.take("finish")) {
    read_finish(layer);
  } else if (in_.take("normal")) {
    in_.expect("{", "behind normal");
    in_.skip_block();
    ++reliefs_;
  } else {
    return false;
  }
  return true;
}

void PovLooks::read_pigment(PovLayer& layer, bool& is_other) {
  constexpr std::array<std::string_view, 4> colors{"rgb", "rgbf", "rgbt", "<"};  // others are declared by name
  in_.expect("{", "behind pigment");
  while (in_.take("color") || in_.take("colour")) continue;
  if (is_one_of(colors, in_.word())) {
    layer.pigment = in_.color("pigment");
    if (in_.take("}")) return;
  }
  is_other = true;
  in_.skip_block();
}

void PovLooks::read_finish(PovLayer& layer) {
  in_.expect("{", "behind finish");
  while (!in_.take("}")) {
    if (in_.take("diffuse"))
      layer.diffuse = in_.number("diffuse");
    else if (in_.take("brilliance"))
      layer.brilliance = in_.number("brilliance");
    else if (in_.take("phong"))
      layer.phong = in_.number("phong");
    else if (in_.take("phong_size"))
      layer.phong_size = in_.number("phong_size");
    else if (in_.take("ambient"))
      layer.ambient = in_.color("ambient").rgb;
    else if (in_.take("emission"))
      layer.emission = in_.color("emission").rgb;
    else if (in_.take("reflection"))
      read_reflection(layer);
    else
      leave_out_value();
  }
  if (layer.brilliance != 0 && layer.brilliance != 1) ++values_;
}

void PovLooks::read_reflection(PovLayer& layer) {
  const bool has_block = in_.take("{");
  layer.reflection = in_.color("reflection").rgb;
  if (!has_block || in_.take("}")) return;
  ++values_;
  in_.skip_block();
}

void PovLooks::read_interior(PovLook& look) {
  in_.expect("{", "behind interior");
  while (!in_.take("}")) {
    if (in_.take("ior"))
      look.index = in_.number("ior");
    else
      leave_out_value();
  }
}

void PovLooks::leave_out_value() {
  ++values_;
  if (in_.done()) in_.fail_here("expected } for each {");
  if (in_.word() != "{") in_.pass();
  in_.skip_value();
}

std::optional<scene::Material> PovLooks::material(const PovLook& look) {
  if (!look.at) {
    if (look.index != 1) ++values_;  // it is of another's texture
    return std::nullopt;
  }
  scene::Material m{.k_d = 0};
  bool is_other = look.is_other;
  for (const PovLayer& layer : look.layers) is_other |= !add_layer(layer, static_cast<double>(look.layers.size()), m);
  if (is_other) {
    ++textures_;
    return std::nullopt;
  }
  if (m.color == no_light) m.k_d = 1;  // of black nobody sees how much
  if (m.k_t > 0) m.index = look.index;
  const auto check = [&](const auto& field) {
    check_rule(in_, *look.at, field.key, field.rule, m.*field.member, field.clause);
  };
  std::apply([&](const auto&... field) { (check(field), ...); }, material_fields);
  return m;
}

void PovLooks::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, textures_, "texture", "textures",
           "left out: read are pigments of one colour with a finish, and averages of such");
  add_loss(lost, reliefs_, "relief", "reliefs", "(normal) left out");
  add_loss(lost, values_, "value of a finish or an interior", "values of finishes or interiors",
           "left out: a material has no place for it");
}

}  // namespace durero::io
