#pragma once
/// No structure at all: every element's ball is tried for every ray, as `analytic` does. What the others are measured
/// against.

#include <span>

#include "durero/accel/structure.hpp"
#include "durero/trace/tables.hpp"

namespace durero::accel {

/// A ball around each element, in the order of the scene.
class Linear {
 public:
  /// Of a scene, which must outlive it unedited.
  explicit Linear(const scene::Scene& scene) : tables_(scene) {}

  /// @{ As every Structure has it.
  const scene::Scene& scene() const noexcept { return tables_.scene(); }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return tables_.extraordinary(); }
  Size size() const;
  /// All balls are counted, those behind an element that ends the walk with them.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
    work.volumes += scene().size() - extraordinary().size();
    return tables_.any(ray, limit, [&](scene::ElementRef e) {
      ++work.candidates;
      return visit(e);
    });
  }
  /// @}

  /// The balls.
  const trace::Tables& tables() const noexcept { return tables_; }

 private:
  trace::Tables tables_;
};

}  // namespace durero::accel
