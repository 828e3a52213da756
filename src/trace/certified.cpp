#include "durero/trace/certified.hpp"

#include "durero/trace/search.hpp"

namespace durero::trace {

namespace {

RoundedPoint lane_of(const RoundedPacket& rounded, std::size_t lane) {
  return {true, rounded.t[lane], {rounded.x[lane], rounded.y[lane], rounded.z[lane]}};
}

}  // namespace

void Certified::hit_own(std::uint32_t number, const RayNumbers& ray, scene::ElementRef e, const Point& point) {
  Hits& hits = waiting_own_[static_cast<std::size_t>(e.tipo)];
  hits.findings.set(hits.queue.count, point.finding);
  hits.queue.push(scene_, number, ray, e);
  if (hits.queue.full()) round(hits, improve_and_round_from);
}

void Certified::finish() {
  for (Hits& hits : waiting_) round(hits, improve_and_round);
  for (Hits& hits : waiting_own_) round(hits, improve_and_round_from);
}

void Certified::round(Hits& hits, Rounding rounding) {
  if (hits.queue.count == 0) return;
  rounding(hits.queue.packet, hits.queue.elements[0].tipo, hits.findings, rounded_);
  for (std::size_t lane = 0; lane < hits.queue.count; ++lane)
    write(hits.queue.numbers[lane], hits.queue.elements[lane], rounded(hits, lane));
  hits.queue.count = 0;
}

void Certified::write(std::uint32_t number, scene::ElementRef e, const RoundedPoint& rounded) {
  ++counts_.order[0];
  write_hit(hits_[number], e, rounded);
}

/// The lane's result where it is certain; the later steps for this ray and element where it is not.
RoundedPoint Certified::rounded(const Hits& hits, std::size_t lane) {
  if ((rounded_.certain >> lane & 1) != 0) {
    ++counts_.rounding[0];
    return lane_of(rounded_, lane);
  }
  const scene::Query& query = queries_[hits.queue.numbers[lane]];
  return Search(scene_, query.rayo, query.en, counts_).rounded_hit(hits.queue.elements[lane], hits.findings[lane]);
}

}  // namespace durero::trace
