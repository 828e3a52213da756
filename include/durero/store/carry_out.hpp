#pragma once
/// How a store carries an operation out: under contract alone, or by another opinion too.

#include <functional>

#include "durero/io/json/edited_scene.hpp"

namespace durero::store {

/// Carries a step out on a scene, and answers it.
using CarryOut = std::function<io::EditAnswer(io::EditedScene& edited, const io::ScriptStep& step)>;

/// By the contracts alone.
inline io::EditAnswer carry_out(io::EditedScene& edited, const io::ScriptStep& step) {
  return edited.apply_total(step);
}

}  // namespace durero::store
