#include "extent_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "durero/contract/contract.hpp"
#include "two.hpp"

namespace durero::io {
namespace {

using scene::LightExtent;
using scene::LightShape;

/// The words of the shapes, in the order of LightShape; a point has none.
constexpr std::array<std::string_view, 5> shape_words{"", "disc", "sphere", "triangle", "rectangle"};
constexpr std::array<std::string_view, 2> disc_keys{"radius", "normal"};
constexpr std::array<std::string_view, 1> sphere_keys{"radius"}, edge_keys{"edges"};

double read_radius(json::Reader& in) {
  const std::size_t at = in.offset();
  const double radius = in.number("radius");
  if (!(radius > 0)) in.fail(at, fmt::format("radius is {}", radius), "expected a number above 0");
  return radius;
}

glm::dvec3 read_normal(json::Reader& in) {
  const std::size_t at = in.offset();
  const glm::dvec3 normal = in.vec3("normal");
  if (normal == glm::dvec3(0)) in.fail(at, "normal is the null vector", "expected a direction");
  return normal;
}

std::array<glm::dvec3, 2> read_edges(json::Reader& in) {
  const std::size_t at = in.offset();
  const auto edges = read_two<glm::dvec3>(in, "edges", "expected two edges", [&] { return in.vec3("edges"); });
  if (glm::cross(edges[0], edges[1]) == glm::dvec3(0))
    in.fail(at, "edges is two parallel vectors", "expected edges with an area between them");
  return edges;
}

}  // namespace

void read_json(json::Reader& in, std::string_view shape, LightExtent& extent) {
  if (!extent.is_point()) in.fail(in.key_offset(), "a light has two shapes", "expected one");
  extent.shape = static_cast<LightShape>(std::ranges::find(shape_words, shape) - shape_words.begin());
  switch (extent.shape) {
    case LightShape::point:
      break;
    case LightShape::disc:
      return in.object(shape, disc_keys, disc_keys.size(), [&](std::size_t key) {
        if (key == 0) extent.radius = read_radius(in);
        if (key == 1) extent.normal = read_normal(in);
      });
    case LightShape::sphere:
      return in.object(shape, sphere_keys, 1, [&](std::size_t) { extent.radius = read_radius(in); });
    case LightShape::triangle:
    case LightShape::rectangle:
      return in.object(shape, edge_keys, 1, [&](std::size_t) { extent.edges = read_edges(in); });
  }
  contract::unreachable();
}

void write_member(json::Writer& out, std::string_view shape, const LightExtent& extent) {
  if (shape != shape_words[static_cast<std::size_t>(extent.shape)]) return;
  out.key(shape).begin_object();
  if (extent.radius > 0) out.member("radius", extent.radius);
  if (extent.shape == LightShape::disc) out.member("normal", extent.normal);
  if (extent.radius == 0) {
    out.key("edges").begin_array();
    for (const glm::dvec3& edge : extent.edges) out.value(edge);
    out.end_array();
  }
  out.end_object();
}

}  // namespace durero::io
