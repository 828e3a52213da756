#pragma once
/// The machine that the options of `durero spec` ask for.

#include <memory>

#include "durero/spec/animation.hpp"

namespace durero::cli {

/// Throws what is said, `what is wrong; expected …`, as an error of the file or the option.
[[noreturn]] void refuse_as_said(const std::string& where, const std::string& said);

/// The machine of these files, or of the program's own text where there are none, with members of given sets as
/// --given has them. Throws io::InputError where the text, or an option, is wrong.
std::unique_ptr<spec::Machine> machine_of(const std::vector<std::string>& files, const std::vector<std::string>& given,
                                          spec::Setup setup);

}  // namespace durero::cli
