#pragma once
/// Whether a hit is right, as the Z text decides. The text knows the points of a ray by membership, not by enumeration;
/// but where along a ray its predicate can change from true to false it says itself (spec::alcance). So which
/// points they are, which of them is the reduction, that a miss is one and that no point is nearest is its word.

#include <optional>
#include <string>
#include <vector>

#include "durero/model/escena.hpp"
#include "durero/scene/hit.hpp"
#include "durero/scene/query.hpp"
#include "durero/scene/scene.hpp"
#include "durero/spec/ray.hpp"

namespace durero::spec {

/// Judges hits of the rays of one scene, to which it keeps a reference. Not for use by two threads at once.
class Confirmation {
 public:
  /// O(n log n) for n elements.
  explicit Confirmation(const scene::Scene& scene);

  /// Why the hit is not the answer to the query: the label of the predicate that is false, and what it says of the ray.
  /// Nothing where the hit is right, every bit of t and of the point included.
  std::optional<std::string> objection(const scene::Query& query, const scene::Hit& hit) const;

 private:
  struct Question;  // a ray, and what the text finds of it on each element

  std::set<model::Elemento> names(const scene::ElementSet& elements) const;
  std::optional<std::string> objection_to_hit(const Question& question, const scene::Hit& hit) const;
  static std::optional<std::string> objection_to_miss(const Question& question, const scene::Hit& hit);
  std::optional<std::string> objection_to_no_minimum(const Question& question, const scene::Hit& hit) const;
  std::set<model::Elemento> elements_at(const model::ExactPoint& point, const Question& question) const;

  const scene::Scene& scene_;
  model::Escena escena_;
  zed::Value theta_;  // θEscena
  Judge judge_;
};

}  // namespace durero::spec
