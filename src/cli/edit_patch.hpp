#pragma once
/// Edits by a JSON Patch.

#include <string>

namespace durero::cli {

/// Carries out the patch of a file on the scene of another, and writes the scene to `out` where that is not empty. The
/// exit status.
int edit_by_patch(const std::string& scene, const std::string& patch, const std::string& out);

}  // namespace durero::cli
