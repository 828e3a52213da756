// Embree 3.13.5 open: misplaced
// Expected e1 at t = 27.06713520062746, point (-73.86572959874508, 0, 0), outward normal (-0.8664369843452723, 0.35344020625376016, 0.35265701859167625), front; got e1 at t = 26.679790496826172, normal (-240662200320, 98171822080, 97954283520).
// Cone curves are met at another t where |v| is not 1, though RTCRay says that the direction does not have to be normalized.
// the exact answer: e1 at t = 27.06713520062746
// e1:
//   t = 27.06713520062746173226869667341545629454
//     = 64 − 316912650057057350374175801344/951641845695224870090159381809·√(951641845695224870090159381809/77371252455336267181195264)
// the first point:
//   x = -73.86572959874507653546260665316908741092
//   y = 0
//   z = 0
//
// c++ -std=c++17 -O2 curve-direction.cpp -lembree3 && ./a.out
#include <embree3/rtcore.h>

#include <cstdio>
#include <limits>

static float* floats(RTCGeometry geometry, RTCBufferType type, RTCFormat format, int width, int count) {
  return static_cast<float*>(rtcSetNewGeometryBuffer(geometry, type, 0, format, 4 * width, count));
}

static unsigned* indices(RTCGeometry geometry, RTCFormat format, int width) {
  return static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, format, 4 * width, 1));
}

static void copy(const double* from, int count, float* to) {
  for (int i = 0; i < count; ++i) to[i] = float(from[i]);
}

int main() {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  const char* names[1];
  {
    names[0] = "e1";
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_CONE_LINEAR_CURVE);
    const double ends[] = {0.0, 0.0, 0.0, 64.0,
                           -127.81732940673828, -157.01571655273438, -156.66778564453125, 64.0};
    copy(ends, 8, floats(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 4, 2));
    indices(geometry, RTC_FORMAT_UINT, 1)[0] = 0;
    void* flags = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_FLAGS, 0, RTC_FORMAT_UCHAR, 1, 1);
    *static_cast<unsigned char*>(flags) = RTC_CURVE_FLAG_NEIGHBOR_LEFT | RTC_CURVE_FLAG_NEIGHBOR_RIGHT;
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, 0);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene);

  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit rayhit{};
  rayhit.ray.org_x = float(-128.0), rayhit.ray.org_y = float(0.0), rayhit.ray.org_z = float(0.0);
  rayhit.ray.dir_x = float(2.0), rayhit.ray.dir_y = float(0.0), rayhit.ray.dir_z = float(0.0);
  rayhit.ray.tfar = std::numeric_limits<float>::infinity();
  rayhit.ray.mask = ~0U;
  rayhit.hit.geomID = rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &rayhit);

  if (rayhit.hit.geomID == RTC_INVALID_GEOMETRY_ID)
    std::puts("got: miss");
  else
    std::printf("got: hit %s %.9g\n", names[rayhit.hit.geomID], rayhit.ray.tfar);
  std::puts("expected: hit e1 27.06713520062746");
}
