#include "view.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "durero/render/sample/maps.hpp"
#include "durero/scene/motion.hpp"
#include "durero/scene/stage.hpp"

namespace durero::render {
namespace {

scene::PrimaryRays rays_of(const scene::Stage& stage, const RenderSettings& frame) {
  if (!stage.camera) throw std::domain_error("the scene has no camera; expected one");
  return {*stage.camera, frame.size.value_or(stage.resolution.value_or(default_resolution))};
}

/// The crop that is asked for, or the whole picture.
Crop crop_of(const RenderSettings& frame, scene::Resolution size) {
  const Crop crop = frame.crop.value_or(Crop{0, 0, size});
  const auto inside = [](std::uint32_t begin, std::uint32_t length, std::uint32_t whole) {
    return length > 0 && begin < whole && length <= whole - begin;
  };
  if (!inside(crop.x, crop.size.width, size.width) || !inside(crop.y, crop.size.height, size.height))
    throw std::out_of_range("the crop is not inside the picture");
  return crop;
}

/// The engine for a moving scene; null where no element moves.
std::unique_ptr<const engine::Engine> engine_of(const scene::Scene& scene, const RenderSettings& frame) {
  if (scene::moving_elements(scene) == 0) return nullptr;
  return frame.prepare ? frame.prepare(scene) : engine::find(engine::default_engine)->prepare(scene);
}

/// The number of samples from which on an engine answers them on one thread: other threads have other parts of the
/// picture, and rays that are not divided are answered in longer bundles.
constexpr std::size_t many = 1 << 10;

/// The colours that the rays of these samples bring.
std::vector<PathRadiance> brought_by(const scene::PrimaryRays& rays, const Follower& follower,
                                     std::span<const EyeSample> samples) {
  std::vector<scene::Query> queries;
  std::vector<SampleSource> sources;
  queries.reserve(samples.size());
  sources.reserve(samples.size());
  for (const auto& [point, source] : samples) {
    queries.push_back({rays.has_lens() ? rays.lens_ray_at(point.x, point.y, in_disc(source.pair(of_lens)))
                                       : rays.ray_at(point.x, point.y)});
    sources.push_back(source);
  }
  if (samples.size() < many) return follower.brought(queries, sources);
  oneapi::tbb::task_arena alone(1);
  return alone.execute([&] { return follower.brought(queries, sources); });
}

}  // namespace

Moment::Moment(const scene::Scene& still, const engine::Engine& resting, double time, const RenderSettings& frame,
               const PathLimits& limits)
    : scene(still.at_time(time)),
      own(engine_of(scene, frame)),
      rays(rays_of(scene.stage(), frame)),
      follower(scene, own ? *own : resting, limits) {}

View::View(const scene::Scene& drawn, const engine::Engine& asked, const RenderSettings& frame)
    : scene(drawn),
      engine(asked),
      rays(rays_of(drawn.stage(), frame)),
      crop(crop_of(frame, rays.resolution())),
      limits{.max_depth = frame.max_depth.value_or(depth_of(drawn.stage(), frame.integrator)),
             .min_weight = frame.min_weight,
             .integrator = frame.integrator,
             .shadows = frame.shadows},
      seed(frame.samples.seed),
      is_independent(frame.samples.sampling == Sampling::independent),
      follower(scene, engine, limits, frame.caustics),
      frame_(frame),
      moves_(scene::moves(drawn)) {}

std::vector<PathRadiance> View::brought_by(std::span<const EyeSample> samples) const {
  return moves_ ? brought_in_motion(samples) : render::brought_by(rays, follower, samples);
}

/// The work of making a moment is isolated: a thread that waits in it takes no task that would wait for the same
/// moment.
const Moment& View::moment(std::uint32_t number) const {
  std::call_once(made_[number], [&] {
    const double time = time_of(number, seed) * scene.stage().camera->shutter;
    tbb::this_task_arena::isolate(
        [&] { moments_[number] = std::make_unique<const Moment>(scene, engine, time, frame_, limits); });
  });
  return *moments_[number];
}

/// Takes the samples of one moment together, moment by moment.
std::vector<PathRadiance> View::brought_in_motion(std::span<const EyeSample> samples) const {
  std::vector<PathRadiance> all(samples.size());
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  const auto of = [&](std::size_t i) { return samples[i].source.number % most_moments; };
  std::ranges::stable_sort(order, {}, of);
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    const std::uint32_t number = of(order[begin]);
    std::vector<EyeSample> together;
    for (; end < order.size() && of(order[end]) == number; ++end) together.push_back(samples[order[end]]);
    const Moment& then = moment(number);
    const std::vector<PathRadiance> found = render::brought_by(then.rays, then.follower, together);
    for (std::size_t i = begin; i < end; ++i) all[order[i]] = found[i - begin];
  }
  return all;
}

}  // namespace durero::render
