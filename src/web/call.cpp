#include "durero/web/call.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <exception>
#include <new>

#include "calls.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "json_text.hpp"

namespace durero::web {
namespace {

std::string answer_version(const AskedCall& asked);

/// A call by its name.
struct CallRow {
  std::string_view name;
  std::string (*answer)(const AskedCall& asked);
};

constexpr std::array<CallRow, 16> call_rows{{{"version", answer_version},
                                             {"text", answer_text},
                                             {"labels", answer_labels},
                                             {"errata", answer_errata},
                                             {"operations", answer_operations},
                                             {"check", answer_check},
                                             {"edit", answer_edit},
                                             {"trace", answer_trace},
                                             {"ray", answer_ray},
                                             {"light", answer_light},
                                             {"eval", answer_eval},
                                             {"zed.check", answer_zed_check},
                                             {"zed.run", answer_zed_run},
                                             {"zed.graph", answer_zed_graph},
                                             {"surface", answer_surface},
                                             {"render_shader", answer_render_shader}}};

std::string answer_version(const AskedCall& asked) {
  asked.require({}, 0);
  return ObjectText()
      .member("durero", DURERO_VERSION)
      .raw("calls", array_of(call_rows, [](const CallRow& row) { return json_of(row.name); }))
      .text();
}

std::string answer_of(std::string_view request) {
  const AskedCall asked(request);
  const auto row = std::ranges::find(call_rows, asked.call(), &CallRow::name);
  if (row != call_rows.end()) return row->answer(asked);
  std::vector<std::string> names;
  for (const CallRow& each : call_rows) names.emplace_back(each.name);
  asked.refuse_call("expected " +
                    text::nearest(asked.call(), names).value_or(fmt::format("{}", fmt::join(names, ", "))));
}

/// An error at a place of the source of that name.
std::string error_answer(std::string_view name, io::TextPosition place, std::string_view message) {
  return ObjectText()
      .member("error", fmt::format("{}:{}:{}: {}", name, place.line, place.column, message))
      .member("source", name)
      .member("line", std::uint64_t{place.line})
      .member("column", std::uint64_t{place.column})
      .text();
}

std::string error_answer(const io::InputError& error) {
  const std::string_view what = error.what(), message = error.message();
  const std::size_t place = fmt::formatted_size(":{}:{}: ", error.place().line, error.place().column);
  return error_answer(what.substr(0, what.size() - message.size() - place), error.place(), message);
}

}  // namespace

std::string call(std::string_view request) noexcept {
  try {
    return answer_of(request);
  } catch (const io::InputError& error) {
    return error_answer(error);
  } catch (const std::bad_alloc&) {
    return error_answer("call", {1, 1}, "memory did not do; expected a smaller question");
  } catch (const std::exception& error) {
    return error_answer("call", {1, 1}, text::escaped(error.what()));
  }
}

}  // namespace durero::web
