#pragma once
/// Whatever answers rays: one interface, which `durero trace`, `agree` and `render` ask and nothing else.
///
/// An engine answers on as many threads as the calling thread may use (tbb::global_control, tbb::task_arena); no answer
/// depends on their number, nor on what else is asked with it.

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
#include "durero/trace/first_element.hpp"

namespace durero::engine {

/// Answers rays on one scene, which must outlive it unedited. Any number of threads may ask it.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Primera_Interseccion of every query, in order. Preconditions: a place in `hits` for each query; the elements of
  /// every en are in the scene.
  virtual void first_hits(std::span<const scene::Query> queries, std::span<scene::Hit> hits) const = 0;

  /// What first_hits says less t and point, which an engine need not find out then. Preconditions as above.
  virtual void first_elements(std::span<const scene::Query> queries, std::span<trace::FirstElement> elements) const;

  /// occluded_segment of every query, in order: some element is met at some 0 < t < 1. Preconditions as above.
  virtual void occluded_segments(std::span<const scene::Query> queries, std::span<bool> occluded) const = 0;

  /// The unit normal of an element of the scene at a point of it, for its look: on either side, and null where there is
  /// none.
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

/// How a hierarchy branches.
struct Branching {
  double cost;       ///< by Goldsmith and Salmon: the tests that a line which meets the root is expected to need
  double arity;      ///< children of an inner node, in the mean
  std::size_t most;  ///< children of one inner node
};

/// What a structure cost: to make, to hold, and to answer rays. A structure that is for some rays alone is asked about
/// such as belong to the rays that it is measured with.
struct Figures {
  accel::Size size;                       ///< what it holds
  accel::Work work;                       ///< what it did for the rays
  double building_seconds;                ///< that it took to make
  double answering_seconds;               ///< that the answers took, on one thread
  std::string_view asked = "first hits";  ///< what the rays were asked for
  std::optional<double> without_seconds =
      {};  ///< that the same took without a structure, where not first hits of the same
  std::optional<Branching> branching = {};  ///< of a hierarchy that has inner nodes
};

/// What an engine is called, what it promises, and what makes it ready for a scene, which must outlive it unedited.
struct Row {
  std::string_view name;  ///< on the command line
  std::string_view what;  ///< in a few words
  bool exact_bytes;       ///< its answers are those of `exact`, byte for byte
  bool honours_origins;   ///< it knows of the elements that a ray starts on; otherwise it answers as if there were none
  std::unique_ptr<const Engine> (*prepare)(const scene::Scene& scene);  ///< makes it ready for the scene
  std::string_view section{};  ///< of the acceleration seed that describes its structure; empty where it has none
  /// The figures of its structure on some rays, one by one; null where it has none.
  Figures (*measure)(const scene::Scene& scene, std::span<const scene::Query> queries) = nullptr;
  /// @{ As prepare and measure, with groups of the scene as its hierarchy; null where it follows none.
  std::unique_ptr<const Engine> (*prepare_by_hand)(const scene::Scene& scene, const scene::Groups& groups) = nullptr;
  Figures (*measure_by_hand)(const scene::Scene& scene, std::span<const scene::Query> queries,
                             const scene::Groups& groups) = nullptr;
  /// @}
};

/// Every engine, in the order of the ladder.
std::span<const Row> engines();
/// Null where no engine has the name.
const Row* find(std::string_view name);

/// The engine of whoever names none.
inline constexpr std::string_view default_engine = "fast";

}  // namespace durero::engine
