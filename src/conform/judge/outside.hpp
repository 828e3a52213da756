#pragma once
/// The clauses of a profile that exclude a ray: one that excludes its whole scene, or one of the ray itself.

#include <string>

#include "conform/judge/trial.hpp"

namespace durero::conform {

/// The clause that excludes an element of the scene, by its type, the format of its numbers, its sizes or its
/// coordinates; empty where none does. It is the same for all rays of a case.
std::string outside_by_scene(const ClaimContext& trial);
/// The clause that excludes the ray in a scene that none excludes; empty where none does.
std::string outside_by_ray(const ClaimContext& trial);

}  // namespace durero::conform
