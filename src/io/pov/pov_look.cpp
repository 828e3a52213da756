#include "pov_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <tuple>

#include "durero/scene/stage.hpp"
#include "io/json/stage_fields.hpp"
#include "io/losses.hpp"
#include "pov_transform.hpp"

namespace durero::io {
namespace {

using scene::Coefficient;

const glm::dvec3 no_light(0);
/// What a literal colour begins with; others are declared by name.
constexpr std::array<std::string_view, 11> color_words{"rgb",   "rgbf",   "rgbt",  "rgbft",  "srgb", "srgbf",
                                                       "srgbt", "srgbft", "color", "colour", "<"};

/// Puts a term into its place. Whether that was free, or held the same.
template <class Value>
bool put(Value& place, const Value& free, const Value& term) {
  if (place != free && place != term) return false;
  place = term;
  return true;
}

/// Makes a material of layers, of which there are so many.
class MaterialOfLayers {
 public:
  explicit MaterialOfLayers(double count) : count_(count) {}

  /// Adds a layer, whose pattern is the texture of that name: it multiplies white. What goes through is the part of the
  /// whole that it takes from the rest. Whether a material has a place for all of it.
  bool add(const PovLayer& layer, const std::string& texture) {
    const PovColor& p = layer.pigment;
    const glm::dvec3 color = texture.empty() ? p.rgb / count_ : glm::dvec3(1);
    const double whole = 1 - p.filter - p.transmit;
    bool fits = p.filter == 0 || p.transmit == 0;
    const double diffuse = layer.diffuse * whole;
    if (diffuse != 0 && color != no_light)
      fits &= put(made.color, no_light, color) && put(layer.brilliance == 0 ? made.k_a : made.k_d, 0.0, diffuse) &&
              wears(Coefficient::color, texture);
    fits &= add_shine(made.emission, Coefficient::emission, whole * layer.emission * color, texture) &&
            add_shine(made.ambient, Coefficient::ambient, whole * layer.ambient * color, texture);
    if (const double through = p.filter + p.transmit; through != 0)
      fits &= put(made.k_t, 0.0, through) &&
              put(made.M_T, glm::dvec3(1), p.filter != 0 ? color : glm::dvec3(1 / count_)) &&
              wears(Coefficient::M_T, p.filter != 0 ? texture : "");
    if (layer.phong != 0) fits &= put(made.k_s, 0.0, layer.phong / count_) && put(made.e, 1.0, layer.phong_size);
    if (const glm::dvec3 mirror = layer.reflection / count_; mirror != no_light) {
      const double most = std::max({mirror.x, mirror.y, mirror.z});
      fits &= put(made.k_ps, 0.0, most) && put(made.M_PS, glm::dvec3(1), mirror / most);
    }
    return fits;
  }

  scene::Material made{.k_d = 0};

 private:
  bool add_shine(glm::dvec3& sum, Coefficient coefficient, const glm::dvec3& more, const std::string& texture) {
    sum += more;
    return more == no_light || wears(coefficient, texture);
  }

  /// Whether all terms of a coefficient have this texture, or none.
  bool wears(Coefficient coefficient, const std::string& texture) {
    const auto i = static_cast<std::size_t>(coefficient);
    if (!worn_[i]) worn_[i] = made.textures.names[i] = texture;
    return worn_[i] == texture;
  }

  double count_;
  std::array<std::optional<std::string>, scene::coefficient_words.size()> worn_{};
};

/// Whether the colours of a layer's pattern, of so many layers, are those of a texture.
bool are_shares(const PovLayer& layer, double count) {
  if (!layer.pattern) return true;
  const auto is_share = [&](const glm::dvec3& color) {
    const glm::dvec3 share = color / count;
    return std::min({share.x, share.y, share.z}) >= 0 && std::max({share.x, share.y, share.z}) <= 1;
  };
  return is_share(layer.pigment.rgb) && is_share(layer.pattern->second.rgb);
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
    PovLayer layer = look.layers.empty() ? default_ : look.layers.front();
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
  PovLayer& layer = look.layers.emplace_back(default_);
  while (!in_.take("}")) {
    if (read_layer(layer, look.is_other)) continue;
    if (take_pov_transform(in_)) {
      move(look);
      continue;
    }
    look.is_other = true;
    return in_.skip_block();
  }
}

void PovLooks::read_average(PovLook& look) {
  in_.expect("texture_map", "behind average");
  in_.expect("{", "behind texture_map");
  while (in_.take("[")) {
    const bool has_number = in_.here() != nullptr && begins_pov_expression(*in_.here());
    if (!has_number || in_.number("texture_map") != 1) look.is_other = true;
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
  in_.expect("{", "behind pigment");
  const PovWords begin = in_;
  layer.pattern.reset();
  if (is_one_of(color_words, in_.word())) {
    layer.pigment = in_.color("pigment");
    take_pov_transforms(in_);
    if (in_.take("}")) return;
  } else if (read_pattern(layer) && in_.take("}")) {
    return;
  }
  in_.stand_where(begin);
  layer.pattern.reset();
  if (!read_mean(layer)) is_other = true;
}

/// Reads the mean of the colours of another pigment, up to behind its }. False where it tells of none.
bool PovLooks::read_mean(PovLayer& layer) {
  PovColor sum;
  double count = 0;
  for (std::size_t open = 1; open > 0;) {
    if (in_.done()) in_.fail_here("expected } for each {");
    if (is_one_of(color_words, in_.word()) && in_.word() != "<") {
      const PovColor color = in_.color("pigment");
      sum.rgb += color.rgb, sum.filter += color.filter, sum.transmit += color.transmit;
      ++count;
      continue;
    }
    if (in_.word() == "{") ++open;
    if (in_.word() == "}") --open;
    in_.pass();
  }
  if (count == 0) return false;
  layer.pigment = {sum.rgb / count, sum.filter / count, sum.transmit / count};
  ++means_;
  return true;
}

/// Reads a pattern as it is written to POV-Ray. False where another stands here, or part of another.
bool PovLooks::read_pattern(PovLayer& layer) {
  PovPattern& pattern = layer.pattern.emplace();
  if (in_.take("checker")) {
    pattern.texture.pattern = scene::Pattern::checker;
    return read_two_colors(layer) && read_place(pattern, 1);
  }
  pattern.texture.pattern = scene::Pattern::stripes;
  return in_.take("gradient") && in_.take("x") && in_.take("color_map") && in_.take("{") && read_two_colors(layer) &&
         in_.take("}") && read_place(pattern, 2);
}

/// Two colours, in a map from one half on in [ ] each, else with a comma between.
bool PovLooks::read_two_colors(PovLayer& layer) {
  const bool is_map = layer.pattern->texture.pattern == scene::Pattern::stripes;
  for (PovColor* const color : {&layer.pigment, &layer.pattern->second}) {
    if (is_map ? !in_.take("[") || in_.take_number() != 0.5 : color == &layer.pattern->second && !in_.take(","))
      return false;
    if (!is_one_of(color_words, in_.word())) return false;
    *color = in_.color("pigment");
    if (is_map && !in_.take("]")) return false;
  }
  return layer.pigment.filter == layer.pattern->second.filter &&
         layer.pigment.transmit == layer.pattern->second.transmit;
}

/// `scale <across/x, 1/y, depth>`, and what lays it on a surface, up to the }.
bool PovLooks::read_place(PovPattern& pattern, double across) {
  if (!in_.take("scale") || !in_.take("<")) return false;
  for (int k = 0; k < 2; ++k) {
    if (in_.take_number() != (k == 0 ? across : 1) || !in_.take("/")) return false;
    const auto repeat = in_.take_number();
    if (!repeat || !(*repeat > 0) || !in_.take(",")) return false;
    pattern.texture.repeat[k] = *repeat;
  }
  const auto depth = in_.take_number();
  if (!depth || !in_.take(">")) return false;
  pattern.at.depth = *depth;
  const std::size_t from = in_.offset();
  if (in_.take("warp")) in_.skip_value();
  if (!in_.take("matrix")) return false;
  in_.skip_value();
  pattern.at.place = in_.passed(from);
  return true;
}

/// The name of the texture of a layer, of which there are so many; of one that is as another the other's. Empty where
/// it has none.
std::string PovLooks::name_of(const PovLayer& layer, double count) {
  if (!layer.pattern) return "";
  scene::Texture texture = layer.pattern->texture;
  texture.colors = {layer.pigment.rgb / count, layer.pattern->second.rgb / count};
  for (const scene::Texture& known : patterns_) {
    texture.name = known.name;
    if (texture == known) return known.name;
  }
  texture.name = fmt::format("p{}", patterns_.size() + 1);
  patterns_.push_back(texture);
  return texture.name;
}

void PovLooks::move(PovLook& look) {
  for (PovLayer& layer : look.layers)
    if (layer.pattern) layer.pattern->at.place += " moved";
}

void PovLooks::read_default() {
  in_.expect("{", "behind #default");
  bool is_other = false;
  while (!in_.take("}")) {
    const bool has_pigment = in_.word() == "pigment" || in_.word() == "texture";
    if (in_.take("texture")) {
      PovLook look;
      read_texture(look);
      is_other |= look.is_other;
      if (!look.layers.empty()) default_ = look.layers.front();
    } else if (!read_layer(default_, is_other)) {
      leave_out_value();
    }
    has_default_ |= has_pigment && !is_other;
  }
  default_.pattern.reset();
}

std::optional<PovMaterial> PovLooks::default_material() {
  if (!has_default_) return std::nullopt;
  PovLook look;
  look.at = 0;
  look.layers.push_back(default_);
  return material(look);
}

void PovLooks::read_finish(PovLayer& layer) {
  in_.expect("{", "behind finish");
  while (!in_.take("}")) {
    if (in_.take("diffuse")) {
      if (in_.take("albedo")) ++values_;
      layer.diffuse = in_.number("diffuse");
      if (in_.take(",")) in_.number("diffuse"), ++values_;
    } else if (in_.take("brilliance"))
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

std::optional<PovMaterial> PovLooks::material(const PovLook& look) {
  if (!look.at) {
    if (look.index != 1) ++values_;  // it is of another's texture
    return std::nullopt;
  }
  const auto count = static_cast<double>(look.layers.size());
  MaterialOfLayers layers(count);
  std::optional<PovPlace> at;
  bool is_other = look.is_other;
  for (const PovLayer& layer : look.layers) {
    is_other |= !are_shares(layer, count) || (at && layer.pattern && *at != layer.pattern->at);
    if (layer.pattern) at = layer.pattern->at;
    is_other |= !layers.add(layer, is_other ? "" : name_of(layer, count));
  }
  if (is_other) {
    ++textures_;
    return std::nullopt;
  }
  scene::Material& m = layers.made;
  if (m.color == no_light) m.k_d = 1;  // of black nobody sees how much
  if (m.k_t > 0) m.index = look.index;
  const auto holds = [&](const auto& field) { return field.rule.holds(m.*field.member); };
  if (!std::apply([&](const auto&... field) { return (holds(field) && ...); }, material_fields)) {
    ++textures_;
    return std::nullopt;
  }
  return PovMaterial{std::move(m), std::move(at)};
}

void PovLooks::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, textures_, "texture", "textures",
           "left out: read are pigments of one colour, or of two as export writes them, with a finish, and averages of "
           "such");
  add_loss(lost, means_, "pigment", "pigments", "of several colours: their mean");
  add_loss(lost, reliefs_, "relief", "reliefs", "(normal) left out");
  add_loss(lost, values_, "value of a finish or an interior", "values of finishes or interiors",
           "left out: a material has no place for it");
}

}  // namespace durero::io
