"""Asks Embree 4 by rtcIntersect1, and of shadow rays by rtcOccluded1; the argument `mesh` makes one geometry of triangles."""

import ctypes
import math
import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
from rtcore import (CONE_LINEAR_CURVE, FLAGS, FLOAT3, FLOAT4, INDEX, NONE, NORMAL, OF_FORMAT, ORIENTED_DISC_POINT, ROBUST,
                    SPHERE_POINT, TRIANGLE, UCHAR, UINT, UINT3, VERSION, VERTEX, RayHit, rtc)

is_mesh = sys.argv[1:] == ["mesh"]
OPEN = 3  # The curve has neighbours at both ends, and so no caps.
device = rtc.rtcNewDevice(None)


def geometry(kind, *buffers):
    handle = rtc.rtcNewGeometry(device, kind)
    for buffer, form, items in buffers:
        item_type = OF_FORMAT[form]
        place = rtc.rtcSetNewGeometryBuffer(handle, buffer, 0, form, ctypes.sizeof(item_type), len(items))
        for i, item in enumerate(items):
            (item_type * len(items)).from_address(place)[i] = item_type(*item) if isinstance(item, tuple) else item
    rtc.rtcCommitGeometry(handle)
    return handle


def shape(element):
    if element.tipo == "triangulo":
        return geometry(TRIANGLE, (VERTEX, FLOAT3, element.vertices), (INDEX, UINT3, [(0, 1, 2)]))
    if element.tipo == "esfera":
        return geometry(SPHERE_POINT, (VERTEX, FLOAT4, [(*element.centro, element.radio)]))
    if element.tipo == "disco":
        disc = (*element.centro, element.radio)
        return geometry(ORIENTED_DISC_POINT, (VERTEX, FLOAT4, [disc]), (NORMAL, FLOAT3, [element.vector]))
    base, top = element.radii()
    advances = zip((-element.altura, 0, element.altura, 2 * element.altura), (base, base, top, top))
    ends = [(*element.along(advance), radius) for advance, radius in advances]
    return geometry(CONE_LINEAR_CURVE, (VERTEX, FLOAT4, ends), (INDEX, UINT, [1]), (FLAGS, UCHAR, [OPEN]))


def one_mesh(elements):
    points, faces = protocol.mesh(elements)
    return geometry(TRIANGLE, (VERTEX, FLOAT3, points), (INDEX, UINT3, faces))


class Scene:
    """A scene, and a ray that is asked again and again."""

    def __init__(self, elements):
        self.elements, self.scene = elements, scene_of(elements)
        self.memory = ctypes.create_string_buffer(ctypes.sizeof(RayHit) + 16)
        self.hit = RayHit.from_address((ctypes.addressof(self.memory) + 15) // 16 * 16)

    def __del__(self):
        rtc.rtcReleaseScene(self.scene)

    def set(self, p, v, begin, end):
        hit = self.hit
        hit.org, hit.dir, hit.tnear, hit.tfar, hit.mask, hit.geomID = p, v, begin, end, NONE, NONE
        return ctypes.addressof(hit)

    def first(self, p, v, begin=0, end=math.inf):
        rtc.rtcIntersect1(self.scene, self.set(p, v, begin, end), None)
        if self.hit.geomID == NONE:
            return None
        met = self.elements[self.hit.primID if is_mesh else self.hit.geomID]
        *normal, u, v = self.hit.normal_u_v
        besides = {"normal": normal, "uv": (u, v)} if met.tipo == "triangulo" else {"normal": normal}
        return met.name, self.hit.tfar, besides

    def is_hit(self, p, v, end):
        rtc.rtcOccluded1(self.scene, self.set(p, v, 0, end), None)
        return self.hit.tfar < 0


def scene_of(elements):
    scene = rtc.rtcNewScene(device)
    rtc.rtcSetSceneFlags(scene, ROBUST)
    for handle in [one_mesh(elements)] if is_mesh else map(shape, elements):
        rtc.rtcAttachGeometry(scene, handle)
        rtc.rtcReleaseGeometry(handle)
    rtc.rtcCommitScene(scene)
    error = rtc.rtcGetDeviceError(device)
    if error:
        raise RuntimeError(f"RTCError {error}")
    return scene


version = rtc.rtcGetDeviceProperty(device, VERSION)
protocol.serve("Embree", f"{version // 10000}.{version // 100 % 100}.{version % 100}",
               lambda elements: protocol.each(Scene(elements).first), lambda elements: Scene(elements).is_hit,
               lambda elements: Scene(elements).first)
