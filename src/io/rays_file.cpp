#include "durero/io/rays_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cursor.hpp"
#include "durero/io/npy.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::size_t numbers_in_ray = 6;

model::Rayo make_ray(const double* n) { return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}}; }

bool is_null(const double* v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

const std::string null_expected = fmt::format("expected {} ({})", model::Rayo_inv_1.predicate, model::Rayo_inv_1.label);

double read_value(Cursor& in, std::size_t count) {
  if (in.done())
    in.fail(in.offset(), fmt::format("the ray ends after {} numbers", count), "expected px py pz vx vy vz");
  const double value = in.number("#", "a ray");
  in.skip_blanks();
  return value;
}

scene::ElementRef read_element(Cursor& in, const scene::Scene& scene) {
  const std::size_t at = in.offset();
  const std::string_view word = in.word("#");
  if (!word.starts_with('@')) in.fail(at, fmt::format("{} after six numbers", text::shown(word)), "expected @name");
  const std::string_view name = word.substr(1);
  const auto element = scene.find(name);
  if (!element) in.fail(at, fmt::format("no element {}", text::shown(name)), "expected an element of the scene");
  in.skip_blanks();
  return *element;
}

Ray read_ray(Cursor& in, const scene::Scene& scene) {
  double n[numbers_in_ray];
  std::size_t v_offset = 0;
  for (std::size_t i = 0; i < numbers_in_ray; ++i) {
    if (i == 3) v_offset = in.offset();
    n[i] = read_value(in, i);
  }
  if (is_null(n + 3)) in.fail(v_offset, "v is (0, 0, 0)", null_expected);
  Ray ray{make_ray(n)};
  while (!in.done()) ray.en.push_back(read_element(in, scene));
  std::ranges::sort(ray.en);
  const auto repeated = std::ranges::unique(ray.en);
  ray.en.erase(repeated.begin(), repeated.end());
  return ray;
}

std::vector<Ray> read_rays_npy(const Source& source) {
  const std::vector<double> values = read_npy(source, numbers_in_ray);
  std::vector<Ray> rays;
  rays.reserve(values.size() / numbers_in_ray);
  for (std::size_t first = 0; first < values.size(); first += numbers_in_ray) {
    const double* n = values.data() + first;
    const std::size_t row = first / numbers_in_ray + 1;
    const double* wrong = std::find_if_not(n, n + numbers_in_ray, [](double x) { return std::isfinite(x); });
    if (wrong != n + numbers_in_ray) {
      const Place place{row, static_cast<std::size_t>(wrong - n) + 1};
      throw InputError(source.name(), place, number_text(*wrong), "expected a finite number");
    }
    if (is_null(n + 3)) throw InputError(source.name(), {row, 4}, "v is (0, 0, 0)", null_expected);
    rays.push_back({make_ray(n)});
  }
  return rays;
}

}  // namespace

std::vector<Ray> read_rays(const Source& source, const scene::Scene& scene) {
  if (is_npy(source.text()) || source.name().ends_with(".npy")) return read_rays_npy(source);
  std::vector<Ray> rays;
  Lines lines(source.text());
  while (const auto line = lines.next()) {
    Cursor in(source, *line);
    if (!in.done()) rays.push_back(read_ray(in, scene));
  }
  return rays;
}

std::string rays_text(std::span<const Ray> rays, const scene::Scene& scene) {
  std::string out;
  for (const Ray& ray : rays) {
    const auto& p = ray.rayo.p();
    const auto& v = ray.rayo.v();
    fmt::format_to(std::back_inserter(out), "{} {} {} {} {} {}", p.x(), p.y(), p.z(), v.x(), v.y(), v.z());
    for (const scene::ElementRef element : ray.en) out.append(" @").append(scene.name(element).name());
    out += '\n';
  }
  return out;
}

std::string rays_npy(std::span<const Ray> rays) {
  std::string out = npy_head("'<f8'", fmt::format("({}, 6)", rays.size()));
  for (const Ray& ray : rays) {
    const auto& p = ray.rayo.p();
    const auto& v = ray.rayo.v();
    for (const double x : {p.x(), p.y(), p.z(), v.x(), v.y(), v.z()}) append_binary64(out, x);
  }
  return out;
}

}  // namespace durero::io
