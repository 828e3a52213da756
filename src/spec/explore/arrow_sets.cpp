/// The sets of relations and functions that arrows make.
#include <algorithm>
#include <array>
#include <cmath>

#include "choice_walk.hpp"
#include "toolkit_operators.hpp"
#include "value_domains.hpp"

namespace durero::spec {
namespace {

class ArrowSet : public ValueDomain {
 public:
  ArrowSet(InternedValues& values, DomainPtr from, DomainPtr to, ArrowProperties properties)
      : values_(values), from_(std::move(from)), to_(std::move(to)), properties_(properties) {}

  bool has(ValueId value, IdFrame frame) const override {
    const auto pairs = values_.members(value);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto parts = values_.parts(pairs[i]);
      if (!from_->has(parts[0], frame) || !to_->has(parts[1], frame)) return false;
      for (std::size_t j = 0; j < i; ++j) {
        const auto other = values_.parts(pairs[j]);
        if (properties_.function && other[0] == parts[0]) return false;
        if (properties_.injective && other[1] == parts[1]) return false;
      }
    }
    if (properties_.total && !covers(value, *from_, "dom", frame)) return false;
    return !properties_.surjective || covers(value, *to_, "ran", frame);
  }
  bool is_whole() const override { return !properties_.function && from_->is_whole() && to_->is_whole(); }
  double size() const override {
    if (!properties_.function) return bounded_size(std::exp2(from_->size() * to_->size()));
    return bounded_size(std::pow(to_->size() + (properties_.total ? 0 : 1), from_->size()));
  }
  bool each(IdFrame frame, const IdVisit& visit) const override {
    const std::vector<ValueId> from = listed_members(*from_, frame), to = listed_members(*to_, frame);
    const double count = properties_.function
                             ? std::pow(static_cast<double>(to.size() + 1), static_cast<double>(from.size()))
                             : std::exp2(static_cast<double>(from.size() * to.size()));
    if (count > most_composed) throw NotInterned("a set has many functions");
    return properties_.function ? each_function(from, to, frame, visit) : each_relation(from, to, visit);
  }

 private:
  bool covers(ValueId relation, const ValueDomain& wanted, std::string_view part, IdFrame frame) const {
    const ValueId has = unary_operator(part)(values_, relation);
    return wanted.each(frame, [&](ValueId each) { return values_.has(has, each); });
  }
  bool each_function(const std::vector<ValueId>& from, std::vector<ValueId> to, IdFrame frame,
                     const IdVisit& visit) const {
    if (!properties_.total) to.insert(to.begin(), 0);  // 0 stands for no value
    const std::vector<std::vector<ValueId>> options(from.size(), to);
    const auto may = [&](const std::vector<ValueId>& before, ValueId next) {
      return !properties_.injective || next == 0 || std::find(before.begin(), before.end(), next) == before.end();
    };
    return ChoiceWalk(options, may,
                      [&](const std::vector<ValueId>& chosen) {
                        std::vector<ValueId> pairs;
                        for (std::size_t i = 0; i < from.size(); ++i)
                          if (chosen[i] != 0) pairs.push_back(values_.pair(from[i], chosen[i]));
                        const ValueId function = values_.set(pairs);
                        return (properties_.surjective && !covers(function, *to_, "ran", frame)) || visit(function);
                      })
        .go();
  }
  bool each_relation(const std::vector<ValueId>& from, const std::vector<ValueId>& to, const IdVisit& visit) const {
    std::vector<ValueId> pairs;
    for (const ValueId first : from)
      for (const ValueId second : to) pairs.push_back(values_.pair(first, second));
    for (std::uint64_t bits = 0; bits >> pairs.size() == 0; ++bits) {
      std::vector<ValueId> some;
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if ((bits >> i & 1U) != 0) some.push_back(pairs[i]);
      if (!visit(values_.set(some))) return false;
    }
    return true;
  }

  InternedValues& values_;
  DomainPtr from_, to_;
  ArrowProperties properties_;
};

}  // namespace

std::optional<ArrowProperties> arrow_properties(const std::string& name) {
  struct Row {
    const char* name;
    ArrowProperties properties;
  };
  static constexpr std::array rows{
      Row{"_↔_", {false, false, false, false}}, Row{"_→_", {true, true, false, false}},
      Row{"_⇸_", {true, false, false, false}},  Row{"_⤔_", {true, false, true, false}},
      Row{"_↣_", {true, true, true, false}},    Row{"_⤀_", {true, false, false, true}},
      Row{"_↠_", {true, true, false, true}},    Row{"_⤖_", {true, true, true, true}},
      Row{"_⇻_", {true, false, false, false}},  Row{"_⤕_", {true, false, true, false}},
  };
  for (const Row& row : rows)
    if (name == row.name) return row.properties;
  return std::nullopt;
}

DomainPtr arrow_set(InternedValues& values, DomainPtr from, DomainPtr to, ArrowProperties properties) {
  return std::make_shared<ArrowSet>(values, std::move(from), std::move(to), properties);
}

}  // namespace durero::spec
