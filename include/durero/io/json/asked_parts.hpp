#pragma once
/// Parts of questions in JSON: rays, operations, and texts that stand in them as objects.

#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/json.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

/// The text of the object that stands here, as it is written; the reader passes it. Preconditions: an object stands
/// here; the source is that of the reader.
std::string_view object_text(json::Reader& in, const Source& source);

/// A script of the operations that stand here as an array, one a line: each is a line of a script, or an object. The
/// reader passes it. Throws InputError where one of them is neither, or has a line end. Precondition: the source is
/// that of the reader.
std::string read_json_script(json::Reader& in, const Source& source);

/// The rays that stand here as an array: each is an array of six numbers, or an object with these as `ray`, and with
/// the names of the elements that the ray starts on as `on`. The reader passes it. Throws InputError.
std::vector<scene::Query> read_json_rays(json::Reader& in, const scene::Scene& scene);

/// @{ A point or a direction and the elements of names, as above: parts of a ray. Throw InputError.
scene::ElementSet read_json_elements(json::Reader& in, const scene::Scene& scene);
glm::dvec3 read_json_direction(json::Reader& in);
/// @}

}  // namespace durero::io
