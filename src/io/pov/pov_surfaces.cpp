#include "pov_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "durero/io/pov/algebraic.hpp"

namespace durero::io {
namespace {

/// The powers of x, y and z in a term.
using Powers = std::array<int, 3>;
/// The terms of a polynomial.
using Coefficients = std::map<Powers, double>;

/// The powers of all terms up to a degree, in POV-Ray's order: they fall by those of x, then of y, then of z.
std::vector<Powers> powers_up_to(int degree) {
  std::vector<Powers> all;
  for (int x = degree; x >= 0; --x)
    for (int y = degree - x; y >= 0; --y)
      for (int z = degree - x - y; z >= 0; --z) all.push_back({x, y, z});
  return all;
}

/// The least and the greatest degree of a poly.
constexpr int least_degree = 2, greatest_degree = 35;

/// Numbers between < and >, which stand for the terms of these powers.
void read_terms(PovWords& in, std::string_view word, const std::vector<Powers>& powers, Coefficients& into) {
  in.expect("<", fmt::format("in {}", word));
  for (const Powers& each : powers) {
    into[each] = in.number(fmt::format("a coefficient of {}", word));
    in.comma();
  }
  in.expect(">", fmt::format("behind the {} coefficients of {}", powers.size(), word));
}

Coefficients quadric(PovWords& in) {
  Coefficients terms;
  read_terms(in, "quadric", {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, terms);
  in.comma();
  read_terms(in, "quadric", {{1, 1, 0}, {1, 0, 1}, {0, 1, 1}}, terms);
  in.comma();
  read_terms(in, "quadric", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, terms);
  in.comma();
  terms[{0, 0, 0}] = in.number("the constant of quadric");
  return terms;
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
  return PovSurface{moved_torus, {{"mayor", major}, {"menor", minor}}};
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

/// The attributes that hold the 35 coefficients of degree four, in POV-Ray's order.
const std::vector<WrittenAttribute>& holders_of_coefficients() {
  constexpr WrittenKind number = WrittenKind::number, triple = WrittenKind::triple;
  static const std::vector<WrittenAttribute> all{{"xxxx", number}, {"xxx", triple}, {"xx_1", triple}, {"xx_2", triple},
                                                 {"x_1", triple},  {"x_2", triple}, {"x_3", triple},  {"x_4", number},
                                                 {"c_1", triple},  {"c_2", triple}, {"c_3", triple},  {"c_4", triple},
                                                 {"c_5", triple}};
  return all;
}

ValuesByWord quartic_values(const Coefficients& terms) {
  std::vector<double> numbers;
  for (const Powers& powers : powers_up_to(4)) {
    const auto term = terms.find(powers);
    numbers.push_back(term == terms.end() ? 0 : term->second);
  }
  ValuesByWord values;
  auto next = numbers.begin();
  for (const auto& [word, kind] : holders_of_coefficients()) {
    if (kind == WrittenKind::number)
      values[word] = *next++;
    else
      values[word] = glm::dvec3(next[0], next[1], next[2]), next += 3;
  }
  return values;
}

/// A type with a place of its own in space. A Z text has the components of a schema in the order of their names.
WrittenType placed_type(std::string word, std::vector<WrittenAttribute> own) {
  for (const char* const place : {"centro", "x", "y", "z"}) own.push_back({place, WrittenKind::triple});
  std::ranges::sort(own, {}, &WrittenAttribute::word);
  return {std::move(word), std::move(own)};
}

}  // namespace

std::span<const WrittenType> algebraic_types() {
  static const std::array<WrittenType, 2> types{
      placed_type("toro_oblicuo", {{"mayor", WrittenKind::number}, {"menor", WrittenKind::number}}),
      placed_type("cuartica", holders_of_coefficients())};
  return types;
}

std::optional<PovSurface> read_pov_surface(PovWords& in, std::string_view word) {
  if (word == "torus") return torus(in);
  Coefficients terms;
  int degree = 2;
  if (word == "quadric") {
    terms = quadric(in);
  } else {
    degree = word == "cubic" ? 3 : word == "quartic" ? 4 : degree_of_poly(in);
    read_terms(in, word, powers_up_to(degree), terms);
  }
  if (degree > 4) return std::nullopt;
  return PovSurface{quartic, quartic_values(terms)};
}

std::vector<WrittenValue> placed_surface(const PovSurface& surface, const PovTransform& by) {
  ValuesByWord values = surface.own;
  values["centro"] = by.shift;
  values["x"] = by.linear[0], values["y"] = by.linear[1], values["z"] = by.linear[2];
  std::vector<WrittenValue> attributes;
  for (const WrittenAttribute& attribute : algebraic_types()[surface.type].attributes)
    attributes.push_back(values.at(attribute.word));
  return attributes;
}

}  // namespace durero::io
