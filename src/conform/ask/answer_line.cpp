#include "conform/ask/answer_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

#include "conform/ask/words.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

constexpr std::string_view form_of_a_hit = "a hit is ELEMENT T or ELEMENT T X Y Z";

/// The vector of the first words; nothing where they are too few, or one is no number.
template <class Vector>
std::optional<Vector> read_vector(std::span<const std::string_view> words) {
  Vector read;
  if (words.size() < static_cast<std::size_t>(Vector::length())) return std::nullopt;
  for (int i = 0; i < Vector::length(); ++i) {
    const std::optional<double> number = io::read_number(words[static_cast<std::size_t>(i)]);
    if (!number) return std::nullopt;
    read[i] = *number;
  }
  return read;
}

/// The fault in what a hit says besides, or an empty text. It is stored in the claim.
std::string_view read_besides(std::span<const std::string_view> words, Claim& claim) {
  while (!words.empty()) {
    const std::string_view what = words.front();
    words = words.subspan(1);
    if (what == "front" || what == "back") {
      claim.is_front = what == "front";
    } else if (what == "normal") {
      claim.normal = read_vector<glm::dvec3>(words);
      if (!claim.normal) return "NX NY NZ are no three numbers";
      words = words.subspan(3);
    } else if (what == "uv") {
      claim.uv = read_vector<glm::dvec2>(words);
      if (!claim.uv) return "U V are no two numbers";
      words = words.subspan(2);
    } else {
      return "a hit says besides normal NX NY NZ, front or back, and uv U V";
    }
  }
  return "";
}

bool begins_besides(std::string_view word) {
  return word == "normal" || word == "front" || word == "back" || word == "uv";
}

/// The fault in the numbers of a hit, T and then X Y Z, or an empty text. The numbers are stored in the claim.
std::string_view read_hit_numbers(std::span<const std::string_view> words, Claim& claim) {
  if (words.size() != 1 && words.size() != 4) return form_of_a_hit;
  if (words.front() != "-") {
    claim.t = io::read_number(words.front());
    if (!claim.t) return "T is no number";
  }
  if (words.size() == 1) return "";
  claim.punto = read_vector<glm::dvec3>(words.subspan(1));
  return claim.punto ? "" : "X Y Z are no three numbers";
}

Claim read_hit(std::string_view line, const scene::Scene& scene) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.size() < 3) return malformed(line, form_of_a_hit);
  Claim claim{.outcome = Claim::Outcome::hit};
  if (words[1] != "-") {
    claim.element = scene.find(words[1]);
    if (!claim.element) return malformed(line, "the question has no such element");
  }
  const auto besides = std::ranges::find_if(words.begin() + 2, words.end(), begins_besides);
  std::string_view wrong = read_hit_numbers({words.begin() + 2, besides}, claim);
  if (wrong.empty()) wrong = read_besides({besides, words.end()}, claim);
  return wrong.empty() ? claim : malformed(line, wrong);
}

}  // namespace

Claim malformed(std::string_view line, std::string_view wrong) {
  return {.why = fmt::format("malformed answer {}: {}", text::shown(line), wrong)};
}

Claim read_answer_line(std::string_view line, const scene::Scene& scene) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.empty()) return malformed(line, "the line is empty");
  if (words.front() == "refused") return {.why = text::escaped(fmt::format("{}", fmt::join(words, " ")))};
  if (words.front() == "hit") return read_hit(line, scene);
  if (words.front() != "miss") return malformed(line, "it begins with none of miss, hit and refused");
  if (words.size() != 1) return malformed(line, "a miss is miss alone");
  return {.outcome = Claim::Outcome::miss};
}

}  // namespace durero::conform
