#pragma once
/// Nestings of media, each with a number, which a path holds in place of the media.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "durero/scene/stage.hpp"
#include "media.hpp"

namespace durero::render {

/// The nestings that the rays of a stage, which must outlive them, have been in.
class Nestings {
 public:
  explicit Nestings(const scene::Stage& stage) : stage_(stage) { forget(); }

  /// The number of no media.
  static constexpr std::uint32_t open = 0;

  /// The nesting behind a surface, and the ratio of the indices before it and behind it.
  struct Crossing {
    std::uint32_t beyond;
    double ratio;
  };

  /// Media::cross of a nesting.
  Crossing cross(std::uint32_t from, bool enters, std::uint32_t material) {
    KnownCrossing& known = known_[(std::size_t{from} * 8 + std::size_t{material} * 2 + enters) % known_.size()];
    if (known.from != from || known.material != material)  // the place tells whether it enters
      known = {from, material, found(from, enters, material)};
    return known.crossing;
  }

  /// Forgets the nestings where they have become many. Precondition: no number but `open` is used any more.
  void begin() {
    constexpr std::size_t many = 1 << 12;
    if (media_.size() > many) forget();
  }

 private:
  struct KnownCrossing {
    std::uint32_t from = std::numeric_limits<std::uint32_t>::max();  // no nesting's number
    std::uint32_t material = 0;
    Crossing crossing{};
  };

  void forget() {
    media_.assign(1, {});
    numbers_ = {{media_[open], open}};
    known_.fill({});
  }

  [[gnu::noinline]] Crossing found(std::uint32_t from, bool enters, std::uint32_t material) {
    Media media = media_[from];
    const double ratio = media.cross(enters, material, stage_);
    const auto [place, is_new] = numbers_.try_emplace(media, static_cast<std::uint32_t>(media_.size()));
    if (is_new) media_.push_back(media);
    return {place->second, ratio};
  }

  const scene::Stage& stage_;
  std::vector<Media> media_;                // by number
  std::map<Media, std::uint32_t> numbers_;  // of all of media_
  std::array<KnownCrossing, 256> known_;    // crossings, each in the place that is its own
};

}  // namespace durero::render
