#pragma once
/// Answers compared byte for byte, and what a failure prints so that it can be replayed.

#include <fmt/core.h>

#include <bit>
#include <cstdint>
#include <string>

#include "durero/conform/families/families.hpp"
#include "durero/scene/hit.hpp"

namespace durero::test {

/// Every byte, so that +0 and −0 differ.
inline bool identical(const scene::Hit& a, const scene::Hit& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return a.resultado == b.resultado && a.elementos == b.elementos && same(a.t, b.t) && same(a.punto.x, b.punto.x) &&
         same(a.punto.y, b.punto.y) && same(a.punto.z, b.punto.z);
}

inline std::string text(const scene::Hit& hit) {
  std::string said = fmt::format("{} t={:a} ({:a}, {:a}, {:a})", model::name(hit.resultado), hit.t, hit.punto.x,
                                 hit.punto.y, hit.punto.z);
  for (const scene::ElementRef e : hit.elementos) said += fmt::format(" {}#{}", model::name(e.tipo), e.index);
  return said;
}

inline std::string text(const scene::Query& ray) {
  const model::Punto& p = ray.rayo.p();
  const model::Vector& v = ray.rayo.v();
  std::string said = fmt::format("{:a} {:a} {:a} {:a} {:a} {:a}", p.x(), p.y(), p.z(), v.x(), v.y(), v.z());
  for (const scene::ElementRef e : ray.en) said += fmt::format(" @{}#{}", model::name(e.tipo), e.index);
  return said;
}

/// The place of a ray among the generated ones.
inline std::string replay(const conform::Family& family, std::uint64_t seed, std::size_t rays, std::size_t ray) {
  return fmt::format("replay: generate(*find_family(\"{}\"), {}, {}).rays[{}]", family.name, seed, rays, ray);
}

}  // namespace durero::test
