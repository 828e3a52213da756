#pragma once
/// Answers to the requests about texts: each writes its result.

#include <string>

#include "durero/zed/names/outline.hpp"
#include "lsp/rpc.hpp"
#include "lsp/workspace.hpp"

namespace durero::lsp {

/// The terms that a client and this server agreed on when they met.
struct ProtocolOptions {
  PositionUnit unit = PositionUnit::utf16;
  bool markdown = false;        ///< hovers may be Markdown
  bool nested_symbols = false;  ///< an outline may have parts
};

/// Answers from the texts of a workspace.
class TextAnswers {
 public:
  TextAnswers(Workspace& workspace, const ProtocolOptions& options) : workspace_(workspace), options_(options) {}

  /// @{ Write the result of a request with these parameters. Throw RpcError, and zed::ZError where a text refuses.
  void hover(const JsonValue& params, JsonWriter& to);
  void definition(const JsonValue& params, JsonWriter& to);
  void references(const JsonValue& params, JsonWriter& to);
  void document_highlight(const JsonValue& params, JsonWriter& to);
  void completion(const JsonValue& params, JsonWriter& to);
  void prepare_rename(const JsonValue& params, JsonWriter& to);
  void rename(const JsonValue& params, JsonWriter& to);
  void formatting(const JsonValue& params, JsonWriter& to);
  void document_symbol(const JsonValue& params, JsonWriter& to);
  /// @}
  /// Writes the parameters of the notification that tells the defects of an open file, and its conjectures that were
  /// found false.
  void diagnostics(const std::string& path, JsonWriter& to);

 private:
  /// A place that a request names: an open file, its analysis, and a byte.
  struct RequestedPlace {
    std::string path;
    OpenFile* file;
    GroupAnalysis* analysis;
    std::size_t byte = 0;
  };
  RequestedPlace file_of(const JsonValue& params);
  RequestedPlace place_of(const JsonValue& params);
  const zed::Occurrence* occurrence_at(const RequestedPlace& asked);
  void range(const EditedText& text, std::size_t from, std::size_t to, JsonWriter& writer) const;
  void diagnostic(const EditedText& text, zed::Place place, std::int64_t severity, const std::string& message,
                  JsonWriter& to) const;
  void symbols(const RequestedPlace& asked, const std::vector<zed::OutlineEntry>& entries, const std::string& within,
               JsonWriter& to);
  void location(const GroupAnalysis& in, const std::string& path, const zed::Occurrence& of, JsonWriter& to);
  void locations(const RequestedPlace& asked, bool declarations, bool uses, JsonWriter& to);

  Workspace& workspace_;
  const ProtocolOptions& options_;
};

/// The position that a JSON object of the protocol says.
EditorPosition position_in(const JsonValue& params);

}  // namespace durero::lsp
