#include "proofs/recorder.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <sstream>

namespace durero::trace::HWY_NAMESPACE {
namespace {

struct Recorded {
  Form form;
  std::vector<Node> operands;
  std::optional<double> constant;
};

/// All that was recorded, operands before what they are operands of.
struct Record {
  std::vector<Recorded> nodes;
  std::map<std::pair<std::string, std::vector<Node>>, Node> known;
};
Record& all() {
  static Record record;
  return record;
}

/// What is settled on the path at hand.
std::map<Node, bool>& path() {
  static std::map<Node, bool> settled;
  return settled;
}

Form of_constant(double x) {
  if (x < 0) return {"- " + of_constant(-x).text, Tightness::other};
  if (x == std::floor(x) && x < 100) return {std::to_string(static_cast<int>(x)), Tightness::name};
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto power = [](int e) { return "bpow radix2 " + (e < 0 ? "(" + std::to_string(e) + ")" : std::to_string(e)); };
  if (fraction == 0.5) return {power(exponent - 1), Tightness::application};
  auto digits = static_cast<long long>(std::ldexp(fraction, 53));
  for (exponent -= 53; digits % 2 == 0; ++exponent) digits /= 2;
  return {std::to_string(digits) + " * " + power(exponent), Tightness::other};
}

std::string bracketed(const std::string& text, Tightness is, Tightness takes) {
  return is <= takes ? text : "(" + text + ")";
}

/// The text of terms, where those in `names` are called by their names.
struct Writer {
  std::map<Node, std::string> names;

  std::string operand(Node node, Tightness takes) const {
    if (const auto named = names.find(node); named != names.end()) return named->second;
    return bracketed(text(node), all().nodes[node].form.is, takes);
  }
  std::string text(Node node) const {
    const Recorded& term = all().nodes[node];
    std::string written;
    for (std::size_t i = 0; i < term.form.text.size(); ++i) {
      if (term.form.text[i] != '%') {
        written += term.form.text[i];
      } else {
        written += operand(term.operands[static_cast<std::size_t>(term.form.text[++i] - '0')], term.form.takes);
      }
    }
    return written;
  }
};

/// What a program does: what it builds, or that and that by a condition.
struct Way {
  Built built;
  Node condition = 0;
  std::unique_ptr<Way> yes, no;
};

Way ways(const std::function<Built()>& build) {
  try {
    return {build(), 0, nullptr, nullptr};
  } catch (const Unsettled& unsettled) {
    const auto where = [&](bool holds) {
      path()[unsettled.condition] = holds;
      auto way = std::make_unique<Way>(ways(build));
      path().erase(unsettled.condition);
      return way;
    };
    auto yes = where(true);
    return {{}, unsettled.condition, std::move(yes), where(false)};
  }
}

/// Each node that the way names, as often as it does.
void named(const Way& way, std::vector<Node>& nodes) {
  if (!way.yes) {
    nodes.insert(nodes.end(), way.built.parts.begin(), way.built.parts.end());
    return;
  }
  nodes.push_back(way.condition);
  named(*way.yes, nodes);
  named(*way.no, nodes);
}

/// Those below the nodes, operands before what they are operands of, in an order that does not depend on when they were
/// recorded, as that depends on the compiler; and how often each is used.
struct Uses {
  std::vector<Node> order;
  std::map<Node, int> times;

  explicit Uses(const std::vector<Node>& nodes) {
    for (const Node node : nodes) use(node);
  }
  void use(Node node) {
    if (times[node]++ != 0) return;
    for (const Node operand : all().nodes[node].operands) use(operand);
    order.push_back(node);
  }
};

/// In lines of at most 120 characters, later ones indented further.
void print_wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string line(indent, ' '), word;
  bool first = true;
  while (words >> word) {
    if (!first && line.size() + 1 + word.size() > 120) {
      std::printf("%s\n", line.c_str());
      line.assign(indent + 4, ' ');
      first = true;
    }
    line += (first ? "" : " ") + word;
    first = false;
  }
  std::printf("%s\n", line.c_str());
}

void print(const Writer& writer, const Built& built, std::size_t indent, const std::string& before,
           const std::string& after) {
  std::string written = before + built.constructor;
  for (std::size_t i = 0; i < built.parts.size(); ++i) {
    if (built.names.empty()) {
      written += (written.empty() ? "" : " ") + writer.operand(built.parts[i], Tightness::name);
    } else {
      written =
          (i == 0 ? before + "{| " : "") + built.names[i] + " := " + writer.operand(built.parts[i], Tightness::other);
      if (i + 1 == built.parts.size()) break;
      print_wrapped(written + ";", i == 0 ? indent : indent + 3);
    }
  }
  print_wrapped(written + (built.names.empty() ? "" : " |}") + after, built.names.empty() ? indent : indent + 3);
}

void print(const Writer& writer, const Way& way, std::size_t indent, const std::string& before,
           const std::string& after) {
  if (!way.yes) {
    print(writer, way.built, indent, before, after);
    return;
  }
  print_wrapped(before + "if " + writer.operand(way.condition, Tightness::other) + " then", indent);
  print(writer, *way.yes, indent + 2, "", "");
  print(writer, *way.no, indent, "else ", after);
}

}  // namespace

Node record(const Form& form, std::vector<Node> operands) {
  Record& record = all();
  const auto [place, is_new] = record.known.try_emplace({form.text, operands}, record.nodes.size());
  if (is_new) record.nodes.push_back({form, std::move(operands), std::nullopt});
  return place->second;
}

Node record(double constant) {
  const Node node = record(of_constant(constant));
  all().nodes[node].constant = constant;
  return node;
}

Node record_product(Node a, Node b) {
  const std::optional<double> x = all().nodes[a].constant, y = all().nodes[b].constant;
  if (x && y && std::fma(*x, *y, -(*x * *y)) == 0) return record(*x * *y);
  return record({"rnd (%0 * %1)", Tightness::application, Tightness::application}, {a, b});
}

Node record_pair(Node hi, Node lo) {
  const Recorded &first = all().nodes[hi], &second = all().nodes[lo];
  if (first.form.text == "hi %0" && second.form.text == "lo %0" && first.operands == second.operands)
    return first.operands.front();
  return record({"Twofold %0 %1", Tightness::application}, {hi, lo});
}

bool settled(Node condition) {
  const Recorded& term = all().nodes[condition];
  if (term.form.text == "negb %0") return !settled(term.operands[0]);
  const auto found = path().find(condition);
  if (found == path().end()) throw Unsettled{condition};
  return found->second;
}

void define(const std::string& comment, const std::string& head, const std::function<Built()>& build) {
  const Way way = ways(build);
  std::vector<Node> nodes;
  named(way, nodes);
  Writer writer;
  if (!comment.empty()) std::printf("\n(** %s *)", comment.c_str());
  std::printf("\n");
  print_wrapped("Definition " + head + " :=", 0);
  Uses uses(nodes);
  for (const Node node : uses.order) {
    if (uses.times[node] == 1 || all().nodes[node].operands.empty()) continue;
    const std::string name = "x" + std::to_string(writer.names.size() + 1);
    print_wrapped("let " + name + " := " + writer.text(node) + " in", 2);
    writer.names[node] = name;
  }
  print(writer, way, 2, "", ".");
}

}  // namespace durero::trace::HWY_NAMESPACE
