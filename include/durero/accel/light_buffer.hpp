#pragma once
/// The light buffer (A §1.6.1, Haines and Greenberg): a direction cube about each light of the stage, whose squares
/// list the elements that are seen there from the light, ascending by least distance. It answers segments that end at a
/// light; other rays are tested against every element.
///
/// The lists hold every element that a segment may meet. A segment from x has v = L − x, each component rounded once: v
/// = v₀ + δ with v₀ = L − x and |δ| ≤ u|v₀|, u = 2⁻⁵³. Its point at t, seen from the light, is −(1 − t)·v₀ + t·δ. At a
/// distance s from the light its direction is within arcsin(|δ|/s) of that of −v₀, which is within 2u of that of −v,
/// which lies within 2u of the square that it is looked up in. The cube therefore serves segments up to `longest` long,
/// and takes elements that come nearer to the light than `close` for seen everywhere. With |δ|/s ≤ u·longest/close ≤
/// 2⁻²⁴, a square whose pyramid is `widening` = 2⁻²² wider holds every element that a segment of it may meet.
///
/// Two simplifications of the seed are left out: its rules for polygons that face away from the light, and for lists of
/// one polygon. They depend on the surface that a shadow ray starts on, and hold for closed opaque solids, which a
/// scene does not know, and for flat elements that the ray starts on, which `en` names; they fail for a triangle that
/// stands alone, and for an open cylinder, which shades itself. A full-occlusion record ends a list behind an element
/// that is proved to cover the square: a sphere.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/accel/direction_cube.hpp"
#include "durero/accel/linear.hpp"
#include "durero/accel/slab.hpp"
#include "durero/accel/structure.hpp"

namespace durero::accel {

/// The construction of the lists.
struct LightBufferOptions {
  bool ends_at_cover = true;  ///< whether lists end behind an element that covers the square; false to measure it
};

/// The direction cube of one light.
class LightCube {
 public:
  /// An element, seen from the light.
  struct Item {
    scene::ElementRef e;  ///< the element
    ApparentBall seen;    ///< its ball, seen from the light
    surface::Box box;     ///< its box
    /// Whether the element has a finite ball and box.
    bool is_bounded() const { return seen.far < trace::no_limit; }
  };
  /// A full-occlusion record: a segment of the square whose length is within both bounds meets the element.
  struct Record {
    scene::ElementRef e;  ///< the element that covers the square
    double from;          ///< the least length; ∞ where nothing covers the square
    double to;            ///< the greatest length
  };
  /// The list of a square.
  struct List {
    std::span<const std::uint32_t> items;  ///< ascending by least distance
    const Record& record;                  ///< the list is complete for segments shorter than record.from
  };

  /// Makes the lists of a light at an ordinary point. Precondition: `elements` are the ordinary elements of the scene.
  LightCube(const scene::Scene& scene, const glm::dvec3& light, std::span<const scene::ElementRef> elements,
            const LightBufferOptions& options = {});

  /// The middle of the cube.
  const glm::dvec3& light() const noexcept { return light_; }
  /// Whether the ray's segment ends at the light, and is not too long to be looked up. Precondition: the ray is
  /// ordinary.
  bool serves(const trace::Ray& ray) const noexcept { return ray.v == light_ - ray.p && ray.length() <= longest_; }
  /// The list of a ray's square. Precondition: the cube serves the ray.
  List list(const trace::Ray& ray) const;
  /// The item of a number in a list.
  const Item& item(std::uint32_t number) const { return items_[number]; }

  /// Adds the size of the lists.
  void add_to(Size& size) const;

 private:
  using Numbers = std::vector<std::uint32_t>;
  /// A square, quartered or with a list.
  struct Node {
    std::uint32_t first;   // the first of its quarters, which are consecutive; or of its references
    std::uint32_t count;   // the number of its references
    std::uint32_t record;  // 0 for none
    bool is_quartered;
  };

  /// A square that may still be quartered.
  struct Open {
    std::uint32_t node;
    Square square;
    Numbers seen;
    std::uint32_t record;
    std::uint32_t depth;
  };

  void build();
  Open open(std::uint32_t node, const Square& square, const Numbers& seen, std::uint32_t record, std::uint32_t depth);
  template <class Push>
  bool quarter_pays(const Open& whole, std::size_t& references, Push push);
  void close(const Open& open);
  bool is_settled(const Open& open) const;
  std::uint32_t end_at_cover(const DirectionCone& cone, Numbers& seen, std::uint32_t record);

  const scene::Scene* scene_;
  LightBufferOptions options_;
  glm::dvec3 light_;
  double longest_ = 0;
  std::vector<Item> items_;  // ascending by least distance
  std::vector<Node> nodes_;
  std::vector<Record> records_;
  Numbers references_;
  std::uint32_t depth_ = 0;
};

/// The cubes of all lights, and the balls of all elements for rays that no list serves: a structure. It recognises
/// segments that are certainly occluded without a candidate.
class LightBuffer : public LinearList {
 public:
  /// Makes the lists of a scene, which must outlive it unedited.
  explicit LightBuffer(const scene::Scene& scene, const LightBufferOptions& options = {});

  /// @{ The operations of a structure.
  Size size() const;
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const;
  /// @}

  /// Whether a full-occlusion record proves that the ray, which starts on the elements of en, meets one at some 0 < t <
  /// 1.
  bool is_certainly_occluded(const trace::Ray& ray, scene::Origin en) const;

 private:
  const LightCube* cube_of(const trace::Ray& ray) const;

  std::vector<LightCube> cubes_;
};

template <class Limit, class Visit>
bool LightBuffer::any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
  const LightCube* const cube = limit() <= 1 ? cube_of(ray) : nullptr;
  if (cube == nullptr) return LinearList::any(ray, limit, visit, work);
  const LightCube::List list = cube->list(ray);
  if (!(ray.length() < list.record.from)) return LinearList::any(ray, limit, visit, work);
  ++work.cells;
  const Beam beam(ray);
  for (const std::uint32_t number : list.items) {
    const LightCube::Item& item = cube->item(number);
    if (item.seen.near > ray.length()) {  // the segment's points are within |v₀|(1 + u) of the light
      ++work.by_distance;
      return false;
    }
    if (item.is_bounded()) {
      ++work.volumes;
      if (!stretch(item.box, beam, 1).meets()) {
        ++work.by_miss;
        continue;
      }
    }
    ++work.candidates;
    if (visit(item.e)) return true;
  }
  return false;
}

}  // namespace durero::accel
