#pragma once
/// A JSON Patch (RFC 6902) of a file that cannot be read as it is: `replace` and `remove`, by JSON pointers. What
/// `durero check --fix` proposes of a file that holds no scene is one; `durero edit --script` carries it out.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io::json {

/// An operation of a patch.
struct PatchProposal {
  /// The change of the value at the path.
  enum class Kind : std::uint8_t { replace, remove };

  Kind kind;               ///< what is done
  std::string path;        ///< a JSON pointer to the value
  std::string value{};     ///< of a replacement, as JSON text
  std::string reason{};    ///< for whoever reads the patch; the standard lets programs pass over it
  std::size_t offset = 0;  ///< where it stands in the patch
};

/// Whether a text is a patch and no script of operations: it begins with a bracket.
bool is_patch(const Source& source);

/// Reads a patch. Throws InputError; an operation that the standard has and that is none of these is an error, too.
std::vector<PatchProposal> read_patch(const Source& source);

/// The text of a patch, an operation a line.
std::string patch_text(std::span<const PatchProposal> patch);

/// The text of a file after a patch: what is not touched keeps its digits. Throws InputError, of the patch where a path
/// names nothing, and of the file where it is no JSON.
std::string patched(const Source& file, const Source& patch_source, std::span<const PatchProposal> patch);

}  // namespace durero::io::json
