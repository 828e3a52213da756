#pragma once
/// The facts about a scene that hold for all its rays. Each is found when it is first asked for.

#include <oneapi/tbb/task_arena.h>

#include <mutex>
#include <optional>

#include "conform/judge/closed_mesh.hpp"
#include "conform/judge/scene_tree.hpp"

namespace durero::conform {

class SceneFacts {
 public:
  /// The facts about a scene, which must outlive them unedited with its other elements, for about so many rays.
  SceneFacts(const scene::Scene& scene, std::size_t rays, const OtherElements& others)
      : scene_(&scene), rays_(rays), others_(others) {}

  const scene::Scene& scene() const { return *scene_; }

  /// A thread that builds the tree in parallel takes no other work meanwhile, which could wait for the tree.
  const SceneTree& tree() const {
    std::call_once(tree_once_,
                   [&] { oneapi::tbb::this_task_arena::isolate([&] { tree_.emplace(*scene_, rays_, others_); }); });
    return *tree_;
  }
  /// All triangles of the scene, where they are a closed mesh.
  const std::optional<ClosedMesh>& mesh() const {
    std::call_once(mesh_once_, [&] { mesh_ = closed_mesh(tree()); });
    return mesh_;
  }
  /// The largest magnitude of a position or length.
  double largest_length() const {
    std::call_once(length_once_, [&] {
      scene_->for_each([&](auto, const auto& shape) { length_ = std::max(length_, conform::largest_length(shape)); });
    });
    return length_;
  }

 private:
  const scene::Scene* scene_;
  std::size_t rays_;
  OtherElements others_;
  mutable std::once_flag tree_once_, mesh_once_, length_once_;
  mutable std::optional<SceneTree> tree_{};
  mutable std::optional<ClosedMesh> mesh_{};
  mutable double length_ = 0;
};

}  // namespace durero::conform
