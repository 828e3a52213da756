#include "scattering.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "durero/render/light/directions.hpp"
#include "durero/render/sample/maps.hpp"

namespace durero::render {
namespace {

double greatest(const glm::dvec3& color) { return std::max({color.x, color.y, color.z}); }

}  // namespace

Scattering::Scattering(const Encounter& at, bool goes_through)
    : at_(at),
      mirrored_(unit(mirrored_way(at))),
      mirror_color_(at.look.k_ps * at.look.M_PS),
      has_gloss_(!std::isinf(at.look.gloss)),
      even_(at.look.k_d * greatest(at.look.color)),
      highlight_(2 * at.look.k_s / (at.look.e + 1)) {
  (goes_through ? beyond_color_ : mirror_color_) += at.look.k_t * at.look.M_T;
  mirror_ = greatest(mirror_color_);
  beyond_ = greatest(beyond_color_);
  sum_ = even_ + highlight_ + mirror_ + beyond_;
}

/// The lobe about the mirrored direction, and what of it is folded back from beyond the surface.
double Scattering::gloss_density(const glm::dvec3& l) const {
  const double gloss = at_.look.gloss;
  return lobe_density(glm::dot(l, mirrored_), gloss) +
         lobe_density(glm::dot(render::mirrored(l, at_.normal), mirrored_), gloss);
}

glm::dvec3 Scattering::of_light(const glm::dvec3& l) const { return std::numbers::pi * of_local_model(l); }

glm::dvec3 Scattering::sent(const glm::dvec3& l) const {
  const glm::dvec3 all = of_local_model(l);
  return has_gloss_ && glm::dot(l, at_.normal) > 0 ? all + mirror_color_ * gloss_density(l) : all;
}

glm::dvec3 Scattering::of_local_model(const glm::dvec3& l) const {
  if (!(glm::dot(l, at_.normal) > 0)) return glm::dvec3(0);
  const double cosine = glm::dot(l, at_.facing);
  glm::dvec3 all = at_.look.color * (at_.look.k_d * cosine_density(cosine));
  if (highlight_ > 0 && cosine > 0) {
    const double towards = glm::dot(render::mirrored(l, at_.facing), at_.d);
    all += glm::dvec3(highlight_ * lobe_density(towards, at_.look.e));
  }
  return all;
}

double Scattering::density(const glm::dvec3& l) const {
  double all = even_ * cosine_density(glm::dot(l, at_.facing));
  const glm::dvec3 r = render::mirrored(at_.d, at_.facing);
  if (highlight_ > 0) all += highlight_ * lobe_density(glm::dot(l, r), at_.look.e);
  if (has_gloss_ && mirror_ > 0 && glm::dot(l, at_.normal) > 0) all += mirror_ * gloss_density(l);
  return all / sum_;
}

Scattering::Lobe Scattering::chosen(double choice) const {
  const double place = choice * sum_;
  if (place < even_ + highlight_) return Lobe::smooth;
  if (place < even_ + highlight_ + mirror_) return has_gloss_ ? Lobe::smooth : Lobe::mirror;
  return beyond_ > 0 ? Lobe::beyond : (mirror_ > 0 && !has_gloss_ ? Lobe::mirror : Lobe::smooth);
}

glm::dvec3 Scattering::direction(double choice, const glm::dvec2& pair) const {
  const double place = choice * sum_;
  if (place < even_) return by_cosine(pair, at_.facing);
  if (place < even_ + highlight_) return in_lobe(pair, render::mirrored(at_.d, at_.facing), at_.look.e);
  const glm::dvec3 turned = in_lobe(pair, mirrored_, at_.look.gloss);
  return glm::dot(turned, at_.normal) > 0 ? turned : render::mirrored(turned, at_.normal);
}

}  // namespace durero::render
