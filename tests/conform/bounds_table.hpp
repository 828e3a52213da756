#pragma once
/// The worst |computed − exact|/bound of each quantity of each step and shape, and the case it was seen on.

#include <fmt/core.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "bounds_exact.hpp"
#include "durero/scene/attributes.hpp"

namespace durero::test {

/// A quantity of a step, such as "stable" "B".
struct Quantity {
  std::string_view step, name;
  auto operator<=>(const Quantity&) const = default;
};

/// The worst ratio, over generic rays and over all, and where the latter was seen.
struct Worst {
  double generic = 0, all = 0;
  Specimen where{};
};

using Ratios = std::vector<std::pair<Quantity, double>>;

/// By quantity, then by shape.
class Table {
 public:
  void add(const Specimen& specimen, bool generic, const Ratios& ratios) {
    for (const auto& [quantity, ratio] : ratios) {
      Worst& worst = rows_[quantity][specimen.element.index()];
      if (generic) worst.generic = std::max(worst.generic, ratio);
      // A ratio that is not a number is worse than all.
      if (!(ratio <= worst.all)) worst.all = ratio, worst.where = specimen;
    }
  }
  const std::map<Quantity, std::array<Worst, scene::shape_count>>& rows() const { return rows_; }

 private:
  std::map<Quantity, std::array<Worst, scene::shape_count>> rows_;
};

/// visit(x) for each number of what a table stores of an attribute.
template <class Stored, class Visit>
void for_each_coordinate(Stored& stored, Visit visit) {
  if constexpr (std::is_same_v<std::remove_const_t<Stored>, double>) {
    visit(stored);
  } else {
    for (int i = 0; i < 3; ++i) for_each_coordinate(stored[i], visit);
  }
}

/// visit(x) for each number of a case, in order: those of its element by the table of attributes, p and v.
template <class Case, class Visit>
void for_each_number(Case& specimen, Visit visit) {
  const auto take = [&](auto& stored) { for_each_coordinate(stored, visit); };
  std::visit(
      [&]<class Shape>(Shape& shape) {
        scene::for_each_attribute<std::remove_const_t<Shape>>(
            [&](const auto& attribute) { take(shape.*attribute.field); });
      },
      specimen.element);
  take(specimen.p);
  take(specimen.v);
}

/// A case in one line of words: its shape's, its numbers in hexadecimal, and whether the ray starts on the element.
inline std::string line_of(const Specimen& specimen) {
  std::string line(std::visit([]<class Shape>(const Shape&) { return Shape::word; }, specimen.element));
  for_each_number(specimen, [&](double x) { line += fmt::format(" {:a}", x); });
  return line + (specimen.on ? " on" : " off");
}

/// The case of such a line.
inline Specimen specimen_of(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  words >> word;
  Specimen specimen;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    if (Shape::word == word) specimen.element = Shape{};
  });
  for_each_number(specimen, [&](double& x) {
    words >> word;
    x = std::strtod(word.c_str(), nullptr);
  });
  words >> word;
  specimen.on = word == "on";
  return specimen;
}

}  // namespace durero::test
