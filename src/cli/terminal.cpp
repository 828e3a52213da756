#include "terminal.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "durero/io/standard_output.hpp"
#include "interrupted.hpp"

namespace durero::cli {
namespace {

/// The other screen without a cursor, and clicks as `ESC [ < button ; column ; row M`.
constexpr std::string_view begin_screen = "\033[?1049h\033[?25l\033[?1000h\033[?1006h",
                           end_screen = "\033[?1006l\033[?1000l\033[?25h\033[?1049l";
/// The rest of a key's bytes comes as soon as this, or it was the key Escape.
constexpr int sequence_patience = 50;  // milliseconds

std::atomic<bool> was_resized = false;

using Kind = TerminalInput::Kind;
using Pixel = std::array<std::uint8_t, 3>;

/// The arrow of the letter that ends its bytes.
std::optional<Kind> arrow(char letter) {
  switch (letter) {
    case 'A':
      return Kind::up;
    case 'B':
      return Kind::down;
    case 'C':
      return Kind::right;
    case 'D':
      return Kind::left;
    default:
      return std::nullopt;
  }
}

/// `button ; column ; row M`; nothing for another button, and for one that is let go.
std::optional<TerminalInput> click_of(std::string_view text) {
  std::array<unsigned, 3> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (unsigned& number : numbers) {
    const auto [next, error] = std::from_chars(at, end, number);
    if (error != std::errc() || next == end) return std::nullopt;
    at = next + 1;
  }
  const auto& [button, column, row] = numbers;
  if (text.back() != 'M' || column == 0 || row == 0) return std::nullopt;
  if (button == 64) return TerminalInput{Kind::nearer};
  if (button == 65) return TerminalInput{Kind::farther};
  return button == 0 ? std::optional(TerminalInput{Kind::click, 0, column - 1, row - 1}) : std::nullopt;
}

/// The number of the nearest colour of 216, of six values of each component.
unsigned nearest_of_216(const Pixel& pixel) {
  unsigned number = 16;
  for (std::size_t i = 0; i < 3; ++i) {
    const unsigned value = pixel[i];  // the values are 0, and 95 to 255 in steps of 40
    number += (value < 48 ? 0 : value < 115 ? 1 : (value - 35) / 40) * (i == 0 ? 36 : i == 1 ? 6 : 1);
  }
  return number;
}

/// Appends what sets a colour: of the characters, or of the ground behind them.
void append_colour(std::string& text, const Pixel& pixel, bool has_all_colours, bool is_ground) {
  auto end = std::back_inserter(text);
  if (has_all_colours)
    fmt::format_to(end, FMT_COMPILE("\033[{}8;2;{};{};{}m"), is_ground ? 4 : 3, pixel[0], pixel[1], pixel[2]);
  else
    fmt::format_to(end, FMT_COMPILE("\033[{}8;5;{}m"), is_ground ? 4 : 3, nearest_of_216(pixel));
}

}  // namespace

Terminal::Terminal(int other) : other_(other) {
  if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDOUT_FILENO) != 1 || ::tcgetattr(STDIN_FILENO, &before_) != 0)
    throw std::invalid_argument("standard input or output is no terminal; expected one that shows the scene");
  interrupted();
  struct sigaction action {};
  action.sa_handler = [](int) { was_resized = true; };  // without SA_RESTART: poll() ends
  ::sigaction(SIGWINCH, &action, nullptr);
  termios raw = before_;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  io::print(begin_screen);
}

Terminal::~Terminal() {
  ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  try {
    io::print(end_screen);
  } catch (const std::exception&) {  // the terminal is gone
  }
}

TerminalSize Terminal::size() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return {80, 24};
  return {size.ws_col, size.ws_row};
}

bool Terminal::has_next(int within) const {
  std::array inputs{pollfd{STDIN_FILENO, POLLIN, 0}, pollfd{other_, POLLIN, 0}};  // a negative one is passed over
  return !typed_.empty() || was_resized || interrupted() || ::poll(inputs.data(), inputs.size(), within) != 0;
}

/// Whether some bytes have come in that time; without end where it is negative.
bool Terminal::read_more(int milliseconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, milliseconds) <= 0) return false;
  std::array<char, 256> bytes;
  const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count > 0) typed_.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0;
}

TerminalInput Terminal::next() {
  while (true) {
    if (was_resized.exchange(false)) return {Kind::resized};
    if (interrupted()) return {Kind::end};
    if (typed_.empty()) {
      std::array inputs{pollfd{STDIN_FILENO, POLLIN, 0}, pollfd{other_, POLLIN, 0}};
      if (::poll(inputs.data(), inputs.size(), -1) < 0 && errno == EINTR) continue;
      if (inputs[1].revents != 0) return {Kind::told};
      if (!read_more(0)) return {Kind::end};
    }
    const auto take = [&](std::size_t bytes) { typed_.erase(0, bytes); };
    if (typed_.front() != '\033') {
      const char character = typed_.front();
      take(1);
      return {Kind::character, character};
    }
    if (typed_.size() < 3 && !read_more(sequence_patience)) {
      take(typed_.size());
      return {Kind::character, '\033'};
    }
    if (typed_.size() < 3) continue;
    // A key is ESC [ or ESC O, and what ends with the first letter.
    std::size_t end = typed_.find_first_of("ABCDEFGHMPQRSZm~", 2);
    if (end == typed_.npos) {
      if (!read_more(sequence_patience)) take(typed_.size());
      continue;
    }
    const std::string key = typed_.substr(0, end + 1);
    take(end + 1);
    if (key.starts_with("\033[<")) {
      if (const auto click = click_of(std::string_view(key).substr(3))) return *click;
    } else if (const auto way = arrow(key.back())) {
      return {*way};
    }
  }
}

std::string in_half_blocks(const render::Image& image, bool has_all_colours) {
  const auto& [width, height] = image.resolution;
  const auto pixel = [&](std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* const at = image.rgb.data() + (std::size_t{y} * width + x) * 3;
    return Pixel{at[0], at[1], at[2]};
  };
  std::string text = "\033[H";
  for (std::uint32_t y = 0; y + 1 < height; y += 2) {
    std::optional<Pixel> upper, lower;
    for (std::uint32_t x = 0; x < width; ++x) {
      const Pixel above = pixel(x, y), below = pixel(x, y + 1);
      if (above != upper) append_colour(text, *(upper = above), has_all_colours, false);
      if (below != lower) append_colour(text, *(lower = below), has_all_colours, true);
      text += "▀";
    }
    text += "\033[0m\n";
  }
  return text;
}

}  // namespace durero::cli
