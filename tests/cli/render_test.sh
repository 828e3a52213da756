# durero render: the same picture by every engine that a picture can be drawn with, and the refusals.
tree=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
. "$(dirname "$0")/harness.sh"
sample >scene.json

run 0 render scene.json -o analytic.png --engine analytic
empty out
empty err
for engine in exact analytic fast; do
  for threads in 1 3; do
    run 0 render scene.json -o other.png --engine $engine --threads $threads
    same analytic.png other.png
  done
done

# A picture shows more than its background: the one of the scene without its elements is another.
sed '/"tipo"/d' scene.json >empty.json
run 0 render empty.json -o empty.png
checks=$((checks + 1))
cmp -s analytic.png empty.png && fail 'the elements are not in the picture'

# Shadows start on elements, and the sampled oracle cannot tell a surface that a ray leaves from one that it meets.
echo kept >old.png
for out in new.png old.png; do
  refused '--engine sampled: ' render scene.json -o $out --engine sampled
done
absent new.png
is old.png kept

refused 'picture.jpg: not a picture' render scene.json -o picture.jpg
sed '/"camera"/d' scene.json >blind.json
for out in new.png old.png; do
  refused 'blind.json: ' render blind.json -o $out
done
absent new.png
is old.png kept

# How many rays in a row: as the materials need, or as the file or the call says.
mirrors=$tree/demo/mirrors.json
run 0 render "$mirrors" -o deep.png --size 64x36 --engine analytic
run 0 render "$mirrors" -o exact.png --size 64x36 --engine exact
same deep.png exact.png
run 0 render "$mirrors" -o seven.png --size 64x36 --max-depth 7
same deep.png seven.png
run 0 render "$mirrors" -o one.png --size 64x36 --max-depth 1
mkdir said
sed 's/"max_depth":7/"max_depth":1/' "$mirrors" >said/mirrors.json
run 0 render said/mirrors.json -o said.png --size 64x36
same one.png said.png
checks=$((checks + 1))
cmp -s deep.png one.png && fail 'no mirror is in the picture'
refused 'render: --max-depth 1000000: no whole number from 1 to 1000' render "$mirrors" -o new.png --max-depth 1000000
refused 'render: --max-depth 0: no whole number' render "$mirrors" -o new.png --max-depth 0
absent new.png

# What counts too little is not followed, and what that cost is said.
run 0 render "$mirrors" -o light.png --size 64x36 --min-weight 0.05
lines out 1
has out ' of 7, '
has out 'left out: at most 0.'
checks=$((checks + 1))
cmp -s deep.png light.png && fail 'nothing is left out'
run 0 render "$mirrors" -o none.png --size 64x36 --min-weight 0
has out 'left out: at most 0 of a linear component'
same deep.png none.png
refused 'render: --min-weight 1.5: no number from 0 to 1' render "$mirrors" -o new.png --min-weight 1.5
absent new.png

# --size draws in another size than the scene's, --crop a rectangle of the picture, pixel for pixel.
run 0 render scene.json -o whole.png --size 40x30
run 0 render scene.json -o crop.png --size 40x30 --crop 12,9,17,14
run 0 render scene.json -o all.png --size 40x30 --crop 0,0,40,30
same all.png whole.png
run 0 render scene.json -o own.png --crop 0,0,8,6
same own.png analytic.png
sed '/"resolution"/d' scene.json >sizeless.json
run 0 render sizeless.json -o sizeless.png --crop 635,355,5,5  # of 640 x 360
checks=$((checks + 1))
python3 - <<'PYTHON' || fail 'a crop is not what stands there in the picture'
import struct, zlib
def pixels(name):
    data, at, idat = open(name, "rb").read(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR": width, height = struct.unpack(">II", body[:8])
        if kind == b"IDAT": idat += body
        at += 12 + length
    raw, rows, before, at = zlib.decompress(idat), [], bytes(3 * width), 0
    for _ in range(height):  # each row is filtered in a way of its own (PNG, 9.2)
        how, row = raw[at], bytearray(raw[at + 1:at + 1 + 3 * width])
        for i in range(len(row)):
            a, b, c = (row[i - 3] if i >= 3 else 0), before[i], (before[i - 3] if i >= 3 else 0)
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[i] = (row[i] + (0, a, b, (a + b) // 2, paeth)[how]) % 256
        rows.append(bytes(row))
        before, at = row, at + 1 + 3 * width
    return width, height, rows
width, height, whole = pixels("whole.png")
assert (width, height) == (40, 30)
width, height, crop = pixels("crop.png")
assert (width, height) == (17, 14)
assert crop == [row[3 * 12:3 * 29] for row in whole[9:23]]
assert len(set(whole)) > 10
assert pixels("sizeless.png")[:2] == (5, 5)
PYTHON

for size in 0x6 8x0 8 8x 8x6x4 8X6 -8x6 8.5x6 65536x1 99999999999x1 'x6' ''; do
  refused "render: --size $size: no size; expected WxH" render scene.json -o new.png --size "$size"
done
for crop in 0,0,0,1 0,0,1,0 0,0,1 0,0,1,1,1 -1,0,1,1 a,0,1,1 0,0,1,1x 0x0x1x1; do
  refused "render: --crop $crop: no rectangle; expected X,Y,W,H" render scene.json -o new.png --crop "$crop"
done
for crop in 8,0,1,1 0,6,1,1 1,0,8,1 0,1,1,6 65535,65535,65535,65535; do
  refused "render: --crop $crop: it is not inside the picture; expected pixels of 8x6" \
    render scene.json -o new.png --crop "$crop"
done
absent new.png

# A picture carries along what draws it again: no folder, no time, no engine, and what is left open as it was.
run 0 render scene.json -o analytic.png --size 8x6 --engine analytic --threads 2 --min-weight 0 --tone clamp --samples 1
has analytic.png 'durero render scene.json --size 8x6 --max-depth 1'
run 0 render scene.json -o again.png --size 8x6 --max-depth 1
same analytic.png again.png
cp scene.json "it's mine.json"
run 0 render ./"it's mine.json" -o crop.png --size 40x30 --crop 12,9,17,14 --tone reinhard
has crop.png "durero render 'it'\\''s mine.json' --size 40x30 --crop 12,9,17,14 --max-depth 1 --tone reinhard"

# The tones differ, and OpenEXR has none.
for tone in max reinhard; do
  run 0 render "$mirrors" -o $tone.png --size 64x36 --tone $tone
  checks=$((checks + 1))
  cmp -s $tone.png deep.png && fail "--tone $tone is no other"
done
refused 'render: --tone dim: no such tone; expected one of clamp, max, reinhard' \
  render scene.json -o new.png --tone dim
refused '--tone max: new.exr holds linear light; expected OUT.png' render scene.json -o new.exr --tone max
refused '--aov: new.png has no such channels; expected OUT.exr' render scene.json -o new.png --aov
run 0 render scene.json -o one.exr --aov
run 0 render scene.json -o two.exr --aov --engine exact --threads 3
same one.exr two.exr
run 0 render scene.json -o plain.exr
checks=$((checks + 1))
[ "$(wc -c <plain.exr)" -lt "$(wc -c <one.exr)" ] || fail 'the channels are not in the file'
absent new.exr

# Samples: the same bytes whatever the threads and the engine; and calls that make no sense.
for how in '--samples 4' '--sampling stratified --samples 4' '--sampling independent --samples 5' \
  '--sampling net --samples 5' '--integrator path --samples 5' \
  '--integrator path --sampling grid --samples 4' '--sampling statistical --samples 40 --width 0.2'; do
  run 0 render scene.json -o one.png $how --threads 1
  run 0 render scene.json -o three.png $how --threads 3 --engine exact
  same one.png three.png
  checks=$((checks + 1))
  cmp -s one.png analytic.png && fail "$how: no other picture"
done
lines out 1
has out ' rays from the eye a pixel; '
has out ' of 48 pixels not known within 0.2 with confidence 0.95'
refused '--samples 5: no square number; expected 1, 4, 9' render scene.json -o new.png --samples 5
refused '--min-weight: of one integrator alone; expected --integrator whitted' \
  render scene.json -o new.png --integrator path --min-weight 0.1
refused 'render: --integrator radiosity: no such integrator; expected one of whitted, path' \
  render scene.json -o new.png --integrator radiosity
refused '--samples 1: too few to tell anything; expected 4 or more' \
  render scene.json -o new.png --samples 1 --sampling statistical
refused '--width: of one sampling alone; expected --sampling statistical' render scene.json -o new.png --width 0.1
refused '--confidence: of one sampling alone' render scene.json -o new.png --confidence 0.9
for width in 0 1 -1 nan x; do
  refused "render: --width $width: no number from 0 to 1, neither of them; expected one" \
    render scene.json -o new.png --sampling statistical --width $width
done

run 0 render scene.json -o one.png --sampling allotted --samples 40 --threads 1
lines out 1
has out ' rays from the eye a pixel'
run 0 render scene.json -o three.png --sampling allotted --samples 40 --threads 3 --engine exact
same one.png three.png
refused '--samples 3: too few to tell anything; expected 4 or more with --sampling allotted' \
  render scene.json -o new.png --samples 3 --sampling allotted

# Lens, shutter, a light of some size and gloss: the same bytes whatever the threads and the engine, others by another seed,
# and the note of a picture draws it again.
sed -e 's/"fov_y":\([0-9.]*\)/"fov_y":\1,"aperture":0.5,"shutter":1,"motion":[0.25,0,0]/' scene.json >blurred.json
run 0 render blurred.json -o one.png --samples 9 --threads 1
run 0 render blurred.json -o three.png --samples 9 --threads 3 --engine exact
same one.png three.png
run 0 render blurred.json -o other.png --samples 9 --seed 7
has other.png '--samples 9 --seed 7'
checks=$((checks + 1))
cmp -s one.png other.png && fail 'another seed draws no other picture'
run 0 render blurred.json -o path.png --integrator path
has path.png '--integrator path --max-depth 1000 --sampling net --samples 1'
refused 'render: --seed -1: ' render blurred.json -o new.png --seed -1
absent new.png

# Shadows of glass: the text's without a word, and others by a word, which the note keeps.
sed -e 's/"materials":{/"materials":{"pane":{"color":[0,0,0],"k_d":0,"k_t":0.9,"M_T":[1,0.5,0.25]},/' \
  -e 's/"elementos":\[/"elementos":[{"id":"pane-1","tipo":"plano","centro":[0,7,0],"vector":[0,1,0],"material":"pane"},/' \
  scene.json >pane.json
run 0 render pane.json -o one.png
run 0 render pane.json -o three.png --shadows opaque
same one.png three.png
run 0 render pane.json -o other.png --shadows coloured --threads 1
run 0 render pane.json -o three.png --shadows coloured --threads 3 --engine exact
same other.png three.png
has other.png '--shadows coloured'
checks=$((checks + 1))
cmp -s one.png other.png && fail 'coloured shadows draw no other picture'
refused 'render: --shadows grey: no such rule of shadows; expected one of opaque, coloured' \
  render scene.json -o new.png --shadows grey
refused '--shadows coloured: of rays that are lines alone; expected no --rays' \
  render scene.json -o new.png --shadows coloured --rays cones
absent new.png

# A preview: k passes are the same picture whenever it ends, the file is whole at any time, and an interrupted one is kept.
run 0 render scene.json -o first.png --preview --samples 1
is out '1 pass'
run 0 render scene.json -o passes.png --preview --samples 3
is out '3 passes'
has passes.png '--preview --samples 3'
refused 'render: --sampling excludes --preview' render scene.json -o new.png --preview --sampling grid
absent new.png
"$durero" render scene.json -o shown.png --preview >out 2>err </dev/null &
preview=$!
tries=0
until [ -s shown.png ] || [ $tries -ge 300 ]; do sleep 0.1; tries=$((tries + 1)); done
kill -INT $preview
wait $preview
got=$?
called='render --preview, interrupted'
checks=$((checks + 1))
[ $got = 0 ] || fail "$called: status $got, expected 0"
passes=$(sed -n 's/ pass.*//p' out)
run 0 render scene.json -o counted.png --preview --samples "${passes:-0}"
same shown.png counted.png
for left in shown.png.*; do absent "$left"; done
finish
