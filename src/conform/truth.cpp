#include "durero/conform/truth.hpp"

#include <algorithm>
#include <optional>

#include "conform/robust.hpp"
#include "durero/contract/contract.hpp"

namespace durero::conform {
namespace {

using surface::exact::Crossing;

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

/// Ascending. A stretch counts with both ends.
std::vector<Place> places(const AnsweredQuery& q) {
  std::vector<Place> all;
  for (const Crossing& crossing : surface::exact::all_hits(q.scene, q.query.rayo, q.query.en)) {
    const auto& [begin, end] = crossing.segment;
    const bool is_point = begin && end && surface::exact::order(*begin, *end) == 0;
    const Ambiguity weak = is_point ? weakness(candidate(q, crossing.elemento), *begin) : Ambiguity::in_surface;
    all.push_back({begin, crossing.elemento, weak});
    if (!is_point && end) all.push_back({end, crossing.elemento, weak});
  }
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

void add_each_alone(std::vector<scene::Hit>& to, const scene::Hit& hit) {
  if (hit.elementos.size() == 1) return;
  for (const scene::ElementRef e : hit.elementos) {
    to.push_back(hit);
    to.back().elementos = {e};
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

Truth truth(const scene::Scene& scene, const scene::Query& ray) {
  const AnsweredQuery asked{scene, ray, {}};
  const std::vector<Place> all = places(asked);
  if (all.empty()) return {};
  std::span<const Place> left = all;
  Meeting meeting = take_meeting(left);
  Truth found{hit_at(ray.rayo, meeting), ambiguity(meeting)};
  if (!meeting.front().t) {
    found.permissible.push_back(found.hit);
    found.hit = {.resultado = model::Resultado::no_minimum, .elementos = found.hit.elementos};
    add_each_alone(found.permissible, found.permissible.front());
  } else {
    add_each_alone(found.permissible, found.hit);
  }
  while (!is_robust(meeting)) {
    if (left.empty()) {
      found.permissible.emplace_back();
      break;
    }
    meeting = take_meeting(left);
    found.permissible.push_back(hit_at(ray.rayo, meeting));
    add_each_alone(found.permissible, scene::Hit(found.permissible.back()));
  }
  return found;
}

}  // namespace durero::conform
