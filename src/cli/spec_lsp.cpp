// durero spec lsp: a language server for Z over the standard input and output.
#include "spec_lsp.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "description.hpp"
#include "durero/io/source.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/lsp/language_server.hpp"
#include "durero/number/memory.hpp"
#include "message_framing.hpp"

namespace durero::cli {
namespace {

/// The memory that a number of an explained value may take.
constexpr std::size_t most_number = std::size_t{16} << 20U;

/// Says whether bytes of the client wait.
bool has_input() {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, 0) == 1;
}

/// Reads what waits, or waits for it. False where the client has closed its end.
bool read_input(MessageFraming& into) {
  std::array<char, 1U << 16U> bytes{};
  for (;;) {
    const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    into.add({bytes.data(), static_cast<std::size_t>(count)});
    return true;
  }
}

void send(lsp::LanguageServer& server) {
  for (const std::string& message : server.sent()) io::print(framed(message));
}

/// Takes all messages that were read whole, so that a cancellation finds its request before that is answered.
void take_messages(MessageFraming& framing, lsp::LanguageServer& server) {
  try {
    while (const auto message = framing.next()) server.take(*message);
  } catch (const io::InputError&) {
    send(server);
    server.take("");  // the client is told, as far as it listens
    send(server);
    throw;
  }
}

int serve_editor() {
  number::throw_when_numbers_outgrow_memory(most_number);
  lsp::LanguageServer server(DURERO_VERSION);
  MessageFraming framing;
  bool is_open = true;
  while (!server.is_over()) {
    if (is_open && (!server.has_work() || has_input())) {
      is_open = read_input(framing);
      take_messages(framing, server);
    } else if (server.has_work()) {
      server.step();
    } else {
      break;
    }
    send(server);
  }
  return server.status();
}

}  // namespace

void add_spec_lsp(CLI::App& spec, int& status) {
  auto* command = spec.add_subcommand("lsp", "A language server for Z, which an editor starts");
  command->footer(
      "It speaks the Language Server Protocol 3.17 over the standard input and output: defects as spec check gives "
      "them,\n"
      "types and values, definitions, references, completion, renaming, layout and outline. docs/editors.md says how\n"
      "editors start it.\n\n" +
      exit_status("the editor asked to shut down, and ended it", "the editor ended without that",
                  "what came was no message") +
      examples({"spec lsp"}));
  command->callback([&status] { status = serve_editor(); });
}

}  // namespace durero::cli
