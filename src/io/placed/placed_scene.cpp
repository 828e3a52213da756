#include "placed_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "durero/scene/attributes.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/solids.hpp"
#include "io/axis.hpp"
#include "io/letters.hpp"
#include "io/losses.hpp"
#include "io/mesh/rounded_map.hpp"

namespace durero::io {
namespace {

bool is_finite_point(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

std::string next_name(char letter, std::size_t& count) { return fmt::format("{}{}", letter, ++count); }

/// How many elements a surface becomes.
std::size_t elements_of(const SimpleSurface& surface) {
  const auto* const mesh = std::get_if<MeshTriangles>(&surface);
  return mesh == nullptr ? 1 : (*mesh)->size();
}

}  // namespace

bool PlacedScene::add(const PlacedThing& thing, scene::Group& into) {
  const std::size_t more = elements_of(thing.surface);
  if (more > most_elements - tried_) return false;
  tried_ += more;
  const Place place{thing.by, thing.material, into};
  if (thing.by.map.orientation() == 0)
    ++without_;
  else
    std::visit([&](const auto& surface) { add(surface, place); }, thing.surface);
  return true;
}

/// A point where it is put, rounded once.
glm::dvec3 PlacedScene::moved(const glm::dvec3& p, const AffinePlacement& by) {
  if (by.map.is_identity()) return p;
  ++moved_;
  return by.map.point(p, 1);
}

void PlacedScene::add(const scene::Sphere& sphere, const Place& place) {
  if (!place.by.scale) return add_copy(sphere, place);
  add_shape(scene::Sphere{moved(sphere.centro, place.by), sphere.radio * *place.by.scale}, place);
}

void PlacedScene::add(const OpenCylinder& cylinder, const Place& place) {
  const bool is_similar = place.by.scale.has_value();
  std::array<glm::dvec3, 2> ends = cylinder.ends;
  if (is_similar)
    for (glm::dvec3& end : ends) end = moved(end, place.by);
  const double radius = cylinder.radius * place.by.scale.value_or(1);
  const auto made = surface_between({ends[0], radius}, {ends[1], cylinder.is_cone ? 0 : radius}, rounded_);
  if (!made) {
    ++refused_["two ends, a finite distance apart"];
    return;
  }
  std::visit([&](const auto& shape) { is_similar ? add_shape(shape, place) : add_copy(shape, place); }, *made);
}

void PlacedScene::add(const scene::Disc& disc, const Place& place) {
  if (!place.by.scale) return add_copy(disc, place);
  if (place.by.map.is_identity()) return add_shape(disc, place);
  // An inverse that is there: the map has an orientation.
  const auto axis = axis_between(glm::dvec3(0), place.by.map.normals()->point(disc.vector, 1));
  if (!axis) {
    ++beyond_;
    return;
  }
  ++directions_;
  add_shape(scene::Disc{moved(disc.centro, place.by), disc.radio * *place.by.scale, axis->vector}, place);
}

void PlacedScene::add(const AxisBox& box, const Place& place) {
  const auto [a, b] = box.corners;
  auto solid = scene::box_between(a, b);
  if (!solid) {
    ++refused_["corners of a box with an inside"];
    return;
  }
  if (!place.by.map.keeps_axes()) return add_body(scene::copied(place.by.mapa(), {*std::move(solid)}), place);
  const glm::dvec3 from = moved(a, place.by), to = moved(b, place.by);
  solid = is_finite_point(from) && is_finite_point(to) ? scene::box_between(from, to) : std::nullopt;
  solid ? add_body({*std::move(solid)}, place) : static_cast<void>(++beyond_);
}

/// A mesh becomes a group, of its triangles in their order.
void PlacedScene::add(const MeshTriangles& mesh, const Place& place) {
  const bool is_moved = !place.by.map.is_identity();
  const RoundedMap points(place.by.map), normals(*place.by.map.normals());
  scene::Group own;
  const Place inner{place.by, place.material, own};
  for (const MeshTriangle& one : *mesh) {
    scene::Triangle triangle = one.triangle;
    auto turned = one.normals;
    if (is_moved) {
      moved_ += 3;
      for (glm::dvec3& vertex : triangle.vertices) vertex = points.point(vertex, 1);
      if (turned)
        for (glm::dvec3& normal : *turned) normal = normals.point(normal, 1);
    }
    const std::size_t before = scene_.size();
    add_shape(triangle, inner);
    if (scene_.size() == before) continue;
    const scene::ElementRef element{scene::Triangle::tipo,
                                    static_cast<std::uint32_t>(scene_.singles<scene::Triangle>().size() - 1)};
    if (turned && scene::have_directions(*turned))
      scene_.set_vertex_normals(element, *turned);
    else
      flat_ += turned.has_value();
    if (one.wrap) scene_.set_wrap(element, *one.wrap);
  }
  add_group(next_name('m', meshes_), std::move(own), place.into);
}

template <class Shape>
void PlacedScene::add_shape(const Shape& shape, const Place& place) {
  bool is_finite = true;
  scene::for_each_attribute<Shape>([&](const auto& attribute) {
    const auto& value = shape.*attribute.field;
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, double>)
      is_finite &= std::isfinite(value);
    else if constexpr (std::is_same_v<Value, glm::dvec3>)
      is_finite &= is_finite_point(value);
    else
      is_finite &= std::ranges::all_of(value, is_finite_point);
  });
  if (!is_finite) {
    ++beyond_;
    return;
  }
  std::string name = next_name(letter_of<Shape>(), numbered_[scene::place_of<Shape>]);
  const model::Answer answer = scene_.add(model::Elemento{name}, shape, place.material);
  if (answer.ok())
    place.into.elementos.insert(std::move(name));
  else if (std::is_same_v<Shape, scene::Triangle>)
    ++aligned_;
  else
    ++refused_[fmt::format("{} ({})", answer.violated->predicate, answer.violated->label)];
}

/// The exact copy of a shape that a scene may have.
void PlacedScene::add_copy(const scene::AnyShape& shape, const Place& place) {
  scene::Scene alone;
  const model::Answer answer = std::visit([&](const auto& s) { return alone.add(model::Elemento("e"), s); }, shape);
  if (answer.ok())
    add_body({scene::Instance{shape, place.by.mapa()}}, place);
  else
    ++refused_[fmt::format("{} ({})", answer.violated->predicate, answer.violated->label)];
}

void PlacedScene::add_body(scene::Body body, const Place& place) {
  std::string name = next_name('b', bodies_);
  scene_.add(model::Elemento{name}, scene::stand_in, place.material);
  scene_.set_body(scene_.find(name).value(), std::move(body));
  place.into.elementos.insert(std::move(name));
}

void PlacedScene::add_instance(scene::Group own, scene::Group& into) {
  add_group(next_name('u', instances_), std::move(own), into);
}

/// Its name is new, and so is whatever is in it, so that none is refused.
void PlacedScene::add_group(std::string name, scene::Group own, scene::Group& into) {
  if (own == scene::Group()) return;
  groups_.apply_total(scene::Grouping{name, std::move(own)}, scene_);
  into.groups.insert(std::move(name));
}

Imported PlacedScene::take(std::vector<std::string> lost) {
  materials_.finish();
  scene_.audit();
  add_loss(lost, moved_, "point", "points", "moved by a transformation: each coordinate is rounded once");
  rounded_.name_losses(lost);
  add_loss(lost, directions_, "direction", "directions", "rounded: those of a scene have length 1");
  add_loss(lost, flat_, "triangle", "triangles", "kept flat: a normal at a vertex has no direction");
  add_loss(lost, aligned_, "triangle", "triangles", "left out: the vertices lie on one line");
  add_loss(lost, without_, "shape", "shapes", "left out: a transformation leaves nothing of its volume");
  add_loss(lost, beyond_, "shape", "shapes", "left out: a transformation puts it beyond binary64");
  for (const auto& [clause, count] : refused_)
    add_loss(lost, count, "shape", "shapes", "left out: a scene's have " + clause);
  return {std::move(scene_), std::move(lost), std::move(groups_)};
}

MeshTriangles triangles_of(const scene::Scene& mesh, bool with_normals) {
  auto made = std::make_shared<std::vector<MeshTriangle>>();
  const auto triangles = mesh.singles<scene::Triangle>();
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const scene::ElementRef element{scene::Triangle::tipo, i};
    made->push_back({triangles[i], with_normals ? mesh.vertex_normals(element) : std::nullopt, mesh.wrap(element)});
  }
  return made;
}

}  // namespace durero::io
