#include "file_watch.hpp"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "durero/io/json/json.hpp"

namespace durero::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A program writes the next part of a file sooner than this, in milliseconds.
constexpr int patience_of_writer = 150;

constexpr std::uint32_t saves = IN_MODIFY | IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE | IN_CREATE;

bool is_json(const io::Source& source) {
  try {
    const io::json::Document document(source);
    return true;
  } catch (const io::InputError&) {
    return false;
  }
}

}  // namespace

FileWatch::FileWatch(std::string path)
    : path_(std::move(path)), descriptor_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
  if (descriptor_ < 0) throw io::FileError(path_, "cannot be watched", "expected inotify of Linux");
  try {
    if (path_ == "-") throw io::FileError(path_, "is the standard input, which cannot be watched", "expected a file");
    watch(path_);
    std::error_code error;
    const fs::path led_to = fs::canonical(path_, error);
    if (!error) watch(led_to.string());
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

FileWatch::~FileWatch() { ::close(descriptor_); }

void FileWatch::watch(const std::string& path) {
  const fs::path file(path);
  const std::string folder = file.has_parent_path() ? file.parent_path().string() : ".";
  const int number = ::inotify_add_watch(descriptor_, folder.c_str(), saves);
  if (number < 0)
    throw io::FileError(path, std::string("cannot be watched: ") + std::strerror(errno), "expected a file in a folder");
  watched_.push_back({number, file.filename().string()});
}

bool FileWatch::was_saved() {
  bool was = false;
  alignas(inotify_event) std::array<char, 16384> bytes;
  for (ssize_t count; (count = ::read(descriptor_, bytes.data(), bytes.size())) > 0;) {
    for (ssize_t at = 0; at < count;) {
      const auto* const event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
      at += static_cast<ssize_t>(sizeof(inotify_event) + event->len);
      const std::string name = event->len > 0 ? event->name : "";
      const auto is_it = [&](const Watched& each) { return each.folder == event->wd && each.name == name; };
      was = was || (event->mask & IN_Q_OVERFLOW) != 0 || std::ranges::any_of(watched_, is_it);
    }
  }
  return was;
}

bool FileWatch::is_saved_within(int milliseconds) {
  const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd input{descriptor_, POLLIN, 0};
    const int ready = ::poll(&input, 1, static_cast<int>(std::max<long>(left, 0)));
    if (ready > 0 && was_saved()) return true;
    if (ready < 0 || left <= 0) return false;
  }
}

io::Source FileWatch::whole_file() {
  while (true) {
    io::Source source = io::read_source(path_);
    if (is_json(source) || !is_saved_within(patience_of_writer)) return source;
  }
}

}  // namespace durero::cli
