#include "durero/accel/item_buffer.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <boost/container/small_vector.hpp>
#include <stdexcept>

#include "durero/surface/surfaces.hpp"
#include "durero/trace/search.hpp"

namespace durero::accel {
namespace {

static_assert(Structure<ItemBuffer>);

constexpr std::uint32_t rows_of_a_band = 16, side_of_a_tile = 4;

/// The greatest number of items of a pixel. Where more elements may be the first, the pixel keeps none and all are
/// tested.
constexpr std::size_t most_items = 16;

constexpr std::uint64_t most_pixels = std::uint64_t{1} << 23U;

}  // namespace

std::optional<scene::PrimaryRays> primary_rays(const scene::Stage& stage) {
  const scene::Resolution size = stage.resolution.value_or(scene::default_resolution);
  if (!stage.camera || std::uint64_t{size.width} * size.height > most_pixels) return std::nullopt;
  try {
    const scene::PrimaryRays rays(*stage.camera, size);
    if (trace::ordinary(scene::Sphere{stage.camera->eye, 1})) return rays;
  } catch (const std::domain_error&) {  // the caller that draws the picture is told
  }
  return std::nullopt;
}

struct ItemBuffer::Candidate {
  scene::ElementRef e;
  ApparentBall seen;
};

/// A rectangle of pixels.
struct ItemBuffer::Tile {
  std::uint32_t x, y, width, height;
};

namespace {

/// A cone that contains the rays of a tile's pixels; nothing where they spread too wide.
template <class Tile>
std::optional<DirectionCone> cone_of(const scene::PrimaryRays& rays, const Tile& tile) {
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return direction(rays.ray(x, y).v().xyz()); };
  const glm::dvec3 middle = at(tile.x + tile.width / 2, tile.y + tile.height / 2);
  double cosine = 1;
  for (std::uint32_t y = tile.y; y < tile.y + tile.height; ++y)
    for (std::uint32_t x = tile.x; x < tile.x + tile.width; ++x)
      cosine = std::min(cosine, cosine_between(middle, at(x, y)));
  if (cosine < 0x1p-10) return std::nullopt;
  return cone(middle, cosine, 0);
}

}  // namespace

ItemBuffer::ItemBuffer(const scene::Scene& scene) : others_(scene), rays_(primary_rays(scene.stage())) {
  for (const scene::ElementRef e : others_.extraordinary())
    (scene.visit(e, [](const auto& shape) { return trace::ordinary(shape); }) ? boundless_ : extraordinary_)
        .push_back(e);
  if (!rays_) return;
  std::vector<Candidate> all;
  scene.for_each([&](scene::ElementRef e, const auto& shape) {
    if (trace::ordinary(shape)) all.push_back({e, seen(surface::ball(shape), scene.stage().camera->eye)});
  });
  std::ranges::stable_sort(all, {}, [](const Candidate& candidate) { return candidate.seen.near; });
  const scene::Resolution size = rays_->resolution();
  std::vector<Band> bands((size.height + rows_of_a_band - 1) / rows_of_a_band);
  oneapi::tbb::parallel_for(std::size_t{0}, bands.size(), [&](std::size_t i) {
    const auto y = static_cast<std::uint32_t>(i) * rows_of_a_band;
    bands[i] = band(all, y, std::min(rows_of_a_band, size.height - y));
  });
  for (const Band& band : bands) {
    const auto before = static_cast<std::uint32_t>(items_.size());
    for (const Pixel& pixel : band.pixels) pixels_.push_back({before + pixel.first, pixel.count, pixel.beyond});
    items_.insert(items_.end(), band.items.begin(), band.items.end());
  }
}

ItemBuffer::Band ItemBuffer::band(std::span<const Candidate> all, std::uint32_t y, std::uint32_t rows) const {
  const std::uint32_t width = rays_->resolution().width;
  Band band{.pixels = std::vector<Pixel>(std::size_t{width} * rows), .items = {}};
  fill(band, {0, y, width, rows}, {all.begin(), all.end()});
  return band;
}

/// Halves a tile until it is small, each half with the elements that are seen in it.
void ItemBuffer::fill(Band& band, const Tile& tile, std::vector<Candidate> seen) const {
  if (const auto cone = cone_of(*rays_, tile))
    std::erase_if(seen, [&](const Candidate& candidate) { return !may_be_seen(candidate.seen, *cone); });
  if (!seen.empty() && std::max(tile.width, tile.height) > side_of_a_tile) {
    Tile first = tile, second = tile;
    if (tile.width >= tile.height) {
      first.width = tile.width / 2;
      second.x += first.width;
      second.width -= first.width;
    } else {
      first.height = tile.height / 2;
      second.y += first.height;
      second.height -= first.height;
    }
    fill(band, first, seen);
    fill(band, second, std::move(seen));
    return;
  }
  const std::uint32_t width = rays_->resolution().width;
  for (std::uint32_t y = tile.y; y < tile.y + tile.height; ++y)
    for (std::uint32_t x = tile.x; x < tile.x + tile.width; ++x)
      band.pixels[std::size_t{y % rows_of_a_band} * width + x] = pixel(band.items, rays_->ray(x, y), seen);
}

ItemBuffer::Pixel ItemBuffer::pixel(std::vector<scene::ElementRef>& items, const model::Rayo& rayo,
                                    std::span<const Candidate> seen) const {
  struct Met {
    scene::ElementRef e;
    double low;  // −∞ where the hit is undecided
  };
  boost::container::small_vector<Met, 8> all;
  trace::Counts unseen;
  const trace::Search search(scene(), rayo, {}, unseen);
  double nearest = trace::no_limit, beyond = trace::no_limit;
  for (const Candidate& candidate : seen) {
    // |v|·t is not less than the least distance, and `length` exceeds |v| by more than the division's rounding.
    const double least = candidate.seen.near / search.ray().length();
    if (least > nearest) {
      beyond = least;
      break;
    }
    const std::optional<trace::Meeting> met = search.certified_meeting(candidate.e, trace::no_limit);
    if (met && met->kind == trace::Meeting::Kind::none) continue;
    const bool is_point = met && met->kind == trace::Meeting::Kind::point;
    all.push_back({candidate.e, is_point ? met->low : -trace::no_limit});
    if (is_point) nearest = std::min(nearest, met->high);
    if (all.size() > most_items) return {0, 0, -trace::no_limit};
  }
  const auto first = static_cast<std::uint32_t>(items.size());
  for (const Met& met : all) {
    if (met.low <= nearest) {
      items.push_back(met.e);
    } else {
      beyond = std::min(beyond, met.low);
    }
  }
  return {first, static_cast<std::uint32_t>(items.size()) - first, beyond};
}

const ItemBuffer::Pixel* ItemBuffer::pixel_of(const trace::Ray& ray) const {
  const auto place = rays_ ? rays_->pixel_of(ray.p, ray.v) : std::nullopt;
  if (!place) return nullptr;
  return &pixels_[std::size_t{place->y} * rays_->resolution().width + place->x];
}

Size ItemBuffer::size() const {
  Size size = others_.size();
  size.elements += boundless_.size();
  size.apart = extraordinary_.size();
  size.cells = pixels_.size();
  size.references = items_.size();
  size.bytes += pixels_.size() * sizeof(Pixel) +
                (items_.size() + boundless_.size() + extraordinary_.size()) * sizeof(scene::ElementRef);
  return size;
}

}  // namespace durero::accel
