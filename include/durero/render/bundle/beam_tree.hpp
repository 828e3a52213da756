#pragma once
/// The beam tree of a scene of triangles and planes (Heckbert and Hanrahan; Dadoun and Kirkpatrick). A beam is the
/// pyramid over a polygon of the picture (haz.def.1); the elements that it meets divide it, and a mirror sends each of
/// its parts on as a beam from the mirrored origin (haz.conj.1, imagen.conj.2). All is exact.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "durero/polygon/convex.hpp"
#include "durero/scene/camera.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

/// A part of a beam: all rays within its outline meet the same elements first.
struct BeamRegion {
  polygon::Polygon outline;       ///< in pixels: x to the right and y down from the centre of pixel (0, 0), z = 0
  scene::ElementSet elementos{};  ///< the elements that its rays meet first; none where they meet nothing
  polygon::PlaneSide nearness{};  ///< 1/t of the meeting, which is linear in x and y: the depth of a point in it
  std::uint32_t parent{};         ///< the region whose elements mirror this one; without_parent from the eye
  std::uint32_t depth = 1;        ///< the number of beams in a row, itself the last
  scene::ElementSet edge_on{};    ///< the elements in whose planes the origin lies: they have no region, but some rays
};

/// The parent of a region that is seen directly.
inline constexpr std::uint32_t without_parent = std::numeric_limits<std::uint32_t>::max();

/// All regions, each after its parent. The regions of one parent, and those without one, divide its outline, or the
/// picture's, without a gap and without an overlap.
using BeamTree = std::vector<BeamRegion>;

/// The outline of a rectangle of pixels, in the coordinates of regions: each pixel is a square about its centre.
polygon::Polygon outline_of(scene::Pixel first, scene::Resolution size);

/// The beam tree of the part of a picture within an outline, with at most so many beams in a row. An element that is
/// seen edge-on has no region. Throws std::domain_error where the scene has what beams do not follow: an
/// element that is no triangle and no plane; a material that lets light through; a mirror that is dull or smooth, or
/// has a relief.
BeamTree beam_tree(const scene::Scene& scene, const scene::PrimaryRays& rays, const polygon::Polygon& outline,
                   std::uint32_t max_depth);

/// The area of an outline, in pixels.
polygon::Rational area(const polygon::Polygon& outline);

/// A drawing of the regions as SVG: each in the colour of its element, those that mirrors show within thinner lines.
std::string svg(const BeamTree& tree, const scene::Scene& scene, scene::Resolution size);

}  // namespace durero::render
