#pragma once
/// The typed commands of durero spec run are taken apart here.

#include <string>

#include "durero/spec/animation.hpp"

namespace durero::cli {

/// The error of a command that cannot be done; the place is a column of the line.
struct Refused {
  std::string wrong, expected;
  std::size_t column = 1;
};

/// The text without the blanks around it.
std::string trimmed(const std::string& text);

/// The inputs of `x? = VALUE; y? = VALUE`. Throws Refused where one is no input of the operation, or has no value.
zed::Valuation typed_inputs(const spec::Machine& machine, const spec::MachineOperation& operation,
                            const std::string& typed);

/// Adds the members of `NAME=3` or `NAME=ann,bob`, as --given has them. Throws io::InputError where there are none.
void add_typed_members(const std::string& typed, spec::Setup& setup);

}  // namespace durero::cli
