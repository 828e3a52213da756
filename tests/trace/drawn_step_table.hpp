/// Random step tables for the search: half of them say nothing false of a first parameter of each element, which
/// proofs/Search.v calls right, and half say anything, but that no finding is certainly less than itself, and that a
/// hit in floating point is one by exact numbers, too: else the code has nothing to say.
#pragma once

#include "support/scenes.hpp"
#include "trace/step_table.hpp"

namespace durero::test {

/// Parameters, many of which are equal or lie beside each other, beside 1, and beside an end.
inline const std::vector<TableParameter>& some_parameters() {
  static const std::vector<TableParameter> all = [] {
    constexpr std::array numbers{std::array{1, 0, 0, 2},                    // 1/2
                                 std::array{0, 1, 1, 2},                    // √1/2
                                 std::array{2, -1, 2, 1},                   // 2 − √2
                                 std::array{0, 1, 3, 2},                    // √3/2
                                 std::array{1073741823, 0, 0, 1073741824},  // 1 − 2⁻³⁰
                                 std::array{1, 0, 0, 1},                    // 1
                                 std::array{3, -1, 4, 1},                   // 3 − √4
                                 std::array{0, 2, 2, 2},                    // √2
                                 std::array{0, 1, 2, 1},                    // √2 again
                                 std::array{141421356, 0, 0, 100000000},    // less than it by 2·10⁻⁹
                                 std::array{2, 0, 0, 1},                    // 2
                                 std::array{0, 1, 4, 1}};                   // √4
    std::vector<TableParameter> parameters;
    for (const auto& [num, coef, rad, den] : numbers) parameters.push_back({num, coef, rad, den, 0, 0, 0});
    return parameters;
  }();
  return all;
}

/// How they and the limits stand to each other.
struct ParameterOrders {
  std::vector<std::vector<std::strong_ordering>> parameters;  ///< of the one and the other
  std::vector<std::vector<std::partial_ordering>> limit;      ///< of a limit and a parameter; of no number, unordered
};
inline const ParameterOrders& parameter_orders() {
  static const ParameterOrders all = [] {
    ParameterOrders orders;
    const auto rows = [](const auto& of, auto& out, auto compare) {
      for (const auto& one : of) {
        auto& row = out.emplace_back();
        for (const TableParameter& p : some_parameters()) row.push_back(compare(one, TableSteps::parameter(p)));
      }
    };
    rows(some_parameters(), orders.parameters, [](const TableParameter& one, const trace::Parameter& t) {
      return surface::exact::order(TableSteps::parameter(one), t);
    });
    rows(limits, orders.limit, [](double limit, const trace::Parameter& t) -> std::partial_ordering {
      if (!std::isfinite(limit)) return limit <=> 0.0;
      return surface::exact::order(trace::Parameter{.x = limit}, t);
    });
    return orders;
  }();
  return all;
}

/// Draws the tables of one seed, each by its number alone.
class DrawnStepTable {
 public:
  DrawnStepTable(std::uint64_t seed, std::uint64_t number) : random_(seed * 0x9e3779b97f4a7c15 + number) {
    right_ = random_.chance(1, 2);
    table_.parameters = some_parameters();
    for (std::size_t i = 0; i < table_.parameters.size(); ++i) draw_parameter(i);
    const std::size_t findings = 1 + random_.below(6), elements = random_.below(7);
    for (std::size_t i = 0; i < findings; ++i) of_finding_.push_back(random_.below(table_.parameters.size()));
    for (std::size_t i = 0; i < findings; ++i) draw_finding(i);
    for (std::size_t i = 0; i < elements; ++i) {
      const bool again = random_.chance(1, 4);  // an element of equal numbers
      if (again && i > 0) {
        const std::size_t before = random_.below(i);
        table_.elements.push_back(TableElement(table_.elements[before]));
      } else {
        draw_element();
      }
    }
  }

  /// The table.
  const StepTable& table() const { return table_; }
  /// Whether its steps say nothing false: then an exact search answers alike.
  bool right() const { return right_; }

 private:
  using Place = std::size_t;  // of a parameter

  static std::strong_ordering order(Place i, Place j) { return parameter_orders().parameters[i][j]; }
  static std::partial_ordering order_of_limit(Limit x, Place i) { return parameter_orders().limit[x][i]; }

  /// An end of the parameter: at most or at least it where the table is right; often near it otherwise, too.
  Limit draw_end(Place i, bool low) {
    for (;;) {
      const Limit end = random_.below(limits.size());
      const auto side = order_of_limit(end, i);
      if (low ? side <= 0 : side >= 0) return end;
      if (!right_ && random_.chance(1, 4)) return end;
    }
  }
  void draw_parameter(Place i) {
    TableParameter& p = table_.parameters[i];
    p.low = draw_end(i, true);
    p.high = draw_end(i, false);
    if (right_) {  // the first that is equal gives the name
      while (order(static_cast<Place>(p.rounded), i) != 0) ++p.rounded;
    } else {
      p.rounded = random_.integer(0, 9);
    }
  }
  void draw_finding(std::size_t f) {
    const Place at = of_finding_[f];
    TableFinding& finding = table_.findings.emplace_back();
    finding.triage_low = draw_end(at, true);
    finding.triage_high = draw_end(at, false);
    finding.stable_low = draw_end(at, true);
    finding.stable_high = draw_end(at, false);
    finding.rank = random_.integer(0, 3);
    for (const Place other : of_finding_) {
      const bool said = random_.chance(1, 2);
      finding.certainly_less.push_back(said && (!right_ || order(at, other) < 0));
    }
    finding.certainly_less[f] = false;
  }

  /// A finding of the element's parameter; undecided where there is none.
  Answer draw_hit(Place at) {
    const auto f = static_cast<Answer>(random_.below(of_finding_.size()));
    return !right_ || order(of_finding_[static_cast<std::size_t>(f)], at) == 0 ? f : undecided;
  }
  /// What a step says up to the limit.
  Answer draw_answer(const TableElement& e, Limit limit) {
    const bool hit = random_.chance(3, 4), missed = random_.chance(1, 2);
    if (e.reach >= 0 && hit) {
      const Answer answer = draw_hit(static_cast<Place>(e.reach));
      if (answer != undecided) return answer;
    }
    if (!missed) return undecided;
    if (!right_ || e.reach == nothing) return miss;
    return e.reach >= 0 && order_of_limit(limit, static_cast<Place>(e.reach)) < 0 ? miss : undecided;
  }
  void draw_element() {
    TableElement e{};
    e.on = random_.chance(1, 3);
    e.in_range = random_.chance(7, 8);
    const std::uint64_t kind = random_.below(16);
    // Half of them are met where some finding is.
    const Place found = of_finding_[random_.below(of_finding_.size())], any = random_.below(table_.parameters.size());
    e.reach = kind == 0 ? no_minimum : kind < 3 ? nothing : static_cast<int>(kind < 13 ? found : any);
    for (Limit x = 0; x < limits.size(); ++x) {
      e.triage[x] = draw_answer(e, x);
      e.stable[x] = draw_answer(e, x);
    }
    for (std::size_t f = 0; f < of_finding_.size(); ++f) {
      e.improved.push_back(draw_answer(e, limit_of(trace::no_limit)));
      const bool certain = random_.chance(1, 2);
      const int name = right_ ? table_.parameters[of_finding_[f]].rounded : random_.integer(0, 9);
      e.rounded.push_back(certain ? name : uncertain);
    }
    table_.elements.push_back(std::move(e));
  }

  Random random_;
  bool right_;
  StepTable table_;
  std::vector<Place> of_finding_;  // the parameter that each is of, where the table is right
};

}  // namespace durero::test
