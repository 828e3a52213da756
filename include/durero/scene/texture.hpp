#pragma once
/// Textures: what a surface has from point to point, by the coordinates (u, v) of render/coordinates.hpp.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "durero/scene/picture.hpp"

namespace durero::scene {

/// What a texture is made of: a picture, or two colours by a rule. With x = repeat.x·u and y = repeat.y·v:
enum class Pattern : std::uint8_t {
  image,    ///< a picture, once in each unit square of (x, y), its lower left corner at (0, 0)
  checker,  ///< the first colour where ⌊x⌋ + ⌊y⌋ is even
  stripes,  ///< the first colour where ⌊x⌋ is even
  p6m,      ///< stars and hexagons that the plane group p6m keeps, with translations (1, 0) and (½, ½√3)
  waves     ///< from the first colour to the second by ½ + ½·sin 2πx·sin 2πy
};
/// Their keys in files, in step.
inline constexpr std::array<std::string_view, 5> pattern_words{"image", "checker", "stripes", "p6m", "waves"};

/// What of an image's texels a point shows.
enum class Filter : std::uint8_t {
  nearest,  ///< the texel that it lies in
  linear,   ///< the four around it, by how near their centres are
  mipmap    ///< that of the two best levels of the mipmap, by how far it is seen from
};
/// Their words in files, in step.
inline constexpr std::array<std::string_view, 3> filter_words{"nearest", "linear", "mipmap"};

/// What stands beyond the edges of an image.
enum class Edges : std::uint8_t { repeat, clamp };
/// Their words in files, in step.
inline constexpr std::array<std::string_view, 2> edges_words{"repeat", "clamp"};

/// What the numbers of an image are: colours on the sRGB curve, or plain numbers.
enum class TransferFunction : std::uint8_t { srgb, linear };
/// Their words in files, in step.
inline constexpr std::array<std::string_view, 2> curve_words{"srgb", "linear"};

/// A texture. Each of its components lies in [0, 1].
struct Texture {
  std::string name{};                               ///< in files
  Pattern pattern = Pattern::checker;               ///< what it is made of
  std::array<glm::dvec3, 2> colors{};               ///< of a rule, linear
  PictureFile image{};                              ///< of an image
  glm::dvec2 repeat{1};                             ///< how often it stands in a unit of u and of v, each above 0
  Filter filter = Filter::linear;                   ///< of an image
  Edges edges = Edges::repeat;                      ///< of an image
  TransferFunction curve = TransferFunction::srgb;  ///< of an image
  std::optional<double> near{};                     ///< of a mipmap: up to this distance M₀ alone is shown; above 0
  bool operator==(const Texture&) const = default;
};

/// What of a material a texture may multiply: a colour by its colour, a share by the mean of its red, green and blue.
enum class Coefficient : std::uint8_t { color, k_a, k_d, k_s, k_ps, M_PS, k_t, M_T, emission, ambient };
/// Their keys in files, in step.
inline constexpr std::array<std::string_view, 10> coefficient_words{"color", "k_a", "k_d", "k_s",      "k_ps",
                                                                    "M_PS",  "k_t", "M_T", "emission", "ambient"};

/// The names of the textures of a material, by coefficient; empty where there is none.
struct TextureUses {
  std::array<std::string, coefficient_words.size()> names{};  ///< in step with the coefficients
  bool operator==(const TextureUses&) const = default;

  /// Of one coefficient.
  const std::string& of(Coefficient coefficient) const { return names[static_cast<std::size_t>(coefficient)]; }
  /// Whether there is any.
  bool any() const {
    for (const std::string& name : names)
      if (!name.empty()) return true;
    return false;
  }
};

/// The relief of a surface, which turns its normal and moves no point (realism seed, 1.2): the mean of red, green and
/// blue of a texture as height over the surface.
struct Bump {
  std::string texture{};          ///< its name
  double height = 1;              ///< k: how high 1 is, in units of the scene; below 0 it is a depth
  std::optional<double> delta{};  ///< Δ, above 0, in parts of the texture; else one texel, or 1/64 of a rule
  bool operator==(const Bump&) const = default;
};

}  // namespace durero::scene
