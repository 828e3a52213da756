// The tests of a text, as programs in which calls of the tested system are to be filled in.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "spec_cases.hpp"

namespace durero::cli {

using spec::Machine;
using spec::OperationCase;
using spec::OperationCases;

namespace {

/// A string literal of Python and of C++: both read \" and \\, and letters beyond ASCII as they are.
std::string literal(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return quoted + "\"";
}

/// A value of Python: a whole number, a string, a tuple, a frozenset, or of a binding a frozenset of its pairs.
std::string python_value(const zed::Value& value) {
  const auto joined = [](const auto& parts) {
    std::string all;
    for (const zed::Value& part : parts) all += python_value(part) + ", ";
    return all;
  };
  if (const zed::Real* number = value.real(); number && number->is_integer()) return number->text();
  if (const auto* atom = value.get<zed::Atom>()) return literal((*atom)->text);
  if (const auto* tuple = value.tuple()) return "(" + joined(tuple->parts) + ")";
  if (const auto* made = value.get<zed::ConstructedPtr>())
    return "(" + literal((*made)->constructor->text) + ", " + python_value((*made)->argument) + ")";
  if (const auto* binding = value.binding()) {
    std::string all;
    for (std::size_t i = 0; i < binding->values.size(); ++i)
      all += "(" + literal((*binding->names)[i].text()) + ", " + python_value(binding->values[i]) + "), ";
    return "frozenset({" + all + "})";
  }
  if (const zed::Set* set = value.set(); set && set->members())
    return set->members()->empty() ? "frozenset()" : "frozenset({" + joined(*set->members()) + "})";
  return literal(value.text());
}

std::string python_values(const zed::Valuation& values) {
  std::string all;
  for (const auto& [name, value] : values)
    all += (all.empty() ? "" : ", ") + literal(name.text()) + ": " + python_value(value);
  return "{" + all + "}";
}

std::string cpp_values(const Machine& machine, const zed::Valuation& values) {
  std::string all;
  for (const auto& [name, value] : values)
    all += (all.empty() ? "{" : ", {") + literal(name.text()) + ", " + literal(machine.written(name, value)) + "}";
  return "{" + all + "}";
}

std::set<std::string> called_operations(const OperationCases& cases) {
  std::set<std::string> names;
  for (const OperationCase& each : cases.cases)
    if (each.is_found) names.insert(each.operation);
  return names;
}

/// A word of Python and C++ for an operation: letters beyond ASCII and signs become _.
std::string identifier(const std::string& name) {
  std::string word = name;
  for (char& c : word)
    if (!(c >= '0' && c <= '9') && !(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z')) c = '_';
  return word;
}

std::string comment_lines(const OperationCase& each, const std::string& begin) {
  std::string all;
  for (const std::string& side : each.disjuncts) {
    all += begin;
    for (const char c : side) all += c == '\n' ? ' ' : c;
    all += "\n";
  }
  return all;
}

}  // namespace

std::string cases_python(const Machine& machine, const OperationCases& cases) {
  std::string text =
      "\"\"\"Tests of the operations on " + machine.state() +
      ".\n\nA set is a frozenset, a function the set of its pairs, a binding the set of its components' pairs, and a "
      "member\n"
      "of a given set or a constant its name. Fill in the system's calls.\n\"\"\"\nimport unittest\n\n\nclass System:\n"
      "    \"\"\"Each call brings the system into the state `before`, does the operation with `inputs`, and returns "
      "the\n"
      "    outputs and the state after, two dictionaries.\"\"\"\n\n";
  for (const std::string& name : called_operations(cases))
    text += fmt::format("    def {}(self, before, inputs):\n        raise NotImplementedError(\"{}\")\n\n",
                        identifier(name), name);
  text +=
      "\nclass Cases(unittest.TestCase):\n    def case(self, operation, before, inputs, admitted):\n        try:\n"
      "            answer = getattr(System(), operation)(before, inputs)\n        except NotImplementedError as "
      "missing:\n"
      "            self.skipTest(f\"{missing} is not filled in\")\n        self.assertIn(tuple(answer), admitted)\n";
  std::size_t number = 0;
  for (const OperationCase& each : cases.cases) {
    ++number;
    if (!each.is_found) {
      text += fmt::format("\n    # {} {} is infeasible.\n", number, each.operation) + comment_lines(each, "    #   ");
      continue;
    }
    text += fmt::format("\n    def test_{}_{}(self):\n", number, identifier(each.operation)) +
            comment_lines(each, "        # ");
    text += fmt::format("        self.case(\"{}\",\n                  {},\n                  {},\n                  [",
                        identifier(each.operation), python_values(each.way.back().after), python_values(each.inputs));
    for (const spec::Transition& step : each.admitted)
      text += fmt::format("({}, {}),\n                   ", python_values(step.outputs), python_values(step.after));
    text += "])\n";
  }
  return text + "\n\nif __name__ == \"__main__\":\n    unittest.main()\n";
}

std::string cases_cpp(const Machine& machine, const OperationCases& cases) {
  std::string text =
      "// Tests of the operations on " + machine.state() +
      ". A value is written as Z. Fill in the system's calls.\n#include <cstdio>\n#include <map>\n#include <optional>\n"
      "#include <string>\n#include <utility>\n#include <vector>\n\nusing Values = std::map<std::string, std::string>;\n"
      "using Answer = std::pair<Values, Values>;  // the outputs, and the state after\n\n"
      "// Each call brings the system into the state `before`, does the operation with `inputs`, and returns its "
      "answer.\n";
  for (const std::string& name : called_operations(cases))
    text += fmt::format(
        "std::optional<Answer> {}([[maybe_unused]] const Values& before, [[maybe_unused]] const Values& inputs) {{\n"
        "  return std::nullopt;  // not filled in\n}}\n",
        identifier(name));
  text +=
      "\nint failed = 0, passed = 0, missing = 0;\n\n"
      "void check(const char* name, const std::optional<Answer>& answer, const std::vector<Answer>& admitted) {\n"
      "  bool right = false;\n  for (const Answer& each : admitted) right = right || answer == each;\n"
      "  ++(!answer ? missing : right ? passed : failed);\n"
      "  if (answer && !right) std::"
      "printf(\"FAILED: %s\\n\", name);\n}\n\nint main() {\n";
  std::size_t number = 0;
  for (const OperationCase& each : cases.cases) {
    ++number;
    text += comment_lines(each, "  // ");
    if (!each.is_found) {
      text += fmt::format("  // {} {} is infeasible.\n", number, each.operation);
      continue;
    }
    text +=
        fmt::format("  check(\"{} {}\", {}({}, {}),\n        {{", number, each.operation, identifier(each.operation),
                    cpp_values(machine, each.way.back().after), cpp_values(machine, each.inputs));
    for (const spec::Transition& step : each.admitted)
      text += fmt::format("Answer{{{}, {}}},\n         ", cpp_values(machine, step.outputs),
                          cpp_values(machine, step.after));
    text += "});\n";
  }
  return text +
         "  std::"
         "printf(\"%d passed, %d failed, %d not filled in\\n\", passed, failed, missing);\n"
         "  return failed == 0 ? 0 : 1;\n}\n";
}

}  // namespace durero::cli
