#pragma once
/// The machine that a call asks about, and the way that it has gone.

#include <fmt/format.h>

#include <memory>
#include <string>

#include "asked.hpp"
#include "durero/spec/animation.hpp"

namespace durero::web {

/// A machine, and how many ways to go on are listed.
struct AskedMachine {
  std::shared_ptr<const spec::Machine> machine;
  std::size_t choices;
};

/// The machine of a call, by its keys `text`, `name` and `setup`. It is made anew for each call, as what it answers may
/// depend on what it was asked before. Throws io::InputError.
AskedMachine machine_of(const AskedCall& asked);

/// Goes the way of a call, its key `way`, where it is there. Throws io::InputError.
void go_way(const AskedCall& asked, spec::Animation& way);

/// Throws the error of a question about a machine that has no answer.
[[noreturn]] void refuse_question(const std::string& wrong, const std::string& expected);

/// Asks a machine. Throws io::InputError where it does not come to an end.
template <class Ask>
auto asking(Ask&& ask) {
  try {
    return ask();
  } catch (const zed::StepsSpent&) {
    refuse_question("steps did not do", "expected a smaller question, or a greater steps in setup");
  } catch (const zed::Undetermined& error) {
    refuse_question(std::string("this is not decided: ") + error.what(),
                    fmt::format("expected one among constants, {}=VALUE", error.constant()));
  } catch (const zed::EvaluationError& error) {
    refuse_question(std::string("this is not decided: ") + error.what(),
                    "expected inputs, or equations for what is left");
  }
}

}  // namespace durero::web
