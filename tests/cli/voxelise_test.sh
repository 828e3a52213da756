# durero voxelise: a scene as a mosaic of cubes.
. "$(dirname "$0")/harness.sh"
sample >scene.json

# The cubes of the surface are the same with and without what is inside.
run 0 voxelise scene.json --depth 6
empty err
has out '{"format":"durero-mosaic","version":1,"file":"scene.json","elementos":3,'
has out '"filling":"surface","depth":6,"cube":{"low":'
has out '"conservative":["cilindro","cono"],'
grep '"surface":\[' out | sed 's/,$//;s/\(\]}\)\]$/\1/' >hollow
grep -q '"inside":\[' out && fail 'something is inside a surface'
run 0 voxelise scene.json --depth 6 --solid -o solid.json
empty out
grep '"surface":\[' solid.json | sed 's/,$//;s/\(\]}\)\]$/\1/' >solid
same hollow solid
grep '"inside":\[' solid.json >within
checks=$((checks + 1))
[ "$(wc -l <within)" -gt 20 ] || fail "only $(wc -l <within) cubes lie inside the sphere"
grep -qv '"inside":\["s1"\]' within && fail 'a cube lies inside what encloses nothing'
has solid.json "\"volume\":{\"surface\":$(wc -l <solid),\"inside\":"

# What text is written at once does not show.
run 0 voxelise scene.json --depth 10 -o long.json
checks=$((checks + 1))
[ "$(wc -c <long.json)" -gt 2000000 ] || fail "the mosaic is too short to be written in parts"
python3 - <<'PYTHON' || fail 'the mosaic is not as it says'
import json
said = json.load(open("long.json"))
codes = [voxel["code"] for voxel in said["voxels"]]
assert codes == sorted(set(codes)) and {len(code) for code in codes} == {10}
assert said["volume"] == {"surface": len(codes), "inside": 0}
PYTHON
refused "<stdin>:1:1: the text is empty" voxelise - --depth 6

# A cube with a surface counts as that, also where it lies inside another sphere.
cat >nested.json <<'JSON'
{"format":"durero-scene","version":1,"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":2},
{"id":"b","tipo":"esfera","centro":[0,0,0],"radio":1}]}
JSON
run 0 voxelise nested.json --depth 5 --solid
has out '"surface":["b"],"inside":["a"]}'
has out "\"volume\":{\"surface\":$(grep -c '"surface":\[' out),\"inside\":"

echo '{"format":"durero-scene","version":1,"elementos":[{"id":"p","tipo":"plano","centro":[0,0,0],"vector":[0,0,1]}]}' >plane.json
run 0 voxelise plane.json --depth 3
has out '"apart":["p"],"conservative":[],'
has out '"volume":{"surface":0,"inside":0}}'
refused 'voxelise: --depth 18: no whole number from 0 to 17; expected one' voxelise scene.json --depth 18
refused 'voxelise: --depth -1' voxelise scene.json --depth=-1
refused 'absent.json: cannot be read' voxelise absent.json --depth 3 -o there
absent there
finish
