#pragma once
/// States on which the conjectures of the Z text are tried.

#include "durero/zed/trial/trial.hpp"

namespace durero::oracle::spec {

/// Scenes of none to nine elements, which the model's own operations made, with each type among them, elements that
/// touch, and some removed again, and the tables that the program keeps of them; rays through points of theirs, along
/// generators and past them; such points and others; axes and vectors that are none; lengths that are positive and that
/// are not; parameters; and materials, lights and windows. The same at every call.
zed::Samples samples();

}  // namespace durero::oracle::spec
