#include "durero/render/texture/texture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <numbers>
#include <stdexcept>

#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

using scene::Edges;
using scene::Filter;
using scene::Pattern;
using scene::Texture;

/// The index in a row of n texels that stands for texel number i, by the edges. The number is a double, so that no far
/// point is out of range.
std::uint32_t wrapped(double i, std::uint32_t n, Edges edges) {
  switch (edges) {
    case Edges::repeat:
      return std::min(n - 1, static_cast<std::uint32_t>(std::max(0.0, i - n * std::floor(i / n))));
    case Edges::clamp:
      break;
  }
  return static_cast<std::uint32_t>(std::clamp(i, 0.0, n - 1.0));
}

const std::vector<scene::TexelImage>& levels_of(const Texture& texture) {
  if (!texture.image.levels) throw std::domain_error("the pictures of the scene have not been read");
  return *texture.image.levels;
}

bool is_even(double whole) {
  if (std::abs(whole) < 0x1p62) return (static_cast<std::int64_t>(whole) & 1) == 0;
  return std::fmod(whole, 2) == 0;
}

glm::dvec3 mixed(const glm::dvec3& a, const glm::dvec3& b, double share) { return a * (1 - share) + b * share; }

glm::dvec3 image_at(const Texture& texture, const glm::dvec2& at, double distance) {
  const std::vector<scene::TexelImage>& levels = levels_of(texture);
  const WrapModes beyond{texture.edges, texture.edges};
  switch (texture.filter) {
    case Filter::nearest:
      return nearest_texel(levels[0], at, beyond);
    case Filter::linear:
      return linear_texels(levels[0], at, beyond);
    case Filter::mipmap:
      break;
  }
  const double level = mipmap_level(distance, texture.near.value_or(1), levels.size() - 1);
  const auto i = static_cast<std::size_t>(level);
  const glm::dvec3 best = linear_texels(levels[i], at, beyond);
  const double share = level - static_cast<double>(i);
  return share == 0 ? best : mixed(best, linear_texels(levels[i + 1], at, beyond), share);
}

/// Whether the point is in the first colour of the p6m pattern: stars with twelve points about the centres of the
/// sixfold turns, within hexagons. Both are told by distances from lines in the triangle of representatives.
bool is_first_of_p6m(const glm::dvec2& at) {
  const glm::dvec2 p = p6m_representative(at);
  const bool in_star = p.x + 1.5 * p.y < 0.38;
  const bool in_frame = p.x > 0.46;
  return in_star != in_frame;
}

double wave(const glm::dvec2& at) {
  return 0.5 + 0.5 * std::sin(2 * std::numbers::pi * at.x) * std::sin(2 * std::numbers::pi * at.y);
}

glm::dvec2 within(const Texture& texture, const TextureCoordinates& at) {
  return {texture.repeat.x * at.u, texture.repeat.y * at.v};
}

/// The slopes by central differences: they are 0 where the texture is level a little to both sides.
glm::dvec2 differences(const Texture& texture, const TextureCoordinates& at, const glm::dvec2& delta) {
  const auto height = [&](double u, double v) { return grey(texture_at(texture, {u, v}, 0)); };
  return {(height(at.u + delta.x, at.v) - height(at.u - delta.x, at.v)) / (2 * delta.x),
          (height(at.u, at.v + delta.y) - height(at.u, at.v - delta.y)) / (2 * delta.y)};
}

}  // namespace

glm::dvec3 nearest_texel(const scene::TexelImage& picture, const glm::dvec2& at, WrapModes beyond) {
  return picture.at(wrapped(std::floor(at.x * picture.width), picture.width, beyond.across),
                    wrapped(picture.height - 1 - std::floor(at.y * picture.height), picture.height, beyond.upwards));
}

glm::dvec3 linear_texels(const scene::TexelImage& picture, const glm::dvec2& at, WrapModes beyond) {
  const double x = at.x * picture.width - 0.5, y = (1 - at.y) * picture.height - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const auto row = [&](double k) {
    const std::uint32_t in = wrapped(k, picture.height, beyond.upwards);
    return mixed(picture.at(wrapped(left, picture.width, beyond.across), in),
                 picture.at(wrapped(left + 1, picture.width, beyond.across), in), x - left);
  };
  return mixed(row(top), row(top + 1), y - top);
}

double mipmap_level(double distance, double near, std::size_t n) {
  if (!(distance > near)) return 0;
  return std::min(std::log2(distance / near), static_cast<double>(n));
}

glm::dvec2 p6m_representative(glm::dvec2 at) {
  const double half_root = std::numbers::sqrt3 / 2;
  // The nearest point of the lattice: it has two rectangular halves, and the nearer of their nearest points is taken.
  const auto to_nearest = [&](const glm::dvec2& p) {
    return glm::dvec2(p.x - std::round(p.x), p.y - 2 * half_root * std::round(p.y / (2 * half_root)));
  };
  const glm::dvec2 one = to_nearest(at), other = to_nearest(at - glm::dvec2(0.5, half_root));
  const auto length = [](const glm::dvec2& p) { return p.x * p.x + p.y * p.y; };
  glm::dvec2 p = glm::abs(length(one) <= length(other) ? one : other);
  // The mirrors at 30° and, once more, at y = 0.
  if (p.y > p.x / std::numbers::sqrt3) p = {0.5 * p.x + half_root * p.y, std::abs(half_root * p.x - 0.5 * p.y)};
  return p;
}

double grey(const glm::dvec3& color) {
  return color.x + ((color.y - color.x) + (color.z - color.x)) / 3;  // exactly the component where all three are equal
}

glm::dvec3 texture_at(const Texture& texture, const TextureCoordinates& coordinates, double distance) {
  const glm::dvec2 at = within(texture, coordinates);
  const auto& [first, second] = texture.colors;
  switch (texture.pattern) {
    case Pattern::image:
      return image_at(texture, at, distance);
    case Pattern::checker:
      return is_even(std::floor(at.x)) == is_even(std::floor(at.y)) ? first : second;
    case Pattern::stripes:
      return is_even(std::floor(at.x)) ? first : second;
    case Pattern::p6m:
      return is_first_of_p6m(at) ? first : second;
    case Pattern::waves:
      break;
  }
  return mixed(first, second, wave(at));
}

glm::dvec2 slopes(const Texture& texture, const TextureCoordinates& at, std::optional<double> delta) {
  constexpr double of_a_rule = 1.0 / 64;
  glm::dvec2 step(delta.value_or(of_a_rule));
  switch (texture.pattern) {
    case Pattern::image:
      if (!delta) step = {1.0 / levels_of(texture)[0].width, 1.0 / levels_of(texture)[0].height};
      break;
    case Pattern::checker:
    case Pattern::stripes:
    case Pattern::p6m:
      break;
    case Pattern::waves:
      if (delta) break;
      constexpr double pi = std::numbers::pi;
      const glm::dvec2 p = 2 * pi * within(texture, at);
      const double rise = grey(texture.colors[1]) - grey(texture.colors[0]);
      return rise * pi * texture.repeat * glm::dvec2(std::cos(p.x) * std::sin(p.y), std::sin(p.x) * std::cos(p.y));
  }
  return differences(texture, at, step / texture.repeat);
}

}  // namespace durero::render
