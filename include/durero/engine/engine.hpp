#pragma once
/// An engine answers rays on a scene. `durero trace`, `agree` and `render` use this interface and no other.
///
/// An engine uses as many threads as the calling thread may (tbb::global_control, tbb::task_arena). No answer depends
/// on their number, nor on the other queries of a call.

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "durero/accel/work.hpp"
#include "durero/scene/groups.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/exact.hpp"
#include "durero/trace/first_element.hpp"

namespace durero::engine {

/// Answers rays on one scene, which must outlive the engine unedited. Any number of threads may call it.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Primera_Interseccion of every query, in order. Preconditions: `hits` has a place for each query; the elements of
  /// every en are in the scene.
  virtual void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const = 0;

  /// first_hits without t and point, which an engine need not compute then. Preconditions are those of first_hits, for
  /// `elements`.
  virtual void first_elements(std::span<const scene::Query> queries, std::span<trace::FirstElement> elements) const;

  /// occluded_segment of every query, in order: whether the ray meets some element at some 0 < t < 1. Preconditions are
  /// those of first_hits, for `occluded`.
  virtual void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const = 0;

  /// The points of all elements that a ray of the engine's scene meets on a stretch, each rounded once: by the name of
  /// the element, then ascending along the ray (enumerado of ante or ante_lejos). Nothing where one of the elements
  /// does not pass light, or the ray runs along it there. Preconditions are those of first_hits.
  virtual std::optional<std::vector<surface::exact::ElementPoint>> points_between(
      const scene::Scene& scene, const scene::Query& query, surface::exact::RayStretch stretch,
      const surface::exact::Passes& passes) const;

  /// The unit normal of an element at one of its points, as shading uses it: on either side of the surface, and the
  /// null vector where there is none. Precondition: the element is in the scene.
  virtual glm::dvec3 normal(const scene::Scene& scene, scene::ElementRef element, const glm::dvec3& point) const;

 protected:
  Engine() = default;
  Engine(const Engine&) = default;
  Engine& operator=(const Engine&) = default;
};

/// Engine::first_hits of these queries, in order.
std::vector<scene::Hit> first_hits(const Engine& engine, std::span<const scene::Query> queries);
/// Engine::first_hits of one query.
scene::Hit first_hit(const Engine& engine, const scene::Query& query);
/// Engine::occluded_segments of one query.
bool occluded_segment(const Engine& engine, const scene::Query& query);

/// The branching of a hierarchy's inner nodes.
struct Branching {
  double cost;       ///< the expected tests of a line that meets the root (Goldsmith and Salmon)
  double arity;      ///< the mean number of children
  std::size_t most;  ///< the greatest number of children
};

/// The costs of a structure: to build it, to hold it, and to answer rays by it. A structure that serves only some rays
/// is measured with rays of that kind.
struct Figures {
  accel::Size size;                       ///< the structure's size
  accel::Work work;                       ///< its work for the rays
  double building_seconds;                ///< the time to build it
  double answering_seconds;               ///< the time of the answers, on one thread
  std::string_view asked = "first hits";  ///< the kind of query
  std::optional<double> without_seconds =
      {};  ///< the time of the same answers without the structure, where it serves only some rays
  std::optional<Branching> branching = {};  ///< of a hierarchy with inner nodes
};

/// A row of the table of engines: an engine's name, its promises, and its makers. A scene must outlive the engines made
/// for it, unedited.
struct EngineRow {
  std::string_view name;  ///< on the command line
  std::string_view what;  ///< a description in a few words
  bool exact_bytes;       ///< its answers are those of `exact`, byte for byte
  bool honours_origins;   ///< knows the elements that a ray starts on; otherwise it ignores them
  std::unique_ptr<const Engine> (*prepare)(const scene::Scene& scene);  ///< makes the engine for a scene
  std::string_view section{};  ///< of the acceleration seed that describes the structure, or empty
  /// Measures the structure on some rays, one by one; null for an engine without a structure.
  Figures (*measure)(const scene::Scene& scene, std::span<const scene::Query> queries) = nullptr;
  /// @{ prepare and measure with the scene's groups as the hierarchy; null for an engine that follows no groups.
  std::unique_ptr<const Engine> (*prepare_by_hand)(const scene::Scene& scene, const scene::Groups& groups) = nullptr;
  Figures (*measure_by_hand)(const scene::Scene& scene, std::span<const scene::Query> queries,
                             const scene::Groups& groups) = nullptr;
  /// @}
};

/// Every engine, in the order of the ladder.
std::span<const EngineRow> engines();
/// The row of an engine's name; null where there is none.
const EngineRow* find(std::string_view name);

/// The engine that is used where none is named.
inline constexpr std::string_view default_engine = "fast";

}  // namespace durero::engine
