#include "request.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "durero/io/json/asked_parts.hpp"
#include "durero/io/json/json.hpp"
#include "durero/store/provenance.hpp"

namespace durero::serve {
namespace {

constexpr std::array<std::string_view, 4> edit_keys{"operations", "all_or_nothing", "comment", "author"};
constexpr std::array<std::string_view, 1> rays_keys{"rays"};

/// A text without a line end, as events keep it.
std::string one_line(io::json::Reader& in, std::string_view what) {
  const std::size_t at = in.offset();
  const std::string_view line = in.string(what);
  if (std::ranges::any_of(line, [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
    in.fail(at, fmt::format("{} has a line end or another control character", what), "expected one line");
  return std::string(line);
}

}  // namespace

AskedEdit read_edit(std::string_view body, const std::string& author) {
  const io::Source source("body", std::string(body));
  const io::json::Document document(source);
  io::json::Reader in(document);
  AskedEdit asked;
  asked.by = {author, store::time_now(), ""};
  in.object("an edit", edit_keys, 1, [&](std::size_t key) {
    switch (key) {
      case 0:
        asked.operations = io::read_json_script(in, source);
        return;
      case 1:
        asked.all_or_nothing = in.boolean("all_or_nothing");
        return;
      case 2:
        asked.by.comment = one_line(in, "comment");
        return;
      case 3:
        asked.by.author = one_line(in, "author");
        return;
    }
  });
  return asked;
}

std::vector<scene::Query> read_rays(std::string_view body, const scene::Scene& scene) {
  const io::Source source("body", std::string(body));
  const io::json::Document document(source);
  io::json::Reader in(document);
  std::vector<scene::Query> rays;
  in.object("a question", rays_keys, 1, [&](std::size_t) { rays = io::read_json_rays(in, scene); });
  return rays;
}

}  // namespace durero::serve
