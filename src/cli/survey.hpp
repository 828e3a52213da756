#pragma once
/// The survey of a folder, `durero import FOLDER --survey`: which of its files can be imported, and what stops the
/// rest.

#include <string>

namespace durero::cli {

/// Reads each file below a folder whose name tells a format, with the files that it names in `root` or, without one, in
/// its own folder. Prints how many are read, what stops the others, and what of those that are read is left out or
/// changed. Nothing is written. 0 where all are read, else 1. Throws io::FileError where there is no such folder.
int survey(const std::string& folder, const std::string& root, bool quiet);

}  // namespace durero::cli
