#include "durero/render/sample/refined.hpp"

#include <utility>
#include <vector>

#include "by_rows.hpp"
#include "points.hpp"
#include "view.hpp"

namespace durero::render {

Refined::Refined(const scene::Scene& scene, const engine::Engine& engine, const RenderSettings& frame)
    : view_(std::make_unique<const View>(scene, engine, frame)), sums_(view_->crop.size) {}

Refined::~Refined() = default;

void Refined::pass(const Progress& progress) {
  const View& view = *view_;
  const std::uint32_t width = view.crop.size.width;
  Picture next(view.crop.size);
  by_rows(view.crop.size.height, progress, [&](std::uint32_t y) {
    std::vector<EyeSample> eye(width);
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint64_t key = view.key(x, y);
      eye[x] = view.sample(x, y, passes_ == 0 ? glm::dvec2(0) : in_net(passes_, key), key, passes_);
    }
    const std::vector<PathRadiance> found = view.brought_by(eye);
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::size_t at = std::size_t(y) * width + x;
      next.rgb[at] = sums_.rgb[at] + found[x].color;
    }
  });
  sums_ = std::move(next);
  ++passes_;
}

Picture Refined::picture() const {
  Picture mean = sums_;
  for (glm::dvec3& color : mean.rgb) color /= double(passes_);
  return mean;
}

}  // namespace durero::render
