#pragma once
/// The light buffer (A §1.6.1, Haines and Greenberg): a direction cube about each light of the stage, with a list in
/// each of its squares of the elements that are seen there from the light, ascending by their nearest distance to it.
/// It answers segments that end at a light; other rays are tried against every element.
///
/// A segment from x has v = L − x, each component rounded once: v = v₀ + δ with v₀ = L − x and |δ| ≤ u|v₀|, u = 2⁻⁵³.
/// Its point at t, seen from the light, is −(1 − t)·v₀ + t·δ. At a distance s from the light its direction is within
/// arcsin(|δ|/s) of that of −v₀, which is within 2u of that of −v, which lies within 2u of the square that it is looked
/// up in. So the cube serves segments up to `longest` long, takes elements that come nearer to the light than `close`
/// for seen everywhere, and with |δ|/s ≤ u·longest/close ≤ 2⁻²⁴ a square whose pyramid is `widening` = 2⁻²² wider holds
/// whatever a segment of it may meet.
///
/// The seed's simplifications: its rules for polygons that face away from the light, and for lists of one polygon, ask
/// whose surface a shadow ray starts on. They hold for closed opaque solids, of which a scene knows nothing, and for
/// flat elements that the ray starts on, which `en` names; not for a triangle that stands alone, nor for an open
/// cylinder, which shades itself. So no element is left out by them. A list ends behind an element that covers its
/// square, in a full-occlusion record, where that is proved: of spheres.

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "durero/accel/direction_cube.hpp"
#include "durero/accel/linear.hpp"
#include "durero/accel/slab.hpp"
#include "durero/accel/structure.hpp"

namespace durero::accel {

/// How the lists are made.
struct LightBufferOptions {
  bool ends_at_cover = true;  ///< a list ends behind what covers its square; without it what that saves is measured
};

/// The cube of one light.
class LightCube {
 public:
  /// An element as it is seen from the light.
  struct Item {
    scene::ElementRef e;  ///< which
    Seen seen;            ///< as its ball is seen
    surface::Box box;     ///< around it
    /// It has a ball and a box.
    bool is_bounded() const { return seen.far < trace::no_limit; }
  };
  /// What is known of the squares that an element covers: where both hold, the segment meets it, and needs no test.
  struct Record {
    scene::ElementRef e;  ///< which covers them
    double from;          ///< of segments not shorter than this; ∞ where nothing covers the square
    double to;            ///< of segments not longer than this
  };
  /// The elements of a square.
  struct List {
    std::span<const std::uint32_t> items;  ///< ascending by nearest distance
    const Record& record;                  ///< the list is complete for segments shorter than record.from
  };

  /// Of a light at an ordinary point, and the ordinary elements of the scene.
  LightCube(const scene::Scene& scene, const glm::dvec3& light, std::span<const scene::ElementRef> elements,
            const LightBufferOptions& options = {});

  /// The middle of the cube.
  const glm::dvec3& light() const noexcept { return light_; }
  /// The segment of the ray ends at the light, and is not too long to be looked up. Precondition: the ray is ordinary.
  bool serves(const trace::Ray& ray) const noexcept { return ray.v == light_ - ray.p && ray.length() <= longest_; }
  /// The list of a ray that it serves.
  List list(const trace::Ray& ray) const;
  /// Of a number in a list.
  const Item& item(std::uint32_t number) const { return items_[number]; }

  /// Adds what it holds.
  void add_to(Size& size) const;

 private:
  using Numbers = std::vector<std::uint32_t>;
  /// A square: quartered, or with a list.
  struct Node {
    std::uint32_t first;   // of its quarters, which lie together; or of its references
    std::uint32_t count;   // of its references
    std::uint32_t record;  // none: 0
    bool is_quartered;
  };

  /// A square that may be quartered yet.
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
  std::uint32_t end_at_cover(const Cone& cone, Numbers& seen, std::uint32_t record);

  const scene::Scene* scene_;
  LightBufferOptions options_;
  glm::dvec3 light_;
  double longest_ = 0;
  std::vector<Item> items_;  // ascending by nearest distance
  std::vector<Node> nodes_;
  std::vector<Record> records_;
  Numbers references_;
  std::uint32_t depth_ = 0;
};

/// The cubes of all lights, and the balls of all elements for the rays that no list serves. A Structure; segments that
/// are certainly in shadow it knows without a candidate.
class LightBuffer : public Linear {
 public:
  /// Of a scene, which must outlive it unedited.
  explicit LightBuffer(const scene::Scene& scene, const LightBufferOptions& options = {});

  /// @{ As every Structure has it.
  Size size() const;
  template <class Limit, class Visit>
  bool any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const;
  /// @}

  /// A full-occlusion record proves that the ray, which starts on the elements of en, meets one at some 0 < t < 1.
  bool is_certainly_occluded(const trace::Ray& ray, scene::Origin en) const;

 private:
  const LightCube* cube_of(const trace::Ray& ray) const;

  std::vector<LightCube> cubes_;
};

template <class Limit, class Visit>
bool LightBuffer::any(const trace::Ray& ray, Limit limit, Visit visit, Work& work) const {
  const LightCube* const cube = limit() <= 1 ? cube_of(ray) : nullptr;
  if (cube == nullptr) return Linear::any(ray, limit, visit, work);
  const LightCube::List list = cube->list(ray);
  if (!(ray.length() < list.record.from)) return Linear::any(ray, limit, visit, work);
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
