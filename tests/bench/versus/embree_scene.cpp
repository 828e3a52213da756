#include "versus/embree_scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace durero::versus {
namespace {

void* new_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t width, std::size_t size) {
  return rtcSetNewGeometryBuffer(geometry, type, 0, format, width, size);
}

void store(float* to, const glm::dvec3& x) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(x[i]);
}
void store(float* to, const glm::dvec3& x, double radius) {
  store(to, x);
  to[3] = static_cast<float>(radius);
}

void bound(const RTCBoundsFunctionArguments* call) {
  const CurvedElement& e = static_cast<const Callbacks*>(call->geometryUserPtr)->curved[call->primID];
  float* low = &call->bounds_o->lower_x;
  float* high = &call->bounds_o->upper_x;
  const glm::dvec3 along = e.b - e.a;
  const double squared = glm::dot(along, along);
  for (int i = 0; i < 3; ++i) {
    const double share = squared > 0 ? std::sqrt(std::max(0.0, 1 - along[i] * along[i] / squared)) : 1;
    const double least = std::min(e.a[i] - e.radius * share, e.b[i] - e.top * share);
    const double greatest = std::max(e.a[i] + e.radius * share, e.b[i] + e.top * share);
    low[i] = std::nextafter(static_cast<float>(least), -HUGE_VALF);
    high[i] = std::nextafter(static_cast<float>(greatest), HUGE_VALF);
  }
}

}  // namespace

EmbreeScene::EmbreeScene(RTCDevice device, const BenchScene& scenes, Kind kind) : scene_(rtcNewScene(device)) {
  if (kind == Kind::robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  if (!scenes.triangles.empty()) {
    add_triangles(device, scenes.triangles);
  } else if (kind == Kind::types || kind == Kind::robust) {
    add_spheres(device, scenes.curved);
    add_curves(device, scenes.curved);
  } else {
    add_callbacks(device, scenes.curved, kind);
  }
  rtcCommitScene(scene_);
}

void EmbreeScene::attach(RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::add_spheres(RTCDevice device, const std::vector<CurvedElement>& elements) {
  std::vector<const CurvedElement*> own;
  for (const CurvedElement& e : elements)
    if (e.tipo == model::Tipo::soy_esfera) own.push_back(&e);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* vertex = static_cast<float*>(new_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, own.size()));
  for (std::size_t i = 0; i < own.size(); ++i) store(vertex + 4 * i, own[i]->a, own[i]->radius);
  attach(geometry);
}

void EmbreeScene::add_curves(RTCDevice device, const std::vector<CurvedElement>& elements) {
  std::vector<const CurvedElement*> own;
  for (const CurvedElement& e : elements)
    if (e.tipo != model::Tipo::soy_esfera) own.push_back(&e);
  if (own.empty()) return;
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
  const std::size_t n = own.size();
  auto* vertex = static_cast<float*>(new_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 16, 2 * n));
  auto* index = static_cast<unsigned*>(new_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, 4, n));
  auto* flags = static_cast<unsigned char*>(new_buffer(geometry, RTC_BUFFER_TYPE_FLAGS, RTC_FORMAT_UCHAR, 1, n));
  for (std::size_t i = 0; i < n; ++i) {
    store(vertex + 8 * i, own[i]->a, own[i]->radius);
    store(vertex + 8 * i + 4, own[i]->b, own[i]->top);
    index[i] = static_cast<unsigned>(2 * i);
    flags[i] = RTC_CURVE_FLAG_NEIGHBOR_LEFT | RTC_CURVE_FLAG_NEIGHBOR_RIGHT;
  }
  attach(geometry);
}

void EmbreeScene::add_triangles(RTCDevice device, const std::vector<std::array<glm::dvec3, 3>>& triangles) {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  const std::size_t n = triangles.size();
  auto* vertex = static_cast<float*>(new_buffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 12, 3 * n));
  auto* index = static_cast<unsigned*>(new_buffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, 12, n));
  for (std::size_t i = 0; i < 3 * n; ++i) {
    store(vertex + 3 * i, triangles[i / 3][i % 3]);
    index[i] = static_cast<unsigned>(i);
  }
  attach(geometry);
}

void EmbreeScene::add_callbacks(RTCDevice device, const std::vector<CurvedElement>& elements, Kind kind) {
  callbacks_ =
      kind == Kind::callbacks ? plain_callbacks(elements) : tuned_callbacks(elements, kind == Kind::tuned_double);
  callbacks_.curved = elements.data();
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(elements.size()));
  rtcSetGeometryUserData(geometry, &callbacks_);
  rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
  rtcSetGeometryIntersectFunction(geometry, callbacks_.intersect);
  rtcSetGeometryOccludedFunction(geometry, callbacks_.occlude);
  attach(geometry);
}

}  // namespace durero::versus
