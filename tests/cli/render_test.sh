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
sed 's/"max_depth":7/"max_depth":1/' "$mirrors" >one.json
run 0 render one.json -o said.png --size 64x36
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
finish
