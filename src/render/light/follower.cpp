#include "follower.hpp"

#include <memory>
#include <mutex>
#include <utility>

#include "durero/contract/contract.hpp"
#include "durero/render/sample/sampling.hpp"
#include "followed.hpp"
#include "tracer.hpp"

namespace durero::render {
namespace {

std::unique_ptr<Tracer> tracer_of(const TracingContext& context) {
  switch (context.limits.integrator) {
    case Integrator::whitted:
      return whitted_tracer(context);
    case Integrator::path:
      return path_tracer(context);
  }
  contract::unreachable();
}

/// The samples of a pixel, and of further ones where they are too many.
std::vector<SampleSource> samples_of_one_pixel(std::size_t count) {
  std::vector<SampleSource> samples(count);
  for (std::size_t i = 0; i < count; ++i) {
    samples[i].key = key_of(static_cast<std::uint32_t>(i / greatest_samples), 0, 0);
    samples[i].number = static_cast<std::uint32_t>(i % greatest_samples);
  }
  return samples;
}

}  // namespace

/// The data of a follower.
struct Follower::Held {
  TracingContext followed;
  std::mutex mutex{};
  std::vector<std::unique_ptr<Tracer>> idle{};  ///< tracers whose memory is used again

  /// A tracer that no other call uses: a thread that waits within one call may begin another.
  std::unique_ptr<Tracer> taken() {
    const std::lock_guard lock(mutex);
    if (idle.empty()) return tracer_of(followed);
    std::unique_ptr<Tracer> one = std::move(idle.back());
    idle.pop_back();
    return one;
  }
  void give_back(std::unique_ptr<Tracer> one) {
    const std::lock_guard lock(mutex);
    idle.push_back(std::move(one));
  }
};

Follower::Follower(const scene::Scene& scene, const engine::Engine& engine, const PathLimits& limits,
                   const Caustics* caustics) {
  if (limits.max_depth > 0) held_.reset(new Held{.followed{scene, engine, limits, caustics}});
}

Follower::~Follower() = default;

std::vector<PathRadiance> Follower::brought(std::span<const scene::Query> rays,
                                            std::span<const SampleSource> samples) const {
  std::vector<PathRadiance> sums(rays.size());
  if (!held_) return sums;
  std::unique_ptr<Tracer> tracer = held_->taken();
  tracer->follow(rays, samples, sums);
  held_->give_back(std::move(tracer));
  return sums;
}

std::vector<PathRadiance> brought(const scene::Scene& scene, const engine::Engine& engine,
                                  std::span<const scene::Query> rays, const PathLimits& limits) {
  return Follower(scene, engine, limits).brought(rays, samples_of_one_pixel(rays.size()));
}

}  // namespace durero::render
