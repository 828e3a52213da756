# durero stats: what structures cost and save; what is counted is the same at every call.
demo=$(CDPATH='' cd -- "$(dirname -- "$0")/../../demo" && pwd)
. "$(dirname "$0")/harness.sh"
sample >scene.json
printf '0 0 -9 0 0 1\n0 9 0 0 1 0\n' >rays.txt

# Every engine with a structure, a line each below the heads; without times, the same bytes twice.
run 0 stats scene.json
empty err
has out 'scene.json: 3 elementos, 1000 rays'
has out 'break-even'
measured=$(($(sed '/^$/,$d' out | wc -l) - 2))
run 0 stats scene.json --no-times
cp out said
run 0 stats scene.json --no-times
same out said
lines out $((measured + 5))
has out 'hierarchy                  cost   depth   arity    most'
grep -q 'break-even' out && fail 'times where none were asked for'
run 0 stats scene.json --format json --no-times
cp out said
run 0 stats scene.json --format json --no-times
same out said
has out '{"format":"durero-stats","version":1,"file":"scene.json","elementos":3,'
has out '"rays":{"count":1000,"seed":1},'
[ "$(grep -c '"engine":' out)" -eq "$measured" ] || fail 'as text and as JSON there are not the same engines'
grep -q seconds out && fail 'seconds where none were asked for'

# Without a structure each ray is tried against the ball of every element; the others name a section.
run 0 stats scene.json rays.txt --engine analytic --format json
has out '"rays":{"count":2,"file":"rays.txt"},'
has out '"work":{"rays":2,"volumes":6,"nodes":0,"cells":0,"by_miss":0,"by_distance":0,"candidates":1,"repeated":0,"untested":1},'
has out '"seconds":{"building":'
grep -q break_even out && fail 'what has no structure breaks even with itself'
[ "$(grep -c '"section":"A §1' out)" -eq "$(grep -c '"engine":' out)" ] || fail 'an engine without a section'

# `durero engines` has each of them under a head.
run 0 engines
cp out listed
run 0 stats scene.json --format json --no-times
sed -n 's/.*"engine":"\([^"]*\)".*/\1/p' out >names
lines names "$measured"
while read -r name; do
  checks=$((checks + 1))
  grep -qE "^  .* \(A §1[.0-9]*\): (.*, )?$name(,|\$)" listed || fail "durero engines has $name under no head"
done <names

# Every technique of the text's classification is there, had by something; what is had by an option, by one that there is.
while read -r section technique; do
  grep -qE "^  $technique \\(A §$section\\): [a-z]" listed || fail "durero engines lacks $technique (A §$section)"
  checks=$((checks + 1))
done <<'TECHNIQUES'
1.1 intersections of fewer operations
1.2 bounding volumes
1.3 hierarchies of bounding volumes
1.4.2 adaptive subdivision of space
1.4.3 uniform subdivision of space
1.5 item buffer
1.6.1 light buffer
1.6 ray classification
1.1 statistical antialiasing
1.7 adaptive depth control
1.1 cones
1.1 beams
1.1 pencils
TECHNIQUES
[ "$(grep -c '^  .* (A §' listed)" -eq 13 ] || fail 'durero engines has a technique that is not in the list here'
grep -A1 '^rays that are more than lines:' listed | grep -q '^  cones (A §1.1): render --rays cones$' ||
  fail 'rays that are more than lines'
grep -q '^of each in this list durero stats counts nodes, cells and bytes' listed || fail 'durero engines says nothing of counters'
run 0 render --help
cp out rendering
sed -n 's/.*: render \(--[a-z-]*\).*/\1/p' listed >options
lines options 5
while read -r option; do
  checks=$((checks + 1))
  grep -q -e "$option " rendering || fail "durero engines names $option, which durero render has not"
done <options

# Groups made by hand stand beside the automatic hierarchy, and may cost less; each alone where it is asked for.
run 0 stats "$demo/groups.json" --engine bvh --no-times
lines out 8
checks=$((checks + 1))
awk '/^hierarchy/ { below = 1 } below && /^bvh +[0-9]/ { own = $2 } below && /^bvh by hand/ { hand = $4 }
  END { exit !(hand > 3 && hand < 0.9 * own) }' out || fail 'by hand it does not cost less'
has out 'bvh by hand              3.8598       2    2.67       3'
run 0 stats "$demo/groups.json" --engine bvh --hierarchy hand --format json --no-times
has out '"hierarchy":{"made":"by hand","cost":3.859'
grep -q automatically out && fail 'the automatic hierarchy where it was not asked for'
run 0 stats "$demo/groups.json" --engine bvh --hierarchy automatic --no-times
lines out 6
run 0 stats scene.json --engine bvh --hierarchy hand --format json --no-times
has out '"made":"by hand"'

# A hierarchy of many elements is paid for, after as many rays as the seconds say: built longer, over saved for a ray.
awk 'BEGIN {
  printf "{\"format\":\"durero-scene\",\"version\":1,\"elementos\":["
  for (i = 0; i < 8000; ++i)
    printf "%s{\"id\":\"s%d\",\"tipo\":\"esfera\",\"centro\":[%d,%d,%d],\"radio\":0.3}", i ? "," : "", i, i % 20, i / 20 % 20, i / 400
  print "]}" }' >many.json
run 0 stats many.json --engine analytic --engine bvh --format json
sed -n 's/.*"seconds":{"building":\([^,]*\),"answering":\([^}]*\)}\(,"break_even":\([0-9]*\)\)\{0,1\}.*/\1 \2 \4/p' out >seconds
lines seconds 2
checks=$((checks + 1))
awk 'NR == 1 { built = $1; answered = $2 }
  NR == 2 { rays = 1000 * ($1 - built) / (answered - $2); wrong = $3 == "" || $3 < rays - 1 || $3 > rays + 2 }
  END { exit NR != 2 || wrong }' seconds || fail "$called: not the rays that pay for it: $(cat seconds)"

# Bounding volumes where they are asked for: each kind and what is chosen, then each element that has one.
run 0 stats scene.json --engine volumes --bounds --no-times
cp out said
has out 'I = 51.0 ns'
has out 'chosen                       m/ray    mean fit   void area  T foretold'
run 0 stats scene.json --engine volumes --bounds --no-times
same out said
grep -q measured out && fail 'what was measured where no times were asked for'
run 0 stats scene.json --engine volumes --bounds
has out 'measured ns'
run 0 stats scene.json --engine volumes --bounds --format json --no-times
has out '{"volumes":"slabs-13","n":3000,'
has out '"kinds":[{"kind":"ball","m":'
[ "$(grep -c '^{"volumes":' out)" -eq 8 ] || fail 'not seven kinds and what is chosen'
[ "$(grep -c '^{"id":' out)" -eq 3 ] || fail 'not an entry for each element'
run 0 stats scene.json --engine volumes --format json --no-times
grep -q bounds out && fail 'bounding volumes that nobody asked for'

echo '{"format":"durero-scene","version":1,"elementos":[]}' >empty.json
run 0 stats empty.json
has out 'empty.json: 0 elementos, 0 rays'
refused 'stats: --engine exact: no such engine; expected ' stats scene.json --engine exact
refused 'stats: --format sarif: no such format; expected one of text, json' stats scene.json --format sarif
refused 'absent.txt: cannot be read' stats scene.json absent.txt
# Sphere tracing: at four epsilons, the engine's own last; no ray goes on beyond its hit.
run 0 stats scene.json --engine analytic --sphere-tracing --no-times
has out 'sdf, epsilon'
[ "$(sed '1,/sdf, epsilon/d' out | awk '{ right += $3; passed += $7 } END { print NR, (right > 3000), passed }')" = '4 1 0' ] ||
  fail 'the figures of sphere tracing are not four lines of which nearly all rays are right'
run 0 stats scene.json --engine analytic --sphere-tracing --no-times --format json
has out '"sphere_tracing":['
has out '"passed":0}'
finish
