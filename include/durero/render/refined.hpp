#pragma once
/// A picture that is there soon and becomes finer with each pass.

#include <cstdint>
#include <memory>

#include "durero/engine/engine.hpp"
#include "durero/render/picture.hpp"
#include "durero/render/render.hpp"
#include "durero/scene/scene.hpp"

namespace durero::render {

struct View;

/// One more ray through each pixel a pass: first through its centre, then through the points of a scrambled net, so
/// that the first passes, and all of them together, are spread evenly. The scene and the engine outlive it.
class Refined {
 public:
  /// The most passes.
  static constexpr std::uint32_t most_passes = greatest_samples;

  /// Throws as render does; the frame's samples are not asked for.
  Refined(const scene::Scene& scene, const engine::Engine& engine, const Frame& frame);
  ~Refined();
  Refined(const Refined&) = delete;
  Refined& operator=(const Refined&) = delete;

  /// One more pass. Where the progress throws, the pass has not been. Precondition: fewer than most_passes have.
  void pass(const Progress& progress = {});
  /// How many there were.
  std::uint32_t passes() const noexcept { return passes_; }
  /// The mean of the passes. Precondition: there was one.
  Picture picture() const;

 private:
  std::unique_ptr<const View> view_;
  Picture sums_;
  std::uint32_t passes_ = 0;
};

}  // namespace durero::render
