#pragma once
/// Where the tests find the tree that they were built from. Only tree.cpp knows, so that no other object depends on it.

#include <string>

namespace durero::test {

/// The root of the sources, without a slash at its end.
std::string source_dir();
/// The root of the build.
std::string binary_dir();

}  // namespace durero::test
