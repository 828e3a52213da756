// durero watch SCENE [--with TEXT] [--view]: checks a scene file at each save, a line each; or shows it in the
// terminal.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "by_text.hpp"
#include "commands.hpp"
#include "description.hpp"
#include "durero/io/json/scene_check.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/text/shown.hpp"
#include "engines.hpp"
#include "file_watch.hpp"
#include "interrupted.hpp"
#include "scene_tracer.hpp"
#include "terminal_view.hpp"

namespace durero::cli {
namespace {

struct WatchOptions : ViewOptions {
  bool view = false;
};

/// An interrupt is seen as soon as this, in milliseconds, where it comes between a look and a wait.
constexpr int longest_wait = 500;

/// What `durero check` says of a file, in a line: the first thing that is wrong, or how many elements there are.
std::string verdict(const io::SceneCheck& check) {
  if (!check.errors.empty()) return check.errors.front().what();
  const std::string file = text::escaped(check.file);
  if (!check.findings.empty()) return fmt::format("{}: {}", file, check.findings.front().message);
  return fmt::format("{}: ok: {} elementos", file, check.scene.size());
}

/// Tells each state of a file once.
class Teller {
 public:
  Teller(const WatchOptions& options, FileWatch& watch) : options_(options), watch_(watch) {}

  /// Tells what the file is now, and how long that took since the save was seen; nothing where it is as it was.
  void tell() {
    const auto begin = std::chrono::steady_clock::now();
    const std::string now = look();
    if (now.empty()) return;
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
    io::print(fmt::format("{} ({:.0f} ms)\n", now, taken.count()));
  }

 private:
  std::string look() {
    try {
      const io::Source source = watch_.whole_file();
      if (told_ && *told_ == source.text()) return {};
      told_ = source.text();
      return verdict(options_.with.empty() ? io::check_scene(source) : check_by_text(source, options_.with));
    } catch (const io::FileError& error) {
      const bool is_new = told_ != error.what();
      told_ = error.what();
      return is_new ? error.what() : "";
    }
  }

  const WatchOptions& options_;
  FileWatch& watch_;
  std::optional<std::string> told_{};  // the text, or the error, that was told last
};

int watch(const WatchOptions& options) {
  const ThreadLimit limit(options.threads);
  FileWatch watch(options.scene);
  if (options.view) {
    io::print(camera_line(show_in_terminal(options, &watch)));
    return 0;
  }
  interrupted();
  Teller teller(options, watch);
  teller.tell();
  while (!interrupted())
    if (watch.is_saved_within(longest_wait)) teller.tell();
  return 0;
}

}  // namespace

void add_watch(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("watch", "Check a scene at each save, or show it in the terminal");
  const auto options = std::make_shared<WatchOptions>();
  command->add_option("SCENE", options->scene, "Scene file (JSON)")->required();
  command->add_flag("--view", options->view, "Show it in the terminal, as durero view does");
  add_with(*command, options->with);
  add_engine(*command, options->engine);
  add_hierarchy(*command, options->hierarchy);
  add_threads(*command, options->threads);
  command->footer(
      "It prints a line at the start and at each save: what durero check says first, and the time. Saves in place are\n"
      "seen as those that rename another file are; a text that is no JSON is told only where it stays so for 150 ms,\n"
      "as the rest may not be written yet. It ends when it is interrupted.\n\n"
      "With --view each save is drawn by the camera as it stands, and the error of a file that is wrong is told below\n"
      "the last picture. Keys: " +
      std::string(view_keys()) + ".\n\n" +
      exit_status("it was watched", "the call is bad, or there is no terminal to show it in") +
      examples({"watch demo/still-life.json", "watch demo/still-life.json --view"}));
  command->callback([options, &status] { status = watch(*options); });
}

}  // namespace durero::cli
