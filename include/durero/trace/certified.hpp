#pragma once
/// The kernel of Batch for certified hits: triage in lanes, then the nearest points are improved and rounded in lanes.

#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/trace/counts.hpp"
#include "durero/trace/packet.hpp"
#include "durero/trace/picked.hpp"

namespace durero::trace {

/// Writes a hit on one element.
inline void write_hit(scene::Hit& hit, scene::ElementRef e, const RoundedPoint& rounded) {
  hit.resultado = model::Resultado::hit;
  hit.t = rounded.t;
  hit.punto = rounded.punto;
  if (hit.elementos.size() == 1) {  // as in nearly all hits that are written over
    hit.elementos[0] = e;
  } else {
    hit.elementos.assign(1, e);
  }
}
/// Writes a miss.
inline void write_miss(scene::Hit& hit) {
  hit.resultado = model::Resultado::miss;
  hit.t = 0;
  hit.punto = glm::dvec3(0);
  hit.elementos.clear();
}

/// A kernel of Batch. It writes each hit into its query's place, and counts the decisions of each step.
class Certified {
 public:
  using Findings = trace::Findings;  ///< the result of triage
  /// A hit's record.
  struct Point {
    RootEstimate finding{Decision::miss, no_limit};  ///< by triage
    /// @{ Bounds of the parameter, as Findings has them.
    double low() const { return finding.hi - finding.error; }
    double high() const { return finding.hi + finding.error; }
    /// @}
  };

  /// The kernel keeps references to its arguments, which must outlive it. Precondition: `hits` has a place for each
  /// query. `of_pairs` says whether pairs are counted; the other counts are always added to.
  Certified(const scene::Scene& scene, IndexedView<const scene::Query> queries, IndexedView<scene::Hit> hits,
            Counts& counts, bool of_pairs)
      : counted(of_pairs), scene_(scene), queries_(queries), hits_(hits), counts_(counts) {}

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
  static Point point(const Findings& findings, std::size_t lane) { return {findings[lane]}; }

  void miss(std::uint32_t number) { write_miss(hits_[number]); }
  template <class Source>
  void hit(std::uint32_t number, const RayNumbers& ray, const Source& source, scene::ElementRef own,
           const Point& point) {
    Hits& hits = waiting_[static_cast<std::size_t>(own.tipo)];
    hits.findings.set(hits.queue.count, point.finding);
    hits.queue.push(source, number, ray, own);
    hits.queue.elements[hits.queue.count - 1] = source.element(own);
    if (hits.queue.full()) round(hits, improve_and_round);
  }
  void hit_own(std::uint32_t number, const RayNumbers& ray, scene::ElementRef e, const Point& point);
  /// @}

  /// Writes the hits that still wait for a packet to fill. Precondition: the batch has answered.
  void finish();

  const bool counted;  ///< whether the pairs are counted

 private:
  /// Hits of one type that wait to be rounded in lanes.
  struct Hits {
    Queue queue;
    Findings findings;
  };

  using Rounding = void (*)(const Packet&, model::Tipo, const Findings&, RoundedPacket&);

  void round(Hits& hits, Rounding rounding);
  void write(std::uint32_t number, scene::ElementRef e, const RoundedPoint& rounded);
  RoundedPoint rounded(const Hits& hits, std::size_t lane);

  const scene::Scene& scene_;
  IndexedView<const scene::Query> queries_;
  IndexedView<scene::Hit> hits_;
  Counts& counts_;
  std::array<Hits, scene::shape_count> waiting_{};
  std::array<Hits, scene::shape_count> waiting_own_{};  // on the elements that their rays start on
  RoundedPacket rounded_;
};

}  // namespace durero::trace
