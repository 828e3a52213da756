#define HWY_TARGET_INCLUDE "trace/filter.cpp"  // as seen from src/
#include "lanes/for_each_target.hpp"
//
#include <cmath>
#include <limits>

#include "durero/trace/filter.hpp"

HWY_BEFORE_NAMESPACE();
namespace durero::trace {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<double, Balls::block>;
using Lanes = hn::Vec<Tag>;

struct Components {
  Lanes x, y, z;
};

HWY_INLINE Lanes squared(const Components& a) {
  return hn::Add(hn::Add(hn::Mul(a.x, a.x), hn::Mul(a.y, a.y)), hn::Mul(a.z, a.z));
}

std::size_t passed_by(const Balls& balls, const Ray& ray, double limit, std::size_t begin, std::size_t end,
                      std::uint32_t* passed) {
  const Tag tag;
  const Components p{hn::Set(tag, ray.p.x), hn::Set(tag, ray.p.y), hn::Set(tag, ray.p.z)};
  const Components v{hn::Set(tag, ray.v.x), hn::Set(tag, ray.v.y), hn::Set(tag, ray.v.z)};
  const Lanes length_squared = hn::Set(tag, ray.length_squared()), length = hn::Set(tag, ray.length());
  const Lanes allowance = hn::Set(tag, ray.allowance());
  const Lanes farthest = hn::Set(tag, limit * ray.length_squared());
  std::size_t count = 0;
  for (std::size_t i = begin; i < end; i += hn::Lanes(tag)) {
    const Components q{hn::Sub(p.x, hn::LoadU(tag, &balls.x[i])), hn::Sub(p.y, hn::LoadU(tag, &balls.y[i])),
                       hn::Sub(p.z, hn::LoadU(tag, &balls.z[i]))};
    const Lanes radius = hn::Add(hn::LoadU(tag, &balls.radius[i]), allowance);
    const Components moment{hn::Sub(hn::Mul(q.y, v.z), hn::Mul(q.z, v.y)),
                            hn::Sub(hn::Mul(q.z, v.x), hn::Mul(q.x, v.z)),
                            hn::Sub(hn::Mul(q.x, v.y), hn::Mul(q.y, v.x))};
    const Lanes B = hn::Add(hn::Add(hn::Mul(q.x, v.x), hn::Mul(q.y, v.y)), hn::Mul(q.z, v.z));
    const Lanes reach = hn::Mul(radius, length);
    const auto near = hn::Le(squared(moment), hn::Mul(hn::Mul(radius, radius), length_squared));
    const auto ahead = hn::Le(B, reach);
    const auto soon = hn::Ge(hn::Add(hn::Add(B, reach), farthest), hn::Zero(tag));
    const auto met = hn::And(near, hn::And(ahead, soon));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(tag, met, bits);
    for (unsigned mask = bits[0]; mask != 0; mask &= mask - 1) {
      passed[count++] = static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(__builtin_ctz(mask));
    }
  }
  return count;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace durero::trace
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace durero::trace {
namespace {
HWY_EXPORT(passed_by);
}  // namespace

void Balls::push_back(const surface::Ball& ball) {
  x.push_back(ball.centre.x);
  y.push_back(ball.centre.y);
  z.push_back(ball.centre.z);
  const glm::dvec3& m = ball.centre;
  radius.push_back(ball.radius + 0x1p-49 * (std::abs(m.x) + std::abs(m.y) + std::abs(m.z)));
}

void Balls::pad() {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  while (x.size() % block != 0) push_back({{nan, nan, nan}, nan});
}

std::size_t filter(const Balls& balls, const Ray& ray, double limit, std::size_t begin, std::size_t end,
                   std::uint32_t* passed) {
  return HWY_DYNAMIC_DISPATCH(passed_by)(balls, ray, limit, begin, end, passed);
}

}  // namespace durero::trace
#endif
