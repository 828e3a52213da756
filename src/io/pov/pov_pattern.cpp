#include "pov_pattern.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "durero/contract/contract.hpp"
#include "durero/io/file_name.hpp"
#include "durero/scene/stage.hpp"

namespace durero::io {
namespace {

using scene::Pattern;
using scene::Surroundings;
using scene::Texture;

/// A function of POV-Ray's language, by its name, and what it needs before it.
struct DeclaredFunction {
  std::string_view name, text;
};

/// Of numbers A and B, what patterns and coordinates are made of. Odd is 1 where the whole part is odd, else 0. Of p6m,
/// as render/texture.hpp has it: the nearest point of the lattice, of each of its two rectangular halves the nearest,
/// then the nearer one; what is above the mirror at 30° comes to below it; and what two lines tell apart.
constexpr DeclaredFunction helpers[] = {
    {"Turn", "#declare Turn = function(A, B) { atan2(B, A)/(2*pi) - floor(atan2(B, A)/(2*pi)) }\n"},
    {"Latitude", "#declare Latitude = function(A, B, C) { 0.5 + atan2(B, sqrt(A*A + C*C))/pi }\n"},
    {"Odd", "#declare Odd = function(A) { floor(A) - 2*floor(floor(A)/2) }\n"},
    {"Hexagons",
     R"(#declare Across = function(A) { A - floor(A + 0.5) }
#declare Upwards = function(A) { A - sqrt(3)*floor(A/sqrt(3) + 0.5) }
#declare Nearer = function(A, B) { pow(Across(A), 2) + pow(Upwards(B), 2) - pow(Across(A - 0.5), 2) - pow(Upwards(B - sqrt(3)/2), 2) }
#declare LatticeX = function(A, B) { abs(select(Nearer(A, B), Across(A), Across(A), Across(A - 0.5))) }
#declare LatticeY = function(A, B) { abs(select(Nearer(A, B), Upwards(B), Upwards(B), Upwards(B - sqrt(3)/2))) }
#declare FoldX = function(A, B) { select(B - A/sqrt(3), A, A, A/2 + B*sqrt(3)/2) }
#declare FoldY = function(A, B) { select(B - A/sqrt(3), B, B, abs(A*sqrt(3)/2 - B/2)) }
#declare Frame = function(A, B) { abs(select(A + 1.5*B - 0.38, 1, 0) - select(0.46 - A, 1, 0)) }
#declare Hexagons = function(A, B) { 1 - Frame(FoldX(LatticeX(A, B), LatticeY(A, B)), FoldY(LatticeX(A, B), LatticeY(A, B))) }
)"}};

bool is_called(std::string_view name, std::string_view text) {
  return text.find(fmt::format("{}(", name)) != text.npos;
}

/// How POV-Ray is told of a file; empty where its name does not say what it is.
std::string image_pigment(const scene::PictureFile& picture, std::string_view options) {
  const auto is = [&](std::string_view ending) { return ends_in(picture.file, ending); };
  const std::string_view kind = is(".png") ? "png" : is(".jpg") || is(".jpeg") ? "jpeg" : "";
  if (kind.empty()) return "";
  std::string name;
  for (const char c : picture.file) {
    if (c == '"' || c == '\\') name += '\\';
    name += c;
  }
  return fmt::format("image_map {{ {} \"{}\" {} }}", kind, name, options);
}

/// The curve of a texture's numbers, and what is between its texels.
std::string image_pigment(const Texture& texture) {
  return image_pigment(texture.image,
                       fmt::format("gamma {}{}", texture.curve == scene::TransferFunction::srgb ? "srgb" : "1",
                                   texture.filter == scene::Filter::nearest ? "" : " interpolate 2"));
}

/// 0 where the first colour is, 1 where the second is, of x and y in the texture.
std::string rule(Pattern pattern, const std::string& x, const std::string& y) {
  switch (pattern) {
    case Pattern::checker:
      return fmt::format("Odd(floor({}) + floor({}))", x, y);
    case Pattern::stripes:
      return fmt::format("Odd({})", x);
    case Pattern::p6m:
      return fmt::format("Hexagons({}, {})", x, y);
    case Pattern::waves:
      return fmt::format("(0.5 + 0.5*sin(2*pi*{})*sin(2*pi*{}))", x, y);
    case Pattern::image:
      break;
  }
  contract::unreachable();
}

/// @{ x and y in a texture.
std::string across(const Texture& texture, const PovCoordinates& at) {
  return fmt::format("{}*({})", texture.repeat.x, at.u);
}
std::string upwards(const Texture& texture, const PovCoordinates& at) {
  return fmt::format("{}*({})", texture.repeat.y, at.v);
}
/// @}

std::string within(const std::string& at) { return fmt::format("min(max({}, 0.000001), 0.999999)", at); }

/// What an image shows beyond its edge; POV-Ray repeats.
std::string bounded(const std::string& at, scene::Edges edges) {
  return edges == scene::Edges::clamp ? within(at) : at;
}

PovChannels of_image(std::string_view image, const std::string& x, const std::string& y) {
  PovChannels channels;
  for (std::size_t k = 0; k < 3; ++k)
    channels[k] = fmt::format("{}({}, {}, 0).{}", image, x, y, std::array{"red", "green", "blue"}[k]);
  return channels;
}

/// The spot of a picture that shows direction (x, y, z), and how much it counts there (render/environment.hpp).
struct Spot {
  std::string x;
  std::string y;
  std::string share = "1";
};

/// Which components of the direction a face of a box has forward, to the right and up, and which others.
struct Sides {
  const char *forward, *right, *up, *first, *second;
};
constexpr std::array<Sides, 6> sides{{{"x", "z", "y", "y", "z"},
                                      {"-x", "-z", "y", "y", "z"},
                                      {"y", "x", "z", "x", "z"},
                                      {"-y", "x", "-z", "x", "z"},
                                      {"z", "-x", "y", "x", "y"},
                                      {"-z", "x", "y", "x", "y"}}};

Spot spot_on(Surroundings kind, std::size_t picture) {
  switch (kind) {
    case Surroundings::box: {
      const Sides& s = sides.at(picture);
      const std::string forward = fmt::format("max({}, 0.000001)", s.forward);
      return {within(fmt::format("0.5+0.5*({})/{}", s.right, forward)),
              within(fmt::format("0.5+0.5*({})/{}", s.up, forward)),
              fmt::format("select({} - max(abs({}), abs({})), 0, 1)", s.forward, s.first, s.second)};
    }
    case Surroundings::spherical:
      return {within("0.5 + 0.5*x/max(sqrt(x*x + y*y + (z+1)*(z+1)), 0.000001)"),
              within("0.5 + 0.5*y/max(sqrt(x*x + y*y + (z+1)*(z+1)), 0.000001)")};
    case Surroundings::equirectangular:
      return {"0.5 + atan2(x, -z)/(2*pi)", within("0.5 + asin(min(max(y, -1), 1))/pi")};
    case Surroundings::gradient:
      break;
  }
  contract::unreachable();
}

/// Where the pattern of a texture stands: it is as large as one of its squares, and of stripes as two of them.
std::string placed(const Texture& texture, const PovCoordinates& at, int across = 1) {
  return fmt::format(" scale <{}/{}, 1/{}, {}> {}", across, texture.repeat.x, texture.repeat.y, at.depth, at.place);
}

}  // namespace

std::string pov_pigment(const PovChannels& channels, const glm::dvec3& color, std::string_view behind) {
  std::string text = "average pigment_map {";
  for (std::size_t k = 0; k < 3; ++k) {
    glm::dvec3 thrice(0);  // it is the mean of three
    thrice[static_cast<int>(k)] = 3 * color[static_cast<int>(k)];
    text += fmt::format(" [1 function {{ {} }} color_map {{ [0 rgb 0{}] [1 rgb <{}, {}, {}>{}] }}]", channels[k],
                        behind, thrice.x, thrice.y, thrice.z, behind);
  }
  return text + " }";
}

PovPatterns::PovPatterns(const std::vector<Texture>& textures) : textures_(textures) {
  unknown_ = static_cast<std::size_t>(
      std::ranges::count_if(textures, [&](const Texture& texture) { return !is_known(texture.name); }));
}

std::string PovPatterns::declarations(std::string_view text) const {
  std::string declared;
  for (const auto& [name, function] : helpers)
    if (is_called(name, text)) declared += function;
  for (std::size_t i = 0; i < textures_.size(); ++i)
    if (const std::string name = fmt::format("Image{}", i); is_called(name, text))
      declared += fmt::format("#declare {} = function {{ pigment {{ {} }} }}\n", name, image_pigment(textures_[i]));
  return declared;
}

const Texture& PovPatterns::named(const std::string& name) const {
  return *std::ranges::find(textures_, name, &Texture::name);
}

bool PovPatterns::is_known(const std::string& name) const {
  const Texture& texture = named(name);
  return texture.pattern != Pattern::image || !image_pigment(texture).empty();
}

std::optional<PovChannels> PovPatterns::channels(const std::string& name, const PovCoordinates& at) const {
  const Texture& texture = named(name);
  const std::string x = across(texture, at), y = upwards(texture, at);
  if (texture.pattern == Pattern::image) {
    if (image_pigment(texture).empty()) return std::nullopt;
    return of_image(fmt::format("Image{}", &texture - textures_.data()), bounded(x, texture.edges),
                    bounded(y, texture.edges));
  }
  const std::string share = rule(texture.pattern, x, y);
  PovChannels channels;
  for (int k = 0; k < 3; ++k)
    channels[static_cast<std::size_t>(k)] =
        fmt::format("({} + ({})*{})", texture.colors[0][k], texture.colors[1][k] - texture.colors[0][k], share);
  return channels;
}

std::string PovPatterns::pattern(const std::string& name, const PovCoordinates& at, PovLevel level,
                                 std::string_view first, std::string_view second, bool is_placed) const {
  const Texture& texture = named(name);
  const std::string_view map = level == PovLevel::color ? "color_map" : "texture_map";
  if (is_placed && !at.place.empty() && texture.pattern == Pattern::checker)
    return level == PovLevel::color
               ? fmt::format("checker {}, {}{}", first, second, placed(texture, at))
               : fmt::format("checker texture {{ {} }} texture {{ {} }}{}", first, second, placed(texture, at));
  if (is_placed && !at.place.empty() && texture.pattern == Pattern::stripes)
    return fmt::format("gradient x {} {{ [0.5 {}] [0.5 {}] }}{}", map, first, second, placed(texture, at, 2));
  return fmt::format("function {{ {} }} {} {{ [0 {}] [1 {}] }}",
                     rule(texture.pattern, across(texture, at), upwards(texture, at)), map, first, second);
}

std::string PovPatterns::picture(const std::string& name, const PovCoordinates& at) const {
  const Texture& texture = named(name);
  if (texture.pattern != Pattern::image || texture.edges == scene::Edges::clamp || at.place.empty()) return "";
  const std::string map = image_pigment(texture);
  return map.empty() ? "" : map + placed(texture, at);
}

/// POV-Ray adds to the unit normal the values of a function at the corners of a tetrahedron of the size of its
/// accuracy, each times the direction there, −0.1·size/accuracy of them: in the limit −0.4/3·size times its gradient,
/// which for half the grey, within 0 and 1, is to be the slope of the relief.
std::string PovPatterns::normal(const scene::Bump& relief, const PovCoordinates& at) const {
  const Texture& texture = named(relief.texture);
  const auto grey = channels(relief.texture, at);
  if (!grey) return "";
  constexpr double of_waves = 1e-5, of_a_rule = 1.0 / 64, of_an_image = 1.0 / 256;  // steps, in units of the texture
  const double step = texture.pattern == Pattern::waves   ? of_waves
                      : texture.pattern == Pattern::image ? relief.delta.value_or(of_an_image)
                                                          : relief.delta.value_or(of_a_rule);
  return fmt::format(" normal {{ function {{ 0.25 + ({})/6 }} bump_size {} accuracy {} }}", fmt::join(*grey, " + "),
                     15 * relief.height, step * at.length / texture.repeat.y);
}

bool PovPatterns::is_exact(const scene::Bump& relief) const {
  return named(relief.texture).pattern == Pattern::waves && !relief.delta;
}

std::string pov_sky(const scene::Environment& environment) {
  if (environment.kind == Surroundings::gradient) {
    const auto& [below, above] = environment.colors;
    return fmt::format(
        "sky_sphere {{ pigment {{ gradient y color_map {{ [0 rgb <{}, {}, {}>] [1 rgb <{}, {}, {}>] }} scale 2 "
        "translate <0, -1, 0> }} }}\n",
        below.x, below.y, below.z, above.x, above.y, above.z);
  }
  std::string declared;
  PovChannels sum;
  for (std::size_t i = 0; i < environment.pictures.size(); ++i) {
    const std::string map = image_pigment(environment.pictures[i], "gamma srgb interpolate 2");
    if (map.empty()) return "";
    declared += fmt::format("#declare Sky{} = function {{ pigment {{ {} }} }}\n", i, map);
    const Spot spot = spot_on(environment.kind, i);
    const PovChannels one = of_image(fmt::format("Sky{}", i), spot.x, spot.y);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += fmt::format("{}{}*{}", i > 0 ? " + " : "", spot.share, one[k]);
  }
  return declared + fmt::format("sky_sphere {{ pigment {{ {} }} }}\n", pov_pigment(sum, glm::dvec3(1)));
}

}  // namespace durero::io
