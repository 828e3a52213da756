#include "conform/ask/answer_line.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <span>

#include "conform/ask/words.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/whole_number.hpp"

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

/// Reads the words of one hit of a line.
Claim read_hit(std::string_view line, std::span<const std::string_view> words, const scene::Scene& scene,
               bool is_grid) {
  if (words.size() < 3 || words.front() != "hit") return malformed(line, form_of_a_hit);
  Claim claim{.outcome = Claim::Outcome::hit};
  const bool is_whole_mesh = is_grid && words[1] == scene.meshes()[0].m.name();  // any of its triangles
  if (words[1] != "-" && !is_whole_mesh) {
    claim.element = scene.find(words[1]);
    if (!claim.element) return malformed(line, "the question has no such element");
  }
  const auto besides = std::ranges::find_if(words.begin() + 2, words.end(), begins_besides);
  std::string_view wrong = read_hit_numbers({words.begin() + 2, besides}, claim);
  if (wrong.empty()) wrong = read_besides({besides, words.end()}, claim);
  return wrong.empty() ? claim : malformed(line, wrong);
}

/// Reads a hit, or several with a semicolon between them.
Claim read_hits(std::string_view line, std::span<const std::string_view> words, const scene::Scene& scene,
                bool is_grid) {
  std::optional<Claim> first;
  for (;;) {
    const auto end = std::ranges::find(words, ";");
    Claim claim = read_hit(line, {words.begin(), end}, scene, is_grid);
    if (claim.outcome == Claim::Outcome::unanswered) return claim;
    if (first)
      first->behind.push_back(std::move(claim));
    else
      first = std::move(claim);
    if (end == words.end()) return *std::move(first);
    words = {end + 1, words.end()};
  }
}

/// Reads the number of all hits.
Claim read_number_of_hits(std::string_view line, std::span<const std::string_view> words) {
  const auto count = text::whole_number(words.size() == 2 ? words[1] : "");
  if (!count) return malformed(line, "a count is one whole number");
  return {.outcome = *count > 0 ? Claim::Outcome::hit : Claim::Outcome::miss, .count = *count};
}

}  // namespace

Claim malformed(std::string_view line, std::string_view wrong) {
  return {.why = fmt::format("malformed answer {}: {}", text::shown(line), wrong)};
}

Claim read_answer_line(std::string_view line, const scene::Scene& scene, bool is_grid) {
  const std::vector<std::string_view> words = words_of(line);
  if (words.empty()) return malformed(line, "the line is empty");
  if (words.front() == "refused") return {.why = text::escaped(fmt::format("{}", fmt::join(words, " ")))};
  if (words.front() == "hit") return read_hits(line, words, scene, is_grid);
  if (words.front() == "count") return read_number_of_hits(line, words);
  if (words.front() != "miss") return malformed(line, "it begins with none of miss, hit, count and refused");
  if (words.size() != 1) return malformed(line, "a miss is miss alone");
  return {.outcome = Claim::Outcome::miss};
}

}  // namespace durero::conform
