#pragma once
/// The commands of `durero store`, and what they share.

#include <CLI/CLI.hpp>
#include <string>

#include "durero/store/store.hpp"

namespace durero::cli {

/// @{ Each adds its commands to `store`.
void add_store_write(CLI::App& command, int& status);
void add_store_edit(CLI::App& command, int& status);
void add_store_read(CLI::App& command, int& status);
void add_store_names(CLI::App& command, int& status);
void add_store_compare(CLI::App& command, int& status);
void add_store_verify(CLI::App& command, int& status);
/// @}

/// The argument STORE of a command.
void add_store_path(CLI::App& command, std::string& path);
/// The argument REV of a command, which stands for HEAD where it is absent.
void add_revision(CLI::App& command, std::string& revision);

/// The options --author, --time and --comment of a command.
void add_provenance(CLI::App& command, store::Provenance& by);
/// What these say. Where there is no author, the environment names one: DURERO_AUTHOR, LOGNAME or USER. Where there is
/// no time, it is now.
store::Provenance provenance_of(store::Provenance by);

/// `event 4, branch main`
std::string where_text(store::Store& of);

}  // namespace durero::cli
