#include "held_text.hpp"

#include <algorithm>
#include <map>

#include "durero/spec/spec.hpp"
#include "durero/spec/text_check.hpp"
#include "durero/zed/review/review.hpp"
#include "held.hpp"

namespace durero::embedded {
const std::map<std::string, std::string>& labels();
}

namespace durero::web {
namespace {

constexpr std::size_t most_texts = 8;

/// Whether a section of a text has a parent that the text lacks and the program's own has.
bool needs_own(const zed::Specification& alone) {
  return std::ranges::any_of(alone.sections, [&](const zed::Section& section) {
    return std::ranges::any_of(section.parents, [&](const std::string& parent) {
      return !alone.find(parent) && spec::text().find(parent) != nullptr;
    });
  });
}

zed::Specification read_held(const std::string& name, const std::string& text) {
  std::map<std::string, std::string> texts{{name, text}};
  zed::Specification alone = zed::read_texts(texts);
  if (!needs_own(alone)) return alone;
  for (const zed::Section& own : spec::text().sections)
    if (!alone.find(own.name)) texts.emplace(own.file, spec::files().at(own.file));
  return zed::read_texts(texts);
}

[[noreturn]] void refuse(const zed::Defect& defect) {
  throw io::InputError(defect.file, {defect.place.line, defect.place.column}, defect.what, defect.expected);
}

std::shared_ptr<const HeldText> held_text(std::string name, zed::Specification text, bool own) {
  auto made = std::make_shared<HeldText>(HeldText{std::move(name), std::move(text), {}, own});
  made->typing = zed::check(made->text);
  return made;
}

}  // namespace

void HeldText::require_right() const {
  for (const auto* defects : {&text.defects, &typing.defects})
    for (const zed::Defect& defect : *defects)
      if (defect.severity == zed::Defect::Severity::error) refuse(defect);
  if (own) return;
  for (const zed::Defect& empty : zed::without_paragraphs({name}, text)) refuse(empty);
}

std::shared_ptr<const HeldText> text_of(const AskedCall& asked) {
  thread_local Held<HeldText> held(most_texts);
  if (!asked.has("text")) {
    if (asked.has("name"))
      asked.source().fail(asked.at("name").offset(), "name names no text", "expected text beside it");
    return held.of("", [] { return held_text("spec", spec::text(), true); });
  }
  const std::string name = asked.text("name", "text"), text = asked.text("text", "");
  const std::string key = name + std::string(1, '\0') + text;
  return held.of(key, [&] { return held_text(name, read_held(name, text), false); });
}

const std::string& label_table() { return embedded::labels().begin()->second; }

}  // namespace durero::web
