#include <fmt/format.h>

#include <span>

#include "conform/ask/claim_rows.hpp"
#include "conform/ask/profile_reader.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/whole_number.hpp"
#include "durero/io/lines.hpp"

namespace durero::conform {
namespace {

using io::json::Reader;

enum ClaimKey : std::size_t {
  ray,
  outcome,
  in_case,
  hits,
  count,
  why,
  element,
  t,
  point,
  normal_there,
  face,
  uv_there
};
constexpr std::string_view keys[] = {"ray",     "outcome", "case",  "hits",   "count", "why",
                                     "element", "t",       "point", "normal", "face",  "uv"};
constexpr std::size_t required = 2, first_of_hit = ClaimKey::element;

/// A hit, and the name of its element, whose meaning depends on the case.
struct HitPart {
  std::string_view element_name;
  std::size_t element_at = 0;
  Claim claim;
};

/// The contents of a line: its claim, and the texts whose meaning depends on the case.
struct ClaimLine {
  std::string_view case_name;
  std::size_t case_at = 0, ray_at = 0, hits_at = 0;
  double ray = 0;
  HitPart own;
  std::vector<HitPart> hits;  // all of them, where the line lists them
};

constexpr std::array<std::string_view, 2> face_words = {"back", "front"};

glm::dvec2 read_uv(Reader& in) {
  const std::size_t at = in.offset();
  std::vector<double> read;
  in.array("uv", [&] { read.push_back(in.extended_number("uv")); });
  if (read.size() != 2) in.fail(at, fmt::format("uv has {} numbers", read.size()), "expected two");
  return {read[0], read[1]};
}

/// Reads a key of a hit.
void read_hit_part(Reader& in, ClaimKey key, HitPart& hit) {
  switch (key) {
    case element:
      hit.element_at = in.offset();
      hit.element_name = in.string("element");
      return;
    case t:
      hit.claim.t = in.extended_number("t");
      return;
    case point:
      hit.claim.punto = in.triple("point", [&] { return in.extended_number("point"); });
      return;
    case normal_there:
      hit.claim.normal = in.triple("normal", [&] { return in.extended_number("normal"); });
      return;
    case face:
      hit.claim.is_front = read_word<bool>(in, "face", face_words);
      return;
    case uv_there:
      hit.claim.uv = read_uv(in);
      return;
    case ray:
    case outcome:
    case in_case:
    case hits:
    case count:
    case why:
      contract::unreachable();
  }
}

HitPart read_hit(Reader& in) {
  HitPart hit{.claim = {.outcome = Claim::Outcome::hit}};
  in.object("a hit", std::span(keys).subspan(first_of_hit), 0,
            [&](std::size_t key) { read_hit_part(in, static_cast<ClaimKey>(first_of_hit + key), hit); });
  return hit;
}

void read_part(Reader& in, ClaimKey key, const io::Source& source, ClaimLine& row) {
  const std::size_t at = in.offset();
  switch (key) {
    case in_case:
      row.case_at = at;
      row.case_name = in.string("case");
      return;
    case ray:
      row.ray_at = at;
      row.ray = in.number("ray");
      return;
    case outcome:
      row.own.claim.outcome = read_outcome(source, at, in.string("outcome"));
      return;
    case hits:
      row.hits_at = at;
      in.array("hits", [&] { row.hits.push_back(read_hit(in)); });
      return;
    case count:
      row.own.claim.count = io::json::whole_number(in, "count");
      return;
    case why:
      row.own.claim.why = in.string("why");
      return;
    case element:
    case t:
    case point:
    case normal_there:
    case face:
    case uv_there:
      read_hit_part(in, key, row.own);
  }
}

/// The claim of a hit, with its element.
Claim claim_of(const HitPart& hit, std::size_t in_case, const ClaimRows& rows) {
  Claim claim = hit.claim;
  if (hit.element_at != 0) claim.element = rows.element_of(hit.element_at, in_case, hit.element_name);
  return claim;
}

/// The claim of a line: its own hit, or those that it lists.
Claim claim_of(const ClaimLine& row, std::size_t in_case, const ClaimRows& rows) {
  if (row.hits_at == 0) return claim_of(row.own, in_case, rows);
  const Claim& own = row.own.claim;
  const bool has_own = row.own.element_at != 0 || own.t || own.punto || has_besides(own);
  if (own.outcome != Claim::Outcome::hit || has_own || row.hits.empty())
    rows.source().fail(row.hits_at,
                       fmt::format("hits beside the outcome {}{}", name(own.outcome),
                                   has_own            ? " and a hit"
                                   : row.hits.empty() ? ", and none of them"
                                                      : ""),
                       "expected them with the outcome hit, one at least, in the place of element, t and point");
  Claim claim = claim_of(row.hits.front(), in_case, rows);
  for (const HitPart& hit : std::span(row.hits).subspan(1)) claim.behind.push_back(claim_of(hit, in_case, rows));
  return claim;
}

void read_row(const io::json::Document& document, std::size_t at, ClaimRows& rows) {
  Reader in(document);
  ClaimLine row;
  in.object("a claim", keys, required,
            [&](std::size_t key) { read_part(in, static_cast<ClaimKey>(key), rows.source(), row); });
  check_claim(rows.source(), at, row.own.claim);
  const bool has_case = row.case_at != 0;
  if (!has_case && rows.names_cases()) rows.source().fail(at, "key \"case\" is missing in a claim", "expected it");
  const std::size_t number = has_case ? rows.case_of(row.case_at, row.case_name) : 0;
  const Claim claim = claim_of(row, number, rows);
  rows.claim_on(row.ray_at, number, row.ray) = claim;
}

}  // namespace

void read_claims_json(ClaimRows& rows) {
  const std::string_view text = rows.source().text();
  io::Lines lines(text);
  while (const auto line = lines.next()) {
    if (text.substr(line->begin, line->end - line->begin).find_first_not_of(" \t") == std::string_view::npos) continue;
    read_row(io::json::Document(rows.source(), line->begin, line->end), line->begin, rows);
  }
}

}  // namespace durero::conform
