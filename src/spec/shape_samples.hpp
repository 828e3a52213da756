#pragma once
/// Steps of the operations that spec/promocion.tex lifts from one shape to a scene.

#include <vector>

#include "durero/model/operation.hpp"
#include "durero/zed/trial/trial.hpp"

namespace durero::spec {

/// Adds samples of each lifted operation, `Agregar_Cono_Formas` and its like: the states before and after, what goes
/// in, and the answer. The scenes are those that these edits make, and the operations are the edits and the removals of
/// what is there.
void add_lifted_samples(const std::vector<model::Operation>& edits, zed::Samples& to);

}  // namespace durero::spec
