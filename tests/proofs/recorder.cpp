#include "proofs/recorder.hpp"

#include <algorithm>
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
std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string lines, line(indent, ' '), word;
  bool first = true;
  while (words >> word) {
    if (!first && line.size() + 1 + word.size() > 120) {
      lines += line + "\n";
      line.assign(indent + 4, ' ');
      first = true;
    }
    line += (first ? "" : " ") + word;
    first = false;
  }
  return lines + line + "\n";
}

std::string text_of(const Writer& writer, const Built& built, std::size_t indent, const std::string& before,
                    const std::string& after) {
  std::string lines, written = before + built.constructor;
  for (std::size_t i = 0; i < built.parts.size(); ++i) {
    if (built.names.empty()) {
      written += (written.empty() ? "" : " ") + writer.operand(built.parts[i], Tightness::name);
    } else {
      written =
          (i == 0 ? before + "{| " : "") + built.names[i] + " := " + writer.operand(built.parts[i], Tightness::other);
      if (i + 1 == built.parts.size()) break;
      lines += wrapped(written + ";", i == 0 ? indent : indent + 3);
    }
  }
  return lines +
         wrapped(written + (built.names.empty() ? "" : " |}") + after, built.names.empty() ? indent : indent + 3);
}

std::string text_of(const Writer& writer, const Way& way, std::size_t indent, const std::string& before,
                    const std::string& after) {
  if (!way.yes) return text_of(writer, way.built, indent, before, after);
  return wrapped(before + "if " + writer.operand(way.condition, Tightness::other) + " then", indent) +
         text_of(writer, *way.yes, indent + 2, "", "") + text_of(writer, *way.no, indent, "else ", after);
}

/// The text of what is built, with a name for each term that is used more than once.
std::string text_of(const Way& way) {
  std::vector<Node> nodes;
  named(way, nodes);
  const Uses uses(nodes);
  Writer writer;
  std::string lines;
  for (const Node node : uses.order) {
    if (uses.times.at(node) == 1 || all().nodes[node].operands.empty()) continue;
    const std::string name = "x" + std::to_string(writer.names.size() + 1);
    lines += wrapped("let " + name + " := " + writer.text(node) + " in", 2);
    writer.names[node] = name;
  }
  return lines + text_of(writer, way, 2, "", ".");
}

/// The head of a definition, NAME (x y : T) (z : U) : RESULT, in parts.
struct Head {
  std::string name, result;
  std::vector<std::pair<std::string, std::string>> arguments;  // each with its type

  explicit Head(const std::string& text) {
    std::size_t at = text.find_first_of(" (");
    name = text.substr(0, at);
    while ((at = text.find_first_not_of(' ', at)) != std::string::npos && text[at] == '(') {
      const std::size_t colon = text.find(" :", at), end = text.find(')', at);
      std::istringstream names(text.substr(at + 1, colon - at - 1));
      for (std::string argument; names >> argument;) arguments.emplace_back(argument, text.substr(colon, end - colon));
      at = end + 1;
    }
    result = text.substr(at);
  }
  /// What has these arguments says the same as what has those of the other, where both are written alike.
  bool covers(const Head& other) const {
    const auto mine = [this](const auto& argument) { return std::ranges::count(arguments, argument) != 0; };
    return result == other.result && std::ranges::all_of(other.arguments, mine);
  }
  std::string call() const {
    std::string text = name;
    for (const auto& [argument, type] : arguments) text += " " + argument;
    return text;
  }
};

/// What was written, by its text, so that none is written twice.
std::map<std::string, std::vector<Head>>& written() {
  static std::map<std::string, std::vector<Head>> heads;
  return heads;
}

/// A call of what has that text already, or that text. A name that is written again means the later.
std::string written_once(const std::string& head, const std::string& text) {
  const Head mine(head);
  for (auto& [of, heads] : written()) std::erase_if(heads, [&](const Head& other) { return other.name == mine.name; });
  std::vector<Head>& alike = written()[text];
  const auto same = std::ranges::find_if(alike, [&](const Head& other) { return mine.covers(other); });
  const std::string once = same == alike.end() ? text : wrapped(same->call() + ".", 2);
  alike.push_back(mine);
  return once;
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
  const std::string text = text_of(ways(build));
  if (!comment.empty()) std::printf("\n(** %s *)", comment.c_str());
  std::printf("\n%s%s", wrapped("Definition " + head + " :=", 0).c_str(), written_once(head, text).c_str());
}

}  // namespace durero::trace::HWY_NAMESPACE
