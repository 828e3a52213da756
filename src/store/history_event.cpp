#include "durero/store/history_event.hpp"

#include <charconv>
#include <chrono>
#include <optional>

namespace durero::store {
namespace {

std::string_view word_of(EventKind kind) {
  switch (kind) {
    case EventKind::import:
      return "import";
    case EventKind::edit:
      return "edit";
  }
  __builtin_unreachable();  // a kind is one of its enumerators
}

/// The number in decimal digits alone.
std::optional<int> digits_in(std::string_view text) {
  int value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + (c - '0');
  }
  return value;
}

}  // namespace

Digest hash_of(const HistoryEvent& event, const Digest& parent) {
  FieldDigest fields;
  fields.add(bytes_of(parent)).add(word_of(event.kind)).add(event.begins ? "begins" : "goes on");
  fields.add(std::to_string(event.line)).add(event.operation).add(event.answer);
  return fields.add(event.by.author).add(event.by.time).add(event.by.comment).add(event.content).digest();
}

bool is_time(std::string_view text) {
  constexpr std::string_view form = "0000-00-00T00:00:00Z";
  if (text.size() != form.size()) return false;
  for (std::size_t i = 0; i < form.size(); ++i)
    if (form[i] != '0' && text[i] != form[i]) return false;
  const auto year = digits_in(text.substr(0, 4)), month = digits_in(text.substr(5, 2)),
             day = digits_in(text.substr(8, 2)), hour = digits_in(text.substr(11, 2)),
             minute = digits_in(text.substr(14, 2)), second = digits_in(text.substr(17, 2));
  if (!year || !month || !day || !hour || !minute || !second) return false;
  using namespace std::chrono;
  const year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                            std::chrono::day(static_cast<unsigned>(*day))};
  return date.ok() && *hour < 24 && *minute < 60 && *second < 60;
}

}  // namespace durero::store
