#pragma once
/// A terminal as a screen: characters come as they are typed, clicks too, and a picture stands in half blocks.

#include <termios.h>

#include <string>
#include <string_view>

#include "durero/render/output/image.hpp"

namespace durero::cli {

/// An action of a person at a terminal.
struct TerminalInput {
  /// The kinds of it.
  enum class Kind {
    character,  ///< a key of one byte
    left,
    right,
    up,
    down,   ///< arrows
    click,  ///< the left button of a mouse
    nearer,
    farther,  ///< its wheel
    resized,  ///< the terminal has another size
    told,     ///< the other descriptor can be read
    end       ///< nothing comes any more, or the program is interrupted
  };
  Kind kind;
  char character = 0;            ///< of a key
  unsigned column = 0, row = 0;  ///< of a click, from 0
};

/// The size of a terminal, in characters.
struct TerminalSize {
  unsigned columns, rows;
};

/// The terminal of standard input and output, as long as this lives; then it is as it was before.
class Terminal {
 public:
  /// The number of no descriptor.
  static constexpr int no_descriptor = -1;
  /// Waits for another descriptor as well, where one is given. Throws std::invalid_argument where one of both is no
  /// terminal.
  explicit Terminal(int other = no_descriptor);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Its size, of which a row and a column is the least.
  static TerminalSize size();
  /// Waits for the next input.
  TerminalInput next();
  /// Whether next() need not wait, or not longer than so many milliseconds.
  bool has_next(int within = 0) const;

 private:
  bool read_more(int milliseconds);

  int other_;
  termios before_{};
  std::string typed_{};  // and not taken yet
};

/// The text that shows a picture from the upper left corner on, two pixels in a character, one above the other. Colours
/// are of 24 bits, or the nearest of the 216 that a terminal has which knows no others.
std::string in_half_blocks(const render::Image& image, bool has_all_colours);

}  // namespace durero::cli
