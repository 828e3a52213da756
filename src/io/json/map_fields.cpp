#include "map_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "durero/number/rational.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

using number::Rational;

constexpr std::size_t longest = 1000;

bool is_whole(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

Rational read_entry(json::Reader& in) {
  if (in.kind() != json::TokenKind::string) return number::exact(in.number("an entry of mapa"));
  const std::size_t at = in.offset();
  const std::string_view text = in.string("an entry of mapa");
  const auto value = fraction_of(text);
  if (!value)
    in.fail(at, fmt::format("an entry of mapa is {}", text::shown(text)),
            "expected a number, or a fraction such as \"-1/3\"");
  return *value;
}

using Row = std::array<Rational, 4>;

Row read_row(json::Reader& in) {
  const std::size_t at = in.offset();
  Row row;
  std::size_t count = 0;
  const auto require = [&](bool holds) {
    if (!holds) in.fail(at, "a row of mapa has not four entries", "expected four");
  };
  in.array("a row of mapa", [&] {
    require(count < row.size());
    row[count++] = read_entry(in);
  });
  require(count == row.size());
  return row;
}

void write_entry(json::Writer& out, const Rational& entry) {
  const double rounded = number::round_to_binary64(entry);
  if (std::isfinite(rounded) && number::exact(rounded) == entry) {
    out.value(rounded);
  } else {
    out.value(entry.str());
  }
}

}  // namespace

std::optional<Rational> fraction_of(std::string_view text) {
  if (text.size() > longest) return std::nullopt;
  const bool is_negative = text.starts_with('-');
  const std::string_view magnitude = text.substr(is_negative ? 1 : 0);
  const std::size_t slash = std::min(magnitude.find('/'), magnitude.size());
  const std::string_view above = magnitude.substr(0, slash);
  const std::string_view below = slash == magnitude.size() ? "1" : magnitude.substr(slash + 1);
  if (!is_whole(above) || !is_whole(below)) return std::nullopt;
  // A leading 0 would have the text read as octal.
  const auto whole = [](std::string_view digits) {
    const std::size_t first = std::min(digits.find_first_not_of('0'), digits.size() - 1);
    return number::Integer(std::string(digits.substr(first)));
  };
  const number::Integer q = whole(below);
  if (q == 0) return std::nullopt;
  const Rational value(whole(above), q);
  return is_negative ? Rational(-value) : value;
}

model::Mapa read_map(json::Reader& in) {
  const std::size_t at = in.offset();
  const auto rows = in.three<Row>("mapa", "expected three rows", [&] { return read_row(in); });
  const auto column = [&](std::size_t i) { return model::ExactVector(rows[0][i], rows[1][i], rows[2][i]); };
  model::Mapa mapa{column(3), column(0), column(1), column(2)};
  const model::Judgement judged = model::inv(mapa).front();
  if (!judged.holds)
    in.fail(at, "mapa takes space to a plane, a line or a point",
            fmt::format("expected {} ({})", judged.what->predicate, judged.what->label), judged.what);
  return mapa;
}

void write_map(json::Writer& out, const model::Mapa& mapa) {
  const auto row = [&](auto coordinate) {
    out.begin_array();
    for (const model::ExactVector* column : {&mapa.x, &mapa.y, &mapa.z, &mapa.centro})
      write_entry(out, coordinate(*column));
    out.end_array();
  };
  out.begin_array();
  row([](const model::ExactVector& v) { return v.x; });
  row([](const model::ExactVector& v) { return v.y; });
  row([](const model::ExactVector& v) { return v.z; });
  out.end_array();
}

}  // namespace durero::io
