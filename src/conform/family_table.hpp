#pragma once
/// The table of the families: one row is all that there is of a family, what is published of it and how it is made.

#include <optional>
#include <span>

#include "conform/members.hpp"
#include "conform/recipes.hpp"
#include "durero/conform/families.hpp"

namespace durero::conform {

/// The least parts of its rays that are members, and exact ones; both hold for each seed of 20 scenes of 100 rays.
struct Floors {
  double members, exact;
};

/// How a scene is made, and then each ray for it.
struct Recipe {
  recipes::FramedShapes (*scene)(Draws&, int parameter);
  DrawnRay (*ray)(Draws&, int parameter, recipes::Given shapes);
};

/// What makes a ray a member, and an exact one.
struct Questions {
  bool (*is_member)(const AnsweredQuery&);
  bool (*is_exact)(const AnsweredQuery&);
};

struct Limits {
  int least, greatest;
};

/// Where cases of binary32 numbers are others: a parameter that the format has room for, and floors.
struct OfBinary32 {
  std::optional<Limits> parameter{};
  std::optional<Floors> floors{};
};

struct FamilyRow {
  Family family;
  Floors floors;
  Recipe recipe;
  Questions questions;
  OfBinary32 of_binary32{};
};

/// Every family, in the order in which they are published.
std::span<const FamilyRow> family_table();

/// The row of a family. Throws std::invalid_argument where it is none of families().
const FamilyRow& row_of(const Family& family);

}  // namespace durero::conform
