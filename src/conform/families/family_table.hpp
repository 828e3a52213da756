#pragma once
/// The table of the families has one row for each: its published description and its recipe.

#include <optional>
#include <span>
#include <variant>

#include "conform/families/members.hpp"
#include "conform/families/recipes.hpp"
#include "conform/families/recipes_body.hpp"
#include "conform/families/recipes_mesh.hpp"
#include "durero/conform/families/families.hpp"

namespace durero::conform {

/// The least shares of a family's rays that are members, and exact ones; both hold for each seed of 20 scenes of 100
/// rays.
struct Floors {
  double members, exact;
};

/// The functions that make a scene, and then each ray for it.
struct Recipe {
  recipes::FramedShapes (*scene)(Draws&, int parameter);
  DrawnRay (*ray)(Draws&, int parameter, recipes::ShapeSpan shapes);
};

/// The functions that make a mesh of about so many faces, and then each ray for it.
struct MeshRecipe {
  DrawnMesh (*mesh)(Draws&, int parameter, std::size_t faces);
  DrawnRay (*ray)(Draws&, int parameter, const DrawnMesh& mesh);
  bool is_grid = false;  ///< whether it makes a grid, where grids are asked for
};

/// The functions that make the bodies of a scene, and then each ray for them.
struct BodyRecipe {
  std::vector<AskedBody> (*scene)(Draws&, int parameter);
  DrawnRay (*ray)(Draws&, int parameter, recipes::BodySpan bodies);
};

/// The conditions that make a ray a member, and an exact one.
struct Questions {
  bool (*is_member)(const AnsweredQuery&);
  bool (*is_exact)(const AnsweredQuery&);
};

struct IntegerRange {
  int least, greatest;
};

/// The exceptions for binary32 numbers: a parameter that fits the format, and other floors.
struct OfBinary32 {
  std::optional<IntegerRange> parameter{};
  std::optional<Floors> floors{};
};

struct FamilyRow {
  Family family;
  Floors floors;
  std::variant<Recipe, MeshRecipe, BodyRecipe> recipe;
  Questions questions;
  OfBinary32 of_binary32{};

  bool is_of_meshes() const { return std::holds_alternative<MeshRecipe>(recipe); }
  bool is_of_bodies() const { return std::holds_alternative<BodyRecipe>(recipe); }
};

/// Every family, in the order in which they are published: those of meshes, and then those of bodies,
/// are the last.
std::span<const FamilyRow> family_table();

/// The row of a family. Throws std::invalid_argument where the family is none of families().
const FamilyRow& row_of(const Family& family);

}  // namespace durero::conform
