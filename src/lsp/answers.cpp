#include "lsp/answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "durero/zed/names/explanation.hpp"
#include "durero/zed/names/rename.hpp"
#include "durero/zed/print/block_layout.hpp"
#include "lsp/file_uri.hpp"

namespace durero::lsp {

EditorPosition position_in(const JsonValue& params) {
  return {count_member(params, "line"), count_member(params, "character")};
}

TextAnswers::RequestedPlace TextAnswers::file_of(const JsonValue& params) {
  RequestedPlace asked;
  asked.path = path_of_uri(text_member(member(params, "textDocument"), "uri"));
  asked.file = workspace_.find(asked.path);
  if (!asked.file) throw RpcError(ErrorCode::invalid_params, asked.path + " is not open; expected an open text");
  asked.analysis = &workspace_.analysis(asked.path);
  return asked;
}

TextAnswers::RequestedPlace TextAnswers::place_of(const JsonValue& params) {
  const EditorPosition position = position_in(member(params, "position"));
  RequestedPlace asked = file_of(params);
  asked.byte = asked.file->text.byte_of(position);
  return asked;
}

const zed::Occurrence* TextAnswers::occurrence_at(const RequestedPlace& asked) {
  return asked.analysis->names().at(asked.path, asked.byte);
}

namespace {

void put_position(EditorPosition position, JsonWriter& to) {
  to.StartObject();
  put(to, "line", std::int64_t{position.line});
  put(to, "character", std::int64_t{position.character});
  to.EndObject();
}

}  // namespace

void TextAnswers::range(const EditedText& text, std::size_t from, std::size_t to, JsonWriter& writer) const {
  writer.StartObject();
  writer.Key("start");
  put_position(text.position_of(from), writer);
  writer.Key("end");
  put_position(text.position_of(to), writer);
  writer.EndObject();
}

void TextAnswers::location(const GroupAnalysis& in, const std::string& path, const zed::Occurrence& of,
                           JsonWriter& to) {
  to.StartObject();
  put(to, "uri", workspace_.uri_of(path));
  to.Key("range");
  range(workspace_.text_of(in, path, options_.unit), of.from, of.to, to);
  to.EndObject();
}

void TextAnswers::locations(const RequestedPlace& asked, bool declarations, bool uses, JsonWriter& to) {
  const zed::Occurrence* occurrence = occurrence_at(asked);
  to.StartArray();
  if (occurrence && occurrence->referent)
    for (const auto& [path, all] : asked.analysis->names().files)
      for (const zed::Occurrence& each : all)
        if (each.referent == occurrence->referent && (each.declares ? declarations : uses))
          location(*asked.analysis, path, each, to);
  to.EndArray();
}

void TextAnswers::definition(const JsonValue& params, JsonWriter& to) { locations(place_of(params), true, false, to); }

void TextAnswers::references(const JsonValue& params, JsonWriter& to) {
  const JsonValue* declarations = find_member(params, "context", "includeDeclaration");
  locations(place_of(params), !declarations || !declarations->IsFalse(), true, to);
}

void TextAnswers::document_highlight(const JsonValue& params, JsonWriter& to) {
  constexpr std::int64_t read = 2, write = 3;
  const RequestedPlace asked = place_of(params);
  const zed::Occurrence* occurrence = occurrence_at(asked);
  to.StartArray();
  if (occurrence && occurrence->referent)
    for (const zed::Occurrence& each : asked.analysis->names().files.at(asked.path)) {
      if (each.referent != occurrence->referent) continue;
      to.StartObject();
      to.Key("range");
      range(asked.file->text, each.from, each.to, to);
      put(to, "kind", each.declares ? write : read);
      to.EndObject();
    }
  to.EndArray();
}

namespace {

std::string hover_line(const zed::Explanation& told) {
  std::string line = told.notation;
  if (!told.type.empty()) line += " : " + told.type;
  if (!told.value.empty()) line += "\n= " + told.value;
  return line;
}

std::string hover_text(const zed::Explanation& told, bool markdown) {
  const auto code = [&](const std::string& text) { return markdown ? "```z\n" + text + "\n```\n" : text + "\n"; };
  std::string all = code(hover_line(told));
  if (!told.form.empty()) all += told.form + "\n";
  if (!told.declaration.empty()) all += (markdown ? "\n" : "") + code(told.declaration);
  return all;
}

}  // namespace

void TextAnswers::hover(const JsonValue& params, JsonWriter& to) {
  const RequestedPlace asked = place_of(params);
  const auto told = zed::explanation(asked.analysis->checked(), asked.analysis->names(), asked.path, asked.byte);
  if (!told) {
    to.Null();
    return;
  }
  to.StartObject();
  to.Key("contents");
  to.StartObject();
  put(to, "kind", options_.markdown ? "markdown" : "plaintext");
  put(to, "value", hover_text(*told, options_.markdown));
  to.EndObject();
  to.Key("range");
  range(asked.file->text, told->from, told->to, to);
  to.EndObject();
}

namespace {

const zed::Occurrence& required(const zed::Occurrence* occurrence) {
  if (!occurrence) throw RpcError(ErrorCode::request_failed, "no name stands here; expected a name to rename");
  return *occurrence;
}

}  // namespace

void TextAnswers::prepare_rename(const JsonValue& params, JsonWriter& to) {
  const RequestedPlace asked = place_of(params);
  const zed::Occurrence& occurrence = required(occurrence_at(asked));
  const std::string word = zed::word_to_rename(asked.analysis->checked(), asked.analysis->names(), occurrence);
  to.StartObject();
  to.Key("range");
  range(asked.file->text, occurrence.from, occurrence.to, to);
  put(to, "placeholder", word);
  to.EndObject();
}

void TextAnswers::rename(const JsonValue& params, JsonWriter& to) {
  const std::string name = text_member(params, "newName");
  const RequestedPlace asked = place_of(params);
  const zed::Occurrence& occurrence = required(occurrence_at(asked));
  const auto edits = zed::renamed(asked.analysis->checked(), asked.analysis->names(), occurrence, name);
  to.StartObject();
  to.Key("changes");
  to.StartObject();
  for (const auto& [path, replacements] : edits) {
    const std::string uri = workspace_.uri_of(path);
    const EditedText text = workspace_.text_of(*asked.analysis, path, options_.unit);
    to.Key(uri.c_str());
    to.StartArray();
    for (const zed::Replacement& each : replacements) {
      to.StartObject();
      to.Key("range");
      range(text, each.from, each.to, to);
      put(to, "newText", each.text);
      to.EndObject();
    }
    to.EndArray();
  }
  to.EndObject();
  to.EndObject();
}

void TextAnswers::formatting(const JsonValue& params, JsonWriter& to) {
  const RequestedPlace asked = file_of(params);
  const zed::Specification& read = asked.analysis->checked().read;
  for (const zed::Defect& defect : read.defects)
    if (defect.file == asked.path) throw RpcError(ErrorCode::request_failed, defect.text());
  to.StartArray();
  for (const zed::Replacement& each : zed::block_layout(asked.file->text.text(), read)) {
    to.StartObject();
    to.Key("range");
    range(asked.file->text, each.from, each.to, to);
    put(to, "newText", each.text);
    to.EndObject();
  }
  to.EndArray();
}

namespace {

constexpr std::int64_t error_severity = 1, warning_severity = 2, information_severity = 3;

std::int64_t severity_of(const zed::Defect& defect) {
  switch (defect.severity) {
    case zed::Defect::Severity::error:
      return error_severity;
    case zed::Defect::Severity::warning:
      return warning_severity;
    case zed::Defect::Severity::opinion:
      return information_severity;
  }
  return error_severity;
}

/// The message of a defect, as `durero spec check` says it behind the place.
std::string message_of(zed::Defect defect) {
  defect.severity = zed::Defect::Severity::error;  // the weight is told apart
  const std::string line = defect.text();
  const std::string place = fmt::format(":{}:{}: ", defect.place.line, defect.place.column);
  const std::size_t at = line.find(place);
  return at == line.npos ? line : line.substr(at + place.size());
}

/// The counterexample of a conjecture, as `durero spec check` gives it behind the place.
std::string message_of(const zed::Trial& trial) {
  const std::string label = trial.label.empty() ? "" : " " + trial.label;
  std::string message = fmt::format("conjecture{} is false, as in this state:\n{}", label, trial.counterexample);
  if (message.ends_with('\n')) message.pop_back();
  return message;
}

/// The end of what stands at a byte: of a word, or of one character.
std::size_t end_of_word(const std::string& text, std::size_t from) {
  const auto goes_on = [&](std::size_t at) {
    const char c = at < text.size() ? text[at] : ' ';
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '\'' ||
           c == '?' || c == '!';
  };
  std::size_t end = from;
  if (end < text.size() && text[end] == '\\') ++end;
  while (goes_on(end) || (end + 1 < text.size() && text[end] == '\\' && text[end + 1] == '_' && end > from)) ++end;
  if (end == from && end < text.size() && text[end] != '\n') ++end;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
  return end;
}

}  // namespace

void TextAnswers::diagnostic(const EditedText& text, zed::Place place, std::int64_t severity,
                             const std::string& message, JsonWriter& to) const {
  const std::size_t from = text.byte_of(place);
  to.StartObject();
  to.Key("range");
  range(text, from, end_of_word(text.text(), from), to);
  put(to, "severity", severity);
  put(to, "source", "durero");
  put(to, "message", message);
  to.EndObject();
}

void TextAnswers::diagnostics(const std::string& path, JsonWriter& to) {
  const OpenFile& file = *workspace_.find(path);
  GroupAnalysis& analysis = workspace_.analysis(path);
  to.StartObject();
  put(to, "uri", file.uri);
  put(to, "version", file.version);
  to.Key("diagnostics");
  to.StartArray();
  for (const zed::Defect& defect : analysis.defects())
    if (defect.file == path) diagnostic(file.text, defect.place, severity_of(defect), message_of(defect), to);
  for (const zed::Trial& trial : analysis.refuted())
    if (trial.file == path) diagnostic(file.text, trial.place, error_severity, message_of(trial), to);
  to.EndArray();
  to.EndObject();
}

}  // namespace durero::lsp
