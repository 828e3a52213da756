#pragma once
/// States on which the conjectures of the Z text are tried.

#include "durero/zed/trial/trial.hpp"

namespace durero::spec {

/// Scenes of none to nine elements, which the model's own operations made, with each type among them, elements that
/// touch, and some removed again, the tables that the program keeps of them, and steps between the same as functions to
/// shapes; rays through points of theirs, along generators and past them; such points and others; axes and vectors that
/// are none; lengths that are positive and that are not; parameters; materials, lights and windows; and meshes, what is
/// none, and scenes with meshes. The same at every call.
zed::Samples samples();

/// Values for the constants that the text leaves open, which the samples ask for: the names of the faces of some
/// meshes.
zed::Valuation sample_constants();

}  // namespace durero::spec
