#include "durero/trace/segments.hpp"

#include "trace/triage.hpp"

namespace durero::trace {

bool blocks_segment(const scene::Scene& scene, const scene::Query& query, const Ray& ray, scene::ElementRef e) {
  const RootEstimate found = scene.visit(e, [&](const auto& element) {
    return ordinary(element) ? triage(element, ray, Origin(query.en).contains(e), 1)
                             : RootEstimate{Decision::undecided};
  });
  if (found.verdict == Decision::miss) return false;
  if (found.verdict == Decision::hit && found.hi + found.error < 1) return true;
  Counts unseen;
  return Search(scene, query.rayo, query.en, unseen).blocks_segment(e);
}

}  // namespace durero::trace
