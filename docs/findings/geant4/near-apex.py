# Geant4 11-04-patch-01: missed
# Expected e0 at t = 7.9999999947636455, point (0.9912939147341485, 0.1365375449710824, 0.3160660288468041); got a miss.
# the exact answer: e0 at t = 7.9999999947636455
# e0:
#   t = 7.999999994763645901163787227518216708871
#     = 13371876473250547411578452568485279027645739692/1671484579021161844955672649187517877810816663 + 356811923176489970264571492362373784095686656/1671484579021161844955672649187517877810816663·√(4447184876009365515051096341297573884025026807/25108406941546723055343157692830665664409421777856138051584)
# e0.base:
#   t = 8.79624462434117097665077353612848208611
#     = 3263055323291612/370960047457299
# the first point:
#   x = 0.9912939147341485624339357063872289039663
#   y = 0.1365375449710824051757968202350243841166
#   z = 0.3160660288468041193155811741737100885176
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
    placed(g4.G4Cons("e0", 0, 2.0987653732299805, 0, 0.0, 0.5246913433074951, 0, 2 * math.pi),
           (0.49564701620965934, 0.06826878460303831, 0.15803295261783035),
           (0.3142027569188025, -0.09445944944307598, -0.9446449279785156), (-0.09445944944307598, 0.9869894671069236, -0.13011227548122406), (0.9446449279785156, 0.13011227548122406, 0.3011922240257263)),
]
p = g4.G4ThreeVector(12.554486274719238, -10.418593406677246, 3.6148223876953125)
v = g4.G4ThreeVector(-0.7226995218278813, 0.6596956838653468, -0.2061722722365551)  # v/|v|

hits = []
for solid, to_solid in solids:
    at, along = to_solid.TransformPoint(p), to_solid.TransformAxis(v)
    side = solid.Inside(at)
    enters = side == g4.kSurface and solid.SurfaceNormal(at).dot(along) < 0
    distance = solid.DistanceToOut if side == g4.kInside or enters else solid.DistanceToIn
    hits.append((distance(at, along), solid.GetName()))
distance, name = min(hits)
print("got: miss" if distance >= 9.0e99 else f"got: hit {name} {distance!r}")
print("expected: hit e0 16.00000001485955")
