#include <fmt/format.h>

#include "conform/ask/claim_rows.hpp"
#include "conform/ask/profile_reader.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/lines.hpp"

namespace durero::conform {
namespace {

using io::json::Reader;

enum ClaimKey : std::size_t { ray, outcome, in_case, element, t, point, normal_there, face, uv_there, why };
constexpr std::string_view keys[] = {"ray", "outcome", "case", "element", "t", "point", "normal", "face", "uv", "why"};
constexpr std::size_t required = 2;

/// The contents of a line: its claim, and the texts whose meaning depends on the case.
struct ClaimLine {
  std::string_view case_name, element_name;
  std::size_t case_at = 0, ray_at = 0, element_at = 0;
  double ray = 0;
  Claim claim;
};

constexpr std::array<std::string_view, 2> face_words = {"back", "front"};

glm::dvec2 read_uv(Reader& in) {
  const std::size_t at = in.offset();
  std::vector<double> read;
  in.array("uv", [&] { read.push_back(in.extended_number("uv")); });
  if (read.size() != 2) in.fail(at, fmt::format("uv has {} numbers", read.size()), "expected two");
  return {read[0], read[1]};
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
      row.claim.outcome = read_outcome(source, at, in.string("outcome"));
      return;
    case element:
      row.element_at = at;
      row.element_name = in.string("element");
      return;
    case t:
      row.claim.t = in.extended_number("t");
      return;
    case point:
      row.claim.punto = in.triple("point", [&] { return in.extended_number("point"); });
      return;
    case normal_there:
      row.claim.normal = in.triple("normal", [&] { return in.extended_number("normal"); });
      return;
    case face:
      row.claim.is_front = read_word<bool>(in, "face", face_words);
      return;
    case uv_there:
      row.claim.uv = read_uv(in);
      return;
    case why:
      row.claim.why = in.string("why");
  }
}

void read_row(const io::json::Document& document, std::size_t at, ClaimRows& rows) {
  Reader in(document);
  ClaimLine row;
  in.object("a claim", keys, required,
            [&](std::size_t key) { read_part(in, static_cast<ClaimKey>(key), rows.source(), row); });
  check_claim(rows.source(), at, row.claim);
  const bool has_case = row.case_at != 0;
  if (!has_case && rows.names_cases()) rows.source().fail(at, "key \"case\" is missing in a claim", "expected it");
  const std::size_t number = has_case ? rows.case_of(row.case_at, row.case_name) : 0;
  if (row.element_at != 0) row.claim.element = rows.element_of(row.element_at, number, row.element_name);
  rows.claim_on(row.ray_at, number, row.ray) = row.claim;
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
