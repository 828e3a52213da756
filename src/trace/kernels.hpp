#pragma once
/// The functions of stable.cpp, compiled for several instruction sets: one table of them each.

#include "durero/trace/steps.hpp"

namespace durero::trace {

struct StableKernels {
  Finding (*sphere)(const scene::Sphere&, const Beam&, bool, double);
  Finding (*cylinder)(const scene::Cylinder&, const Beam&, bool, double);
  Finding (*cone)(const scene::Cone&, const Beam&, bool, double);
  Finding (*improved_sphere)(const scene::Sphere&, const Beam&, const Finding&);
  Finding (*improved_cylinder)(const scene::Cylinder&, const Beam&, const Finding&);
  Finding (*improved_cone)(const scene::Cone&, const Beam&, const Finding&);
  Rounded (*rounded)(const Beam&, const Finding&);
};

}  // namespace durero::trace
