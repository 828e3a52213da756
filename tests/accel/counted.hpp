#pragma once
/// The first hit among what a structure lists, for tests that ask what a hit took.

#include "durero/accel/structure.hpp"
#include "durero/trace/candidates.hpp"

namespace durero::test {

template <accel::Structure S>
scene::Hit counted_first_hit(const S& structure, const model::Rayo& rayo, accel::Work& work, scene::Origin en = {}) {
  trace::Counts unseen;
  return trace::first_hit_among(accel::Counted(structure, work), rayo, en, unseen);
}

}  // namespace durero::test
