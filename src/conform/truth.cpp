#include "durero/conform/truth.hpp"

#include <algorithm>
#include <optional>

#include "conform/robust.hpp"
#include "durero/contract/contract.hpp"

namespace durero::conform {
namespace {

/// A place where the ray meets an element: a point, or an end of a stretch inside it. Without t it is t → 0⁺.
struct Place {
  std::optional<Parameter> t;
  scene::ElementRef e;
  Ambiguity weakness;
};

bool at_one_point(const Place& a, const Place& b) {
  return a.t && b.t ? surface::exact::order(*a.t, *b.t) == 0 : a.t.has_value() == b.t.has_value();
}

bool earlier(const Place& a, const Place& b) {
  if (at_one_point(a, b)) return a.e < b.e;
  return !a.t || (b.t && surface::exact::order(*a.t, *b.t) < 0);
}

/// Of one element. A stretch counts with both its ends.
void add_places(std::vector<Place>& to, const Candidate& c) {
  const surface::exact::Reach reach = surface::exact::reach(c.f);
  for (const Parameter& t : reach.points()) to.push_back({t, c.e, weakness(c, t)});
  if (!reach.segment) return;
  to.push_back({reach.segment->begin, c.e, Ambiguity::in_surface});
  if (reach.segment->end) to.push_back({reach.segment->end, c.e, Ambiguity::in_surface});
}

/// Of all elements, ascending.
std::vector<Place> places(const AnsweredQuery& q) {
  std::vector<Place> all;
  q.scene.for_each([&](scene::ElementRef e, const auto&) {
    if (!certainly_missed(q, e)) add_places(all, candidate(q, e));
  });
  std::sort(all.begin(), all.end(), earlier);
  return all;
}

/// All that the ray meets at one point.
using Meeting = std::span<const Place>;

/// Takes the meeting that the places begin with from them. Precondition: there are some.
Meeting take_meeting(std::span<const Place>& left) {
  const auto beyond =
      std::find_if(left.begin(), left.end(), [&](const Place& place) { return !at_one_point(place, left.front()); });
  const Meeting meeting = left.first(static_cast<std::size_t>(beyond - left.begin()));
  left = left.subspan(meeting.size());
  return meeting;
}

bool is_robust(Meeting meeting) {
  return std::any_of(meeting.begin(), meeting.end(), [](const Place& p) { return p.weakness == Ambiguity::none; });
}

/// The first in this order that one of the meeting's crossings has; a tie where none has any.
Ambiguity ambiguity(Meeting meeting) {
  using enum Ambiguity;
  for (const Ambiguity weak : {in_surface, apex, edge, rim, tangent}) {
    if (std::any_of(meeting.begin(), meeting.end(), [&](const Place& p) { return p.weakness == weak; })) return weak;
  }
  return meeting.size() > 1 ? tie : none;
}

/// A stretch from t → 0⁺ begins at the origin.
scene::Hit hit_at(const model::Rayo& rayo, Meeting meeting) {
  const std::optional<Parameter>& t = meeting.front().t;
  scene::Hit hit{model::Resultado::hit, 0, rayo.p().xyz()};
  if (t) hit = surface::exact::rounded_hit(rayo, *t, {});
  for (const Place& place : meeting) hit.elementos.push_back(place.e);
  return hit;
}

void add_each_alone(std::vector<scene::Hit>& to, scene::Hit hit) {
  if (hit.elementos.size() == 1) return;
  const scene::ElementSet all = hit.elementos;
  for (const scene::ElementRef e : all) {
    hit.elementos = {e};
    to.push_back(hit);
  }
}

}  // namespace

std::string_view name(Ambiguity ambiguity) {
  switch (ambiguity) {
    case Ambiguity::none:
      return "none";
    case Ambiguity::tangent:
      return "tangent";
    case Ambiguity::rim:
      return "rim";
    case Ambiguity::edge:
      return "edge";
    case Ambiguity::apex:
      return "apex";
    case Ambiguity::tie:
      return "tie";
    case Ambiguity::in_surface:
      return "in_surface";
  }
  contract::unreachable();
}

Truth truth_of(const AnsweredQuery& q) {
  const model::Rayo& rayo = q.query.rayo;
  const std::vector<Place> all = places(q);
  if (all.empty()) return {};
  std::span<const Place> left = all;
  Meeting meeting = take_meeting(left);
  Truth found{q.hit, ambiguity(meeting)};
  if (!meeting.front().t) found.permissible.push_back(hit_at(rayo, meeting));
  add_each_alone(found.permissible, meeting.front().t ? found.hit : found.permissible.front());
  while (!is_robust(meeting)) {
    if (left.empty()) {
      found.permissible.emplace_back();
      break;
    }
    meeting = take_meeting(left);
    found.permissible.push_back(hit_at(rayo, meeting));
    add_each_alone(found.permissible, found.permissible.back());
  }
  return found;
}

Truth truth(const scene::Scene& scene, const scene::Query& ray) {
  return truth_of({scene, ray, surface::exact::first_hit(scene, ray.rayo, ray.en)});
}

}  // namespace durero::conform
