// Durero and Embree on the same scenes and rays, interleaved, on one thread: how long a build takes, millions of rays a
// second, and how many times Embree's rate is Durero's; then how many times its own rate Durero's is on two threads, of
// the time that passes. Durero's `fast` is right, and gives what it is asked for: the elements that are met first, or
// these with t and the point rounded; Embree's answers are not judged here.
//   embree_bench [--scene curved|mesh|soup] [--rays primary|incoherent|shadow] [--size SIZE]... [ELEMENTS...]
//                    size² rays, 1024², of every kind, on 10³, 10⁵ and 10⁶ curved elements, unless told
//
// Curved elements are a third each of spheres, cylinders and cones in the unit cube; a mesh is a wavy sheet of
// triangles; a soup has triangles at random (versus/scenes.hpp). Embree is asked ray by ray and in packets of 8 and of
// 16: by its own types, by these in a robust scene, and for curved elements by callbacks, of one ray in binary64, and
// tuned ones that are vectorised over the packet in binary32 and in binary64 (versus/tuned.cpp). Each rate is the best
// of some turns, in which each takes its own.
#include <embree3/rtcore.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <algorithm>
#include <boost/container/vector.hpp>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "durero/engine/engine.hpp"
#include "versus/embree_scene.hpp"
#include "versus/scenes.hpp"

using namespace durero;
using namespace durero::versus;

namespace {

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

template <class Rays>
void set(Rays& rays, std::size_t lane, const Ray32& from) {
  rays.org_x[lane] = from.p[0], rays.org_y[lane] = from.p[1], rays.org_z[lane] = from.p[2];
  rays.dir_x[lane] = from.v[0], rays.dir_y[lane] = from.v[1], rays.dir_z[lane] = from.v[2];
  rays.tnear[lane] = from.from, rays.tfar[lane] = from.to, rays.time[lane] = 0;
  rays.mask[lane] = ~0U, rays.flags[lane] = 0;
}

/// The rays that Embree is asked, and the places of its answers.
struct Asked {
  const std::vector<Ray32>& rays;
  std::vector<Hit32>& hits;
  bool segments, coherent;
};

RTCIntersectContext context_of(const Asked& asked) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (asked.coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

void ask_single(RTCScene scene, const Asked& asked) {
  RTCIntersectContext context = context_of(asked);
  for (std::size_t i = 0; i < asked.rays.size(); ++i) {
    RTCRayHit hit;
    set(hit.ray, asked.rays[i]);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    if (asked.segments) {
      rtcOccluded1(scene, &context, &hit.ray);
    } else {
      rtcIntersect1(scene, &context, &hit);
    }
    asked.hits[i] = {hit.ray.tfar, hit.hit.geomID, hit.hit.primID};
  }
}

/// A packet's functions.
template <std::size_t width>
struct Packet;
template <>
struct Packet<8> {
  using Hits = RTCRayHit8;
  static constexpr auto intersect = rtcIntersect8;
  static constexpr auto occluded = rtcOccluded8;
};
template <>
struct Packet<16> {
  using Hits = RTCRayHit16;
  static constexpr auto intersect = rtcIntersect16;
  static constexpr auto occluded = rtcOccluded16;
};

template <std::size_t width>
void ask_packets(RTCScene scene, const Asked& asked) {
  RTCIntersectContext context = context_of(asked);
  for (std::size_t at = 0; at < asked.rays.size(); at += width) {
    const std::size_t count = std::min(width, asked.rays.size() - at);
    alignas(64) int valid[width];
    typename Packet<width>::Hits hit;
    for (std::size_t lane = 0; lane < width; ++lane) {
      valid[lane] = lane < count ? -1 : 0;
      set(hit.ray, lane, asked.rays[at + (lane < count ? lane : 0)]);
      hit.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    if (asked.segments) {
      Packet<width>::occluded(valid, scene, &context, &hit.ray);
    } else {
      Packet<width>::intersect(valid, scene, &context, &hit);
    }
    for (std::size_t lane = 0; lane < count; ++lane)
      asked.hits[at + lane] = {hit.ray.tfar[lane], hit.hit.geomID[lane], hit.hit.primID[lane]};
  }
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
  std::printf("%8zu  %-10s  %-32s %8.2f Mrays/s   %5.2f times one thread's\n", n, kind, "Durero fast, two threads",
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
    std::printf("%8zu  %-10s  %-32s %8.2f Mrays/s", n, kind, c.name.c_str(), static_cast<double>(rays) / c.best / 1e6);
    if (i >= first) std::printf("   Durero is");
    for (std::size_t own = 0; i >= first && own < first; ++own)
      std::printf("%s %5.2f", own == 0 ? "" : ",", c.best / contestants[own].best);
    std::printf(i >= first ? " of it\n" : "\n");
  }
  std::fflush(stdout);
}

/// The choice of scenes and rays to compare.
struct Asking {
  std::string scene = "curved", rays{};
  std::vector<std::uint32_t> sizes{};
  std::vector<std::size_t> elements{};
  bool wants(const char* kind) const { return rays.empty() || rays == kind; }
};

/// An Embree scene to ask, in these ways.
struct Peer {
  const char* name;
  Kind kind;
  bool packets;
  std::unique_ptr<EmbreeScene> scene{};
};

std::vector<Peer> peers_of(const std::string& scene) {
  std::vector<Peer> peers;
  peers.push_back({"types", Kind::types, true});
  peers.push_back({"robust", Kind::robust, true});
  if (scene != "curved") return peers;
  peers.push_back({"callbacks", Kind::callbacks, false});
  peers.push_back({"tuned, binary32", Kind::tuned_single, true});
  peers.push_back({"tuned, binary64", Kind::tuned_double, true});
  return peers;
}

/// Durero's contestants, then Embree's.
std::vector<Contestant> with_peers(std::vector<Contestant> contestants, const std::vector<Peer>& peers,
                                   const Asked& asked) {
  for (const Peer& peer : peers) {
    const RTCScene scene = peer.scene->scene();
    const std::string name = std::string("Embree ") + peer.name;
    contestants.push_back({name + ", single", [=, &asked] { ask_single(scene, asked); }});
    if (!peer.packets) continue;
    contestants.push_back({name + ", by 8", [=, &asked] { ask_packets<8>(scene, asked); }});
    contestants.push_back({name + ", by 16", [=, &asked] { ask_packets<16>(scene, asked); }});
  }
  return contestants;
}

/// Builds both, and says how long it takes and what Durero's tree is like.
std::unique_ptr<const engine::Engine> built(RTCDevice device, const BenchScene& scenes, std::vector<Peer>& peers) {
  const std::size_t n = scenes.durero.size();
  const engine::EngineRow* row = engine::find("fast");
  std::unique_ptr<const engine::Engine> fast;
  double building = HUGE_VAL;
  std::vector<double> own(peers.size(), HUGE_VAL);
  for (int turn = 0; turn < turns; ++turn) {
    fast.reset();
    building = std::min(building, seconds([&] { fast = row->prepare(scenes.durero); }));
    for (std::size_t i = 0; i < peers.size(); ++i) {
      peers[i].scene.reset();
      own[i] = std::min(
          own[i], seconds([&] { peers[i].scene = std::make_unique<EmbreeScene>(device, scenes, peers[i].kind); }));
    }
  }
  std::printf("%8zu  build       Durero %.1f ms", n, 1e3 * building);
  for (std::size_t i = 0; i < peers.size(); ++i) std::printf("; Embree %s %.1f", peers[i].name, 1e3 * own[i]);
  std::printf("\n");
  const engine::Figures figures = row->measure(scenes.durero, incoherent(10000));
  const accel::Work& work = figures.work;
  const auto a_ray = [&](std::uint64_t all) { return static_cast<double>(all) / static_cast<double>(work.rays); };
  std::printf("%8zu  size        %.1f bytes an element, %zu nodes, depth %zu\n", n,
              static_cast<double>(figures.size.bytes) / static_cast<double>(n), figures.size.nodes, figures.size.depth);
  std::size_t of_mesh = 0;
  const scene::Meshes& meshes = scenes.durero.meshes();
  for (std::size_t i = 0; i < meshes.size(); ++i)
    of_mesh += meshes[i].puntos.bytes() + meshes[i].caras.capacity() * sizeof(model::Cara);
  if (of_mesh > 0)
    std::printf("%8zu  size        %.1f bytes an element with the mesh\n", n,
                static_cast<double>(figures.size.bytes + of_mesh) / static_cast<double>(n));
  std::printf("%8zu  incoherent  a ray alone: %.1f nodes, %.1f boxes, of which %.1f met, %.1f candidates\n", n,
              a_ray(work.nodes), a_ray(work.volumes), a_ray(work.volumes - work.by_miss), a_ray(work.candidates));
  return fast;
}

void compare_first_hits(const engine::Engine& fast, const std::vector<Peer>& peers, std::size_t n, const char* kind,
                        const Queries& queries) {
  std::vector<scene::Hit> hits(queries.size());
  std::vector<trace::FirstElement> elements(queries.size());
  const std::vector<Ray32> rays = rays_of(queries, false);
  std::vector<Hit32> hits32(rays.size());
  const Asked asked{rays, hits32, false, std::string_view(kind) == "primary"};
  compare(n, kind, queries.size(), 2,
          with_peers({{"Durero fast, elements", [&] { fast.first_elements(queries, elements); }},
                      {"Durero fast, rounded", [&] { fast.first_hits(queries, hits); }}},
                     peers, asked));
  compare_threads(n, kind, queries.size(), [&] { fast.first_elements(queries, elements); });
}

void compare_shadows(const engine::Engine& fast, const std::vector<Peer>& peers, std::size_t n,
                     const Queries& queries) {
  boost::container::vector<bool> blocked(queries.size());
  const auto own = [&] { fast.occluded_segments(queries, {blocked.data(), blocked.size()}); };
  const std::vector<Ray32> rays = rays_of(queries, true);
  std::vector<Hit32> hits32(rays.size());
  const Asked asked{rays, hits32, true, true};
  compare(n, "shadow", queries.size(), 1, with_peers({{"Durero fast", own}}, peers, asked));
  compare_threads(n, "shadow", queries.size(), own);
}

void run(RTCDevice device, std::size_t wanted, const Asking& asking) {
  const BenchScene scenes = asking.scene == "mesh"   ? mesh_scene(wanted)
                            : asking.scene == "soup" ? soup_scene(wanted)
                                                     : curved_scene(wanted);
  const std::size_t n = scenes.durero.size();
  std::vector<Peer> peers = peers_of(asking.scene);
  const auto fast = built(device, scenes, peers);
  for (const std::uint32_t size : asking.sizes) {
    std::printf("%8zu  %u x %u rays\n", n, size, size);
    if (asking.wants("incoherent"))
      compare_first_hits(*fast, peers, n, "incoherent", incoherent(std::size_t{size} * size));
    if (asking.wants("primary")) compare_first_hits(*fast, peers, n, "primary", primary(size));
    if (asking.wants("shadow")) compare_shadows(*fast, peers, n, shadow(engine::first_hits(*fast, primary(size))));
  }
}

[[noreturn]] void refuse(std::string_view text) {
  std::fprintf(stderr,
               "embree_bench: %.*s: expected [--scene curved|mesh|soup] [--rays primary|incoherent|shadow] "
               "[--size SIZE]... [ELEMENTS...]\n",
               static_cast<int>(text.size()), text.data());
  std::exit(2);
}

/// A whole number above 0, which is the whole text; else the program ends.
std::uint32_t whole_number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
  if (error == std::errc() && end == text.end() && value > 0) return value;
  refuse(text);
}

Asking asked(std::vector<std::string_view> words) {
  Asking asking;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string_view word = words[i];
    if (!word.starts_with("--")) {
      asking.elements.push_back(whole_number(word));
      continue;
    }
    if (++i == words.size()) refuse(word);
    if (word == "--size") {
      asking.sizes.push_back(whole_number(words[i]));
    } else if (word == "--scene" && (words[i] == "curved" || words[i] == "mesh" || words[i] == "soup")) {
      asking.scene = words[i];
    } else if (word == "--rays" && (words[i] == "primary" || words[i] == "incoherent" || words[i] == "shadow")) {
      asking.rays = words[i];
    } else {
      refuse(words[i]);
    }
  }
  if (asking.sizes.empty()) asking.sizes = {1024};
  if (asking.elements.empty()) asking.elements = {1000, 100000, 1000000};
  return asking;
}

/// The version of Embree, and the instruction set that it and Durero take here.
void print_versions(RTCDevice device) {
  const auto version = rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_VERSION);
  std::printf("Embree %ld.%ld.%ld; this machine has %s\n", version / 10000, version / 100 % 100, version % 100,
              __builtin_cpu_supports("avx512dq") ? "AVX-512"
              : __builtin_cpu_supports("avx2")   ? "AVX2"
                                                 : "SSE");
}

}  // namespace

int main(int argc, char** argv) {
  const Asking asking = asked({argv + 1, argv + argc});
  const RTCDevice device = rtcNewDevice(nullptr);
  print_versions(device);
  for (const std::size_t n : asking.elements) run(device, n, asking);
  rtcReleaseDevice(device);
}
