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
    pile.rays[pile.count] = ray;
    pile.elements[pile.count] = e;
    if (++pile.count == Pack::size) round(pile);
  }

  void alone(std::uint32_t ray) { counts_ += answer(ray); }

  void finish() {
    for (Pile& pile : piles_) round(pile);
  }

 private:
  /// Hits of one type that wait to be rounded.
  struct Pile {
    Pack pack;
    Findings findings;
    std::array<std::uint32_t, Pack::size> rays{};
    std::array<scene::ElementRef, Pack::size> elements{};
    std::size_t count = 0;
  };

  Counts answer(std::uint32_t ray) {
    Counts counts;
    const scene::Query& query = queries_[ray];
    hits_[ray] = first_hit(tables_, query.rayo, query.en, &counts);
    return counts;
  }

  void round(Pile& pile) {
    if (pile.count == 0) return;
    improve_and_round(pile.pack, pile.elements[0].tipo, pile.findings, rounded_);
    for (std::size_t lane = 0; lane < pile.count; ++lane) {
      const std::uint32_t ray = pile.rays[lane];
      ++counts_.order[0];
      if ((rounded_.certain >> lane & 1) == 0) {
        const Counts counts = answer(ray);  // element and order are counted
        for (std::size_t step = 0; step < 3; ++step) counts_.rounding[step] += counts.rounding[step];
        continue;
      }
      ++counts_.rounding[0];
      scene::Hit& hit = hits_[ray];
      hit.resultado = model::Resultado::hit;
      hit.t = rounded_.t[lane];
      hit.punto = {rounded_.x[lane], rounded_.y[lane], rounded_.z[lane]};
      hit.elementos.push_back(pile.elements[lane]);
    }
    pile.count = 0;
  }

  const Tables& tables_;
  std::span<const scene::Query> queries_;
  std::span<scene::Hit> hits_;
  Counts& counts_;
  std::array<Pile, 3> piles_{};
  RoundedPack rounded_;
};

}  // namespace

std::vector<scene::Hit> first_hits(const Tables& tables, std::span<const scene::Query> queries, unsigned threads,
                                   Counts* counts) {
  std::mutex adding;
  return in_blocks(queries, threads, [&](std::span<const scene::Query> block, std::span<scene::Hit> hits) {
    Counts mine;
    Certified engine(tables, block, hits, mine);
    Batch batch(tables, block, engine);
    batch.answer();
    engine.finish();
    mine.element[0] += batch.decided();
    if (counts == nullptr) return;
    const std::scoped_lock lock(adding);
    *counts += mine;
  });
}

}  // namespace durero::trace
