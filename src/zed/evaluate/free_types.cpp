#include "zed/evaluate/free_types.hpp"

#include <algorithm>

#include "zed/value/formed_set.hpp"
#include "zed/value/sets.hpp"

namespace durero::zed {
namespace {

constexpr std::size_t most_listed_values = 4096;  // of a free type

Value constructed(const FreeBranch& branch, const Value& argument) {
  return ConstructedPtr(std::make_shared<const Constructed>(Constructed{*branch.name.get<Atom>(), argument}));
}

/// All values; nothing where the arguments of some constructor are not known to be few.
std::optional<std::vector<Value>> all_values(const std::vector<FreeBranch>& branches, Context& context) {
  std::vector<Value> values;
  for (const FreeBranch& branch : branches) {
    if (!branch.arguments) {
      values.push_back(branch.name);
      continue;
    }
    const Value arguments = branch.arguments(context);
    const auto* few = arguments.set() && !arguments.set()->family() ? arguments.set()->members() : nullptr;
    if (!few || few->size() > most_listed_values - std::min(values.size(), most_listed_values)) return std::nullopt;
    for (const Value& argument : *few) values.push_back(constructed(branch, argument));
  }
  return values;
}

class FreeTypeSet : public FormedSet {
 public:
  FreeTypeSet(std::string name, std::vector<FreeBranch> branches, FreeTypeForm form)
      : name_(std::move(name)), branches_(std::move(branches)), form_(form) {}
  // Every value of the type is a member; an unknown stands for one, where there may be none.
  Truth contains(const Value& value, Context& context) const override {
    return form_.inhabited || !value.get<Unknown>() ? Truth::yes : lost(context);
  }
  bool total() const override { return form_.inhabited; }
  bool is_infinite() const override { return form_.infinite; }

  // An argument has a constructor less around it.
  std::vector<Value> some_members(const SmallScope& scope, Context& context) const override {
    std::vector<Value> some;
    for (const FreeBranch& branch : branches_)
      if (!branch.arguments) some.push_back(branch.name);
    if (scope.depth == 0) return some;
    const std::size_t share = std::max<std::size_t>(2, scope.most / (2 * branches_.size()));
    const SmallScope inside{scope.numbers, share, scope.depth - 1, scope.given};
    for (const FreeBranch& branch : branches_) {
      const Value arguments = branch.arguments ? branch.arguments(context) : Value();
      if (!arguments.set()) continue;
      for (const Value& argument : arguments.set()->some_members(inside, context))
        if (some.size() < scope.most) some.push_back(constructed(branch, argument));
    }
    return some;
  }
  std::string spelled(Wording) const override { return name_; }

 private:
  std::string name_;
  std::vector<FreeBranch> branches_;
  FreeTypeForm form_;
};

/// Says whether the arguments of some branch are listed, and not none.
bool has_listed_argument(const std::vector<FreeBranch>& branches, Context& context) {
  return std::any_of(branches.begin(), branches.end(), [&](const FreeBranch& branch) {
    try {
      const Value arguments = branch.arguments ? branch.arguments(context) : Value();
      return arguments.set() && arguments.set()->members() && !arguments.set()->members()->empty();
    } catch (const EvaluationError&) {
      return false;
    }
  });
}

}  // namespace

// A constructor whose argument is of the free type itself asks for that set while it is made, and is told so by an
// error: there is no such list then.
Value free_type_set(std::string name, std::vector<FreeBranch> branches, FreeTypeForm form, Context& context) {
  try {
    if (auto values = all_values(branches, context)) return Value::set(std::move(*values));
  } catch (const EvaluationError&) {  // it stays known by its name
  }
  form.inhabited = form.inhabited || has_listed_argument(branches, context);
  return SetPtr(std::make_shared<const FreeTypeSet>(std::move(name), std::move(branches), form));
}

}  // namespace durero::zed
