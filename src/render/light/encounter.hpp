#pragma once
/// An encounter of a ray with a surface, as all integrators see it.

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <utility>

#include "durero/render/light/directions.hpp"
#include "durero/render/light/environment.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/surface/surfaces.hpp"
#include "element_looks.hpp"
#include "followed.hpp"
#include "front.hpp"
#include "media.hpp"
#include "render/texture/looks.hpp"
#include "smooth_normal.hpp"

namespace durero::render {

/// The point where a ray meets an element, and the look of the surface there.
struct Encounter {
  const scene::Query& query;
  const scene::Hit& hit;
  scene::ElementRef element;              ///< the one that gives the point its look
  std::optional<std::uint32_t> material;  ///< its number
  const Look& look;
  glm::dvec3 normal;  ///< the unit normal on the side of the ray
  glm::dvec3 facing;  ///< that normal as the vertices and the relief turn it
  glm::dvec3 d;       ///< the unit direction of the ray
  double way;         ///< the length from the eye to here
  bool enters;        ///< whether the ray comes from the outer side
};

/// The tangents without their parts along a unit normal.
inline Tangents across(const Tangents& t, const glm::dvec3& n) {
  return {t.u - glm::dot(t.u, n) * n, t.v - glm::dot(t.v, n) * n};
}

/// The encounter of a hit, behind a way of that length. `looks` are those of the context, and hold the look of a
/// material with textures. Precondition: the hit has a point.
[[gnu::always_inline]] inline Encounter encounter_of(const TracingContext& context, const scene::Query& query,
                                                     const scene::Hit& hit, double behind, ElementLooks& looks) {
  const scene::ElementRef element = front(context.scene, hit.elementos);
  const ElementLook& its = looks.of(element);
  glm::dvec3 n = context.engine.normal(context.scene, element, hit.punto);
  const glm::dvec3 d = unit(query.rayo.v().xyz());
  const bool enters = !(glm::dot(n, d) > 0);
  const double way = behind + glm::distance(query.rayo.p().xyz(), hit.punto);
  const TexturedMaterial& worn = *its.worn;
  const Look* look = &worn.plain;
  glm::dvec3 facing = its.has_vertex_normals ? smooth_normal(context.scene, element, hit.punto, n) : n;
  if (!worn.is_bare()) {
    const TextureCoordinates coordinates = render::coordinates(context.scene, element, hit.punto);
    if (worn.varies) look = &looks.varied.emplace(worn.look(coordinates, way));
    if (worn.relief) {
      Tangents along = tangents(context.scene, element, coordinates);
      if (facing != n) along = across(along, facing);
      facing = worn.normal(along, facing, coordinates);
    }
  }
  if (!enters) n = -n, facing = -facing;       // the side that the ray sees: cylinders and cones are open
  if (!(glm::dot(facing, d) < 0)) facing = n;  // a slope that is turned away is not seen
  return {query, hit, element, its.material, *look, n, facing, d, way, enters};
}

/// The colour that comes from a direction in which nothing stands.
inline glm::dvec3 from_nowhere(const scene::Stage& stage, const glm::dvec3& v) {
  return stage.environment ? environment_at(*stage.environment, v) : stage.background.value_or(default_background);
}

/// Whether all elements met are flat, and met for the first time.
inline bool is_sheet(const Encounter& at) {
  const scene::Origin start(at.query.en);
  return std::ranges::all_of(at.hit.elementos,
                             [&](scene::ElementRef e) { return surface::is_flat(e.tipo) && !start.contains(e); });
}

/// The refracted direction. Where a relief would send it back through the surface, the direction that the surface alone
/// gives.
inline std::optional<glm::dvec3> through(const Encounter& at, double ratio) {
  const auto t = refracted(at.d, at.facing, ratio);
  return t && !(glm::dot(*t, at.normal) < 0) ? refracted(at.d, at.normal, ratio) : t;
}

/// The mirrored direction, likewise.
inline glm::dvec3 mirrored_way(const Encounter& at) {
  const glm::dvec3 r = mirrored(at.d, at.facing);
  return glm::dot(r, at.normal) > 0 ? r : mirrored(at.d, at.normal);
}

/// The media behind a surface that a ray passes, and the ratio of the indices before it and behind it.
struct Passage {
  Media media;
  double ratio;
};

/// The media of a ray that was in `media` and passes the surface. Precondition: the element has a material.
[[gnu::always_inline]] inline Passage beyond_of(const Encounter& at, Media media, const scene::Stage& stage) {
  const double ratio = media.cross(at.enters, *at.material, stage);
  return {std::move(media), ratio};
}

}  // namespace durero::render
