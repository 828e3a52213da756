#!/bin/sh
# Other questions than the first hit: in suites on disk, of one's own rays, and in campaigns.
. "$(dirname "$0")/harness.sh"
export XDG_CACHE_HOME="$PWD/cache"

# A suite has the exact answers as claims, and the ends of its rays; judging them finds nothing, and less than all is seen.
for question in shadow range all count cast; do
  run 0 conform make "suite-$question" --family rim,in_surface --rays 32 --question "$question"
  has "suite-$question/suite.json" "\"question\":\"$question\""
  cat "suite-$question"/*/*.claims.jsonl >claims.jsonl
  lines claims.jsonl 64
  run 0 conform judge "suite-$question" claims.jsonl --profile durero --report "found-$question"
  has out '64 rays: 0 gross'
  has "found-$question/report.json" "\"question\":\"$question\""
  sed 's/"outcome":"hit".*/"outcome":"miss"}/' claims.jsonl >misses.jsonl
  run 1 conform judge "suite-$question" misses.jsonl --profile durero
done
has suite-all/rim/0000.claims.jsonl '"hits":[{"element":"e'
absent suite-all/rim/0000.ranges.txt
lines suite-range/rim/0000.ranges.txt 16
lines suite-cast/rim/0000.ranges.txt 16
[ "$(awk '{print NF}' suite-range/rim/0000.ranges.txt | sort -u)" = 2 ] || fail 'a range has two ends'
[ "$(awk '{print NF}' suite-shadow/rim/0000.ranges.txt | sort -u)" = 1 ] || fail 'a shadow ray has one end'
sed 's/^0/1/' suite-range/rim/0000.ranges.txt >changed && cp changed suite-range/rim/0000.ranges.txt
cat suite-range/*/*.claims.jsonl >claims.jsonl
refused 'suite-range/rim/0000.ranges.txt:' conform judge suite-range claims.jsonl --profile durero
refused 'bullet does not claim the question all; expected one of ' conform judge suite-all claims.jsonl --profile bullet
refused 'a suite of nearest points; expected durero conform run' conform make nearest --question closest

# One's own rays.
printf '{"format":"durero-scene","version":1,"elementos":[{"id":"ball","tipo":"esfera","centro":[0,0,5],"radio":1}]}' >own.json
printf '0 0 0 0 0 1\n0 3 0 0 0 1\n' >own.txt
own() { # STATUS QUESTION ARGUMENT...
  status=$1 asked=$2
  shift 2
  run "$status" conform judge --scene own.json --rays own.txt own.jsonl --profile durero --question "$asked" "$@"
}
printf '{"ray":0,"outcome":"hit","hits":[{"element":"ball","t":4},{"element":"ball","t":6}]}\n{"ray":1,"outcome":"miss"}\n' >own.jsonl
own 0 all
is out '2 rays: 2 exact'
printf '{"ray":0,"outcome":"hit","element":"ball","t":4}\n{"ray":1,"outcome":"miss"}\n' >own.jsonl
own 1 all
has out 'ray 0 missed: expected ball at t = 4, point (0, 0, 4); ball at t = 6, point (0, 0, 6); got ball at t = 4'
printf '{"ray":0,"outcome":"hit","count":2}\n{"ray":1,"outcome":"hit","count":1}\n' >own.jsonl
own 1 count
has out 'ray 1 wrong_count: expected 0 hits; got 1 hit'
printf '{"ray":0,"outcome":"hit"}\n{"ray":1,"outcome":"miss"}\n' >own.jsonl
printf '4.5\n9  # behind nothing\n' >ends.txt
own 0 shadow --ranges ends.txt
printf '3.5\n9\n' >ends.txt
own 1 shadow --ranges ends.txt
has out 'ray 0 phantom: expected no hit up to t = 3.5, the first being ball at t = 4'
printf '{"ray":0,"outcome":"hit","element":"ball","t":6}\n{"ray":1,"outcome":"miss"}\n' >own.jsonl
printf '4.5 9\n0 9\n' >ends.txt
own 0 range --ranges ends.txt
printf '0 9\n0 9\n' >ends.txt
own 1 range --ranges ends.txt
has out 'ray 0 far_root: expected ball at t = 4, point (0, 0, 4) within t = 0 … 9; got ball at t = 6'
printf '{"ray":0,"outcome":"hit","element":"ball","t":4,"point":[0,0,4]}\n{"ray":1,"outcome":"hit","t":5}\n' >own.jsonl
own 1 closest
has out 'ray 1 misplaced: expected ball at a distance of 4.8309518948453'
printf '{"ray":0,"outcome":"hit","element":"ball","t":3.5,"point":[0,0,4]}\n{"ray":1,"outcome":"hit","t":5}\n' >own.jsonl
printf '0.5\n1  # just passes\n' >radii.txt
own 1 cast --ranges radii.txt
has out 'ray 1 phantom: expected a ball of radius 1 touches nothing; got'
printf '0.5\n2\n' >radii.txt
own 0 cast --ranges radii.txt
is out '2 rays: 2 exact'
printf '0.5\n0\n' >radii.txt
refused 'radii.txt:2:1: "0"; expected a radius that is positive' conform judge --scene own.json --rays own.txt own.jsonl --profile durero --question cast --ranges radii.txt
refused '--ranges is missing; expected the file' conform judge --scene own.json --rays own.txt own.jsonl --profile durero --question cast
refused '--ranges is missing; expected the file' conform judge --scene own.json --rays own.txt own.jsonl --profile durero --question range
refused '--ranges is for shadow rays, ranges and casts' conform judge --scene own.json --rays own.txt own.jsonl --profile durero --question all --ranges ends.txt
refused 'embree-user does not claim the question all' conform judge --scene own.json --rays own.txt own.jsonl --profile embree-user --question all
printf '0 0 0 0 0 1\n0 3 0 0 0 1\n0 9 0 0 0 1\n' >three.txt
refused 'ends.txt:3:1: 2 ranges; expected 3, one a ray' conform judge --scene own.json --rays three.txt own.jsonl --profile durero --question range --ranges ends.txt

# A campaign.
printf '{"format":"durero-campaign","version":1,"system":"durero","seed":5,"rays_of_a_shard":64,"shards":2,"families":["rim","tiny"],"question":"all"}\n' >all.json
run 0 conform shard all.json 0 --output zero.json
run 0 conform merge all.json zero.json --output merged.json
has out ': 1 of 2 shards'
sed 's/"all"/"shadow"/' all.json >shadow.json
refused 'zero.json:' conform merge shadow.json zero.json
sed 's/"durero",/"bullet",/' all.json >bullet.json
refused 'bullet does not claim the question all; expected one of ' conform shard bullet.json 0
finish
