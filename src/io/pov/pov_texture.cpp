#include "pov_texture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {
namespace {

using scene::Coefficient;

const glm::dvec3 black(0);

/// Whether a texture multiplies it by its colour; else by the mean of its red, green and blue.
bool is_color(Coefficient coefficient) {
  using enum Coefficient;
  switch (coefficient) {
    case color:
    case M_PS:
    case M_T:
    case emission:
    case ambient:
      return true;
    case k_a:
    case k_d:
    case k_s:
    case k_ps:
    case k_t:
      return false;
  }
  contract::unreachable();
}

std::string rgb(const glm::dvec3& color) { return fmt::format("rgb <{}, {}, {}>", color.x, color.y, color.z); }

/// A summand of the colour of a point: a pigment, and what a finish makes of it.
struct PigmentTerm {
  glm::dvec3 color;
  std::string pigment;  ///< behind the colour
  std::string finish;
};

/// The summands of the local model that are not 0, each as a texture of its own. POV-Ray's diffuse term with brilliance
/// 0 is the light alone, whatever its angle: k_a.
std::vector<PigmentTerm> parts_of(const scene::Material& m) {
  std::vector<PigmentTerm> parts;
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

/// Something that textures multiply: its texture, so many times itself in red, green and blue.
struct TexturedFactor {
  std::vector<Coefficient> factors;
  std::function<std::string(const glm::dvec3&)> times;
};

std::string texture_text(const glm::dvec3& color, std::string_view pigment, std::string_view finish,
                         std::string_view normal) {
  return fmt::format("pigment {{ {}{} }}{} finish {{ ambient 0 {} }}", rgb(color), pigment, normal, finish);
}

/// All summands, each by itself: highlight and mirror, too. That of k_a has the normal of the surface, since a relief
/// that is turned away from a light is lit by it all the same.
std::vector<TexturedFactor> worn_by(const scene::Material& m, const std::string& normal) {
  using enum Coefficient;
  std::vector<TexturedFactor> parts;
  const auto add = [&](const glm::dvec3& own, std::vector<Coefficient> factors, const std::string& finish,
                       const std::string& turned = "", const std::string& pigment = "") {
    if (own == black) return;
    parts.push_back(
        {std::move(factors), [=](const glm::dvec3& n) { return texture_text(n * own, pigment, finish, turned); }});
  };
  add(m.k_d > 0 ? m.color : black, {color, k_d}, fmt::format("diffuse {}", m.k_d), normal);
  add(m.k_a > 0 ? m.color : black, {color, k_a}, fmt::format("diffuse {} brilliance 0", m.k_a));
  add(m.emission, {emission}, "diffuse 0 emission 1");
  add(m.ambient, {ambient}, "diffuse 0 emission 1");
  add(m.k_t > 0 ? m.M_T : black, {M_T, k_t}, "diffuse 0", normal, fmt::format(" filter {}", m.k_t));
  if (m.k_s > 0)
    parts.push_back({{k_s}, [=](const glm::dvec3& n) {
                       return texture_text(black, "", fmt::format("diffuse 0 phong {} phong_size {}", n.x * m.k_s, m.e),
                                           normal);
                     }});
  if (m.k_ps > 0)
    parts.push_back({{M_PS, k_ps}, [=](const glm::dvec3& n) {
                       return texture_text(
                           black, "", fmt::format("diffuse 0 reflection {{ {} }}", rgb(n * m.k_ps * m.M_PS)), normal);
                     }});
  return parts;
}

/// The product of the textures of some coefficients, in red, green and blue; of a share the mean of its three. Empty
/// where there are none.
std::optional<PovChannels> product(const scene::Material& m, const PovPatterns& patterns, const PovCoordinates& at,
                                   const std::vector<Coefficient>& factors) {
  std::optional<PovChannels> product;
  for (const Coefficient factor : factors) {
    if (m.textures.of(factor).empty()) continue;
    auto channels = patterns.channels(m.textures.of(factor), at);
    if (!channels) continue;
    if (!is_color(factor)) channels->fill(fmt::format("({})/3", fmt::join(*channels, " + ")));
    if (product)
      for (std::size_t k = 0; k < 3; ++k) (*product)[k] += "*" + (*channels)[k];
    else
      product = channels;
  }
  return product;
}

bool is_share(const scene::Material& m, const std::vector<Coefficient>& factors) {
  return std::ranges::none_of(factors, [&](Coefficient c) { return is_color(c) && !m.textures.of(c).empty(); });
}

std::string interior(const scene::Material& m) {
  return m.k_t > 0 ? fmt::format(" interior {{ ior {} }}", m.index) : "";
}

}  // namespace

std::string pov_attributes(const scene::Material& m, const PovPatterns& patterns, const PovCoordinates& at) {
  struct Term {
    std::string share;  // of itself, from place to place; empty where it is whole
    glm::dvec3 of;
    const TexturedFactor* part;
  };
  const std::string normal = m.bump ? patterns.normal(*m.bump, at) : "";
  const std::vector<TexturedFactor> parts = worn_by(m, normal);
  std::vector<Term> terms;
  for (const TexturedFactor& part : parts) {
    const auto channels = product(m, patterns, at, part.factors);
    if (!channels) {
      terms.push_back({"", glm::dvec3(1), &part});
    } else if (is_share(m, part.factors)) {
      terms.push_back({channels->front(), glm::dvec3(1), &part});
    } else {
      for (int k = 0; k < 3; ++k) {
        glm::dvec3 of(0);
        of[k] = 1;
        terms.push_back({(*channels)[static_cast<std::size_t>(k)], of, &part});
      }
    }
  }
  if (terms.empty()) return pov_attributes(m);
  std::string text;
  for (const Term& term : terms) {
    const std::string whole = term.part->times(double(terms.size()) * term.of);
    text += term.share.empty() ? fmt::format(" [1 {}]", whole)
                               : fmt::format(" [1 function {{ {} }} texture_map {{ [0 {}] [1 {}] }}]", term.share,
                                             texture_text(black, "", "diffuse 0", normal), whole);
  }
  return fmt::format("texture {{ average texture_map {{{} }} }}{}", text, interior(m));
}

std::string pov_attributes(const scene::Material& m) {
  const std::vector<PigmentTerm> parts = parts_of(m);
  const auto count = static_cast<double>(parts.size());
  const auto texture = [&](const PigmentTerm& part) {
    return fmt::format("pigment {{ {}{} }} finish {{ ambient 0 {}{} }}", rgb(count * part.color), part.pigment,
                       part.finish, &part == &parts.front() ? of_the_first(m, count) : "");
  };
  std::string text;
  if (parts.size() == 1) {
    text = fmt::format("texture {{ {} }}", texture(parts.front()));
  } else {
    for (const PigmentTerm& part : parts) text += fmt::format(" [1 {}]", texture(part));
    text = fmt::format("texture {{ average texture_map {{{} }} }}", text);
  }
  return text + interior(m);
}

}  // namespace durero::io
