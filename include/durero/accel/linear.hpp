#pragma once
/// The linear structure tests every element's ball against every ray, as `analytic` does. Other structures are measured
/// against it.

#include <span>

#include "durero/accel/structure.hpp"
#include "durero/trace/tables.hpp"

namespace durero::accel {

/// A ball around each element, in the order of the scene.
class LinearList {
 public:
  /// Prepares a scene, which must outlive it unedited.
  explicit LinearList(const scene::Scene& scene) : tables_(scene) {}

  /// @{ The operations of a structure.
  const scene::Scene& scene() const noexcept { return tables_.scene(); }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return tables_.extraordinary(); }
  Size size() const;
  /// All balls are counted, also those behind the element that ends the search.
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
