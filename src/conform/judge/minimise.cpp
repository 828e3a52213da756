#include "durero/conform/judge/minimise.hpp"

#include <cmath>
#include <limits>

#include "conform/judge/allowance.hpp"
#include "conform/judge/draft.hpp"

namespace durero::conform {
namespace {

/// The number of elements up to which each number of a draft is tried by itself.
constexpr std::size_t few = 32;

/// The search for a smaller failure: the smallest so far, and the condition that a smaller one must meet.
class FailureMinimiser {
 public:
  FailureMinimiser(const Finding& finding, const Profile& profile, const Ask& ask)
      : profile_(profile), ask_(ask), draft_(finding.of), best_(finding) {}

  /// Keeps the change where the system still fails with the same verdict. Returns whether it did.
  template <class Change>
  bool attempt(Change change) {
    Draft changed = draft_;
    change(changed);
    std::optional<SuiteCase> of = changed.built(best_.of);
    if (!of || !outside(*of, 0, profile_).empty()) return false;
    const Claim claim = ask_(*of);
    const ClaimJudgement judgement = judge(*of, 0, claim, profile_);
    if (judgement.verdict != best_.judgement.verdict) return false;
    draft_ = std::move(changed);
    best_ = {std::move(*of), 0, claim, judgement};
    return true;
  }

  const Draft& draft() const { return draft_; }
  Finding result() && { return std::move(best_); }

 private:
  const Profile& profile_;
  const Ask& ask_;
  Draft draft_;
  Finding best_;
};

/// Leaves out runs of elements that are not needed: halves of those that are there, then quarters, and so on.
void leave_out_runs(FailureMinimiser& search) {
  const auto left = [&] { return search.draft().elements.size(); };
  for (std::size_t size = left() / 2; size > 1; size /= 2) {
    for (std::size_t end = left(); end >= size && left() > size; end -= size) {
      search.attempt([&](Draft& draft) {
        const auto last = draft.elements.begin() + static_cast<std::ptrdiff_t>(end);
        draft.elements.erase(last - static_cast<std::ptrdiff_t>(size), last);
      });
    }
  }
}

void leave_out_elements(FailureMinimiser& search) {
  if (search.draft().elements.size() > few) leave_out_runs(search);
  for (std::size_t i = search.draft().elements.size(); i-- > 0;) {
    if (search.draft().elements.size() == 1) return;
    search.attempt(
        [&](Draft& draft) { draft.elements.erase(draft.elements.begin() + static_cast<std::ptrdiff_t>(i)); });
  }
}

void move_to_zero(FailureMinimiser& search) {
  search.attempt([](Draft& draft) { translate(draft, -*places(draft.elements.front().shape).points.front()); });
}

/// Scales v, so that its largest coordinate is from 1 to 2.
void round_length(FailureMinimiser& search) {
  search.attempt([](Draft& draft) { scale_direction(draft, std::ldexp(1, -std::ilogb(largest(draft.v)))); });
}

/// Moves the scene to the origin, and scales it to a size near 1.
void move_home(FailureMinimiser& search) {
  move_to_zero(search);
  search.attempt([](Draft& draft) {
    const Places of = places(draft.elements.front().shape);
    if (!of.lengths.empty()) scale(draft, -std::ilogb(*of.lengths.front()));
    if (!of.sides.empty()) scale(draft, -std::ilogb(largest(*of.sides.front())));
  });
  round_length(search);
}

bool straighten_axis(FailureMinimiser& search, std::size_t element) {
  for (const int coordinate : {2, 1, 0}) {
    for (const double sign : {1.0, -1.0}) {
      const bool is_straight = search.attempt([&](Draft& draft) {
        for (glm::dvec3* axis : places(draft.elements[element].shape).axes) {
          *axis = glm::dvec3(0);
          (*axis)[coordinate] = sign;
        }
      });
      if (is_straight) return true;
    }
  }
  return false;
}

void straighten_axes(FailureMinimiser& search) {
  for (std::size_t i = 0; i < search.draft().elements.size(); ++i) {
    Draft draft = search.draft();
    if (!places(draft.elements[i].shape).axes.empty()) straighten_axis(search, i);
  }
}

/// The number nearest to x with so many significant bits.
double shortened(double x, int bits) {
  if (x == 0) return x;
  const int unit = std::ilogb(x) - bits + 1;
  return std::ldexp(std::nearbyint(std::ldexp(x, -unit)), unit);
}

/// The numbers of a draft, in an order that stays while no element goes.
std::vector<double*> numbers(Draft& draft) {
  std::vector<double*> all;
  const auto add = [&](glm::dvec3& v) {
    for (int i = 0; i < 3; ++i) all.push_back(&v[i]);
  };
  for (Draft::Element& element : draft.elements) {
    const Places of = places(element.shape);
    for (glm::dvec3* point : of.points) add(*point);
    all.insert(all.end(), of.lengths.begin(), of.lengths.end());
    all.insert(all.end(), of.ratios.begin(), of.ratios.end());
  }
  add(draft.p);
  add(draft.v);
  const std::vector<double*> of_range = numbers_behind(draft);
  all.insert(all.end(), of_range.begin(), of_range.end());
  return all;
}

bool round_number(FailureMinimiser& search, std::size_t place) {
  Draft before = search.draft();
  const double x = *numbers(before)[place];
  const auto set = [&](double rounder) {
    return search.attempt([&](Draft& draft) { *numbers(draft)[place] = rounder; });
  };
  if (x == 0) return false;
  if (set(0)) return true;
  for (const int bits : {1, 2, 3, 4, 6, 9, 13, 18, 24, 32, 42}) {
    const double rounder = shortened(x, bits);
    if (rounder == x) return false;
    if (set(rounder)) return true;
  }
  return false;
}

/// Tries rounder numbers. Returns whether some number became rounder.
bool round_numbers(FailureMinimiser& search) {
  Draft draft = search.draft();
  const std::size_t count = numbers(draft).size();
  bool some = false;
  for (std::size_t place = 0; place < count; ++place) some = round_number(search, place) || some;
  return some;
}

}  // namespace

Finding tidied(const Finding& finding, const Profile& profile, const Ask& ask) {
  FailureMinimiser search(finding, profile, ask);
  leave_out_elements(search);
  round_length(search);
  move_to_zero(search);
  search.attempt([](Draft& draft) { scale_with_t(draft, -std::ilogb(size_of(draft))); });
  return std::move(search).result();
}

Finding minimised(const Finding& finding, const Profile& profile, const Ask& ask) {
  constexpr int most_rounds = 4;
  FailureMinimiser search(finding, profile, ask);
  leave_out_elements(search);
  if (search.draft().elements.size() > few) return std::move(search).result();  // elements of the case as they are
  move_home(search);
  straighten_axes(search);
  for (int round = 0; round < most_rounds && round_numbers(search); ++round) leave_out_elements(search);
  return std::move(search).result();
}

}  // namespace durero::conform
