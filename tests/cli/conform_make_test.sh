# durero conform list and make: the families, and suites of them.
. "$(dirname "$0")/harness.sh"

run 0 conform list
cp out listed
has listed 'far_origin           an element from 10³ to 10¹⁴ of its sizes away'
has listed '                     mitsuba3#512, OSPRay#179'
has listed '                     log2 of the distance: 10 … 48 (10 … 17 in binary32)'
for family in scale rotation parked vertex edge inside; do
  grep -q "^$family  " listed || fail "conform list: $family is not there"
done
run 0 conform list --json
lines out 58
has out '"family":"tiny","kind":"sizes from 10⁻³ to 10⁻³⁰","reason":"celeritas#1897: absolute epsilons","parameter":{"name":"log2 of the scale","least":-106,"greatest":-17,"binary32":{"least":-106,"greatest":-17}}}'
[ "$(grep -c '"family"' out)" = 56 ] || fail "conform list --json: not 56 families"

# The same bytes from the same options on any number of threads.
run 0 conform make one --family rim --family tie --rays 25 --seed 5 --threads 1
empty err
lines out 2
has out 'rim                  25 rays: '
has out ' % with one answer alone'
run 0 conform make two --family tie --family rim --rays 25 --seed 5 --threads 3
checks=$((checks + 1))
diff -r one two >differences || fail "one thread and three differ: $(cat differences)"
[ "$(find one -type f | wc -l)" = 25 ] || fail "not 25 files: $(find one -type f)"
run 0 conform make other --family rim --rays 25 --seed 6
cmp -s one/rim/0000.rays.txt other/rim/0000.rays.txt && fail "two seeds give the same rays"

# The files are those that the other commands read, and the answers those of every engine.
for number in 0000 0001; do
  for engine in exact analytic; do
    run 0 trace one/rim/$number.scene.json one/rim/$number.rays.txt --engine $engine
    same out one/rim/$number.hits.jsonl
    run 0 trace one/rim/$number.scene.json one/rim/$number.rays.npy --engine $engine -o hits.npy
    same hits.npy one/rim/$number.hits.npy
  done
  run 0 check one/rim/$number.scene.json
done
lines one/rim/0000.hits.jsonl 16
lines one/rim/0001.hits.jsonl 9

# Types, solids, formats.
run 0 conform make spheres --types esfera --rays 10
has out 'apex                 no scene has elements of these types alone'
absent spheres/apex
if grep -rhE '"tipo":"[^"]*"' spheres --include='*.scene.json' -o | grep -qv esfera; then fail "not only spheres"; fi
has spheres/suite.json '"tipos":["esfera"]'
run 0 conform make solids --types cilindro,cono --solids --family generic --rays 64
has solids/generic/0000.case.json '"solids":[{"wall":"e0","discs":["e0.base"'
has solids/generic/0000.scene.json '"id":"e0.base","tipo":"disco"'
run 0 conform make wide --numbers binary64 --family rotation --rays 64
has wide/suite.json '"numbers":"binary64"'
run 0 conform make narrow --family rotation --rays 64
has narrow/suite.json '"numbers":"binary32"'

# Meshes: of as many faces as are asked for, 256 rays each, with the exact answers of every engine.
run 0 conform make meshes --family mesh_inside,stack --rays 300 --faces 200
has meshes/suite.json '"faces":200'
has meshes/stack/0001.scene.json '"mallas"'
lines meshes/stack/0000.hits.jsonl 256
lines meshes/stack/0001.hits.jsonl 44
run 0 trace meshes/stack/0001.scene.json meshes/stack/0001.rays.txt --engine exact
same out meshes/stack/0001.hits.jsonl
run 0 conform make few --family stack --rays 16
run 0 conform show --case stack/0001 --ray 255
absent few/stack/0001.scene.json
if grep -q faces few/suite.json; then fail 'the usual number of faces is told'; fi
refused 'conform make: --faces 0: no whole number from 1 to 4000000' conform make new --faces 0

# What is refused leaves nothing.
mkdir full && echo kept >full/kept
refused "$PWD/full: it is there already, and is no empty directory" conform make full --rays 10
[ "$(ls full)" = kept ] || fail "full was changed"
refused "$PWD/full/kept: it is there already" conform make full/kept --rays 10
refused 'none/suite: cannot be written: No such file or directory' conform make none/suite --rays 10
refused 'conform make: --family tiger: no such family; expected one of generic, ' conform make new --family tiger
refused 'conform make: --types cubo: no such type; expected one of ' conform make new --types esfera,cubo
refused 'conform make: --numbers binary16: no such format; expected ' conform make new --numbers binary16
refused 'conform make: --rays 0: no whole number from 1' conform make new --rays 0
refused 'conform make: --seed -1: no whole number from 0 to 9007199254740992' conform make new --seed -1
refused 'conform make: DIR: it is missing; expected durero conform make ' conform make
absent new
case $(ls -d ./*.new* 2>/dev/null) in '') ;; *) fail "a directory was left" ;; esac
finish
