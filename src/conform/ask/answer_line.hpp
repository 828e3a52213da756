#pragma once
/// An answer line gives the outcome of one ray; systems and files of claims both have them.

#include <string_view>

#include "durero/conform/ask/claim.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// The unanswered claim that a malformed line gives.
Claim malformed(std::string_view line, std::string_view wrong);

/// Reads miss, hit and refused; any element of the scene may be named.
Claim read_answer_line(std::string_view line, const scene::Scene& scene, bool is_grid = false);

}  // namespace durero::conform
