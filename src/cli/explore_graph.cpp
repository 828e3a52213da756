#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "durero/spec/animation_text.hpp"
#include "explore_text.hpp"

namespace durero::cli {

using spec::Machine;
using spec::StateGraph;

namespace {

/// The lines of a state: a component each.
std::vector<std::string> state_lines(const Machine& machine, const zed::Valuation& state) {
  std::vector<std::string> lines;
  for (const auto& [name, value] : state) lines.push_back(name.text() + " == " + machine.written(name, value));
  return lines;
}

/// The steps from one state to another, on one arrow each.
std::map<std::pair<std::size_t, std::size_t>, std::vector<std::string>> arrows(const Machine& machine,
                                                                               const StateGraph& graph) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::string>> all;
  for (const StateGraph::Edge& edge : graph.steps)
    all[{edge.from, edge.to}].push_back(spec::step_line(machine, edge.step));
  return all;
}

std::string quoted_dot(const std::vector<std::string>& lines) {
  std::string text = "\"";
  for (const std::string& line : lines) {
    for (const char c : line) text += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    text += "\\l";  // the line ends there, and begins on the left
  }
  return text + "\"";
}

std::string escaped_svg(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return escaped;
}

/// The least number of steps from an initial state to each.
std::vector<std::size_t> layers_of(const StateGraph& graph) {
  std::vector<std::vector<std::size_t>> next(graph.states.size());
  for (const StateGraph::Edge& edge : graph.steps) next[edge.from].push_back(edge.to);
  std::vector<std::size_t> layer(graph.states.size(), graph.states.size()), queue;
  for (std::size_t at = 0; at < graph.initial; ++at) {
    layer[at] = 0;
    queue.push_back(at);
  }
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (const std::size_t to : next[queue[i]]) {
      if (layer[to] != graph.states.size()) continue;
      layer[to] = layer[queue[i]] + 1;
      queue.push_back(to);
    }
  return layer;
}

/// A box of a state in a drawing, in pixels.
struct StateBox {
  std::size_t x = 0, y = 0, width = 0, height = 0;
};

constexpr std::size_t line_height = 16, letter_width = 8, gap = 48;

std::size_t letters_of(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::vector<StateBox> placed_boxes(const std::vector<std::vector<std::string>>& lines,
                                   const std::vector<std::size_t>& layers) {
  std::vector<StateBox> boxes(lines.size());
  std::map<std::size_t, std::size_t> right, height;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    StateBox& box = boxes[i];
    for (const std::string& line : lines[i]) box.width = std::max(box.width, letters_of(line) * letter_width);
    box.width += letter_width * 2;
    box.height = (lines[i].size() + 1) * line_height;
    box.x = gap + right[layers[i]];
    right[layers[i]] = box.x + box.width;
    height[layers[i]] = std::max(height[layers[i]], box.height);
  }
  std::map<std::size_t, std::size_t> top;
  std::size_t down = gap;
  for (const auto& [layer, high] : height) {
    top[layer] = down;
    down += high + gap * 2;
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i].y = top[layers[i]];
  return boxes;
}

std::string box_svg(const StateBox& box, const std::vector<std::string>& lines, bool initial) {
  std::string text = fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\" fill=\"#fff\" stroke=\"#333\" "
      "stroke-width=\"{}\"/>\n",
      box.x, box.y, box.width, box.height, initial ? 3 : 1);
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", box.x + letter_width, box.y + (i + 1) * line_height,
                        escaped_svg(lines[i]));
  return text;
}

std::string arrow_svg(const StateBox& from, const StateBox& to, const std::vector<std::string>& steps, bool own) {
  const auto middle = [](const StateBox& box) { return box.x + box.width / 2; };
  std::string title;
  for (const std::string& step : steps) title += (title.empty() ? "" : "\n") + step;
  std::string path;
  if (own)
    path = fmt::format("M {} {} c 30 -24 30 24 0 12", from.x + from.width, from.y + from.height / 2);
  else if (from.y < to.y)
    path = fmt::format("M {} {} L {} {}", middle(from), from.y + from.height, middle(to), to.y);
  else
    path = fmt::format("M {} {} Q {} {} {} {}", middle(from), from.y, (middle(from) + middle(to)) / 2 + gap,
                       std::min(from.y, to.y) - std::min(from.y, gap / 2), middle(to),
                       to.y + (from.y > to.y ? to.height : 0));
  return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"#888\" marker-end=\"url(#to)\"><title>{}</title></path>\n",
                     path, escaped_svg(title));
}

}  // namespace

std::string graph_dot(const Machine& machine, const StateGraph& graph) {
  std::string text =
      "digraph states {\n  node [shape=box, fontname=\"monospace\"];\n  edge [fontname=\"monospace\"];\n";
  for (std::size_t at = 0; at < graph.states.size(); ++at)
    text += fmt::format("  s{} [label={}{}];\n", at, quoted_dot(state_lines(machine, graph.states[at])),
                        at < graph.initial ? ", penwidth=3" : "");
  for (const auto& [ends, steps] : arrows(machine, graph))
    text += fmt::format("  s{} -> s{} [label={}];\n", ends.first, ends.second, quoted_dot(steps));
  return text + "}\n";
}

std::string graph_svg(const Machine& machine, const StateGraph& graph) {
  std::vector<std::vector<std::string>> lines;
  for (const zed::Valuation& state : graph.states) lines.push_back(state_lines(machine, state));
  const std::vector<StateBox> boxes = placed_boxes(lines, layers_of(graph));
  std::size_t width = gap, height = gap;
  for (const StateBox& box : boxes) {
    width = std::max(width, box.x + box.width + gap);
    height = std::max(height, box.y + box.height + gap);
  }
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"monospace\" font-size=\"12\">\n<defs><marker id=\"to\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" "
      "markerWidth=\"8\" markerHeight=\"8\" orient=\"auto\"><path d=\"M 0 0 L 8 4 L 0 8 z\" "
      "fill=\"#888\"/></marker></defs>\n",
      width, height);
  for (const auto& [ends, steps] : arrows(machine, graph))
    text += arrow_svg(boxes[ends.first], boxes[ends.second], steps, ends.first == ends.second);
  for (std::size_t at = 0; at < boxes.size(); ++at) text += box_svg(boxes[at], lines[at], at < graph.initial);
  return text + "</svg>\n";
}

}  // namespace durero::cli
