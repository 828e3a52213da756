"""The part of Embree 4's API that is asked, through ctypes: the library lies in the embreex wheel."""

import ctypes
import glob
import importlib.util
import os

TRIANGLE, CONE_LINEAR_CURVE, SPHERE_POINT, ORIENTED_DISC_POINT = 0, 15, 50, 52  # RTCGeometryType
INDEX, VERTEX, NORMAL, FLAGS = 0, 1, 3, 32  # RTCBufferType
UCHAR, UINT, UINT3, FLOAT3, FLOAT4 = 0x1001, 0x5001, 0x5003, 0x9003, 0x9004  # RTCFormat
ROBUST, VERSION, NONE = 4, 0, 0xFFFFFFFF  # RTC_SCENE_FLAG_ROBUST, RTC_DEVICE_PROPERTY_VERSION, RTC_INVALID_GEOMETRY_ID
OF_FORMAT = {UCHAR: ctypes.c_ubyte, UINT: ctypes.c_uint, UINT3: ctypes.c_uint * 3, FLOAT3: ctypes.c_float * 3,
             FLOAT4: ctypes.c_float * 4}

folder = os.path.dirname(importlib.util.find_spec("embreex").origin) + "/../embreex.libs/"
ctypes.CDLL(glob.glob(folder + "libtbb*")[0], mode=ctypes.RTLD_GLOBAL)
rtc = ctypes.CDLL(glob.glob(folder + "libembree4*")[0])
pointer, number = ctypes.c_void_p, ctypes.c_uint
for name, result, *arguments in [
    ("NewDevice", pointer, ctypes.c_char_p), ("GetDeviceProperty", ctypes.c_ssize_t, pointer, number),
    ("GetDeviceError", number, pointer), ("NewScene", pointer, pointer), ("SetSceneFlags", None, pointer, number),
    ("NewGeometry", pointer, pointer, number), ("AttachGeometry", number, pointer, pointer),
    ("SetNewGeometryBuffer", pointer, pointer, number, number, number, ctypes.c_size_t, ctypes.c_size_t),
    ("CommitGeometry", None, pointer), ("ReleaseGeometry", None, pointer), ("CommitScene", None, pointer),
    ("ReleaseScene", None, pointer), ("Intersect1", None, pointer, pointer, pointer),
    ("Occluded1", None, pointer, pointer, pointer),
]:
    function = getattr(rtc, "rtc" + name)
    function.restype, function.argtypes = result, arguments


class RayHit(ctypes.Structure):
    _fields_ = [("org", ctypes.c_float * 3), ("tnear", ctypes.c_float), ("dir", ctypes.c_float * 3),
                ("time", ctypes.c_float), ("tfar", ctypes.c_float), ("mask", number), ("id", number),
                ("flags", number), ("normal_u_v", ctypes.c_float * 5), ("primID", number), ("geomID", number),
                ("instID", number * 2)]
