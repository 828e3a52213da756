#include "durero/lsp/language_server.hpp"

#include <deque>
#include <exception>
#include <new>
#include <utility>

#include "lsp/dispatch.hpp"

namespace durero::lsp {

struct LanguageServer::State {
  ServerSession session;
  std::deque<ClientMessage> waiting{};

  State(std::string version, FolderReader read) : session(std::move(version), std::move(read)) {}

  /// Answers a request that waits as cancelled, if there is one of this id.
  void cancel(const JsonValue& params) {
    const JsonValue* id = find_member(params, "id");
    for (auto at = waiting.begin(); id && at != waiting.end(); ++at) {
      if (!at->is_request() || *at->id() != *id) continue;
      session.refuse(at->id(), RpcError(ErrorCode::request_cancelled, "the client cancelled this"));
      waiting.erase(at);
      return;
    }
  }
};

LanguageServer::LanguageServer(std::string version, FolderReader read_folder)
    : state_(std::make_unique<State>(std::move(version),
                                     read_folder ? std::move(read_folder) : FolderReader(folder_on_disk))) {}
LanguageServer::~LanguageServer() = default;

void LanguageServer::take(std::string_view message) {
  try {
    ClientMessage read(message);
    if (read.method() == "$/cancelRequest") return state_->cancel(read.params());
    state_->waiting.push_back(std::move(read));
  } catch (const RpcError& error) {
    state_->session.refuse(nullptr, error);
  }
}

bool LanguageServer::has_work() const { return !state_->waiting.empty() || state_->session.has_untold(); }

void LanguageServer::step() {
  if (state_->waiting.empty()) return state_->session.tell();
  const ClientMessage message = std::move(state_->waiting.front());
  state_->waiting.pop_front();
  state_->session.handle(message);
}

std::vector<std::string> LanguageServer::sent() { return state_->session.take_sent(); }

bool LanguageServer::is_over() const { return state_->session.is_over(); }

int LanguageServer::status() const { return state_->session.was_shut_down() ? 0 : 1; }

}  // namespace durero::lsp
