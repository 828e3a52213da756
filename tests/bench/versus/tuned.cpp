// Callbacks of a packet, as fast as we can write them: the origin is first moved to the nearest point of the line to
// the element, and all rays of the packet are computed side by side, without a branch, in the widest lanes of the
// machine.
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <vector>

#include "versus/embree_scene.hpp"

namespace durero::versus {
namespace {

/// An element as the callbacks have it: what does not depend on the ray is computed before.
template <class T>
struct TunedElement {
  T ax, ay, az, nx, ny, nz, radius, slope, height;
  bool is_sphere;
};

template <class T>
TunedElement<T> tuned(const CurvedElement& e) {
  const glm::dvec3 along = e.b - e.a;
  const double height = glm::length(along);
  const bool is_sphere = !(height > 0);
  const glm::dvec3 n = is_sphere ? glm::dvec3(0) : along / height;
  const double slope = is_sphere ? 0 : (e.top - e.radius) / height;
  return {T(e.a.x), T(e.a.y), T(e.a.z), T(n.x), T(n.y), T(n.z), T(e.radius), T(slope), T(height), is_sphere};
}

/// The components of a packet of rays and of its hits, as Embree lays them out.
enum Component : unsigned { org_x, org_y, org_z, tnear, dir_x, dir_y, dir_z, tfar = 8, prim_id = 17, geom_id = 18 };

/// The first root of each ray between its ends; `hit` is 0 where there is none.
template <class T, unsigned size, bool is_sphere>
[[gnu::always_inline]] inline void roots(const TunedElement<T>& e, const float* rays, float* t, int* hit) {
  const float *px = rays + org_x * size, *py = rays + org_y * size, *pz = rays + org_z * size;
  const float *vx = rays + dir_x * size, *vy = rays + dir_y * size, *vz = rays + dir_z * size;
  const float *from = rays + tnear * size, *to = rays + tfar * size;
#pragma GCC ivdep
  for (unsigned i = 0; i < size; ++i) {
    const T x = T(vx[i]), y = T(vy[i]), z = T(vz[i]), least = T(from[i]), greatest = T(to[i]);
    T ox = T(px[i]) - e.ax, oy = T(py[i]) - e.ay, oz = T(pz[i]) - e.az;
    const T inverse = T(1) / (x * x + y * y + z * z);
    const T nearest = -(ox * x + oy * y + oz * z) * inverse;
    ox += nearest * x, oy += nearest * y, oz += nearest * z;
    T low, high, D;
    int in0 = 1, in1 = 1;
    if constexpr (is_sphere) {
      D = e.radius * e.radius - (ox * ox + oy * oy + oz * oz);
      high = std::sqrt((D > 0 ? D : T(0)) * inverse), low = -high;
    } else {
      const T s0 = ox * e.nx + oy * e.ny + oz * e.nz, s1 = x * e.nx + y * e.ny + z * e.nz;
      const T qx = ox - s0 * e.nx, qy = oy - s0 * e.ny, qz = oz - s0 * e.nz;
      const T wx = x - s1 * e.nx, wy = y - s1 * e.ny, wz = z - s1 * e.nz;
      const T wide = e.radius + e.slope * s0, slope = e.slope * s1;
      const T A = wx * wx + wy * wy + wz * wz - slope * slope, B = qx * wx + qy * wy + qz * wz - slope * wide;
      const T C = qx * qx + qy * qy + qz * qz - wide * wide;
      D = B * B - A * C;
      const T root = std::sqrt(D > 0 ? D : T(0)), of_A = T(1) / A, u = (-B - root) * of_A, w = (-B + root) * of_A;
      low = u < w ? u : w, high = u < w ? w : u;
      const T first = s0 + low * s1, second = s0 + high * s1;
      in0 = (first >= 0) & (first <= e.height), in1 = (second >= 0) & (second <= e.height);
    }
    const T t0 = nearest + low, t1 = nearest + high;
    const int has0 = in0 & (D >= 0) & (t0 > least) & (t0 < greatest);
    const int has1 = in1 & (D >= 0) & (t1 > least) & (t1 < greatest);
    t[i] = static_cast<float>(has0 ? t0 : t1);
    hit[i] = has0 | has1;
  }
}

template <class T>
[[gnu::always_inline]] inline void roots(const TunedElement<T>& e, const float* rays, unsigned size, float* t,
                                         int* hit) {
  if (size == 16) return e.is_sphere ? roots<T, 16, true>(e, rays, t, hit) : roots<T, 16, false>(e, rays, t, hit);
  if (size == 8) return e.is_sphere ? roots<T, 8, true>(e, rays, t, hit) : roots<T, 8, false>(e, rays, t, hit);
  return e.is_sphere ? roots<T, 1, true>(e, rays, t, hit) : roots<T, 1, false>(e, rays, t, hit);
}

#define EACH_TARGET [[gnu::target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")]]
EACH_TARGET void all_roots(const TunedElement<float>& e, const float* rays, unsigned size, float* t, int* hit) {
  roots(e, rays, size, t, hit);
}
EACH_TARGET void all_roots(const TunedElement<double>& e, const float* rays, unsigned size, float* t, int* hit) {
  roots(e, rays, size, t, hit);
}

constexpr unsigned most = 16;

template <class T>
const TunedElement<T>& element(const void* callbacks, unsigned id) {
  return static_cast<const TunedElement<T>*>(static_cast<const Callbacks*>(callbacks)->elements)[id];
}

template <class T>
void intersect(const RTCIntersectFunctionNArguments* call) {
  auto* const rays = reinterpret_cast<float*>(call->rayhit);
  const unsigned size = call->N;
  float t[most];
  int hit[most];
  all_roots(element<T>(call->geometryUserPtr, call->primID), rays, size, t, hit);
  auto* const ids = reinterpret_cast<unsigned*>(rays);
  for (unsigned i = 0; i < size; ++i)
    if ((hit[i] & call->valid[i]) != 0) {
      rays[tfar * size + i] = t[i];
      ids[prim_id * size + i] = call->primID, ids[geom_id * size + i] = call->geomID;
    }
}

template <class T>
void occlude(const RTCOccludedFunctionNArguments* call) {
  auto* const rays = reinterpret_cast<float*>(call->ray);
  float t[most];
  int hit[most];
  all_roots(element<T>(call->geometryUserPtr, call->primID), rays, call->N, t, hit);
  for (unsigned i = 0; i < call->N; ++i)
    if ((hit[i] & call->valid[i]) != 0) rays[tfar * call->N + i] = -HUGE_VALF;
}

template <class T>
Callbacks callbacks_over(const std::vector<CurvedElement>& elements) {
  auto own = std::make_shared<std::vector<TunedElement<T>>>();
  for (const CurvedElement& e : elements) own->push_back(tuned<T>(e));
  return {own->data(), intersect<T>, occlude<T>, own};
}

}  // namespace

Callbacks tuned_callbacks(const std::vector<CurvedElement>& elements, bool in_binary64) {
  return in_binary64 ? callbacks_over<double>(elements) : callbacks_over<float>(elements);
}

}  // namespace durero::versus
