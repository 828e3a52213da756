// Z texts checked, in the lines of `durero spec check`.
#include <array>

#include "calls.hpp"
#include "durero/spec/constants.hpp"
#include "durero/spec/text_check.hpp"
#include "held_text.hpp"
#include "json_text.hpp"

namespace durero::web {
namespace {

constexpr std::array<std::string_view, 5> check_text_keys{"text", "name", "states", "let", "strict"};

std::string defect_text(const zed::Defect& defect) {
  constexpr std::array<std::string_view, 3> severities{"error", "warning", "opinion"};
  return ObjectText()
      .member("file", defect.file)
      .member("line", std::uint64_t{defect.place.line})
      .member("column", std::uint64_t{defect.place.column})
      .member("severity", severities[static_cast<std::size_t>(defect.severity)])
      .member("message", defect.what)
      .member("expected", defect.expected)
      .text();
}

std::string conjecture_text(const spec::TriedConjecture& tried) {
  const zed::Trial& trial = tried.trial;
  return ObjectText()
      .member("file", trial.file)
      .member("line", std::uint64_t{trial.place.line})
      .member("column", std::uint64_t{trial.place.column})
      .member("label", trial.label)
      .member("theorem", tried.theorem)
      .member("tried", std::uint64_t{trial.tried})
      .member("refuted", !trial.counterexample.empty())
      .raw("counterexample", array_of_lines(trial.counterexample, true))
      .member("why_not", trial.why_not)
      .text();
}

std::string section_text(const zed::Section& section) {
  return ObjectText()
      .member("file", section.file)
      .member("name", section.name)
      .member("paragraphs", std::uint64_t{section.paragraphs.size()})
      .text();
}

spec::TextCheck checked_text(const AskedCall& asked, const HeldText& text) {
  const spec::TextCheckSetup setup{asked.texts("let"), static_cast<std::size_t>(asked.whole("states", 0, 1'000'000, 8)),
                                   asked.flag("strict", false), text.own};
  const std::vector<std::string> files = text.own ? std::vector<std::string>{} : std::vector{text.name};
  try {
    return spec::check_text(text.text, text.typing, files, setup, spec::LabelIndex(text.own ? label_table() : ""));
  } catch (const spec::ConstantError& error) {
    throw io::InputError("let", {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
  }
}

}  // namespace

std::string answer_zed_check(const AskedCall& asked) {
  asked.require(check_text_keys, 0);
  const auto text = text_of(asked);
  const spec::TextCheck check = checked_text(asked, *text);
  return ObjectText()
      .member("ok", check.is_read() && !check.is_refuted())
      .raw("defects", array_of(check.defects, defect_text))
      .raw("sections", array_of(text->text.sections, section_text))
      .raw("conjectures", array_of(check.conjectures, conjecture_text))
      .raw("taken", array_of_texts(spec::taken_lines(check.taken)))
      .raw("lines", array_of_lines(check.lines(), true))
      .text();
}

}  // namespace durero::web
