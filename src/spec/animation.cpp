/// The way that an animation went, as text and back.
#include "durero/spec/animation.hpp"

#include <algorithm>
#include <set>
#include <sstream>

namespace durero::spec {

using zed::Name;
using zed::Truth;
using zed::Valuation;
using zed::Value;

namespace {

constexpr const char* header = "durero-trace 1";

Name with_stroke(Name name) {
  name.strokes += "'";
  return name;
}

}  // namespace

std::string name_list(const std::set<Name>& names) {
  std::string said;
  for (const Name& name : names) said += (said.empty() ? "" : ", ") + name.text();
  return said;
}

bool Animation::back() {
  if (way_.size() < 2) return false;
  way_.pop_back();
  return true;
}

std::string Animation::saved() const {
  std::string text = std::string(header) + "\n";
  for (const std::string& carrier : machine_.carriers()) text += "given " + carrier + "\n";
  text += "state " + machine_.state() + "\n";
  for (const Transition& step : way_) {
    text += "step " + step.operation + "\n";
    const auto add = [&](const Name& name, const Name& of_type, const Value& value) {
      text += "  " + name.text() + " == " + machine_.written(of_type, value) + "\n";
    };
    for (const auto& [name, value] : step.inputs) add(name, name, value);
    for (const auto& [name, value] : step.outputs) add(name, name, value);
    for (const auto& [name, value] : step.after) add(with_stroke(name), name, value);
  }
  return text;
}

namespace {

/// Reads the lines of a saved way. Columns count characters of a line that begins with two blanks at most.
class TraceReader {
 public:
  TraceReader(const Machine& machine, const std::string& text) : machine_(machine), in_(text) {}

  std::vector<Transition> way() {
    if (!next() || line_ != header)
      fail("this is no trace, or one of another version", std::string("expected the line ") + header);
    std::vector<std::string> expected;
    for (const std::string& carrier : machine_.carriers()) expected.push_back("given " + carrier);
    expected.push_back("state " + machine_.state());
    for (const std::string& line : expected)
      if (!next() || line_ != line) fail("the trace is of another text, or of other given sets", "expected " + line);
    std::vector<Transition> steps;
    for (bool more = next(); more;) {
      if (!line_.starts_with("step ")) fail("this is no step", "expected a line step OPERATION");
      const std::uint32_t at = number_;
      steps.push_back(begun(line_.substr(5), steps.empty()));
      for (more = next(); more && line_.starts_with("  "); more = next()) give(steps.back());
      judge(steps, at);
    }
    return steps;
  }

 private:
  bool next() {
    ++number_;
    if (!std::getline(in_, line_)) {
      line_.clear();
      return false;
    }
    if (line_.ends_with('\r')) line_.pop_back();
    return true;
  }
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected, std::uint32_t column = 1) const {
    throw zed::ZError({number_, column}, wrong, expected);
  }

  Transition begun(const std::string& operation, bool first) const {
    const std::string& init = machine_.init().empty() ? machine_.state() : machine_.init();
    if (first ? operation != init : !machine_.find(operation))
      fail(operation + (first ? " is not the initial schema" : " is no operation"),
           "expected " + (first ? init : "one of the text"), 6);
    Transition step{operation, {}, {}, {}};
    for (const Name& name : machine_.components()) step.after.emplace_back(name, Value());
    return step;
  }

  void give(Transition& step) const {
    const std::size_t sign = line_.find(" == ");
    if (sign == line_.npos) fail("this gives no value", "expected NAME == VALUE", 3);
    const std::string name = line_.substr(2, sign - 2);
    const auto value_of = [&](const Name& of_type) {
      try {
        return machine_.typed(line_.substr(sign + 4), of_type);
      } catch (const zed::ZError& error) {
        fail(error.what_is_wrong, error.expected, static_cast<std::uint32_t>(name.size() + 6 + error.place.column));
      }
    };
    for (auto& [component, after] : step.after)
      if (name == with_stroke(component).text()) {
        after = value_of(component);
        return;
      }
    const MachineOperation* operation = machine_.find(step.operation);
    for (const auto* names : {operation ? &operation->inputs : nullptr, operation ? &operation->outputs : nullptr})
      for (const Name& each : names ? *names : std::vector<Name>())
        if (name == each.text()) {
          (names == &operation->inputs ? step.inputs : step.outputs).emplace_back(each, value_of(each));
          return;
        }
    fail(step.operation + " has no " + name, "expected a component of it", 3);
  }

  void judge(const std::vector<Transition>& steps, std::uint32_t at) {
    const Transition& last = steps.back();
    const Valuation none;
    for (const auto& [name, value] : last.after)
      if (value.is_undefined())
        throw zed::ZError({at, 1}, "the step says no " + with_stroke(name).text(), "expected every component");
    if (machine_.is_step(steps.size() < 2 ? none : steps[steps.size() - 2].after, last) != Truth::yes)
      throw zed::ZError({at, 6}, last.operation + " does not allow this step", "expected one that its text allows");
  }

  const Machine& machine_;
  std::istringstream in_;
  std::string line_;
  std::uint32_t number_ = 0;
};

}  // namespace

void Animation::replay(const std::string& text) {
  std::vector<Transition> way = TraceReader(machine_, text).way();
  way_ = std::move(way);
}

}  // namespace durero::spec
