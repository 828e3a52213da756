#include "durero/io/rays/rays_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "durero/io/file_name.hpp"
#include "durero/io/lines.hpp"
#include "durero/io/number_text.hpp"
#include "durero/text/shown.hpp"
#include "io/cursor.hpp"

namespace durero::io {
namespace {

constexpr std::size_t numbers_in_ray = 6;

model::Rayo make_ray(const double* n) { return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}}; }

bool is_null(const double* v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

const std::string null_expected = fmt::format("expected {} ({})", model::Rayo_inv_1.predicate, model::Rayo_inv_1.label);

double read_value(WordCursor& in, std::size_t count) {
  if (in.done())
    in.fail(in.offset(), fmt::format("the ray ends after {} numbers", count), "expected px py pz vx vy vz");
  const double value = in.number("#", "a ray");
  in.skip_blanks();
  return value;
}

scene::ElementRef read_element(WordCursor& in, const scene::Scene& scene) {
  const std::size_t at = in.offset();
  const std::string_view word = in.word("#");
  if (!word.starts_with('@')) in.fail(at, fmt::format("{} after six numbers", text::shown(word)), "expected @name");
  const std::string_view name = word.substr(1);
  const auto element = scene.find(name);
  if (!element) in.fail(at, fmt::format("no element {}", text::shown(name)), "expected an element of the scene");
  in.skip_blanks();
  return *element;
}

Ray read_ray(WordCursor& in, const scene::Scene& scene) {
  double n[numbers_in_ray];
  std::size_t v_offset = 0;
  for (std::size_t i = 0; i < numbers_in_ray; ++i) {
    if (i == 3) v_offset = in.offset();
    n[i] = read_value(in, i);
  }
  if (is_null(n + 3)) in.fail(v_offset, "v is (0, 0, 0)", null_expected, &model::Rayo_inv_1);
  Ray ray{make_ray(n)};
  while (!in.done()) ray.en.push_back(read_element(in, scene));
  std::ranges::sort(ray.en);
  const auto repeated = std::ranges::unique(ray.en);
  ray.en.erase(repeated.begin(), repeated.end());
  return ray;
}

// The ray of six numbers, which stand in that row, from 1.
Ray row_ray(const std::string& name, const double* n, std::size_t row) {
  const double* wrong = std::find_if_not(n, n + numbers_in_ray, [](double x) { return std::isfinite(x); });
  if (wrong != n + numbers_in_ray) {
    const TextPosition place{row, static_cast<std::size_t>(wrong - n) + 1};
    throw InputError(name, place, number_text(*wrong), "expected a finite number");
  }
  if (is_null(n + 3)) throw InputError(name, {row, 4}, "v is (0, 0, 0)", null_expected, &model::Rayo_inv_1);
  return {make_ray(n)};
}

// How many of the bytes that wait are whole lines; at the end all are, and so is a line that is too long already, which
// its WordCursor refuses.
std::size_t whole_lines(Input& input) {
  std::size_t searched = 0;
  for (;;) {
    const std::size_t last = input.waiting().substr(searched).find_last_of("\r\n");
    if (last != std::string_view::npos) return searched + last + 1;
    searched = input.waiting().size();
    if (searched > longest_line || !input.read()) return searched;
  }
}

}  // namespace

RayReader::RayReader(Input& input, const scene::Scene& scene) : input_(input), scene_(scene) {
  if (is_npy(input) || ends_in(input.name(), ".npy")) table_.emplace(input, numbers_in_ray);
}

bool RayReader::next(std::vector<Ray>& rays) {
  rays.clear();
  if (wrong_) std::rethrow_exception(std::exchange(wrong_, nullptr));
  try {
    return table_ ? next_rows(rays) : next_lines(rays);
  } catch (const InputError&) {
    if (rays.empty()) throw;
    wrong_ = std::current_exception();
    return true;
  }
}

bool RayReader::next_lines(std::vector<Ray>& rays) {
  if (input_.waiting().empty() && !input_.read()) return false;
  if (std::exchange(is_after_return_, false) && input_.waiting().front() == '\n') {
    input_.take(1);
    return true;
  }
  const std::size_t size = whole_lines(input_);
  const Source text(input_.name(), std::string(input_.waiting().substr(0, size)), done_);
  input_.take(size);
  is_after_return_ = text.text().back() == '\r';
  Lines lines(text.text());
  while (const auto line = lines.next()) {
    ++done_;
    WordCursor in(text, *line);
    if (!in.done()) rays.push_back(read_ray(in, scene_));
  }
  return true;
}

bool RayReader::next_rows(std::vector<Ray>& rays) {
  if (!table_->next(numbers_)) return false;
  rays.reserve(numbers_.size() / numbers_in_ray);
  for (std::size_t first = 0; first < numbers_.size(); first += numbers_in_ray)
    rays.push_back(row_ray(input_.name(), numbers_.data() + first, ++done_));
  return true;
}

std::vector<Ray> read_rays(const Source& source, const scene::Scene& scene) {
  Input input(source);
  RayReader reader(input, scene);
  std::vector<Ray> all, rays;
  while (reader.next(rays)) std::ranges::move(rays, std::back_inserter(all));
  return all;
}

bool begins_as_rays(const Source& source) {
  if (is_npy(source.text())) return true;
  Lines lines(source.text());
  while (const auto line = lines.next()) {
    WordCursor in(source, *line);
    if (!in.done()) return read_finite(in.word("#")).has_value();
  }
  return false;
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
