#pragma once
/// The data that the build put into the program.

#include <map>
#include <string>

namespace durero::embedded {

/// The index that cmake/label_index.sh made when the program was built: one table.
const std::map<std::string, std::string>& labels();

}  // namespace durero::embedded
