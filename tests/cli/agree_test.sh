# durero agree: engines against the sampled oracle; its range, and calls that it refuses.
tree=$(CDPATH='' cd -- "$(dirname -- "$0")/../.." && pwd)
. "$(dirname "$0")/harness.sh"
sample >scene.json

# Every engine agrees, and a seed names the same rays whatever the engine, the compiler and the number of threads.
run 0 agree scene.json --rays 3000 --seed 7
cp out said
has said '3000 rays: '
has said 'unexplained: 0'
lines said 3
for engine in exact analytic; do
  for threads in 1 3; do
    run 0 agree scene.json --rays 3000 --seed 7 --engine $engine --threads $threads
    same out said
    empty err
  done
done
run 0 agree scene.json --rays 3000 --seed 7 --engine sampled
has out 'unexplained: 0'
run 0 agree scene.json --rays 3000 --seed 18446744073709551615
has out 'unexplained: 0'

# For programs: the same as JSON.
run 0 agree scene.json --rays 3000 --seed 7 --format json
empty err
has out '{"format":"durero-agreement","version":1,"file":"scene.json","engine":"fast","seed":7,"rays":3000,"ok":true,'
has out '"incomplete":0,"unsound":0},'
has out "\"verdicts\":{\"agrees\":$(sed -n 's/^3000 rays: \([0-9]*\) agree.*/\1/p' said),"
has out '"findings":[]}'
refused 'agree: --format sarif: no such format; expected one of text, json' agree scene.json --format sarif

# Beyond the oracle's range nothing is said of the engine: not that it agrees, and not that it is wrong.
beyond() { # beyond RADIUS TEXT
  printf '{"format":"durero-scene","version":1,"elementos":[\n{"id":"s","tipo":"esfera","centro":[0,0,0],"radio":%s}]}' \
    "$1" >beyond.json
  for engine in sampled exact analytic fast; do
    refused "beyond.json: element s has a length of $2; expected lengths from 1e-140 to 1e+140" \
      agree beyond.json --rays 2000 --engine $engine
  done
}
beyond 1e160 1e+160
beyond 1e-160 1e-160
beyond 1e308 1e+308
beyond 5e-324 5e-324
printf '{"format":"durero-scene","version":1,"elementos":[\n{"id":"s","tipo":"esfera","centro":[0,-1e200,0],"radio":1}]}' >beyond.json
refused 'beyond.json: element s has a coordinate of -1e+200; expected coordinates up to 1e+140' agree beyond.json
for radius in 1e-140 3e139; do
  printf '{"format":"durero-scene","version":1,"elementos":[\n{"id":"s","tipo":"esfera","centro":[0,0,0],"radio":%s}]}' \
    $radius >within.json
  run 0 agree within.json --rays 2000
  has out '2000 rays: '
  has out 'unexplained: 0'
done

# No rays where there is nothing to see.
echo '{"format":"durero-scene","version":1,"elementos":[]}' >empty.json
run 0 agree empty.json
has out '0 rays: 0 agree'

# Numbers that are none of those that the call takes.
refused 'agree: --seed -1: no whole number from 0 to 18446744073709551615; expected ' agree scene.json --seed -1
refused 'agree: --seed 18446744073709551616: no whole number' agree scene.json --seed 18446744073709551616
refused 'agree: --seed 1.5: no whole number' agree scene.json --seed 1.5
refused 'agree: --rays 0: no whole number from 1 to 100000000' agree scene.json --rays 0
refused 'agree: --rays -1: no whole number' agree scene.json --rays -1
refused 'agree: --fineness nan: no number from 0.0009765625 to 1' agree scene.json --fineness nan
refused 'agree: --fineness 2: no number' agree scene.json --fineness 2
refused 'agree: --fineness inf: no number' agree scene.json --fineness inf
refused 'agree: --fineness x: no number' agree scene.json --fineness x
refused 'agree: --engine nobody: no such engine; expected one of ' agree scene.json --engine nobody
# Instances and solids: a ray towards each of their surfaces, and none is unexplained.
for scene in solids instances; do
  run 0 agree "$tree/demo/gallery/$scene.json" --rays 2000
  has out 'unexplained: 0'
done
cat >lens.json <<'SCENE'
{"format":"durero-scene","version":1,"elementos":[{"id":"lens","tipo":"interseccion","de":[
{"tipo":"esfera","centro":[0,0,-3],"radio":5},{"tipo":"esfera","centro":[0,0,3],"radio":1e-150}]}]}
SCENE
refused 'lens.json: element lens has a length of 1e-150; expected lengths from 1e-140 to 1e+140' agree lens.json
finish
