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

/// Of numbers A and B, what patterns and coordinates are made of. Odd is 1 where the whole part is odd, else 0. Of p6m,
/// as render/texture.hpp has it: the nearest point of the lattice, of each of its two rectangular halves the nearest,
/// then the nearer one; what is above the mirror at 30° comes to below it; and what two lines tell apart.
constexpr std::string_view helpers =
    R"(#declare Turn = function(A, B) { atan2(B, A)/(2*pi) - floor(atan2(B, A)/(2*pi)) }
#declare Latitude = function(A, B, C) { 0.5 + atan2(B, sqrt(A*A + C*C))/pi }
#declare Odd = function(A) { floor(A) - 2*floor(floor(A)/2) }
#declare Across = function(A) { A - floor(A + 0.5) }
#declare Upwards = function(A) { A - sqrt(3)*floor(A/sqrt(3) + 0.5) }
#declare Nearer = function(A, B) { pow(Across(A), 2) + pow(Upwards(B), 2) - pow(Across(A - 0.5), 2) - pow(Upwards(B - sqrt(3)/2), 2) }
#declare LatticeX = function(A, B) { abs(select(Nearer(A, B), Across(A), Across(A), Across(A - 0.5))) }
#declare LatticeY = function(A, B) { abs(select(Nearer(A, B), Upwards(B), Upwards(B), Upwards(B - sqrt(3)/2))) }
#declare FoldX = function(A, B) { select(B - A/sqrt(3), A, A, A/2 + B*sqrt(3)/2) }
#declare FoldY = function(A, B) { select(B - A/sqrt(3), B, B, abs(A*sqrt(3)/2 - B/2)) }
#declare Frame = function(A, B) { abs(select(A + 1.5*B - 0.38, 1, 0) - select(0.46 - A, 1, 0)) }
#declare Hexagons = function(A, B) { 1 - Frame(FoldX(LatticeX(A, B), LatticeY(A, B)), FoldY(LatticeX(A, B), LatticeY(A, B))) }
)";

/// How POV-Ray is told of a file; empty where its name does not say what it is.
std::string image_map(const scene::PictureFile& picture, std::string_view options) {
  const auto is = [&](std::string_view ending) { return ends_in(picture.file, ending); };
  const std::string_view kind = is(".png") ? "png" : is(".jpg") || is(".jpeg") ? "jpeg" : "";
  if (kind.empty()) return "";
  std::string name;
  for (const char c : picture.file) {
    if (c == '"' || c == '\\') name += '\\';
    name += c;
  }
  return fmt::format("function {{ pigment {{ image_map {{ {} \"{}\" {} }} }} }}", kind, name, options);
}

std::string image_map(const Texture& texture) {
  return image_map(texture.image,
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

/// A pigment whose red, green and blue are those numbers.
std::string pigment(const PovChannels& channels) {
  constexpr std::array<std::string_view, 3> thrice{"<3, 0, 0>", "<0, 3, 0>", "<0, 0, 3>"};  // it is the mean of three
  std::string text = "average pigment_map {";
  for (std::size_t k = 0; k < 3; ++k)
    text += fmt::format(" [1 function {{ {} }} color_map {{ [0 rgb 0] [1 rgb {}] }}]", channels[k], thrice[k]);
  return text + " }";
}

}  // namespace

PovPatterns::PovPatterns(const std::vector<Texture>& textures) : textures_(textures) {
  if (textures.empty()) return;
  declarations_ = helpers;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    if (textures[i].pattern != Pattern::image) continue;
    const std::string map = image_map(textures[i]);
    if (map.empty())
      ++unknown_;
    else
      declarations_ += fmt::format("#declare Image{} = {}\n", i, map);
  }
}

const Texture& PovPatterns::named(const std::string& name) const {
  return *std::ranges::find(textures_, name, &Texture::name);
}

std::optional<PovChannels> PovPatterns::channels(const std::string& name, const PovCoordinates& at) const {
  const Texture& texture = named(name);
  const std::string x = fmt::format("{}*({})", texture.repeat.x, at.u),
                    y = fmt::format("{}*({})", texture.repeat.y, at.v);
  if (texture.pattern == Pattern::image) {
    if (image_map(texture).empty()) return std::nullopt;
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
        "sky_sphere {{ pigment {{ function {{ 0.5 + 0.5*y }} color_map {{ [0 rgb <{}, {}, {}>] [1 rgb <{}, {}, {}>] }} "
        "}} "
        "}}\n",
        below.x, below.y, below.z, above.x, above.y, above.z);
  }
  std::string declared;
  PovChannels sum;
  for (std::size_t i = 0; i < environment.pictures.size(); ++i) {
    const std::string map = image_map(environment.pictures[i], "gamma srgb interpolate 2");
    if (map.empty()) return "";
    declared += fmt::format("#declare Sky{} = {}\n", i, map);
    const Spot spot = spot_on(environment.kind, i);
    const PovChannels one = of_image(fmt::format("Sky{}", i), spot.x, spot.y);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += fmt::format("{}{}*{}", i > 0 ? " + " : "", spot.share, one[k]);
  }
  return declared + fmt::format("sky_sphere {{ pigment {{ {} }} }}\n", pigment(sum));
}

}  // namespace durero::io
