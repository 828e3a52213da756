#include "durero/scene/held_stage.hpp"

#include "durero/scene/stage.hpp"

namespace durero::scene {

HeldStage::HeldStage() noexcept = default;
HeldStage::HeldStage(HeldStage&&) noexcept = default;
HeldStage& HeldStage::operator=(HeldStage&&) noexcept = default;
HeldStage::~HeldStage() = default;

HeldStage::HeldStage(const HeldStage& other) {
  if (other.stage_) stage_ = std::make_unique<Stage>(*other.stage_);
}

HeldStage& HeldStage::operator=(const HeldStage& other) {
  if (this != &other) *this = HeldStage(other);
  return *this;
}

const Stage& HeldStage::operator*() const noexcept {
  static const Stage nothing;
  return stage_ ? *stage_ : nothing;
}

Stage& HeldStage::operator*() {
  if (!stage_) stage_ = std::make_unique<Stage>();
  return *stage_;
}

}  // namespace durero::scene
