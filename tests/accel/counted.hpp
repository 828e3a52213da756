#pragma once
/// A structure as a source of candidates that adds up its work, for tests that ask what a hit took.

#include "durero/accel/structure.hpp"

namespace durero::test {

template <accel::Structure S>
struct Counted {
  const S& structure;
  accel::Work& work;
  const scene::Scene& scene() const { return structure.scene(); }
  std::span<const scene::ElementRef> extraordinary() const { return structure.extraordinary(); }
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit) const {
    return structure.any(ray, limit, visit, work);
  }
};

template <accel::Structure S>
scene::Hit counted_first_hit(const S& structure, const model::Rayo& rayo, accel::Work& work, scene::Origin en = {}) {
  trace::Counts unseen;
  return trace::first_hit_among(Counted<S>{structure, work}, rayo, en, unseen);
}

}  // namespace durero::test
