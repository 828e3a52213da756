"""Asks Embree 4 by rtcIntersect1."""

import ctypes
import math
import os
import sys

sys.path.append(os.path.join(os.path.dirname(__file__), ".."))
import protocol  # isort: skip
from rtcore import (CONE_LINEAR_CURVE, FLAGS, FLOAT3, FLOAT4, INDEX, NONE, NORMAL, OF_FORMAT, ORIENTED_DISC_POINT, ROBUST,
                    SPHERE_POINT, TRIANGLE, UCHAR, UINT, UINT3, VERSION, VERTEX, RayHit, rtc)

OPEN = 3  # The curve has neighbours at both ends, and so no caps.
device = rtc.rtcNewDevice(None)


def geometry(kind, *buffers):
    made = rtc.rtcNewGeometry(device, kind)
    for buffer, form, items in buffers:
        kind = OF_FORMAT[form]
        place = rtc.rtcSetNewGeometryBuffer(made, buffer, 0, form, ctypes.sizeof(kind), len(items))
        for i, item in enumerate(items):
            (kind * len(items)).from_address(place)[i] = kind(*item) if isinstance(item, tuple) else item
    rtc.rtcCommitGeometry(made)
    return made


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


def load(elements):
    scene = rtc.rtcNewScene(device)
    rtc.rtcSetSceneFlags(scene, ROBUST)
    for element in elements:
        made = shape(element)
        rtc.rtcAttachGeometry(scene, made)
        rtc.rtcReleaseGeometry(made)
    rtc.rtcCommitScene(scene)
    error = rtc.rtcGetDeviceError(device)
    if error:
        raise RuntimeError(f"RTCError {error}")
    memory = ctypes.create_string_buffer(ctypes.sizeof(RayHit) + 16)
    hit = RayHit.from_address((ctypes.addressof(memory) + 15) // 16 * 16)

    def first(p, v):
        hit.org, hit.dir, hit.tnear, hit.tfar, hit.mask, hit.geomID = p, v, 0, math.inf, NONE, NONE
        rtc.rtcIntersect1(scene, ctypes.addressof(hit), None)
        return None if hit.geomID == NONE else (elements[hit.geomID].name, hit.tfar)

    def ask(rays):
        claims = protocol.each(first)(rays)
        rtc.rtcReleaseScene(scene)
        return claims

    ask.memory = memory
    return ask


version = rtc.rtcGetDeviceProperty(device, VERSION)
protocol.serve("Embree", f"{version // 10000}.{version // 100 % 100}.{version % 100}", load)
