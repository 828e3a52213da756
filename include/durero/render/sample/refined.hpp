#pragma once
/// A refined picture is there after one pass and becomes finer with each further one.

#include <cstdint>
#include <memory>

#include "durero/engine/engine.hpp"
#include "durero/render/output/picture.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

struct View;

/// A picture that takes one more ray through each pixel in a pass: first through its centre, then through the points of
/// a scrambled net, so that the first passes, and all of them together, are spread evenly. The scene and the engine
/// must outlive it.
class Refined {
 public:
  /// The greatest number of passes.
  static constexpr std::uint32_t most_passes = greatest_samples;

  /// A picture without passes. The samples of the frame are ignored. Throws as render() does.
  Refined(const scene::Scene& scene, const engine::Engine& engine, const RenderSettings& frame);
  ~Refined();
  Refined(const Refined&) = delete;
  Refined& operator=(const Refined&) = delete;

  /// Makes one more pass. Where the progress throws, the pass does not count. Precondition: fewer than most_passes were
  /// made.
  void pass(const Progress& progress = {});
  /// The number of passes made.
  std::uint32_t passes() const noexcept { return passes_; }
  /// The mean of the passes. Precondition: at least one was made.
  Picture picture() const;

 private:
  std::unique_ptr<const View> view_;
  Picture sums_;
  std::uint32_t passes_ = 0;
};

}  // namespace durero::render
