// Asks Embree 3 through rtcIntersect1, and of shadow rays through rtcOccluded1, a geometry an element: `open` and
// `solid` are its own points, curves and triangles, `user` a quadratic in binary64 in a user geometry, as its users
// write them.
#include "../ask.hpp"

#include <embree3/rtcore.h>

using namespace ask;

enum class Kind { open, solid, user };

// The nearest t in (tnear, tfar) of |q − s·d|² = (a + b·s)², 0 ≤ s ≤ h: a cylinder where b = 0; a sphere where d = 0,
// b = 0.
static double user_t(const Element& e, const Ray& ray, double tnear, double tfar) {
  const bool is_sphere = e.is("esfera");
  const Vec d = is_sphere ? Vec{0, 0, 0} : e.vector(), q = ray.p - e.centro();
  const double a = is_sphere ? e.numbers[3] : e.base_radius();
  const double b = is_sphere ? 0 : (e.top_radius() - e.base_radius()) / e.altura();
  const double qs = dot(q, d), vs = dot(ray.v, d);
  const double A = dot(ray.v, ray.v) - vs * vs - b * b * vs * vs;
  const double B = dot(q, ray.v) - qs * vs - b * vs * (a + b * qs);
  const double C = dot(q, q) - qs * qs - (a + b * qs) * (a + b * qs);
  const double D = B * B - A * C;
  if (D < 0) return tfar;
  double nearest = tfar;
  const double alone = -C / (2 * B);  // along a generator of a cone
  for (const double root : {A == 0 ? alone : (-B - std::sqrt(D)) / A, A == 0 ? alone : (-B + std::sqrt(D)) / A}) {
    const double s = qs + root * vs;
    if (root > tnear && root < nearest && (is_sphere || (s >= 0 && s <= e.altura() && a + b * s >= 0))) nearest = root;
  }
  return nearest;
}

static void user_bounds(const RTCBoundsFunctionArguments* args) {
  const auto& e = *static_cast<const Element*>(args->geometryUserPtr);
  const bool is_sphere = e.is("esfera");
  const double r = is_sphere ? e.numbers[3] : e.base_radius();
  const Vec ends[] = {e.centro(), is_sphere ? e.centro() : e.top()};
  float* const lower = &args->bounds_o->lower_x;
  float* const upper = &args->bounds_o->upper_x;
  const float infinity = std::numeric_limits<float>::infinity();
  for (int i = 0; i < 3; ++i) {
    lower[i] = std::nextafterf(float(std::fmin(ends[0][i], ends[1][i]) - r), -infinity);
    upper[i] = std::nextafterf(float(std::fmax(ends[0][i], ends[1][i]) + r), infinity);
  }
}

static void user_intersect(const RTCIntersectFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto& e = *static_cast<const Element*>(args->geometryUserPtr);
  auto& rayhit = *reinterpret_cast<RTCRayHit*>(args->rayhit);  // N = 1
  RTCRay& ray = rayhit.ray;
  const Ray asked = {{ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}};
  const double t = user_t(e, asked, ray.tnear, ray.tfar);
  if (t >= ray.tfar) return;
  ray.tfar = float(t);
  rayhit.hit.geomID = args->geomID;
  rayhit.hit.primID = 0;
}

template <class T>
static T* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t stride, std::size_t count) {
  return static_cast<T*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, stride, count));
}

static RTCGeometry user(RTCDevice device, const Element& e) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, 1);
  rtcSetGeometryUserData(geometry, const_cast<Element*>(&e));
  rtcSetGeometryBoundsFunction(
      geometry, [](const RTCBoundsFunctionArguments* args) { user_bounds(args); }, nullptr);
  rtcSetGeometryIntersectFunction(geometry, user_intersect);
  return geometry;
}

static RTCGeometry sphere(RTCDevice device, const Element& e) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  float* const v = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, 1);
  for (int i = 0; i < 4; ++i) v[i] = float(e.numbers[i]);
  return geometry;
}

static RTCGeometry disc(RTCDevice device, const Element& e) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
  float* const v = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, 1);
  float* const n = buffer<float>(geometry, RTC_BUFFER_TYPE_NORMAL, RTC_FORMAT_FLOAT3, 12, 1);
  for (int i = 0; i < 3; ++i) v[i] = float(e.centro()[i]), n[i] = float(e.vector()[i]);
  v[3] = float(e.numbers[6]);
  return geometry;
}

static RTCGeometry triangle(RTCDevice device, const Element& e) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  float* const v = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 12, 3);
  unsigned* const index = buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 12, 1);
  for (int i = 0; i < 9; ++i) v[i] = float(e.numbers[i]);
  for (unsigned i = 0; i < 3; ++i) index[i] = i;
  return geometry;
}

// A segment with neighbours on both sides is open; without them it is closed.
static RTCGeometry curve(RTCDevice device, const Element& e, Kind kind) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
  float* const v = buffer<float>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, 2);
  const Vec top = e.top();
  for (int i = 0; i < 3; ++i) v[i] = float(e.centro()[i]), v[4 + i] = float(top[i]);
  v[3] = float(e.base_radius());
  v[7] = float(e.top_radius());
  *buffer<unsigned>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, 4, 1) = 0;
  *buffer<unsigned char>(geometry, RTC_BUFFER_TYPE_FLAGS, RTC_FORMAT_UCHAR, 1, 1) =
      kind == Kind::open ? RTC_CURVE_FLAG_NEIGHBOR_LEFT | RTC_CURVE_FLAG_NEIGHBOR_RIGHT : 0;
  return geometry;
}

static RTCGeometry geometry_of(RTCDevice device, const Element& e, Kind kind) {
  if (kind == Kind::user) return user(device, e);
  if (e.is("esfera")) return sphere(device, e);
  if (e.is("disco")) return disc(device, e);
  if (e.is("triangulo")) return triangle(device, e);
  return curve(device, e, kind);
}

// What an intersection of all hits finds. The filter takes each hit down and rejects it, so that the search goes on.
struct AllHits {
  RTCIntersectContext context;  // first, so that the filter finds the rest by it
  const Scene* of;
  std::vector<Listed> found;
};
static void take_down(const RTCFilterFunctionNArguments* args) {
  auto& all = *reinterpret_cast<AllHits*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned element = RTCHitN_geomID(args->hit, args->N, i);
    all.found.push_back({RTCRayN_tfar(args->ray, args->N, i), all.of->elements[element].name});
    args->valid[i] = 0;
  }
}

class Asked {
 public:
  Asked(RTCDevice device, const Scene& of, Kind kind) : kind_(kind), of_(&of), scene_(rtcNewScene(device)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
    for (unsigned i = 0; i < of.elements.size(); ++i) {
      RTCGeometry geometry = geometry_of(device, of.elements[i], kind);
      rtcCommitGeometry(geometry);
      rtcAttachGeometryByID(scene_, geometry, i);
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene_);
  }
  ~Asked() { rtcReleaseScene(scene_); }

  void ask(const Ray& asked) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit rayhit{};
    RTCRay& ray = rayhit.ray;
    ray.org_x = float(asked.p[0]), ray.org_y = float(asked.p[1]), ray.org_z = float(asked.p[2]);
    ray.dir_x = float(asked.v[0]), ray.dir_y = float(asked.v[1]), ray.dir_z = float(asked.v[2]);
    ray.tnear = float(asked.begin);
    ray.tfar = float(asked.end);
    ray.mask = ~0U;
    if (asked.is_about_all) {
      AllHits all{context, of_, {}};
      all.context.filter = take_down;
      rayhit.hit.geomID = rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene_, &all.context, &rayhit);
      return all_hits(asked, all.found);
    }
    if (asked.is_shadow) {
      rtcOccluded1(scene_, &context, &ray);
      return shadow(ray.tfar < 0);
    }
    rayhit.hit.geomID = rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &rayhit);
    if (rayhit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return miss();
    const Element& met = of_->elements[rayhit.hit.geomID];
    if (kind_ == Kind::user) return hit(met.name, ray.tfar);
    const double uv[] = {rayhit.hit.u, rayhit.hit.v};
    hit(met.name, ray.tfar, {rayhit.hit.Ng_x, rayhit.hit.Ng_y, rayhit.hit.Ng_z}, met.is("triangulo") ? uv : nullptr);
  }

 private:
  Kind kind_;
  const Scene* of_;
  RTCScene scene_;
};

int main(int, char** argv) {
  const std::string word = argv[1];
  const Kind kind = word == "open" ? Kind::open : word == "solid" ? Kind::solid : Kind::user;
  RTCDevice device = rtcNewDevice("threads=1");
  return answer("Embree " RTC_VERSION_STRING " " + word,
                [&](const Scene& scene) { return Asked(device, scene, kind); });
}
