// The first hits of many rays, and what stands in their way.
#include <fmt/format.h>

#include <boost/container/vector.hpp>
#include <limits>
#include <stdexcept>

#include "bindings.hpp"
#include "blocks.hpp"
#include "durero/contract/contract.hpp"
#include "rays.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

/// A row of the array that answers. `element` is the first by name, `tied` says that there are more.
struct HitRow {
  std::uint8_t outcome;
  bool tied;
  std::int32_t element;
  double t;
  double point[3];
};

/// Rays of a scene, asked of one engine: the state is held, whatever becomes of the scene meanwhile.
class Question {
 public:
  Question(const Scene& scene, const py::object& rays, const std::string& engine, const py::object& en,
           const std::string& hierarchy)
      : state_(scene.state()),
        row_(engine_named(*state_, engine)),
        numbering_(state_->numbering()),
        rays_(rays),
        origins_(en, rays_.size(), numbering_.size()) {
    if (!origins_.empty() && !row_.honours_origins)
      throw std::invalid_argument(
          fmt::format("engine {}: it knows nothing of the elements that a ray starts on; expected no en", engine));
    const py::gil_scoped_release released;
    engine_ = &state_->prepared(row_, hierarchy);
  }

  std::size_t size() const { return rays_.size(); }
  const engine::Engine& engine() const { return *engine_; }
  const Numbering& numbering() const { return numbering_; }

  std::vector<scene::Query> queries(std::size_t begin, std::size_t end) const {
    std::vector<scene::Query> queries;
    queries.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) queries.push_back({rays_[i], origins_.of(i, numbering_)});
    return queries;
  }

  /// answer(i, hit) of every ray, in any order.
  template <class Answer>
  void for_each_hit(Answer answer) const {
    for_each_block(size(), [&](std::size_t begin, std::size_t end) {
      const std::vector<scene::Hit> hits = engine::first_hits(engine(), queries(begin, end));
      for (std::size_t i = begin; i < end; ++i) answer(i, hits[i - begin]);
    });
  }

 private:
  std::shared_ptr<const State> state_;
  const engine::EngineRow& row_;
  const Numbering& numbering_;
  Rays rays_;
  Origins origins_;
  const engine::Engine* engine_;
};

std::vector<std::int32_t> numbers(const scene::ElementSet& elements, const Numbering& numbering) {
  std::vector<std::int32_t> numbers;
  for (const scene::ElementRef element : elements) numbers.push_back(numbering.number(element));
  std::ranges::sort(numbers);
  return numbers;
}

/// Without a hit t and point are no numbers, as in files.
HitRow row_of(const scene::Hit& hit, const Numbering& numbering) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::size_t count = hit.elementos.size();
  std::int32_t first = -1;
  if (count == 1) first = numbering.number(hit.elementos[0]);
  if (count > 1) first = numbers(hit.elementos, numbering).front();
  HitRow row{static_cast<std::uint8_t>(hit.resultado), count > 1, first, none, {none, none, none}};
  if (hit.resultado == model::Resultado::hit) {
    row.t = hit.t;
    for (int i = 0; i < 3; ++i) row.point[i] = hit.punto[i];
  }
  return row;
}

py::array_t<HitRow> first_hits(const Scene& scene, const py::object& rays, const std::string& engine,
                               const py::object& en, const std::string& hierarchy) {
  const Question question(scene, rays, engine, en, hierarchy);
  py::array_t<HitRow> answers(static_cast<py::ssize_t>(question.size()));
  HitRow* const rows = answers.mutable_data();
  question.for_each_hit([&](std::size_t i, const scene::Hit& hit) { rows[i] = row_of(hit, question.numbering()); });
  return answers;
}

/// The same, and every element of each: ray i has those from offsets[i] to offsets[i + 1].
py::tuple first_hits_with_elements(const Scene& scene, const py::object& rays, const std::string& engine,
                                   const py::object& en, const std::string& hierarchy) {
  const Question question(scene, rays, engine, en, hierarchy);
  const std::size_t size = question.size();
  py::array_t<HitRow> answers(static_cast<py::ssize_t>(size));
  py::array_t<std::int64_t> offsets(static_cast<py::ssize_t>(size + 1));
  HitRow* const rows = answers.mutable_data();
  std::int64_t* const ends = offsets.mutable_data() + 1;
  std::vector<std::vector<std::int32_t>> of_blocks((size + rays_of_a_block - 1) / rays_of_a_block);
  question.for_each_hit([&](std::size_t i, const scene::Hit& hit) {
    rows[i] = row_of(hit, question.numbering());
    const std::vector<std::int32_t> all = numbers(hit.elementos, question.numbering());
    auto& of_block = of_blocks[i / rays_of_a_block];  // one task has it, and its rays come in order
    of_block.insert(of_block.end(), all.begin(), all.end());
    ends[i] = static_cast<std::int64_t>(all.size());
  });
  ends[-1] = 0;
  for (std::size_t i = 0; i < size; ++i) ends[i] += i == 0 ? 0 : ends[i - 1];
  py::array_t<std::int32_t> elements(size == 0 ? 0 : static_cast<py::ssize_t>(ends[size - 1]));
  std::int32_t* next = elements.mutable_data();
  for (const auto& of_block : of_blocks) next = std::copy(of_block.begin(), of_block.end(), next);
  return py::make_tuple(answers, offsets, elements);
}

/// alcances ≠ ∅: a first hit, or points without a nearest.
py::array_t<bool> occluded(const Scene& scene, const py::object& rays, const std::string& engine, const py::object& en,
                           const std::string& hierarchy) {
  const Question question(scene, rays, engine, en, hierarchy);
  py::array_t<bool> answers(static_cast<py::ssize_t>(question.size()));
  bool* const occluded = answers.mutable_data();
  question.for_each_hit(
      [&](std::size_t i, const scene::Hit& hit) { occluded[i] = hit.resultado != model::Resultado::miss; });
  return answers;
}

py::array_t<bool> occluded_segment(const Scene& scene, const py::object& rays, const std::string& engine,
                                   const py::object& en, const std::string& hierarchy) {
  const Question question(scene, rays, engine, en, hierarchy);
  py::array_t<bool> answers(static_cast<py::ssize_t>(question.size()));
  bool* const occluded = answers.mutable_data();
  for_each_block(question.size(), [&](std::size_t begin, std::size_t end) {
    question.engine().occluded_segments(question.queries(begin, end), {occluded + begin, end - begin});
  });
  return answers;
}

py::tuple engines() {
  py::list rows;
  for (const engine::EngineRow& row : engine::engines())
    rows.append(py::make_tuple(std::string(row.name), std::string(row.what), row.exact_bytes, row.honours_origins));
  return rows;
}

}  // namespace

void add_trace(py::module_& module) {
  PYBIND11_NUMPY_DTYPE(HitRow, outcome, tied, element, t, point);
  module.attr("hit_dtype") = py::dtype::of<HitRow>();
  module.attr("default_engine") = std::string(engine::default_engine);
  module.def("engines", engines);
  module.def("first_hits", first_hits);
  module.def("first_hits_with_elements", first_hits_with_elements);
  module.def("occluded", occluded);
  module.def("occluded_segment", occluded_segment);
}

}  // namespace durero::python
