#pragma once
/// Coherent queries of a block are answered in bundles by a source that can, in binary32 (trace/single_rays.hpp). The
/// other queries are left to Batch and SegmentBatch.

#include <algorithm>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/scene/query.hpp"
#include "durero/trace/picked.hpp"
#include "durero/trace/single_rays.hpp"

namespace durero::trace {

/// A source of candidates (trace/candidates.hpp) that answers bundles. Beside the operations of PairCandidates it has
///   bundles()              whether it can, in its scene;
///   search(search, rays)   answers rays, or adds them to rays.left. Triangles are named by the index of own(e);
///   block(name)            the block of a triangle of that name, in whose lane name modulo 8 it stands.
template <class Source>
concept BundleSource = requires(const Source& source, SingleRays& rays) {
  { source.bundles() } -> std::same_as<bool>;
  { source.block(SingleRays::none) } -> std::same_as<TriangleBlock>;
  source.search(SingleSearch::nearest, rays);
};

/// The queries of a block that are not answered in bundles.
class Unbundled {
 public:
  /// Answers queries of a block in bundles; answer(number, rays, which) is called for each bundle, where `number` is
  /// that of the query at its first place, and `which` are the places that are answered. Bundles are given up in a
  /// block where they hand most rays back.
  template <class Source, class Answer>
  Unbundled(const Source& source, IndexedView<const scene::Query> block, SingleSearch search, Answer answer) {
    if constexpr (BundleSource<Source>) {
      if (block.size() < least_worth || !source.bundles()) return;
      SingleRays rays;
      std::size_t next = 0;
      for (; next < block.size() && places_.size() <= next / 2 + most_in_vain; next += rays.count) {
        const std::uint64_t several = push(source, block, next, rays);
        source.search(search, rays);
        const std::uint64_t all = ~std::uint64_t{0} >> (SingleRays::size - rays.count);
        std::uint64_t left = (rays.left | several) & all;
        answer(static_cast<std::uint32_t>(next), rays, all & ~left);
        for (; left != 0; left &= left - 1) leave(block, next + static_cast<std::size_t>(std::countr_zero(left)));
      }
      any_answered_ = places_.size() < next;
      for (; any_answered_ && next < block.size(); ++next) leave(block, next);
    }
  }

  /// The entries of a view of the block that belong to these queries; the view is of an array like that of the queries.
  template <class T>
  IndexedView<T> of(const IndexedView<T>& view) const {
    return any_answered_ ? view.at_places(places_) : view;
  }
  /// Whether there is none.
  bool none() const { return any_answered_ && places_.empty(); }

 private:
  static constexpr std::size_t least_worth = 8;     // queries that are worth a bundle
  static constexpr std::size_t most_in_vain = 192;  // rays that may be handed back beyond a half of all

  void leave(IndexedView<const scene::Query> block, std::size_t number) {
    places_.push_back(static_cast<std::uint32_t>(block.place(number)));
  }

  /// Fills the bundle from a query on. The rays that start on several elements, which are not for bundles.
  template <class Source>
  static std::uint64_t push(const Source& source, IndexedView<const scene::Query> block, std::size_t next,
                            SingleRays& rays) {
    const std::size_t count = std::min(SingleRays::size, block.size() - next);
    std::uint64_t several = 0;
    rays.clear();
    for (std::size_t place = 0; place < count; ++place) {
      const scene::Query& query = block[next + place];
      several |= std::uint64_t{query.en.size() > 1} << place;
      rays.push(query.rayo.p().xyz(), query.rayo.v().xyz(),
                query.en.empty() ? SingleRays::none : source.own(query.en[0]).index);
    }
    return several;
  }

  std::vector<std::uint32_t> places_;
  bool any_answered_ = false;  // else these are all queries
};

}  // namespace durero::trace
