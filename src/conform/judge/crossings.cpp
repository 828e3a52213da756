#include "conform/judge/crossings.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "conform/judge/error_of.hpp"
#include "conform/judge/limits.hpp"
#include "conform/judge/matching.hpp"
#include "conform/judge/normals.hpp"
#include "conform/judge/walls.hpp"
#include "durero/trace/search.hpp"

namespace durero::conform {
namespace {

using number::shifted;
using scene::ElementRef;
using surface::exact::order;

/// A hit of a list: its place, where it gives one, and the elements that it may be of.
struct ListedHit {
  const Claim* claim;
  std::optional<ClaimedPoint> where;
  std::vector<ElementRef> at;       ///< on which the place may lie; without a place, that some data meet
  std::vector<ElementRef> origins;  ///< the solids that it may answer the origin of

  bool is_of_some() const { return !at.empty() || !origins.empty(); }
};

bool has_place(const Claim& claim) { return claim.t || claim.punto; }

ListedHit listed(const ClaimContext& trial, const Claim& claim) {
  ListedHit hit{&claim, std::nullopt, {}, answered_origins(trial, claim)};
  if (!has_place(claim)) {
    trial.any_named(claim, [&](ElementRef element) {
      if (earliest_asked(trial, element)) hit.at.push_back(element);
      return false;
    });
    return hit;
  }
  hit.where = place(trial, claim);
  if (!hit.where) return hit;
  hit.at = elements_at(trial, claim, *hit.where);
  std::erase_if(hit.origins, [&](ElementRef element) { return !may_be_origin(trial, element, *hit.where); });
  return hit;
}

/// The hits of the list, in its order; a miss has none.
std::vector<const Claim*> claims_of(const Claim& claim) {
  if (claim.outcome == Claim::Outcome::miss) return {};
  std::vector<const Claim*> all{&claim};
  for (const Claim& behind : claim.behind) all.push_back(&behind);
  return all;
}

/// The error of the t of a place, times |v|, for the data of the element.
Dyadic own_error(const ClaimContext& trial, ElementRef element, const ClaimedPoint& where) {
  return Dyadic(where.deviation) * delta(trial.elements(), element, where, trial.ray.rayo, trial.precision());
}

/// Whether the hit may claim the crossing of the zone.
bool may_claim(const ClaimContext& trial, const ListedHit& hit, const Zone& zone) {
  if (std::ranges::find(hit.at, zone.element) == hit.at.end()) return false;
  if (!hit.where) return true;
  const Dyadic own = own_error(trial, zone.element, *hit.where);
  return !is_behind(*hit.where, own, zone, trial.ray.rayo) && !is_before(*hit.where, own, zone, trial.ray.rayo);
}

/// The number of zones that no hit claims, each hit one at most.
std::size_t unclaimed(const ClaimContext& trial, const std::vector<ListedHit>& hits, const std::vector<Zone>& zones) {
  Suiting suiting(zones.size());
  for (std::size_t i = 0; i < zones.size(); ++i) {
    for (std::size_t hit = 0; hit < hits.size(); ++hit) {
      if (may_claim(trial, hits[hit], zones[i])) suiting[i].push_back(hit);
    }
  }
  return Matching(suiting, hits.size()).left_out().size();
}

/// Whether the closed mesh around the origin has no hit, of a system that leaves none without.
bool lacks_mesh(const ClaimContext& trial, const std::vector<ListedHit>& hits) {
  const auto is_of_mesh = [](const ListedHit& hit) {
    return std::ranges::any_of(hit.at, [](ElementRef element) { return element.tipo == scene::Triangle::tipo; });
  };
  return wall_of_mesh(trial) && std::ranges::none_of(hits, is_of_mesh);
}

/// The meetings that there is room for on the elements of a list: of each stretch of a shell so many as the rays of
/// data may have there, and one at the origin of a solid.
class MeetingPlaces {
 public:
  explicit MeetingPlaces(const ClaimContext& trial) : trial_(&trial) {}

  /// The places that suit the hit.
  std::vector<std::size_t> suiting(const ListedHit& hit) {
    std::vector<std::size_t> all;
    for (const ElementRef element : hit.at) add_stretches(all, element, hit);
    for (const ElementRef element : hit.origins)
      all.push_back(origins_.try_emplace(element, count_).second ? count_++ : origins_.at(element));
    return all;
  }
  std::size_t count() const { return count_; }

 private:
  struct Room {
    ShellStretch stretch;
    std::size_t first;  // its places are this and those behind it
  };

  void add_stretches(std::vector<std::size_t>& to, ElementRef element, const ListedHit& hit) {
    const std::vector<Room>* const rooms = rooms_of(element);
    bool is_found = false;
    if (rooms != nullptr) {
      for (const Room& room : *rooms) {
        if (hit.where && !may_be_within(room.stretch, element, *hit.where)) continue;
        is_found = true;
        for (std::size_t i = 0; i < room.stretch.most; ++i) to.push_back(room.first + i);
      }
    }
    if (!is_found) to.push_back(count_++);  // it may be met anywhere, or just before the origin
  }

  /// The stretches of the element; null where it may be met anywhere.
  const std::vector<Room>* rooms_of(ElementRef element) {
    const auto [at, is_new] = rooms_.try_emplace(element);
    if (is_new) {
      const auto found = stretches(trial_->elements(), element, trial_->ray.rayo, trial_->precision());
      if (found) at->second.emplace();
      for (const ShellStretch& stretch : found.value_or(std::vector<ShellStretch>())) {
        at->second->push_back({stretch, count_});
        count_ += stretch.most;
      }
    }
    return at->second ? &*at->second : nullptr;
  }

  bool may_be_within(const ShellStretch& stretch, ElementRef element, const ClaimedPoint& where) const {
    const model::Rayo& rayo = trial_->ray.rayo;
    const Dyadic own = own_error(*trial_, element, where);
    return order(moved_by(where.t, own, rayo), stretch.begin) >= 0 &&
           (!stretch.end || order(moved_by(where.t, -own, rayo), *stretch.end) <= 0);
  }

  const ClaimContext* trial_;
  std::size_t count_ = 0;
  std::map<ElementRef, std::optional<std::vector<Room>>> rooms_{};
  std::map<ElementRef, std::size_t> origins_{};
};

/// Whether some hit finds no room for another meeting of its elements.
bool has_doubled(const ClaimContext& trial, const std::vector<ListedHit>& hits) {
  MeetingPlaces places(trial);
  Suiting suiting;
  for (const ListedHit& hit : hits) suiting.push_back(places.suiting(hit));
  return !Matching(suiting, places.count()).left_out().empty();
}

/// Whether a hit is certainly nearer than one before it in the list. Each t is off by its own error, and by 2δ/|v| for
/// a v and roundings of its own data.
bool is_unsorted(const ClaimContext& trial, const std::vector<ListedHit>& hits) {
  std::optional<surface::exact::Parameter> farthest;
  for (const ListedHit& hit : hits) {
    if (!hit.where || hit.at.empty()) continue;
    Dyadic off;
    for (const ElementRef element : hit.at) {
      const Dyadic delta_of = delta(trial.elements(), element, *hit.where, trial.ray.rayo, trial.precision());
      off = std::max(off, Dyadic(hit.where->deviation + 2) * delta_of);
    }
    if (farthest && order(moved_by(hit.where->t, off, trial.ray.rayo), *farthest) < 0) return true;
    const surface::exact::Parameter least = moved_by(hit.where->t, -off, trial.ray.rayo);
    if (!farthest || order(*farthest, least) < 0) farthest = least;
  }
  return false;
}

/// The verdict on a hit whose place lies on no element that it may name.
Verdict of_stray(const ClaimContext& trial, const ListedHit& hit) {
  if (!hit.where) return Verdict::phantom;
  const bool is_near =
      trial.any_named(*hit.claim, [&](ElementRef element) { return is_near_surface(trial, *hit.where, element); });
  if (is_near) return Verdict::off;
  const bool is_crossed = std::ranges::any_of(
      trial.truth.all, [&](const scene::Hit& truth) { return trial.names(*hit.claim, truth.elementos.front()); });
  return is_crossed ? Verdict::misplaced : Verdict::phantom;
}

/// Whether the list has every exact crossing, rounded once, in order, and no other.
bool is_exact_list(const ClaimContext& trial, const std::vector<const Claim*>& claims) {
  const std::vector<scene::Hit>& all = trial.truth.all;
  if (claims.size() != all.size()) return false;
  std::vector<bool> is_claimed(all.size(), false);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    // Crossings at one t have any order.
    const bool is_one = std::ranges::any_of(all, [&](const scene::Hit& truth) {
      const auto at = static_cast<std::size_t>(&truth - all.data());
      if (is_claimed[at] || truth.t != all[i].t || !is_exactly(trial, *claims[i], truth)) return false;
      is_claimed[at] = true;
      return true;
    });
    if (!is_one) return false;
  }
  return true;
}

/// The first verdict that is worse than right about what hits say besides their places.
Verdict verdict_besides_all(const ClaimContext& trial, const std::vector<ListedHit>& hits) {
  for (const ListedHit& hit : hits) {
    if (!hit.where || hit.at.empty() || !has_besides(*hit.claim)) continue;
    const Verdict is = verdict_besides(trial, *hit.claim, *hit.where, hit.at);
    if (is != Verdict::right) return is;
  }
  return Verdict::right;
}

Verdict verdict_of_places(const ClaimContext& trial, const std::vector<ListedHit>& hits) {
  std::size_t off = 0;
  for (const ListedHit& hit : hits) {
    if (hit.is_of_some()) continue;
    const Verdict is = of_stray(trial, hit);
    if (is != Verdict::off) return is;
    ++off;
  }
  // A hit that is a little off may stand for a crossing.
  const std::size_t missed = unclaimed(trial, hits, walls_of_elements(trial, trace::no_limit));
  if (missed > off || (off == 0 && lacks_mesh(trial, hits))) return Verdict::missed;
  if (off > 0) return Verdict::off;
  if (has_doubled(trial, hits)) return Verdict::doubled;
  return is_unsorted(trial, hits) ? Verdict::unsorted : Verdict::right;
}

/// The largest backward error of a hit of the list.
double largest_backward_error(const ClaimContext& trial, const std::vector<ListedHit>& hits) {
  double most = 0;
  for (const ListedHit& hit : hits) {
    if (hit.where && hit.origins.empty()) most = std::max(most, backward_error(trial, *hit.claim, *hit.where));
  }
  return most;
}

/// The greatest number of meetings of the element with the rays of any data.
std::size_t most_hits_of(const ClaimContext& trial, ElementRef element) {
  const auto found = stretches(trial.elements(), element, trial.ray.rayo, trial.precision());
  const std::size_t of_any = most_meetings_of(trial.elements(), element);
  if (!found) return of_any;
  std::size_t most = 0;
  for (const ShellStretch& stretch : *found) most += stretch.most;
  return std::min(most, of_any);
}

/// The least number of hits that a system must see.
std::size_t least_count(const ClaimContext& trial) {
  const std::vector<Zone> zones = walls_of_elements(trial, trace::no_limit);
  const bool has_mesh =
      std::ranges::any_of(zones, [](const Zone& zone) { return zone.element.tipo == scene::Triangle::tipo; });
  return zones.size() + (!has_mesh && wall_of_mesh(trial) ? 1 : 0);
}

}  // namespace

ClaimJudgement judgement_of_all(const ClaimContext& trial, const Claim& claim) {
  const std::vector<const Claim*> claims = claims_of(claim);
  const bool is_exact = is_exact_list(trial, claims);
  const bool has_more = std::ranges::any_of(claims, [](const Claim* hit) { return has_besides(*hit); });
  if (is_exact && !has_more) return {.verdict = Verdict::exact};
  std::vector<ListedHit> hits;
  for (const Claim* const hit : claims) {
    hits.push_back(listed(trial, *hit));
    if (has_place(*hit) && !hits.back().where) return {.verdict = Verdict::non_finite};
  }
  ClaimJudgement is{.verdict = is_exact ? Verdict::exact : verdict_of_places(trial, hits)};
  if (!is_exact) is.backward = largest_backward_error(trial, hits);
  const bool is_right = is.verdict == Verdict::exact || is.verdict == Verdict::right;
  const Verdict besides = is_right ? verdict_besides_all(trial, hits) : Verdict::right;
  if (besides != Verdict::right) is.verdict = besides;
  return is;
}

Verdict verdict_of_count(const ClaimContext& trial, const Claim& claim) {
  const std::uint64_t count = claim.count.value_or(0);
  if (count == trial.truth.all.size()) return Verdict::exact;
  if (count < least_count(trial)) return Verdict::wrong_count;
  std::size_t most = trial.profile.inside == Inside::origin ? trial.solids_around_origin().size() : 0;
  const bool is_reached = trial.scene.any_of([&](ElementRef element, const auto&) {
    most += most_hits_of(trial, element);
    return most >= count;
  });
  return is_reached || most >= count ? Verdict::right : Verdict::wrong_count;
}

}  // namespace durero::conform
