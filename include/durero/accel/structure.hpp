#pragma once
/// An acceleration structure, and its use as a source of candidates (trace/candidates.hpp).

#include <concepts>

#include "durero/accel/work.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/candidates.hpp"

namespace durero::accel {

/// A structure is constructed from a scene, which must outlive it unedited, and offers
///   scene(), extraordinary()         as a source of candidates; elements without a finite bound, such as planes, are
///                                    extraordinary;
///   any(ray, limit, visit, work)     as a source's any(ray, limit, visit), and adds its work to `work`;
///   size()                           its size.
template <class S>
concept Structure = std::constructible_from<S, const scene::Scene&> &&
                    requires(const S& structure, const trace::Ray& ray, double (&limit)(),
                             bool (&visit)(scene::ElementRef), Work& work) {
                      { structure.scene() } -> std::convertible_to<const scene::Scene&>;
                      { structure.extraordinary() } -> std::convertible_to<std::span<const scene::ElementRef>>;
                      { structure.any(ray, limit, visit, work) } -> std::same_as<bool>;
                      { structure.size() } -> std::same_as<Size>;
                    };

/// A structure, which must outlive it, as a source of candidates whose work is not counted.
template <class S>
class CandidateSource {
 public:
  explicit CandidateSource(const S& structure) : structure_(structure) {}  ///< refers to the structure

  /// @{ The operations of trace::Candidates.
  const scene::Scene& scene() const noexcept { return structure_.scene(); }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return structure_.extraordinary(); }
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit) const {
    Work unseen;
    return structure_.any(ray, limit, visit, unseen);
  }
  /// @}

 protected:
  const S& structure_;  ///< the structure
};

/// A structure as a source of candidates whose work is counted.
template <class S>
class Counted : public CandidateSource<S> {
 public:
  /// Refers to the structure and to the counts, which must outlive it.
  Counted(const S& structure, Work& work) : CandidateSource<S>(structure), work_(work) {}

  /// Candidates::any.
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit) const {
    ++work_.rays;
    const std::uint64_t before = work_.candidates;
    const bool answered = this->structure_.any(ray, limit, visit, work_);
    if (work_.candidates == before) ++work_.untested;
    return answered;
  }

 private:
  Work& work_;
};

}  // namespace durero::accel
