# Textures and environments: pictures that a scene names, from its folder; the same picture by every engine and number of
# threads; durero environment; the refusals.
. "$(dirname "$0")/harness.sh"
mkdir pictures
cat >pictures/plain.json <<'END'
{"format":"durero-scene","version":1,"camera":{"eye":[0,1,-4],"look_at":[0,0,0],"up":[0,1,0],"fov_y":50},
"lights":[{"position":[3,5,-4],"color":[1,1,1]}],"background":[0.2,0.4,0.8],"materials":{"red":{"color":[0.9,0.1,0.1]}},
"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1,"material":"red"}]}
END
run 0 render pictures/plain.json -o pictures/even.png --size 32x32
run 0 render pictures/plain.json -o pictures/odd.png --size 15x9

cat >pictures/worn.json <<'END'
{"format":"durero-scene","version":1,"camera":{"eye":[0,2,-6],"look_at":[0,0.5,0],"up":[0,1,0],"fov_y":45},"resolution":[48,32],
"lights":[{"position":[3,5,-4],"color":[1,1,1]}],
"environment":{"equirectangular":"odd.png"},
"textures":{
"even":{"image":"even.png","filter":"mipmap","near":2,"repeat":[3,2]},
"odd":{"image":"odd.png","repeat":[4,4],"curve":"linear"},
"p6m":{"p6m":[[1,1,1],[0.1,0.2,0.3]],"repeat":[2,2]}},
"materials":{
"ball":{"color":[1,1,1],"textures":{"color":"even"},"bump":{"texture":"odd","height":0.05}},
"floor":{"color":[0.9,0.9,0.9],"k_ps":0.4,"textures":{"color":"p6m","k_ps":"odd"}}},
"elementos":[
{"id":"a","tipo":"esfera","centro":[0,1,0],"radio":1,"material":"ball"},
{"id":"b","tipo":"cilindro","centro":[2,0,0],"radio":0.6,"vector":[0,1,0],"altura":2,"material":"ball"},
{"id":"floor","tipo":"plano","centro":[0,0,0],"vector":[0,1,0],"material":"floor"}]}
END
run 0 render pictures/worn.json -o worn.png --engine analytic
for engine in exact fast bvh; do
  for threads in 1 3; do
    run 0 render pictures/worn.json -o other.png --engine $engine --threads $threads
    same worn.png other.png
  done
done
(cd pictures && "$durero" render worn.json -o ../other.png)
same worn.png other.png
# Each of them is in the picture.
for part in 's/"textures":{"color":"even"},//' 's/,"bump":{[^}]*}//' 's/"textures":{"color":"p6m","k_ps":"odd"}/"k_d":1/' \
  '/"environment"/d' 's/"filter":"mipmap","near":2,//'; do
  sed "$part" pictures/worn.json >pictures/less.json
  run 0 render pictures/less.json -o less.png
  checks=$((checks + 1))
  cmp -s worn.png less.png && fail "$part changes nothing"
done
# Other commands need no pictures, and edit keeps what is said of them.
cp pictures/worn.json alone.json
run 0 check alone.json
run 0 edit alone.json -o kept.json
has kept.json '"environment":{"equirectangular":"odd.png"}'
has kept.json '"even":{"image":"even.png","repeat":[3,2],"filter":"mipmap","near":2}'
has kept.json '"textures":{"color":"even"},"bump":{"texture":"odd","height":0.05}'

# From another folder it names the same pictures, and the picture is the same; so do import and export.
mkdir elsewhere
run 0 edit pictures/worn.json -o elsewhere/worn.json
has elsewhere/worn.json '"environment":{"equirectangular":"../pictures/odd.png"}'
has elsewhere/worn.json '"even":{"image":"../pictures/even.png","repeat":[3,2],"filter":"mipmap","near":2}'
run 0 render elsewhere/worn.json -o other.png
same worn.png other.png
run 0 export elsewhere/worn.json -o worn.json
has worn.json '"equirectangular":"pictures/odd.png"'
run 0 import worn.json -o pictures/again.json
has pictures/again.json '"equirectangular":"odd.png"'

refused 'alone.json:5:17: image is "even.png": No such file or directory; expected' render alone.json -o new.png
absent new.png
sed 's/even.png/odd.png/' pictures/worn.json >pictures/bad.json
refused 'pictures/bad.json:5:17: image is "odd.png": it has 15 by 9 texels; expected 2ⁿ by 2ⁿ for a mipmap' \
  render pictures/bad.json -o new.png
sed 's/even.png/plain.json/' pictures/worn.json >pictures/bad.json
refused 'pictures/bad.json:5:17: image is "plain.json": it is no picture' render pictures/bad.json -o new.png
head -c 60 pictures/even.png >pictures/cut.png
sed 's/even.png/cut.png/' pictures/worn.json >pictures/bad.json
refused 'pictures/bad.json:5:17: image is "cut.png": libpng: ' render pictures/bad.json -o new.png
head -c -12 pictures/even.png >pictures/cut.png
refused 'pictures/bad.json:5:17: image is "cut.png": it ends before its end chunk, IEND' render pictures/bad.json -o new.png
absent new.png

# A scene without elements is its environment, in another layout; and back it is what it was, but for its texels.
echo '{"format":"durero-scene","version":1,"environment":{"gradient":[[1,0,0],[0,0,1]]},"elementos":[]}' >sky.json
run 0 environment sky.json -o box.png --as box --width 16
empty out
for face in px nx py ny pz nz; do
  checks=$((checks + 1))
  [ -s box-$face.png ] || fail "no box-$face.png"
done
absent box.png
same box-px.png box-nx.png
echo '{"format":"durero-scene","version":1,"environment":{"box":["box-px.png","box-nx.png","box-py.png","box-ny.png","box-pz.png","box-nz.png"]},"elementos":[]}' >box.json
for kind in equirectangular spherical; do
  run 0 environment box.json -o $kind.png --as $kind --width 32
  run 0 environment box.json -o other.png --as $kind --width 32 --threads 1
  same $kind.png other.png
done
# From another point a scene looks otherwise.
run 0 environment pictures/plain.json -o here.png --as equirectangular --width 32 --from 0,0,-3
run 0 environment pictures/plain.json -o there.png --as equirectangular --width 32 --from=-3,0,0
checks=$((checks + 1))
cmp -s here.png there.png && fail 'two points see the same'

refused 'environment: --from 1,2: no point; expected X,Y,Z' environment sky.json -o new.png --as box --from 1,2
refused 'environment: --as cube: no such environment' environment sky.json -o new.png --as cube
refused 'environment: --width 0: no whole number from 1 to 8192' environment sky.json -o new.png --as box --width 0
refused 'new.jpg: not a picture' environment sky.json -o new.jpg --as spherical
refused '--engine sampled: ' environment sky.json -o new.png --as spherical --engine sampled
refused 'absent.json: cannot be read' environment absent.json -o new.png --as box
absent new.png
absent new-px.png
finish
