#pragma once
/// A scene in a terminal, to be turned and picked from.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "durero/engine/engine.hpp"
#include "durero/io/source.hpp"
#include "durero/scene/stage.hpp"
#include "file_watch.hpp"

namespace durero::cli {

/// The call of a view.
struct ViewOptions {
  std::string scene;
  std::string engine{engine::default_engine}, hierarchy{"automatic"}, with;
  std::size_t threads = 0;
  std::optional<io::Source> text{};  ///< the scene, where it is not that of the file as it is
};

/// The keys of a view, and what they do.
std::string_view view_keys();

/// Shows a scene until the person ends it. The last camera. With a watch each save is shown, seen as before; a file
/// that is wrong is told below the last picture. Throws as the reader of scenes does, and std::invalid_argument where
/// there is no terminal.
scene::Camera show_in_terminal(const ViewOptions& options, FileWatch* watch = nullptr);

/// The line of a scene file that has the camera.
std::string camera_line(const scene::Camera& camera);

}  // namespace durero::cli
