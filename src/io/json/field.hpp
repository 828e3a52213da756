#pragma once
/// A field of a value that files hold: its key, where it is and what it must be. A table of fields is read and written
/// by the same few functions, so a key stands in one place.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "cone_fields.hpp"
#include "durero/contract/contract.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "texture_fields.hpp"

namespace durero::io {

/// What a value must be. A message says `KEY is WRONG; expected EXPECTED`; of a number, its value and not `wrong`.
template <class Value>
struct Rule {
  bool (*holds)(const Value&);
  std::string_view wrong, expected;
};

inline bool always(const glm::dvec3&) { return true; }
inline constexpr Rule<glm::dvec3> any_triple{always, "", ""};

template <class Part, class Value>
struct Field {
  std::string_view key;
  Value Part::*member;
  Rule<Value> rule;
  const contract::clause* clause = nullptr;  ///< of the text that the rule is, if it is one
};

/// Fails at that byte where the value of a key breaks the rule, which is that clause. `In` is what reads: it has
/// fail().
template <class In, class Value>
void check_rule(const In& in, std::size_t at, std::string_view key, const Rule<Value>& rule, const Value& value,
                const contract::clause* clause = nullptr) {
  if (rule.holds(value)) return;
  const std::string label = clause == nullptr ? "" : fmt::format(" ({})", clause->label);
  const std::string expected = fmt::format("expected {}{}", rule.expected, label);
  if constexpr (std::is_same_v<Value, double>) {
    in.fail(at, fmt::format("{} is {}", key, value), expected, clause);
  } else {
    in.fail(at, fmt::format("{} is {}", key, rule.wrong), expected, clause);
  }
}

inline void read_json(json::Reader& in, std::string_view what, bool& value) { value = in.boolean(what); }
inline void read_json(json::Reader& in, std::string_view what, double& value) { value = in.number(what); }
inline void read_json(json::Reader& in, std::string_view what, glm::dvec3& value) { value = in.vec3(what); }
inline void read_json(json::Reader& in, std::string_view what, std::array<glm::dvec3, 3>& value) {
  value = in.three_points(what);
}

/// Writes a member of an object. What is no value of JSON alone has one of its own.
template <class Value>
void write_member(json::Writer& out, std::string_view key, const Value& value) {
  out.member(key, value);
}

/// Every field of a table.
inline constexpr std::size_t all_fields = std::numeric_limits<std::size_t>::max();

/// Reads an object that has the first `required` fields of the table, perhaps the others, and none besides; what it
/// lacks stays as it is. `what` names it in messages.
template <class Part, class... Value>
void read_fields(json::Reader& in, std::string_view what, const std::tuple<Field<Part, Value>...>& fields, Part& part,
                 std::size_t required = all_fields) {
  const auto keys = std::apply([](const auto&... field) { return std::array{field.key...}; }, fields);
  in.object(what, keys, std::min(required, keys.size()), [&](std::size_t known) {
    const auto read = [&](const auto& field) {
      if (field.key != keys[known]) return;
      const std::size_t at = in.offset();
      read_json(in, field.key, part.*field.member);
      check_rule(in, at, field.key, field.rule, part.*field.member, field.clause);
    };
    std::apply([&](const auto&... field) { (read(field), ...); }, fields);
  });
}

/// Writes an object of the fields of the table: of those behind the first `required`, what is not as in a new part.
template <class Part, class... Value>
void write_fields(json::Writer& out, const std::tuple<Field<Part, Value>...>& fields, const Part& part,
                  std::size_t required = all_fields) {
  const Part fresh{};
  std::size_t i = 0;
  const auto write = [&](const auto& field) {
    if (i++ < required || part.*field.member != fresh.*field.member) write_member(out, field.key, part.*field.member);
  };
  out.begin_object();
  std::apply([&](const auto&... field) { (write(field), ...); }, fields);
  out.end_object();
}

}  // namespace durero::io
