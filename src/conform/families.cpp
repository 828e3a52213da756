#include "durero/conform/families.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "conform/family_table.hpp"
#include "durero/surface/exact.hpp"

namespace durero::conform {
namespace {

/// A stream of its own for each family and seed.
std::uint64_t seed_of(const Family& family, std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : family.name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash ^ (seed * 0x9e3779b97f4a7c15);
}

bool is_ray(const DrawnRay& ray) {
  const auto finite = [](const glm::dvec3& x) {
    return std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
  };
  return finite(ray.p) && finite(ray.v) && ray.v != glm::dvec3(0);
}

std::string name_of(std::size_t place) { return "e" + std::to_string(place); }

scene::Query query_of(const scene::Scene& scene, const DrawnRay& ray) {
  scene::Query query{{model::Punto(ray.p), model::Vector(ray.v)}, {}};
  for (const std::size_t place : ray.on) query.en.push_back(*scene.find(name_of(place)));
  std::sort(query.en.begin(), query.en.end());
  return query;
}

}  // namespace

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

Case generate(const Family& family, std::uint64_t seed, std::size_t rays) {
  const Recipe& recipe = row_of(family).recipe;
  Random random(seed_of(family, seed));
  const int parameter = random.integer(family.parameter.least, family.parameter.greatest);
  const std::vector<FramedShape> shapes = recipe.scene(random, parameter);
  Case the_case;
  for (std::size_t i = 0; i < shapes.size(); ++i) the_case.scene.apply(shapes[i].addition(model::Elemento(name_of(i))));
  while (the_case.rays.size() < rays) {
    const DrawnRay ray = recipe.ray(random, parameter, shapes);
    if (is_ray(ray)) the_case.rays.push_back(query_of(the_case.scene, ray));
  }
  return the_case;
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
