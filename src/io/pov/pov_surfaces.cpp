#include "pov_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "durero/io/pov/algebraic.hpp"

namespace durero::io {
namespace {

/// The least and the greatest degree of a poly.
constexpr int least_degree = 2, greatest_degree = 35;

/// Numbers between < and >, which stand for the terms of these powers.
void read_terms(PovWords& in, std::string_view word, const std::vector<PovPowers>& powers, PovPolynomial& into) {
  in.expect("<", fmt::format("in {}", word));
  for (const PovPowers& each : powers) {
    into.add(each, number::exact(in.number(fmt::format("a coefficient of {}", word))));
    in.comma();
  }
  in.expect(">", fmt::format("behind the {} coefficients of {}", powers.size(), word));
}

PovPolynomial quadric(PovWords& in) {
  PovPolynomial terms;
  read_terms(in, "quadric", {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, terms);
  in.comma();
  read_terms(in, "quadric", {{1, 1, 0}, {1, 0, 1}, {0, 1, 1}}, terms);
  in.comma();
  read_terms(in, "quadric", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, terms);
  in.comma();
  terms.add({0, 0, 0}, number::exact(in.number("the constant of quadric")));
  return terms;
}

/// (x² + y² + z² + R² − r²)² − 4·R²·(x² + z²).
PovPolynomial polynomial_of_torus(double major, double minor) {
  const PovPolynomial x = PovPolynomial::coordinate(0), y = PovPolynomial::coordinate(1),
                      z = PovPolynomial::coordinate(2), outer = power(major, 2);
  return power(x * x + y * y + z * z + outer - power(minor, 2), 2) - PovPolynomial(4.0) * outer * (x * x + z * z);
}

/// A torus, whose tube may be wider than its circle: a word then tells which parts there are. By `union` and
/// `difference` these are all.
std::optional<PovSurface> torus(PovWords& in) {
  const double major = in.number("the radius of torus");
  in.comma();
  const double minor = in.number("the radius of the tube of torus");
  const bool is_part = in.at("merge") || in.at("intersection");
  if (is_part || in.at("union") || in.at("difference")) in.pass();
  if (is_part && std::abs(minor) > std::abs(major)) return std::nullopt;
  return PovSurface{polynomial_of_torus(major, minor), PovTorus{major, minor}};
}

int degree_of_poly(PovWords& in) {
  const std::size_t at = in.offset();
  const double degree = in.number("the degree of poly");
  in.comma();
  if (!(degree >= least_degree && degree <= greatest_degree) || degree != static_cast<int>(degree))
    in.fail(at, fmt::format("a poly of degree {}", degree),
            fmt::format("expected a whole number from {} to {}", least_degree, greatest_degree));
  return static_cast<int>(degree);
}

}  // namespace

std::optional<PovSurface> read_pov_surface(PovWords& in, std::string_view word) {
  if (word == "torus") return torus(in);
  PovPolynomial terms;
  int degree = 2;
  if (word == "quadric") {
    terms = quadric(in);
  } else {
    degree = word == "cubic" ? 3 : word == "quartic" ? 4 : degree_of_poly(in);
    read_terms(in, word, pov_powers_up_to(degree), terms);
  }
  if (degree > 4) return std::nullopt;
  return PovSurface{std::move(terms)};
}

std::size_t type_of(const PovSurface& surface) { return surface.torus ? moved_torus : quartic; }

std::optional<std::vector<WrittenValue>> placed_surface(const PovSurface& surface, const PovTransform& by) {
  PovAttributes attributes;
  attributes.set_place(by);
  if (surface.torus) {
    attributes.set_number("mayor", number::exact(surface.torus->major));
    attributes.set_number("menor", number::exact(surface.torus->minor));
  } else {
    attributes.set_quartic(surface.polynomial);
  }
  return attributes.of_type(type_of(surface));
}

}  // namespace durero::io
