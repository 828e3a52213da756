#include "line_reader.hpp"

#include <histedit.h>
#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <utility>

#include "durero/io/standard_output.hpp"

namespace durero::cli {
namespace {

constexpr int most_lines = 1000;          // of the history
constexpr std::size_t most_listed = 200;  // words below a line

/// What all of these begin with. Precondition: there is one.
std::string common_start(const std::vector<std::string>& words) {
  const auto [first, last] = std::ranges::minmax_element(words);
  const auto end = std::ranges::mismatch(*first, *last).in1;
  return {first->begin(), end};
}

}  // namespace

struct LineReader::Typed {
  std::string prompt;
  Completer completer;
  EditLine* line = nullptr;
  ::History* history = nullptr;
  void (*on_interrupt)(int) = SIG_DFL;  // what it was

  Typed(std::string asked, Completer goes_on) : prompt(std::move(asked)), completer(std::move(goes_on)) {
    std::setlocale(LC_CTYPE, "C.UTF-8");
    line = ::el_init("durero", stdin, stdout, stderr);
    history = ::history_init();
    HistEvent event;
    ::history(history, &event, H_SETSIZE, most_lines);
    ::el_set(line, EL_CLIENTDATA, this);
    ::el_set(line, EL_PROMPT, &Typed::prompt_of);
    ::el_set(line, EL_EDITOR, "emacs");
    ::el_set(line, EL_HIST, ::history, history);
    ::el_set(line, EL_ADDFN, "complete", "completes the word", &Typed::complete);
    ::el_set(line, EL_BIND, "^I", "complete", nullptr);
    // An interrupt empties the line, and no more: where it comes while no line is read, it does nothing.
    ::el_set(line, EL_SETTY, "-d", "-isig", nullptr);
    on_interrupt = std::signal(SIGINT, SIG_IGN);
    ::el_set(line, EL_BIND, "^C", "em-kill-line", nullptr);
  }
  ~Typed() {
    ::el_end(line);
    ::history_end(history);
    std::signal(SIGINT, on_interrupt);
  }
  Typed(const Typed&) = delete;
  Typed& operator=(const Typed&) = delete;

  static Typed& of(EditLine* edited) {
    void* self = nullptr;
    ::el_get(edited, EL_CLIENTDATA, &self);
    return *static_cast<Typed*>(self);
  }
  static char* prompt_of(EditLine* edited) { return of(edited).prompt.data(); }

  /// Completes as far as all words agree; where they agree no further, it lists them.
  static unsigned char complete(EditLine* edited, int) {
    const LineInfo* const now = ::el_line(edited);
    const std::string_view before(now->buffer, static_cast<std::size_t>(now->cursor - now->buffer));
    const auto [begin, words] = of(edited).completer(before);
    if (words.empty()) return CC_ERROR;
    std::string more = common_start(words).substr(before.size() - begin);
    if (words.size() == 1 && !words.front().ends_with('=')) more += ' ';
    if (!more.empty()) return ::el_insertstr(edited, more.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    std::string listed = "\n";
    for (std::size_t i = 0; i < std::min(words.size(), most_listed); ++i) listed += words[i] + "\n";
    if (words.size() > most_listed) listed += "…\n";
    io::print(listed);
    return CC_REDISPLAY;
  }
};

LineReader::LineReader(std::string prompt, Completer completer) {
  if (::isatty(STDIN_FILENO) == 1 && ::isatty(STDOUT_FILENO) == 1)
    typed_ = std::make_unique<Typed>(std::move(prompt), std::move(completer));
}

LineReader::~LineReader() = default;

std::optional<std::string> LineReader::next() {
  if (typed_ == nullptr) {
    std::string line;
    return std::getline(std::cin, line) ? std::optional(std::move(line)) : std::nullopt;
  }
  int count = 0;
  ::el_set(typed_->line, EL_PREP_TERM, 1);  // before the prompt, so that whoever sees it types into the line
  const char* const read = ::el_gets(typed_->line, &count);
  if (read == nullptr || count <= 0) return std::nullopt;
  std::string line(read, static_cast<std::size_t>(count));
  while (line.ends_with('\n') || line.ends_with('\r')) line.pop_back();
  HistEvent event;
  if (!line.empty()) ::history(typed_->history, &event, H_ENTER, line.c_str());
  return line;
}

}  // namespace durero::cli
