#pragma once
/// Solids that are joined, as elements of scene files: `union`, `interseccion` and `diferencia` of the parts behind
/// `de`, and `caja`, a box by two of its corners.

#include <span>
#include <string_view>

#include "body_reader.hpp"
#include "durero/io/json/json_writer.hpp"

namespace durero::io {

/// The keys of each tipo.
inline constexpr std::string_view solid_keys[] = {"de"}, box_keys[] = {"esquinas"};

/// The most shapes of a solid.
inline constexpr std::size_t most_shapes_of_a_solid = 1000;

/// @{ The one part that an element of that tipo is.
BodyParts make_union(BodyReader& reader, std::span<const json::Reader> values);
BodyParts make_intersection(BodyReader& reader, std::span<const json::Reader> values);
BodyParts make_difference(BodyReader& reader, std::span<const json::Reader> values);
BodyParts make_box(BodyReader& reader, std::span<const json::Reader> values);
/// @}

}  // namespace durero::io
