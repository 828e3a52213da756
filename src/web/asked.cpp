#include "asked.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "durero/io/json/asked_parts.hpp"
#include "durero/io/json/whole_number.hpp"
#include "durero/text/shown.hpp"

namespace durero::web {

AskedCall::AskedCall(std::string_view request) : source_("call", std::string(request)), document_(source_) {
  io::json::Reader in(document_);
  const std::size_t begin = in.offset();
  in.members("a call", [&](const io::json::Key& key) {
    if (!members_.emplace(key.name, Member{key.offset, in}).second)
      in.fail(key.offset, fmt::format("the key {} stands twice", text::shown(key.name)), "expected it once");
    in.skip();
  });
  if (!has("call")) in.fail(begin, "a call has no call", "expected the name of what is asked");
  io::json::Reader name = at("call");
  call_offset_ = name.offset();
  call_ = name.string("call");
}

void AskedCall::refuse_call(const std::string& expected) const {
  source_.fail(call_offset_, fmt::format("nothing answers the call {}", text::shown(call_)), expected);
}

void AskedCall::require(std::span<const std::string_view> keys, std::size_t required) const {
  for (const auto& [key, member] : members_) {
    if (key == "call" || std::ranges::find(keys, key) != keys.end()) continue;
    const std::string of_call = fmt::format("the call {}", call_);
    source_.fail(member.key, fmt::format("{} has no key {}", of_call, text::shown(key)),
                 keys.empty() ? "expected none beside call" : fmt::format("expected {}", fmt::join(keys, ", ")));
  }
  for (const std::string_view key : keys.first(required))
    if (!has(key)) source_.fail(call_offset_, fmt::format("the call {} lacks {}", call_, key), "expected it");
}

std::string AskedCall::text(std::string_view key, std::string_view otherwise) const {
  return has(key) ? std::string(at(key).string(key)) : std::string(otherwise);
}

bool AskedCall::flag(std::string_view key, bool otherwise) const { return has(key) ? at(key).boolean(key) : otherwise; }

std::uint64_t AskedCall::whole(std::string_view key, std::uint64_t least, std::uint64_t most,
                               std::uint64_t otherwise) const {
  if (!has(key)) return otherwise;
  io::json::Reader in = at(key);
  return static_cast<std::uint64_t>(io::json::whole_number(in, key, static_cast<std::int64_t>(least),
                                                           static_cast<std::int64_t>(most),
                                                           fmt::format("{} to {}", least, most)));
}

std::vector<std::string> AskedCall::texts(std::string_view key) const {
  std::vector<std::string> texts;
  if (!has(key)) return texts;
  io::json::Reader in = at(key);
  in.array(key, [&] { texts.emplace_back(in.string(key)); });
  return texts;
}

io::Source AskedCall::part(std::string_view key) const {
  io::json::Reader in = at(key);
  const bool is_object = in.kind() == io::json::TokenKind::object;
  return {std::string(key), std::string(is_object ? io::object_text(in, source_) : in.string(key))};
}

}  // namespace durero::web
