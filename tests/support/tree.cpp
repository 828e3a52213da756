#include "support/tree.hpp"

namespace durero::test {

std::string source_dir() { return DURERO_SOURCE_DIR; }
std::string binary_dir() { return DURERO_BINARY_DIR; }

}  // namespace durero::test
