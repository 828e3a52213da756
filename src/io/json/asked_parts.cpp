#include "durero/io/json/asked_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "durero/model/tipos.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::array<std::string_view, 2> asked_ray_keys{"ray", "on"};

/// A line of a script; a line end is no part of a string of JSON, so that an object becomes one line.
std::string script_line(json::Reader& in, const Source& source) {
  if (in.kind() == json::TokenKind::object) {
    std::string line(object_text(in, source));
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return line;
  }
  const std::size_t at = in.offset();
  const std::string_view line = in.string("an operation");
  if (line.find_first_of("\n\r") != line.npos) in.fail(at, "an operation has a line end", "expected one line");
  return std::string(line);
}

scene::ElementRef asked_element(json::Reader& in, const scene::Scene& scene) {
  const std::size_t at = in.offset();
  const std::string_view name = in.string("an element");
  if (const auto element = scene.find(name)) return *element;
  in.fail(at, fmt::format("no element is called {}", text::shown(name)), "expected an element of the scene");
}

void require_direction(const json::Reader& in, std::size_t at, const glm::dvec3& v) {
  if (v == glm::dvec3(0)) in.fail(at, "the direction of a ray is 0", "expected another one", &model::Rayo_inv_1);
}

/// Six numbers.
scene::Query asked_ray(json::Reader& in) {
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
  require_direction(in, at, {vx, vy, vz});
  return {model::Rayo({px, py, pz}, {vx, vy, vz}), {}};
}

scene::Query asked_ray_from(json::Reader& in, const scene::Scene& scene) {
  std::optional<scene::Query> ray;
  scene::ElementSet on;
  in.object("a ray", asked_ray_keys, 1, [&](std::size_t key) {
    if (key == 0)
      ray = asked_ray(in);
    else
      on = read_json_elements(in, scene);
  });
  ray->en = std::move(on);
  return *std::move(ray);
}

}  // namespace

std::string_view object_text(json::Reader& in, const Source& source) {
  const std::size_t begin = in.offset();
  in.skip();
  const std::string_view behind = source.text().substr(begin, in.offset() - begin);
  return behind.substr(0, behind.rfind('}') + 1);
}

std::string read_json_script(json::Reader& in, const Source& source) {
  std::string script;
  in.array("operations", [&] { script.append(script_line(in, source)).append("\n"); });
  return script;
}

scene::ElementSet read_json_elements(json::Reader& in, const scene::Scene& scene) {
  scene::ElementSet elements;
  in.array("on", [&] { elements.push_back(asked_element(in, scene)); });
  std::ranges::sort(elements);
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  return elements;
}

glm::dvec3 read_json_direction(json::Reader& in) {
  const std::size_t at = in.offset();
  const glm::dvec3 v = in.vec3("v");
  require_direction(in, at, v);
  return v;
}

std::vector<scene::Query> read_json_rays(json::Reader& in, const scene::Scene& scene) {
  std::vector<scene::Query> rays;
  in.array("rays",
           [&] { rays.push_back(in.kind() == json::TokenKind::object ? asked_ray_from(in, scene) : asked_ray(in)); });
  return rays;
}

}  // namespace durero::io
