#include "durero/accel/volume/choice.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <vector>

namespace durero::accel {
namespace {

using std::numbers::pi;

constexpr std::size_t line_count = 1024;
/// The set of lines that meet a volume.
using Met = std::bitset<line_count>;

/// A line through the ball of radius 1 about 0, and the point on it that is nearest to 0.
struct Chord {
  glm::dvec3 along, aside;
};

/// Isotropic lines. Four coordinates that fill the cube evenly (the multiples of the powers of the root of x⁵ = x + 1)
/// give the direction, and the place across it.
std::array<Chord, line_count> isotropic_lines() {
  constexpr double root = 1.1673039782614187;
  std::array<Chord, line_count> lines;
  for (std::size_t i = 0; i < line_count; ++i) {
    const auto coordinate = [&](int power) { return std::fmod(0.5 + double(i) / std::pow(root, power), 1); };
    const double z = 1 - 2 * coordinate(1), around_z = 2 * pi * coordinate(2), flat = std::sqrt(1 - z * z);
    const glm::dvec3 v(flat * std::cos(around_z), flat * std::sin(around_z), z);
    const glm::dvec3 x = glm::normalize(glm::cross(v, std::abs(z) < 0.6 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
    const double angle = 2 * pi * coordinate(3), off = std::sqrt(coordinate(4));
    lines[i] = {v, off * (std::cos(angle) * x + std::sin(angle) * glm::cross(v, x))};
  }
  return lines;
}

/// The volumes around an element and the lines that meet them, computed on demand.
class VolumeEstimates {
 public:
  VolumeEstimates(scene::ShapeView element, double surface_of_region)
      : element_(element), outline_(accel::outline(element)), region_(surface_of_region) {}

  const Outline& outline() const { return outline_; }
  const Simple& volume(std::size_t kind) {
    auto& known = volumes_[kind];
    if (!known) known = kinds()[kind].around(element_, outline_);
    return *known;
  }
  /// The share of rays that meet a kind's volume, of those that cross the region, by Cauchy; above 1 where the volume
  /// reaches beyond the region.
  double rays(std::size_t kind) {
    auto& known = rays_[kind];
    if (!known) known = surface_of(volume(kind)) / region_;
    return *known;
  }
  /// The share of rays that meet the hull, a lower bound for every volume.
  double share_of_hull() const { return std::min(1.0, outline_.surface() / region_); }
  const Met& met(std::size_t kind) {
    auto& known = met_[kind];
    if (!known) known = met(volume(kind));
    return *known;
  }
  Met met(const Simple& volume) {
    const auto* const slabs = std::get_if<Slabs>(&volume);
    const std::size_t directions = slabs == nullptr ? 0 : slabs->along.size();
    const std::vector<trace::Ray>& lines = this->lines();
    Met result;
    for (std::size_t i = 0; i < line_count; ++i)
      result[i] = verdict(volume, PrecomputedRay(lines[i], directions), never) == VolumeTest::met;
    return result;
  }

 private:
  /// The isotropic lines around the element.
  const std::vector<trace::Ray>& lines() {
    static const std::array<Chord, line_count> chords = isotropic_lines();
    if (!lines_.empty()) return lines_;
    lines_.reserve(line_count);
    for (const auto& [along, aside] : chords) {
      const glm::dvec3 from = ball().centre + reach * ball().radius * (aside - 2.0 * along);
      lines_.emplace_back(model::Rayo{model::Punto(from), model::Vector(along)});
    }
    return lines_;
  }

  /// The radius of the ball that the lines cross, in radii of the element's ball: no kind reaches beyond √3 of them.
  static constexpr double reach = 1.75;

  const surface::Ball& ball() { return std::get<surface::Ball>(volume(0)); }

  scene::ShapeView element_;
  Outline outline_;
  double region_;
  std::array<std::optional<Simple>, kind_count> volumes_;
  std::array<std::optional<double>, kind_count> rays_;
  std::array<std::optional<Met>, kind_count> met_;
  std::vector<trace::Ray> lines_;
};

/// The cheapest choice so far. A choice that can save less than a hundredth is not tried, because the lines are too few
/// for it.
class Least {
 public:
  explicit Least(VolumeCost first) : best_(std::move(first)) {}

  /// Whether a choice that costs at least `bound` may be taken.
  bool may_be_beaten_by(double bound) const { return bound < 0.99 * best_.T; }
  void consider(VolumeCost choice) {
    if (choice.T < best_.T) best_ = std::move(choice);
  }
  VolumeCost take() { return std::move(best_); }

 private:
  VolumeCost best_;
};

VolumeCost made(Volume volume, double tests, double m) { return {std::move(volume), tests, m, tests + m * I}; }

void consider_intersections(VolumeEstimates& trial, Least& least) {
  const double hull = trial.share_of_hull() * I;
  for (std::size_t i = 0; i < kinds().size(); ++i) {
    if (!least.may_be_beaten_by(kinds()[i].B + hull)) continue;
    const double first = std::min(1.0, trial.rays(i));
    for (std::size_t j = 0; j < kinds().size(); ++j) {
      const double tests = kinds()[i].B + first * kinds()[j].B;
      if (i == j || !least.may_be_beaten_by(tests + hull) || trial.met(i).none()) continue;
      const double let_through = double((trial.met(i) & trial.met(j)).count()) / double(trial.met(i).count());
      const double m = std::min(1.0, trial.rays(i) * let_through);
      least.consider(made({{trial.volume(i), trial.volume(j)}}, tests, m));
    }
  }
}

}  // namespace

VolumeCost choose(scene::ShapeView element, double surface_of_region) {
  VolumeEstimates trial(element, surface_of_region);
  const VolumeKind& single = cheapest(element, surface_of_region);
  const auto i = static_cast<std::size_t>(&single - kinds().data());
  Least least(made({{trial.volume(i)}}, single.B, std::min(1.0, trial.rays(i))));
  consider_intersections(trial, least);
  return least.take();
}

const VolumeKind& kind_of(const Simple& volume) {
  const auto* const slabs = std::get_if<Slabs>(&volume);
  std::size_t i = volume.index();
  if (slabs != nullptr) i += slabs->along.size() == 3 ? 0 : slabs->along.size() == 7 ? 1 : 2;
  return kinds()[i];
}

std::string described(const Volume& volume) {
  std::string text;
  for (const Simple& part : volume.parts) {
    if (!text.empty()) text += volume.rule == Volume::Rule::intersection ? " ∩ " : " ∪ ";
    text += kind_of(part).name;
  }
  return text;
}

}  // namespace durero::accel
