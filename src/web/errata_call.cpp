// The errata of the source texts, the paper's schemas as printed, and the scenes that draw two of them.
#include <algorithm>
#include <array>
#include <map>

#include "calls.hpp"
#include "json_text.hpp"
#include "prose.hpp"

namespace durero::embedded {
const std::map<std::string, std::string>& errata();
}

namespace durero::web {
namespace {

constexpr std::string_view list_file = "erratas.md", drawn_folder = "impresa/dibujo/";

/// An entry of the list, with the members of its points: `Printed`, `Defect`, `Correction`, `Proof`.
struct Erratum {
  std::string name, title, source;
  std::map<std::string, std::string> points{};
};

/// Adds a line to the point that is open; a line that begins `- WORD: ` opens one, and one that stands at the margin
/// closes it.
void add_line(Erratum& to, std::string& open, std::string_view line) {
  const std::size_t colon = line.find(": ");
  if (line.starts_with("- ") && colon != line.npos) {
    open = std::string(line.substr(2, colon - 2));
    to.points[open] = line.substr(colon + 2);
  } else if (line.starts_with("  ") && !open.empty()) {
    to.points[open].append(" ").append(line.substr(2));
  } else {
    open.clear();
  }
}

/// The entries of the list: a head of the second degree names a source, one of the fourth an entry.
std::vector<Erratum> read_list(std::string_view list) {
  std::vector<Erratum> all;
  std::string source, open;
  for (const std::string_view line : pieces_of(list, '\n')) {
    if (line.starts_with("## ")) source = line.substr(3);
    if (line.starts_with("#### ")) {
      const std::string_view head = line.substr(5);
      const std::size_t blank = std::min(head.find(' '), head.size());
      all.push_back(
          {std::string(head.substr(0, blank)), std::string(head.substr(std::min(blank + 1, head.size()))), source});
      open.clear();
    } else if (!all.empty()) {
      add_line(all.back(), open, line);
    }
  }
  return all;
}

bool is_of_label(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.';
}

/// The labels in a text: what stands between grave accents and has the form NAME.KIND.NUMBER.
std::vector<std::string> labels_in(std::string_view text) {
  std::vector<std::string> labels;
  const auto pieces = pieces_of(text, '`');
  for (std::size_t i = 1; i < pieces.size(); i += 2)
    if (std::ranges::count(pieces[i], '.') == 2 && std::ranges::all_of(pieces[i], is_of_label))
      labels.emplace_back(pieces[i]);
  return labels;
}

/// The names of errata in the comment that ends a printed line.
std::vector<std::string_view> marks_in(std::string_view line) {
  std::vector<std::string_view> marks;
  const std::size_t comment = line.find("% ");
  if (comment == line.npos || comment == 0) return marks;
  for (const std::string_view word : pieces_of(line.substr(comment + 2), ' '))
    if (word.size() > 1 && word.front() == 'E' &&
        std::ranges::all_of(word.substr(1), [](char c) { return c >= '0' && c <= '9'; }))
      marks.push_back(word);
  return marks;
}

std::string printed_line(std::string_view line, std::size_t number) {
  return ObjectText()
      .member("line", std::uint64_t{number})
      .member("text", line)
      .raw("marks", array_of_texts(marks_in(line)))
      .text();
}

std::string printed_file(const std::string& name, std::string_view text) {
  ArrayText lines;
  std::size_t number = 0;
  for (const std::string_view line : pieces_of(text, '\n')) lines.raw(printed_line(line, ++number));
  return ObjectText().member("file", "spec/" + name).raw("lines", lines.text()).text();
}

std::string entry_text(const Erratum& entry) {
  const auto point = [&](const char* of) {
    const auto found = entry.points.find(of);
    return found == entry.points.end() ? std::string() : found->second;
  };
  ObjectText text;
  text.member("name", entry.name)
      .member("title", entry.title)
      .member("source", entry.source)
      .member("printed", point("Printed"))
      .member("defect", point("Defect"))
      .member("correction", point("Correction"))
      .member("proof", point("Proof"))
      .raw("labels", array_of_texts(labels_in(point("Correction"))));
  const auto drawn = embedded::errata().find(std::string(drawn_folder) + entry.name + ".json");
  return text.raw("drawn", drawn == embedded::errata().end() ? "null" : json_of(drawn->second)).text();
}

bool is_printed_text(std::string_view name) { return name.ends_with(".tex") && !name.starts_with(drawn_folder); }

}  // namespace

std::string answer_errata(const AskedCall& asked) {
  asked.require({}, 0);
  ArrayText printed;
  for (const auto& [name, text] : embedded::errata())
    if (is_printed_text(name)) printed.raw(printed_file(name, text));
  return ObjectText()
      .raw("errata", array_of(read_list(embedded::errata().at(std::string(list_file))), entry_text))
      .raw("printed", printed.text())
      .member("drawn_text", embedded::errata().at(std::string(drawn_folder) + "superficies.tex"))
      .text();
}

}  // namespace durero::web
