// The lines of claims: the lines that a system writes, and lines for rays that it did not answer.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "conform/ask/answer_line.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

using Outcome = Claim::Outcome;

std::string hit_text(const Claim& claim, const scene::Scene& scene) {
  const std::string element = claim.element ? scene.name(*claim.element).name() : "-";
  std::string line = fmt::format("hit {} {}", element, claim.t ? io::number_text(*claim.t) : "-");
  if (claim.punto) line += fmt::format(" {} {} {}", claim.punto->x, claim.punto->y, claim.punto->z);
  if (claim.normal) line += fmt::format(" normal {} {} {}", claim.normal->x, claim.normal->y, claim.normal->z);
  if (claim.is_front) line += *claim.is_front ? " front" : " back";
  if (claim.uv) line += fmt::format(" uv {} {}", claim.uv->x, claim.uv->y);
  for (const Claim& behind : claim.behind) line += " ; " + hit_text(behind, scene);
  return line;
}

}  // namespace

std::string claim_text(const Claim& claim, const scene::Scene& scene) {
  if (claim.count) return fmt::format("count {}", *claim.count);
  switch (claim.outcome) {
    case Outcome::hit:
      return hit_text(claim, scene);
    case Outcome::miss:
      return "miss";
    case Outcome::crashed:
      return "crashed " + claim.why;
    case Outcome::hung:
      return "hung " + claim.why;
    case Outcome::unanswered:
      return "unanswered " + claim.why;
  }
  contract::unreachable();
}

Claim read_claim(std::string_view text, const scene::Scene& scene) {
  const std::string_view word = text.substr(0, text.find(' '));
  const std::string why(text.substr(std::min(text.size(), word.size() + 1)));
  if (word == "crashed") return {.outcome = Outcome::crashed, .why = why};
  if (word == "hung") return {.outcome = Outcome::hung, .why = why};
  if (word == "unanswered") return {.outcome = Outcome::unanswered, .why = why};
  Claim claim = read_answer_line(text, scene);
  if (claim.outcome == Outcome::unanswered) throw std::invalid_argument(claim.why);
  return claim;
}

}  // namespace durero::conform
