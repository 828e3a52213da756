#include "value_domains.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "toolkit_operators.hpp"

namespace durero::spec {
namespace {

/// A set with more subsets, functions or tuples than so many is not listed for a search.
constexpr double most_composed = 1'000'000;

double bounded_size(double size) { return size > most_composed ? unlisted : size; }

class WholeNumbers : public ValueDomain {
 public:
  WholeNumbers(InternedValues& values, std::optional<std::int64_t> from) : values_(values), from_(from) {}
  bool has(ValueId value, IdFrame) const override { return values_.whole_number(value) >= from_.value_or(INT64_MIN); }
  double size() const override { return unlisted; }
  bool each(IdFrame, const IdVisit&) const override { throw NotInterned("numbers have no end"); }
  std::optional<std::optional<std::int64_t>> numbers_from() const override {
    return std::optional<std::optional<std::int64_t>>(std::in_place, from_);
  }

 private:
  InternedValues& values_;
  std::optional<std::int64_t> from_;
};

class WholeType : public ValueDomain {
 public:
  explicit WholeType(std::optional<std::vector<ValueId>> members) : members_(std::move(members)) {}
  bool has(ValueId, IdFrame) const override { return true; }
  bool is_whole() const override { return true; }
  double size() const override { return members_ ? static_cast<double>(members_->size()) : unlisted; }
  bool each(IdFrame, const IdVisit& visit) const override {
    if (!members_) throw NotInterned("a type is not listed");
    return std::all_of(members_->begin(), members_->end(), visit);
  }

 private:
  std::optional<std::vector<ValueId>> members_;
};

class DomainOfSet : public ValueDomain {
 public:
  DomainOfSet(InternedValues& values, IdCode set, std::function<bool(ValueId, ValueId)> contained, double size)
      : values_(values), set_(std::move(set)), contained_(std::move(contained)), size_(size) {}
  bool has(ValueId value, IdFrame frame) const override {
    const ValueId set = set_(frame);
    if (set == 0) return false;
    return values_.form(set) == InternedForm::set ? values_.has(set, value) : contained_(set, value);
  }
  double size() const override { return size_; }
  bool each(IdFrame frame, const IdVisit& visit) const override {
    const ValueId set = set_(frame);
    if (set == 0) return true;
    const auto members = values_.members(set);
    return std::all_of(members.begin(), members.end(), visit);
  }

 private:
  InternedValues& values_;
  IdCode set_;
  std::function<bool(ValueId, ValueId)> contained_;
  double size_;
};

class ListedPowerSet : public ValueDomain {
 public:
  ListedPowerSet(InternedValues& values, DomainPtr of, bool nonempty)
      : values_(values), of_(std::move(of)), nonempty_(nonempty) {}
  bool has(ValueId value, IdFrame frame) const override {
    if (is_whole()) return true;
    const auto members = values_.members(value);
    return !(nonempty_ && members.empty()) &&
           std::all_of(members.begin(), members.end(), [&](ValueId each) { return of_->has(each, frame); });
  }
  bool is_whole() const override { return of_->is_whole() && !nonempty_; }
  double size() const override { return bounded_size(std::exp2(of_->size())); }
  bool each(IdFrame frame, const IdVisit& visit) const override {
    const std::vector<ValueId> members = listed_members(*of_, frame);
    if (std::exp2(static_cast<double>(members.size())) > most_composed) throw NotInterned("a set has many subsets");
    for (std::uint64_t bits = nonempty_ ? 1 : 0; bits >> members.size() == 0; ++bits) {
      std::vector<ValueId> some;
      for (std::size_t i = 0; i < members.size(); ++i)
        if ((bits >> i & 1U) != 0) some.push_back(members[i]);
      if (!visit(values_.set(some))) return false;
    }
    return true;
  }

 private:
  InternedValues& values_;
  DomainPtr of_;
  bool nonempty_;
};

/// Goes every choice of one of `options` for each of so many places; `may` refuses a choice after those before it.
class ChoiceWalk {
 public:
  using May = std::function<bool(const std::vector<ValueId>& before, ValueId next)>;
  using Visit = std::function<bool(const std::vector<ValueId>& chosen)>;
  ChoiceWalk(const std::vector<std::vector<ValueId>>& options, May may, Visit visit)
      : options_(options), may_(std::move(may)), visit_(std::move(visit)) {}
  bool go() {
    if (chosen_.size() == options_.size()) return visit_(chosen_);
    for (const ValueId next : options_[chosen_.size()]) {
      if (!may_(chosen_, next)) continue;
      chosen_.push_back(next);
      const bool on = go();
      chosen_.pop_back();
      if (!on) return false;
    }
    return true;
  }

 private:
  const std::vector<std::vector<ValueId>>& options_;
  May may_;
  Visit visit_;
  std::vector<ValueId> chosen_;
};

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

class ListedProduct : public ValueDomain {
 public:
  ListedProduct(InternedValues& values, std::vector<DomainPtr> parts) : values_(values), parts_(std::move(parts)) {}
  bool has(ValueId value, IdFrame frame) const override {
    const auto of = values_.parts(value);
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (!parts_[i]->has(of[i], frame)) return false;
    return true;
  }
  bool is_whole() const override {
    return std::all_of(parts_.begin(), parts_.end(), [](const DomainPtr& part) { return part->is_whole(); });
  }
  double size() const override {
    double product = 1;
    for (const DomainPtr& part : parts_) product *= part->size();
    return bounded_size(product);
  }
  bool each(IdFrame frame, const IdVisit& visit) const override {
    std::vector<std::vector<ValueId>> options;
    for (const DomainPtr& part : parts_) options.push_back(listed_members(*part, frame));
    return ChoiceWalk(
               options, [](const std::vector<ValueId>&, ValueId) { return true; },
               [&](const std::vector<ValueId>& chosen) { return visit(values_.tuple(chosen)); })
        .go();
  }

 private:
  InternedValues& values_;
  std::vector<DomainPtr> parts_;
};

class ListedSequences : public ValueDomain {
 public:
  ListedSequences(InternedValues& values, DomainPtr of, bool nonempty, bool injective)
      : values_(values), of_(std::move(of)), nonempty_(nonempty), injective_(injective) {}
  bool has(ValueId value, IdFrame frame) const override {
    std::vector<ValueId> elements;
    try {
      elements = sequence_elements(values_, value);
    } catch (const NotInterned&) {
      if (values_.form(value) != InternedForm::set) throw;
      return false;  // the set is listed and is no sequence
    }
    if (nonempty_ && elements.empty()) return false;
    for (const ValueId each : elements)
      if (!of_->has(each, frame)) return false;
    std::sort(elements.begin(), elements.end());
    return !injective_ || std::adjacent_find(elements.begin(), elements.end()) == elements.end();
  }
  double size() const override {
    const double most = of_->size();  // an injective one is as long as its set at most: e · n! of them
    return injective_ ? bounded_size(std::exp(1) * std::tgamma(most + 1)) : unlisted;
  }
  bool each(IdFrame frame, const IdVisit& visit) const override {
    if (!injective_ || size() == unlisted) throw NotInterned("sequences have no end");
    std::vector<ValueId> all = listed_members(*of_, frame), chosen;
    return extend(all, chosen, visit);
  }

 private:
  bool extend(const std::vector<ValueId>& all, std::vector<ValueId>& chosen, const IdVisit& visit) const {
    if (!(nonempty_ && chosen.empty()) && !visit(sequence_of(values_, chosen))) return false;
    for (const ValueId next : all) {
      if (std::find(chosen.begin(), chosen.end(), next) != chosen.end()) continue;
      chosen.push_back(next);
      const bool on = extend(all, chosen, visit);
      chosen.pop_back();
      if (!on) return false;
    }
    return true;
  }

  InternedValues& values_;
  DomainPtr of_;
  bool nonempty_, injective_;
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

DomainPtr whole_numbers(InternedValues& values, std::optional<std::int64_t> from) {
  return std::make_shared<WholeNumbers>(values, from);
}
DomainPtr set_given(InternedValues& values, IdCode set, std::function<bool(ValueId, ValueId)> contained, double size) {
  return std::make_shared<DomainOfSet>(values, std::move(set), std::move(contained), size);
}
DomainPtr whole_type(InternedValues&, std::optional<std::vector<ValueId>> members) {
  return std::make_shared<WholeType>(std::move(members));
}
DomainPtr power_set(InternedValues& values, DomainPtr of, bool nonempty) {
  return std::make_shared<ListedPowerSet>(values, std::move(of), nonempty);
}
DomainPtr arrow_set(InternedValues& values, DomainPtr from, DomainPtr to, ArrowProperties properties) {
  return std::make_shared<ArrowSet>(values, std::move(from), std::move(to), properties);
}
DomainPtr product_set(InternedValues& values, std::vector<DomainPtr> parts) {
  return std::make_shared<ListedProduct>(values, std::move(parts));
}
DomainPtr sequence_set(InternedValues& values, DomainPtr of, bool nonempty, bool injective) {
  return std::make_shared<ListedSequences>(values, std::move(of), nonempty, injective);
}

std::vector<ValueId> listed_members(const ValueDomain& domain, IdFrame frame) {
  std::vector<ValueId> members;
  domain.each(frame, [&](ValueId each) {
    members.push_back(each);
    return true;
  });
  return members;
}

}  // namespace durero::spec
