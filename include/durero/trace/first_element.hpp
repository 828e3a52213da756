#pragma once
/// What a ray first meets, without where: for whoever needs neither t nor the point, no root is improved and nothing is
/// rounded.

#include <cstdint>
#include <span>

#include "durero/scene/hit.hpp"
#include "durero/trace/candidates.hpp"

namespace durero::trace {

/// A Hit less its numbers: plain, so that arrays of them take no memory beside their own.
struct FirstElement {
  model::Resultado resultado = model::Resultado::miss;  ///< resultado!
  std::uint32_t count = 0;                              ///< how many elementos! there are; 0 of a miss
  scene::ElementRef least{};                            ///< the least of elementos!; meaningless of a miss

  bool operator==(const FirstElement&) const = default;
};

/// That of an answer.
inline FirstElement first_element(const scene::Hit& hit) {
  if (hit.elementos.empty()) return {hit.resultado};
  return {hit.resultado, static_cast<std::uint32_t>(hit.elementos.size()), hit.elementos[0]};
}

/// A kernel of Batch that writes them, each in its place.
class FirstElements {
 public:
  using Findings = trace::Findings;  ///< of its triage
  /// What it keeps of a hit: between which its parameter lies, as in Certified::Point.
  class Point {
   public:
    Point() = default;  ///< of nothing: beyond every limit
    /// Of a hit.
    explicit Point(const Finding& by_triage)
        : low_(by_triage.hi - by_triage.error), high_(by_triage.hi + by_triage.error) {}
    double low() const { return low_; }    ///< not after it
    double high() const { return high_; }  ///< not before it

   private:
    double low_ = no_limit, high_ = no_limit;
  };

  /// Precondition: a place in `elements` for each query. It must outlive this.
  explicit FirstElements(Picked<FirstElement> elements) : elements_(elements) {}

  /// @{ What Batch asks of a kernel.
  static void triage(const Packet& packet, model::Tipo tipo, Findings& findings) {
    trace::triage(packet, tipo, findings);
  }
  static void triage(const RayColumns& rays, std::uint64_t which, scene::ShapeView shape, ColumnFindings& findings) {
    trace::triage(rays, which, shape, findings);
  }
  static void triage_from(const Packet& packet, model::Tipo tipo, Findings& findings) {
    trace::triage_from(packet, tipo, findings);
  }
  static Point point(const Findings& findings, std::size_t lane) { return Point(findings[lane]); }
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
  Picked<FirstElement> elements_;
};

/// first_element of first_hit_among of every query, in order. Threads and precondition as of first_hits_among.
template <PairCandidates Source>
void first_elements_among(const Source& source, std::span<const scene::Query> queries,
                          std::span<FirstElement> elements) {
  const std::vector<std::uint32_t> order = order_of(source, queries, Asked::first);
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    const auto block = picked(queries, order, begin, count);
    const auto answers = picked(elements, order, begin, count);
    FirstElements kernel(answers);
    Batch batch(source, block, kernel);
    batch.answer();
    Counts unseen;
    batch.for_each_alone([&](std::uint32_t number) {
      answers[number] = first_element(first_hit_among(source, block[number].rayo, block[number].en, unseen));
    });
  });
}

}  // namespace durero::trace
