#pragma once
/// An operation as it is written, in either syntax, before its inputs have a meaning.

#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "durero/io/lines.hpp"
#include "durero/io/source.hpp"

namespace durero::io {

/// A word of the text syntax: whether it is a number or a name, the input says.
struct BareWord {
  std::string text;
};

/// The inputs that are lists of triples, however many: the points and the faces of a mesh.
inline constexpr std::array<std::string_view, 2> mesh_lists{"puntos", "caras"};

struct CallInput {
  std::string name;  // without ?
  std::size_t name_offset;
  std::size_t value_offset;
  // A string and a double are JSON's. A list of triples is that of an input of mesh_lists.
  std::variant<BareWord, std::string, double, glm::dvec3, std::array<glm::dvec3, 3>, std::vector<std::string>,
               std::vector<glm::dvec3>>
      value;
};

struct Call {
  std::string schema;
  std::size_t offset;
  std::vector<CallInput> inputs;
};

/// The operation of a line, as text or, where it starts with {, as JSON; nothing of a line that is blank or a comment.
/// Throws InputError.
std::optional<Call> read_call(const Source& source, const TextLine& line);

}  // namespace durero::io
