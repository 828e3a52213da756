#pragma once
/// A packet is eight rays side by side in lanes, each with an element of one type. The steps here also take up to 64
/// rays in columns with one element.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "durero/scene/scene.hpp"
#include "durero/scene/shape_view.hpp"
#include "durero/trace/finding.hpp"
#include "durero/trace/ray.hpp"
#include "durero/trace/triangle_block.hpp"

namespace durero::trace {

/// Rays and elements of one type in columns. Columns of attributes that the type does not have mean nothing, nor do the
/// results of unused lanes. Precondition: every lane holds ordinary numbers or zeros.
struct Packet {
  static constexpr std::size_t size = 8;    ///< lanes
  using Column = std::array<double, size>;  ///< a number of each lane
  using Columns = std::array<Column, 3>;    ///< of x, y and z

  /// @{ The member of that name of Ray, or of the shape.
  alignas(64) Columns p{};
  Columns v{};
  Column speed{};
  Columns centro{};
  Column radio{}, proporcion{};
  Columns vector{};
  Column altura{};
  std::array<Columns, 3> vertices{};
  /// @}

  /// Sets a lane to a ray and an element.
  template <class Shape>
  void set(std::size_t lane, const RayNumbers& ray, const Shape& shape) {
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

/// Pairs of a ray and an element of one type that wait to fill a packet. The caller chooses how elements are named.
struct Queue {
  Packet packet;                                           ///< its first lanes are filled
  std::array<std::uint32_t, Packet::size> numbers{};       ///< the numbers of the rays
  std::array<scene::ElementRef, Packet::size> elements{};  ///< the names of the elements
  std::size_t count = 0;                                   ///< pairs that wait

  /// Adds a pair; shapes.visit(e, f) gives f the geometry. Precondition: the queue is not full.
  template <class Shapes>
  void push(const Shapes& shapes, std::uint32_t number, const RayNumbers& ray, scene::ElementRef e) {
    shapes.visit(e, [&](const auto& shape) { packet.set(count, ray, shape); });
    numbers[count] = number;
    elements[count] = e;
    ++count;
  }
  /// Adds as many of the rays as find room, all with the same element; their numbers count up from `number`. The number
  /// of rays that were added.
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

/// A queue for each type of element.
using Queues = std::array<Queue, scene::shape_count>;

/// The triage's findings in lanes: t within its error and the slope of a hit. A lane with neither bit is a miss.
struct Findings {
  using Column = Packet::Column;  ///< a number of each lane
  /// @{ The member of that name of RootEstimate or Slope.
  alignas(64) Column t{};
  Column error{}, at_root{}, at_root_error{}, A{}, A_error{};
  /// @}
  unsigned hit = 0, undecided = 0;  ///< a bit for every lane, the first lane's lowest

  /// The finding of a lane.
  RootEstimate operator[](std::size_t lane) const {
    const auto has = [&](unsigned bits) { return (bits >> lane & 1) != 0; };
    const Decision verdict = has(hit) ? Decision::hit : has(undecided) ? Decision::undecided : Decision::miss;
    return {verdict, t[lane], 0, error[lane], {at_root[lane], at_root_error[lane], A[lane], A_error[lane]}};
  }
  /// @{ Bounds of the parameter of a lane's hit.
  // Their own roundings are covered: the triage's error exceeds its need by three roundings of t (`quotient`).
  double low(std::size_t lane) const { return t[lane] - error[lane]; }
  double high(std::size_t lane) const { return t[lane] + error[lane]; }
  /// @}
  /// Sets a lane to a finding. Precondition: the finding is a hit by triage.
  void set(std::size_t lane, const RootEstimate& finding) {
    hit |= 1u << lane;
    t[lane] = finding.hi;
    error[lane] = finding.error;
    at_root[lane] = finding.slope.at_root;
    at_root_error[lane] = finding.slope.at_root_error;
    A[lane] = finding.slope.A;
    A_error[lane] = finding.slope.A_error;
  }
};

/// triage of eight pairs at once, for rays that do not start on their elements, without a limit. It may leave a lane
/// undecided that the triage of one ray decides.
void triage(const Packet& packet, model::Tipo tipo, Findings& findings);

/// triage of one ray against the triangles of a block, on none of which it starts; findings stand in the triangles'
/// lanes. Lanes without a triangle are misses. Precondition: the ray is ordinary, and so are the triangles.
void triage(const Ray& ray, const TriangleBlock& block, Findings& findings);

/// Rays in columns, which are tested against one element together. Precondition: all are ordinary or zeros.
struct RayColumns {
  static constexpr std::size_t size = 64;   ///< rays at most
  using Column = std::array<double, size>;  ///< a number of each ray

  /// @{ The member of that name of Ray, by axis.
  alignas(64) std::array<Column, 3> p{};
  std::array<Column, 3> v{};
  Column speed{};
  /// @}
  std::array<std::uint64_t, size> start{};  ///< the element that each starts on, where set_start was called

  /// The name of an element, as one number.
  static constexpr std::uint64_t number(scene::ElementRef own) {
    return std::uint64_t{static_cast<std::uint8_t>(own.tipo)} << 32 | own.index;
  }
  /// The element of that number.
  static constexpr scene::ElementRef element(std::uint64_t number) {
    return {static_cast<model::Tipo>(number >> 32), static_cast<std::uint32_t>(number)};
  }
  /// Sets a place to a ray, without the element that it starts on.
  void set(std::size_t place, const Ray& ray) {
    p[0][place] = ray.p.x, p[1][place] = ray.p.y, p[2][place] = ray.p.z;
    v[0][place] = ray.v.x, v[1][place] = ray.v.y, v[2][place] = ray.v.z;
    speed[place] = ray.speed;
  }
  /// Sets the element that a ray starts on. The column is apart, because most rays start on nothing and it is not read
  /// then.
  void set_start(std::size_t place, scene::ElementRef own) { start[place] = number(own); }
};

/// The groups of eight that hold a ray of `which`: a bit for each, that of its first place. A loop over these bits has
/// no branch for each empty group, which would be mispredicted.
constexpr std::uint64_t eights_of(std::uint64_t which) {
  static_assert(Packet::size == 8);
  which |= which >> 4;
  which |= which >> 2;
  which |= which >> 1;
  return which & 0x0101010101010101;
}

/// The rays of `which` that start on this element. Precondition: set_start was called for each.
std::uint64_t starting_on(const RayColumns& rays, std::uint64_t which, scene::ElementRef own);

/// The triage's findings for rays in columns, by groups of eight.
using ColumnFindings = std::array<Findings, RayColumns::size / Packet::size>;

/// triage of one element for the rays in `which`, whose findings stand in the lanes of their places. Groups of eight
/// without a ray of `which` keep their findings; the findings of other rays, and of rays that start on the element,
/// mean nothing.
void triage(const RayColumns& rays, std::uint64_t which, scene::ShapeView element, ColumnFindings& findings);

/// triage of eight pairs whose rays start on their elements. A plane, disc or triangle is never hit.
void triage_from(const Packet& packet, model::Tipo tipo, Findings& findings);
/// triage_from of one element for the rays in `which`, all of which start on it; findings stand as triage leaves them.
void triage_from(const RayColumns& rays, std::uint64_t which, scene::ShapeView element, ColumnFindings& findings);

/// t and the point of a hit in each lane, rounded once; they mean something only in certain lanes.
struct RoundedPacket {
  using Column = Packet::Column;  ///< a number of each lane
  alignas(64) Column t{};         ///< t!
  Column x{}, y{}, z{};           ///< punto!
  unsigned certain = 0;           ///< a bit for every lane, the first lane's lowest
};

/// rounded(improved) in every lane (trace/steps.hpp). Precondition: the findings are hits by triage, of rays that do
/// not start on their elements.
void improve_and_round(const Packet& packet, model::Tipo tipo, const Findings& findings, RoundedPacket& result);
/// rounded(improved) for rays that start on their elements. Precondition: the findings are hits by triage_from of these
/// rays and elements.
void improve_and_round_from(const Packet& packet, model::Tipo tipo, const Findings& findings, RoundedPacket& result);

}  // namespace durero::trace
