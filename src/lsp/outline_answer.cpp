#include <algorithm>

#include "durero/zed/names/outline.hpp"
#include "lsp/answers.hpp"

namespace durero::lsp {
namespace {

using Part = zed::OutlineEntry::Part;

/// The kinds of symbols that the protocol numbers.
std::int64_t symbol_kind(Part part) {
  constexpr std::int64_t module = 2, property = 7, field = 8, enumeration = 10, function = 12, constant = 14,
                         event = 24, struct_kind = 23, member = 22, type = 26;
  switch (part) {
    case Part::section:
      return module;
    case Part::given:
      return type;
    case Part::free_type:
      return enumeration;
    case Part::branch:
      return member;
    case Part::definition:
      return constant;
    case Part::axiom:
      return function;
    case Part::schema:
      return struct_kind;
    case Part::component:
      return field;
    case Part::conjecture:
      return event;
  }
  return property;
}

}  // namespace

void TextAnswers::document_symbol(const JsonValue& params, JsonWriter& to) {
  const RequestedPlace asked = file_of(params);
  symbols(asked, zed::outline(asked.analysis->checked(), asked.path), {}, to);
}

void TextAnswers::symbols(const RequestedPlace& asked, const std::vector<zed::OutlineEntry>& entries,
                          const std::string& within, JsonWriter& to) {
  const bool nested = options_.nested_symbols;
  if (nested || within.empty()) to.StartArray();
  for (const zed::OutlineEntry& each : entries) {
    to.StartObject();
    put(to, "name", each.name);
    put(to, "kind", symbol_kind(each.part));
    if (nested) {
      put(to, "detail", each.detail);
      to.Key("range");
      range(asked.file->text, each.from, each.to, to);
      to.Key("selectionRange");
      range(asked.file->text, each.name_from, each.name_to, to);
      to.Key("children");
      symbols(asked, each.entries, each.name, to);
    } else {
      if (!within.empty()) put(to, "containerName", within);
      to.Key("location");
      to.StartObject();
      put(to, "uri", asked.file->uri);
      to.Key("range");
      range(asked.file->text, each.name_from, each.name_to, to);
      to.EndObject();
    }
    to.EndObject();
    if (!nested) symbols(asked, each.entries, each.name, to);
  }
  if (nested || within.empty()) to.EndArray();
}

}  // namespace durero::lsp
