#pragma once
/// A line that answers a ray, whoever wrote it.

#include <string_view>

#include "durero/conform/claim.hpp"
#include "durero/scene/scene.hpp"

namespace durero::conform {

/// A malformed line, as a claim.
Claim malformed(std::string_view line, std::string_view wrong);

/// Reads miss, hit and refused; any element of the scene may be named.
Claim read_answer_line(std::string_view line, const scene::Scene& scene);

}  // namespace durero::conform
