#include "durero/trace/search.hpp"

#include <cmath>
#include <compare>
#include <cstring>

#include "trace/ends.hpp"
#include "trace/search-inl.hpp"
#include "trace/steps.hpp"
#include "trace/triage.hpp"

namespace durero::trace {
namespace {

/// The steps of the program: floating point with certificates, then exact numbers.
struct CertifiedSteps {
  const scene::Scene& scene;
  const model::Rayo& rayo;
  const Origin& en;
  const Ray& ray;

  bool on(scene::ElementRef e) const { return en.contains(e); }
  template <class Use>
  auto visit(scene::ElementRef e, Use&& use) const {
    return scene.visit(e, std::forward<Use>(use));
  }
  /// Orders elements by the bytes of their stored numbers, so 0 and −0 differ.
  std::strong_ordering order_of_numbers(scene::ElementRef a, scene::ElementRef b) const {
    if (a.tipo != b.tipo) return a.tipo <=> b.tipo;
    if (on(a) != on(b)) return on(a) <=> on(b);
    return scene.visit(a, [&]<class Shape>(const Shape& shape) {
      static_assert(sizeof(Shape) % sizeof(double) == 0, "its bytes are those of its numbers");
      const Shape other = scene.shapes<Shape>()[b.index];
      return std::memcmp(&shape, &other, sizeof shape) <=> 0;
    });
  }
  template <class Element>
  bool in_range(const Element& element, Search::Range range) const {
    return ray.ordinary && (range == Search::Range::ordinary || ordinary(element));
  }
  template <class Element>
  RootEstimate triage(const Element& element, bool on, double limit) const {
    return trace::triage(element, ray, on, limit);
  }
  RootEstimate stable(scene::ShapeView element, bool on, double limit) const {
    return trace::stable(element, ray, on, limit);
  }
  RootEstimate improved(scene::ShapeView element, bool on, const RootEstimate& finding) const {
    return trace::improved(element, ray, on, finding);
  }
  surface::exact::Reach reach(scene::ShapeView element, bool on) const {
    return surface::exact::reach(element, rayo, on);
  }
  static std::strong_ordering order(const Parameter& a, const Parameter& b) { return surface::exact::order(a, b); }

  static ParameterBounds<double> ends(Step step, const RootEstimate& found) {
    return step == Step::triage ? ends_of(found.hi, found.error) : ends_of_pair(found.hi, found.error);
  }
  static ParameterBounds<double> ends(const Parameter& t) {
    const double nearest = number::round_to_binary64(t);
    return {std::nextafter(nearest, -no_limit), std::nextafter(nearest, no_limit)};
  }
  static bool ahead(const RootEstimate& a, const RootEstimate& b) { return a.hi < b.hi; }
  static bool certainly_less(const RootEstimate& a, const RootEstimate& b) { return trace::certainly_less(a, b); }

  RoundedPoint rounded(scene::ShapeView element, const RootEstimate& finding) const {
    return trace::rounded(element, ray, finding);
  }
  RoundedPoint rounded(const Parameter& t) const {
    const scene::Hit hit = surface::exact::rounded_hit(rayo, t, {});
    return {true, hit.t, hit.punto};
  }
};

}  // namespace

Search::Search(const scene::Scene& scene, const model::Rayo& rayo, Origin en, Counts& counts)
    : scene_(scene), rayo_(rayo), en_(en), counts_(counts), ray_(rayo) {}

void Search::test(scene::ElementRef e, Range range) {
  take(CertifiedSteps{scene_, rayo_, en_, ray_}, found_, e, range, counts_);
}

scene::Hit Search::finish() { return published(CertifiedSteps{scene_, rayo_, en_, ray_}, found_, counts_); }

RoundedPoint Search::rounded_hit(scene::ElementRef e, const RootEstimate& by_triage) const {
  return rounded_hit(e, point_of(CertifiedSteps{scene_, rayo_, en_, ray_}, Step::triage, by_triage));
}

RoundedPoint Search::rounded_hit(scene::ElementRef e, const Meeting& met) const {
  return rounded_candidate(CertifiedSteps{scene_, rayo_, en_, ray_}, {e, met}, counts_);
}

bool Search::blocks(scene::ElementRef e, Range range) const {
  return trace::blocks(CertifiedSteps{scene_, rayo_, en_, ray_}, e, range, counts_);
}

bool Search::blocks_segment(scene::ElementRef e, Range range) const {
  return trace::blocks_segment(CertifiedSteps{scene_, rayo_, en_, ray_}, e, range, counts_);
}

Meeting Search::meeting(scene::ElementRef e, double limit, Range range) const {
  return meeting_of(CertifiedSteps{scene_, rayo_, en_, ray_}, e, limit, range, counts_);
}

std::optional<Meeting> Search::certified_meeting(scene::ElementRef e, double limit) const {
  const CertifiedSteps steps{scene_, rayo_, en_, ray_};
  return steps.visit(e, [&](const auto& element) {
    const bool in_range = steps.in_range(element, Range::unknown);
    return in_range ? certified_meeting_of(steps, element, steps.on(e), limit) : std::nullopt;
  });
}

}  // namespace durero::trace
