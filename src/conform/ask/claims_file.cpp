#include "durero/conform/ask/claims_file.hpp"

#include <fmt/format.h>

#include "conform/ask/claim_rows.hpp"
#include "durero/io/file_name.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/whole_number.hpp"
#include "durero/io/rays/npy.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {

using Outcome = Claim::Outcome;

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::hit:
      return "hit";
    case Outcome::miss:
      return "miss";
    case Outcome::crashed:
      return "crashed";
    case Outcome::hung:
      return "hung";
    case Outcome::unanswered:
      return "unanswered";
  }
  contract::unreachable();
}

ClaimRows::ClaimRows(const io::Source& source, std::span<const SuiteCase> cases) : source_(&source), cases_(cases) {
  for (const SuiteCase& of : cases) {
    by_name_.emplace(of.name(), claims_.size());
    claims_.emplace_back(of.the_case.rays.size());
  }
}

std::size_t ClaimRows::case_of(std::size_t offset, std::string_view name) const {
  const auto at = by_name_.find(name);
  if (at == by_name_.end()) source_->fail(offset, "no case " + text::shown(name), "expected a case of the suite");
  return at->second;
}

scene::ElementRef ClaimRows::element_of(std::size_t offset, std::size_t in_case, std::string_view name) const {
  const auto element = cases_[in_case].the_case.scene.find(name);
  if (!element) source_->fail(offset, "no element " + text::shown(name), "expected an element of the scene");
  return *element;
}

Claim& ClaimRows::claim_on(std::size_t offset, std::size_t in_case, double ray) {
  Claims& claims = claims_[in_case];
  if (!io::is_whole(ray, 0, static_cast<double>(claims.size()) - 1)) {
    source_->fail(offset, fmt::format("ray {} of {}", ray, claims.size()), "expected a ray of the case, from 0");
  }
  Claim& claim = claims[static_cast<std::size_t>(ray)];
  if (claim.outcome != Outcome::unanswered)
    source_->fail(offset, fmt::format("ray {} has a claim already", ray), "expected one a ray");
  return claim;
}

Outcome read_outcome(const io::Source& source, std::size_t offset, std::string_view text) {
  for (const Outcome outcome : {Outcome::hit, Outcome::miss, Outcome::crashed, Outcome::hung}) {
    if (text == name(outcome)) return outcome;
  }
  source.fail(offset, "outcome is " + text::shown(text), "expected hit, miss, crashed or hung");
}

void check_claim(const io::Source& source, std::size_t offset, const Claim& claim) {
  if (claim.outcome != Outcome::hit && has_besides(claim))
    source.fail(offset, fmt::format("{} with normal, face or uv", name(claim.outcome)), "expected them of a hit alone");
  if (claim.count && (claim.outcome == Outcome::hit) != (*claim.count > 0))
    source.fail(offset, fmt::format("{} with count {}", name(claim.outcome), *claim.count),
                "expected a hit with a count from 1, or a miss with 0");
  if (claim.outcome == Outcome::hit || (!claim.t && !claim.punto)) return;
  source.fail(offset, fmt::format("{} with t or point", name(claim.outcome)), "expected them of a hit alone");
}

std::vector<Claims> read_claims(const io::Source& source, std::span<const SuiteCase> cases) {
  ClaimRows rows(source, cases);
  if (io::is_npy(source.text()) || io::ends_in(source.name(), ".npy"))
    read_claims_npy(rows);
  else if (io::ends_in(source.name(), ".csv"))
    read_claims_csv(rows);
  else
    read_claims_json(rows);
  return std::move(rows).take();
}

namespace {

void write_hit(io::json::Writer& out, const scene::Scene& scene, const Claim& hit) {
  if (hit.element) out.member("element", scene.name(*hit.element).name());
  if (hit.t) out.member("t", *hit.t);
  if (hit.punto) out.member("point", *hit.punto);
  if (hit.normal) out.member("normal", *hit.normal);
  if (hit.is_front) out.member("face", *hit.is_front ? "front" : "back");
  if (hit.uv) out.key("uv").begin_array().value(hit.uv->x).value(hit.uv->y).end_array();
}

}  // namespace

std::string claim_json(const SuiteCase& of, std::size_t ray, const Claim& claim) {
  std::string text;
  io::json::Writer out(text);
  out.begin_object().member("case", of.name()).member("ray", ray).member("outcome", name(claim.outcome));
  if (claim.count) out.member("count", *claim.count);
  if (claim.behind.empty()) {
    write_hit(out, of.the_case.scene, claim);
  } else {
    out.key("hits").begin_array();
    write_hit(out.begin_object(), of.the_case.scene, claim);
    out.end_object();
    for (const Claim& behind : claim.behind) {
      write_hit(out.begin_object(), of.the_case.scene, behind);
      out.end_object();
    }
    out.end_array();
  }
  if (!claim.why.empty()) out.member("why", claim.why);
  out.end_object();
  return text;
}

}  // namespace durero::conform
