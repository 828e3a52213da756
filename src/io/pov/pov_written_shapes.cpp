#include "pov_written_shapes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "durero/io/pov/algebraic.hpp"

namespace durero::io {
namespace {

/// The greatest degree of a surface by a Z text.
constexpr int greatest_written_degree = 24;

/// The number, if it is whole and from 1 to the greatest degree.
std::optional<int> whole_exponent(double exponent) {
  const bool is_whole = exponent >= 1 && exponent <= greatest_written_degree && exponent == std::floor(exponent);
  return is_whole ? std::optional(static_cast<int>(exponent)) : std::nullopt;
}

}  // namespace

// POV-Ray raises to 2/e and 2/n, each rounded to binary64, and the sum to e/n. With a and b for the first two, that is
// b/a, or p/q in lowest terms. To the power q the equation has the degree a·p = b·q, the least multiple of a and b.
std::optional<PovElement> read_pov_superellipsoid(PovWords& in) {
  const std::size_t at = in.offset();
  const glm::dvec3 exponents = in.triple("superellipsoid");
  if (!(exponents.x > 0 && exponents.y > 0))
    in.fail(at, "an exponent of superellipsoid that is not above 0", "expected two numbers above 0");
  const auto a = whole_exponent(2 / exponents.x), b = whole_exponent(2 / exponents.y);
  if (!a || !b || std::lcm(*a, *b) > greatest_written_degree) return std::nullopt;
  const int common = std::gcd(*a, *b);
  return PovElement{superellipsoid,
                    {{"a", double(*a)},
                     {"b", double(*b)},
                     {"p", double(*b / common)},
                     {"q", double(*a / common)},
                     {"impar_a", double(*a % 2)},
                     {"impar_b", double(*b % 2)}}};
}

namespace {

/// A part of a blob: the density is about a point, or about an axis from it.
struct BlobPart {
  glm::dvec3 center{0}, axis{0};
  double radius = 0, strength = 0;
};

/// Moves a part by what stands in its braces; false where that does not keep angles.
bool read_part_attributes(PovWords& in, BlobPart& part, std::size_t& looks, bool& is_rounded) {
  PovTransform moved;
  while (!in.take("}")) {
    if (const auto move = take_pov_transform(in)) {
      moved = moved.then(*move);
      continue;
    }
    constexpr std::string_view looks_of_parts[] = {"texture", "pigment", "normal", "finish", "interior", "material"};
    if (!is_one_of(looks_of_parts, in.word()))
      in.fail_here("expected a transformation, a texture, or } behind a part of blob");
    ++looks;
    in.pass();
    in.skip_value();
  }
  if (moved.is_identity()) return true;
  if (!moved.scale) return false;
  is_rounded = true;
  part.center = moved.point(part.center);
  part.axis = moved.direction(part.axis);
  part.radius *= std::abs(*moved.scale);
  return true;
}

/// A sphere, a cylinder or a component; nothing where none stands here. `is_held` becomes false where it is moved by
/// too free a map.
std::optional<BlobPart> read_part(PovWords& in, std::size_t& looks, bool& is_rounded, bool& is_held) {
  BlobPart part;
  if (in.take("component")) {
    part.strength = in.number("component");
    in.comma();
    part.radius = in.number("component");
    in.comma();
    part.center = in.triple("component");
    return part;
  }
  const bool is_sphere = in.take("sphere");
  if (!is_sphere && !in.take("cylinder")) return std::nullopt;
  const std::string_view word = is_sphere ? "sphere" : "cylinder";
  in.expect("{", fmt::format("behind {}", word));
  part.center = in.triple(word);
  in.comma();
  if (!is_sphere) {
    part.axis = in.triple(word) - part.center;
    in.comma();
  }
  part.radius = in.number(word);
  in.comma();
  in.take("strength");
  part.strength = in.number(word);
  is_held = read_part_attributes(in, part, looks, is_rounded) && is_held;
  return part;
}

}  // namespace

std::optional<PovElement> read_pov_blob(PovWords& in, std::size_t& looks) {
  PovElement blob{written_blob};
  blob.own["umbral"] = 1.0;
  std::vector<BlobPart> parts;
  bool is_held = true;
  while (true) {
    if (in.take("threshold"))
      blob.own["umbral"] = in.number("threshold");
    else if (const auto part = read_part(in, looks, blob.is_rounded, is_held))
      parts.push_back(*part);
    else
      break;
  }
  std::size_t states = 1;
  for (const BlobPart& part : parts) {
    if (part.strength != 0 && states <= most_blob_states) states *= part.axis == glm::dvec3(0) ? 2 : 4;
    is_held = is_held && part.radius > 0;
  }
  if (!is_held || parts.empty() || parts.size() > most_blob_parts || states > most_blob_states) return std::nullopt;
  parts.resize(most_blob_parts);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    blob.own[fmt::format("c_{}", i + 1)] = parts[i].center;
    blob.own[fmt::format("v_{}", i + 1)] = parts[i].axis;
    blob.own[fmt::format("r_{}", i + 1)] = parts[i].radius;
    blob.own[fmt::format("f_{}", i + 1)] = parts[i].strength;
  }
  return blob;
}

}  // namespace durero::io
