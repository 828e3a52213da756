// Durero and Embree on the same scenes and rays, interleaved, on one thread: how long a build takes, millions of rays a
// second, and how many times Embree's rate is Durero's; then how many times its own rate Durero's is on two threads, of
// the time that passes. Durero's `fast` is right, and gives what it is asked for: the elements that are met first, or
// these with t and the point rounded; Embree's answers are binary32, or its callbacks' binary64, and are not judged
// here.
//   embree_bench [--size SIZE] [--rays KIND] [ELEMENTS...]
//                    size² rays, 1024², of every kind, on 10, 10³, 10⁵ and 10⁶ elements, unless told
//
// The scene is that of trace_bench: n elements in the unit cube, a third of each of spheres, cylinders and cones.
// Primary rays leave a pinhole, in Morton order; incoherent ones have uniform origins and directions; shadow rays go
// from each primary hit to one light. Embree is asked by its own types (spheres, and cones of linear curves, which are
// open where both neighbour flags are set), ray by ray and in packets of 16, and by callbacks in binary64, ray by ray.
// Each rate is the best of some turns, in which each takes its own.
#include <embree3/rtcore.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <boost/container/vector.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "durero/engine/engine.hpp"
#include "support/scenes.hpp"
#include "support/shapes.hpp"

using namespace durero;

namespace {

/// A cylinder or a cone between two points, or a sphere at the first.
struct Element {
  model::Tipo tipo;
  glm::dvec3 a, b;
  double radius, top;
};

double single(double x) { return static_cast<double>(static_cast<float>(x)); }
glm::dvec3 single(const glm::dvec3& x) { return {single(x.x), single(x.y), single(x.z)}; }

struct Scenes {
  scene::Scene durero;
  std::vector<Element> elements;
};

Scenes made(std::size_t n) {
  test::Random random(1);
  Scenes scenes;
  const double unit = 0.25 * std::cbrt(1 / static_cast<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3 centro = single(random.in_cube(0.5) + 0.5);
    const double radio = single(unit * random.uniform(0.5, 1));
    const double altura = single(unit * random.uniform(1.5, 3));
    const glm::dvec3 axis = random.axis().xyz();
    const glm::dvec3 end = centro + altura * axis;
    if (i % 3 == 0) {
      test::add(scenes.durero, scene::Sphere{centro, radio});
      scenes.elements.push_back({model::Tipo::soy_esfera, centro, centro, radio, radio});
    } else if (i % 3 == 1) {
      test::add(scenes.durero, scene::Cylinder{centro, radio, axis, altura});
      scenes.elements.push_back({model::Tipo::soy_cilindro, centro, end, radio, radio});
    } else {
      test::add(scenes.durero, scene::Cone{centro, radio / altura, axis, altura});
      scenes.elements.push_back({model::Tipo::soy_cono, centro, end, radio, 0});
    }
  }
  return scenes;
}

using Queries = std::vector<scene::Query>;

/// The even bits of a number.
std::uint32_t even_bits(std::uint64_t x) {
  std::uint32_t bits = 0;
  for (int i = 0; i < 16; ++i) bits |= static_cast<std::uint32_t>(x >> (2 * i) & 1) << i;
  return bits;
}

Queries primary(std::uint32_t size) {
  Queries queries;
  for (std::uint64_t i = 0; i < std::uint64_t{size} * size; ++i) {
    const auto place = [&](std::uint32_t at) { return (2 * (at + 0.5) / size - 1) * 0.55 / 1.2; };
    const glm::dvec3 v = glm::normalize(glm::dvec3(place(even_bits(i)), place(even_bits(i >> 1)), 1));
    queries.push_back({test::ray({0.5, 0.5, single(-1.2)}, single(v))});
  }
  return queries;
}

Queries incoherent(std::size_t count) {
  test::Random random(2);
  Queries queries;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec3 from = single(random.in_cube(0.5) + 0.5);
    queries.push_back({test::ray(from, single(random.direction()))});
  }
  return queries;
}

Queries shadow(const std::vector<scene::Hit>& hits) {
  Queries queries;
  for (const scene::Hit& hit : hits)
    if (hit.resultado == model::Resultado::hit)
      queries.push_back({test::ray(hit.punto, glm::dvec3(0.3, 2.5, -0.8) - hit.punto), hit.elementos});
  return queries;
}

// Embree.

/// The first root of the quadratic between the ray's ends at which the point is one of the element; infinite for none.
double first_root(const Element& e, const glm::dvec3& p, const glm::dvec3& v, double from, double to) {
  const glm::dvec3 q = p - e.a;
  double A = glm::dot(v, v), B = glm::dot(q, v), C = glm::dot(q, q), s0 = 0, s1 = 0, height = 0;
  if (e.tipo == model::Tipo::soy_esfera) {
    C -= e.radius * e.radius;
  } else {
    const glm::dvec3 along = e.b - e.a;
    height = glm::length(along);
    const glm::dvec3 d = along / height;
    s0 = glm::dot(q, d), s1 = glm::dot(v, d);
    const double k = (e.top - e.radius) / height, radius = e.radius + k * s0;
    A -= s1 * s1 * (1 + k * k);
    B -= s0 * s1 + k * s1 * radius;
    C -= s0 * s0 + radius * radius;
  }
  const double D = B * B - A * C;
  if (D < 0) return HUGE_VAL;
  const double root = std::sqrt(D), inverse = 1 / A;
  double near = (-B - root) * inverse, far = (-B + root) * inverse;
  if (near > far) std::swap(near, far);
  for (const double t : {near, far}) {
    const double s = s0 + t * s1;
    if (t > from && t < to && s >= 0 && s <= height) return t;
  }
  return HUGE_VAL;
}

double first_root(const RTCRay& ray, const Element& e) {
  return first_root(e, {ray.org_x, ray.org_y, ray.org_z}, {ray.dir_x, ray.dir_y, ray.dir_z}, ray.tnear, ray.tfar);
}

const Element& element(const void* elements, unsigned id) { return static_cast<const Element*>(elements)[id]; }

void bound(const RTCBoundsFunctionArguments* call) {
  const Element& e = element(call->geometryUserPtr, call->primID);
  float* low = &call->bounds_o->lower_x;
  float* high = &call->bounds_o->upper_x;
  const glm::dvec3 along = e.b - e.a;
  const double squared = glm::dot(along, along);
  for (int i = 0; i < 3; ++i) {
    const double share = squared > 0 ? std::sqrt(std::max(0.0, 1 - along[i] * along[i] / squared)) : 1;
    low[i] =
        std::nextafter(static_cast<float>(std::min(e.a[i] - e.radius * share, e.b[i] - e.top * share)), -HUGE_VALF);
    high[i] =
        std::nextafter(static_cast<float>(std::max(e.a[i] + e.radius * share, e.b[i] + e.top * share)), HUGE_VALF);
  }
}

void intersect(const RTCIntersectFunctionNArguments* call) {
  if (call->valid[0] == 0) return;
  auto* hit = reinterpret_cast<RTCRayHit*>(call->rayhit);
  const double t = first_root(hit->ray, element(call->geometryUserPtr, call->primID));
  if (!(t < HUGE_VAL)) return;
  hit->ray.tfar = static_cast<float>(t);
  hit->hit.primID = call->primID;
  hit->hit.geomID = call->geomID;
}

void occlude(const RTCOccludedFunctionNArguments* call) {
  if (call->valid[0] == 0) return;
  auto* ray = reinterpret_cast<RTCRay*>(call->ray);
  if (first_root(*ray, element(call->geometryUserPtr, call->primID)) < HUGE_VAL) ray->tfar = -HUGE_VALF;
}

class Embree {
 public:
  Embree(RTCDevice device, const std::vector<Element>& elements, bool native) : scene_(rtcNewScene(device)) {
    if (native) {
      spheres(device, elements);
      curves(device, elements);
    } else {
      const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
      rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(elements.size()));
      rtcSetGeometryUserData(geometry, const_cast<Element*>(elements.data()));
      rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
      rtcSetGeometryIntersectFunction(geometry, intersect);
      rtcSetGeometryOccludedFunction(geometry, occlude);
      attach(geometry);
    }
    rtcCommitScene(scene_);
  }
  ~Embree() { rtcReleaseScene(scene_); }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  RTCScene scene() const { return scene_; }

 private:
  void attach(RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  static void* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t width, std::size_t size) {
    return rtcSetNewGeometryBuffer(geometry, type, 0, format, width, size);
  }

  static void store(float* to, const glm::dvec3& x, double radius) {
    for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(x[i]);
    to[3] = static_cast<float>(radius);
  }

  void spheres(RTCDevice device, const std::vector<Element>& elements) {
    std::vector<const Element*> own;
    for (const Element& e : elements)
      if (e.tipo == model::Tipo::soy_esfera) own.push_back(&e);
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* vertex = static_cast<float*>(buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, own.size()));
    for (std::size_t i = 0; i < own.size(); ++i) store(vertex + 4 * i, own[i]->a, own[i]->radius);
    attach(geometry);
  }

  void curves(RTCDevice device, const std::vector<Element>& elements) {
    std::vector<const Element*> own;
    for (const Element& e : elements)
      if (e.tipo != model::Tipo::soy_esfera) own.push_back(&e);
    if (own.empty()) return;
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
    const std::size_t n = own.size();
    auto* vertex = static_cast<float*>(buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, 2 * n));
    auto* index = static_cast<unsigned*>(buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, 4, n));
    auto* flags = static_cast<unsigned char*>(buffer(geometry, RTC_BUFFER_TYPE_FLAGS, RTC_FORMAT_UCHAR, 1, n));
    for (std::size_t i = 0; i < n; ++i) {
      store(vertex + 8 * i, own[i]->a, own[i]->radius);
      store(vertex + 8 * i + 4, own[i]->b, own[i]->top);
      index[i] = static_cast<unsigned>(2 * i);
      flags[i] = RTC_CURVE_FLAG_NEIGHBOR_LEFT | RTC_CURVE_FLAG_NEIGHBOR_RIGHT;
    }
    attach(geometry);
  }

  RTCScene scene_;
};

/// A ray as Embree is asked, ready in an array; what it answers goes to another.
struct Ray32 {
  float p[3], v[3], from, to;
};
struct Hit32 {
  float t;
  unsigned geometry, element;
};

std::vector<Ray32> rays_of(const Queries& queries, bool segments) {
  std::vector<Ray32> rays;
  for (const scene::Query& query : queries) {
    const glm::dvec3 &p = query.rayo.p().xyz(), &v = query.rayo.v().xyz();
    rays.push_back({{float(p.x), float(p.y), float(p.z)},
                    {float(v.x), float(v.y), float(v.z)},
                    segments ? 1e-4F : 0,
                    segments ? 1 : HUGE_VALF});
  }
  return rays;
}

void set(RTCRay& ray, const Ray32& from) {
  ray = {from.p[0], from.p[1], from.p[2], from.from, from.v[0], from.v[1], from.v[2], 0, from.to, ~0U, 0, 0};
}

void set(RTCRay16& rays, std::size_t lane, const Ray32& from) {
  rays.org_x[lane] = from.p[0], rays.org_y[lane] = from.p[1], rays.org_z[lane] = from.p[2];
  rays.dir_x[lane] = from.v[0], rays.dir_y[lane] = from.v[1], rays.dir_z[lane] = from.v[2];
  rays.tnear[lane] = from.from, rays.tfar[lane] = from.to, rays.time[lane] = 0;
  rays.mask[lane] = ~0U, rays.flags[lane] = 0;
}

struct Asked {
  const std::vector<Ray32>& rays;
  std::vector<Hit32>& hits;
  RTCIntersectContext& context;
};

void first_hits_single(RTCScene scene, const Asked& asked) {
  for (std::size_t i = 0; i < asked.rays.size(); ++i) {
    RTCRayHit hit;
    set(hit.ray, asked.rays[i]);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &asked.context, &hit);
    asked.hits[i] = {hit.ray.tfar, hit.hit.geomID, hit.hit.primID};
  }
}

void occluded_single(RTCScene scene, const Asked& asked) {
  for (std::size_t i = 0; i < asked.rays.size(); ++i) {
    RTCRay ray;
    set(ray, asked.rays[i]);
    rtcOccluded1(scene, &asked.context, &ray);
    asked.hits[i].t = ray.tfar;
  }
}

constexpr std::size_t lanes = 16;

/// ask(valid, from, count) for each sixteen rays.
template <class Ask>
void by_sixteen(const Asked& asked, Ask ask) {
  for (std::size_t at = 0; at < asked.rays.size(); at += lanes) {
    const std::size_t count = std::min(lanes, asked.rays.size() - at);
    alignas(64) int valid[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) valid[lane] = lane < count ? -1 : 0;
    ask(valid, at, count);
  }
}

void first_hits_packets(RTCScene scene, const Asked& asked) {
  by_sixteen(asked, [&](const int* valid, std::size_t at, std::size_t count) {
    RTCRayHit16 hit;
    for (std::size_t lane = 0; lane < count; ++lane) {
      set(hit.ray, lane, asked.rays[at + lane]);
      hit.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, scene, &asked.context, &hit);
    for (std::size_t lane = 0; lane < count; ++lane)
      asked.hits[at + lane] = {hit.ray.tfar[lane], hit.hit.geomID[lane], hit.hit.primID[lane]};
  });
}

void occluded_packets(RTCScene scene, const Asked& asked) {
  by_sixteen(asked, [&](const int* valid, std::size_t at, std::size_t count) {
    RTCRay16 rays;
    for (std::size_t lane = 0; lane < count; ++lane) set(rays, lane, asked.rays[at + lane]);
    rtcOccluded16(valid, scene, &asked.context, &rays);
    for (std::size_t lane = 0; lane < count; ++lane) asked.hits[at + lane].t = rays.tfar[lane];
  });
}

// The turns.

constexpr int turns = 3;

using Threads = oneapi::tbb::global_control;

/// Of the processor, on one thread.
double seconds(const std::function<void()>& work) {
  const Threads one(Threads::max_allowed_parallelism, 1);
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// That pass, on some threads.
double seconds_on(std::size_t threads, const std::function<void()>& work) {
  const Threads some(Threads::max_allowed_parallelism, threads);
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// What a second thread gains, if there is one.
void compare_threads(std::size_t n, const char* kind, std::size_t rays, const std::function<void()>& work) {
  if (oneapi::tbb::info::default_concurrency() < 2) return;
  double one = HUGE_VAL, two = HUGE_VAL;
  for (int turn = 0; turn < turns; ++turn) {
    one = std::min(one, seconds_on(1, work));
    two = std::min(two, seconds_on(2, work));
  }
  std::printf("%8zu  %-10s  %-26s %8.2f Mrays/s   %5.2f times one thread's\n", n, kind, "Durero fast, two threads",
              static_cast<double>(rays) / two / 1e6, one / two);
  std::fflush(stdout);
}

struct Contestant {
  std::string name;
  std::function<void()> work;
  double best = HUGE_VAL;
};

/// Turn by turn, and what each of the first, which are Durero, is to each other.
void compare(std::size_t n, const char* kind, std::size_t rays, std::size_t first,
             std::vector<Contestant> contestants) {
  for (int turn = 0; turn < turns; ++turn)
    for (Contestant& contestant : contestants) contestant.best = std::min(contestant.best, seconds(contestant.work));
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    const Contestant& c = contestants[i];
    std::printf("%8zu  %-10s  %-26s %8.2f Mrays/s", n, kind, c.name.c_str(), static_cast<double>(rays) / c.best / 1e6);
    if (i >= first) std::printf("   Durero is");
    for (std::size_t own = 0; i >= first && own < first; ++own)
      std::printf("%s %5.2f", own == 0 ? "" : ",", c.best / contestants[own].best);
    std::printf(i >= first ? " of it\n" : "\n");
  }
  std::fflush(stdout);
}

/// What to compare: size² rays of this kind, or of every kind.
struct Asking {
  std::uint32_t size = 1024;
  std::string kind{};
  bool wants(const char* one) const { return kind.empty() || kind == one; }
};

void run(RTCDevice device, std::size_t n, const Asking& asking) {
  Scenes scenes = made(n);
  std::unique_ptr<const engine::Engine> fast;
  const engine::EngineRow* row = engine::find("fast");
  std::unique_ptr<Embree> native, callbacks;
  double building = HUGE_VAL, native_building = HUGE_VAL, callbacks_building = HUGE_VAL;
  for (int turn = 0; turn < turns; ++turn) {
    fast.reset(), native.reset(), callbacks.reset();
    building = std::min(building, seconds([&] { fast = row->prepare(scenes.durero); }));
    native_building =
        std::min(native_building, seconds([&] { native = std::make_unique<Embree>(device, scenes.elements, true); }));
    callbacks_building = std::min(
        callbacks_building, seconds([&] { callbacks = std::make_unique<Embree>(device, scenes.elements, false); }));
  }
  std::printf("%8zu  build       Durero %.1f ms, Embree's types %.1f ms, its callbacks %.1f ms\n", n, 1e3 * building,
              1e3 * native_building, 1e3 * callbacks_building);
  if (row->measure != nullptr) {
    const engine::Figures figures = row->measure(scenes.durero, incoherent(10000));
    const accel::Size& size = figures.size;
    const accel::Work& work = figures.work;
    const auto a_ray = [&](std::uint64_t all) { return static_cast<double>(all) / static_cast<double>(work.rays); };
    std::printf("%8zu  size        %.1f bytes an element, %zu nodes, depth %zu\n", n,
                static_cast<double>(size.bytes) / static_cast<double>(n), size.nodes, size.depth);
    std::printf("%8zu  incoherent  a ray alone: %.1f nodes, %.1f boxes, of which %.1f met, %.1f candidates\n", n,
                a_ray(work.nodes), a_ray(work.volumes), a_ray(work.volumes - work.by_miss), a_ray(work.candidates));
  }

  const auto first_hits = [&](const char* kind, const Queries& queries) {
    std::vector<scene::Hit> hits(queries.size());
    std::vector<trace::FirstElement> elements(queries.size());
    const std::vector<Ray32> rays = rays_of(queries, false);
    std::vector<Hit32> hits32(rays.size());
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    if (std::strcmp(kind, "primary") == 0) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    const Asked asked{rays, hits32, context};
    if (!asking.wants(kind)) {
      fast->first_hits(queries, hits);
      return hits;
    }
    compare(n, kind, queries.size(), 2,
            {{"Durero fast, elements", [&] { fast->first_elements(queries, elements); }},
             {"Durero fast, rounded", [&] { fast->first_hits(queries, hits); }},
             {"Embree types, single", [&] { first_hits_single(native->scene(), asked); }},
             {"Embree types, packets", [&] { first_hits_packets(native->scene(), asked); }},
             {"Embree callbacks, single", [&] { first_hits_single(callbacks->scene(), asked); }}});
    compare_threads(n, kind, queries.size(), [&] { fast->first_elements(queries, elements); });
    return hits;
  };
  if (asking.wants("incoherent")) first_hits("incoherent", incoherent(std::size_t{asking.size} * asking.size));
  if (!asking.wants("primary") && !asking.wants("shadow")) return;
  const std::vector<scene::Hit> hits = first_hits("primary", primary(asking.size));
  if (!asking.wants("shadow")) return;

  const Queries queries = shadow(hits);
  boost::container::vector<bool> blocked(queries.size());
  const std::vector<Ray32> rays = rays_of(queries, true);
  std::vector<Hit32> hits32(rays.size());
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  const Asked asked{rays, hits32, context};
  compare(n, "shadow", queries.size(), 1,
          {{"Durero fast",
            [&] {
              fast->occluded_segments(queries, {blocked.data(), blocked.size()});
            }},
           {"Embree types, single", [&] { occluded_single(native->scene(), asked); }},
           {"Embree types, packets", [&] { occluded_packets(native->scene(), asked); }},
           {"Embree callbacks, single", [&] { occluded_single(callbacks->scene(), asked); }}});
  compare_threads(n, "shadow", queries.size(), [&] {
    fast->occluded_segments(queries, {blocked.data(), blocked.size()});
  });
}

}  // namespace

/// A whole number above 0, which is the whole text; else the program ends.
std::uint32_t whole_number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
  if (error == std::errc() && end == text.end() && value > 0) return value;
  std::fprintf(stderr, "embree_bench: %s: expected [--size SIZE] [--rays primary|incoherent|shadow] [ELEMENTS...]\n",
               text.data());
  std::exit(2);
}

int main(int argc, char** argv) {
  std::vector<std::size_t> sizes;
  Asking asking;
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--size" && i + 1 < argc) {
      asking.size = whole_number(argv[++i]);
    } else if (word == "--rays" && i + 1 < argc) {
      asking.kind = argv[++i];
      if (asking.kind != "primary" && asking.kind != "incoherent" && asking.kind != "shadow") whole_number(asking.kind);
    } else {
      sizes.push_back(whole_number(word));
    }
  }
  if (sizes.empty()) sizes = {10, 1000, 100000, 1000000};
  const RTCDevice device = rtcNewDevice(nullptr);
  for (const std::size_t n : sizes) run(device, n, asking);
  rtcReleaseDevice(device);
}
