#include "durero/io/hits_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "durero/io/json.hpp"
#include "durero/io/npy.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

using model::Resultado;

constexpr std::string_view outcome_dtype = "S10";
constexpr std::size_t outcome_width = 10;  // of the longest, no_minimum

std::vector<std::string_view> names(const scene::Hit& hit, const scene::Scene& scene) {
  std::vector<std::string_view> all;
  for (const scene::ElementRef element : hit.elementos) all.push_back(scene.name(element).name());
  std::ranges::sort(all);
  return all;
}

void append_value(std::string& out, double value) {
  const bool finite = std::isfinite(value);  // JSON has no infinity
  if (!finite) out += '"';
  append_number(out, value);
  if (!finite) out += '"';
}

std::string joined_names(const scene::Hit& hit, const scene::Scene& scene) {
  std::string all;
  for (const std::string_view name : names(hit, scene)) all.append(all.empty() ? "" : ",").append(name);
  return all;
}

void append_padded(std::string& out, std::string_view text, std::size_t width) {
  out.append(text).append(width - text.size(), '\0');
}

// A number, or the string of an infinity.
double read_value(json::Reader& in, std::string_view what) {
  if (in.kind() != json::Kind::string) return in.number(what);
  const std::size_t at = in.offset();
  const std::string_view text = in.string(what);
  if (text != "inf" && text != "-inf")
    in.fail(at, fmt::format("{} is {}", what, text::shown(text)), "expected a number, \"inf\" or \"-inf\"");
  return text == "inf" ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
}

std::size_t read_index(json::Reader& in) {
  constexpr double most = 0x1p53;  // whole numbers up to here are binary64
  const std::size_t at = in.offset();
  const double value = in.number("ray");
  if (value < 0 || value > most || std::trunc(value) != value) {
    in.fail(at, fmt::format("ray is {}", value), "expected the number of a ray, from 0");
  }
  return static_cast<std::size_t>(value);
}

Resultado read_outcome(json::Reader& in) {
  const std::size_t at = in.offset();
  const std::string_view text = in.string("outcome");
  for (const Resultado outcome : {Resultado::hit, Resultado::miss, Resultado::no_minimum}) {
    if (text == model::name(outcome)) return outcome;
  }
  in.fail(at, fmt::format("outcome is {}", text::shown(text)), "expected hit, miss or no_minimum");
}

void read_elements(json::Reader& in, const scene::Scene& scene, scene::ElementSet& all) {
  in.array("elementos", [&] {
    const std::size_t at = in.offset();
    const std::string_view name = in.string("an element");
    const auto element = scene.find(name);
    if (!element) in.fail(at, fmt::format("no element {}", text::shown(name)), "expected an element of the scene");
    if (std::ranges::find(all, *element) != all.end()) {
      in.fail(at, fmt::format("element {} stands twice", text::shown(name)), "expected it once");
    }
    all.push_back(*element);
  });
  std::ranges::sort(all);
}

glm::dvec3 read_point(json::Reader& in) {
  const std::size_t at = in.offset();
  glm::dvec3 point{};
  glm::dvec3::length_type count = 0;
  in.array("point", [&] {
    if (count == 3) in.fail(in.offset(), "point has a fourth item", "expected three numbers");
    point[count++] = read_value(in, "point");
  });
  if (count != 3) in.fail(at, fmt::format("point has {} items", count), "expected three numbers");
  return point;
}

void read_hit(const json::Document& document, std::size_t at, const scene::Scene& scene, RayHit& read) {
  constexpr std::string_view keys[] = {"ray", "outcome", "elementos", "t", "point"};
  json::Reader in(document);
  bool has_t = false, has_point = false;
  in.object("a hit", keys, 3, [&](std::size_t key) {
    switch (key) {
      case 0:
        read.offset = in.offset();
        read.ray = read_index(in);
        break;
      case 1:
        read.hit.resultado = read_outcome(in);
        break;
      case 2:
        read_elements(in, scene, read.hit.elementos);
        break;
      case 3:
        read.hit.t = read_value(in, "t");
        has_t = true;
        break;
      default:
        read.hit.punto = read_point(in);
        has_point = true;
    }
  });
  const bool is_hit = read.hit.resultado == Resultado::hit;
  if (has_t != is_hit || has_point != is_hit) {
    in.fail(at, fmt::format("outcome {} {} t and point", model::name(read.hit.resultado), is_hit ? "without" : "with"),
            "expected both where it is hit, and neither otherwise");
  }
  if (read.hit.elementos.empty() != (read.hit.resultado == Resultado::miss)) {
    in.fail(at, fmt::format("outcome {} with {} elements", model::name(read.hit.resultado), read.hit.elementos.size()),
            "expected none where it is miss, and some otherwise");
  }
}

}  // namespace

std::string hit_text(std::size_t ray, const scene::Hit& hit, const scene::Scene& scene) {
  std::string out = fmt::format("{{\"ray\":{},\"outcome\":\"{}\",\"elementos\":[", ray, model::name(hit.resultado));
  std::string_view separator;
  for (const std::string_view name : names(hit, scene)) {
    out.append(separator).append("\"").append(name).append("\"");
    separator = ",";
  }
  out += ']';
  if (hit.resultado == Resultado::hit) {
    out += ",\"t\":";
    append_value(out, hit.t);
    separator = ",\"point\":[";
    for (const double x : {hit.punto.x, hit.punto.y, hit.punto.z}) {
      out += separator;
      append_value(out, x);
      separator = ",";
    }
    out += ']';
  }
  return out + "}";
}

std::string hits_npy(std::span<const scene::Hit> hits, const scene::Scene& scene) {
  std::size_t width = 1;  // NumPy's shortest
  for (const scene::Hit& hit : hits) width = std::max(width, joined_names(hit, scene).size());
  std::string out =
      npy_head(fmt::format("[('outcome', '{}'), ('t', '<f8'), ('point', '<f8', (3,)), ('elementos', 'S{}')]",
                           outcome_dtype, width),
               fmt::format("({},)", hits.size()));
  for (const scene::Hit& hit : hits) {
    append_padded(out, model::name(hit.resultado), outcome_width);
    const bool is_hit = hit.resultado == Resultado::hit;
    for (const double x : {hit.t, hit.punto.x, hit.punto.y, hit.punto.z}) {
      append_binary64(out, is_hit ? x : std::numeric_limits<double>::quiet_NaN());
    }
    append_padded(out, joined_names(hit, scene), width);
  }
  return out;
}

std::vector<RayHit> read_hits(const Source& source, const scene::Scene& scene) {
  const std::string_view text = source.text();
  std::vector<RayHit> hits;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.find_first_not_of(" \t\r") != line.npos) {
      const json::Document document(source, begin, end);
      read_hit(document, begin, scene, hits.emplace_back());
    }
    begin = end + 1;
  }
  return hits;
}

std::vector<std::optional<scene::Hit>> read_hits_of_rays(const Source& source, const scene::Scene& scene,
                                                         std::size_t rays) {
  std::vector<std::optional<scene::Hit>> hits(rays);
  for (RayHit& read : read_hits(source, scene)) {
    if (read.ray >= rays) {
      source.fail(read.offset, fmt::format("ray {} of {}", read.ray, rays), "expected a ray of the ray file, from 0");
    }
    if (hits[read.ray])
      source.fail(read.offset, fmt::format("ray {} has a hit already", read.ray), "expected one a ray");
    hits[read.ray] = std::move(read.hit);
  }
  return hits;
}

}  // namespace durero::io
