// Judges the hits of other programs, and draws the rays on which such programs go wrong.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <stdexcept>

#include "bindings.hpp"
#include "blocks.hpp"
#include "durero/conform/ask/system_file.hpp"
#include "durero/conform/families/suite.hpp"
#include "durero/conform/judge/judge.hpp"
#include "durero/conform/report/explanation.hpp"
#include "durero/text/shown.hpp"
#include "rays.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

using conform::Claim;
using conform::ClaimJudgement;
using conform::SuiteCase;

using Outcomes = py::array_t<std::uint8_t, py::array::c_style>;
template <class Value>
using Column = std::optional<py::array_t<Value, py::array::c_style>>;

/// What a system answered, a column each; a column that it does not give is absent.
struct Claims {
  Outcomes outcomes;              // a Resultado each
  Column<std::int64_t> elements;  // their numbers, −1 for none
  Column<double> t;
  Column<double> points;  // of shape (n, 3)

  Claim of(std::size_t i, const Numbering& numbering) const {
    const auto row = static_cast<py::ssize_t>(i);
    Claim claim;
    switch (static_cast<model::Resultado>(outcomes.at(row))) {
      case model::Resultado::hit:
        claim.outcome = Claim::Outcome::hit;
        if (elements && elements->at(row) >= 0)
          claim.element = numbering.element(static_cast<std::int32_t>(elements->at(row)));
        if (t) claim.t = t->at(row);
        if (points) claim.punto = glm::dvec3(points->at(row, 0), points->at(row, 1), points->at(row, 2));
        return claim;
      case model::Resultado::miss:
        claim.outcome = Claim::Outcome::miss;
        return claim;
      case model::Resultado::no_minimum:
        claim.why = "no point of the elements is the nearest";
        return claim;
    }
    throw std::invalid_argument(fmt::format("hits: the outcome of row {} is none; expected 0, 1 or 2", i));
  }
};

/// A case of no family: the scene with those rays, answered.
SuiteCase case_of(const scene::Scene& scene, const Rays& rays) {
  SuiteCase of{.family = &conform::families().front(), .the_case = {scene, {}}};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const scene::Query query{rays[i]};
    of.the_case.rays.push_back(query);
  }
  return of;
}

py::list judge(const Scene& scene, const py::object& given, const Claims& claims, const io::Source& profile_source) {
  const auto state = scene.state();
  require_own_shapes(*state, "judge");
  const conform::Profile profile = conform::read_profile(profile_source);
  const Rays rays(given);
  SuiteCase of = case_of(state->scene(), rays);
  const Numbering& numbering = state->numbering();
  std::vector<Claim> read;
  for (std::size_t i = 0; i < rays.size(); ++i) read.push_back(claims.of(i, numbering));
  of.truths.resize(rays.size());
  std::vector<ClaimJudgement> judgements(rays.size());
  const conform::SceneTruths truths(of.the_case.scene, rays.size());
  const conform::CaseJudge judge(of, profile);
  for_each_block(rays.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      of.truths[i] = truths.of(of.the_case.rays[i]);
      judgements[i] = judge.judge(i, read[i]);
    }
  });
  py::list all;
  for (const ClaimJudgement& judgement : judgements)
    all.append(py::make_tuple(
        std::string(name(judgement.verdict)), judgement.ulps, judgement.backward, judgement.clause,
        judgement.otherwise ? py::object(py::str(std::string(name(*judgement.otherwise)))) : py::none()));
  return all;
}

std::string explain(const Scene& scene, const py::object& ray) {
  const auto state = scene.state();
  require_own_shapes(*state, "explain");
  const Rays rays(ray);
  single_ray(rays);
  SuiteCase of = case_of(state->scene(), rays);
  const py::gil_scoped_release released;
  conform::answer(of);
  return conform::exact_answer(of, 0);
}

/// (its word, what it says, whether it is gross) of every verdict, in order.
py::list verdicts() {
  py::list all;
  for (int i = 0; i < conform::verdict_count; ++i) {
    const auto verdict = static_cast<conform::Verdict>(i);
    all.append(py::make_tuple(std::string(name(verdict)), std::string(meaning(verdict)), is_gross(verdict)));
  }
  return all;
}

py::list families() {
  py::list all;
  for (const conform::Family& family : conform::families())
    all.append(py::make_tuple(std::string(family.name), std::string(family.kind), std::string(family.reason)));
  return all;
}

py::array_t<double> rays_of(const SuiteCase& of) {
  py::array_t<double> rays({static_cast<py::ssize_t>(of.the_case.rays.size()), py::ssize_t{6}});
  double* next = rays.mutable_data();
  for (const scene::Query& query : of.the_case.rays) {
    const glm::dvec3 &p = query.rayo.p().xyz(), &v = query.rayo.v().xyz();
    for (const double x : {p.x, p.y, p.z, v.x, v.y, v.z}) *next++ = x;
  }
  return rays;
}

/// (name, scene, rays) of every case.
py::list suite(const std::string& family_name, std::size_t rays, std::uint64_t seed, bool binary32) {
  const conform::Family* family = conform::find_family(family_name);
  if (family == nullptr)
    throw std::invalid_argument(
        fmt::format("no family {}; expected one of durero.conform.families()", text::shown(family_name)));
  const conform::SuiteOptions options{
      .families = {family},
      .seed = seed,
      .rays = rays,
      .numbers = binary32 ? conform::NumberFormat::binary32 : conform::NumberFormat::binary64};
  py::list all;
  const std::size_t count = cases(options, *family);
  for (std::size_t number = 0; number < count; ++number) {
    const SuiteCase of = suite_case(options, *family, number);
    all.append(py::make_tuple(of.name(), Scene(scene::GroupedScene{of.the_case.scene}), rays_of(of)));
  }
  return all;
}

}  // namespace

void add_conform(py::module_& module) {
  module.def("judge", [](const Scene& scene, const py::object& rays, const Outcomes& outcomes,
                         const Column<std::int64_t>& elements, const Column<double>& t, const Column<double>& points,
                         const std::string& profile, const std::string& profile_name) {
    return judge(scene, rays, {outcomes, elements, t, points}, io::Source(profile_name, profile));
  });
  module.def("explain", explain);
  module.def("verdicts", verdicts);
  module.def("families", families);
  module.def("suite", suite);
}

}  // namespace durero::python
