# durero render --rays: rays that are more than lines, and what each of them refuses.
tree=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
. "$(dirname "$0")/harness.sh"
sample >scene.json

# Beams: the picture is that of rays, byte for byte, and the tree is drawn.
beams=$tree/demo/gallery/beams.json
run 0 render "$beams" -o lines.png --size 96x54
empty out
for threads in 1 3; do
  run 0 render "$beams" -o beams.png --size 96x54 --rays beams --tree tree.svg --threads $threads
  is out '1086 regions, up to 4 beams in a row; the areas of the first add up to 5184 pixels; 0 rays on lines'
  empty err
  same lines.png beams.png
done
has tree.svg 'viewBox="-0.5 -0.5 96 54"'
lines tree.svg 1088
run 0 render "$beams" -o lines.png --size 96x54 --rays lines
same lines.png beams.png
run 0 render "$beams" -o lines.png --size 96x54 --crop 20,10,30,20
run 0 render "$beams" -o beams.png --size 96x54 --crop 20,10,30,20 --rays beams
has out 'add up to 600 pixels'
same lines.png beams.png

refused 'scene.json: element s1 is neither a triangle nor a plane' render scene.json -o new.png --rays beams
refused 'render: --rays cubes: ' render "$beams" -o new.png --rays cubes
refused '--samples 4: of rays that are lines' render "$beams" -o new.png --rays beams --samples 4
refused '--sampling stratified: of rays that are lines' render "$beams" -o new.png --rays beams --sampling stratified
refused '--min-weight 0.1: of rays that are lines' render "$beams" -o new.png --rays beams --min-weight 0.1
refused '--rays: of one integrator alone' render "$beams" -o new.png --rays beams --integrator path
refused '--preview: of rays that are lines' render "$beams" -o new.png --rays beams --preview
refused '--tree: of one kind of rays' render "$beams" -o new.png --tree new.svg
refused '--tree new.txt: not a drawing' render "$beams" -o new.png --rays beams --tree new.txt
echo kept >old.svg
refused 'scene.json: element ' render scene.json -o new.png --rays beams --tree old.svg
is old.svg kept
absent new.png
absent new.svg

# Cones: those of no angle are rays, others are the same for every number of threads.
cones=$tree/demo/gallery/cones.json
sed 's/,"sphere":{"radius":[0-9.]*}//g; s/,"gloss":[0-9]*//' "$cones" >bare.json
run 0 render bare.json -o lines.png --size 64x36
run 0 render bare.json -o cones.png --size 64x36 --rays cones --spread 0
same lines.png cones.png
run 0 render "$cones" -o cones.png --size 48x27 --rays cones --threads 1
empty out
run 0 render "$cones" -o other.png --size 48x27 --rays cones --threads 3
same cones.png other.png
run 0 render "$cones" -o other.png --size 48x27 --rays cones --crop 10,5,20,15
refused 'scene.json: element c1 is no sphere, plane or triangle' render scene.json -o new.png --rays cones
refused '--spread: of one kind of rays' render scene.json -o new.png --spread 1
refused 'render: --spread -1: ' render scene.json -o new.png --rays cones --spread -1
refused '--sampling stratified: of rays that are lines' render "$cones" -o new.png --rays cones --sampling stratified
refused '--samples 5: no square number' render "$cones" -o new.png --rays cones --samples 5
absent new.png

# Pencils: the same for every number of threads, and more light than without them.
glass=$tree/demo/gallery/glass-ball.json
run 0 render "$glass" -o without.png --size 64x36
run 0 render "$glass" -o pencils.png --size 64x36 --rays pencils --threads 1
has out ' pencils, '
has out 'left out: 0.0'
run 0 render "$glass" -o other.png --size 64x36 --rays pencils --threads 3
same pencils.png other.png
checks=$((checks + 1))
cmp -s pencils.png without.png && fail 'pencils bring no light'
refused 'scene.json: no light shines on a finite element with k_ps or k_t' render scene.json -o new.png --rays pencils
refused '--rays: of one integrator alone' render "$glass" -o new.png --rays pencils --integrator path
refused '--preview: not with pencils' render "$glass" -o new.png --rays pencils --preview
absent new.png
finish
