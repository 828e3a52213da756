# durero raster: the pictures of each technique, the same bytes by any number of threads and any engine; the refusals.
. "$(dirname "$0")/harness.sh"
cat >blocks.json <<'END'
{"format":"durero-scene","version":1,"camera":{"eye":[0,3,-6],"look_at":[0,0,0],"up":[0,1,0],"fov_y":45},"resolution":[48,32],
"lights":[{"position":[3,5,-3],"color":[0.8,0.8,0.8]}],"background":[0.2,0.4,0.8],
"materials":{"sheet":{"color":[0.1,0,0],"k_t":0.5,"M_T":[1,0.5,0.5]},"red":{"color":[0.9,0.1,0.1]}},
"elementos":[
{"id":"floor.1","tipo":"triangulo","vertices":[[-4,0,-4],[-4,0,4],[4,0,4]],"material":"red"},
{"id":"floor.2","tipo":"triangulo","vertices":[[-4,0,-4],[4,0,4],[4,0,-4]],"material":"red"},
{"id":"sail","tipo":"triangulo","vertices":[[-1,1,0],[1,1,0.5],[0,2,-1]]}]}
END
sed 's/"vertices":\[\[-1,1,0\]/"material":"sheet",&/' blocks.json >sheets.json
cat >room.json <<'END'
{"format":"durero-scene","version":1,"camera":{"eye":[0,1,-6],"look_at":[0,1,0],"up":[0,1,0],"fov_y":45},"resolution":[48,32],
"lights":[{"position":[3,5,-3],"color":[0.8,0.8,0.8]}],"materials":{"glass":{"color":[0,0,0],"k_ps":0.9}},
"elementos":[{"id":"ball","tipo":"esfera","centro":[0.5,1,0],"radio":0.5},
{"id":"glass","tipo":"disco","centro":[0,1,2],"radio":1,"vector":[0.6,0,-0.8],"material":"glass"}]}
END
for technique in shadows weiler depth-map; do
  run 0 raster $technique blocks.json -o $technique.png
  same shadows-rays.png $technique-rays.png
  has out "$technique: 3 polygons, "
  run 0 raster $technique blocks.json -o other.png --threads 1 --engine exact
  same $technique.png other.png
  same $technique-difference.png other-difference.png
done
same shadows-rays.png shadows.png
same shadows-rays.png weiler.png
run 0 raster shadows blocks.json -o all.png
has out '3 polygons, 6 pairs of them projected, 1 shadow polygon; 0 of 1536 pixels differ from rays, by at most 0 of 255'

# A drawing of areas; one picture of three; means of finer pixels.
run 0 raster shadows blocks.json -o blocks.svg
has blocks.svg '<svg xmlns='
absent blocks-rays.png
run 0 raster weiler blocks.json -o lit.svg
has lit.svg '</svg>'
run 0 raster shadows blocks.json -o beside.png --beside --samples 4
absent beside-rays.png

# The test without a bias, and a picture that is thrown.
run 0 raster depth-map blocks.json -o stripes.png --map 32 --bias none
has out 'depth maps of six pictures of 32x32, bias none'
run 0 raster projected blocks.json -o thrown.png --picture shadows.png --towards 0,0,0 --angle 40
has out 'predicted in the middle'

# Transparent polygons, and a mirror.
run 0 raster transparent sheets.json -o sheets.png
same sheets-rays.png sheets.png
has out '3 polygons, 1 of them transparent, drawn by depth; 0 of 1536'
run 0 raster mirror room.json -o room.png --mirror glass --max-depth 2
same room-rays.png room.png
has out 'mirror: the mirror glass by a second camera'

# What is refused leaves no file.
refused 'new.jpg: not a picture' raster depth-map blocks.json -o new.jpg
refused 'new.svg: not a picture' raster transparent sheets.json -o new.svg
refused 'room.json: element ball is of the type esfera; expected triangles alone' raster shadows room.json -o new.png
refused 'sheets.json: element sail is seen through' raster weiler sheets.json -o new.png
refused 'room.json: element ball mirrors nothing' raster mirror room.json -o new.png --mirror ball
refused 'room.json: no element is called none' raster mirror room.json -o new.png --mirror none
refused 'raster shadows: --samples 3: no square number' raster shadows blocks.json -o new.png --samples 3
refused 'raster depth-map: --bias much: no such bias' raster depth-map blocks.json -o new.png --bias much
refused 'blocks.json: it is no picture' raster projected blocks.json -o new.png --picture blocks.json
refused 'absent.json: cannot be read' raster shadows absent.json -o new.png
for name in new.png new-rays.png new-difference.png new.svg new.jpg; do absent $name; done
finish
