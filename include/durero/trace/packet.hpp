#pragma once
/// Eight rays side by side, each against one element of the same type, or many of them against the same element: what
/// steps over lanes take and give.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "durero/scene/scene.hpp"
#include "durero/scene/shape_view.hpp"
#include "durero/trace/finding.hpp"
#include "durero/trace/ray.hpp"

namespace durero::trace {

/// Rays and elements in columns; those of attributes that the type does not have mean nothing. Every lane must hold
/// ordinary ones or zeros; results of unused lanes mean nothing.
struct Packet {
  static constexpr std::size_t size = 8;    ///< how many lanes
  using Column = std::array<double, size>;  ///< a number of each lane
  using Columns = std::array<Column, 3>;    ///< of x, y and z

  /// @{ The member of that name of Ray, or of the shapes.
  alignas(64) Columns p{};
  Columns v{};
  Column speed{};
  Columns centro{};
  Column radio{}, proporcion{};
  Columns vector{};
  Column altura{};
  std::array<Columns, 3> vertices{};
  /// @}

  /// Fills a lane.
  template <class Shape>
  void set(std::size_t lane, const Ray& ray, const Shape& shape) {
    set(p, lane, ray.p);
    set(v, lane, ray.v);
    speed[lane] = ray.speed;
    if constexpr (requires { shape.centro; }) set(centro, lane, shape.centro);
    if constexpr (requires { shape.radio; }) radio[lane] = shape.radio;
    if constexpr (requires { shape.proporcion; }) proporcion[lane] = shape.proporcion;
    if constexpr (requires { shape.vector; }) set(vector, lane, shape.vector);
    if constexpr (requires { shape.altura; }) altura[lane] = shape.altura;
    if constexpr (requires { shape.vertices; })
      for (std::size_t i = 0; i < vertices.size(); ++i) set(vertices[i], lane, shape.vertices[i]);
  }

 private:
  static void set(Columns& columns, std::size_t lane, const glm::dvec3& x) {
    columns[0][lane] = x.x;
    columns[1][lane] = x.y;
    columns[2][lane] = x.z;
  }
};

/// Pairs of a ray and an element of one type, which wait until there are enough for a packet. What names an element is
/// the caller's.
struct Queue {
  Packet packet;                                           ///< its first lanes are filled
  std::array<std::uint32_t, Packet::size> numbers{};       ///< of the rays
  std::array<scene::ElementRef, Packet::size> elements{};  ///< the elements
  std::size_t count = 0;                                   ///< how many wait

  /// Adds a pair; shapes.visit(e, f) gives f the geometry. Precondition: not full.
  template <class Shapes>
  void push(const Shapes& shapes, std::uint32_t number, const Ray& ray, scene::ElementRef e) {
    shapes.visit(e, [&](const auto& shape) { packet.set(count, ray, shape); });
    numbers[count] = number;
    elements[count] = e;
    ++count;
  }
  /// Adds the first of some rays with the same element, as many as find room; their numbers count from one on. How
  /// many.
  template <class Shapes>
  std::size_t push(const Shapes& shapes, std::uint32_t number, std::span<const Ray> rays, scene::ElementRef e) {
    const std::span<const Ray> some = rays.first(std::min(rays.size(), Packet::size - count));
    shapes.visit(e, [&](const auto& shape) {
      for (std::size_t i = 0; i < some.size(); ++i) packet.set(count + i, some[i], shape);
    });
    for (std::size_t i = 0; i < some.size(); ++i) numbers[count] = number++, elements[count++] = e;
    return some.size();
  }
  /// Whether every lane is filled.
  bool full() const { return count == Packet::size; }
};

/// A queue for each type.
using Queues = std::array<Queue, scene::shape_count>;

/// By lane, what the triage finds: t within error, and the slope, of a hit. A lane neither hit nor undecided is a miss.
struct Findings {
  using Column = Packet::Column;  ///< a number of each lane
  /// @{ As in Finding and Slope.
  alignas(64) Column t{};
  Column error{}, at_root{}, at_root_error{}, A{}, A_error{};
  /// @}
  unsigned hit = 0, undecided = 0;  ///< a bit for every lane, the first lane's lowest

  /// That of a lane.
  Finding operator[](std::size_t lane) const {
    const auto has = [&](unsigned bits) { return (bits >> lane & 1) != 0; };
    const Verdict verdict = has(hit) ? Verdict::hit : has(undecided) ? Verdict::undecided : Verdict::miss;
    return {verdict, t[lane], 0, error[lane], {at_root[lane], at_root_error[lane], A[lane], A_error[lane]}};
  }
  /// Precondition: a hit by triage.
  void set(std::size_t lane, const Finding& finding) {
    hit |= 1u << lane;
    t[lane] = finding.hi;
    error[lane] = finding.error;
    at_root[lane] = finding.slope.at_root;
    at_root_error[lane] = finding.slope.at_root_error;
    A[lane] = finding.slope.A;
    A_error[lane] = finding.slope.A_error;
  }
};

/// triage in every lane, for rays that do not start on the element, without a limit. A lane may be undecided where the
/// triage of one ray is not.
void triage(const Packet& packet, model::Tipo tipo, Findings& findings);

/// Rays in columns, for tests of many of them against one element. Every one must be ordinary or zeros.
struct RayColumns {
  static constexpr std::size_t size = 64;   ///< how many at most
  using Column = std::array<double, size>;  ///< a number of each ray

  /// @{ The member of that name of Ray, by axis.
  alignas(64) std::array<Column, 3> p{};
  std::array<Column, 3> v{};
  Column speed{};
  /// @}
  std::array<std::uint64_t, size> start{};  ///< what each starts on, as one number, where that is set

  /// An element of a source of candidates as one number.
  static constexpr std::uint64_t number(scene::ElementRef own) {
    return std::uint64_t{static_cast<std::uint8_t>(own.tipo)} << 32 | own.index;
  }
  /// Fills a place but for what the ray starts on.
  void set(std::size_t place, const Ray& ray) {
    p[0][place] = ray.p.x, p[1][place] = ray.p.y, p[2][place] = ray.p.z;
    v[0][place] = ray.v.x, v[1][place] = ray.v.y, v[2][place] = ray.v.z;
    speed[place] = ray.speed;
  }
  /// Apart, as most rays start on nothing, and no column of it is read then.
  void set_start(std::size_t place, scene::ElementRef own) { start[place] = number(own); }
};

/// Of rays in columns that have a bit: a bit for each eight of some, that of its first place. Who goes through these
/// passes over the others without a branch for each, which would go one way or the other as chance has it.
constexpr std::uint64_t eights_of(std::uint64_t which) {
  static_assert(Packet::size == 8);
  which |= which >> 4;
  which |= which >> 2;
  which |= which >> 1;
  return which & 0x0101010101010101;
}

/// Those of the rays that have a bit which start on this element. Precondition: what they start on is set.
std::uint64_t starting_on(const RayColumns& rays, std::uint64_t which, scene::ElementRef own);

/// What the triage finds of rays in columns, by eights.
using ColumnFindings = std::array<Findings, RayColumns::size / Packet::size>;

/// The same for the rays that have a bit, and one element: in the lanes that they fill, what it finds in those of a
/// packet. Eights of which none has a bit are left as they are; what other rays get means nothing.
void triage(const RayColumns& rays, std::uint64_t which, scene::ShapeView element, ColumnFindings& findings);

/// triage of a packet for rays that start on the element. Linear ones are never hit.
void triage_from(const Packet& packet, model::Tipo tipo, Findings& findings);

/// By lane, t and the point rounded once; only where certain.
struct RoundedPacket {
  using Column = Packet::Column;  ///< a number of each lane
  alignas(64) Column t{};         ///< t!
  Column x{}, y{}, z{};           ///< punto!
  unsigned certain = 0;           ///< a bit for every lane, the first lane's lowest
};

/// rounded(improved) in every lane. Precondition: the findings are hits by triage, of rays that do not start on the
/// element.
void improve_and_round(const Packet& packet, model::Tipo tipo, const Findings& findings, RoundedPacket& result);
/// The same of rays that start on their elements. Precondition: the findings are hits by triage_from of these rays and
/// elements.
void improve_and_round_from(const Packet& packet, model::Tipo tipo, const Findings& findings, RoundedPacket& result);

}  // namespace durero::trace
