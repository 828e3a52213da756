#include "durero/trace/certified.hpp"

#include "durero/trace/search.hpp"

namespace durero::trace {

void Certified::finish() {
  for (Hits& hits : waiting_) round(hits);
}

void Certified::round(Hits& hits) {
  if (hits.queue.count == 0) return;
  improve_and_round(hits.queue.packet, hits.queue.elements[0].tipo, hits.findings, rounded_);
  for (std::size_t lane = 0; lane < hits.queue.count; ++lane) write(hits, lane);
  hits.queue.count = 0;
}

void Certified::write(const Hits& hits, std::size_t lane) {
  ++counts_.order[0];
  const Rounded r = rounded(hits, lane);
  scene::Hit& hit = hits_[hits.queue.numbers[lane]];
  hit.resultado = model::Resultado::hit;
  hit.t = r.t;
  hit.punto = r.punto;
  hit.elementos.clear();
  hit.elementos.push_back(hits.queue.elements[lane]);
}

/// What the lanes found; where they are not certain, the steps after them for this ray and element alone.
Rounded Certified::rounded(const Hits& hits, std::size_t lane) {
  if ((rounded_.certain >> lane & 1) != 0) {
    ++counts_.rounding[0];
    return {true, rounded_.t[lane], {rounded_.x[lane], rounded_.y[lane], rounded_.z[lane]}};
  }
  const scene::Query& query = queries_[hits.queue.numbers[lane]];
  return Search(scene_, query.rayo, query.en, counts_).rounded_hit(hits.queue.elements[lane], hits.findings[lane]);
}

}  // namespace durero::trace
