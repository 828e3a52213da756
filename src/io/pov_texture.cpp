#include "pov_texture.hpp"

#include <fmt/format.h>

#include <vector>

namespace durero::io {
namespace {

const glm::dvec3 black(0);

std::string rgb(const glm::dvec3& color) { return fmt::format("rgb <{}, {}, {}>", color.x, color.y, color.z); }

/// A summand of the colour of a point: a pigment, and what a finish makes of it.
struct Part {
  glm::dvec3 color;
  std::string pigment;  ///< behind the colour
  std::string finish;
};

/// The summands of the local model that are not 0, each as a texture of its own. POV-Ray's diffuse term with brilliance
/// 0 is the light alone, whatever its angle: k_a.
std::vector<Part> parts_of(const scene::Material& m) {
  std::vector<Part> parts;
  const bool shows_color = m.color != black;
  if (m.k_d > 0 && shows_color) parts.push_back({m.color, "", fmt::format("diffuse {}", m.k_d)});
  if (m.k_a > 0 && shows_color) parts.push_back({m.color, "", fmt::format("diffuse {} brilliance 0", m.k_a)});
  if (const glm::dvec3 own = m.emission + m.ambient; own != black) parts.push_back({own, "", "diffuse 0 emission 1"});
  if (m.k_t > 0) parts.push_back({m.M_T, fmt::format(" filter {}", m.k_t), "diffuse 0"});
  if (parts.empty()) parts.push_back({black, "", "diffuse 0"});
  return parts;
}

/// Highlight and mirror, which know no pigment; of `count` textures that are averaged one has them, so many times.
std::string of_the_first(const scene::Material& m, double count) {
  std::string finish;
  if (m.k_s > 0) finish += fmt::format(" phong {} phong_size {}", count * m.k_s, m.e);
  if (m.k_ps > 0) finish += fmt::format(" reflection {{ {} }}", rgb(count * m.k_ps * m.M_PS));
  return finish;
}

}  // namespace

std::string pov_attributes(const scene::Material& m) {
  const std::vector<Part> parts = parts_of(m);
  const auto count = static_cast<double>(parts.size());
  const auto texture = [&](const Part& part) {
    return fmt::format("pigment {{ {}{} }} finish {{ ambient 0 {}{} }}", rgb(count * part.color), part.pigment,
                       part.finish, &part == &parts.front() ? of_the_first(m, count) : "");
  };
  std::string text;
  if (parts.size() == 1) {
    text = fmt::format("texture {{ {} }}", texture(parts.front()));
  } else {
    for (const Part& part : parts) text += fmt::format(" [1 {}]", texture(part));
    text = fmt::format("texture {{ average texture_map {{{} }} }}", text);
  }
  if (m.k_t > 0) text += fmt::format(" interior {{ ior {} }}", m.index);
  return text;
}

}  // namespace durero::io
