#pragma once
/// Right tracers: values that say what each claims of itself and how it computes, and their answers, which are exact
/// ones of data moved by no more than is declared. Nothing of the judge's code is used.

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/families/suite.hpp"
#include "durero/scene/any_shape.hpp"
#include "durero/surface/exact.hpp"
#include "mover.hpp"

namespace durero::test {

using surface::exact::Parameter;

/// What data a tracer computes with.
enum class Data {
  given,    ///< those of the question
  rounded,  ///< each number rounded to the tracer's format
  ends,     ///< the ends of an axis, rounded so, in the place of its centre, unit vector and length
  moved     ///< each number moved, of each element in its own way
};
inline constexpr std::array<std::string_view, 4> data_words = {"given", "rounded", "ends", "moved"};

/// A tracer and what it claims. Its answer is exact but for what stands here.
struct RightTracer {
  conform::Profile profile;
  Data data = Data::given;
  Draw draw = Draw::anywhere;      ///< of moved data
  bool makes_unit = false;         ///< traces v/|v|, and multiplies
  bool counts_origin = false;      ///< t ≥ 0 for t > 0: what the origin lies on exactly is met there
  bool sees_beyond_least = false;  ///< answers a hit beyond a limit, which it need not
  bool sees_beyond_greatest = false;
  bool excludes_limits = false;  ///< a number that is a limit is beyond it
  bool answers_element = false;  ///< no number, where it names elements
  bool culls_backs = false;      ///< of flat elements, where its profile leaves them unseen
};

/// What a tracer claims, clause by clause. A new clause of a profile does not compile here until it is one of these.
/// Surfaces of a text, which no family has, are asked in judge/text_space_test.cpp.
inline std::map<std::string, std::string> clauses(const conform::Profile& profile) {
  const auto& [system, format, tipos, bodies, surfaces, caps, measure, directions, inside, error, thickness, least_t,
               greatest_t, least_size, greatest_size, greatest_coordinate, names_elements, half_spaces, touching,
               back_faces, watertight, normal, normal_length, faces, uv, questions, sources] = profile;
  const auto claimed = [](bool is) { return std::string(is ? "claimed" : "none"); };
  return {{"format", std::string(word(format))},
          {"tipos", claimed(tipos.size() < model::tipo_count)},
          {"bodies", claimed(bodies.size() == conform::body_count)},
          {"caps", std::string(word(caps))},
          {"measure", std::string(word(measure))},
          {"directions", std::string(word(directions))},
          {"inside", std::string(word(inside))},
          {"thickness", claimed(thickness > 0)},
          {"least_t", claimed(least_t > 0)},
          {"greatest_t", claimed(std::isfinite(greatest_t))},
          {"least_size", claimed(least_size > 0)},
          {"greatest_size", claimed(std::isfinite(greatest_size))},
          {"greatest_coordinate", claimed(std::isfinite(greatest_coordinate))},
          {"names_elements", claimed(names_elements)},
          {"error", claimed(error > conform::usual_error)},
          {"half_spaces", claimed(half_spaces)},
          {"touching", std::string(word(touching))},
          {"back_faces", std::string(word(back_faces))},
          {"watertight", claimed(watertight)},
          {"normal", std::string(word(normal))},
          {"normal_length", std::string(word(normal_length))},
          {"faces", claimed(faces)},
          {"uv", claimed(uv)},
          {"questions", claimed(questions.size() > 1)}};
}

/// Whether the element is a wall that discs close, to a tracer that has solids.
inline bool is_closed(const RightTracer& tracer, const conform::SuiteCase& of, scene::ElementRef element) {
  return tracer.profile.caps == conform::Caps::solid &&
         std::any_of(of.solids.begin(), of.solids.end(),
                     [&](const conform::Solid& solid) { return solid.wall == element; });
}

/// What a tracer may say of a point beside its place, in its own format.
struct Besides {
  std::optional<glm::dvec3> outward{};  ///< of length 1; nothing where there is none
  double against = 0;                   ///< less than 0 where the ray comes from the outward side
  std::optional<glm::dvec2> uv{};
};

/// Something that a tracer meets.
struct Met {
  scene::ElementRef element;
  model::Rayo rayo;
  std::optional<Parameter> t;  ///< nothing at the origin
  Besides besides{};           ///< what it may say besides

  double parameter() const { return t ? number::round_to_binary64(*t) : 0; }
};

inline bool is_earlier(const Met& a, const Met& b) {
  return a.t && b.t ? surface::exact::order(*a.t, *b.t) < 0 : !a.t && b.t;
}

/// t·|v|, where long double has room for squares of small numbers.
inline double length_of(double t, const glm::dvec3& v) {
  const long double x = v.x, y = v.y, z = v.z;
  return static_cast<double>(t * std::sqrt(x * x + y * y + z * z));
}

/// The distance that the tracer gives, or compares with its limits.
inline double distance(const RightTracer& tracer, const Met& met) {
  const double t = met.parameter();
  const bool is_length = tracer.profile.measure == conform::Measure::length;
  return narrowed(is_length ? length_of(t, met.rayo.v().xyz()) : t, tracer.profile.format);
}

/// Whether it is the back of a flat element.
inline bool is_back(const Met& met) {
  const bool is_flat = met.element.tipo == model::Tipo::soy_triangulo || met.element.tipo == model::Tipo::soy_disco ||
                       met.element.tipo == model::Tipo::soy_plano;
  return is_flat && met.besides.outward && met.besides.against > 0;
}

/// Whether the tracer passes it by. Its limits are numbers of its format, too.
inline bool passes_by(const RightTracer& tracer, const Met& met) {
  if (tracer.culls_backs && tracer.profile.back_faces == conform::BackFaces::unseen && is_back(met)) return true;
  const double x = distance(tracer, met), least = narrowed(tracer.profile.least_t, tracer.profile.format),
               greatest = narrowed(tracer.profile.greatest_t, tracer.profile.format);
  const bool is_limit = tracer.excludes_limits && ((least > 0 && x == least) || x == greatest);
  return (!tracer.sees_beyond_least && x < least) || (!tracer.sees_beyond_greatest && x > greatest) || is_limit;
}

/// What the tracer says beside the place, as its profile claims.
inline void add_besides(const conform::Profile& profile, const Besides& besides, conform::Claim& claim) {
  if (!besides.outward) return;
  const double side = profile.normal == conform::NormalSide::facing && besides.against > 0 ? -1 : 1;
  const double length = profile.normal_length == conform::NormalLength::any ? 8 : 1;
  if (profile.normal != conform::NormalSide::none) claim.normal = side * length * *besides.outward;
  if (profile.faces) claim.is_front = besides.against < 0;
  if (profile.uv) claim.uv = besides.uv;
}

/// What the tracer says of something that it meets; nothing where a number is none of its format.
inline std::optional<conform::Claim> hit_claim(const RightTracer& tracer, const Met& met) {
  conform::Claim claim{.outcome = conform::Claim::Outcome::hit};
  if (tracer.profile.names_elements) claim.element = met.element;
  if (tracer.answers_element && claim.element) return claim;
  add_besides(tracer.profile, met.besides, claim);
  const conform::NumberFormat format = tracer.profile.format;
  if (tracer.profile.measure == conform::Measure::point) {
    const glm::dvec3 w =
        met.t ? surface::exact::rounded_hit(met.rayo, *met.t, {met.element}).punto : met.rayo.p().xyz();
    claim.punto = glm::dvec3(narrowed(w.x, format), narrowed(w.y, format), narrowed(w.z, format));
    return std::isfinite(longest(*claim.punto)) ? std::optional(claim) : std::nullopt;
  }
  claim.t = distance(tracer, met);
  return claim;
}

/// Of what is met, what it says; nothing where a number is none of its format: then the tracer is not right.
inline std::optional<conform::Claim> claim_of(const RightTracer& tracer, std::vector<Met> all) {
  const auto is_number = [&](const Met& met) { return std::isfinite(distance(tracer, met)); };
  if (!std::all_of(all.begin(), all.end(), is_number)) return std::nullopt;
  std::erase_if(all, [&](const Met& met) { return passes_by(tracer, met); });
  const auto first = std::min_element(all.begin(), all.end(), is_earlier);
  if (first == all.end()) return conform::Claim{.outcome = conform::Claim::Outcome::miss};
  return hit_claim(tracer, *first);
}

/// All that it does not pass by, in order; nothing where a number is none of its format.
inline std::optional<conform::Claim> list_claim(const RightTracer& tracer, std::vector<Met> all) {
  std::erase_if(all, [&](const Met& met) { return passes_by(tracer, met); });
  std::stable_sort(all.begin(), all.end(), is_earlier);
  std::optional<conform::Claim> first;
  for (const Met& met : all) {
    const std::optional<conform::Claim> hit = hit_claim(tracer, met);
    if (!hit || !std::isfinite(distance(tracer, met))) return std::nullopt;
    if (first)
      first->behind.push_back(*hit);
    else
      first = hit;
  }
  return first ? first : conform::Claim{.outcome = conform::Claim::Outcome::miss};
}

/// The number of what it does not pass by.
inline conform::Claim count_claim(const RightTracer& tracer, std::vector<Met> all) {
  std::erase_if(all, [&](const Met& met) { return passes_by(tracer, met); });
  const bool is_hit = !all.empty();
  return {.outcome = is_hit ? conform::Claim::Outcome::hit : conform::Claim::Outcome::miss, .count = all.size()};
}

}  // namespace durero::test
