#pragma once
/// Rays of one scene, followed to what they bring, with all that they have in common made ready once.

#include <memory>
#include <span>
#include <vector>

#include "durero/render/whitted.hpp"

namespace durero::render {

/// Any number of threads may ask it.
class Follower {
 public:
  /// Of a scene and an engine that outlive it unedited. Throws as brought() does.
  Follower(const scene::Scene& scene, const engine::Engine& engine, const Limits& limits);
  ~Follower();

  /// render::brought of these rays.
  std::vector<Brought> brought(std::span<const scene::Query> rays) const;

 private:
  struct Held;
  std::unique_ptr<Held> held_;  // null where no ray may be followed
};

}  // namespace durero::render
