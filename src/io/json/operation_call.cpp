#include "operation_call.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "durero/io/json/json.hpp"
#include "durero/text/spanish.hpp"
#include "io/cursor.hpp"

namespace durero::io {
namespace {

double read_component(WordCursor& in) {
  in.skip_blanks();
  const double component = in.number(",()", "a triple");
  in.skip_blanks();
  return component;
}

glm::dvec3 read_triple(WordCursor& in) {
  glm::dvec3 v{};
  v.x = read_component(in);
  in.expect(',', "in (x,y,z)");
  v.y = read_component(in);
  in.expect(',', "in (x,y,z)");
  v.z = read_component(in);
  in.expect(')', "after (x,y,z");
  return v;
}

// ((x,y,z),(x,y,z),(x,y,z)), of which the first bracket has been read.
std::array<glm::dvec3, 3> read_three_points(WordCursor& in) {
  constexpr std::string_view where = "in ((x,y,z),(x,y,z),(x,y,z))";
  std::array<glm::dvec3, 3> points{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) in.expect(',', where);
    in.skip_blanks();
    in.expect('(', where);
    points[i] = read_triple(in);
    in.skip_blanks();
  }
  in.expect(')', "after ((x,y,z),(x,y,z),(x,y,z)");
  return points;
}

/// ((x,y,z),…), of which the first bracket has been read.
std::vector<glm::dvec3> read_triples(WordCursor& in) {
  constexpr std::string_view where = "in ((x,y,z),…)";
  std::vector<glm::dvec3> triples;
  in.skip_blanks();
  if (in.take(')')) return triples;
  do {
    in.skip_blanks();
    in.expect('(', where);
    triples.push_back(read_triple(in));
    in.skip_blanks();
  } while (in.take(','));
  in.expect(')', "after ((x,y,z),…");
  return triples;
}

bool is_list(std::string_view input) { return std::ranges::find(mesh_lists, input) != mesh_lists.end(); }

CallInput read_input(WordCursor& in) {
  CallInput input{{}, in.offset(), 0, {}};
  input.name = in.word("=?");
  if (input.name.empty()) in.fail(in.offset(), in.here(), "expected an input, name?=value");
  in.take('?');
  in.expect('=', "after the name of an input");
  input.value_offset = in.offset();
  if (in.take('(')) {
    in.skip_blanks();
    if (is_list(input.name)) {
      input.value = read_triples(in);
    } else if (in.at('(')) {
      input.value = read_three_points(in);
    } else {
      input.value = read_triple(in);
    }
    return input;
  }
  const std::string_view word = in.word("");
  if (word.empty())
    in.fail(input.value_offset, fmt::format("{} has no value", text::with_english(input.name)), "expected one after =");
  input.value = BareWord{std::string(word)};
  return input;
}

std::string without_mark(std::string_view name) {
  if (name.size() > 1 && name.ends_with('?')) name.remove_suffix(1);
  return std::string(name);
}

Call read_text_call(WordCursor& in) {
  const std::size_t at = in.offset();
  Call call{std::string(in.word("#")), at, {}};
  in.skip_blanks();
  while (!in.done()) {
    call.inputs.push_back(read_input(in));
    const std::size_t behind = in.offset();
    in.skip_blanks();
    if (!in.done() && in.offset() == behind) in.fail(behind, in.here(), "expected a space after an input");
  }
  return call;
}

void read_array(json::Reader& in, std::string_view what, CallInput& input) {
  const json::TokenKind first = in.kind_of_first_item();
  if (is_list(input.name)) {
    std::vector<glm::dvec3> triples;
    in.array(what, [&] { triples.push_back(in.vec3(what)); });
    input.value = std::move(triples);
  } else if (first == json::TokenKind::array) {
    input.value = in.three_points(what);
  } else if (first == json::TokenKind::string || first == json::TokenKind::end_array) {
    std::vector<std::string> names;
    in.array(what, [&] { names.emplace_back(in.string(what)); });
    input.value = std::move(names);
  } else {
    input.value = in.vec3(what);
  }
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
    CallInput input{without_mark(key.name), key.offset, at, {}};
    switch (in.kind()) {
      case json::TokenKind::number:
        input.value = in.number(key.name);
        break;
      case json::TokenKind::array:
        read_array(in, key.name, input);
        break;
      default:
        input.value = std::string(in.string(key.name));
    }
    call.inputs.push_back(std::move(input));
  });
  if (!named) source.fail(begin, "key \"op\" is missing", "expected the name of an operation");
  return call;
}

}  // namespace

std::optional<Call> read_call(const Source& source, const TextLine& line) {
  WordCursor in(source, line);
  if (in.done()) return std::nullopt;
  return in.at('{') ? read_json_call(source, in.offset(), line.end) : read_text_call(in);
}

}  // namespace durero::io
