// durero spec run [FILES]: an animator. A command a line, from the terminal or from a pipe.
#include "spec_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <new>
#include <optional>

#include "durero/io/output_file.hpp"
#include "durero/io/source.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/spec/animation_text.hpp"
#include "durero/text/nearest.hpp"
#include "spec.hpp"
#include "spec_machine.hpp"
#include "spec_run_typed.hpp"

namespace durero::cli {

using spec::Animation;
using spec::ConjectureResult;
using spec::Machine;
using spec::MachineOperation;
using spec::ReachedTransitions;
using spec::Transition;
using zed::Truth;

namespace {

/// A note on further ways that may exist, and on the reason why they were not found.
std::string left_open(const ReachedTransitions& ways) {
  if (!ways.undecided) return {};
  if (ways.tried.empty()) return "  there may be other ways: equations do not give them\n";
  return fmt::format("  there may be other ways: some values of {} were tried, as --numbers bounds them\n",
                     spec::name_list(ways.tried));
}

std::string how_far(const ReachedTransitions& ways) {
  if (!ways.undecided) return {};
  if (ways.tried.empty()) return ", as far as equations give it";
  return fmt::format(", as far as some values of {} were tried: --numbers", spec::name_list(ways.tried));
}

constexpr const char* help_text =
    "  OPERATION [x? = VALUE; y? = VALUE]   goes on; inputs that are not given are looked for\n"
    "  N            goes on by number N of the ways that were listed last\n"
    "  ops          which operations there are, and one way to go on by each\n"
    "  why OPERATION [x? = VALUE]   each of its predicates here, with its truth; (after): of what comes after\n"
    "  show         the state, beside the one before\n"
    "  back         takes the last step back\n"
    "  trace        the way so far\n"
    "  save FILE    writes it;  replay FILE reads one, and checks each step\n"
    "  try          the conjectures of the text, here\n"
    "  explore [N]  goes all ways from here, to N states, and tries the conjectures in each\n"
    "  restart      begins anew\n"
    "  quit\n";

class Runner {
 public:
  Runner(const Machine& machine, const RunCall& call) : machine_(machine), call_(call), way_(machine) {}

  /// Runs the commands of the standard input. Returns the exit status.
  int run() {
    terminal_ = isatty(STDIN_FILENO) != 0;
    attempt([this] { greet(); });
    for (std::string typed; prompt(), std::getline(std::cin, typed);) {
      ++line_;
      const std::string command = trimmed(typed);
      if (command == "quit") break;
      if (command.empty() || command.front() == '#') continue;
      attempt([&] { obey(command); });
    }
    return refuted_ || refused_ ? 1 : 0;
  }

 private:
  template <class Work>
  void attempt(Work&& work) {
    try {
      work();
    } catch (const Refused& refused) {
      complain(refused);
    } catch (const zed::StepsSpent&) {
      complain({"--steps did not do", "expected a smaller question, or a greater --steps"});
    } catch (const std::bad_alloc&) {
      complain({"--memory did not do", "expected a smaller question, or a greater --memory"});
    } catch (const zed::Undetermined& error) {
      complain({std::string("this is not decided: ") + error.what(),
                fmt::format("expected one, or --let {}=VALUE", error.constant())});
    } catch (const zed::EvaluationError& error) {
      complain({std::string("this is not decided: ") + error.what(), "expected inputs, or equations for what is left"});
    }
  }

  void greet() {
    std::string said = fmt::format("state {}, initial schema {}, {} operations", machine_.state(),
                                   machine_.init().empty() ? "none" : machine_.init(), machine_.operations().size());
    for (const std::string& carrier : machine_.carriers()) said += "\n  " + carrier;
    for (const std::string& constant : machine_.taken()) said += "\n  " + constant;
    io::print(said + "\n");
    if (call_.replay.empty()) {
      begin();
    } else {
      replay(call_.replay);
    }
  }

  void prompt() const {
    if (terminal_) io::print("> ");
  }

  // Reports a refused command. A terminal goes on; a script ends here, as the commands that follow may mean something
  // else now.
  void complain(const Refused& refused) {
    refused_ = !terminal_;
    const io::InputError error("<stdin>", {std::max<std::size_t>(line_, 1), refused.column}, refused.wrong,
                               refused.expected);
    if (!terminal_) throw error;
    io::complain(std::string("durero: ") + error.what() + "\n");
  }

  void begin() {
    go_on(machine_.initial(call_.choices), "no initial state is found",
          "expected an initial schema whose equations give each component a value");
  }

  void obey(const std::string& command) {
    const std::size_t blank = command.find(' ');
    const std::string word = command.substr(0, blank),
                      rest = blank == command.npos ? "" : trimmed(command.substr(blank));
    if (word == "help") return io::print(help_text);
    if (word == "ops") return io::print(spec::operations_list(machine_, here()));
    if (word == "why") return why(rest);
    if (word == "show") return show();
    if (word == "back") return back();
    if (word == "trace") return io::print(spec::way_story(machine_, way_.way()));
    if (word == "save") return io::write_file(rest, way_.saved());
    if (word == "replay") return replay(rest);
    if (word == "try") return try_here();
    if (word == "explore") return explore_from_here(rest);
    if (word == "restart") return restart();
    if (word.find_first_not_of("0123456789") == word.npos) return choose(word);
    const MachineOperation& operation = found(word);
    go_on(machine_.steps(here(), operation, typed_inputs(machine_, operation, rest), call_.choices),
          word + " cannot go on here");
  }

  const zed::Valuation& here() const {
    if (!way_.now()) throw Refused{"there is no state yet", "expected the number of an initial state"};
    return *way_.now();
  }

  const MachineOperation& found(const std::string& word) const {
    if (const MachineOperation* operation = machine_.find(word)) return *operation;
    std::vector<std::string> names;
    for (const auto& each : machine_.operations()) names.push_back(each.name);
    throw Refused{"no operation or command " + word,
                  "expected " + text::nearest(word, names).value_or("an operation; help lists the commands")};
  }

  void go_on(ReachedTransitions ways, const std::string& none,
             const char* expected = "expected an operation that may; why OPERATION says its predicates") {
    const std::string left_out =
        ways.bounded.empty() ? "" : fmt::format("  more may be found with a greater {}\n", ways.bounded);
    const std::string open = left_open(ways);
    if (ways.transitions.empty())  // what is listed may still be chosen from
      throw Refused{none + how_far(ways) + (ways.bounded.empty() ? "" : ", as far as " + ways.bounded + " goes"),
                    expected};
    listed_ = std::move(ways.transitions);
    if (listed_.size() == 1) {
      take(listed_.front());
      return io::print(left_out + open);
    }
    std::string said = fmt::format("{} ways:\n", listed_.size());
    for (std::size_t i = 0; i < listed_.size(); ++i)
      said += fmt::format("{}. {}\n{}", i + 1, spec::step_line(machine_, listed_[i]),
                          spec::state_table(machine_, way_.now(), listed_[i].after));
    io::print(said + left_out + open);
  }

  void choose(const std::string& digits) {
    const std::size_t number = digits.size() > 6 ? 0 : std::stoul(digits);
    if (number == 0 || number > listed_.size())
      throw Refused{"no way " + digits + " is listed",
                    listed_.empty() ? "expected ops before, which lists ways"
                                    : fmt::format("expected a number from 1 to {}", listed_.size())};
    take(listed_[number - 1]);
  }

  void take(Transition step) {
    way_.take(std::move(step));
    listed_.clear();
    show();
  }

  void show() const {
    const auto& last = (here(), way_.way().back());
    io::print(fmt::format("{}. {}\n{}{}", way_.way().size() - 1, spec::step_line(machine_, last),
                          spec::state_table(machine_, way_.before(), last.after), spec::outlook(machine_, last.after)));
  }

  void back() {
    if (!way_.back()) throw Refused{"there is no step to take back", "expected one"};
    show();
  }

  void restart() {
    way_.restart();
    begin();
  }

  void why(const std::string& rest) const {
    const std::size_t blank = rest.find(' ');
    const MachineOperation& operation = found(rest.substr(0, blank));
    const auto given = typed_inputs(machine_, operation, blank == rest.npos ? "" : rest.substr(blank));
    io::print(spec::findings_list(machine_.preconditions(here(), operation, given)));
  }

  void replay(const std::string& path) {
    const io::Source source = io::read_source(path);
    try {
      way_.replay(std::string(source.text()));
    } catch (const zed::ZError& error) {
      throw io::InputError(source.name(), {error.place.line, error.place.column}, error.what_is_wrong, error.expected);
    }
    io::print(fmt::format("{} steps, each as the text says\n", way_.way().size()));
    show();
  }

  void try_here() {
    const zed::Valuation none;
    std::string said;
    here();
    for (const ConjectureResult& tried :
         machine_.conjectures(way_.before() ? *way_.before() : none, way_.way().back())) {
      refuted_ = refuted_ || tried.truth == Truth::no;
      said += spec::claim_line(tried);
    }
    io::print(said.empty() ? "the text has no conjecture of this state or step\n" : said);
  }

  void explore_from_here(const std::string& digits) {
    if (digits.find_first_not_of("0123456789") != digits.npos || digits.size() > 9)
      throw Refused{digits + " is no number", "expected how many states there may be"};
    const std::size_t most = digits.empty() ? call_.states : std::stoul(digits);
    const auto result = spec::explore(machine_, way_.way(), most);
    std::string said = fmt::format("{} states, {} transitions; conjectures: {} tried, {} not decided\n", result.states,
                                   result.transitions, result.claims, result.open);
    for (const std::string& bound : result.bounded) said += "  bounded: " + bound + "\n";
    if (result.refuted) {
      refuted_ = true;
      said += "false after this way:\n" + spec::claim_line(*result.refuted) + spec::way_story(machine_, result.way);
    }
    io::print(said);
  }

  const Machine& machine_;
  const RunCall& call_;
  Animation way_;
  std::vector<Transition> listed_;
  std::size_t line_ = 0;
  bool terminal_ = false, refuted_ = false, refused_ = false;
};

}  // namespace

int spec_run(RunCall call) {
  const auto machine = machine_of(call.files, call.given, call.setup);
  bound_memory(call.memory);
  return Runner(*machine, call).run();
}

}  // namespace durero::cli
