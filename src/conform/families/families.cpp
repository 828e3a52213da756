#include "durero/conform/families/families.hpp"

#include <algorithm>

#include "conform/families/family_table.hpp"
#include "conform/judge/scene_tree.hpp"
#include "durero/conform/judge/truth.hpp"

namespace durero::conform {

std::span<const Family> families() {
  static const std::vector<Family> published = [] {
    std::vector<Family> all;
    for (const FamilyRow& row : family_table()) all.push_back(row.family);
    return all;
  }();
  return published;
}

namespace {

/// The number of families with a recipe of that kind.
template <class OfRecipe>
std::size_t count_of() {
  return static_cast<std::size_t>(std::ranges::count_if(
      family_table(), [](const FamilyRow& row) { return std::holds_alternative<OfRecipe>(row.recipe); }));
}

}  // namespace

const Family& ordinary_family() { return families().front(); }
std::span<const Family> families_of_few() { return families().first(count_of<Recipe>()); }
std::span<const Family> families_of_meshes() { return families().subspan(count_of<Recipe>(), count_of<MeshRecipe>()); }
std::span<const Family> families_of_bodies() { return families().last(count_of<BodyRecipe>()); }
bool is_of_meshes(const Family& family) { return row_of(family).is_of_meshes(); }
bool is_of_bodies(const Family& family) { return row_of(family).is_of_bodies(); }

const Family* find_family(std::string_view name) {
  const std::span<const Family> all = families();
  const auto family = std::find_if(all.begin(), all.end(), [&](const Family& f) { return f.name == name; });
  return family == all.end() ? nullptr : &*family;
}

Range parameter(const Family& family, NumberFormat numbers) {
  const std::optional<IntegerRange>& narrower = row_of(family).of_binary32.parameter;
  if (numbers == NumberFormat::binary64 || !narrower) return family.parameter;
  return {family.parameter.name, narrower->least, narrower->greatest};
}

Membership membership(const Family& family, const Case& the_case, const scene::Query& ray) {
  const Questions& questions = row_of(family).questions;
  const SceneTree tree(the_case.scene, 1);
  const AnsweredQuery answered{the_case.scene, ray, truth(the_case.scene, ray).hit, &tree};
  return {questions.is_member(answered), questions.is_exact(answered)};
}

Count& Count::operator+=(const Count& other) {
  rays += other.rays;
  members += other.members;
  exact += other.exact;
  return *this;
}

Count count(const Family& family, const Case& the_case, std::span<const NamedBody> bodies) {
  const Questions& questions = row_of(family).questions;
  const SceneTruths truths(the_case.scene, the_case.rays.size(), bodies);
  std::optional<SceneTree> tree;
  if (the_case.scene.has_bodies()) tree.emplace(the_case.scene, the_case.rays.size(), bodies);
  Count counted{.rays = the_case.rays.size()};
  for (const scene::Query& ray : the_case.rays) {
    const AnsweredQuery answered{the_case.scene, ray, truths.of(ray).hit, tree ? &*tree : nullptr};
    const bool is_member = questions.is_member(answered);
    counted.members += is_member;
    counted.exact += is_member && questions.is_exact(answered);
  }
  return counted;
}

}  // namespace durero::conform
