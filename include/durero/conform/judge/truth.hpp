#pragma once
/// The truth about a ray is its exact answer, with the other answers that a right program may give where data that are
/// off by a rounding would change it.

#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "durero/conform/families/asked_surface.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/surface/exact.hpp"

namespace durero::conform {

/// The reason why the exact answer is not the only one: the property of the first crossing that an arbitrarily small
/// change of the data removes. Where several elements are at the first point, it is the last property in the order
/// tangent, rim, edge, apex, in_surface that one of them has. A ray that just misses something exactly is not ambiguous
/// by that: its answer is the answer to other data near enough, and a judge with a backward error sees it.
enum class Ambiguity {
  none,
  tangent,    ///< a double root
  rim,        ///< at an end of an open surface, or of a disc
  edge,       ///< at an edge or a vertex of a triangle
  apex,       ///< at the apex of a cone
  tie,        ///< several elements at one point, none of which a small change removes
  in_surface  ///< the ray lies in the surface
};
/// The word of an ambiguity in files, spelt as its enumerator.
std::string_view name(Ambiguity ambiguity);

/// The part of a ray that a question is about: begin ≤ t ≤ end, and t > 0. It is empty where begin is larger than end.
/// A ray along which a ball is cast has the ball's radius besides.
struct AskedRange {
  double begin = 0;                                      ///< not negative
  double end = std::numeric_limits<double>::infinity();  ///< not negative
  double radio = 0;                                      ///< of the ball that is cast, above 0; 0 of any other question
  bool operator==(const AskedRange&) const = default;
};

/// The exact answer to a ray, and the answers that are permissible in its place.
struct ExactAnswer {
  scene::Hit hit;                         ///< the answer of Primera_Interseccion
  Ambiguity ambiguity = Ambiguity::none;  ///< the reason why `hit` is not the only answer; none where it is
  /// The answers that are permissible beside `hit`, nearest first: the crossings behind it up to and including the
  /// first that no small change removes, and a miss where there is no such crossing. Several elements at one point are
  /// answered all together, or each alone. A stretch of the ray inside a surface counts with both its ends, with t = 0
  /// where it begins at t → 0⁺; any point between them is as good.
  std::vector<scene::Hit> permissible{};
  /// Every crossing, ascending, with one element each, where the question is about all; otherwise none. A stretch
  /// inside a surface counts with both its ends.
  std::vector<scene::Hit> all{};
};

/// The exact answer and its permissible variants, from the certified steps of the tracer; surface::exact decides the
/// elements that these steps leave open. Precondition: the ray is of the scene.
ExactAnswer truth(const scene::Scene& scene, const scene::Query& ray);

/// Every crossing of a ray with the elements of the scene, ascending: points, and stretches inside a surface. `others`
/// says which bodies are tori, and which elements a text defines, here and below. Precondition: the ray is of the
/// scene.
std::vector<surface::exact::Crossing> all_crossings(const scene::Scene& scene, const scene::Query& ray,
                                                    const OtherElements& others = {});

class SceneTree;

/// The truths about many rays of one scene. A tree finds the elements of a scene that has many; the answers do not
/// depend on it. Many threads may ask.
class SceneTruths {
 public:
  /// The scene must outlive it unedited. `rays` is about how many are asked.
  SceneTruths(const scene::Scene& scene, std::size_t rays, const OtherElements& others = {});
  ~SceneTruths();  ///< lets go of the tree
  SceneTruths(const SceneTruths&) = delete;
  SceneTruths& operator=(const SceneTruths&) = delete;

  /// truth(). Precondition: the ray is of the scene.
  ExactAnswer of(const scene::Query& ray) const;
  /// The exact answer within the range: the first of all crossings there, and its permissible variants there. A stretch
  /// inside a surface that the range cuts begins or ends where the range does. Precondition: that of of().
  ExactAnswer within(const scene::Query& ray, const AskedRange& range) const;
  /// The t of all crossings, ascending, each rounded once: those of points, and both ends of stretches. Precondition:
  /// that of of().
  std::vector<double> crossings(const scene::Query& ray) const;
  /// of() together with every crossing. Precondition: that of of().
  ExactAnswer with_all(const scene::Query& ray) const;

 private:
  std::unique_ptr<const SceneTree> tree_;
};

/// The truth() of each ray, in order, by as many threads as the calling one may use. Precondition: the rays are of the
/// scene.
std::vector<ExactAnswer> truths(const scene::Scene& scene, std::span<const scene::Query> rays,
                                const OtherElements& others = {});
/// SceneTruths::with_all() of each ray, likewise.
std::vector<ExactAnswer> truths_with_all(const scene::Scene& scene, std::span<const scene::Query> rays,
                                         const OtherElements& others = {});
/// The nearest point of the scene to the origin of each ray, likewise: as a hit at the place with the distance for t,
/// of the elements that attain it. Several nearest points are a tie. Precondition: the scene has an element.
std::vector<ExactAnswer> truths_of_nearest(const scene::Scene& scene, std::span<const scene::Query> rays);
/// SceneTruths::within() of each ray, likewise. Precondition: there is a range for each ray.
std::vector<ExactAnswer> truths_within(const scene::Scene& scene, std::span<const scene::Query> rays,
                                       std::span<const AskedRange> ranges, const OtherElements& others = {});

}  // namespace durero::conform
