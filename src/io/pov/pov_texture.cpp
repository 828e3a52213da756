#include "pov_texture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
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

/// A texture of the scene that multiplies a term.
struct TermTexture {
  std::string name;
  bool is_color;  ///< else its mean multiplies it
  bool operator==(const TermTexture&) const = default;
};

/// The textures of some coefficients of a term; one whose file POV-Ray does not know is none.
std::vector<TermTexture> textures_of(const scene::Material& m, const PovPatterns& patterns,
                                     std::initializer_list<Coefficient> coefficients) {
  std::vector<TermTexture> all;
  for (const Coefficient c : coefficients) {
    const std::string& name = m.textures.of(c);
    if (!name.empty() && patterns.is_known(name)) all.push_back({name, is_color(c)});
  }
  return all;
}

/// A summand of the colour of a point, as a texture of its own: a pigment, and what a finish makes of it.
struct PigmentTerm {
  glm::dvec3 color{0};
  std::vector<TermTexture> textures{};
  std::string behind{};  ///< the colour
  double diffuse = 0;
  std::string_view finish{};             ///< behind the diffuse term
  std::optional<glm::dvec3> emission{};  ///< of the pigment
  bool is_turned = true;                 ///< by a relief
};

/// What multiplies a colour to give another; nothing where no product is that to the last digit.
std::optional<glm::dvec3> factor_of(const glm::dvec3& product, const glm::dvec3& color) {
  glm::dvec3 factor(0);
  for (int k = 0; k < 3; ++k) {
    if (color[k] != 0) factor[k] = product[k] / color[k];
    if (!std::isfinite(factor[k]) || factor[k] * color[k] != product[k]) return std::nullopt;
  }
  return factor;
}

/// Adds what shines of itself: to a term of the same textures, as a factor of its colour, or as a term.
void add_own(std::vector<PigmentTerm>& terms, const glm::dvec3& own, std::vector<TermTexture> textures) {
  if (own == black) return;
  for (PigmentTerm& term : terms) {
    const auto factor = factor_of(own, term.color);
    if (term.emission || term.textures != textures || !factor) continue;
    term.emission = factor;
    return;
  }
  terms.push_back({.color = own, .textures = std::move(textures), .emission = glm::dvec3(1), .is_turned = false});
}

/// The summands of the local model that are not 0, without highlight and mirror. POV-Ray's diffuse term with brilliance
/// 0 is the light alone, whatever its angle: k_a. It has the normal of the surface, since a relief that is turned away
/// from a light is lit by it all the same.
std::vector<PigmentTerm> terms_of(const scene::Material& m, const PovPatterns& patterns) {
  using enum Coefficient;
  std::vector<PigmentTerm> terms;
  if (m.k_d > 0 && m.color != black)
    terms.push_back({.color = m.color, .textures = textures_of(m, patterns, {color, k_d}), .diffuse = m.k_d});
  if (m.k_a > 0 && m.color != black)
    terms.push_back({.color = m.color,
                     .textures = textures_of(m, patterns, {color, k_a}),
                     .diffuse = m.k_a,
                     .finish = " brilliance 0",
                     .is_turned = false});
  const std::vector<TermTexture> of_emission = textures_of(m, patterns, {emission}),
                                 of_ambient = textures_of(m, patterns, {ambient});
  if (of_emission == of_ambient) {
    add_own(terms, m.emission + m.ambient, of_emission);
  } else {
    add_own(terms, m.emission, of_emission);
    add_own(terms, m.ambient, of_ambient);
  }
  if (m.k_t > 0)
    terms.push_back(
        {.color = m.M_T, .textures = textures_of(m, patterns, {M_T, k_t}), .behind = fmt::format(" filter {}", m.k_t)});
  return terms;
}

/// The writer of the texture of a material at the coordinates of an element: an average of textures, of which each
/// counts so many times itself.
class TextureWriter {
 public:
  TextureWriter(const scene::Material& m, const PovPatterns& patterns, const PovCoordinates& at)
      : m_(m), patterns_(patterns), at_(at), normal_(m.bump ? patterns.normal(*m.bump, at) : "") {}

  std::string text() {
    const std::vector<TermTexture> of_light = textures_of(m_, patterns_, {Coefficient::k_s}),
                                   of_mirror = textures_of(m_, patterns_, {Coefficient::M_PS, Coefficient::k_ps});
    const bool shines = m_.k_s > 0 && of_light.empty(), mirrors = m_.k_ps > 0 && of_mirror.empty();
    if (m_.k_s > 0 && !shines) add_light(of_light);
    if (m_.k_ps > 0 && !mirrors) add_mirror(of_mirror);
    std::vector<PigmentTerm> terms = terms_of(m_, patterns_);
    // One of them has the highlight and the mirror, which know no pigment, and turn with the relief.
    auto bright = std::ranges::find_if(terms, [&](const PigmentTerm& t) { return t.is_turned || normal_.empty(); });
    if (bright == terms.end() && (shines || mirrors || (terms.empty() && textures_.empty())))
      bright = terms.insert(terms.end(), PigmentTerm());
    const double count = static_cast<double>(terms.size() + textures_.size());
    std::string finish;
    if (shines) finish += fmt::format(" phong {} phong_size {}", count * m_.k_s, m_.e);
    if (mirrors) finish += fmt::format(" reflection {{ {} }}", rgb(count * m_.k_ps * m_.M_PS));
    std::vector<std::string> all;
    for (auto term = terms.begin(); term != terms.end(); ++term)
      all.push_back(term_text(*term, count, term == bright ? finish : ""));
    for (const auto& texture : textures_) all.push_back(texture(count));
    if (all.size() == 1) return fmt::format("texture {{ {} }}", all.front());
    std::string entries;
    for (const std::string& one : all) entries += fmt::format(" [1 {}]", one);
    return fmt::format("texture {{ average texture_map {{{} }} }}", entries);
  }

 private:
  std::string term_text(const PigmentTerm& term, double count, std::string_view more) const {
    const std::string picture = picture_of(term);
    const double times = picture.empty() ? 1 : count;  // a picture is no more than itself: its finish is
    std::string finish = fmt::format("diffuse {}{}", times * term.diffuse, term.finish);
    if (const auto& e = term.emission)
      finish += e->x == e->y && e->y == e->z ? fmt::format(" emission {}", times * e->x)
                                             : fmt::format(" emission {}", rgb(times * *e));
    return texture_text(picture.empty() ? pigment_of(term, count * term.color) : picture, term.is_turned,
                        finish + std::string(more));
  }

  std::string texture_text(std::string_view pigment, bool is_turned, std::string_view finish) const {
    return fmt::format("pigment {{ {} }}{} finish {{ ambient 0 {} }}", pigment, is_turned ? normal_ : "", finish);
  }
  std::string black_text(std::string_view finish) const { return texture_text(rgb(black), true, finish); }

  /// The picture that is the pigment of a term as it stands; empty where something else multiplies it.
  std::string picture_of(const PigmentTerm& term) const {
    const bool is_alone = term.textures.size() == 1 && term.textures.front().is_color;
    return is_alone && term.color == glm::dvec3(1) && term.behind.empty()
               ? patterns_.picture(term.textures.front().name, at_)
               : "";
  }

  std::string pigment_of(const PigmentTerm& term, const glm::dvec3& color) const {
    if (term.textures.empty()) return rgb(color) + term.behind;
    if (const auto ends = ends_of(term.textures))
      return patterns_.pattern(term.textures.front().name, at_, PovLevel::color, rgb(color * ends->first) + term.behind,
                               rgb(color * ends->second) + term.behind);
    return pov_pigment(product(term.textures), color, term.behind);
  }

  /// What the two colours of a pattern make of a term, where all its textures are that pattern. Between them, in waves,
  /// it is a mixture of both only if the pattern counts once.
  std::optional<std::pair<glm::dvec3, glm::dvec3>> ends_of(const std::vector<TermTexture>& textures) const {
    const scene::Texture& texture = patterns_.named(textures.front().name);
    const bool is_one = std::ranges::all_of(textures, [&](const TermTexture& t) { return t.name == texture.name; });
    if (!is_one || texture.pattern == scene::Pattern::image) return std::nullopt;
    if (texture.pattern == scene::Pattern::waves && textures.size() > 1) return std::nullopt;
    std::pair<glm::dvec3, glm::dvec3> ends{1, 1};
    for (const TermTexture& t : textures) {
      ends.first *= factor(texture.colors[0], t.is_color);
      ends.second *= factor(texture.colors[1], t.is_color);
    }
    return ends;
  }
  static glm::dvec3 factor(const glm::dvec3& color, bool is_color) {
    return is_color ? color : glm::dvec3((color.x + color.y + color.z) / 3);
  }

  /// The product of some textures, in red, green and blue; of a share the mean of its three.
  PovChannels product(const std::vector<TermTexture>& textures) const {
    PovChannels product;
    for (const TermTexture& texture : textures) {
      PovChannels channels = patterns_.channels(texture.name, at_).value();
      if (!texture.is_color) channels.fill(fmt::format("({})/3", fmt::join(channels, " + ")));
      for (std::size_t k = 0; k < 3; ++k) product[k] += (product[k].empty() ? "" : "*") + channels[k];
    }
    return product;
  }

  void add_light(const std::vector<TermTexture>& textures) {
    add_varying(textures, [this](const glm::dvec3& times) {
      return black_text(fmt::format("diffuse 0 phong {} phong_size {}", times.x * m_.k_s, m_.e));
    });
  }
  void add_mirror(const std::vector<TermTexture>& textures) {
    add_varying(textures, [this](const glm::dvec3& times) {
      return black_text(fmt::format("diffuse 0 reflection {{ {} }}", rgb(times * m_.k_ps * m_.M_PS)));
    });
  }

  /// Adds what varies without a pigment, so many times itself in red, green and blue.
  void add_varying(const std::vector<TermTexture>& textures,
                   const std::function<std::string(const glm::dvec3&)>& times) {
    if (const auto ends = ends_of(textures)) {
      textures_.push_back([=, this, name = textures.front().name](double count) {
        return patterns_.pattern(name, at_, PovLevel::texture, times(count * ends->first), times(count * ends->second),
                                 normal_.empty());
      });
      return;
    }
    const bool is_share = std::ranges::none_of(textures, &TermTexture::is_color);
    const PovChannels channels = product(textures);
    for (int k = 0; k < (is_share ? 1 : 3); ++k) {
      glm::dvec3 of(is_share ? 1 : 0);
      of[k] = 1;
      textures_.push_back([=, this, share = channels[static_cast<std::size_t>(k)]](double count) {
        return fmt::format("function {{ {} }} texture_map {{ [0 {}] [1 {}] }}", share, black_text("diffuse 0"),
                           times(count * of));
      });
    }
  }

  const scene::Material& m_;
  const PovPatterns& patterns_;
  const PovCoordinates& at_;
  const std::string normal_;
  std::vector<std::function<std::string(double)>> textures_;  // that vary without a pigment, so many times themselves
};

}  // namespace

std::string pov_attributes(const scene::Material& m, const PovPatterns& patterns, const PovCoordinates& at) {
  return TextureWriter(m, patterns, at).text() + (m.k_t > 0 ? fmt::format(" interior {{ ior {} }}", m.index) : "");
}

}  // namespace durero::io
