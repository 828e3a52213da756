/// Completion: commands of LaTeX behind a backslash, which in a Unicode text give their characters; else the names in
/// scope, and words of the toolkit.

#include <set>
#include <string_view>

#include "durero/zed/names/names_in_scope.hpp"
#include "durero/zed/print/convert.hpp"
#include "durero/zed/print/print.hpp"
#include "lsp/answers.hpp"

namespace durero::lsp {
namespace {

constexpr std::int64_t function = 3, field = 5, variable = 6, struct_kind = 22, keyword = 14, constant = 21;

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

/// The first byte of the name that ends at one. In LaTeX `\_` is a letter.
std::size_t start_of_name(const std::string& text, std::size_t end, bool latex) {
  std::size_t from = end;
  while (from > 0) {
    const char before = text[from - 1];
    if (latex && before == '_' && from > 1 && text[from - 2] == '\\') {
      from -= 2;
    } else if (is_letter_or_digit(before) || (!latex && before == '_')) {
      --from;
    } else {
      break;
    }
  }
  return from;
}

struct CompletionItem {
  std::string label, inserted, detail;
  std::int64_t kind;
};

std::int64_t kind_of(const zed::VisibleName& name) {
  if (name.form == zed::Referent::Form::component) return field;
  if (name.form == zed::Referent::Form::variable) return variable;
  if (!name.type) return constant;
  if (name.type->is_schema_set()) return struct_kind;
  const bool relates = name.type->is(zed::Type::Kind::power) && name.type->parts()[0].is(zed::Type::Kind::product);
  return relates ? function : constant;
}

/// The section that stands at a byte of a file: that of the last name before it, or the file's first.
std::string section_at(const zed::CheckedTexts& of, const zed::CrossReference& names, const std::string& file,
                       std::size_t byte) {
  std::string section;
  if (const auto all = names.files.find(file); all != names.files.end())
    for (const zed::Occurrence& each : all->second)
      if (section.empty() || each.from <= byte) section = each.section;
  for (const zed::Section& each : of.read.sections)
    if (section.empty() && each.file == file) section = each.name;
  return section;
}

std::vector<CompletionItem> commands(const zed::CheckedTexts& of, const std::string& section, bool latex) {
  std::vector<CompletionItem> items;
  for (const auto& [command, unicode] : zed::latex_commands(of.read, section)) {
    const std::string typed = "\\" + command;
    items.push_back({typed, latex ? typed : unicode, unicode, keyword});
  }
  return items;
}

/// The names in scope, and the toolkit's words that are written plainly in this mark-up.
std::vector<CompletionItem> names(const std::vector<zed::VisibleName>& visible, const zed::CheckedTexts& of,
                                  const std::string& section, bool latex, bool with_toolkit) {
  const auto known = of.read.markup.find(section);
  const zed::Markup markup = known == of.read.markup.end() ? zed::Markup() : known->second;
  std::vector<CompletionItem> items;
  for (const zed::VisibleName& each : visible) {
    const std::string label = each.name.text();
    items.push_back({label, latex ? zed::to_latex(zed::reference(each.name), markup) : label,
                     each.type ? each.type->settled().text() : std::string(), kind_of(each)});
  }
  if (!with_toolkit) return items;
  for (const std::string& word : zed::plain_toolkit_names()) items.push_back({word, word, "toolkit", function});
  if (latex) return items;
  for (const auto& [command, word] : zed::latex_commands(of.read, section))
    if (is_letter_or_digit(word.front())) items.push_back({word, word, "toolkit", keyword});
  return items;
}

}  // namespace

void TextAnswers::completion(const JsonValue& params, JsonWriter& to) {
  const RequestedPlace asked = place_of(params);
  const std::string& text = asked.file->text.text();
  const zed::CheckedTexts& of = asked.analysis->checked();
  const bool latex = zed::form_of(text) != zed::Form::unicode;
  std::size_t from = start_of_name(text, asked.byte, latex);
  const bool command = from > 0 && text[from - 1] == '\\';
  const bool selects = from > 0 && text[from - 1] == '.';
  if (command) --from;
  const auto visible = zed::names_in_scope(of.texts, asked.path, from, asked.byte);
  const std::string section = section_at(of, asked.analysis->names(), asked.path, asked.byte);
  std::vector<CompletionItem> items;
  if (visible) items = command ? commands(of, section, latex) : names(*visible, of, section, latex, !selects);
  to.StartArray();
  for (const CompletionItem& each : items) {
    to.StartObject();
    put(to, "label", each.label);
    put(to, "kind", each.kind);
    if (!each.detail.empty()) put(to, "detail", each.detail);
    put(to, "filterText", command ? each.label : each.inserted);
    to.Key("textEdit");
    to.StartObject();
    to.Key("range");
    range(asked.file->text, from, asked.byte, to);
    put(to, "newText", each.inserted);
    to.EndObject();
    to.EndObject();
  }
  to.EndArray();
}

}  // namespace durero::lsp
