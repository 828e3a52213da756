#pragma once
/// A follower finds the colours that rays of one scene bring, and prepares their shared data once.

#include <memory>
#include <span>
#include <vector>

#include "durero/render/light/whitted.hpp"
#include "render/sample/points.hpp"

namespace durero::render {

class Caustics;

/// A follower of a scene's rays, which any number of threads may use at once.
class Follower {
 public:
  /// A follower for a scene and an engine that outlive it unedited, and so do the caustics, where there are some.
  /// Throws as brought() does.
  Follower(const scene::Scene& scene, const engine::Engine& engine, const PathLimits& limits,
           const Caustics* caustics = nullptr);
  ~Follower();

  /// The colours of these rays, as render::brought() gives them, with a sample for each.
  std::vector<PathRadiance> brought(std::span<const scene::Query> rays, std::span<const SampleSource> samples) const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;  // null where no ray may be followed
};

}  // namespace durero::render
