/// The obligations of a refinement as a section of Z.
#include <fmt/format.h>

#include <algorithm>

#include "durero/spec/refinement.hpp"
#include "durero/zed/print/print.hpp"

namespace durero::spec {
namespace {

std::string for_latex(const std::string& name) {
  std::string out;
  for (const char c : name) out += c == '_' ? "\\_" : std::string(1, c);
  return out;
}

/// A name that no section of the text has.
std::string section_of_obligations(const zed::Specification& text) {
  std::string name = "obligations";
  for (int i = 2; text.find(name); ++i) name = "obligations_" + std::to_string(i);
  return name;
}

/// The sections of the text that are no parent of another, by which all are seen.
std::string last_sections(const zed::Specification& text) {
  std::string names;
  for (const zed::Section& section : text.sections) {
    const bool is_parent = std::ranges::any_of(text.sections, [&](const zed::Section& other) {
      return std::ranges::find(other.parents, section.name) != other.parents.end();
    });
    if (!is_parent) names += (names.empty() ? "" : ", ") + section.name;
  }
  return names;
}

std::string subject(const Refinement& refinement, const Obligation& obligation) {
  if (obligation.operation == refinement.operations.size()) return obligation_word(obligation.kind);
  const OperationPair& pair = refinement.operations[obligation.operation];
  return fmt::format("{} of {} for {}", obligation_word(obligation.kind), pair.concrete, pair.abstract);
}

}  // namespace

std::string obligations_text(const zed::Specification& text, const Refinement& refinement,
                             const std::vector<Obligation>& all, bool latex) {
  const auto name = [latex](const std::string& plain) { return latex ? for_latex(plain) : plain; };
  std::string said = name(fmt::format("The obligations of a {} simulation: {} refines {}, through {}.\n\n",
                                      refinement.backward ? "backward" : "forward", refinement.concrete,
                                      refinement.abstract, refinement.retrieve));
  const std::string section = name(section_of_obligations(text)), parents = name(last_sections(text));
  said += latex ? fmt::format("\\begin{{zsection}}\n  \\SECTION {} \\parents {}\n\\end{{zsection}}\n", section, parents)
                : fmt::format("─ section {} parents {}\n└\n", section, parents);
  zed::Markup markup;
  for (const auto& [of, commands] : text.markup) markup.insert(commands.begin(), commands.end());
  for (const Obligation& obligation : all) {
    const zed::Paragraph paragraph{{}, zed::Conjecture{{obligation.claim, obligation.label, {}}, {}}};
    said += fmt::format("\nFor {}:\n\n", name(subject(refinement, obligation)));
    said += latex ? zed::to_latex(paragraph, markup) : "─\n" + zed::to_unicode(paragraph) + "└\n";
  }
  return said;
}

}  // namespace durero::spec
