# Geant4 11-04-patch-01: missed
# Expected e0 at t = 64.00000279026067, point (-0.3047889317186677, 0.3092262677864596, 0.9008194364721724); got a miss.
# the exact answer: e0 at t = 64.00000279026067
# e0:
#   t = 64.00000279026066689099156832667627145455
#     = 43311969165724781812027195117982874032982682464/676749508639027422615047228687763644902270303 + 356811923176489970264571492362373784095686656/676749508639027422615047228687763644902270303·√(2506560116973732862347227298967067559248368335/196159429230833773869868419475239575503198607639501078528)
# e0.base:
#   t = 64.92083507955685537872396514931366695822
#     = 39689149231893856/611346868586287
# the first point:
#   x = -0.3047889317186677466810736731405910931477
#   y = 0.3092262677864596002028104213681234389865
#   z = 0.9008194364721724341957380946491949547818
#
# pip install geant4-pybind && python near-apex.py
import builtins
import math

builtins.input = lambda _: "n"  # the import asks whether to fetch data of physics, which no solid needs
import geant4_pybind as g4


def placed(solid, middle, *columns):
    """The solid, and the transform into its frame."""
    rotation = g4.G4RotationMatrix()
    if columns:
        rotation.rotateAxes(*(g4.G4ThreeVector(*column) for column in columns))
    return solid, g4.G4AffineTransform(rotation.inverse(), g4.G4ThreeVector(*middle)).Inverse()


solids = [
    placed(g4.G4Cons("e0", 0, 2.0, 0, 0.0, 0.5, 0, 2 * math.pi),
           (-0.15239842236042023, 0.15461322665214539, 0.4504103362560272),
           (0.951125785880156, 0.0495845024385205, 0.30479684472084045), (0.0495845024385205, 0.949694886631898, -0.30922645330429077), (-0.30479684472084045, 0.30922645330429077, 0.9008206725120544)),
]
p = g4.G4ThreeVector(-123.70097351074219, 16.86876106262207, 30.618922233581543)
v = g4.G4ThreeVector(0.9640326274426937, -0.12937135691801477, -0.23217266254907834)  # v/|v|

hits = []
for solid, to_solid in solids:
    at, along = to_solid.TransformPoint(p), to_solid.TransformAxis(v)
    side = solid.Inside(at)
    enters = side == g4.kSurface and solid.SurfaceNormal(at).dot(along) < 0
    distance = solid.DistanceToOut if side == g4.kInside or enters else solid.DistanceToIn
    hits.append((distance(at, along), solid.GetName()))
distance, name = min(hits)
print("got: miss" if distance >= 9.0e99 else f"got: hit {name} {distance!r}")
print("expected: hit e0 128.0000085747707")
