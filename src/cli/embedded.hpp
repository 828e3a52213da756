#pragma once
/// What the build put into the program.

#include <map>
#include <string>

namespace durero::embedded {

/// What cmake/label_index.sh found when the program was built: one table.
const std::map<std::string, std::string>& labels();

}  // namespace durero::embedded
