#pragma once
/// Small answered cases, and systems that answer them: right ones and wrong ones.

#include <algorithm>
#include <vector>

#include "durero/conform/report/tally.hpp"
#include "durero/scene/attributes.hpp"

namespace durero::test {

/// A profile that claims everything.
inline conform::Profile profile_of_all() {
  conform::Profile profile{.system = "tested"};
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { profile.tipos.push_back(Shape::tipo); });
  return profile;
}

/// Case `number` of a family, answered.
inline conform::SuiteCase answered_case(const char* family, std::uint64_t number,
                                        const conform::SuiteOptions& options = {}) {
  conform::SuiteCase of = conform::suite_case(options, *conform::find_family(family), number);
  conform::answer(of);
  return of;
}

/// The first cases of a family, so many at most, asked that question.
inline std::vector<conform::SuiteCase> asked_cases(const conform::Family& family, conform::QuestionKind question,
                                                   conform::NumberFormat numbers, std::uint64_t count) {
  const conform::SuiteOptions options{.rays = 1024, .numbers = numbers, .question = question};
  std::vector<conform::SuiteCase> all;
  for (std::uint64_t number = 0; number < std::min(count, conform::cases(options, family)); ++number) {
    all.push_back(conform::suite_case(options, family, number));
    conform::answer(all.back());
    conform::ask_question(all.back(), options);
  }
  return all;
}

/// What a right system says: the exact answer; of no minimum, that it hits at 0.
inline conform::Claim right_claim(const conform::ExactAnswer& truth) {
  using Outcome = conform::Claim::Outcome;
  if (truth.hit.resultado == model::Resultado::miss) return {Outcome::miss};
  if (truth.hit.resultado == model::Resultado::no_minimum) return {Outcome::hit, truth.hit.elementos[0], 0.0, {}};
  return {Outcome::hit, truth.hit.elementos[0], truth.hit.t, {}};
}

inline conform::Claims right_claims(const conform::SuiteCase& of) {
  conform::Claims claims;
  for (const conform::ExactAnswer& truth : of.truths) claims.push_back(right_claim(truth));
  return claims;
}

/// A system that sees no element whose radius is less than 1/2: one with an absolute epsilon.
inline conform::Claims claims_blind_to_small(const conform::SuiteCase& of) {
  conform::Claims claims = right_claims(of);
  for (std::size_t ray = 0; ray < claims.size(); ++ray) {
    if (!claims[ray].element) continue;
    const bool is_small = of.the_case.scene.visit(*claims[ray].element, []<class Shape>(const Shape& shape) {
      if constexpr (scene::has_attribute<Shape, &scene::AnyEscena::mi_radio>())
        return shape.radio < 0.5;
      else
        return false;
    });
    if (is_small) claims[ray] = {conform::Claim::Outcome::miss};
  }
  return claims;
}

}  // namespace durero::test
