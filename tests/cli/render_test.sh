# durero render: the same picture by every engine that a picture can be drawn with, and the refusals.
. "$(dirname "$0")/harness.sh"
sample >scene.json

run 0 render scene.json -o analytic.png --engine analytic
empty out
empty err
for engine in exact analytic; do
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
finish
