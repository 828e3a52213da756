#include "conform/judge/torus_space.hpp"

#include <algorithm>

#include "conform/judge/torus.hpp"

namespace durero::conform {
namespace {

/// A parameter at which the ray is at an end of the space.
struct TubeEnd {
  TubeRoot at;
  bool is_outer;
};

/// The ray in the space between two tubes; the inner one may be none.
class TubeShell {
 public:
  TubeShell(const Torus& torus, const model::Rayo& rayo, const Dyadic& eta)
      : torus_(&torus), rayo_(&rayo), outer_(torus.radio() + eta), inner_(torus.radio() - eta) {
    take(outer_, true);
    if (number::sign(inner_) > 0) take(inner_, false);
    std::ranges::sort(ends_,
                      [](const TubeEnd& a, const TubeEnd& b) { return algebra::compare(a.at.root, b.at.root) < 0; });
  }

  /// All ends at t > 0, ascending.
  const std::vector<TubeEnd>& ends() const { return ends_; }

  /// Whether the ray is in the space between the end of that number and the one before, or behind the last.
  bool holds_before(std::size_t end) const {
    if (ends_.empty()) return holds_at(1);
    if (end == 0) return holds_at(algebra::below(ends_[0].at.root));
    if (end == ends_.size()) return holds_at(algebra::above(ends_.back().at.root));
    return holds_at(algebra::between(ends_[end - 1].at.root, ends_[end].at.root));
  }

 private:
  void take(const Dyadic& rho, bool is_outer) {
    for (TubeRoot& root : tube_roots(torus_->along(*rayo_, rho))) ends_.push_back({std::move(root), is_outer});
  }
  bool holds_at(const Dyadic& t) const {
    const glm::dvec3 &p = rayo_->p().xyz(), &v = rayo_->v().xyz();
    const Point<Dyadic> w{Dyadic(p.x) + t * Dyadic(v.x), Dyadic(p.y) + t * Dyadic(v.y), Dyadic(p.z) + t * Dyadic(v.z)};
    return number::sign(torus_->at(w, outer_)) <= 0 &&
           (number::sign(inner_) <= 0 || number::sign(torus_->at(w, inner_)) >= 0);
  }

  const Torus* torus_;
  const model::Rayo* rayo_;
  Dyadic outer_, inner_;
  std::vector<TubeEnd> ends_{};
};

}  // namespace

std::optional<std::vector<ShellStretch>> torus_stretches(const AskedBody& body, const model::Rayo& rayo,
                                                         const Dyadic& eta) {
  const Torus torus(body);
  if (!torus.is_tube(torus.radio() + eta)) return std::nullopt;
  const TubeShell shell(torus, rayo, eta);
  const std::vector<TubeEnd>& ends = shell.ends();
  std::vector<ShellStretch> found;
  std::optional<ShellStretch> open;
  if (shell.holds_before(0)) open = ShellStretch{{}, std::nullopt, most_meetings_of_torus};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!open) open = ShellStretch{ends[i].at.low, std::nullopt, most_meetings_of_torus};
    if (shell.holds_before(i + 1)) continue;  // behind a place where the ray touches an end, too
    open->end = ends[i].at.high;
    found.push_back(*std::exchange(open, std::nullopt));
  }
  if (open) found.push_back(*open);
  return found;
}

std::optional<BodyStretch> torus_zone(const AskedBody& body, const model::Rayo& rayo, const algebra::Root& crossing,
                                      const Dyadic& eta) {
  const Torus torus(body);
  if (!torus.is_tube(torus.radio() + eta) || !torus.is_tube(torus.radio() - eta)) return std::nullopt;
  const TubeShell shell(torus, rayo, eta);
  const auto after = std::ranges::find_if(
      shell.ends(), [&](const TubeEnd& end) { return algebra::compare(end.at.root, crossing) > 0; });
  if (after == shell.ends().begin() || after == shell.ends().end()) return std::nullopt;
  const TubeEnd& before = *std::prev(after);
  if (before.is_outer == after->is_outer) return std::nullopt;
  return BodyStretch{before.at.low, after->at.high};
}

}  // namespace durero::conform
