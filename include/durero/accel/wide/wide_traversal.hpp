#pragma once
/// Traversal of the wide hierarchy by many rays. Coherent rays traverse in bundles (packet_traversal.hpp). Incoherent
/// rays traverse in streams, one for each octant of directions (stream_traversal.hpp), or interleaved one by one
/// (interleaved_traversal.hpp).

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "durero/accel/wide/interleaved_traversal.hpp"
#include "durero/accel/wide/leaf_columns.hpp"
#include "durero/accel/wide/packet_traversal.hpp"
#include "durero/accel/wide/ray_order.hpp"
#include "durero/accel/wide/stream_traversal.hpp"
#include "durero/trace/finding.hpp"

namespace durero::accel {

/// PairCandidates::pairs over a tree with nodes(), leaves() and spacing().
template <class Tree, class Limit, class Visitor, class Flush>
class WideTraversal {
 public:
  /// The traversal keeps references to its arguments, which must outlive it. Preconditions: the tree has a node; there
  /// is a ray.
  WideTraversal(const Tree& tree, std::span<const trace::Ray> rays, Limit& limit, Visitor& take, Flush& flush)
      : nodes_(tree.nodes()),
        leaves_(tree.leaves()),
        spacing_(tree.spacing()),
        rays_(rays),
        limit_(limit),
        take_(take),
        bundles_(tree, rays, limit, take, flush) {}

  /// Traverses the tree with every ray whose limit is above 0.
  void all() {
    if constexpr (Bundles::takes_any) {
      add_in_order();
    } else {
      const bool some_company = bundles_.some_company();
      for (std::uint32_t number = 0; number < rays_.size(); ++number) {
        const double limit = limit_(number);
        if (!(limit > 0)) continue;
        if (some_company) {
          bundles_.add(number, limit);
        } else {
          alone_.push_back(number);
        }
      }
    }
    bundles_.finish(alone_);
    // Streams serve small trees only: in a large tree too few rays reach the same node.
    if (alone_.size() >= least_stream && nodes_.size_bytes() <= LeafColumns::nearby) return walk_streams();
    InterleavedTraversal(nodes_, leaves_, rays_, limit_, take_).walk(alone_);
  }

 private:
  using Bundles = PacketTraversal<Tree, Limit, Visitor, Flush>;

  static constexpr std::size_t least_stream = 64;  // incoherent rays that are worth a stream

  /// Adds the segments in a coherent order.
  void add_in_order() {
    std::vector<std::uint32_t> numbers;
    numbers.reserve(rays_.size());
    for (std::uint32_t number = 0; number < rays_.size(); ++number)
      if (limit_(number) > 0) numbers.push_back(number);
    sort_segments(RayOrderKey(nodes_[0], spacing_), rays_, numbers);
    constexpr std::size_t ahead = 16;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (i + ahead < numbers.size()) trace::ask_for(rays_[numbers[i + ahead]]);
      bundles_.add(numbers[i], limit_(numbers[i]));
    }
  }

  static std::size_t octant_of(const glm::dvec3& v) {
    return static_cast<std::size_t>(std::signbit(v.x) + 2 * std::signbit(v.y) + 4 * std::signbit(v.z));
  }

  /// Traverses with the incoherent rays, a stream for each octant.
  void walk_streams() {
    std::array<std::vector<StreamRay>, 8> streams;
    for (std::vector<StreamRay>& stream : streams) stream.reserve(alone_.size() / 4);
    for (const std::uint32_t number : alone_) {
      const trace::Ray& ray = rays_[number];
      streams[octant_of(ray.v)].push_back({Beam(ray), trace::no_limit, number});
    }
    StreamTraversal walk(nodes_, leaves_.blocks(), limit_, take_);
    for (std::vector<StreamRay>& stream : streams) walk.walk(stream);
  }

  std::span<const WideNode> nodes_;
  const LeafColumns& leaves_;
  double spacing_;
  std::span<const trace::Ray> rays_;
  Limit& limit_;
  Visitor& take_;
  Bundles bundles_;
  std::vector<std::uint32_t> alone_;
};

}  // namespace durero::accel
