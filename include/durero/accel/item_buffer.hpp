#pragma once
/// The item buffer (A §1.5, Weghorst, Hooper and Greenberg): a pass over the camera's pixels keeps the first element
/// that each primary ray meets, so that the ray is later tested against that element alone.
///
/// The answers stay exact. The pass casts the very rays that are asked later. By the certified steps it keeps, for each
/// pixel, every element that may be the first, and a parameter `beyond` before which the ray meets nothing else. The
/// search certifies the kept elements; where its limit has not fallen below `beyond`, it traverses the hierarchy of all
/// elements too. A wrong identity would cost time and no answer, because the ray does not meet that element, or not
/// before `beyond`. Other rays, and rays that start on elements, traverse the hierarchy at once.

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

/// The primary rays of the stage's camera at its resolution; nothing where there is no camera that sees from an
/// ordinary point, or where the picture has more than 2²³ pixels.
std::optional<scene::PrimaryRays> primary_rays(const scene::Stage& stage);

/// An item buffer for the camera and resolution of the stage; without primary_rays it has no pixels.
class ItemBuffer {
 public:
  /// Casts the primary rays of a scene, which must outlive it unedited, on as many threads as the calling thread may
  /// use.
  explicit ItemBuffer(const scene::Scene& scene);

  /// @{ The operations of a structure.
  const scene::Scene& scene() const noexcept { return others_.scene(); }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return extraordinary_; }
  Size size() const;
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const;
  /// @}

 private:
  friend struct ItemBufferFault;  // a test's access, to plant wrong identities

  /// The items of a pixel.
  struct Pixel {
    std::uint32_t first, count;  // the range of its items
    double beyond;               // no other is met before this parameter; without items none at all, if above 0
  };
  /// Consecutive rows of the picture.
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
  /// Traverses the hierarchy for the elements that are not kept for the ray.
  template <class Limit, class Visit>
  bool any_other(const trace::Ray& ray, std::span<const scene::ElementRef> kept, Limit limit, Visit visit,
                 Work& work) const;

  Bvh others_;
  std::vector<scene::ElementRef> boundless_;  // ordinary, without a box, such as planes: not in the hierarchy
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
  Work found;  // without its leaves, which are not pixels
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
