#include "durero/spec/label_index.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "durero/spec/calculator.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"

namespace durero::spec {
namespace {

std::string paragraph_text(const zed::Section& section, const zed::Paragraph& paragraph, const std::string& name,
                           const LabelIndex& index) {
  std::string said = fmt::format("{}:{}\n{}", section.file, paragraph.place.line, zed::to_unicode(paragraph));
  const std::vector<std::string> labels = zed::labels_of(paragraph);
  const bool is_label = std::find(labels.begin(), labels.end(), name) != labels.end();
  for (const std::string& label : labels) {
    if (!is_label || label == name) said += "\n" + index.places(label);
  }
  return said;
}

/// The name without the places of operands at its ends, in either mark-up: `divides` of `_ divides _`.
std::string operator_word(std::string name) {
  std::erase_if(name, [](char c) { return c == ' ' || c == '\\'; });
  const std::size_t first = name.find_first_not_of('_');
  return first == name.npos ? "" : name.substr(first, name.find_last_not_of('_') + 1 - first);
}

bool is_operator_of(const zed::Paragraph& paragraph, const std::string& name) {
  const std::string word = operator_word(name);
  const std::vector<zed::Name> names = zed::names_of(paragraph);
  return !word.empty() && std::any_of(names.begin(), names.end(), [&](const zed::Name& declared) {
    return operator_word(declared.text()) == word;
  });
}

/// What declares the name; else the first schema with a component of that name; else an operator of that word; else
/// nothing.
std::string declaration_text(const zed::Specification& specification, const std::string& name,
                             const LabelIndex& index) {
  for (const auto& declares : {zed::is_named, zed::has_component, is_operator_of}) {
    for (const zed::Section& section : specification.sections) {
      for (const zed::Paragraph& paragraph : section.paragraphs) {
        if (declares(paragraph, name)) return paragraph_text(section, paragraph, name, index);
      }
    }
  }
  return {};
}

/// Says whether the text has the word, and not as a part of another.
bool has_word(std::string_view text, std::string_view word) {
  const auto goes_on = [](char c) {
    return c == '_' || c == '?' || c == '!' || ('0' <= c && c <= '9') || ('A' <= c && c <= 'Z') ||
           ('a' <= c && c <= 'z');
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !goes_on(text[at - 1])) && (end == text.size() || !goes_on(text[end]))) return true;
  }
  return false;
}

bool has_variable(const zed::Paragraph& paragraph, const std::string& name) {
  return !zed::names_of(paragraph).empty() && has_word(zed::to_unicode(paragraph), name);
}

/// ΔS and ΞS, which no paragraph declares: what they stand for, then S.
std::string change_text(const zed::Specification& specification, const std::string& name, const LabelIndex& index) {
  constexpr std::string_view delta = "Δ", xi = "Ξ";
  static_assert(delta.size() == xi.size());
  const bool nothing_changes = name.starts_with(xi);
  if (!name.starts_with(delta) && !nothing_changes) return {};
  const std::string state = name.substr(delta.size());
  const std::string said = state.empty() ? "" : declaration_text(specification, state, index);
  if (said.empty()) return {};
  return fmt::format("{0} == [{1}; {1} '{2}]\n\n{3}", name, state,
                     nothing_changes ? fmt::format(" | θ {0} = θ {0} '", state) : "", said);
}

}  // namespace

LabelIndex::LabelIndex(std::string table) : table_(std::move(table)) {
  const auto taken = [](std::string_view& rest, char end) {
    const std::string_view cell = rest.substr(0, rest.find(end));
    rest.remove_prefix(std::min(cell.size() + 1, rest.size()));
    return cell;
  };
  for (std::string_view rest = table_; !rest.empty();) {
    std::string_view line = taken(rest, '\n');
    const std::string_view label = taken(line, '\t'), kind = taken(line, '\t'), place = taken(line, '\t');
    entries_.push_back({label, kind, place, taken(line, '\t')});
  }
  std::ranges::stable_sort(entries_, {}, &Entry::label);
}

std::span<const LabelIndex::Entry> LabelIndex::of(std::string_view label) const {
  return std::ranges::equal_range(entries_, label, {}, &Entry::label);
}

std::string LabelIndex::theorem(const std::string& label) const {
  const auto entries = of(label);
  const auto found = std::ranges::find(entries, "theorem", &Entry::kind);
  return std::string(found == entries.end() ? std::string_view() : found->name);
}

std::string LabelIndex::carried_out(const std::string& label_or_name) const {
  const auto entries = of(label_or_name);
  const auto found = std::ranges::find_if(entries, [](const Entry& entry) {
    return entry.kind == "clause" || entry.kind == "function" || entry.kind == "type";
  });
  return std::string(found == entries.end() ? std::string_view() : found->place);
}

std::string LabelIndex::places(const std::string& label) const {
  std::string said = label + "\n";
  for (const std::string_view kind : {"text", "clause", "function", "test", "theorem"}) {
    for (const Entry& entry : of(label)) {
      if (entry.kind != kind) continue;
      said +=
          fmt::format("  {:<8}  {}{}\n", kind, entry.place, entry.name.empty() ? "" : fmt::format("  {}", entry.name));
    }
  }
  return said;
}

std::vector<LabelPlace> LabelIndex::all(const std::string& label) const {
  std::vector<LabelPlace> places;
  for (const Entry& entry : of(label))
    places.push_back({std::string(entry.kind), std::string(entry.place), std::string(entry.name)});
  return places;
}

std::string shown(const zed::Specification& specification, const std::string& name, const LabelIndex& index) {
  const std::string unicode = in_unicode(specification, name);
  const std::string said = declaration_text(specification, unicode, index);
  return said.empty() ? change_text(specification, unicode, index) : said;
}

std::optional<NameLocation> name_location(const zed::Specification& specification, const std::string& name,
                                          const LabelIndex& index) {
  for (const auto& has : {zed::is_named, zed::has_component, has_variable}) {
    for (const zed::Section& section : specification.sections) {
      for (const zed::Paragraph& paragraph : section.paragraphs) {
        if (!has(paragraph, name)) continue;
        const std::vector<zed::Name> names = zed::names_of(paragraph);
        const std::string first = names.empty() ? std::string() : names.front().text();
        NameLocation place{fmt::format("{}:{}", section.file, paragraph.place.line), first, index.carried_out(first)};
        for (const std::string& label : zed::labels_of(paragraph))
          if (place.program.empty()) place.program = index.carried_out(label);
        return place;
      }
    }
  }
  return std::nullopt;
}

std::vector<std::string> names_and_labels(const zed::Specification& specification) {
  std::vector<std::string> names;
  for (const zed::Section& section : specification.sections) {
    for (const zed::Paragraph& paragraph : section.paragraphs) {
      for (const zed::Name& name : zed::names_of(paragraph)) {
        names.push_back(name.text());
        if (const std::string word = operator_word(name.text()); word != name.text()) names.push_back(word);
      }
      const auto labels = zed::labels_of(paragraph);
      names.insert(names.end(), labels.begin(), labels.end());
    }
  }
  return names;
}

std::string in_unicode(const zed::Specification& specification, const std::string& name) {
  if (name.find('\\') == name.npos) return name;
  try {
    const zed::Term term = parsed(name, notation_of(specification));
    return term->kind == zed::Kind::reference ? term->name.text() : name;
  } catch (const zed::ZError&) {
    return name;
  }
}

}  // namespace durero::spec
