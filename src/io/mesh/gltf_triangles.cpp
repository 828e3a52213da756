#include "gltf_triangles.hpp"

#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

#include "gltf_accessor.hpp"

namespace durero::io {
namespace {

constexpr std::size_t most_triangles = std::size_t{1} << 27U;  // of a file, whose nodes may repeat a mesh without end

/// How many triangles so many corners make.
std::size_t triangles_of(GltfMode mode, std::size_t corners) {
  return mode == GltfMode::triangles ? corners / 3 : corners - 2;
}

/// The corners of a triangle, by their places in the primitive.
std::array<std::size_t, 3> corners_of(GltfMode mode, std::size_t triangle) {
  const std::size_t i = triangle, odd = i % 2;
  if (mode == GltfMode::strip) return {i, i + 1 + odd, i + 2 - odd};
  if (mode == GltfMode::fan) return {i + 1, i + 2, 0};
  return {3 * i, 3 * i + 1, 3 * i + 2};
}

glm::dvec3 triple_of(const GltfAccessor::Element& element) { return {element[0], element[1], element[2]}; }

bool is_finite(const glm::dvec3& x) { return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z); }

}  // namespace

/// The corners of a primitive, and the vertices that they name: each is read and placed where it is named first.
class GltfTriangles::Corners {
 public:
  Corners(GltfTriangles& to, const GltfPrimitive& primitive, const GltfPlace& place)
      : to_(to), place_(place), positions_(accessor(*primitive.positions)) {
    positions_.require_vectors("VEC3");
    if (primitive.compressed_at && !positions_.has_bytes())
      to_.source_.fail(*primitive.compressed_at, "a primitive that is compressed", "expected one that is not");
    if (primitive.normals) add_look(normals_, *primitive.normals, "VEC3");
    if (primitive.uv) add_look(uv_, *primitive.uv, "VEC2");
    if (!primitive.indices) return;
    indices_.emplace(accessor(*primitive.indices));
    indices_->require_indices();
  }

  std::size_t count() const { return indices_ ? indices_->count() : positions_.count(); }
  bool have_normals() const { return normals_.has_value(); }
  bool have_uv() const { return uv_.has_value(); }

  /// The number of the vertex of a corner in the soup.
  std::int64_t vertex(std::size_t corner) {
    const std::size_t number = indices_ ? index(corner) : corner;
    const auto [known, is_new] = known_.try_emplace(number, static_cast<std::int64_t>(to_.soup_.vertices.size()));
    if (is_new) place(number);
    return known->second;
  }

 private:
  GltfAccessor accessor(const GltfReference& reference) const {
    return {to_.source_, to_.file_, to_.buffers_, reference};
  }

  void add_look(std::optional<GltfAccessor>& look, const GltfReference& reference, std::string_view type) const {
    look.emplace(accessor(reference));
    look->require_vectors(type);
    if (look->count() != positions_.count())
      look->fail(fmt::format("has {} elements", look->count()),
                 fmt::format("expected {}, one for each position", positions_.count()));
  }

  std::size_t index(std::size_t corner) const {
    const auto number = static_cast<std::uint64_t>(indices_->element(corner)[0]);
    if (number >= positions_.count() || number == indices_->no_index())
      indices_->fail(fmt::format("names vertex {} in element {}, counted from 0", number, corner),
                     fmt::format("expected one of {}, and not the greatest number of its type", positions_.count()));
    return number;
  }

  void place(std::size_t number) {
    const glm::dvec3 point = place_.points.point(triple_of(positions_.finite_element(number)), positions_.divisor());
    if (!is_finite(point))
      to_.source_.fail(place_.at, fmt::format("node {} places a vertex beyond binary64", place_.node),
                       "expected finite coordinates");
    to_.soup_.vertices.push_back(point);
    to_.looks_.normals.values.push_back(normal(number));
    to_.looks_.textures.values.push_back(uv(number));
  }

  /// Null where it has no direction.
  glm::dvec3 normal(std::size_t number) const {
    if (!normals_ || !place_.normals) return glm::dvec3(0);
    const glm::dvec3 own = triple_of(normals_->element(number));
    return is_finite(own) ? place_.normals->point(own, normals_->divisor()) : glm::dvec3(0);
  }

  /// A texture of glTF grows downwards from its first row. Both numbers are rounded once.
  glm::dvec2 uv(std::size_t number) const {
    if (!uv_) return glm::dvec2(0);
    const GltfAccessor::Element own = uv_->finite_element(number);
    return {own[0] / uv_->divisor(), (uv_->divisor() - own[1]) / uv_->divisor()};
  }

  GltfTriangles& to_;
  const GltfPlace& place_;
  GltfAccessor positions_;
  std::optional<GltfAccessor> normals_{}, uv_{}, indices_{};
  std::unordered_map<std::size_t, std::int64_t> known_{};
};

void GltfTriangles::add(const GltfPrimitive& primitive, const GltfPlace& place) {
  Corners corners(*this, primitive, place);
  const std::size_t count = corners.count();
  if (count < 3 || (primitive.mode == GltfMode::triangles && count % 3 != 0))
    source_.fail(primitive.at, fmt::format("a primitive of {} corners", count),
                 "expected a multiple of 3, or 3 or more of a strip or a fan");
  const std::size_t triangles = triangles_of(primitive.mode, count);
  if (triangles > most_triangles - soup_.faces.size())
    source_.fail(place.at, fmt::format("more than {} triangles", most_triangles), "expected fewer");
  for (std::size_t i = 0; i < triangles; ++i) {
    Face& face = soup_.faces.emplace_back();
    for (const std::size_t corner : corners_of(primitive.mode, i)) face.push_back(corners.vertex(corner));
    if (place.mirrors) std::swap(face[1], face[2]);
    static const Face none;
    looks_.normals.of_face.push_back(corners.have_normals() ? face : none);
    looks_.textures.of_face.push_back(corners.have_uv() ? face : none);
    groups_.of_face.push_back(place.group);
  }
}

}  // namespace durero::io
