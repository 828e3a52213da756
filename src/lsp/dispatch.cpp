#include "lsp/dispatch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <new>

#include "durero/zed/syntax/defect.hpp"
#include "lsp/file_uri.hpp"

namespace durero::lsp {
namespace {

/// A request about a text, by its method.
struct TextRequest {
  std::string_view method;
  void (TextAnswers::*answer)(const JsonValue& params, JsonWriter& to);
};

constexpr std::array text_requests = {
    TextRequest{"textDocument/hover", &TextAnswers::hover},
    TextRequest{"textDocument/definition", &TextAnswers::definition},
    TextRequest{"textDocument/references", &TextAnswers::references},
    TextRequest{"textDocument/documentHighlight", &TextAnswers::document_highlight},
    TextRequest{"textDocument/completion", &TextAnswers::completion},
    TextRequest{"textDocument/prepareRename", &TextAnswers::prepare_rename},
    TextRequest{"textDocument/rename", &TextAnswers::rename},
    TextRequest{"textDocument/formatting", &TextAnswers::formatting},
    TextRequest{"textDocument/documentSymbol", &TextAnswers::document_symbol},
};

/// One message in JSON, written by a function.
template <class Write>
std::string message_of(Write&& write) {
  rapidjson::StringBuffer buffer;
  JsonWriter writer(buffer);
  writer.StartObject();
  put(writer, "jsonrpc", "2.0");
  write(writer);
  writer.EndObject();
  return {buffer.GetString(), buffer.GetSize()};
}

void put_id(JsonWriter& to, const JsonValue* id) {
  to.Key("id");
  if (id) {
    id->Accept(to);
  } else {
    to.Null();
  }
}

}  // namespace

ClientMessage::ClientMessage(std::string_view text) {
  json_.Parse<rapidjson::kParseIterativeFlag | rapidjson::kParseValidateEncodingFlag>(text.data(), text.size());
  if (json_.HasParseError())
    throw RpcError(ErrorCode::parse_error,
                   fmt::format("this is no JSON at byte {}; expected a message of JSON-RPC", json_.GetErrorOffset()));
  const auto require = [](bool holds, const char* message) {
    if (!holds) throw RpcError(ErrorCode::invalid_request, message);
  };
  const JsonValue* version = find_member(json_, "jsonrpc");
  require(version && version->IsString() && std::string_view(version->GetString()) == "2.0",
          "this is no message; expected an object with \"jsonrpc\":\"2.0\"");
  const bool has_id = !id() || id()->IsString() || id()->IsInt64() || id()->IsUint64() || id()->IsNull();
  require(has_id, "id is wrong; expected a string or a whole number");
  const JsonValue* method = find_member(json_, "method");
  require(!method || (method->IsString() && method->GetStringLength() > 0), "method is wrong; expected a string");
  require(method || find_member(json_, "result") || find_member(json_, "error"), "there is no method; expected one");
  if (method) method_.assign(method->GetString(), method->GetStringLength());
}

const JsonValue& ClientMessage::params() const {
  static const JsonValue none(rapidjson::kObjectType);
  const JsonValue* found = find_member(json_, "params");
  return found ? *found : none;
}

void ServerSession::refuse(const JsonValue* id, const RpcError& error) {
  sent_.push_back(message_of([&](JsonWriter& to) {
    put_id(to, id);
    to.Key("error");
    to.StartObject();
    put(to, "code", static_cast<std::int64_t>(error.code));
    put(to, "message", error.what());
    to.EndObject();
  }));
}

void ServerSession::log(const std::string& message) {
  constexpr std::int64_t error = 1;
  sent_.push_back(message_of([&](JsonWriter& to) {
    put(to, "method", "window/logMessage");
    to.Key("params");
    to.StartObject();
    put(to, "type", error);
    put(to, "message", message);
    to.EndObject();
  }));
}

void ServerSession::handle(const ClientMessage& message) {
  if (message.method().empty()) return;  // an answer, and nothing was asked
  if (message.is_request()) return request(message);
  try {
    notification(message);
  } catch (const RpcError& error) {
    log(fmt::format("{}: {}", message.method(), error.what()));
  }
}

void ServerSession::request(const ClientMessage& message) {
  try {
    std::string sent = message_of([&](JsonWriter& to) {
      put_id(to, message.id());
      to.Key("result");
      answer(message.method(), message.params(), to);
    });
    sent_.push_back(std::move(sent));
  } catch (const RpcError& error) {
    refuse(message.id(), error);
  } catch (const zed::ZError& error) {
    refuse(message.id(), RpcError(ErrorCode::request_failed, error.what()));
  } catch (const std::bad_alloc&) {
    refuse(message.id(), RpcError(ErrorCode::internal_error, "the memory does not do"));
  }
}

void ServerSession::answer(std::string_view method, const JsonValue& params, JsonWriter& to) {
  if (shut_down_) throw RpcError(ErrorCode::invalid_request, "the server was shut down; expected exit");
  if (method == "initialize") return initialize(params, to);
  if (!initialized_) throw RpcError(ErrorCode::server_not_initialized, "expected initialize first");
  if (method == "shutdown") {
    shut_down_ = true;
    to.Null();
    return;
  }
  const auto known = std::ranges::find(text_requests, method, &TextRequest::method);
  if (known == text_requests.end())
    throw RpcError(ErrorCode::method_not_found, fmt::format("{} is no method of this server", method));
  (answers_.*known->answer)(params, to);
}

void ServerSession::notification(const ClientMessage& message) {
  const std::string_view method = message.method();
  if (method == "exit") {
    over_ = true;
  } else if (!initialized_ || shut_down_ || method == "initialized" || method.starts_with("$/")) {
    // the protocol drops what comes too early or too late, and lets these be passed over
  } else if (method == "textDocument/didOpen") {
    did_open(message.params());
  } else if (method == "textDocument/didChange") {
    did_change(message.params());
  } else if (method == "textDocument/didClose") {
    did_close(message.params());
  } else if (method == "textDocument/didSave" || method == "workspace/didChangeWatchedFiles") {
    files_changed();
  }
}

void ServerSession::initialize(const JsonValue& params, JsonWriter& to) {
  if (initialized_) throw RpcError(ErrorCode::invalid_request, "the server is initialized already");
  const auto offers = [](const JsonValue* among, std::string_view wanted) {
    if (!among || !among->IsArray()) return false;
    return std::ranges::any_of(among->GetArray(), [&](const JsonValue& each) {
      return each.IsString() && wanted == std::string_view(each.GetString(), each.GetStringLength());
    });
  };
  const JsonValue* units = find_member(params, "capabilities", "general", "positionEncodings");
  if (offers(units, "utf-8")) {
    options_.unit = PositionUnit::utf8;
  } else if (offers(units, "utf-32") && !offers(units, "utf-16")) {
    options_.unit = PositionUnit::utf32;
  }
  options_.markdown = offers(find_member(params, "capabilities", "textDocument", "hover", "contentFormat"), "markdown");
  const JsonValue* nested =
      find_member(params, "capabilities", "textDocument", "documentSymbol", "hierarchicalDocumentSymbolSupport");
  options_.nested_symbols = nested && nested->IsTrue();
  initialized_ = true;
  to.StartObject();
  to.Key("capabilities");
  capabilities(to);
  to.Key("serverInfo");
  to.StartObject();
  put(to, "name", "durero spec lsp");
  put(to, "version", version_);
  to.EndObject();
  to.EndObject();
}

void ServerSession::capabilities(JsonWriter& to) const {
  constexpr std::int64_t incremental = 2;
  static constexpr std::string_view units[] = {"utf-8", "utf-16", "utf-32"};
  const auto yes = [&](const char* key) {
    to.Key(key);
    to.Bool(true);
  };
  to.StartObject();
  put(to, "positionEncoding", units[static_cast<std::size_t>(options_.unit)]);
  to.Key("textDocumentSync");
  to.StartObject();
  yes("openClose");
  put(to, "change", incremental);
  yes("save");
  to.EndObject();
  for (const char* provider : {"hoverProvider", "definitionProvider", "referencesProvider", "documentHighlightProvider",
                               "documentFormattingProvider", "documentSymbolProvider"})
    yes(provider);
  to.Key("completionProvider");
  to.StartObject();
  to.Key("triggerCharacters");
  to.StartArray();
  put(to, "\\");
  put(to, ".");
  to.EndArray();
  to.EndObject();
  to.Key("renameProvider");
  to.StartObject();
  yes("prepareProvider");
  to.EndObject();
  to.EndObject();
}

void ServerSession::did_open(const JsonValue& params) {
  const JsonValue& document = member(params, "textDocument");
  const std::string uri = text_member(document, "uri");
  const JsonValue* version = find_member(document, "version");
  const std::string path = path_of_uri(uri);
  workspace_.open(path, {uri, version && version->IsInt64() ? version->GetInt64() : 0,
                         EditedText(text_member(document, "text"), options_.unit)});
  files_changed();
}

void ServerSession::did_change(const JsonValue& params) {
  const JsonValue& document = member(params, "textDocument");
  const std::string path = path_of_uri(text_member(document, "uri"));
  OpenFile* file = workspace_.find(path);
  if (!file) throw RpcError(ErrorCode::invalid_params, path + " is not open; expected an open text");
  EditedText text = file->text;  // a notification is carried out whole, or not at all
  for (const JsonValue& change : array_member(params, "contentChanges").GetArray()) {
    const std::string now = text_member(change, "text");
    if (!find_member(change, "range")) {
      text = EditedText(now, options_.unit);
      continue;
    }
    const EditorPosition from = position_in(member(member(change, "range"), "start"));
    const EditorPosition to = position_in(member(member(change, "range"), "end"));
    if (to < from) throw RpcError(ErrorCode::invalid_params, "a range ends before its start; expected start, then end");
    text.edit(from, to, now);
  }
  file->text = std::move(text);
  if (const JsonValue* version = find_member(document, "version"); version && version->IsInt64())
    file->version = version->GetInt64();
  workspace_.edited();
  untried_.clear();  // what was found was of another text
  for (const auto& [open, each] : workspace_.files()) untold_.insert(open);
  told_.erase(path);  // the client waits for the defects of this version, be they the same
}

void ServerSession::did_close(const JsonValue& params) {
  const std::string uri = text_member(member(params, "textDocument"), "uri");
  const std::string path = path_of_uri(uri);
  workspace_.close(path);
  told_.erase(path);
  untold_.erase(path);
  untried_.erase(path);
  sent_.push_back(message_of([&](JsonWriter& to) {
    put(to, "method", "textDocument/publishDiagnostics");
    to.Key("params");
    to.StartObject();
    put(to, "uri", uri);
    to.Key("diagnostics");
    to.StartArray();
    to.EndArray();
    to.EndObject();
  }));
  files_changed();
}

/// Texts beside the open ones may be others now.
void ServerSession::files_changed() {
  workspace_.reread();
  for (const auto& [path, file] : workspace_.files()) {
    untold_.insert(path);
    untried_.insert(path);
  }
}

void ServerSession::tell() {
  if (untold_.empty()) {
    try_conjecture();
  } else {
    tell_defects();
  }
}

void ServerSession::try_conjecture() {
  const std::string path = *untried_.begin();
  GroupAnalysis& analysis = workspace_.analysis(path);
  const std::size_t before = analysis.refuted().size();
  bool more = false;
  try {
    more = analysis.try_next(path);
  } catch (const std::bad_alloc&) {  // it is not tried, and the next is
    more = true;
  }
  if (!more) untried_.erase(path);
  if (analysis.refuted().size() > before) untold_.insert(path);
}

void ServerSession::tell_defects() {
  for (const std::string& path : std::exchange(untold_, {})) {
    if (!workspace_.find(path)) continue;
    std::string message = message_of([&](JsonWriter& to) {
      put(to, "method", "textDocument/publishDiagnostics");
      to.Key("params");
      answers_.diagnostics(path, to);
    });
    std::string& before = told_[path];
    if (before == message) continue;
    before = message;
    sent_.push_back(std::move(message));
  }
}

}  // namespace durero::lsp
