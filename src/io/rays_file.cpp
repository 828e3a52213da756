#include "durero/io/rays_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "durero/io/npy.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"

namespace durero::io {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";
constexpr std::size_t numbers_in_ray = 6;

model::Rayo make_ray(const double* n) { return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}}; }

bool is_null(const double* v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

const std::string null_expected = fmt::format("expected {} ({})", model::Rayo_inv_1.predicate, model::Rayo_inv_1.label);

// The words of one line, up to a comment.
class Line {
 public:
  Line(std::string_view text, std::size_t begin, std::size_t end) : text_(text.substr(0, end)), next_(begin) { skip(); }
  bool done() const { return next_ == text_.size() || text_[next_] == '#'; }
  std::size_t offset() const { return next_; }
  std::string_view word() {
    const std::size_t from = next_;
    const std::size_t end = std::min(text_.find_first_of(" \t\r\v\f#", from), text_.size());
    next_ = end;
    skip();
    return text_.substr(from, end - from);
  }

 private:
  void skip() { next_ = std::min(text_.find_first_not_of(blanks, next_), text_.size()); }
  std::string_view text_;
  std::size_t next_;
};

double read_value(const Source& source, Line& line, std::size_t count) {
  if (line.done()) {
    source.fail(line.offset(), fmt::format("the ray ends after {} numbers", count), "expected px py pz vx vy vz");
  }
  const std::size_t at = line.offset();
  const std::string_view word = line.word();
  const auto value = read_number(word);
  if (!value || !std::isfinite(*value)) source.fail(at, text::shown(word), "expected a finite number");
  return *value;
}

scene::ElementRef read_element(const Source& source, Line& line, const scene::Scene& scene) {
  const std::size_t at = line.offset();
  const std::string_view word = line.word();
  if (!word.starts_with('@')) source.fail(at, fmt::format("{} after six numbers", text::shown(word)), "expected @name");
  const auto element = scene.find(word.substr(1));
  if (!element)
    source.fail(at, fmt::format("no element {}", text::shown(word.substr(1))), "expected an element of the scene");
  return *element;
}

Ray read_ray(const Source& source, Line& line, const scene::Scene& scene) {
  double n[numbers_in_ray];
  std::size_t v_offset = 0;
  for (std::size_t i = 0; i < numbers_in_ray; ++i) {
    if (i == 3) v_offset = line.offset();
    n[i] = read_value(source, line, i);
  }
  if (is_null(n + 3)) source.fail(v_offset, "v is (0, 0, 0)", null_expected);
  Ray ray{make_ray(n)};
  while (!line.done()) ray.en.push_back(read_element(source, line, scene));
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
  const std::string_view text = source.text();
  std::vector<Ray> rays;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    Line line(text, begin, end);
    if (!line.done()) rays.push_back(read_ray(source, line, scene));
    begin = end + 1;
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
