#pragma once
/// What every acceleration structure offers: it is a source of candidates (trace/candidates.hpp) that counts its work.

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
concept Structure = std::constructible_from<S, const scene::Scene&> && trace::Candidates<S> &&
                    requires(const S& structure, const trace::Ray& ray, double (&limit)(),
                             bool (&visit)(scene::ElementRef), Work& work) {
                      { structure.any(ray, limit, visit, work) } -> std::same_as<bool>;
                      { structure.size() } -> std::same_as<Size>;
                    };

}  // namespace durero::accel
