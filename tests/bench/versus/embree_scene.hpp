#pragma once
/// A scene of Embree 3: of its own types, or of callbacks.

#include <embree3/rtcore.h>

#include <array>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "versus/scenes.hpp"

namespace durero::versus {

/// How Embree has the elements.
enum class Kind {
  types,         ///< spheres, cones of linear curves that are open at both ends, triangles
  robust,        ///< the same in a scene with Embree's robust flag
  callbacks,     ///< a quadratic in binary64, ray by ray
  tuned_single,  ///< a quadratic about the nearest point of the line, vectorised over a packet, in binary32
  tuned_double   ///< the same in binary64
};

/// A geometry of callbacks: its functions, and their user data, which is the structure itself.
struct Callbacks {
  const void* elements;  ///< as the functions read them
  RTCIntersectFunctionN intersect;
  RTCOccludedFunctionN occlude;
  std::shared_ptr<const void> held{};     ///< owns the elements, where they are not the scene's
  const CurvedElement* curved = nullptr;  ///< for their bounds
};
Callbacks plain_callbacks(const std::vector<CurvedElement>& elements);
Callbacks tuned_callbacks(const std::vector<CurvedElement>& elements, bool in_binary64);

/// A committed scene. The elements must outlive it.
class EmbreeScene {
 public:
  EmbreeScene(RTCDevice device, const BenchScene& scenes, Kind kind);
  ~EmbreeScene() { rtcReleaseScene(scene_); }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCScene scene() const { return scene_; }

 private:
  void attach(RTCGeometry geometry);
  void add_spheres(RTCDevice device, const std::vector<CurvedElement>& elements);
  void add_curves(RTCDevice device, const std::vector<CurvedElement>& elements);
  void add_triangles(RTCDevice device, const std::vector<std::array<glm::dvec3, 3>>& triangles);
  void add_callbacks(RTCDevice device, const std::vector<CurvedElement>& elements, Kind kind);

  RTCScene scene_;
  Callbacks callbacks_{};
};

}  // namespace durero::versus
