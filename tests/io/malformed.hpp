#pragma once
/// Whether reading a text fails, and where and how.
#include <string>

#include "durero/io/source.hpp"

namespace durero::test {

/// The message of the InputError that read(Source) throws, or "" where it throws none.
template <class Read>
std::string error_of(const std::string& text, Read&& read) {
  try {
    read(io::Source("f", text));
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

/// A text whose wrong place a `^` marks, without the mark, and what a message starts with that stands there.
struct Marked {
  explicit Marked(std::string with_mark) : text(std::move(with_mark)) {
    const std::size_t at = text.find('^');
    if (at == text.npos) throw std::logic_error("no mark in " + text);
    text.erase(at, 1);
    std::size_t line = 1, column = 1;
    for (std::size_t i = 0; i < at; ++i) {
      ++column;
      if (text[i] != '\n' && (text[i] != '\r' || text[i + 1] == '\n')) continue;
      ++line;
      column = 1;
    }
    place = "f:" + std::to_string(line) + ":" + std::to_string(column) + ": ";
  }
  std::string text, place;
};

/// What is wrong in a text with a mark: the message of read(Source) without its place, which is the mark's; otherwise
/// the whole message.
template <class Read>
std::string error_at_mark(const std::string& with_mark, Read&& read) {
  const Marked marked(with_mark);
  const std::string error = error_of(marked.text, read);
  return error.starts_with(marked.place) ? error.substr(marked.place.size()) : "not at " + marked.place + error;
}

/// A small deterministic generator of damage: a copy of the text with up to four bytes changed, removed, doubled or put
/// in.
class Mutator {
 public:
  std::string operator()(std::string text) {
    for (std::uint64_t n = next() % 4 + 1; n > 0 && !text.empty(); --n) damage(text);
    return text;
  }

 private:
  void damage(std::string& text) {
    static constexpr std::string_view frequent = "{}[]\",:-+.eE0159 \n@#?=()\\ntf\x80\xC3";
    const std::size_t at = next() % text.size();
    const char c = next() % 4 == 0 ? static_cast<char>(next() % 256) : frequent[next() % frequent.size()];
    switch (next() % 4) {
      case 0:
        text[at] = c;
        break;
      case 1:
        text.insert(text.begin() + static_cast<std::ptrdiff_t>(at), c);
        break;
      case 2:
        text.erase(at, next() % 8 + 1);
        break;
      default:
        text.insert(at, text.substr(next() % text.size(), next() % 16));
    }
  }
  std::uint64_t next() {  // xorshift64: any sequence will do, and this one is the same everywhere
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    state_ ^= state_ << 17U;
    return state_;
  }
  std::uint64_t state_ = 0x9E3779B97F4A7C15;
};

/// Reads `count` damaged copies; each is read, or refused with a place inside it and one line. Answers how many are
/// refused.
template <class Read>
std::size_t refused_after_damage(const std::string& text, std::size_t count, Read&& read) {
  Mutator mutate;
  std::size_t refused = 0;
  while (count-- > 0) {
    const std::string error = error_of(mutate(text), read);
    if (error.empty()) continue;
    ++refused;
    if (!error.starts_with("f:") || error.find('\n') != error.npos || error.find("; expected ") == error.npos) {
      throw std::logic_error("no error line: " + error);
    }
  }
  return refused;
}

}  // namespace durero::test
