#pragma once
/// Lines that a person types, with a history and completion, by libedit; or those of a pipe.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "edit_completion.hpp"

namespace durero::cli {

/// The lines of the standard input. There is one at a time.
class LineReader {
 public:
  /// Tells what the line up to the cursor may go on with.
  using Completer = std::function<TypedCompletion(std::string_view line)>;

  /// Asks with that prompt where a person types.
  LineReader(std::string prompt, Completer completer);
  ~LineReader();

  /// Whether a person types: the standard input and output are a terminal.
  bool is_terminal() const noexcept { return typed_ != nullptr; }
  /// The next line, without its end; nothing at the end of the input. It is kept in the history.
  std::optional<std::string> next();

 private:
  struct Typed;
  std::unique_ptr<Typed> typed_{};
};

}  // namespace durero::cli
