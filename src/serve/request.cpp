#include "request.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "durero/io/json/json.hpp"
#include "durero/model/tipos.hpp"
#include "durero/store/provenance.hpp"
#include "durero/text/shown.hpp"

namespace durero::serve {
namespace {

constexpr std::array<std::string_view, 4> edit_keys{"operations", "all_or_nothing", "comment", "author"};
constexpr std::array<std::string_view, 1> rays_keys{"rays"};
constexpr std::array<std::string_view, 2> ray_keys{"ray", "on"};

/// The text of the object that stands here, on one line: a line end is no part of a string of JSON.
std::string object_line(io::json::Reader& in, const io::Source& source) {
  const std::size_t begin = in.offset();
  in.skip();
  const std::string_view behind = std::string_view(source.text()).substr(begin, in.offset() - begin);
  std::string line(behind.substr(0, behind.rfind('}') + 1));
  std::ranges::replace_if(
      line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return line;
}

/// A line of a script.
std::string operation_line(io::json::Reader& in, const io::Source& source) {
  if (in.kind() == io::json::TokenKind::object) return object_line(in, source);
  const std::size_t at = in.offset();
  const std::string_view line = in.string("an operation");
  if (line.find_first_of("\n\r") != line.npos) in.fail(at, "an operation has a line end", "expected one line");
  return std::string(line);
}

/// A text without a line end, as events keep it.
std::string one_line(io::json::Reader& in, std::string_view what) {
  const std::size_t at = in.offset();
  const std::string_view line = in.string(what);
  if (std::ranges::any_of(line, [](char c) { return static_cast<unsigned char>(c) < 0x20; }))
    in.fail(at, fmt::format("{} has a line end or another control character", what), "expected one line");
  return std::string(line);
}

scene::ElementRef element_of(io::json::Reader& in, const scene::Scene& scene) {
  const std::size_t at = in.offset();
  const std::string_view name = in.string("an element");
  if (const auto element = scene.find(name)) return *element;
  in.fail(at, fmt::format("no element is called {}", text::shown(name)), "expected an element of the scene");
}

/// Six numbers.
scene::Query ray_of(io::json::Reader& in) {
  const std::size_t at = in.offset();
  std::array<double, 6> numbers{};
  std::size_t count = 0;
  in.array("a ray", [&] {
    const double number = in.number("a number of a ray");
    if (count < numbers.size()) numbers[count] = number;
    ++count;
  });
  const auto [px, py, pz, vx, vy, vz] = numbers;
  if (count != numbers.size()) in.fail(at, fmt::format("a ray has {} numbers", count), "expected six");
  if (vx == 0 && vy == 0 && vz == 0)
    in.fail(at, "the direction of a ray is 0", "expected another one", &model::Rayo_inv_1);
  return {model::Rayo({px, py, pz}, {vx, vy, vz}), {}};
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
        in.array("operations", [&] { asked.operations.append(operation_line(in, source)).append("\n"); });
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
  const auto with_origin = [&] {
    std::optional<scene::Query> ray;
    scene::ElementSet on;
    in.object("a ray", ray_keys, 1, [&](std::size_t key) {
      if (key == 0)
        ray = ray_of(in);
      else
        in.array("on", [&] { on.push_back(element_of(in, scene)); });
    });
    std::ranges::sort(on);
    on.erase(std::unique(on.begin(), on.end()), on.end());
    ray->en = std::move(on);
    rays.push_back(*std::move(ray));
  };
  in.object("a question", rays_keys, 1, [&](std::size_t) {
    in.array("rays", [&] {
      if (in.kind() == io::json::TokenKind::object)
        with_origin();
      else
        rays.push_back(ray_of(in));
    });
  });
  return rays;
}

}  // namespace durero::serve
