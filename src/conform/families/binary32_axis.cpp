#include "conform/families/binary32_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "durero/model/tipos.hpp"

// An axis d needs d·d = 1 up to 2⁻⁵⁰. The squares of binary32 numbers of 1/2 or more are multiples of 2⁻⁴⁸, and those
// of numbers from 2⁻ᵏ⁻¹ to 2⁻ᵏ of 2⁻⁴⁸⁻²ᵏ; few triples of such squares add up so nearly to 1.
//
// A small coordinate y leaves the choice of the two others free, for its grid is finer. Let the two leave the rest
// r = 1 − x² − z² ≤ 2⁻²⁶. The binary32 number y nearest to √r ≤ 2⁻¹³ is off by half a unit in the last place, 2⁻³⁸ at
// most, so y² is off r by 2·2⁻¹³·2⁻³⁸ = 2⁻⁵⁰ at most. For any x the greatest z with r ≥ 0 leaves r < 2·2⁻²⁴, evenly
// spread, so that of a few neighbours x one leaves 2⁻²⁶ or less. These axes lie within 2⁻¹³ of a coordinate plane.
//
// The axes that lie in a coordinate plane, and those far from all, were found by a search among all neighbours of a
// direction, and are listed. Every permutation of an axis, with any signs, is an axis.

namespace durero::conform {
namespace {

/// The listed axes between the coordinate planes, with no direction farther than 8 degrees from one; x ≥ y ≥ z.
constexpr std::array<std::array<double, 3>, 32> in_space{{
    {0x1.f278ap-1, 0x1.7e383ep-3, 0x1.0d829p-3},   {0x1.eb0d24p-1, 0x1.a029ap-3, 0x1.93bec2p-3},
    {0x1.e3a88p-1, 0x1.346bbcp-2, 0x1.0a784ep-3},  {0x1.e2c448p-1, 0x1.0eeb3p-2, 0x1.9e5cfcp-3},
    {0x1.d54a84p-1, 0x1.516a36p-2, 0x1.cfdb4ap-3}, {0x1.d0f91ep-1, 0x1.8694cap-2, 0x1.616598p-3},
    {0x1.cd385ep-1, 0x1.3ca5dcp-2, 0x1.381caap-2}, {0x1.c17568p-1, 0x1.97516p-2, 0x1.1128c2p-2},
    {0x1.bd20bep-1, 0x1.e6f0ecp-2, 0x1.130514p-3}, {0x1.bb878ap-1, 0x1.7c7ed6p-2, 0x1.55f1acp-2},
    {0x1.b5e118p-1, 0x1.e79aap-2, 0x1.a2e184p-3},  {0x1.af67eep-1, 0x1.bfed2cp-2, 0x1.41b436p-2},
    {0x1.a8dd7p-1, 0x1.f5cc32p-2, 0x1.116018p-2},  {0x1.a800d4p-1, 0x1.98071ep-2, 0x1.93b368p-2},
    {0x1.9fbcf4p-1, 0x1.22fbf4p-1, 0x1.104b82p-3}, {0x1.9a6c52p-1, 0x1.1d8836p-1, 0x1.b93d6cp-3},
    {0x1.982cdcp-1, 0x1.f0044ep-2, 0x1.70f02p-2},  {0x1.8fcf2cp-1, 0x1.126b38p-1, 0x1.4893f2p-2},
    {0x1.8669b4p-1, 0x1.d4950ep-2, 0x1.d4505p-2},  {0x1.852feap-1, 0x1.451088p-1, 0x1.1b22cep-3},
    {0x1.847dfap-1, 0x1.2b4a42p-1, 0x1.263bcap-2}, {0x1.7f21b8p-1, 0x1.432924p-1, 0x1.a204e4p-3},
    {0x1.792aacp-1, 0x1.17cc98p-1, 0x1.97ee0ep-2}, {0x1.786ea6p-1, 0x1.045672p-1, 0x1.cafc76p-2},
    {0x1.6debp-1, 0x1.3617e8p-1, 0x1.66463ep-2},   {0x1.6d5e8cp-1, 0x1.5fc3fap-1, 0x1.184b0ep-3},
    {0x1.630d84p-1, 0x1.6139cp-1, 0x1.a9743ep-3},  {0x1.5ff0cap-1, 0x1.12370ap-1, 0x1.f658aap-2},
    {0x1.5c9318p-1, 0x1.59b0a4p-1, 0x1.22c78ep-2}, {0x1.5930dep-1, 0x1.300b9ep-1, 0x1.c1a36ap-2},
    {0x1.51eacap-1, 0x1.492ef6p-1, 0x1.8df756p-2}, {0x1.3a080cp-1, 0x1.3955e8p-1, 0x1.ff44f2p-2},
}};

/// All axes with one coordinate 0 and y > 2⁻¹²: an exhaustive search finds no others with x ≥ y.
constexpr std::array<std::array<double, 3>, 20> in_plane{{
    {0x1.fffffep-1, 0x1.6a09e6p-12, 0}, {0x1.fffffp-1, 0x1.fffffcp-11, 0}, {0x1.ffffe2p-1, 0x1.5e8ad8p-10, 0},
    {0x1.ffffcp-1, 0x1.fffffp-10, 0},   {0x1.ffffp-1, 0x1.ffffcp-9, 0},    {0x1.fffdcp-1, 0x1.7fff94p-8, 0},
    {0x1.ffdfa4p-1, 0x1.6c0b2p-6, 0},   {0x1.ff1078p-1, 0x1.ef07fcp-5, 0}, {0x1.ff004p-1, 0x1.ff801p-5, 0},
    {0x1.fef088p-1, 0x1.077c02p-4, 0},  {0x1.fe2a1cp-1, 0x1.5a8538p-4, 0}, {0x1.fb1f3cp-1, 0x1.1a0764p-3, 0},
    {0x1.faf524p-1, 0x1.1eb83ep-3, 0},  {0x1.f96e2p-1, 0x1.4707fcp-3, 0},  {0x1.f5dc84p-1, 0x1.958b64p-3, 0},
    {0x1.f37c18p-1, 0x1.c20c7cp-3, 0},  {0x1.ee8d3cp-1, 0x1.090c4ep-2, 0}, {0x1.eb7c28p-1, 0x1.1ef5c2p-2, 0},
    {0x1.e31e4p-1, 0x1.530ffep-2, 0},   {0x1.df3b64p-1, 0x1.6872b2p-2, 0},
}};

using Axis = std::array<double, 3>;

/// The axis of the list nearest to the given one. Precondition: its coordinates are in the order of the list.
template <class List>
Axis nearest(const List& list, const Axis& near) {
  const auto farther = [&](const Axis& a, const Axis& b) {
    const auto along = [&](const Axis& d) { return d[0] * near[0] + d[1] * near[1] + d[2] * near[2]; };
    return along(a) < along(b);
  };
  return *std::max_element(list.begin(), list.end(), farther);
}

double binary32(double x) { return static_cast<double>(static_cast<float>(x)); }
double before(double x) { return std::nextafter(static_cast<float>(x), 0.0F); }

/// An axis near a coordinate plane, whose third coordinate makes up for the rest that two leave of 1.
Axis near_plane(const Axis& near) {
  for (double x = binary32(near[0]);; x = before(x)) {
    const double rest = 1 - x * x;  // exact, as y·y is
    double y = binary32(std::sqrt(rest));
    if (y * y > rest) y = before(y);
    const double z = binary32(std::sqrt(rest - y * y));
    if (model::Unitario::contains(model::Vector(glm::dvec3(x, y, z)))) return {x, y, z};
  }
}

Axis near_ordered(const Axis& near) {
  if (near[1] == 0) return {1, 0, 0};
  if (near[2] == 0) return nearest(in_plane, near);
  return near[2] < 0x1p-4 ? near_plane(near) : nearest(in_space, near);
}

}  // namespace

glm::dvec3 binary32_axis(const glm::dvec3& near) {
  std::array<int, 3> order{0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return std::abs(near[i]) > std::abs(near[j]); });
  Axis ordered{};
  for (std::size_t i = 0; i < 3; ++i) ordered[i] = std::abs(near[order[i]]);
  const Axis found = near_ordered(ordered);
  glm::dvec3 axis;
  for (std::size_t i = 0; i < 3; ++i) axis[order[i]] = std::copysign(found[i], near[order[i]]);
  return axis;
}

}  // namespace durero::conform
