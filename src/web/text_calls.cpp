// The program's own text, paragraph by paragraph, and where each of its predicates is carried out.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "calls.hpp"
#include "durero/spec/label_index.hpp"
#include "durero/spec/spec.hpp"
#include "durero/text/shown.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"
#include "held_text.hpp"
#include "json_text.hpp"
#include "labelled.hpp"
#include "prose.hpp"

namespace durero::embedded {
const std::map<std::string, std::string>& assumptions();
}

namespace durero::web {
namespace {

constexpr std::array<std::string_view, 1> text_keys{"file"};
constexpr std::array<std::string_view, 1> labels_keys{"of"};

/// A part of a file, prose or a paragraph, by the line that it begins on.
struct FilePart {
  std::uint32_t line;
  std::string json;
};

std::string line_text(const LabelledLine& line) {
  ObjectText text;
  text.member("text", line.text).member("line", std::uint64_t{line.place.line});
  if (line.declares) text.member("declares", true);
  if (!line.label.empty()) text.member("label", line.label);
  return text.text();
}

std::string paragraph_part(const zed::Paragraph& paragraph) {
  return ObjectText()
      .member("kind", kind_of(paragraph))
      .raw("names", array_of(zed::names_of(paragraph), [](const zed::Name& name) { return json_of(name.text()); }))
      .member("line", std::uint64_t{paragraph.place.line})
      .member("latex", zed::to_latex(paragraph))
      .raw("lines", array_of(lines_of(paragraph), line_text))
      .text();
}

std::string parts_text(const zed::Section& section) {
  std::vector<FilePart> parts;
  for (const Prose& prose : prose_of(spec::files().at(section.file)))
    parts.push_back(
        {prose.line, ObjectText().member("prose", prose.text).member("line", std::uint64_t{prose.line}).text()});
  for (const zed::Paragraph& paragraph : section.paragraphs)
    parts.push_back({paragraph.place.line, paragraph_part(paragraph)});
  std::ranges::stable_sort(parts, {}, &FilePart::line);
  return array_of(parts, [](const FilePart& part) { return part.json; });
}

ObjectText section_head(const zed::Section& section) {
  ObjectText text;
  text.member("file", section.file).member("section", section.name).raw("parents", array_of_texts(section.parents));
  return text;
}

/// The axioms that each theorem rests on, by its name: proofs/assumptions.txt, a line `NAME: AXIOM AXIOM` or `NAME:
/// none` each.
const std::map<std::string, std::vector<std::string>>& axioms() {
  static const std::map<std::string, std::vector<std::string>> all = [] {
    std::map<std::string, std::vector<std::string>> read;
    std::string_view rest = embedded::assumptions().begin()->second;
    while (!rest.empty()) {
      std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
      auto& of = read[std::string(line.substr(0, line.find(':')))];
      while (line.find(' ') != line.npos) {
        line.remove_prefix(line.find(' ') + 1);
        if (const std::string_view axiom = line.substr(0, line.find(' ')); axiom != "none") of.emplace_back(axiom);
      }
    }
    return read;
  }();
  return all;
}

/// Every axiom that a theorem rests on.
std::string all_axioms() {
  std::set<std::string> all;
  for (const auto& [theorem, of] : axioms()) all.insert(of.begin(), of.end());
  return array_of_texts(all);
}

std::string theorem_text(const spec::LabelPlace& at) {
  const auto of = axioms().find(at.name);
  ObjectText text;
  text.member("name", at.name).member("place", at.place);
  return text.raw("assumptions", of == axioms().end() ? "null" : array_of_texts(of->second)).text();
}

std::string label_text(const spec::LabelIndex& index, const zed::Section& section, const zed::Paragraph& paragraph,
                       const LabelledLine& line) {
  std::map<std::string, ArrayText> places;
  for (const spec::LabelPlace& at : index.all(line.label))
    places[at.kind].raw(at.kind == "theorem" ? theorem_text(at) : json_of(at.place));
  const auto names = zed::names_of(paragraph);
  return ObjectText()
      .member("label", line.label)
      .member("predicate", line.text)
      .member("text", fmt::format("{}:{}", section.file, line.place.line))
      .member("paragraph", names.empty() ? std::string() : names.front().text())
      .raw("clauses", places["clause"].text())
      .raw("functions", places["function"].text())
      .raw("tests", places["test"].text())
      .raw("theorems", places["theorem"].text())
      .member("status", places["theorem"].text() != "[]" ? "proved"
                        : places["test"].text() != "[]"  ? "tested"
                                                         : "stated")
      .text();
}

}  // namespace

std::string answer_text(const AskedCall& asked) {
  asked.require(text_keys, 0);
  const auto& sections = spec::text().sections;
  if (!asked.has("file"))
    return ObjectText()
        .raw("files", array_of(sections, [](const zed::Section& section) { return section_head(section).text(); }))
        .text();
  const std::string file = asked.text("file", "");
  const auto section = std::ranges::find(sections, file, &zed::Section::file);
  if (section == sections.end())
    asked.source().fail(asked.at("file").offset(), "the text has no file " + text::shown(file),
                        "expected one of those that text without a file names");
  return section_head(*section).raw("parts", parts_text(*section)).text();
}

std::string answer_labels(const AskedCall& asked) {
  asked.require(labels_keys, 0);
  const std::string of = asked.text("of", "");
  static const spec::LabelIndex& index = *new spec::LabelIndex(label_table());  // no end of the program takes it apart
  ArrayText labels;
  for (const zed::Section& section : spec::text().sections)
    for (const zed::Paragraph& paragraph : section.paragraphs)
      for (const LabelledLine& line : lines_of(paragraph))
        if (!line.label.empty() && (of.empty() || of == line.label || zed::is_named(paragraph, of)))
          labels.raw(label_text(index, section, paragraph, line));
  if (labels.text() == "[]")
    asked.source().fail(asked.at("of").offset(), "the text has no label of " + text::shown(of),
                        "expected a label, or a name that the text declares with labels");
  return ObjectText().raw("labels", labels.text()).raw("axioms", all_axioms()).text();
}

}  // namespace durero::web
