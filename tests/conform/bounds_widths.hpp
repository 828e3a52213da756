#pragma once
/// How wide a bound may be beside the errors that were seen, and which are wider, each with its reason.

#include <algorithm>
#include <span>

#include "bounds_table.hpp"
#include "conform/families/framed_shape.hpp"
#include "support/catch.hpp"

namespace durero::test {

/// A bound of which errors on generic rays take less than 1/64 is too wide, unless the reason is said beside it.
inline constexpr double widest = 1.0 / 64;

/// The bounds that are wider with a reason, by step and quantities.
struct Exceptions {
  std::string_view step, reason;
  std::vector<std::string_view> quantities;

  bool hold(const Quantity& quantity) const {
    return step == quantity.step && std::find(quantities.begin(), quantities.end(), quantity.name) != quantities.end();
  }
};
inline constexpr std::string_view worst_case =
    "quadratic-inl.hpp: roundings that all go one way, lengths by sums of components; for the sphere proved as it is";
inline constexpr std::string_view made_of =
    "closed_form-inl.hpp: made of the bounds of the coefficients, tight for operands that err by all of those";
inline constexpr std::string_view double_double =
    "quadratic-inl.hpp: as in binary64, and operations taken to err by 16u²";
inline constexpr std::string_view improvement = "power-inl.hpp: good to some forty bits beyond a binary64 as it is";
inline constexpr std::string_view of_parameter =
    "rounding-inl.hpp: mostly that of t, good to forty bits beyond a binary64";
inline const Exceptions exceptions[] = {
    {"triage", worst_case, {"F", "H"}},
    {"triage", made_of, {"D", "S", "q", "root", "t", "slope"}},
    {"lanes", made_of, {"t", "slope"}},
    {"search", made_of, {"ends, triage"}},
    {"stable", double_double, {"A", "B", "C", "F", "H", "D", "S", "q", "root", "t", "avance", "altura − avance"}},
    {"improved", improvement, {"potencia", "t"}},
    {"improved", of_parameter, {"point"}},
    {"stable", of_parameter, {"point"}},
};
/// Of flat shapes, whose coefficients are single products.
inline const Exceptions exceptions_of_flat[] = {
    {"triage", worst_case, {"margin"}},
    {"stable", double_double, {"B", "C", "root", "t", "margin"}},
    {"improved", improvement, {"potencia", "t"}},
    {"improved", of_parameter, {"point"}},
};

/// The worst of the flat shapes, or of the others.
inline Worst worst_of(std::span<const Worst> by_shape, bool flat) {
  Worst worst;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    const Worst& of_shape = by_shape[scene::place_of<Shape>];
    if (conform::is_flat(Shape::tipo) != flat) return;
    worst.generic = std::max(worst.generic, of_shape.generic);
    worst.all = std::max(worst.all, of_shape.all);
  });
  return worst;
}

/// Every row of the table is within the width or an exception, and no exception is left over. What is rounded is right
/// or wrong, and has no width; nor has what these shapes do not have, or have exactly.
inline void check_widths(const Table& table, bool flat, std::span<const Exceptions> listed) {
  std::size_t excepted = 0;
  for (const auto& [quantity, by_shape] : table.rows()) {
    const Worst worst = worst_of(by_shape, flat);
    if (quantity.name == "rounded" || worst.all == 0) continue;
    const bool is_exception =
        std::any_of(listed.begin(), listed.end(), [&](const Exceptions& some) { return some.hold(quantity); });
    INFO(quantity.step << ' ' << quantity.name << ": on generic rays errors take " << worst.generic << " of the bound");
    CHECK(is_exception == (worst.generic < widest));
    excepted += is_exception;
  }
  std::size_t expected = 0;
  for (const Exceptions& some : listed) expected += some.quantities.size();
  CHECK(excepted == expected);
}

}  // namespace durero::test
