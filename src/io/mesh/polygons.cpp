#include "polygons.hpp"

#include "io/losses.hpp"
#include "triangulation.hpp"

namespace durero::io {

void Polygons::add(std::span<const glm::dvec3> polygon, std::optional<std::uint32_t> material,
                   std::span<const glm::dvec2> uv) {
  const auto triangles = triangulated(polygon);
  if (!triangles) {
    ++uncut_;
    return;
  }
  for (const auto& [a, b, c] : *triangles) {
    const model::Answer answer =
        scene_.add(model::Elemento{name(++number_)}, scene::Triangle{{polygon[a], polygon[b], polygon[c]}}, material);
    if (!answer.ok())
      ++aligned_;  // the name is new, so that nothing else can be wrong
    else if (!uv.empty())
      scene_.set_wrap(scene_.find(name(number_)).value(), {.uv = {uv[a], uv[b], uv[c]}});
  }
}

std::string Polygons::name(std::size_t number) const { return fmt::format("{}{}", prefix_, number); }

void Polygons::name_losses(std::vector<std::string>& lost) const {
  add_loss(lost, aligned_, "triangle", "triangles", "left out: the vertices lie on one line");
  add_loss(lost, uncut_, "polygon", "polygons", "left out: edges touch or cross");
}

}  // namespace durero::io
