#include "durero/trace/bundled.hpp"

#include <algorithm>
#include <vector>

#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace durero;
using namespace durero::test;
using trace::IndexedView;
using trace::SingleRays;
using trace::SingleSearch;
using trace::Unbundled;

namespace {

/// A source that hands back the rays whose x is odd, and counts the searches.
struct ByParity {
  bool can = true;
  mutable std::size_t searches = 0;

  bool bundles() const { return can; }
  void search(SingleSearch, SingleRays& rays) const {
    ++searches;
    rays.left = 0;
    for (std::size_t i = 0; i < rays.count; ++i)
      rays.left |= std::uint64_t{static_cast<int>(rays.stored_p[0][i]) % 2 != 0} << i;
  }
  trace::TriangleBlock block(std::uint32_t) const { return trace::TriangleBlock(nullptr); }
  static scene::ElementRef own(scene::ElementRef e) { return {e.tipo, e.index + 100}; }
};

/// The answer to a bundle that calls use(number, rays, place) for each place.
template <class Use>
auto each_place(Use use) {
  return [use](std::uint32_t first, const SingleRays& rays, std::uint64_t which) {
    for (std::uint32_t place = 0; place < SingleRays::size; ++place)
      if ((which >> place & 1) != 0) use(first + place, rays, place);
  };
}

std::vector<scene::Query> queries_at(std::size_t count, std::size_t step) {
  std::vector<scene::Query> queries;
  for (std::size_t i = 0; i < count; ++i) queries.push_back({ray({static_cast<double>(step * i), 1, 2}, {3, 4, 5})});
  return queries;
}

/// The places that are left, by the x of their queries.
std::vector<double> places_left(const Unbundled& left, IndexedView<const scene::Query> queries) {
  std::vector<double> places;
  const auto view = left.of(queries);
  for (std::size_t i = 0; i < view.size(); ++i) places.push_back(view[i].rayo.p().x());
  return places;
}

}  // namespace

TEST_CASE("queries are answered in bundles or left, each once") {
  const std::vector<scene::Query> queries = queries_at(150, 1);
  const ByParity source;
  std::vector<int> answered(queries.size());
  const Unbundled left(source, queries, SingleSearch::nearest,
                       each_place([&](std::uint32_t number, const SingleRays& rays, std::size_t place) {
                         ++answered[number];
                         CHECK(rays.stored_p[0][place] == number);
                         CHECK(rays.stored_v[2][place] == 5);
                         CHECK(rays.start[place] == SingleRays::none);
                       }));
  CHECK(source.searches == 3);
  CHECK_FALSE(left.none());
  const std::vector<double> places = places_left(left, queries);
  CHECK(places.size() == 75);
  for (std::size_t i = 0; i < queries.size(); ++i)
    CHECK(answered[i] + std::ranges::count(places, static_cast<double>(i)) == 1);
  const std::vector<scene::Query> even = queries_at(64, 2);
  const Unbundled all(source, even, SingleSearch::any, [](auto...) {});
  CHECK(all.none());
}

TEST_CASE("queries of a permuted view are left by their places in the whole") {
  const std::vector<scene::Query> queries = queries_at(20, 1);
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 20; i-- > 4;) order.push_back(i);
  const IndexedView<const scene::Query> view(queries, order);
  const Unbundled left(ByParity(), view, SingleSearch::nearest,
                       each_place([&](std::uint32_t number, const SingleRays& rays, std::size_t place) {
                         CHECK(rays.stored_p[0][place] == order[number]);
                       }));
  CHECK(places_left(left, view) == std::vector<double>{19, 17, 15, 13, 11, 9, 7, 5});
}

TEST_CASE("a ray that starts on one element takes its name along, and one that starts on several is left") {
  std::vector<scene::Query> queries = queries_at(10, 2);
  const auto element = [](std::uint32_t index) { return scene::ElementRef{model::Tipo::soy_triangulo, index}; };
  queries[3].en = {element(7)};
  queries[4].en = {element(7), element(8)};
  const Unbundled left(ByParity(), queries, SingleSearch::any,
                       each_place([&](std::uint32_t number, const SingleRays& rays, std::size_t place) {
                         CHECK(number != 4);
                         CHECK(rays.start[place] == (number == 3 ? 107 : SingleRays::none));
                       }));
  CHECK(places_left(left, queries) == std::vector<double>{8});
}

TEST_CASE("a source that cannot, few queries, and rays that are handed back all take no more bundles") {
  const auto searches = [](bool can, const std::vector<scene::Query>& queries) {
    const ByParity source{can};
    const Unbundled left(source, queries, SingleSearch::nearest, [](auto&&...) {});
    CHECK(places_left(left, queries).size() == queries.size());
    return source.searches;
  };
  std::vector<scene::Query> odd = queries_at(4000, 2);
  for (scene::Query& query : odd) query.rayo = ray(query.rayo.p().xyz() + glm::dvec3(1, 0, 0), {1, 1, 1});
  CHECK(searches(false, queries_at(100, 2)) == 0);
  CHECK(searches(true, queries_at(7, 2)) == 0);
  CHECK(searches(true, odd) < 10);
  // Answers that were found before stay, and all queries behind them are left.
  std::vector<scene::Query> some = queries_at(64, 2);
  some.insert(some.end(), odd.begin(), odd.end());
  const ByParity source;
  std::size_t answered = 0;
  const Unbundled left(source, some, SingleSearch::nearest, each_place([&](auto...) { ++answered; }));
  CHECK(answered == 64);
  CHECK(places_left(left, some).size() == odd.size());
  CHECK(source.searches < 15);
}
