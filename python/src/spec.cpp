// The Z text: an expression evaluated, and texts checked.
#include <pybind11/stl.h>

#include <mutex>
#include <utility>

#include "bindings.hpp"
#include "durero/scene/retrieve.hpp"
#include "durero/spec/calculator.hpp"
#include "durero/zed/review/review.hpp"
#include "errors.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

using spec::Calculator;

/// What is evaluated keeps what it has worked out, so one thread evaluates at a time.
std::mutex evaluating;

Calculator::Result evaluated(const scene::Scene* scene, const std::string& typed) {
  const py::gil_scoped_release released;
  const std::scoped_lock lock(evaluating);
  return (scene == nullptr ? Calculator() : Calculator(scene::retrieve(*scene))).evaluate(typed);
}

/// (its text, whether there is a value or the predicate holds)
std::pair<std::string, bool> evaluate(const std::string& typed, const Scene* scene) {
  const auto state = scene == nullptr ? nullptr : scene->state();
  if (state) require_own_shapes(*state, "eval");
  try {
    const Calculator::Result result = evaluated(state ? &state->scene() : nullptr, typed);
    return {result.text, result.yes};
  } catch (const zed::ZError& error) {
    raise_input_error("EXPR", error.place.line, error.place.column, error.what());
  } catch (const zed::EvaluationError& error) {
    raise("Undecided", std::string(error.what()));
  }
}

/// The defects of these texts, by their names; of the program's own text where there are none.
py::list check(const std::vector<std::pair<std::string, std::string>>& sources) {
  std::vector<zed::Defect> defects;
  {
    const py::gil_scoped_release released;
    const std::scoped_lock lock(evaluating);
    defects = zed::review(sources.empty() ? spec::text() : zed::read_sources(sources));
  }
  py::list all;
  for (const zed::Defect& defect : defects)
    all.append(py::make_tuple(defect.file, defect.place.line, defect.place.column, defect.what, defect.expected,
                              defect.severity == zed::Defect::Severity::warning));
  return all;
}

}  // namespace

void add_spec(py::module_& module) {
  module.def("evaluate", evaluate);
  module.def("check", check);
}

}  // namespace durero::python
