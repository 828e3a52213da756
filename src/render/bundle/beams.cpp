#include "durero/render/bundle/beams.hpp"

#include <atomic>
#include <stdexcept>
#include <vector>

#include "durero/scene/motion.hpp"
#include "guided.hpp"
#include "located.hpp"
#include "render/light/follower.hpp"
#include "render/sample/by_rows.hpp"
#include "render/sample/view.hpp"

namespace durero::render {
namespace {

/// The meetings of the rays of a pixel, from the eye on.
std::vector<KnownMeeting> met(const BeamTree& tree, std::uint32_t region) {
  std::vector<KnownMeeting> meetings;
  for (; region != without_parent; region = tree[region].parent)
    meetings.push_back({tree[region].elementos, tree[region].edge_on});
  return {meetings.rbegin(), meetings.rend()};
}

}  // namespace

BeamPicture by_beams(const scene::Scene& scene, const engine::Engine& engine, const Progress& progress,
                     const RenderSettings& frame) {
  const View view(scene, engine, frame);
  if (view.rays.has_lens() || scene::moves(scene))
    throw std::domain_error(
        "beams are through one point, of a scene at rest; expected a camera without aperture and motion");
  const scene::Resolution size = view.crop.size;
  BeamPicture drawn{Picture(size),
                    beam_tree(scene, view.rays, outline_of({view.crop.x, view.crop.y}, size), view.limits.max_depth)};
  const std::vector<std::uint32_t> regions = located(drawn.tree, view.rays, view.crop);
  std::atomic<std::uint64_t> asked = 0;
  by_rows(size.height, progress, [&](std::uint32_t y) {
    GuidedEngine guided(scene, engine);
    const Follower follower(scene, guided, view.limits);
    for (std::uint32_t x = 0; x < size.width; ++x) {
      const std::size_t i = std::size_t(y) * size.width + x;
      guided.guide(met(drawn.tree, regions[i]));
      const scene::Query query{view.rays.ray(view.crop.x + x, view.crop.y + y)};
      const SampleSource source = view.sample(x, y, {0, 0}, view.key(x, y), 0).source;
      drawn.picture.rgb[i] = follower.brought({&query, 1}, {&source, 1}).front().color;
    }
    asked += guided.asked();
  });
  drawn.asked = asked;
  return drawn;
}

}  // namespace durero::render
