#pragma once
/// A store over HTTP: its edits, its scene, its rays and its history as JSON, and each edit told to whoever watches.

#include <memory>
#include <string>

namespace durero::serve {

/// Where a server listens, and to whom.
struct ServerOptions {
  std::string host = "127.0.0.1";  ///< the address that it listens at
  int port = 0;                    ///< 0: one that is free
  std::string token{};             ///< whoever asks must know it; empty: whoever reaches the address may ask
  std::string origin{};            ///< of the pages that may ask from a browser; empty: none may
  std::string author{};            ///< of edits that name none
  bool read_only = false;          ///< whether edits are refused: others write the store, and this follows
};

/// Whether the address is of this machine alone. At another one a server needs a token.
bool is_loopback(const std::string& host);

/// A server of one store. It is the one that writes to it as long as it runs, unless it only reads; others may read.
class Server {
 public:
  /// Opens the store and listens. Throws io::FileError where the store cannot be used, std::invalid_argument where the
  /// address is not of this machine alone and there is no token, and std::runtime_error where it cannot listen.
  Server(const std::string& store, ServerOptions options);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Where it listens.
  int port() const noexcept;
  /// Answers until stop() is called. Edits that were taken are answered before it returns.
  void run();
  /// Ends run(). By any thread.
  void stop() noexcept;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace durero::serve
