# durero import, export and convert: NFF there and back, meshes, and what is lost on the way.
. "$(dirname "$0")/harness.sh"
cat >scene.nff <<'TEXT'
b 0.1 0.2 0.3
v
from 0 0 -5
at 0 0 0
up 0 1 0
angle 45
hither 0
resolution 64 48
l 1 2 3 1 1 1
f 1 0.5 0 1 0 0 0 1
s 1 2 3 4
c 0 0 0 2 0 0 3 2
c 1 2 3 0.5 1 6 3 0
TEXT
run 0 import scene.nff -o scene.json
empty out
empty err
run 0 check scene.json
has out '3 elementos: 1 esfera, 1 cilindro, 1 cono, 0 tronco, 0 plano, 0 disco, 0 triangulo'
run 0 export scene.json -o back.nff
lines err 2
has err 'durero: back.nff: 3 names of elements left out: NFF has none'
run 0 import back.nff -o back.json
same scene.json back.json
run 0 export scene.json -o copy.json
same scene.json copy.json
empty err

# What a scene cannot hold is named; the rest is kept. A polygon is cut into triangles.
cat >more.nff <<'TEXT'
f 1 0 0 1 0.5 10 0 1
p 5
0 0 0
4 0 0
4 4 0
2 1 0
0 4 0
p 4 0 0 0 1 1 0 1 0 0 0 1 0
c 0 0 0 2 0 0 3 1
s 0 0 0 1
TEXT
run 0 import more.nff -o more.json
lines err 1
has err 'durero: more.nff: 1 polygon left out: edges touch or cross'
run 0 check more.json
has out '5 elementos: 1 esfera, 0 cilindro, 0 cono, 1 tronco, 0 plano, 0 disco, 3 triangulo'
run 0 edit more.json --op 'Agregar_Disco e?=d centro?=(0,0,0) radio?=1 vector?=(0,0,1)' -o disc.json
run 0 export disc.json -o disc.nff
has err 'durero: disc.nff: 1 disc left out: NFF has none'
run 0 import disc.nff -o back.json
empty err
run 0 check back.json
has out '5 elementos: 1 esfera, 0 cilindro, 0 cono, 1 tronco, 0 plano, 0 disco, 3 triangulo'

# Meshes: a tetrahedron whose base is there twice, once as a triangle of no area.
mkdir meshes
cat >meshes/solid.obj <<'TEXT'
v 0 0 0
v 0.1 0 0
v 0 0.1 0
v 0 0 0.1
f 1 3 2
f 1 1 2
f 1 2 4
f 2 3 4
f 3 1 4
TEXT
# Groups come with it, and are the hierarchy where that is asked for.
{ sed '/^f/d' meshes/solid.obj; printf 'g base\nf 1 3 2\ng sides\nf 1 2 4\nf 2 3 4\nf 3 1 4\n'; } >grouped.obj
run 0 import grouped.obj -o grouped.json --triangles single
empty err
has grouped.json '"base":{"elementos":["grouped.obj:1"]'
has grouped.json '"sides":{"elementos":["grouped.obj:2","grouped.obj:3","grouped.obj:4"]'
run 0 stats grouped.json --engine bvh --hierarchy hand --no-times
has out 'bvh by hand'
run 0 import meshes/solid.obj -o solid.json --triangles single
is err 'durero: meshes/solid.obj: 1 triangle left out: the vertices lie on one line'
is solid.json '{"format":"durero-scene","version":1,
"elementos":[
{"id":"solid.obj:1","tipo":"triangulo","vertices":[[0,0,0],[0,0.1,0],[0.1,0,0]]},
{"id":"solid.obj:3","tipo":"triangulo","vertices":[[0,0,0],[0.1,0,0],[0,0,0.1]]},
{"id":"solid.obj:4","tipo":"triangulo","vertices":[[0.1,0,0],[0,0.1,0],[0,0,0.1]]},
{"id":"solid.obj:5","tipo":"triangulo","vertices":[[0,0.1,0],[0,0,0],[0,0,0.1]]}
]}'
{ printf 'ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nelement face 5\n'
  printf 'property list uchar int vertex_indices\nend_header\n0 0 0\n0.1 0 0\n0 0.1 0\n0 0 0.1\n'
  printf '3 0 2 1\n3 0 0 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n'; } >solid.ply
run 0 import solid.ply -o from_ply.json --triangles single
sed 's/solid.ply/solid.obj/' from_ply.json >renamed.json
same renamed.json solid.json
run 0 check solid.json
has out '4 elementos: 0 esfera, 0 cilindro, 0 cono, 0 tronco, 0 plano, 0 disco, 4 triangulo'
printf '0.02 0.02 0.02 -1 -1 -1\n' >rays.txt
run 0 trace solid.json rays.txt
has out '"elementos":["solid.obj:1","solid.obj:3","solid.obj:5"],"t":0.02,"point":[0,0,0]'
refused 'solid.step: a format that is not known by this name; expected one that ends in .glb or .gltf or .json or .nff' \
  export solid.json -o solid.step
absent solid.step

# Without the option, a format of meshes gives a mesh, and another format its triangles one by one.
run 0 import meshes/solid.obj -o mesh.json
is err 'durero: meshes/solid.obj: 1 triangle left out: the vertices lie on one line'
has mesh.json '"mallas":[
{"id":"solid.obj","puntos":[[0,0,0],[0,0.1,0],[0.1,0,0],[0,0,0.1]],"caras":[[0,1,2],[0,2,3],[2,1,3],[1,0,3]]}
]'
run 0 import meshes/solid.obj -o again.json --triangles mesh
same again.json mesh.json
run 0 trace mesh.json rays.txt
has out '"elementos":["solid.obj:0","solid.obj:1","solid.obj:3"],"t":0.02,"point":[0,0,0]'
run 0 import grouped.obj -o gathered.json
has gathered.json '"base":{"elementos":["grouped.obj:0"]'
printf 'p 3\n0 0 0\n1 0 0\n0 1 0\np 3\n0 0 0\n0 1 0\n0 0 1\n' >two.nff
run 0 import two.nff -o two.json
! grep -q mallas two.json || fail 'two.json has a mesh, expected single triangles'
run 0 import two.nff -o two.json --triangles mesh
has two.json '"mallas"'
refused 'import: --triangles both: no such way; expected one of mesh, single' import two.nff -o three.json --triangles both
absent three.json

# Each format of meshes keeps the triangles: from one to the next, and back to the first text.
for to in obj ply stl; do
  run 0 export solid.json -o "written.$to"
  is err "durero: written.$to: 4 names of elements left out: $(echo $to | tr a-z A-Z) has none"
  run 0 import "written.$to" -o back.json --triangles single
  run 0 export back.json -o again.obj
  same again.obj written.obj
done
# Scenes of other programs keep them as well, in groups of their own, some in files beside the text.
for to in pbrt rad xml; do
  run 0 export solid.json -o "room.$to"
  has err "durero: room.$to: no camera in the scene: no view was written"
  run 0 import "room.$to" -o back.json --triangles single
  run 0 export back.json -o again.obj
  sed '/^g/d' again.obj >ungrouped.obj
  same ungrouped.obj written.obj
done
[ -f room.mesh1.ply ] || fail 'room.mesh1.ply is absent, expected the triangles of room.xml'
cp solid.json guard.mesh1.ply
refused 'guard.mesh1.ply: the scene itself is in the place of a file that goes with its export; expected another name' \
  export guard.mesh1.ply -o guard.xml
same guard.mesh1.ply solid.json
absent guard.xml
run 0 export solid.json -o room.glb
has err 'durero: room.glb: 3 coordinates rounded: glTF has binary32'
run 0 import room.glb -o back.json --triangles single
run 0 check back.json
has out '4 elementos: 0 esfera, 0 cilindro, 0 cono, 0 tronco, 0 plano, 0 disco, 4 triangulo'
run 0 export solid.json -o bytes.ply --binary
is err 'durero: bytes.ply: 4 names of elements left out: PLY has none'
run 0 import bytes.ply -o back.json --triangles single
run 0 export back.json -o again.obj
same again.obj written.obj
run 0 export solid.json -o bytes.stl --binary
has err 'durero: bytes.stl: 9 coordinates rounded: binary STL has binary32'
[ "$(wc -c <bytes.stl)" -eq 284 ] || fail "bytes.stl has $(wc -c <bytes.stl) bytes, expected 84 and 50 for each facet"
run 0 import bytes.stl -o back.json --triangles single
run 0 export back.json -o again.stl --binary
same again.stl bytes.stl
refused 'bytes.obj: no format with a binary form by this name; expected one that ends in .glb or .ply or .stl' \
  export solid.json -o bytes.obj --binary
absent bytes.obj
printf 'v 0 0 0\nv 1 0 0\nf 1 2 3\n' >bad.obj
refused 'bad.obj:3:7: "3" names no vertex; expected 1 to 2, or a distance back to one above' import bad.obj -o bad.json
absent bad.json
printf 'solid' >bad.ply
refused 'bad.ply:1:1: "solid" stands here; expected ply: no PLY file begins otherwise' import bad.ply -o bad.json
absent bad.json

# glTF: a square in a buffer of its own, beside the file and not where the command runs.
mkdir -p scans
printf '\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\077\0\0\0\0\0\0\0\0' >scans/square.bin # 0 0 0, 1 0 0
printf '\0\0\200\077\0\0\200\077\0\0\0\0\0\0\0\0\0\0\200\077\0\0\0\0' >>scans/square.bin # 1 1 0, 0 1 0
cat >scans/square.gltf <<'TEXT'
{"asset":{"version":"2.0"},"nodes":[{"name":"lid","mesh":0,"scale":[1,1,-1],"translation":[0,0,0.5]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":6,"material":0}]}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":4}],
"bufferViews":[{"buffer":0,"byteLength":48}],"buffers":[{"byteLength":48,"uri":"square.bin"}]}
TEXT
run 0 import scans/square.gltf -o square.json --triangles single
is err 'durero: scans/square.gltf: 1 use of a material left out: a scene has none of this kind'
has square.json '"vertices":[[1,0,0.5],[0,0,0.5],[1,1,0.5]]'
has square.json '"lid":{"elementos":["square.gltf:1","square.gltf:2"]}'
run 1 check --mesh scans/square.gltf
has out 'square.gltf:1'
rm scans/square.bin
refused 'scans/square.gltf:4:80: uri is "square.bin": No such file or directory; expected a readable file' \
  import scans/square.gltf -o bad.json
absent bad.json

# POV-Ray: a union is a group, there and back, and a hierarchy beside the automatic one.
cat >table.pov <<'TEXT'
#version 3.7;
union {
  cylinder { <0, 0, 0>, <0, 0.5, 0>, 2 }
  union { sphere { <-1, 2, 0>, 0.25 } sphere { <1, 2, 0>, 0.25 } }
  pigment { rgb <0.5, 0.25, 0> }
}
TEXT
run 0 import table.pov -o table.json
empty err
has table.json '"c1":{"elementos":["c1","c1:base","c1:top"]}'
has table.json '"u2":{"groups":["c1","u1"]}'
run 0 stats table.json --engine bvh --no-times
has out 'bvh                      '
has out 'bvh by hand              '
run 0 export table.json -o again.pov
run 0 import again.pov -o again.json
has again.json '"u1":{"elementos":["c1","d1","d2"]}'
has again.json '"u3":{"groups":["u1","u2"]}'
run 0 stats again.json --engine bvh --hierarchy hand --no-times
printf 'sphere { 0, 1 }\nzzzzz { }\n' >bad.pov
refused 'bad.pov:2:1: "zzzzz" is not read; expected one of sphere, cylinder, ' import bad.pov -o bad.json
absent bad.json

# Names that end in great letters are those of formats too; what is written ends as its format does, or not at all.
cp meshes/solid.obj SOLID.OBJ
run 0 import SOLID.OBJ -o solid.JSON --triangles single
has solid.JSON '"id":"SOLID.OBJ:1"'
cp scene.nff UPPER.NFF
run 0 import UPPER.NFF -o upper
run 0 export upper -o UPPER.POV
run 0 import UPPER.POV -o - # by its name the standard output
for name in y.stl z.nff back.json.old; do
  refused "$name: " import scene.nff -o "$name"
  has err 'is no ending of a scene; expected a name that ends in .json, or has no ending'
  absent "$name"
  refused "$name: " edit scene.json --op 'Eliminar_Esfera e?=s1' -o "$name"
  has err 'is no ending of a scene; expected a name that ends in .json, or has no ending'
  absent "$name"
done
refused 'cubes.ply: ".ply" is no ending of a mosaic; expected a name that ends in .json' voxelise scene.json --depth 2 -o cubes.ply
refused 'hits.csv: ".csv" is no ending of hits; expected a name that ends in .jsonl or .ndjson or .json or .txt or .npy, or has no' \
  trace scene.json rays.txt -o hits.csv
refused 'rays.txt:1:1: rays stand here; expected a scene (JSON), which is named before the rays' trace rays.txt scene.json
absent hits.csv

printf 's 0 0 0 1\ns 0 0 0 0\n' >bad.nff
refused 'bad.nff:2:9: radio_no_positivo; expected radio? ∈ Rmas (Agregar_Esfera.pre.2)' import bad.nff -o bad.json
absent bad.json
# A survey of a folder: how many files are read, what stops the others, and what is left out.
mkdir -p folder/below
printf 'torus { 1, 0.5 } sphere { 0, 1 pigment { rgb 1 } }\n#version 3.7;' >folder/one.pov
printf 'torus { 1, 0.5 } torus { 2, 1 }\n#version 3.7;' >folder/below/two.pov
printf 'void sphere a/b 0 0 4 0 0 0 1' >folder/one.rad
printf 'void sphere a/b 0 0 4 0 0 0 1 void sphere a/c 0 0 4 0 0 0 2' >folder/two.rad
printf 'sphere { Here, 1 }' >folder/three.pov
printf 'sphere {\n There, 1 }' >folder/below/four.POV
echo 'no scene' >folder/notes.txt
run 1 import folder --survey
empty err
cat >expected <<'TEXT'
folder: 4 of 6 files are read
not read: 2 × … in sphere; expected a finite number
  first folder/below/four.POV:2:2: "There" in sphere; expected a finite number
read: in 2 of them, 3 in all: elements in no group: its identifier is no name
read: in 2 of them, 3 in all: surfaces left out: a scene has such by a Z text alone (--with)
TEXT
same expected out
rm folder/three.pov folder/below/four.POV
run 0 import folder --survey
run 2 import nothing --survey
has err 'durero: nothing: no folder; expected one'
run 2 import folder --survey -o scene.json
run 2 import folder
has err 'durero: import: --output: it is missing'

# Scenes of Mitsuba and pbrt: instances are groups, and the triangles of files beside them faces of a mesh.
mkdir -p room/meshes
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >room/meshes/one.obj
cat >room/room.xml <<'TEXT'
<scene version="3.0.0">
<shape type="shapegroup" id="pair"><shape type="sphere"/>
<shape type="obj"><string name="filename" value="meshes/one.obj"/></shape></shape>
<shape type="instance"><ref id="pair"/></shape>
<shape type="instance"><ref id="pair"/><transform name="to_world"><scale x="2"/></transform></shape>
<shape type="torus"/>
</scene>
TEXT
run 0 import room/room.xml -o room.json
has err 'durero: room/room.xml: 1 shape "torus" left out: a scene has none'
has room.json '[0,3,2]]}'
has room.json '"u1":{"elementos":["s1"],"groups":["m1"]}'
printf '0 0 -5 0 0 1\n1.75 0 -5 0 0 1\n' >rays.txt
run 0 trace room.json rays.txt
has out '"t":4,'
sed 's/one.obj/two.obj/' room/room.xml >two.xml
refused 'two.xml:3:43: no file "meshes/two.obj"; expected a file in the folder of the scene or beneath it' \
  import two.xml -o bad.json
cat >room/hall.pbrt <<'TEXT'
Camera "perspective"
WorldBegin
ObjectBegin "ball" Shape "sphere" ObjectEnd
Translate 0 0 3 ObjectInstance "ball"
Shape "curve"
TEXT
run 0 import room/hall.pbrt -o hall.json
has err 'durero: room/hall.pbrt: 1 shape "curve" left out: a scene has none'
has hall.json '"centro":[0,0,3]'
run 0 import room --survey
has out 'room: 3 of 3 files are read'
has out 'read: in 1 of them, 1 in all: shape "curve" left out: a scene has none'
# Any format becomes any other; what one of both does not keep is named.
run 0 convert scene.nff converted.json
same converted.json scene.json
empty err
run 0 convert converted.json converted.pov
run 0 export scene.json -o exported.pov
same converted.pov exported.pov
run 0 convert meshes/solid.obj converted.ply --binary
has err 'durero: meshes/solid.obj: 1 triangle left out: the vertices lie on one line'
has err 'durero: converted.ply: 4 names of elements left out: PLY has none'
run 0 convert converted.ply converted.stl
refused 'scene.step: a format that is not known by this name; expected one that ends in .glb' convert scene.step a.json
refused 'a.step: a format that is not known by this name; expected one that ends in .glb' convert scene.json a.step
absent a.step
printf '{"format":"durero-scene","version":1,"elementos":[{"id":"e","tipo":"instancia","de":{"tipo":"esfera","centro":[0,0,0],"radio":1},"mapa":[[2,0,0,0],[0,1,0,0],[0,0,1,0]]}]}' >copy_of.json
run 0 convert copy_of.json copy_of.nff
has err 'durero: copy_of.nff: 1 instance or solid left out: NFF has none'
! grep -q '^s ' copy_of.nff || fail 'copy_of.nff has a sphere, expected none'

# Files out of the scene's folder are read where a root holds them.
mkdir -p sets/room
echo '#declare R = 2;' >sets/size.inc
echo '#include "../size.inc" sphere { 0, R }' >sets/room/ball.pov
refused 'sets/room/ball.pov:1:1: no file "../size.inc"; expected a file in the folder of the scene or beneath it, or one' \
  import sets/room/ball.pov -o ball.json
run 0 import sets/room/ball.pov -o ball.json --root sets
has ball.json '"radio":2'
run 0 import sets --survey --root sets
has out 'sets: 1 of 1 files are read'
run 1 import sets --survey
refused 'sets/room/ball.pov: lies elsewhere; expected a file in "meshes" or beneath it' \
  import sets/room/ball.pov -o ball.json --root meshes
refused 'none: no folder; expected one' import sets/room/ball.pov -o ball.json --root none
finish
