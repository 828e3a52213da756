/// What each step of the search answers of one ray and a few elements, as a table: the search of the program and the
/// one extracted from proofs/Search.v run on the same.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "durero/trace/search.hpp"
#include "trace/ends.hpp"
#include "trace/search-inl.hpp"

namespace durero::test {

/// The ends of every parameter of a table, and so the limits that a step is asked with: an entry of a step a limit.
inline constexpr std::array limits{-trace::no_limit,
                                   -1.0,
                                   -0.0,
                                   0.0,
                                   0.5,
                                   0x1.fffffffffffffp-1,
                                   1.0,
                                   0x1.0000000000001p0,
                                   1.5,
                                   std::numeric_limits<double>::max(),
                                   trace::no_limit,
                                   std::numeric_limits<double>::quiet_NaN()};
using Limit = std::size_t;  ///< a place in limits

/// By its bits: 0 is not −0.
inline Limit limit_of(double x) {
  for (Limit i = 0; i < limits.size(); ++i) {
    if (std::bit_cast<std::uint64_t>(limits[i]) == std::bit_cast<std::uint64_t>(x)) return i;
  }
  throw std::logic_error("a step is asked with a limit that is an end of nothing");
}

/// What a step says: miss, undecided, or a hit with that finding.
using Answer = int;
inline constexpr Answer miss = -1, undecided = -2;
/// What the exact step says: nothing, no minimum, or that parameter.
inline constexpr int nothing = -1, no_minimum = -2;
/// What is rounded has this name, or is not certain.
inline constexpr int uncertain = -1;

struct TableElement {
  bool on, in_range;
  std::array<Answer, limits.size()> triage, stable;  ///< by limit
  std::vector<Answer> improved;                      ///< by finding
  std::vector<int> rounded;                          ///< by finding
  int reach;
  auto operator<=>(const TableElement&) const = default;
};
struct TableFinding {
  Limit triage_low, triage_high, stable_low, stable_high;
  int rank;                          ///< the less goes ahead
  std::vector<bool> certainly_less;  ///< than that finding
};
/// (num + coef·√rad)/den; no two of a table are written alike, but they may be equal.
struct TableParameter {
  int num, coef, rad, den;
  Limit low, high;
  int rounded;
};

struct StepTable {
  std::vector<TableElement> elements;  ///< tested in this order
  std::vector<TableFinding> findings;
  std::vector<TableParameter> parameters;
};

/// The steps of trace/search-inl.hpp. The place of a finding is its hi; what is rounded has its name as t.
struct TableSteps {
  using Element = TableElement;
  using Parameter = trace::Parameter;
  const StepTable& table;

  const Element& element(scene::ElementRef e) const { return table.elements.at(e.index); }
  const TableFinding& finding(const trace::RootEstimate& f) const {
    return table.findings.at(static_cast<std::size_t>(f.hi));
  }
  static trace::RootEstimate finding(Answer answer) {
    if (answer >= 0) return {.verdict = trace::Decision::hit, .hi = static_cast<double>(answer)};
    return {.verdict = answer == miss ? trace::Decision::miss : trace::Decision::undecided};
  }
  static Parameter parameter(const TableParameter& p) { return {p.num, p.coef, p.rad, p.den}; }
  const TableParameter& parameter(const Parameter& t) const {
    for (const TableParameter& p : table.parameters) {
      if (t.x == p.num && t.y == p.coef && t.delta == p.rad && t.w == p.den) return p;
    }
    throw std::logic_error("a parameter that is not of the table");
  }
  /// The search is to say rightly whether the ray starts on the element.
  static void check(const Element& e, bool on) {
    if (e.on != on) throw std::logic_error("the search forgot what the ray starts on");
  }

  bool on(scene::ElementRef e) const { return element(e).on; }
  std::strong_ordering order_of_numbers(scene::ElementRef a, scene::ElementRef b) const {
    return element(a) <=> element(b);
  }
  template <class Use>
  auto visit(scene::ElementRef e, Use use) const {
    return use(element(e));
  }
  static bool in_range(const Element& e, trace::Search::Range range) {
    return e.in_range || range == trace::Search::Range::ordinary;
  }
  static trace::RootEstimate triage(const Element& e, bool on, double limit) {
    return check(e, on), finding(e.triage[limit_of(limit)]);
  }
  static trace::RootEstimate stable(const Element& e, bool on, double limit) {
    return check(e, on), finding(e.stable[limit_of(limit)]);
  }
  static trace::RootEstimate improved(const Element& e, bool on, const trace::RootEstimate& f) {
    return check(e, on), finding(e.improved.at(static_cast<std::size_t>(f.hi)));
  }
  surface::exact::Reach reach(const Element& e, bool on) const {
    check(e, on);
    if (e.reach == nothing) return {};
    if (e.reach == no_minimum) return {.segment = surface::exact::Segment{}};
    return {.count = 1, .t = {parameter(table.parameters.at(static_cast<std::size_t>(e.reach)))}};
  }
  static std::strong_ordering order(const Parameter& a, const Parameter& b) { return surface::exact::order(a, b); }

  trace::ParameterBounds<double> ends(trace::Step step, const trace::RootEstimate& f) const {
    const TableFinding& of = finding(f);
    if (step == trace::Step::triage) return {limits[of.triage_low], limits[of.triage_high]};
    return {limits[of.stable_low], limits[of.stable_high]};
  }
  trace::ParameterBounds<double> ends(const Parameter& t) const {
    return {limits[parameter(t).low], limits[parameter(t).high]};
  }
  bool ahead(const trace::RootEstimate& a, const trace::RootEstimate& b) const {
    return finding(a).rank < finding(b).rank;
  }
  bool certainly_less(const trace::RootEstimate& a, const trace::RootEstimate& b) const {
    return finding(a).certainly_less.at(static_cast<std::size_t>(b.hi));
  }
  static trace::RoundedPoint rounded(const Element& e, const trace::RootEstimate& f) {
    const int name = e.rounded.at(static_cast<std::size_t>(f.hi));
    return {name != uncertain, static_cast<double>(name), {}};
  }
  trace::RoundedPoint rounded(const Parameter& t) const {
    return {true, static_cast<double>(parameter(t).rounded), {}};
  }
};

/// The table in numbers, as proofs/oracle/tables.ml reads it.
inline std::string text(const StepTable& table) {
  std::string line;
  const auto put = [&line](auto number) { (line += std::to_string(number)) += ' '; };
  const auto put_all = [&](const auto& numbers) {
    for (const auto number : numbers) put(static_cast<int>(number));
  };
  put(table.elements.size()), put(table.findings.size()), put(table.parameters.size());
  for (const TableParameter& p : table.parameters) {
    put(p.num), put(p.coef), put(p.rad), put(p.den), put(p.low), put(p.high), put(p.rounded);
  }
  for (const TableFinding& f : table.findings) {
    put(f.triage_low), put(f.triage_high), put(f.stable_low), put(f.stable_high), put(f.rank);
    put_all(f.certainly_less);
  }
  for (const TableElement& e : table.elements) {
    put(static_cast<int>(e.in_range)), put_all(e.triage), put_all(e.stable), put_all(e.improved), put_all(e.rounded);
    put(e.reach);
  }
  return line;
}

inline scene::ElementRef element_at(std::size_t i) { return {model::Tipo::soy_esfera, static_cast<std::uint32_t>(i)}; }

/// The search, what it publishes, and which elements block a ray and a segment, in one line:
///   LIMIT; ELEMENT and t, s or x by the step that found it…; ELEMENT…; miss | hit NAME ELEMENT… | none ELEMENT…; 01…;
///   01…
inline std::string answer(const StepTable& table) {
  const TableSteps steps{table};
  trace::Counts counts;
  trace::SearchState found;
  const auto unknown = trace::Search::Range::unknown;
  for (std::size_t i = 0; i < table.elements.size(); ++i) trace::take(steps, found, element_at(i), unknown, counts);

  std::string line = std::to_string(limit_of(found.limit)) + ';';
  const auto put = [&line](const auto& elements) {
    for (const scene::ElementRef& e : elements) (line += ' ') += std::to_string(e.index);
  };
  for (const trace::Candidate& c : found.candidates) {
    ((line += ' ') += std::to_string(c.e.index)) += "tsx"[static_cast<std::size_t>(c.at.step)];
  }
  line += ';', put(found.without_minimum), line += "; ";
  const scene::Hit hit = trace::published(steps, found, counts);
  if (hit.resultado == model::Resultado::miss) line += "miss";
  if (hit.resultado == model::Resultado::hit) line += "hit " + std::to_string(static_cast<int>(hit.t));
  if (hit.resultado == model::Resultado::no_minimum) line += "none";
  put(hit.elementos), line += "; ";
  for (std::size_t i = 0; i < table.elements.size(); ++i)
    line += trace::blocks(steps, element_at(i), unknown, counts) ? '1' : '0';
  line += "; ";
  for (std::size_t i = 0; i < table.elements.size(); ++i)
    line += trace::blocks_segment(steps, element_at(i), unknown, counts) ? '1' : '0';
  return line;
}

}  // namespace durero::test
