// The first hit of one ray as the numbers x + y√Δ that it is.
#include "durero/surface/exact.hpp"

#include <gmp.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <stdexcept>

#include "bindings.hpp"
#include "durero/number/surd.hpp"
#include "rays.hpp"
#include "state.hpp"

namespace durero::python {
namespace {

using number::Rational;
using number::Surd;

/// Whole numbers travel as hexadecimal, of which Python reads any length.
std::string hexadecimal(const mpz_t whole) {
  std::string digits(mpz_sizeinbase(whole, 16) + 2, '\0');
  mpz_get_str(digits.data(), 16, whole);
  digits.resize(digits.find('\0'));
  return digits;
}

py::tuple fraction(const Rational& value) {
  const auto& q = value.backend().data();
  return py::make_tuple(hexadecimal(mpq_numref(q)), hexadecimal(mpq_denref(q)));
}

py::tuple surd(const Surd& value) {
  return py::make_tuple(fraction(value.x), fraction(value.y), fraction(value.delta));
}

using Hexadecimal = std::pair<std::string, std::string>;

Rational rational(const Hexadecimal& hexadecimal) {
  Rational value;
  auto& q = value.backend().data();
  if (mpz_set_str(mpq_numref(q), hexadecimal.first.c_str(), 16) != 0 ||
      mpz_set_str(mpq_denref(q), hexadecimal.second.c_str(), 16) != 0 || mpz_sgn(mpq_denref(q)) == 0)
    throw std::invalid_argument("no number; expected hexadecimal");
  mpq_canonicalize(q);
  return value;
}

double rounded(const Hexadecimal& x, const Hexadecimal& y, const Hexadecimal& delta) {
  return number::round_to_binary64(Surd(rational(x), rational(y), rational(delta)));
}

scene::ElementSet elements(const scene::Scene& scene, const std::vector<std::string>& names) {
  scene::ElementSet elements;
  for (const std::string& name : names) {
    const auto element = scene.find(name);
    if (!element) throw py::key_error(name);
    elements.push_back(*element);
  }
  std::ranges::sort(elements);
  const auto repeated = std::ranges::unique(elements);
  elements.erase(repeated.begin(), repeated.end());
  return elements;
}

/// (outcome, names, t, point), the last two for a hit alone: the nearest of all crossings.
py::tuple first_hit(const Scene& scene, const py::object& ray, const std::vector<std::string>& en) {
  const auto state = scene.state();
  require_own_shapes(*state, "exact");
  const model::Rayo rayo = single_ray(Rays(ray));
  const scene::ElementSet origin = elements(state->scene(), en);
  scene::Hit hit;
  std::vector<surface::exact::Crossing> crossings;
  {
    const py::gil_scoped_release released;
    hit = surface::exact::first_hit(state->scene(), rayo, origin);
    if (hit.resultado == model::Resultado::hit) crossings = surface::exact::all_hits(state->scene(), rayo, origin);
  }
  std::vector<std::string> names;
  for (const scene::ElementRef element : hit.elementos) names.push_back(state->scene().name(element).name());
  std::ranges::sort(names);
  const auto outcome = static_cast<int>(hit.resultado);
  if (crossings.empty()) return py::make_tuple(outcome, names, py::none(), py::none());
  const Surd t(crossings.front().segment.begin.value());
  const glm::dvec3 p = rayo.p().xyz(), v = rayo.v().xyz();
  const auto coordinate = [&](int i) { return surd(Surd(p[i]) + Surd(v[i]) * t); };
  return py::make_tuple(outcome, names, surd(t), py::make_tuple(coordinate(0), coordinate(1), coordinate(2)));
}

}  // namespace

void add_exact(py::module_& module) {
  module.def("exact_first_hit", first_hit);
  module.def("rounded", rounded);
}

}  // namespace durero::python
