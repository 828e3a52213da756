#pragma once
/// A language server for Z: the Language Server Protocol 3.17 without its transport, which is the caller's.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace durero::lsp {

/// A language server takes the messages of a client and gives those that answer them, JSON each. It never throws for
/// what a client sends: a bad message has an error as its answer.
class LanguageServer {
 public:
  /// Serves the texts that the client opens. `version` is told to the client; `read_folder` gives the Z texts that lie
  /// beside a path, by their paths, or without it those on the disk.
  explicit LanguageServer(std::string version,
                          std::function<std::map<std::string, std::string>(const std::string& path)> read_folder = {});
  ~LanguageServer();
  LanguageServer(const LanguageServer&) = delete;
  LanguageServer& operator=(const LanguageServer&) = delete;

  /// Takes a message in. A cancellation takes effect at once, on requests that wait; others wait for step().
  void take(std::string_view message);
  /// Says whether a message waits, or defects that are not told yet.
  bool has_work() const;
  /// Answers the message that waits longest; where none does, tells the defects of the texts as they are now.
  void step();
  /// Returns what is to be sent, in order, and forgets it.
  std::vector<std::string> sent();

  /// Says whether the client has ended the session.
  bool is_over() const;
  /// The exit status that the protocol asks for: 0 where the client asked to shut down before it ended, else 1.
  int status() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace durero::lsp
