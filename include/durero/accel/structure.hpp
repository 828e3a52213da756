#pragma once
/// What every acceleration structure offers, and how it becomes a source of candidates (trace/candidates.hpp).

#include <concepts>

#include "durero/accel/work.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/candidates.hpp"

namespace durero::accel {

/// A structure is made of a scene, which must outlive it unedited, and offers
///   scene(), extraordinary()   as any source of candidates; what has no finite bound, such as a plane, is
///   extraordinary any(ray, limit, visit, work)
///                              as a source's any(ray, limit, visit), and adds to `work` what it did
///   size()                     what it holds.
template <class S>
concept Structure = std::constructible_from<S, const scene::Scene&> &&
                    requires(const S& structure, const trace::Ray& ray, double (&limit)(),
                             bool (&visit)(scene::ElementRef), Work& work) {
                      { structure.scene() } -> std::convertible_to<const scene::Scene&>;
                      { structure.extraordinary() } -> std::convertible_to<std::span<const scene::ElementRef>>;
                      { structure.any(ray, limit, visit, work) } -> std::same_as<bool>;
                      { structure.size() } -> std::same_as<Size>;
                    };

/// A structure, which must outlive it, as a source of candidates of whoever does not ask what it does.
template <class S>
class Source {
 public:
  explicit Source(const S& structure) : structure_(structure) {}  ///< the structure

  /// @{ As trace::Candidates has it.
  const scene::Scene& scene() const noexcept { return structure_.scene(); }
  std::span<const scene::ElementRef> extraordinary() const noexcept { return structure_.extraordinary(); }
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit) const {
    Work unseen;
    return structure_.any(ray, limit, visit, unseen);
  }
  /// @}

 protected:
  const S& structure_;  ///< that it stands for
};

/// The same, that adds up its work.
template <class S>
class Counted : public Source<S> {
 public:
  /// Both must outlive it.
  Counted(const S& structure, Work& work) : Source<S>(structure), work_(work) {}

  /// As trace::Candidates has it.
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
