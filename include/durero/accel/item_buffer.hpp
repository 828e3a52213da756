#pragma once
/// The item buffer (A §1.5, Weghorst, Hooper and Greenberg): a pass over the pixels of the camera's picture, which
/// keeps for each the identity of what its ray meets first, so that a primary ray tests that element alone.
///
/// Why the answer is still exact: the pass keeps of each pixel's ray, which is the very ray that is asked later, each
/// element that may be the first by the certified steps, and a parameter `beyond` that nothing else which it meets lies
/// before. The search certifies what was kept; where its limit has not fallen below `beyond`, it goes through the
/// hierarchy of all elements too. So an identity that was wrong would cost time and no answer: what it stands for is
/// not met, or met no nearer than `beyond`. Other rays, and rays that start on elements, go through the hierarchy at
/// once.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "durero/accel/bvh.hpp"
#include "durero/accel/seen.hpp"
#include "durero/accel/structure.hpp"
#include "durero/scene/camera.hpp"

namespace durero::accel {

/// The rays of the stage's camera at its resolution; none without a camera that sees something from an ordinary point,
/// and where the picture has more than 2²³ pixels.
std::optional<scene::PrimaryRays> primary_rays(const scene::Stage& stage);

/// Of the camera and the resolution of the stage; without primary_rays, of no pixel.
class ItemBuffer {
 public:
  /// Of a scene, which must outlive it unedited. On as many threads as the calling one may use.
  explicit ItemBuffer(const scene::Scene& scene);

  /// @{ As every Structure has it.
  const scene::Scene& scene() const noexcept { return others_.scene(); }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return extraordinary_; }
  Size size() const;
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const;
  /// @}

 private:
  friend struct ItemBufferFault;  // of the test that plants wrong identities

  /// What is kept of a pixel.
  struct Pixel {
    std::uint32_t first, count;  // of its items
    double beyond;               // nothing else is met before this parameter; without items, at all if it is above 0
  };
  /// Some rows of the picture.
  struct Band {
    std::vector<Pixel> pixels;
    std::vector<scene::ElementRef> items;
  };
  struct Candidate;
  struct Tile;

  Band band(std::span<const Candidate> all, std::uint32_t y, std::uint32_t rows) const;
  void fill(Band& band, const Tile& tile, std::vector<Candidate> seen) const;
  Pixel pixel(std::vector<scene::ElementRef>& items, const model::Rayo& rayo, std::span<const Candidate> seen) const;
  const Pixel* pixel_of(const trace::Ray& ray) const;
  /// What is not kept of a ray, through the hierarchy.
  template <class Limit, class Visit>
  bool any_other(const trace::Ray& ray, std::span<const scene::ElementRef> kept, Limit limit, Visit visit,
                 Work& work) const;

  Bvh others_;
  std::vector<scene::ElementRef> boundless_;  // ordinary, as a plane may be: in no hierarchy, and kept of pixels
  std::vector<scene::ElementRef> extraordinary_;
  std::optional<scene::PrimaryRays> rays_;
  std::vector<Pixel> pixels_;  // row by row
  std::vector<scene::ElementRef> items_;
};

template <class Limit, class Visit>
bool ItemBuffer::any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
  const Pixel* const pixel = limit() == trace::no_limit ? pixel_of(ray) : nullptr;
  std::span<const scene::ElementRef> kept;
  if (pixel != nullptr) {
    ++work.cells;
    kept = std::span(items_).subspan(pixel->first, pixel->count);
    for (const scene::ElementRef e : kept) {
      ++work.candidates;
      if (visit(e)) return true;
    }
    if (kept.empty() ? pixel->beyond > 0 : limit() < pixel->beyond) return false;
  }
  return any_other(ray, kept, limit, visit, work);
}

template <class Limit, class Visit>
bool ItemBuffer::any_other(const trace::Ray& ray, std::span<const scene::ElementRef> kept, Limit limit, Visit visit,
                           Work& work) const {
  const auto is_kept = [&](scene::ElementRef e) { return std::ranges::find(kept, e) != kept.end(); };
  for (const scene::ElementRef e : boundless_) {
    if (is_kept(e)) continue;
    ++work.candidates;
    if (visit(e)) return true;
  }
  Work found;  // whose leaves are no pixels
  std::uint64_t again = 0;
  const bool over = others_.any(
      ray, limit, [&](scene::ElementRef e) { return is_kept(e) ? ++again, false : visit(e); }, found);
  found.cells = 0;
  found.candidates -= again;
  found.repeated += again;
  work += found;
  return over;
}

}  // namespace durero::accel
