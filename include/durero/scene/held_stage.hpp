#pragma once
/// The stage of a scene, held so that whoever reads elements alone sees nothing of cameras, lights and textures.

#include <memory>

namespace durero::scene {

struct Stage;

/// A value of type Stage on the heap. An empty holder stands for the stage that says nothing, and takes no memory.
class HeldStage {
 public:
  /// An empty holder.
  HeldStage() noexcept;
  /// @{ A copy holds a stage of its own. A holder that was moved from is empty.
  HeldStage(const HeldStage& other);
  HeldStage(HeldStage&& other) noexcept;
  HeldStage& operator=(const HeldStage& other);
  HeldStage& operator=(HeldStage&& other) noexcept;
  ~HeldStage();
  /// @}

  /// @{ The stage. Of an empty holder that is no constant it is made.
  const Stage& operator*() const noexcept;
  Stage& operator*();
  /// @}

 private:
  std::unique_ptr<Stage> stage_;
};

}  // namespace durero::scene
