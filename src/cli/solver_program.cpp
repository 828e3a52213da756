#include "solver_program.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "durero/conform/ask/program_reply.hpp"
#include "durero/io/source.hpp"
#include "numbers.hpp"
#include "spec.hpp"

namespace durero::cli {
namespace {

constexpr std::uint64_t bytes_of_mib = std::uint64_t{1} << 20U;
constexpr std::array interrupts = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> ask_is_interrupted = false;

/// An interrupt ends the solver first, which has a process group of its own, and then this program as without it.
class InterruptedAsk {
 public:
  InterruptedAsk() {
    ask_is_interrupted = false;
    struct sigaction mark {};
    mark.sa_handler = [](int) { ask_is_interrupted = true; };
    for (std::size_t i = 0; i < interrupts.size(); ++i) {
      ::sigaction(interrupts[i], nullptr, &before_[i]);
      if (before_[i].sa_handler != SIG_IGN) ::sigaction(interrupts[i], &mark, nullptr);
    }
  }
  ~InterruptedAsk() {
    for (std::size_t i = 0; i < interrupts.size(); ++i) ::sigaction(interrupts[i], &before_[i], nullptr);
    if (ask_is_interrupted) std::raise(SIGINT);
  }
  InterruptedAsk(const InterruptedAsk&) = delete;
  InterruptedAsk& operator=(const InterruptedAsk&) = delete;

 private:
  std::array<struct sigaction, interrupts.size()> before_{};
};

std::vector<std::string> words_of(const std::string& typed) {
  std::vector<std::string> words;
  std::istringstream in(typed);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

conform::Command command_of(std::vector<std::string> words, const std::string& name) {
  if (words.size() > 1) return words;
  if (name == "z3") words.insert(words.end(), {"-smt2", "-in"});
  if (name == "cvc5") words.insert(words.end(), {"--lang", "smt2"});
  return words;
}

}  // namespace

void add_solver(CLI::App& command, SolverOptions& to) {
  command
      .add_option("--solver", to.program,
                  "Ask this program, such as z3 or cvc5, where the text does not decide; what it finds is evaluated")
      ->check([](const std::string& typed) {
        return words_of(typed).empty() ? std::string("it names no program") : std::string();
      });
  command.add_option("--solver-time", to.seconds, "How many seconds the solver has for each question")
      ->check(whole_number(1, 86'400))
      ->capture_default_str();
}

zed::SmtProgram solver_program(const SolverOptions& options) {
  const std::vector<std::string> words = words_of(options.program);
  const std::string name = std::filesystem::path(words.front()).filename().string();
  const conform::Command command = command_of(words, name);
  const conform::ReplyLimits limits{.time = std::chrono::seconds(options.seconds),
                                    .memory = default_memory() * bytes_of_mib};
  return {name, [command, limits](const std::string& script) -> zed::SmtReply {
            const InterruptedAsk guard;
            try {
              conform::ProgramReply reply = conform::reply_of(command, script, limits, ask_is_interrupted);
              return {std::move(reply.output), std::move(reply.failure)};
            } catch (const std::runtime_error& error) {
              const std::string what = error.what();
              const std::size_t expected = what.rfind("; ");
              throw io::InputError("--solver", {1, 1}, what.substr(0, expected), what.substr(expected + 2));
            }
          }};
}

}  // namespace durero::cli
