// durero serve STORE [--host H] [--port N] [--token FILE] [--origin O] [--author A] [--read-only]: a store over HTTP.
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

#include "commands.hpp"
#include "description.hpp"
#include "durero/io/source.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/serve/server.hpp"
#include "durero/store/provenance.hpp"
#include "interrupted.hpp"
#include "numbers.hpp"

namespace durero::cli {
namespace {

struct ServeOptions {
  std::string store, token_file;
  serve::ServerOptions server{.port = 8017};
};

/// The first line of a file, without which a token would be shown to whoever lists the programs that run.
std::string token_in(const std::string& file) {
  const io::Source source = io::read_source(file);
  const std::string_view text = source.text();
  std::string token(text.substr(0, text.find_first_of("\r\n")));
  if (token.empty()) source.fail(0, "there is no token", "expected one on the first line");
  return token;
}

int serve_store(ServeOptions options) {
  if (!options.token_file.empty()) options.server.token = token_in(options.token_file);
  if (options.server.author.empty()) options.server.author = store::author_of_environment();
  const std::atomic<bool>& is_interrupted = interrupted();
  serve::Server server(options.store, options.server);
  io::print(fmt::format("http://{}:{}\n", options.server.host, server.port()));
  std::atomic<bool> is_over = false;
  std::thread watch([&] {
    while (!is_interrupted && !is_over) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    server.stop();
  });
  server.run();
  is_over = true;
  watch.join();
  return 0;
}

}  // namespace

void add_serve(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("serve", "Edits, rays and history of a store over HTTP");
  const auto options = std::make_shared<ServeOptions>();
  command
      ->add_option("STORE", options->store, "Store, as durero store init makes one, or the URI of a PostgreSQL server")
      ->required();
  command
      ->add_option("--host", options->server.host,
                   "Address that it listens at; other than of this machine with --token")
      ->capture_default_str();
  command->add_option("--port", options->server.port, "Port; 0 is one that is free")
      ->check(whole_number(0, 65535))
      ->capture_default_str();
  command->add_option("--token", options->token_file, "File whose first line whoever asks must know");
  command->add_option("--origin", options->server.origin, "Origin of the pages that may ask from a browser");
  command->add_option("--author", options->server.author,
                      "Who edits, where an edit names nobody; without it as of durero store edit");
  command->add_flag("--read-only", options->server.read_only,
                    "Refuse edits, and follow those that others make, also through a replica of the store's server");
  command->footer(
      "It prints its address, and answers until it is interrupted. docs/serve.md lists what it answers. Edits that "
      "come\n"
      "at a time are made durable together. An edit whose If-Match names another scene than the last changes "
      "nothing.\n\n" +
      exit_status("it was interrupted", "", "the call or the store is bad, or the address is taken") +
      examples({"serve room.store", "serve room.store --host 0.0.0.0 --token token.txt",
                "serve postgresql://replica/scenes --read-only"}));
  command->callback([options, &status] { status = serve_store(*options); });
}

}  // namespace durero::cli
