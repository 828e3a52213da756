#pragma once
/// A tracer follows rays, some at a time, and keeps its memory from one call to the next. There is one for each
/// integrator.

#include <memory>
#include <span>

#include "durero/render/light/whitted.hpp"
#include "durero/scene/query.hpp"
#include "followed.hpp"
#include "render/sample/points.hpp"

namespace durero::render {

class Tracer {
 public:
  virtual ~Tracer() = default;
  /// Adds the colour that each ray brings to its sum, with a sample for each.
  virtual void follow(std::span<const scene::Query> rays, std::span<const SampleSource> samples,
                      std::span<PathRadiance> sums) = 0;

 protected:
  Tracer() = default;
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;
};

/// @{ The tracers of a context that outlives them.
std::unique_ptr<Tracer> whitted_tracer(const TracingContext& context);
std::unique_ptr<Tracer> path_tracer(const TracingContext& context);
/// @}

}  // namespace durero::render
