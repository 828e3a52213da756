# durero trace: the hits of rays whose answers are known, by every engine.
. "$(dirname "$0")/harness.sh"
sample >scene.json
cat >rays <<'TEXT'
# at the sphere, past everything, along the cylinder's side, from the sphere outwards
0 0 -5 0 0 2
0 9 0 0 1 0
4 -1 0 0 0x1p-1 0
0 0 -1 0 0 -1 @s1
TEXT
expected='{"ray":0,"outcome":"hit","elementos":["s1"],"t":2,"point":[0,0,-1]}
{"ray":1,"outcome":"miss","elementos":[]}
{"ray":2,"outcome":"hit","elementos":["c1"],"t":2,"point":[4,0,0]}
{"ray":3,"outcome":"miss","elementos":[]}'
for engine in exact analytic; do
  run 0 trace scene.json rays --engine $engine
  is out "$expected"
  empty err
done
run 0 trace scene.json rays -o hits.jsonl
is hits.jsonl "$expected"
empty out

# From inside the cylinder's side no point is nearest.
echo '4 1 0 0 1 0' >along
run 0 trace scene.json along
is out '{"ray":0,"outcome":"no_minimum","elementos":["c1"]}'

# The sampled engine sees the sphere near its nearest point.
head -n 2 rays >first
run 0 trace scene.json first --engine sampled
has out '"outcome":"hit","elementos":["s1"]'
# It cannot tell the surface that a ray starts on from one that the ray meets.
refused '--engine sampled: ' trace scene.json rays --engine sampled -o hits

# The hierarchy is that of the scene's groups where that is asked for; the answers are the same.
sed 's/"elementos":\[/"groups":{"all":{"elementos":["c1","s1"]}},\n&/' scene.json >grouped.json
run 0 trace grouped.json rays --engine bvh
cp out said
run 0 trace grouped.json rays --engine bvh --hierarchy hand
same out said
refused 'hierarchy hand: fast follows no groups; expected engine bvh' trace grouped.json rays --hierarchy hand
refused 'trace: --hierarchy none: no such hierarchy; expected one of automatic, hand' trace grouped.json rays --hierarchy none
absent hits

# Threads change nothing.
seed=1
while [ $seed -le 300 ]; do
  echo "0 0 -9 $((seed % 7 - 3)) $((seed % 5 - 2)) $((seed % 11 + 3))"
  seed=$((seed + 1))
done >many
run 0 trace scene.json many --threads 1 -o one
run 0 trace scene.json many --threads 4 -o four
same one four
lines one 300

# .npy in and out: two rays, of which the first hits.
{
  printf '\223NUMPY\001\000\166\000'
  printf "%-117s\n" "{'descr': '<f8', 'fortran_order': False, 'shape': (2, 6), }"
  for ray in 1 2; do
    printf '\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\024\300' # 0 0 -5
    printf '\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000\000'                                # 0 0
    [ $ray = 1 ] && printf '\000\000\000\000\000\000\000\100' || printf '\000\000\000\000\000\000\360\277'    # 2, -1
  done
} >rays.npy
run 0 trace scene.json rays.npy -o hits.npy
has hits.npy "('outcome', 'S10'), ('t', '<f8'), ('point', '<f8', (3,)), ('elementos', 'S2')"
[ "$(tail -c 88 hits.npy | head -c 3)" = hit ] || fail 'the first record is no hit'
[ "$(tail -c 44 hits.npy | head -c 4)" = miss ] || fail 'the second record is no miss'
run 0 trace scene.json rays.npy
has out '{"ray":0,"outcome":"hit","elementos":["s1"],"t":2,"point":[0,0,-1]}'

# Lines may end as on any system.
head -n 3 rays | tr '\n' '\r' >carriage
run 0 trace scene.json carriage
is out "$(printf '%s\n' "$expected" | head -n 2)"

# Malformed rays.
bad() {
  printf '%b\n' "$1" >bad
  refused "bad:$2" trace scene.json bad -o hits
  absent hits
}
bad '0 0 0 0 0 0' '1:7: v is (0, 0, 0); expected ¬ (v.x = 0 ∧ v.y = 0 ∧ v.z = 0) (Rayo.inv.1)'
bad '# c\n0 0 nan 0 0 1' '2:5: "nan"'
bad '0 0 0 0 0 inf' '1:11: "inf"'
bad '0 0 0 0 0' '1:10: the ray ends after 5 numbers'
bad '0 0 0 0 0 1 @s9' '1:13: no element "s9"'
head -c 150 rays.npy >cut.npy
refused 'cut.npy:1:1: ' trace scene.json cut.npy -o hits
absent hits
finish
