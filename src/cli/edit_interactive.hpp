#pragma once
/// `durero edit SCENE -i`: operations that are typed, carried out and answered line by line. The demonstration's
/// program has no such session, and refuses it (demo_commands.cpp).

#include <memory>
#include <string>

#include "by_text.hpp"
#include "durero/io/json/edited_scene.hpp"
#include "durero/io/source.hpp"

namespace durero::cli {

/// The call of a session.
struct SessionCall {
  io::Source source;                       ///< the scene's file, as it was read
  std::unique_ptr<io::EditedScene> scene;  ///< the scene that it holds
  std::string with;                        ///< the file of the Z text that says what its elements are, or empty
  std::string out;                         ///< where it is written where no file is named; empty for its own file
  Editor editor;                           ///< carries out each operation
  ClauseFinder find;                       ///< finds why one would be refused
};

/// Runs a session on the standard input and output. The exit status: 0 where nothing was lost.
int edit_interactively(SessionCall call);

}  // namespace durero::cli
