#include "durero/io/rays/hits_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "durero/io/file_name.hpp"
#include "durero/io/json/json.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/whole_number.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/rays/npy.hpp"
#include "durero/text/shown.hpp"
#include "io/rays/hit_line.hpp"

namespace durero::io {
namespace {

using model::Resultado;

constexpr std::string_view outcome_dtype = "S10";
constexpr std::size_t outcome_width = 10;  // of the longest, no_minimum
constexpr std::size_t values_width = outcome_width + std::size_t{4} * 8;
constexpr std::size_t least_width = 1;  // NumPy's, of the names

std::string joined_names(const scene::Hit& hit, const scene::Scene& scene) {
  std::string all;
  for (const std::string& name : names_of_hit(hit, scene)) all.append(all.empty() ? "" : ",").append(name);
  return all;
}

void append_padded(std::string& out, std::string_view text, std::size_t width) {
  out.append(text).append(width - text.size(), '\0');
}

// What stands before the rows of a .npy file.
std::string head(std::size_t rays, std::size_t width) {
  return npy_head(fmt::format("[('outcome', '{}'), ('t', '<f8'), ('point', '<f8', (3,)), ('elementos', 'S{}')]",
                              outcome_dtype, width),
                  fmt::format("({},)", rays));
}

// What stands in a row before the names.
void append_values(std::string& out, const scene::Hit& hit) {
  append_padded(out, model::name(hit.resultado), outcome_width);
  const bool is_hit = hit.resultado == Resultado::hit;
  for (const double x : {hit.t, hit.punto.x, hit.punto.y, hit.punto.z})
    append_binary64(out, is_hit ? x : std::numeric_limits<double>::quiet_NaN());
}

// A rounded value, which may be infinite.
double read_value(json::Reader& in, std::string_view what) {
  const std::size_t at = in.offset();
  const double value = in.extended_number(what);
  if (std::isnan(value)) in.fail(at, fmt::format("{} is \"nan\"", what), "expected a number, \"inf\" or \"-inf\"");
  return value;
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

enum class HitKey : std::size_t { ray, outcome, elementos, t, point };
constexpr std::string_view hit_keys[] = {"ray", "outcome", "elementos", "t", "point"};
constexpr std::size_t required_hit_keys = 3;

struct GivenKeys {
  bool t = false, point = false;
};

void read_part(json::Reader& in, HitKey key, const scene::Scene& scene, RayHit& read, GivenKeys& seen) {
  using enum HitKey;
  switch (key) {
    case HitKey::ray:
      read.offset = in.offset();
      read.ray =
          static_cast<std::size_t>(json::whole_number(in, "ray", 0, json::most_whole, "the number of a ray, from 0"));
      return;
    case HitKey::outcome:
      read.hit.resultado = read_outcome(in);
      return;
    case HitKey::elementos:
      return read_elements(in, scene, read.hit.elementos);
    case HitKey::t:
      seen.t = true;
      read.hit.t = read_value(in, "t");
      return;
    case HitKey::point:
      seen.point = true;
      read.hit.punto = in.triple("point", [&] { return read_value(in, "point"); });
  }
}

void read_hit(const json::Document& document, std::size_t at, const scene::Scene& scene, RayHit& read) {
  json::Reader in(document);
  GivenKeys seen;
  in.object("a hit", hit_keys, required_hit_keys,
            [&](std::size_t key) { read_part(in, static_cast<HitKey>(key), scene, read, seen); });
  const bool is_hit = read.hit.resultado == Resultado::hit;
  if (seen.t != is_hit || seen.point != is_hit) {
    in.fail(at, fmt::format("outcome {} {} t and point", model::name(read.hit.resultado), is_hit ? "without" : "with"),
            "expected both where it is hit, and neither otherwise");
  }
  if (read.hit.elementos.empty() != (read.hit.resultado == Resultado::miss)) {
    in.fail(at, fmt::format("outcome {} with {} elements", model::name(read.hit.resultado), read.hit.elementos.size()),
            "expected none where it is miss, and some otherwise");
  }
}

/// The name, which says no other format than one of those that hits are written in.
const std::string& with_ending(const std::string& path) {
  static constexpr std::array<std::string_view, 5> endings{".jsonl", ".ndjson", ".json", ".txt", ".npy"};
  require_ending(path, endings, "hits");
  return path;
}

}  // namespace

std::string hits_npy(std::span<const scene::Hit> hits, const scene::Scene& scene) {
  std::size_t width = least_width;
  for (const scene::Hit& hit : hits) width = std::max(width, joined_names(hit, scene).size());
  std::string out = head(hits.size(), width);
  for (const scene::Hit& hit : hits) {
    append_values(out, hit);
    append_padded(out, joined_names(hit, scene), width);
  }
  return out;
}

HitWriter::HitWriter(const std::string& path) : out_(with_ending(path)), width_(least_width) {
  if (ends_in(path, ".npy")) rows_.emplace(path);
}

void HitWriter::write(std::span<const scene::Hit> hits, const scene::Scene& scene) {
  std::string text;
  for (const scene::Hit& hit : hits) {
    if (rows_) {
      const std::string elements = joined_names(hit, scene);
      width_ = std::max(width_, elements.size());
      append_values(text, hit);
      text.append(elements) += '\0';  // which no name has
    } else {
      append_text(text, rays_, hit, scene);
      text += '\n';
    }
    ++rays_;
  }
  if (rows_) {
    rows_->write(text);
  } else {
    out_.write(text);
  }
}

void HitWriter::commit() {
  if (rows_) write_rows();
  out_.commit();
}

void HitWriter::write_rows() {
  constexpr std::size_t block = std::size_t{1} << 20U;
  Input rows = rows_->read();
  std::string text = head(rays_, width_);
  for (std::size_t ray = 0; ray < rays_; ++ray) {
    while (rows.waiting().find('\0', values_width) == std::string_view::npos && rows.read()) {
    }
    const std::size_t end = rows.waiting().find('\0', values_width);
    append_padded(text, rows.waiting().substr(0, end), values_width + width_);
    rows.take(end + 1);
    if (text.size() < block) continue;
    out_.write(text);
    text.clear();
  }
  out_.write(text);
}

std::vector<RayHit> read_hits(const Source& source, const scene::Scene& scene) {
  std::vector<RayHit> hits;
  Lines lines(source.text());
  while (const auto line = lines.next()) {
    if (source.text().substr(line->begin, line->end - line->begin).find_first_not_of(" \t") == std::string_view::npos) {
      continue;
    }
    const json::Document document(source, line->begin, line->end);
    read_hit(document, line->begin, scene, hits.emplace_back());
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
