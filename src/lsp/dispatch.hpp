#pragma once
/// A session with one client: its messages go to what answers them.

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lsp/answers.hpp"

namespace durero::lsp {

/// A message of a client, read and looked at: a request has an id, a notification has none.
class ClientMessage {
 public:
  /// Throws RpcError at what is no message of JSON-RPC.
  explicit ClientMessage(std::string_view text);

  /// Returns the method; empty for an answer of the client.
  std::string_view method() const { return method_; }
  bool is_request() const { return !method_.empty() && id() && !id()->IsNull(); }
  const JsonValue* id() const { return find_member(json_, "id"); }
  const JsonValue& params() const;

 private:
  rapidjson::Document json_;
  std::string method_;
};

/// Carries messages out, and collects what is to be sent.
class ServerSession {
 public:
  ServerSession(std::string version, FolderReader read)
      : version_(std::move(version)), workspace_(std::move(read)), answers_(workspace_, options_) {}

  /// Answers a request, or takes note of a notification. Whatever it throws becomes an error that is sent.
  void handle(const ClientMessage& message);
  /// Sends an error as the answer to a request; without an id, as that to a message of which none is known.
  void refuse(const JsonValue* id, const RpcError& error);
  /// Says whether the defects of some text are to be told, or its conjectures to be tried.
  bool has_untold() const { return !untold_.empty() || !untried_.empty(); }
  /// Tells all defects; or, where these are told, tries one conjecture of a text that was opened or saved.
  void tell();
  std::vector<std::string> take_sent() { return std::exchange(sent_, {}); }
  bool is_over() const { return over_; }
  bool was_shut_down() const { return shut_down_; }

 private:
  void request(const ClientMessage& message);
  void notification(const ClientMessage& message);
  void answer(std::string_view method, const JsonValue& params, JsonWriter& to);
  void initialize(const JsonValue& params, JsonWriter& to);
  void capabilities(JsonWriter& to) const;
  void did_open(const JsonValue& params);
  void did_change(const JsonValue& params);
  void did_close(const JsonValue& params);
  void files_changed();
  void tell_defects();
  void try_conjecture();
  void log(const std::string& message);

  std::string version_;
  ProtocolOptions options_;
  Workspace workspace_;
  TextAnswers answers_;
  std::vector<std::string> sent_;
  std::set<std::string> untold_;             // the paths of open files of which newer defects are to be told
  std::set<std::string> untried_;            // and those of which a conjecture may be untried
  std::map<std::string, std::string> told_;  // what was told last, by path
  bool initialized_ = false, shut_down_ = false, over_ = false;
};

}  // namespace durero::lsp
