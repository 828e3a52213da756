#include "operation_call.hpp"

#include <fmt/format.h>

#include <cmath>

#include "durero/io/json.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "durero/text/utf8.hpp"

namespace durero::io {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

// Walks the text of one operation.
class Scanner {
 public:
  Scanner(const Source& source, std::size_t begin, std::size_t end)
      : source_(source), text_(source.text().substr(0, end)), at_(begin) {}

  std::size_t offset() const { return at_; }
  bool done() const { return at_ == text_.size() || text_[at_] == '#'; }
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }
  bool take(char c) {
    if (at_ == text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c, std::string_view where) {
    if (!take(c)) source_.fail(at_, here(), fmt::format("expected {} {}", c, where));
  }
  // Up to a blank or one of the given characters; may be empty.
  std::string_view take_until(std::string_view stops) {
    const std::size_t from = at_;
    while (at_ < text_.size() && stops.find(text_[at_]) == stops.npos && blanks.find(text_[at_]) == blanks.npos) ++at_;
    return text_.substr(from, at_ - from);
  }
  std::string here() const {
    return at_ == text_.size() ? "the operation ends" : text::shown(text::first(text_.substr(at_))) + " stands here";
  }
  [[noreturn]] void fail(std::size_t offset, const std::string& wrong, const std::string& expected) const {
    source_.fail(offset, wrong, expected);
  }

 private:
  const Source& source_;
  std::string_view text_;
  std::size_t at_;
};

double read_component(Scanner& in) {
  in.skip_blanks();
  const std::size_t at = in.offset();
  const std::string_view text = in.take_until(",()");
  const auto value = read_number(text);
  if (!value || !std::isfinite(*value))
    in.fail(at, fmt::format("{} in a triple", text::shown(text)), "expected a finite number");
  in.skip_blanks();
  return *value;
}

glm::dvec3 read_triple(Scanner& in) {
  glm::dvec3 v{};
  v.x = read_component(in);
  in.expect(',', "in (x,y,z)");
  v.y = read_component(in);
  in.expect(',', "in (x,y,z)");
  v.z = read_component(in);
  in.expect(')', "after (x,y,z");
  return v;
}

Input read_input(Scanner& in) {
  Input input{{}, in.offset(), 0, {}};
  input.name = in.take_until("=?");
  if (input.name.empty()) in.fail(in.offset(), in.here(), "expected an input, name?=value");
  in.take('?');
  in.expect('=', "after the name of an input");
  input.value_offset = in.offset();
  if (in.take('(')) {
    input.value = read_triple(in);
    return input;
  }
  const std::string_view word = in.take_until("");
  if (word.empty()) in.fail(input.value_offset, fmt::format("{} has no value", input.name), "expected one after =");
  input.value = Word{std::string(word)};
  return input;
}

std::string without_mark(std::string_view name) {
  if (name.size() > 1 && name.ends_with('?')) name.remove_suffix(1);
  return std::string(name);
}

}  // namespace

Call read_text_call(const Source& source, std::size_t begin, std::size_t end) {
  Scanner in(source, begin, end);
  Call call{std::string(in.take_until("#")), begin, {}};
  in.skip_blanks();
  while (!in.done()) {
    call.inputs.push_back(read_input(in));
    const std::size_t behind = in.offset();
    in.skip_blanks();
    if (!in.done() && in.offset() == behind) in.fail(behind, in.here(), "expected a space after an input");
  }
  return call;
}

Call read_json_call(const Source& source, std::size_t begin, std::size_t end) {
  const json::Document document(source, begin, end);
  json::Reader in(document);
  Call call{{}, begin, {}};
  bool named = false;
  in.members("an operation", [&](const json::Key& key) {
    const std::size_t at = in.offset();
    if (key.name == "op") {
      if (named) in.fail(key.offset, "key \"op\" stands twice", "expected it once");
      named = true;
      call.schema = in.string("op");
      call.offset = at;
      return;
    }
    Input input{without_mark(key.name), key.offset, at, {}};
    switch (in.kind()) {
      case json::Kind::number:
        input.value = in.number(key.name);
        break;
      case json::Kind::array:
        input.value = in.vec3(key.name);
        break;
      default:
        input.value = std::string(in.string(key.name));
    }
    call.inputs.push_back(std::move(input));
  });
  if (!named) source.fail(begin, "key \"op\" is missing", "expected the name of an operation");
  return call;
}

}  // namespace durero::io
