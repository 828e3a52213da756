#pragma once
/// An engine that answers the rays of a scene by another engine, which has the scene in another unit of length
/// (unit.hpp).

#include <algorithm>
#include <boost/container/vector.hpp>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "durero/engine/engine.hpp"
#include "durero/trace/analytic.hpp"
#include "unit.hpp"

namespace durero::engine {

/// Answers by Inner, an engine that is made of a scene. The search without tables answers rays that are not exact in
/// the unit.
template <class Inner>
class Rescaled final : public Engine {
 public:
  Rescaled(const scene::Scene& scene, int unit)
      : scene_(scene), unit_(unit), scaled_(in_unit(scene, unit)), inner_(scaled_) {}

  void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const override {
    for_each_in_unit(
        queries, [&](std::span<const scene::Query> asked) { return engine::first_hits(inner_, asked); },
        [&](std::size_t i, scene::Hit hit, int of_parameter) {
          hits[i] = out_of_unit(scene_, queries[i], std::move(hit), unit_, of_parameter);
        },
        [&](std::size_t i) { hits[i] = trace::first_hit(scene_, queries[i].rayo, queries[i].en); });
  }
  void first_elements(std::span<const scene::Query> queries, std::span<trace::FirstElement> elements) const override {
    for_each_in_unit(
        queries,
        [&](std::span<const scene::Query> asked) {
          std::vector<trace::FirstElement> answers(asked.size());
          inner_.first_elements(asked, answers);
          return answers;
        },
        [&](std::size_t i, const trace::FirstElement& element, int) { elements[i] = element; },
        [&](std::size_t i) {
          elements[i] = trace::first_element(trace::first_hit(scene_, queries[i].rayo, queries[i].en));
        });
  }
  void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const override {
    for (std::size_t begin = 0; begin < queries.size(); begin += at_a_time) {
      const auto some = queries.subspan(begin, std::min(at_a_time, queries.size() - begin));
      std::vector<scene::Query> asked;
      std::vector<std::size_t> numbers;
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (auto rayo = segment_in_unit(some[i].rayo, unit_)) {
          asked.push_back({*std::move(rayo), some[i].en}), numbers.push_back(begin + i);
        } else {
          occluded[begin + i] = trace::occluded_segment(scene_, some[i].rayo, some[i].en);
        }
      }
      boost::container::vector<bool> answers(asked.size());
      inner_.occluded_segments(asked, {answers.data(), answers.size()});
      for (std::size_t i = 0; i < asked.size(); ++i) occluded[numbers[i]] = answers[i];
    }
  }

  std::optional<std::vector<surface::exact::ElementPoint>> points_between(
      const scene::Scene&, const scene::Query& query, surface::exact::RayStretch stretch,
      const surface::exact::Passes& passes) const override {
    const auto rayo = ray_in_unit(query.rayo, stretch);
    if (!rayo) return surface::exact::points_between(scene_, query.rayo, query.en, stretch, passes);
    const auto found = inner_.points_between(scaled_, {*rayo, query.en}, stretch, passes);
    if (!found) return std::nullopt;
    scene::ElementSet elements;
    for (const surface::exact::ElementPoint& each : *found)
      if (elements.empty() || elements.back() != each.element) elements.push_back(each.element);
    return surface::exact::points_of(scene_, std::move(elements), query.rayo, query.en, stretch);
  }

 private:
  static constexpr std::size_t at_a_time = 1 << 16;  // queries that are copied into the unit together

  std::optional<model::Rayo> ray_in_unit(const model::Rayo& rayo, surface::exact::RayStretch stretch) const {
    if (stretch == surface::exact::RayStretch::segment) return segment_in_unit(rayo, unit_);
    const auto ray = in_unit(rayo, unit_);
    return ray ? std::optional(ray->rayo) : std::nullopt;
  }

  /// Calls take(number, answer, of_parameter) for the answers of ask(queries), and alone(number) for rays that are not
  /// exact in the unit.
  template <class Ask, class Visitor, class Fallback>
  void for_each_in_unit(std::span<const scene::Query> queries, Ask ask, Visitor take, Fallback alone) const {
    for (std::size_t begin = 0; begin < queries.size(); begin += at_a_time) {
      const auto some = queries.subspan(begin, std::min(at_a_time, queries.size() - begin));
      std::vector<scene::Query> asked;
      std::vector<std::pair<std::size_t, int>> numbers;
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (auto ray = in_unit(some[i].rayo, unit_)) {
          asked.push_back({ray->rayo, some[i].en}), numbers.emplace_back(begin + i, ray->of_parameter);
        } else {
          alone(begin + i);
        }
      }
      auto answers = ask(std::span<const scene::Query>(asked));
      for (std::size_t i = 0; i < asked.size(); ++i) take(numbers[i].first, std::move(answers[i]), numbers[i].second);
    }
  }

  const scene::Scene& scene_;
  int unit_;
  scene::Scene scaled_;
  Inner inner_;
};

}  // namespace durero::engine
