#include "value_domains.hpp"

#include <algorithm>
#include <cmath>

#include "choice_walk.hpp"
#include "toolkit_operators.hpp"

namespace durero::spec {
namespace {

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
