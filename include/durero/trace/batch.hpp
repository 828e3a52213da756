#pragma once
/// The first hits of many rays: blocks of rays against chunks of elements, and what passes the filter by eight in
/// lanes. A ray that needs more than that (numbers out of the ordinary, a start on elements, doubt about one element,
/// or two elements whose points are not told apart) is answered alone, from the beginning.

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "durero/scene/hit.hpp"
#include "durero/trace/pack.hpp"
#include "durero/trace/search.hpp"
#include "durero/trace/tables.hpp"

namespace durero::trace {

/// One block. An Engine has
///   Findings, the result of its triage(pack, tipo, findings) in lanes, with the bits hit and undecided;
///   Point, what it keeps of a hit, by point(findings, lane): its parameter is between low() and high(), ∞ by default;
///   hit(ray, beam, e, point), told the nearest point of a ray; and alone(ray), which is to answer a ray by itself.
template <class Engine>
class Batch {
 public:
  Batch(const Tables& tables, std::span<const scene::Query> queries, Engine& engine)
      : tables_(tables), engine_(engine) {
    beams_.reserve(queries.size());
    for (const scene::Query& query : queries) beams_.emplace_back(query.rayo);
    nearest_.resize(queries.size());
    for (std::size_t ray = 0; ray < queries.size(); ++ray) {
      nearest_[ray].alone = !beams_[ray].ordinary || !queries[ray].en.empty() || !tables.extraordinary().empty();
    }
  }

  /// Tells the engine of every ray that is not a miss.
  void answer() {
    for (std::size_t begin = 0; begin < tables_.elements().size(); begin += chunk) meet_chunk(begin);
    for (std::uint32_t ray = 0; ray < nearest_.size(); ++ray) {
      const Nearest& found = nearest_[ray];
      if (found.alone) {
        engine_.alone(ray);
        continue;
      }
      decided_ += found.tested;
      if (found.point.low() < no_limit) engine_.hit(ray, beams_[ray], found.e, found.point);
    }
  }

  /// How many pairs of a ray and an element the lanes decided, for the rays not answered alone.
  std::uint64_t decided() const noexcept { return decided_; }

 private:
  static constexpr std::size_t chunk = 32 * Balls::block;

  /// Of one ray, so far.
  struct Nearest {
    typename Engine::Point point{};
    scene::ElementRef e{};
    std::uint32_t tested = 0;
    bool alone = false;
  };
  /// Rays that wait for an element of one type.
  struct Pile {
    Pack pack;
    std::array<std::uint32_t, Pack::size> rays{};
    std::array<scene::ElementRef, Pack::size> elements{};
    std::size_t count = 0;
  };

  void meet_chunk(std::size_t begin) {
    const auto elements = tables_.elements();
    const std::size_t end = std::min(begin + chunk, elements.size());
    for (std::uint32_t ray = 0; ray < nearest_.size(); ++ray) {
      if (nearest_[ray].alone) continue;
      const double limit = nearest_[ray].point.high();
      const std::size_t count = filter(tables_.balls(), beams_[ray], limit, begin, end, passed_.data());
      for (std::size_t i = 0; i < count; ++i) take(ray, elements[passed_[i]]);
    }
    for (Pile& pile : piles_) test(pile);
  }

  void take(std::uint32_t ray, scene::ElementRef e) {
    Pile& pile = piles_[static_cast<std::size_t>(e.tipo)];
    tables_.scene().visit(e, [&](const auto& shape) { pile.pack.set(pile.count, beams_[ray], shape); });
    pile.rays[pile.count] = ray;
    pile.elements[pile.count] = e;
    if (++pile.count == Pack::size) test(pile);
  }

  void test(Pile& pile) {
    if (pile.count == 0) return;
    engine_.triage(pile.pack, pile.elements[0].tipo, findings_);
    const unsigned used = (1u << pile.count) - 1;
    for (std::size_t lane = 0; lane < pile.count; ++lane) ++nearest_[pile.rays[lane]].tested;
    for (unsigned left = findings_.undecided & used; left != 0; left &= left - 1) {
      nearest_[pile.rays[static_cast<std::size_t>(std::countr_zero(left))]].alone = true;
    }
    for (unsigned left = findings_.hit & used; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(left));
      keep_nearest(nearest_[pile.rays[lane]], pile.elements[lane], engine_.point(findings_, lane));
    }
    pile.count = 0;
  }

  static void keep_nearest(Nearest& nearest, scene::ElementRef e, const typename Engine::Point& point) {
    if (point.low() > nearest.point.high()) return;
    if (!(point.high() < nearest.point.low())) nearest.alone = true;
    nearest.point = point;
    nearest.e = e;
  }

  const Tables& tables_;
  Engine& engine_;
  std::vector<Beam> beams_;
  std::vector<Nearest> nearest_;
  std::array<Pile, 3> piles_{};
  typename Engine::Findings findings_{};
  std::uint64_t decided_ = 0;
  std::array<std::uint32_t, chunk> passed_;
};

/// answer(begin, count) for blocks that make up `size` queries, on as many threads as the calling one may use.
template <class Answer>
void for_each_block(std::size_t size, Answer answer) {
  constexpr std::size_t block_size = 256;
  const std::size_t blocks = (size + block_size - 1) / block_size;
  const auto answer_block = [&](std::size_t block) {
    const std::size_t begin = block * block_size;
    answer(begin, std::min(block_size, size - begin));
  };
  if (blocks == 1) return answer_block(0);
  oneapi::tbb::parallel_for(std::size_t{0}, blocks, answer_block);
}

}  // namespace durero::trace
