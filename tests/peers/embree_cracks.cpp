// embree_cracks [RAYS]: rays from inside closed meshes at their edges and vertices, as near as binary32 allows, through
// this tracer and through Embree's triangles with its robust flag: how many escape. Every number of meshes and rays is
// a binary32, so both are asked the same. Exit status 1 where this tracer loses a ray; 77 (skipped) where Embree is
// absent (Debian: libembree-dev). What Embree loses is counted and judged by nobody.
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "durero/trace/analytic.hpp"
#include "support/meshes.hpp"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>

using namespace durero;
using namespace durero::test;

namespace {

float near_float(Random& random, double x) {
  const float nearest = static_cast<float>(x);
  const int way = random.integer(-1, 1);
  return way == 0 ? nearest : std::nextafter(nearest, static_cast<float>(way) * HUGE_VALF);
}

glm::dvec3 near_floats(Random& random, const glm::dvec3& v) {
  const float x = near_float(random, v.x), y = near_float(random, v.y), z = near_float(random, v.z);
  return {x, y, z};
}

Mesh float_mesh(Random& random) {
  Mesh mesh = rough_mesh(random, 2);
  for (glm::dvec3& vertex : mesh.vertices) vertex = glm::dvec3(glm::vec3(vertex));
  return mesh;
}

/// Embree's scene of a mesh.
class Peer {
 public:
  explicit Peer(const Mesh& mesh) : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.vertices.size()));
    for (const glm::dvec3& v : mesh.vertices)
      for (int i = 0; i < 3; ++i) *vertex++ = static_cast<float>(v[i]);
    auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                 3 * sizeof(unsigned), mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles)
      for (const unsigned i : triangle) *index++ = i;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~Peer() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  bool is_hit_by(const model::Rayo& rayo) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    const glm::vec3 p(rayo.p().xyz()), v(rayo.v().xyz());
    ray.ray.org_x = p.x, ray.ray.org_y = p.y, ray.ray.org_z = p.z;
    ray.ray.dir_x = v.x, ray.ray.dir_y = v.y, ray.ray.dir_z = v.z;
    ray.ray.tfar = HUGE_VALF;
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &ray);
    return ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace

int main(int argc, char** argv) {
  const std::size_t rays = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000, rays_a_mesh = 50'000;
  std::size_t asked = 0, lost = 0, lost_by_peer = 0;
  for (std::uint64_t seed = 1; asked < rays; ++seed) {
    Random random(seed);
    const Mesh mesh = float_mesh(random);
    std::vector<scene::Query> queries;
    for (std::size_t i = 0; i < rays_a_mesh; ++i) {
      const glm::dvec3 p(glm::vec3(random.in_cube(0.125))), at = any_edge_point(random, mesh, 1 << 20).on(mesh);
      queries.push_back({{model::Punto(p), model::Vector(near_floats(random, at - p))}, {}});
    }
    asked += queries.size();
    const scene::Scene scene = scene_of(mesh);
    const trace::Tables tables(scene);
    for (const scene::Hit& hit : trace::first_hits(tables, queries)) lost += hit.resultado != model::Resultado::hit;
    const Peer peer(mesh);
    for (const scene::Query& query : queries) lost_by_peer += !peer.is_hit_by(query.rayo);
  }
  std::cout << asked << " rays at edges and vertices from inside: durero lost " << lost << ", Embree (robust) "
            << lost_by_peer << '\n';
  return lost == 0 ? 0 : 1;
}

#else

int main() {
  std::cout << "skipped: Embree is absent (Debian: libembree-dev)\n";
  return 77;
}

#endif
