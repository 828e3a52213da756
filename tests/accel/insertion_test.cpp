// The incremental construction: what it costs is known exactly, and how far from the best hierarchies it is by trying
// all of those, where elements are few.
#include "accel/insertion.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "accel/top_down.hpp"
#include "durero/number/dyadic.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include "support/scenes.hpp"

using namespace durero;
using namespace durero::test;
using accel::Hierarchy;
using accel::Insertion;
using accel::Position;
using number::Dyadic;

namespace {

using Boxes = std::vector<surface::Box>;

Boxes random_boxes(Random& random, std::size_t count) {
  Boxes boxes;
  while (boxes.size() < count) {
    const glm::dvec3 low = random.in_cube(1), size = random.in_cube(0.2) + 0.21;
    boxes.push_back({low, low + size});
  }
  return boxes;
}

/// Small boxes, that many in the unit of space, whatever their number.
Boxes spread_boxes(Random& random, std::size_t count) {
  Boxes boxes;
  const double side = std::cbrt(double(count));
  while (boxes.size() < count) {
    const glm::dvec3 low = random.in_cube(side);
    boxes.push_back({low, low + glm::dvec3(0.5)});
  }
  return boxes;
}

Hierarchy::Number leaf(Hierarchy& tree, const Boxes& boxes, std::size_t i) {
  return tree.leaf({model::Tipo::soy_esfera, std::uint32_t(i)}, boxes[i]);
}

enum class Criterion : std::uint8_t { downwards, of_all };

template <class N>
Position<N> position(const Hierarchy& tree, const surface::Box& box, Criterion criterion, unsigned most = 8) {
  Insertion<N> insertion(tree, box, most);
  return criterion == Criterion::of_all ? insertion.of_all() : insertion.downwards();
}

struct Grown {
  Hierarchy tree;
  std::size_t examined = 0;
};

Grown grown(const Boxes& boxes, Criterion criterion, unsigned most = 8) {
  Grown result;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Position<double> at = position<double>(result.tree, boxes[i], criterion, most);
    result.examined += at.examined;
    put(result.tree, at, leaf(result.tree, boxes, i));
  }
  return result;
}

Hierarchy from_above(const Boxes& boxes, unsigned most = 8) {
  Hierarchy tree;
  std::vector<Hierarchy::Number> leaves;
  for (std::size_t i = 0; i < boxes.size(); ++i) leaves.push_back(leaf(tree, boxes, i));
  tree.set_root(accel::top_down(tree, leaves, most));
  return tree;
}

/// The least Σ k·A over all hierarchies of some boxes, and how many hierarchies there are. Sets are numbers in binary.
class Exhaustion {
 public:
  explicit Exhaustion(const Boxes& boxes) : boxes_(boxes) {}

  double least() { return of((1U << boxes_.size()) - 1).least; }
  std::size_t hierarchies() { return of((1U << boxes_.size()) - 1).count; }

 private:
  struct Answer {
    double least;
    std::size_t count;
  };

  Answer of(unsigned set) {
    if (std::has_single_bit(set)) return {0, 1};
    if (const auto known = known_.find(set); known != known_.end()) return known->second;
    surface::Box box = boxes_[std::size_t(std::countr_zero(set))];
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if ((set >> i & 1U) != 0) box = accel::around(box, boxes_[i]);
    Answer best{std::numeric_limits<double>::infinity(), 0};
    parts(set, accel::area<double>(box), 0, {0, 1}, best);
    return known_[set] = best;
  }

  /// Every partition of what is left, by the part of its least element; `parts_so_far` parts have been cut off, whose
  /// trees cost and number `so_far`.
  void parts(unsigned left, double area, int parts_so_far, Answer so_far, Answer& best) {
    if (left == 0) {
      if (parts_so_far < 2) return;
      best.least = std::min(best.least, so_far.least + parts_so_far * area);
      best.count += so_far.count;
      return;
    }
    const unsigned first = left & -left, others = left ^ first;
    for (unsigned more = others;; more = (more - 1) & others) {
      const unsigned part = first | more;
      if (parts_so_far > 0 || part != left) {
        const Answer own = of(part);
        parts(left ^ part, area, parts_so_far + 1, {so_far.least + own.least, so_far.count * own.count}, best);
      }
      if (more == 0) break;
    }
  }

  const Boxes& boxes_;
  std::map<unsigned, Answer> known_;
};

double slope(double at_first, double at_last, double ratio) { return std::log(at_last / at_first) / std::log(ratio); }

}  // namespace

TEST_CASE("increments add up to the cost exactly, and both kinds of position occur") {
  for (const Criterion criterion : {Criterion::downwards, Criterion::of_all})
    for (const unsigned most : {2U, 3U, 8U}) {
      Random random(most);
      const Boxes boxes = random_boxes(random, fewer_when_sanitized(60) + 10);
      Hierarchy tree;
      Dyadic maintained(0);
      std::size_t under = 0, beside = 0;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const auto at = position<Dyadic>(tree, boxes[i], criterion, most);
        ++(at.kind == Position<Dyadic>::Kind::under ? under : beside);
        maintained += at.increment;
        put(tree, at, leaf(tree, boxes, i));
        REQUIRE(maintained == accel::weight<Dyadic>(tree));
      }
      CHECK((under > 0) == (most > 2));
      CHECK(beside > 2);
    }
}

TEST_CASE("no position costs less than the one that is found among all") {
  Random random(2);
  const Boxes boxes = random_boxes(random, 40);
  Hierarchy tree;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto best = position<Dyadic>(tree, boxes[i], Criterion::of_all);
    const auto quick = position<Dyadic>(tree, boxes[i], Criterion::downwards);
    CHECK(best.increment <= quick.increment);
    CHECK(best.examined == (tree.empty() ? 0 : tree.inner_nodes() + tree[tree.root()].leaves));
    if (!tree.empty()) {
      Dyadic least = best.increment;
      for (Hierarchy::Number node = 0; node < best.examined; ++node) {
        Hierarchy beside = tree;
        beside.put_beside(node, leaf(beside, boxes, i));
        least = std::min(least, accel::weight<Dyadic>(beside) - accel::weight<Dyadic>(tree));
        if (tree[node].is_leaf() || tree[node].arity == 8) continue;
        Hierarchy under = tree;
        under.put_under(node, leaf(under, boxes, i));
        least = std::min(least, accel::weight<Dyadic>(under) - accel::weight<Dyadic>(tree));
      }
      CHECK(least == best.increment);
    }
    put(tree, best, leaf(tree, boxes, i));
  }
}

TEST_CASE("for up to seven elements every build is near the best of all hierarchies, of which there are so many") {
  const std::size_t hierarchies[] = {1, 1, 4, 26, 236, 2752, 39208};  // Schröder's fourth problem
  double worst[3] = {}, sum[3] = {};
  std::size_t tried = 0;
  for (std::size_t n = 2; n <= 7; ++n)
    for (std::uint64_t seed = 1; seed <= fewer_when_sanitized(20); ++seed) {
      Random random(seed);
      const Boxes boxes = random_boxes(random, n);
      Exhaustion all(boxes);
      CHECK(all.hierarchies() == hierarchies[n - 1]);
      const double best = all.least();
      const double own[] = {accel::weight<double>(from_above(boxes)),
                            accel::weight<double>(grown(boxes, Criterion::of_all).tree),
                            accel::weight<double>(grown(boxes, Criterion::downwards).tree)};
      ++tried;
      for (int i = 0; i < 3; ++i) {
        CHECK(own[i] >= best * (1 - 1e-12));
        worst[i] = std::max(worst[i], own[i] / best);
        sum[i] += own[i] / best;
      }
    }
  for (int i = 0; i < 3; ++i) {
    INFO("build " << i << ": worst " << worst[i] << ", mean " << sum[i] / double(tried));
    CHECK(worst[i] <= 1.5);
    CHECK(sum[i] / double(tried) <= 1.15);
  }
}

TEST_CASE("to try every position takes n looks an element, to go down log n") {
  Random random(3);
  const std::size_t few = 200, many = 800;
  const double of_all = slope(double(grown(spread_boxes(random, few), Criterion::of_all).examined),
                              double(grown(spread_boxes(random, many), Criterion::of_all).examined), 4);
  const double down = slope(double(grown(spread_boxes(random, 1000), Criterion::downwards).examined),
                            double(grown(spread_boxes(random, 8000), Criterion::downwards).examined), 8);
  INFO(of_all << " and " << down);
  CHECK(std::abs(of_all - 2) < 0.1);
  CHECK(down > 1);
  CHECK(down < 1.25);
}

TEST_CASE("to go down takes log n looks an element up to a million, and comes near to what every position gives",
          "[long]") {
  Random random(8);
  std::vector<double> looks;
  for (const std::size_t size : {1000, 10'000, 100'000, 1'000'000}) {
    const Grown down = grown(spread_boxes(random, size), Criterion::downwards);
    looks.push_back(double(down.examined));
    UNSCOPED_INFO(size << ": " << looks.back() / double(size) << " looks an element, " << down.tree.depth() << " deep");
  }
  for (const std::size_t size : {1000, 2000, 4000, 8000}) {
    Boxes boxes = spread_boxes(random, size);
    const Grown of_all = grown(boxes, Criterion::of_all), down = grown(boxes, Criterion::downwards);
    std::ranges::sort(boxes, {}, [](const surface::Box& box) { return box.low.x; });
    const Grown sorted = grown(boxes, Criterion::downwards);
    const double least = accel::weight<double>(of_all.tree);
    UNSCOPED_INFO(size << ": of all " << double(of_all.examined) / double(size) << " looks an element; down "
                       << accel::weight<double>(down.tree) / least << " of its cost, sorted "
                       << accel::weight<double>(sorted.tree) / least);
    CHECK(least < accel::weight<double>(down.tree));
  }
  const double power = slope(looks.front(), looks.back(), 1000);
  INFO("the looks of all grow with the power " << power);
  CHECK(power > 1);
  CHECK(power < 1.2);
}

TEST_CASE("the cost depends on the order of insertion, and every position on average does better") {
  Random random(4);
  Boxes boxes = spread_boxes(random, 400);
  const double shuffled = accel::weight<double>(grown(boxes, Criterion::downwards).tree);
  const double of_all = accel::weight<double>(grown(boxes, Criterion::of_all).tree);
  const double by_area = accel::weight<double>(from_above(boxes));
  std::ranges::sort(boxes, {}, [](const surface::Box& box) { return box.low.x; });
  const double sorted = accel::weight<double>(grown(boxes, Criterion::downwards).tree);
  INFO("shuffled " << shuffled << ", of all " << of_all << ", by area " << by_area << ", sorted " << sorted);
  CHECK(of_all < shuffled);
  CHECK(sorted != shuffled);
  CHECK(by_area < 1.2 * of_all);
}

TEST_CASE("equal boxes keep a tree balanced") {
  const Boxes boxes(2000, {{0, 0, 0}, {1, 1, 1}});
  CHECK(grown(boxes, Criterion::downwards).tree.depth() < 12);
  CHECK(from_above(boxes).depth() < 12);
  CHECK(grown(boxes, Criterion::downwards, 2).tree.depth() < 24);
}
