#include "durero/conform/families/families.hpp"

#include <algorithm>

#include "conform/families/family_table.hpp"
#include "durero/surface/exact.hpp"

namespace durero::conform {

std::span<const Family> families() {
  static const std::vector<Family> published = [] {
    std::vector<Family> all;
    for (const FamilyRow& row : family_table()) all.push_back(row.family);
    return all;
  }();
  return published;
}

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
  const AnsweredQuery answered{the_case.scene, ray, surface::exact::first_hit(the_case.scene, ray.rayo, ray.en)};
  return {questions.is_member(answered), questions.is_exact(answered)};
}

Count& Count::operator+=(const Count& other) {
  rays += other.rays;
  members += other.members;
  exact += other.exact;
  return *this;
}

Count count(const Family& family, const Case& the_case) {
  Count counted{.rays = the_case.rays.size()};
  for (const scene::Query& ray : the_case.rays) {
    const Membership is = membership(family, the_case, ray);
    counted.members += is.member;
    counted.exact += is.member && is.exact;
  }
  return counted;
}

}  // namespace durero::conform
