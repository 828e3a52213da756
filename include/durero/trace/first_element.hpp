#pragma once
/// The first element that a ray meets, without its point. No root is improved and nothing is rounded, which is faster
/// for callers that need neither t nor the point.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "durero/scene/hit.hpp"
#include "durero/trace/candidates.hpp"

namespace durero::trace {

/// A Hit without its numbers, and without memory of its own.
struct FirstElement {
  model::Resultado resultado = model::Resultado::miss;  ///< resultado!
  std::uint32_t count = 0;                              ///< the size of elementos!; 0 of a miss
  scene::ElementRef least{};                            ///< the least of elementos!; without meaning for a miss

  bool operator==(const FirstElement&) const = default;
};

/// The FirstElement of a hit.
inline FirstElement first_element(const scene::Hit& hit) {
  if (hit.elementos.empty()) return {hit.resultado};
  return {hit.resultado, static_cast<std::uint32_t>(hit.elementos.size()), hit.elementos[0]};
}

/// A kernel of Batch that writes the first elements, each into its query's place.
class FirstElements {
 public:
  using Findings = trace::Findings;  ///< the result of triage
  /// A hit's record: bounds of its parameter, as in Certified::Point.
  class Point {
   public:
    Point() = default;  ///< no hit: both bounds are ∞
    /// The bounds of a hit by triage.
    Point(const Findings& by_triage, std::size_t lane) : low_(by_triage.low(lane)), high_(by_triage.high(lane)) {}
    double low() const { return low_; }    ///< the lower bound
    double high() const { return high_; }  ///< the upper bound

   private:
    double low_ = no_limit, high_ = no_limit;
  };

  /// The kernel keeps a reference to `elements`, which must outlive it. Precondition: `elements` has a place for each
  /// query.
  explicit FirstElements(IndexedView<FirstElement> elements) : elements_(elements) {}

  /// @{ The functions that Batch calls.
  static void triage(const Packet& packet, model::Tipo tipo, Findings& findings) {
    trace::triage(packet, tipo, findings);
  }
  static void triage(const RayColumns& rays, std::uint64_t which, scene::ShapeView shape, ColumnFindings& findings) {
    trace::triage(rays, which, shape, findings);
  }
  static void triage(const Ray& ray, const TriangleBlock& block, Findings& findings) {
    trace::triage(ray, block, findings);
  }
  static void triage_from(const Packet& packet, model::Tipo tipo, Findings& findings) {
    trace::triage_from(packet, tipo, findings);
  }
  static std::pair<double, double> bounds(const Findings& findings, std::size_t lane) {
    return {findings.low(lane), findings.high(lane)};
  }
  static Point point(const Findings& findings, std::size_t lane) { return Point(findings, lane); }
  void miss(std::uint32_t number) { elements_[number] = {}; }
  template <class Source>
  void hit(std::uint32_t number, const Ray&, const Source& source, scene::ElementRef own, const Point&) {
    elements_[number] = {model::Resultado::hit, 1, source.element(own)};
  }
  void hit_own(std::uint32_t number, const Ray&, scene::ElementRef e, const Point&) {
    elements_[number] = {model::Resultado::hit, 1, e};
  }
  /// @}

 private:
  IndexedView<FirstElement> elements_;
};

/// first_element of first_hit_among of every query, in order. Threads and preconditions are those of first_hits_among.
template <PairCandidates Source>
void first_elements_among(const Source& source, std::span<const scene::Query> queries,
                          std::span<FirstElement> elements) {
  const std::vector<std::uint32_t> order = order_of(source, queries, QueryKind::first);
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    const auto block = picked(queries, order, begin, count);
    const auto answers = picked(elements, order, begin, count);
    const Unbundled unbundled(
        source, block, SingleSearch::nearest, [&](std::uint32_t first, const SingleRays& rays, std::uint64_t which) {
          for (; which != 0; which &= which - 1) {
            const auto place = static_cast<std::size_t>(std::countr_zero(which));
            const std::uint32_t found = rays.found(place);
            answers[first + place] =
                found == SingleRays::none
                    ? FirstElement{}
                    : FirstElement{model::Resultado::hit, 1, source.element({model::Tipo::soy_triangulo, found})};
          }
        });
    if (unbundled.none()) return;
    const auto left = unbundled.of(block);
    const auto own = unbundled.of(answers);
    FirstElements kernel(own);
    Batch batch(source, left, kernel);
    batch.answer();
    Counts unseen;
    batch.for_each_alone([&](std::uint32_t number) {
      own[number] = first_element(first_hit_among(source, left[number].rayo, left[number].en, unseen));
    });
  });
}

}  // namespace durero::trace
