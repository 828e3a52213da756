#pragma once
/// The name of a file before the messages of errors that do not know it.

#include <fmt/format.h>

#include <string>

namespace durero::cli {

/// Calls work(), and adds the name of the file to its errors of that type.
template <class Error, class Work>
auto naming_file(const std::string& file, Work&& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace durero::cli
