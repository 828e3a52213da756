#include <algorithm>
#include <array>

#include "conform/ask/claim_rows.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

/// The columns of a claim.
struct ClaimColumns {
  enum Column : std::size_t { in_case, ray, outcome, element, t, x, y, z };
};
using Column = ClaimColumns::Column;
constexpr std::array<std::string_view, 8> columns = {"case", "ray", "outcome", "element", "t", "x", "y", "z"};

/// A field of a line: its offset, and its bytes without blanks around them.
struct CsvField {
  std::size_t offset = 0;
  std::string_view text;
};

std::vector<CsvField> fields_of(const io::Source& source, const io::TextLine& line) {
  std::vector<CsvField> fields;
  for (std::size_t begin = line.begin; begin <= line.end;) {
    const std::size_t end = std::min(source.text().find(',', begin), line.end);
    CsvField field{begin, source.text().substr(begin, end - begin)};
    while (!field.text.empty() && (field.text.front() == ' ' || field.text.front() == '\t')) {
      field.text.remove_prefix(1);
      ++field.offset;
    }
    while (!field.text.empty() && (field.text.back() == ' ' || field.text.back() == '\t')) field.text.remove_suffix(1);
    fields.push_back(field);
    begin = end + 1;
  }
  return fields;
}

/// The columns in the order in which the head names them.
std::vector<Column> read_head(const io::Source& source, const io::TextLine& line, bool names_cases) {
  std::vector<Column> head;
  for (const CsvField& field : fields_of(source, line)) {
    const auto* const known = std::ranges::find(columns, field.text);
    if (known == columns.end()) {
      source.fail(field.offset, "no column " + text::shown(field.text),
                  "expected case, ray, outcome, element, t, x, y or z");
    }
    const auto column = static_cast<Column>(known - columns.begin());
    if (std::ranges::find(head, column) != head.end())
      source.fail(field.offset, "a second column " + text::shown(field.text), "expected it once");
    head.push_back(column);
  }
  for (const Column column : {ClaimColumns::in_case, ClaimColumns::ray}) {
    if (column == ClaimColumns::in_case && !names_cases) continue;
    if (std::ranges::find(head, column) == head.end())
      source.fail(line.begin, "no column " + text::shown(columns[column]), "expected case and ray");
  }
  return head;
}

using FieldsOfRow =
    std::array<CsvField, columns.size()>;  // a field for each column; those that the head has not are empty

double number_in(const io::Source& source, const CsvField& field) {
  const auto value = io::read_number(field.text);
  if (!value) source.fail(field.offset, text::shown(field.text) + " in a claim", "expected a number");
  return *value;
}

Claim read_claim(const io::Source& source, std::size_t at, const FieldsOfRow& row) {
  Claim claim;
  if (!row[ClaimColumns::t].text.empty()) claim.t = number_in(source, row[ClaimColumns::t]);
  const auto given = [&](Column column) { return !row[column].text.empty(); };
  if (given(ClaimColumns::x) || given(ClaimColumns::y) || given(ClaimColumns::z))
    claim.punto = {number_in(source, row[ClaimColumns::x]), number_in(source, row[ClaimColumns::y]),
                   number_in(source, row[ClaimColumns::z])};
  if (given(ClaimColumns::outcome))
    claim.outcome = read_outcome(source, row[ClaimColumns::outcome].offset, row[ClaimColumns::outcome].text);
  else
    claim.outcome = claim.t || claim.punto || given(ClaimColumns::element) ? Claim::Outcome::hit : Claim::Outcome::miss;
  check_claim(source, at, claim);
  return claim;
}

void read_row(const io::TextLine& line, std::span<const Column> head, ClaimRows& rows) {
  const io::Source& source = rows.source();
  const std::vector<CsvField> fields = fields_of(source, line);
  if (fields.size() != head.size()) {
    source.fail(line.begin, std::to_string(fields.size()) + " fields",
                "expected " + std::to_string(head.size()) + ", as many as the head");
  }
  FieldsOfRow row;
  row.fill({line.begin, {}});
  for (std::size_t i = 0; i < head.size(); ++i) row[head[i]] = fields[i];
  Claim claim = read_claim(source, line.begin, row);
  const CsvField& in_case = row[ClaimColumns::in_case];
  const bool has_case = rows.names_cases() || !in_case.text.empty();
  const std::size_t number = has_case ? rows.case_of(in_case.offset, in_case.text) : 0;
  if (!row[ClaimColumns::element].text.empty())
    claim.element = rows.element_of(row[ClaimColumns::element].offset, number, row[ClaimColumns::element].text);
  rows.claim_on(row[ClaimColumns::ray].offset, number, number_in(source, row[ClaimColumns::ray])) = claim;
}

}  // namespace

void read_claims_csv(ClaimRows& rows) {
  io::Lines lines(rows.source().text());
  const auto first = lines.next();
  if (!first) rows.source().fail(0, "the file is empty", "expected a head that names the columns");
  const std::vector<Column> head = read_head(rows.source(), *first, rows.names_cases());
  while (const auto line = lines.next()) {
    if (line->begin != line->end) read_row(*line, head, rows);
  }
}

}  // namespace durero::conform
