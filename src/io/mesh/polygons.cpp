#include "polygons.hpp"

#include <fmt/core.h>

#include "io/losses.hpp"

namespace durero::io {

void Polygons::add(std::span<const glm::dvec3> polygon, std::optional<std::uint32_t> material,
                   const CornerLooks& looks) {
  const auto triangles = triangulated(polygon);
  if (!triangles) {
    ++uncut_;
    return;
  }
  for (const auto& corners : *triangles) {
    const auto& [a, b, c] = corners;
    const model::Answer answer =
        scene_.add(model::Elemento{name(++number_)}, scene::Triangle{{polygon[a], polygon[b], polygon[c]}}, material);
    if (!answer.ok())
      ++aligned_;  // the name is new, so that nothing else can be wrong
    else if (!looks.uv.empty() || !looks.normals.empty())
      look(scene_.find(name(number_)).value(), looks, corners);
  }
}

void Polygons::look(scene::ElementRef element, const CornerLooks& looks, const CornerNumbers& corners) {
  const auto [a, b, c] = corners;
  if (const auto& uv = looks.uv; !uv.empty()) scene_.set_wrap(element, {.uv = {uv[a], uv[b], uv[c]}});
  if (looks.normals.empty()) return;
  const scene::VertexNormals normals{looks.normals[a], looks.normals[b], looks.normals[c]};
  if (scene::have_directions(normals))
    scene_.set_vertex_normals(element, normals);
  else
    ++flat_;
}

std::string Polygons::name(std::size_t number) const { return fmt::format("{}{}", prefix_, number); }

void Polygons::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, aligned_, "triangle", "triangles", "left out: the vertices lie on one line");
  add_loss(lost, flat_, "triangle", "triangles", "kept flat: a normal at a vertex has no direction");
  add_loss(lost, uncut_, "polygon", "polygons", "left out: edges touch or cross");
}

}  // namespace durero::io
