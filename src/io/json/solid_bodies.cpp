#include "solid_bodies.hpp"

#include <fmt/format.h>

#include <utility>

#include "durero/scene/solids.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

using scene::Compound;

std::size_t shapes_of(const scene::Body& body);

std::size_t shapes_of(const scene::Instance&) { return 1; }

std::size_t shapes_of(const Compound& solid) {
  std::size_t count = 0;
  for (const scene::Body& part : solid.parts) count += shapes_of(part);
  return count;
}

std::size_t shapes_of(const scene::Body& body) {
  return std::visit([](const auto& form) { return shapes_of(form); }, body.form);
}

BodyParts make_solid(Compound::Operation operation, BodyReader& reader, json::Reader in) {
  Compound solid{operation, {}};
  const std::size_t at = in.offset();
  std::size_t shapes = 0;
  in.array("de", [&] {
    const std::size_t at_part = in.offset();
    scene::Body part = reader.body(in);
    in.skip();
    if (!scene::bounds_a_solid(part))
      in.fail(at_part, "a disc or a triangle bounds no solid",
              "expected a sphere, cylinder, cone, truncated cone, plane or solid");
    shapes += shapes_of(part);
    if (shapes > most_shapes_of_a_solid)
      in.fail(at_part, fmt::format("a solid has more than {} shapes", most_shapes_of_a_solid), "expected fewer");
    solid.parts.push_back(std::move(part));
  });
  if (solid.parts.size() < 2) in.fail(at, "de has fewer than two parts", "expected two or more");
  return alone({std::move(solid)});
}

}  // namespace

BodyParts make_union(BodyReader& reader, std::span<const json::Reader> values) {
  return make_solid(Compound::Operation::united, reader, values[0]);
}

BodyParts make_intersection(BodyReader& reader, std::span<const json::Reader> values) {
  return make_solid(Compound::Operation::intersected, reader, values[0]);
}

BodyParts make_difference(BodyReader& reader, std::span<const json::Reader> values) {
  return make_solid(Compound::Operation::subtracted, reader, values[0]);
}

BodyParts make_box(BodyReader&, std::span<const json::Reader> values) {
  json::Reader in = values[0];
  const std::size_t at = in.offset();
  std::vector<glm::dvec3> corners;
  in.array("esquinas", [&] { corners.push_back(in.vec3("a corner")); });
  if (corners.size() != 2) in.fail(at, fmt::format("esquinas has {} corners", corners.size()), "expected two");
  const auto box = scene::box_between(corners[0], corners[1]);
  if (!box) in.fail(at, "the corners lie in one plane across an axis", "expected two that differ in x, y and z");
  return alone({*box});
}

}  // namespace durero::io
