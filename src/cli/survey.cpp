#include "survey.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "durero/io/file_name.hpp"
#include "durero/io/formats.hpp"
#include "durero/io/standard_output.hpp"
#include "durero/text/shown.hpp"
#include "progress.hpp"

namespace durero::cli {
namespace {

namespace fs = std::filesystem;

/// A reason that several files have in common, and the first of them.
struct SharedReason {
  std::size_t files = 0;
  std::uint64_t things = 0;  // of a loss
  std::string first{};
};
using SharedReasons = std::map<std::string, SharedReason>;

/// The files below a folder that a format is known for, in the order of their names.
std::vector<std::string> files_below(const std::string& folder) {
  const auto is_scene = [](const std::string& path) {
    return std::ranges::any_of(io::formats(), [&](const io::Format& format) {
      return format.read != nullptr && io::ends_in(path, format.ending);
    });
  };
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw io::FileError(folder, "no folder", "expected one");
  std::vector<std::string> files;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied))
    if (entry.is_regular_file(error) && is_scene(entry.path().string())) files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

/// The message without the words in quotes, which are of one file.
std::string without_quotes(std::string_view message) {
  std::string text;
  bool is_quoted = false;
  for (const char c : message) {
    if (c == '"') text += is_quoted ? "" : "…";
    if (c == '"')
      is_quoted = !is_quoted;
    else if (!is_quoted)
      text += c;
  }
  return text;
}

void add_reason(SharedReasons& reasons, const std::string& reason, const std::string& first, std::uint64_t things = 0) {
  SharedReason& shared = reasons[reason];
  if (shared.files++ == 0) shared.first = first;
  shared.things += things;
}

/// Adds a loss, `N things fate`, by its things and fate.
void add_loss_of(SharedReasons& losses, const std::string& line, const std::string& file) {
  std::uint64_t things = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), things);
  const bool has_number = error == std::errc();
  add_reason(losses, line.substr(has_number ? static_cast<std::size_t>(end - line.data()) : 0), file, things);
}

/// The loss of several things whose words are those of one thing, but for the ending of one word; the end where there
/// is none.
SharedReasons::iterator plural_of(const std::string& one, SharedReasons& losses) {
  for (std::size_t end = one.find(' ', 1); end != one.npos; end = one.find(' ', end + 1))
    for (const std::string_view ending : {"s", "es"}) {
      const auto several = losses.find(std::string(one).insert(end, ending));
      if (several != losses.end()) return several;
    }
  return losses.end();
}

/// Puts what is told of one thing to what is told of several.
void join_plurals(SharedReasons& losses) {
  for (auto one = losses.begin(); one != losses.end();) {
    const auto several = plural_of(one->first, losses);
    if (several == losses.end()) {
      ++one;
      continue;
    }
    several->second.files += one->second.files;
    several->second.things += one->second.things;
    one = losses.erase(one);
  }
}

/// The reasons of most files first.
std::vector<std::pair<std::string, SharedReason>> ordered(const SharedReasons& reasons) {
  std::vector<std::pair<std::string, SharedReason>> all(reasons.begin(), reasons.end());
  std::ranges::stable_sort(all, std::ranges::greater(), [](const auto& reason) { return reason.second.files; });
  return all;
}

}  // namespace

int survey(const std::string& folder, const std::string& root, bool quiet) {
  const std::vector<std::string> files = files_below(folder);
  SharedReasons stops, losses;
  std::size_t read = 0;
  std::optional<Progress> progress(std::in_place, quiet, "import");
  for (const std::string& file : files) {
    try {
      for (const std::string& line : io::read_any_format(file, {.root = root}).lost) add_loss_of(losses, line, file);
      ++read;
    } catch (const io::InputError& error) {
      add_reason(stops, without_quotes(error.message()), error.what());
    } catch (const std::exception& error) {
      add_reason(stops, without_quotes(error.what()), error.what());
    }
  }
  progress.reset();
  join_plurals(losses);
  std::string text = fmt::format("{}: {} of {} files are read\n", text::escaped(folder), read, files.size());
  for (const auto& [reason, shared] : ordered(stops))
    text += fmt::format("not read: {} × {}\n  first {}\n", shared.files, reason, shared.first);
  for (const auto& [reason, shared] : ordered(losses))
    text += fmt::format("read: in {} of them, {} in all:{}\n", shared.files, shared.things, reason);
  io::print(text);
  return read == files.size() ? 0 : 1;
}

}  // namespace durero::cli
