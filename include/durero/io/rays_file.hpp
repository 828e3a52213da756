#pragma once
/// Ray files: text, `px py pz vx vy vz` a line, then `@name` for each element that the origin lies on; or .npy,
/// float64, shape (n, 6).

#include <span>
#include <string>
#include <vector>

#include "durero/io/source.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"

namespace durero::io {

using Ray = scene::Query;

/// Reads rays of a scene. A file that starts as a .npy does, or is named so, is read as one, the others as text:
/// numbers decimal or C's hexadecimal, `#` comments, blank lines. Throws InputError on v = 0, on what is no finite
/// number and on a name that the scene has not; the place in a .npy file is the ray (from 1) and its number.
std::vector<Ray> read_rays(const Source& source, const scene::Scene& scene);

/// The text of rays; reads back to the same rays.
std::string rays_text(std::span<const Ray> rays, const scene::Scene& scene);

/// The .npy file of rays; it has no place for the elements that an origin lies on.
std::string rays_npy(std::span<const Ray> rays);

}  // namespace durero::io
