#pragma once
/// A JSON Patch (RFC 6902) of a file that cannot be read as a scene. What `durero check --fix` proposes of such a file
/// is one; `durero edit --script` carries it out.

#include <cstddef>
#include <string>
#include <vector>

#include "durero/io/source.hpp"

namespace durero::io::json {

/// A file after a patch.
struct PatchedFile {
  std::string text{};                     ///< numbers keep their digits; an element stands on a line
  std::vector<std::size_t> operations{};  ///< where each operation begins in the patch
};

/// Whether a text is a patch and no script of operations: it begins with a bracket.
bool is_patch(const Source& source);

/// Carries out a patch on the JSON value of a file. Throws InputError: of the file where it is no JSON, and of the
/// patch as apply_patch does.
PatchedFile patched_file(const Source& file, const Source& patch);

}  // namespace durero::io::json
