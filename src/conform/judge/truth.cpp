#include "durero/conform/judge/truth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "conform/judge/robust.hpp"
#include "conform/judge/scene_tree.hpp"
#include "durero/composed/solid.hpp"
#include "durero/contract/contract.hpp"
#include "durero/distance/distances.hpp"
#include "durero/trace/search.hpp"

namespace durero::conform {
namespace {

/// A place where the ray meets an element: a point, or an end of a stretch inside the surface. Without t it is t → 0⁺.
struct ElementMeeting {
  std::optional<Parameter> t;
  scene::ElementRef e;
  Ambiguity weakness;
};

bool at_one_point(const ElementMeeting& a, const ElementMeeting& b) {
  return a.t && b.t ? surface::exact::order(*a.t, *b.t) == 0 : a.t.has_value() == b.t.has_value();
}

bool earlier(const ElementMeeting& a, const ElementMeeting& b) {
  if (!a.t || !b.t) return std::pair(a.t.has_value(), a.e) < std::pair(b.t.has_value(), b.e);
  const auto by_t = surface::exact::order(*a.t, *b.t);
  return by_t != 0 ? by_t < 0 : a.e < b.e;
}

/// The points t > 0 of an element, or the stretch of the ray inside its surface.
struct ElementPlaces {
  std::vector<ElementMeeting> points{};
  std::optional<surface::exact::Segment> segment{};
};

ElementPlaces places_of(const ElementQuadratic& c) {
  const surface::exact::Reach reach = surface::exact::reach(c.f);
  ElementPlaces all{{}, reach.segment};
  for (const Parameter& t : reach.points()) all.points.push_back({t, c.e, weakness(c, t)});
  return all;
}

/// The same of a body, which is convex: a line that has one point of it touches it, and a ray that runs along it has
/// one stretch of it.
ElementPlaces places_of(const composed::Figure& figure, scene::ElementRef e, const scene::Query& ray) {
  const bool on = scene::Origin(ray.en).contains(e);
  const auto points = figure.parameters(ray.rayo, on, surface::exact::RayStretch::whole);
  if (!points) {
    const auto inside = dynamic_cast<const composed::SolidFigure&>(figure).inside(ray.rayo, on);
    return {{}, inside.at(0)};
  }
  const model::Rayo back(ray.rayo.p(), model::Vector(-ray.rayo.v().xyz()));
  const bool touches = points->size() == 1 && !figure.first(back, on).t;
  ElementPlaces all;
  for (const Parameter& t : *points) all.points.push_back({t, e, touches ? Ambiguity::tangent : Ambiguity::none});
  return all;
}

/// The places on a torus, in which no line lies. At a root that more than one crossing has, the line touches it.
ElementPlaces places_of(const Torus& torus, scene::ElementRef e, const scene::Query& ray) {
  ElementPlaces all;
  for (const TubeRoot& root : tube_roots(torus.along(ray.rayo, torus.radio())))
    all.points.push_back({crossing_at(root), e, root.is_touched ? Ambiguity::tangent : Ambiguity::none});
  return all;
}

/// The places on a surface of a text. A stretch in it is one from its beginning on, since any place there is as good.
ElementPlaces places_of(const AskedSurface& surface, scene::ElementRef e, const scene::Query& ray) {
  ElementPlaces all;
  const auto roots = surface.points.parameters(ray.rayo, false, written::RayPart::whole);
  if (roots) {
    for (const algebra::Root& root : *roots) all.points.push_back({crossing_at(root), e, Ambiguity::none});
    return all;
  }
  const written::First first = surface.points.first(ray.rayo, false);
  if (const auto* const root = std::get_if<algebra::Root>(&first))
    all.points.push_back({crossing_at(*root), e, Ambiguity::in_surface});
  if (const auto* const after = std::get_if<written::After>(&first))
    all.segment =
        surface::exact::Segment{after->t ? std::optional(crossing_at(*after->t)) : std::nullopt, std::nullopt};
  return all;
}

ElementPlaces places_of(const SceneTree& tree, const AnsweredQuery& query, scene::ElementRef e) {
  if (const AskedSurface* const surface = tree.surface(e)) return places_of(*surface, e, query.query);
  if (const Torus* const torus = tree.torus(e)) return places_of(*torus, e, query.query);
  const composed::Figure* const figure = tree.figure(e);
  return figure ? places_of(*figure, e, query.query) : places_of(quadratic(query, e));
}

/// The places of one element are added to the list; a stretch counts with both its ends.
void add_places(std::vector<ElementMeeting>& to, scene::ElementRef e, const ElementPlaces& places) {
  to.insert(to.end(), places.points.begin(), places.points.end());
  if (!places.segment) return;
  to.push_back({places.segment->begin, e, Ambiguity::in_surface});
  if (places.segment->end) to.push_back({places.segment->end, e, Ambiguity::in_surface});
}

/// The places of one element within the range.
void add_places_within(std::vector<ElementMeeting>& to, scene::ElementRef e, const ElementPlaces& places,
                       const AskedRange& range) {
  const Parameter begin{.x = range.begin};
  const bool is_endless = std::isinf(range.end);
  const auto is_before_end = [&](const Parameter& t) {
    return is_endless || surface::exact::order(t, {.x = range.end}) <= 0;
  };
  for (const ElementMeeting& place : places.points) {
    if (surface::exact::order(*place.t, begin) >= 0 && is_before_end(*place.t)) to.push_back(place);
  }
  if (!places.segment) return;
  auto [first, last] = *places.segment;
  if (range.begin > 0 && (!first || surface::exact::order(*first, begin) < 0)) first = begin;
  if (!is_endless && (!last || !is_before_end(*last))) last = Parameter{.x = range.end};
  const Parameter& from = first ? *first : begin;
  if (last && (surface::exact::order(from, *last) > 0 || number::sign(*last) <= 0)) return;
  to.push_back({first, e, Ambiguity::in_surface});
  if (last) to.push_back({last, e, Ambiguity::in_surface});
}

/// The places within the range on all elements, ascending.
std::vector<ElementMeeting> places_within(const SceneTree& tree, const scene::Query& ray, const AskedRange& range) {
  std::vector<ElementMeeting> all;
  if (range.begin > range.end) return all;
  const AnsweredQuery query{tree.scene(), ray, {}};
  trace::Counts counts;
  const trace::Search search(tree.scene(), ray.rayo, ray.en, counts);
  const auto look_at = [&](scene::ElementRef e) {
    const bool is_other = tree.is_other(e);
    const std::optional<trace::Meeting> met = is_other ? std::nullopt : search.certified_meeting(e, range.end);
    if (!met || met->kind != trace::Meeting::Kind::none) add_places_within(all, e, places_of(tree, query, e), range);
  };
  tree.along(
      search.ray(), ray.en, [&] { return range.end; }, look_at);
  std::sort(all.begin(), all.end(), earlier);
  return all;
}

/// The limit beyond which nothing is permissible: the nearest crossing that no small change removes, rounded up;
/// infinity without such a crossing.
double limit_by(const std::vector<ElementMeeting>& places) {
  double limit = trace::no_limit;
  for (const ElementMeeting& place : places) {
    if (place.t && place.weakness == Ambiguity::none) limit = std::min(limit, rounded_up(*place.t));
  }
  return limit;
}

/// The view along a ray: the elements that it may meet first, with bounds on the distance as far as the steps before
/// the exact one tell. A meeting that they certify remains where the data change a little, and so all that lies behind
/// the nearest such meeting is left out.
class Sight {
 public:
  Sight(const SceneTree& tree, const scene::Query& ray) : tree_(&tree), query_{tree.scene(), ray, {}} {
    tree.along(
        search_.ray(), ray.en, [&] { return limit_; }, [&](scene::ElementRef e) { look_at(e); });
    std::vector<scene::ElementRef> again;
    std::swap(again, unclear_);
    for (const scene::ElementRef e : again) look_at(e);  // the lower limit may exclude it
    leave_out_beyond_limit();
  }
  Sight(const Sight&) = delete;  // the search refers to members
  Sight& operator=(const Sight&) = delete;

  /// The exact hit, where these steps decide it; otherwise nothing.
  std::optional<scene::Hit> clear_hit() const {
    if (!unclear_.empty() || met_.size() > 1) return std::nullopt;
    if (met_.empty()) return scene::Hit{};
    const trace::RoundedPoint rounded = search_.rounded_hit(met_.front().first, met_.front().second);
    return scene::Hit{model::Resultado::hit, rounded.t, rounded.punto, {met_.front().first}};
  }

  /// The exact places, ascending, on the elements that are not excluded.
  std::vector<ElementMeeting> places() {
    std::vector<ElementMeeting> all;
    for (const scene::ElementRef e : unclear_) add_places(all, e, places_of(*tree_, query_, e));
    limit_ = std::min(limit_, limit_by(all));
    leave_out_beyond_limit();
    for (const auto& [e, at] : met_) add_places(all, e, places_of(quadratic(query_, e)));
    std::sort(all.begin(), all.end(), earlier);
    return all;
  }

 private:
  void look_at(scene::ElementRef e) {
    if (tree_->is_other(e)) return unclear_.push_back(e);
    std::optional<trace::Meeting> met = search_.certified_meeting(e, limit_);
    if (!met) return unclear_.push_back(e);
    if (met->kind == trace::Meeting::Kind::none) return;
    limit_ = std::min(limit_, met->high);
    met_.emplace_back(e, *std::move(met));
  }
  void leave_out_beyond_limit() {
    std::erase_if(met_, [&](const auto& met) { return met.second.low > limit_; });
  }

  const SceneTree* tree_;
  AnsweredQuery query_;
  trace::Counts counts_{};
  trace::Search search_{query_.scene, query_.query.rayo, query_.query.en, counts_};
  double limit_ = trace::no_limit;
  std::vector<std::pair<scene::ElementRef, trace::Meeting>> met_{};
  std::vector<scene::ElementRef> unclear_{};
};

/// A meeting is the set of places where the ray meets elements at one point.
using Meeting = std::span<const ElementMeeting>;

/// The first meeting, which is removed from the front of the places. Precondition: there are some.
Meeting take_meeting(std::span<const ElementMeeting>& left) {
  const auto beyond = std::find_if(left.begin(), left.end(),
                                   [&](const ElementMeeting& place) { return !at_one_point(place, left.front()); });
  const Meeting meeting = left.first(static_cast<std::size_t>(beyond - left.begin()));
  left = left.subspan(meeting.size());
  return meeting;
}

bool is_robust(Meeting meeting) {
  return std::any_of(meeting.begin(), meeting.end(), [](const auto& p) { return p.weakness == Ambiguity::none; });
}

/// The ambiguity of a meeting: the first in this order that one of its crossings has. Several crossings without any are
/// a tie.
Ambiguity ambiguity(Meeting meeting) {
  using enum Ambiguity;
  for (const Ambiguity weak : {in_surface, apex, edge, rim, tangent}) {
    if (std::any_of(meeting.begin(), meeting.end(), [&](const ElementMeeting& p) { return p.weakness == weak; }))
      return weak;
  }
  return meeting.size() > 1 ? tie : none;
}

/// The hit at a meeting, with all its elements; a stretch from t → 0⁺ begins at the origin.
scene::Hit hit_at(const model::Rayo& rayo, Meeting meeting) {
  const std::optional<Parameter>& t = meeting.front().t;
  scene::Hit hit{model::Resultado::hit, 0, rayo.p().xyz()};
  if (t) hit = surface::exact::rounded_hit(rayo, *t, {});
  for (const ElementMeeting& place : meeting) hit.elementos.push_back(place.e);
  return hit;
}

/// The exact answer for the first meeting; a stretch from t → 0⁺ has no nearest point.
scene::Hit answer_at(const scene::Hit& first, Meeting meeting) {
  if (meeting.front().t) return first;
  return {.resultado = model::Resultado::no_minimum, .elementos = first.elementos};
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

namespace {

/// The answer where the ray meets these places, ascending, or where what lies behind them is not permissible.
ExactAnswer answer_of(const scene::Query& ray, const std::vector<ElementMeeting>& all) {
  if (all.empty()) return {};
  std::span<const ElementMeeting> left = all;
  Meeting meeting = take_meeting(left);
  const scene::Hit first = hit_at(ray.rayo, meeting);
  ExactAnswer found{answer_at(first, meeting), ambiguity(meeting)};
  if (!meeting.front().t) found.permissible.push_back(first);
  add_each_alone(found.permissible, first);
  while (!is_robust(meeting)) {
    if (left.empty()) {
      found.permissible.emplace_back();
      break;
    }
    meeting = take_meeting(left);
    found.permissible.push_back(hit_at(ray.rayo, meeting));
    add_each_alone(found.permissible, found.permissible.back());
  }
  return found;
}

ExactAnswer truth_by(const SceneTree& tree, const scene::Query& ray) {
  Sight sight(tree, ray);
  if (const auto hit = sight.clear_hit()) return {*hit};
  return answer_of(ray, sight.places());
}

}  // namespace

ExactAnswer truth(const scene::Scene& scene, const scene::Query& ray) { return truth_by({scene, 1}, ray); }

SceneTruths::SceneTruths(const scene::Scene& scene, std::size_t rays, const OtherElements& others)
    : tree_(std::make_unique<const SceneTree>(scene, rays, others)) {}
SceneTruths::~SceneTruths() = default;

ExactAnswer SceneTruths::of(const scene::Query& ray) const { return truth_by(*tree_, ray); }

ExactAnswer SceneTruths::within(const scene::Query& ray, const AskedRange& range) const {
  return answer_of(ray, places_within(*tree_, ray, range));
}

std::vector<double> SceneTruths::crossings(const scene::Query& ray) const {
  std::vector<double> all;
  for (const ElementMeeting& place : places_within(*tree_, ray, {}))
    all.push_back(place.t ? number::round_to_binary64(*place.t) : 0);
  return all;
}

std::vector<surface::exact::Crossing> all_crossings(const scene::Scene& scene, const scene::Query& ray,
                                                    const OtherElements& others) {
  if (!scene.has_bodies() && others.surfaces.empty()) return surface::exact::all_hits(scene, ray.rayo, ray.en);
  const SceneTree tree(scene, 1, others);
  const AnsweredQuery query{scene, ray, {}};
  std::vector<surface::exact::Crossing> all;
  scene.for_each([&](scene::ElementRef e, const auto&) {
    const ElementPlaces places = places_of(tree, query, e);
    for (const ElementMeeting& place : places.points) all.push_back({e, {place.t, place.t}});
    if (places.segment) all.push_back({e, *places.segment});
  });
  const auto begins_before = [](const auto& a, const auto& b) {
    const auto &s = a.segment.begin, &t = b.segment.begin;
    return s && t ? surface::exact::order(*s, *t) < 0 : !s && t;
  };
  std::ranges::stable_sort(all, begins_before);
  return all;
}

ExactAnswer SceneTruths::with_all(const scene::Query& ray) const {
  const std::vector<ElementMeeting> places = places_within(*tree_, ray, {});
  ExactAnswer found = answer_of(ray, places);
  for (const ElementMeeting& place : places) found.all.push_back(hit_at(ray.rayo, {&place, 1}));
  return found;
}

namespace {

/// The answer of each ray by its number, by many threads.
template <class Answer>
std::vector<ExactAnswer> answers(std::size_t rays, Answer answer) {
  std::vector<ExactAnswer> all(rays);
  trace::for_each_block(rays, [&](std::size_t begin, std::size_t count) {
    for (std::size_t ray = begin; ray < begin + count; ++ray) all[ray] = answer(ray);
  });
  return all;
}

}  // namespace

std::vector<ExactAnswer> truths(const scene::Scene& scene, std::span<const scene::Query> rays,
                                const OtherElements& others) {
  const SceneTruths of_scene(scene, rays.size(), others);
  return answers(rays.size(), [&](std::size_t ray) { return of_scene.of(rays[ray]); });
}

std::vector<ExactAnswer> truths_with_all(const scene::Scene& scene, std::span<const scene::Query> rays,
                                         const OtherElements& others) {
  const SceneTruths of_scene(scene, rays.size(), others);
  return answers(rays.size(), [&](std::size_t ray) { return of_scene.with_all(rays[ray]); });
}

std::vector<ExactAnswer> truths_of_nearest(const scene::Scene& scene, std::span<const scene::Query> rays) {
  const distance::Distances distances(scene);
  return answers(rays.size(), [&](std::size_t ray) {
    distance::DistanceWork work;
    const scene::Proximity is = distances.nearest(rays[ray].rayo.p().xyz(), work);
    const bool is_one = is.count == scene::NearestCount::one && is.elementos.size() == 1;
    return ExactAnswer{{model::Resultado::hit, is.distance, is.point, is.elementos},
                       is_one ? Ambiguity::none : Ambiguity::tie};
  });
}

std::vector<ExactAnswer> truths_within(const scene::Scene& scene, std::span<const scene::Query> rays,
                                       std::span<const AskedRange> ranges, const OtherElements& others) {
  const SceneTruths of_scene(scene, rays.size(), others);
  return answers(rays.size(), [&](std::size_t ray) { return of_scene.within(rays[ray], ranges[ray]); });
}

}  // namespace durero::conform
