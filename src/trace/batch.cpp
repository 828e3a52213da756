#include "durero/trace/batch.hpp"

#include <mutex>

#include "durero/trace/analytic.hpp"

namespace durero::trace {
namespace {

/// The certified steps: triage in lanes, then the nearest points improved and rounded in lanes.
class Certified {
 public:
  using Findings = trace::Findings;
  struct Point {
    Finding found{Verdict::miss, no_limit};
    // As the triage's error is more than three roundings of t more than needed (`quotient`), the ends may be rounded.
    double low() const { return found.hi - found.error; }
    double high() const { return found.hi + found.error; }
  };

  Certified(const Tables& tables, std::span<const scene::Query> queries, std::span<scene::Hit> hits, Counts& counts)
      : tables_(tables), queries_(queries), hits_(hits), counts_(counts) {}

  static void triage(const Pack& pack, model::Tipo tipo, Findings& findings) { trace::triage(pack, tipo, findings); }
  static Point point(const Findings& findings, std::size_t lane) { return {findings[lane]}; }

  void hit(std::uint32_t ray, const Beam& beam, scene::ElementRef e, const Point& point) {
    Pile& pile = piles_[static_cast<std::size_t>(e.tipo)];
    tables_.scene().visit(e, [&](const auto& shape) { pile.pack.set(pile.count, beam, shape); });
    pile.findings.set(pile.count, point.found);
    pile.found[pile.count] = point.found;
    pile.rays[pile.count] = ray;
    pile.elements[pile.count] = e;
    if (++pile.count == Pack::size) round(pile);
  }

  void alone(std::uint32_t ray) {
    const scene::Query& query = queries_[ray];
    hits_[ray] = first_hit(tables_, query.rayo, query.en, &counts_);
  }

  void finish() {
    for (Pile& pile : piles_) round(pile);
  }

 private:
  /// Hits of one type that wait to be rounded.
  struct Pile {
    Pack pack;
    Findings findings;
    std::array<Finding, Pack::size> found;  // the same, of one lane
    std::array<std::uint32_t, Pack::size> rays{};
    std::array<scene::ElementRef, Pack::size> elements{};
    std::size_t count = 0;
  };

  void round(Pile& pile) {
    if (pile.count == 0) return;
    improve_and_round(pile.pack, pile.elements[0].tipo, pile.findings, rounded_);
    for (std::size_t lane = 0; lane < pile.count; ++lane) {
      ++counts_.order[0];
      const Rounded r = round_lane(pile, lane);
      scene::Hit& hit = hits_[pile.rays[lane]];
      hit.resultado = model::Resultado::hit;
      hit.t = r.t;
      hit.punto = r.punto;
      hit.elementos.push_back(pile.elements[lane]);
    }
    pile.count = 0;
  }

  /// What the lanes found; where they are not certain, the steps after them for this ray and element alone.
  Rounded round_lane(const Pile& pile, std::size_t lane) {
    if ((rounded_.certain >> lane & 1) != 0) {
      ++counts_.rounding[0];
      return {true, rounded_.t[lane], {rounded_.x[lane], rounded_.y[lane], rounded_.z[lane]}};
    }
    const scene::Query& query = queries_[pile.rays[lane]];
    return Search(tables_.scene(), query.rayo, query.en, counts_).rounded_hit(pile.elements[lane], pile.found[lane]);
  }

  const Tables& tables_;
  std::span<const scene::Query> queries_;
  std::span<scene::Hit> hits_;
  Counts& counts_;
  std::array<Pile, 3> piles_{};
  RoundedPack rounded_;
};

}  // namespace

void first_hits(const Tables& tables, std::span<const scene::Query> queries, std::span<scene::Hit> hits,
                Counts* counts) {
  std::mutex adding;
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    Counts mine;
    const auto block = queries.subspan(begin, count);
    Certified engine(tables, block, hits.subspan(begin, count), mine);
    Batch batch(tables, block, engine);
    batch.answer();
    engine.finish();
    mine.element[0] += batch.decided();
    if (counts == nullptr) return;
    const std::scoped_lock lock(adding);
    *counts += mine;
  });
}

std::vector<scene::Hit> first_hits(const Tables& tables, std::span<const scene::Query> queries, Counts* counts) {
  std::vector<scene::Hit> hits(queries.size());
  first_hits(tables, queries, hits, counts);
  return hits;
}

void occluded_segments(const Tables& tables, std::span<const scene::Query> queries, std::span<bool> occluded) {
  for_each_block(queries.size(), [&](std::size_t begin, std::size_t count) {
    for (std::size_t i = begin; i < begin + count; ++i)
      occluded[i] = occluded_segment(tables, queries[i].rayo, queries[i].en);
  });
}

}  // namespace durero::trace
