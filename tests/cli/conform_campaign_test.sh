#!/bin/sh
# durero conform shard and merge: a campaign comes to the same bytes whoever asks which shard when; what is not a whole
# shard of it is refused.
. "$(dirname "$0")/harness.sh"
export XDG_CACHE_HOME="$PWD/cache"
flaky=$(CDPATH='' cd -- "$(dirname -- "$0")/../conform" && pwd)/flaky_system.py
python=/usr/bin/python3  # Debian's; another may be a script around one
[ -x "$python" ] || python=python3

# campaign FILE SYSTEM RAYS [MEMBER]
campaign() {
  printf '{"format":"durero-campaign","version":1,"system":"%s","seed":5,"rays_of_a_shard":%s,"shards":7,\n"families":["tiny","generic"]%s}\n' \
    "$2" "$3" "${4-}" >"$1"
}

# This program is right, and says so. A file of one shard is what it merges to.
campaign right.json durero 300
run 0 conform shard right.json 3 --output three.json
empty out
run 0 conform shard right.json 5
absent shard-5.json
run 0 conform merge right.json three.json
has out 'campaign '
has out ': 1 of 7 shards'
has out 'missing: 0-2, 4-6'
has out '95 %: where none of n judged rays failed, at most 3/n of such rays do'
run 0 conform merge right.json three.json --output again.json
same three.json again.json
run 0 conform merge right.json shard-0000005.json again.json three.json --output both.json
run 0 conform merge right.json both.json again.json --output both-again.json
same both.json both-again.json

# A program by a file of its own, and by a command. It crashes on 1 % of the rays, and hangs on 0.1 %: one, two and
# seven shards at a time, in any order, give the same bytes.
mkdir systems
cat >systems/flaky.json <<JSON
{"format":"durero-system","version":1,"system":"flaky","title":"Flaky","ask":["$python","-S","-E","$flaky"],
"profile":{"format":"binary64","tipos":["esfera","cilindro"],"caps":"open","measure":"parameter","directions":"any",
"inside":"exit_point","names_elements":true}}
JSON
campaign flaky.json systems/flaky.json 300 ',"time":2'
# shards AT_A_TIME N...: each in a file of the folder AT_A_TIME
shards() {
  folder=$1
  mkdir "$folder"
  shift
  printf '%s\n' "$@" | xargs -P "$folder" -I N "$durero" conform shard flaky.json N --jobs 1 --output "$folder/N.json"
  checks=$((checks + 1))
  [ "$(find "$folder" -name '*.json' | wc -l)" = 7 ] || fail "of seven shards some are not written"
}
shards 1 0 1 2 3 4 5 6
shards 2 5 3 6 0 2 4 1
shards 7 6 5 4 3 2 1 0
for folder in 1 2 7; do run 0 conform merge flaky.json "$folder" --output "all-$folder.json"; done
same all-1.json all-2.json
same all-1.json all-7.json
same 1/4.json 7/4.json
run 0 conform merge flaky.json 2/6.json 1/3.json 7 2/1.json all-1.json --output mixed.json
same all-1.json mixed.json
has out ': 7 of 7 shards'
has out 'Flaky (flaky 1)'
has out '2100 rays: '
has out 'signal 11'
has out 'no answer in 2 s'
has out 'hits off by 0 ulps: 0'
lacks() { checks=$((checks + 1)); ! grep -qF -e "$2" "$1" || fail "$called: $1 has: $2"; }
lacks out missing:
lacks out minimise  # a system that is no name
crashed=$(sed -n 's/^all  *//p' out | awk '{print NF}')
checks=$((checks + 1))
[ "$crashed" -ge 4 ] || fail "$called: no column for what crashed or hung"
# A failing ray that it names is one of that case.
replayed=$(sed -n 's/^  durero conform \(show .*\)/\1/p' out | head -n 1)
# shellcheck disable=SC2086  # words are meant to split
run 0 conform $replayed
campaign command.json "command:exec $python -S -E $flaky" 100 ',"time":2,"profile":"systems/flaky.json"'
run 0 conform shard command.json 0
run 0 conform merge command.json shard-0000000.json
has out '100 rays: '

# What is no whole shard of the campaign is refused, by name, and nothing is written.
refuse() { refused "$@" ; absent refused.json; }
refuse '1/4.json:1:50: shards of another campaign' conform merge right.json three.json 1/4.json --output refused.json
head -c 300 1/4.json >cut.json
refuse 'cut.json:' conform merge flaky.json 1 cut.json --output refused.json
has err 'truncated or was altered'
sed 's/"shard":4/"shard":3/' 1/4.json >altered.json
refuse 'altered.json:' conform merge flaky.json altered.json --output refused.json
has err 'truncated or was altered'
echo '{}' >1/other.json
refuse '1/other.json:1:1: no file of shards' conform merge flaky.json 1 --output refused.json
rm 1/other.json
refuse 'nothing.json: ' conform merge flaky.json nothing.json --output refused.json
sed 's/flaky_system.py"/&,"2"/' systems/flaky.json >flaky2.json && mv flaky2.json systems/flaky.json
run 0 conform shard flaky.json 4 --output version2.json
refuse 'version2.json: of "flaky 2"; expected "flaky 1", as the others' \
  conform merge flaky.json 1/3.json version2.json --output refused.json
refused 'no shard 7; expected one from 0 to 6' conform shard flaky.json 7
refused 'nothing.json: ' conform shard nothing.json 0
campaign absent.json bullet 300
refused 'bullet is absent: ' conform shard absent.json 0
campaign bad.json durero -1
refused 'bad.json:1:' conform shard bad.json 0
campaign bad.json command:true 300
refused 'bad.json:1:50: command: without profile' conform shard bad.json 0

# A system that answers in another way each time is named, and what counts is the same in any order.
printf '#!/bin/sh\necho system moody 1\nwhile read -r w n; do [ "$w" = rays ] || continue; i=0; while [ $i -lt $n ]; do read -r x; echo "hit - $1"; i=$((i+1)); done; done\n' >moody.sh
campaign moody.json 'command:sh moody.sh $(cat mood)' 100 ',"profile":"durero"'
for mood in 1 2; do
  echo $mood >mood
  run 0 conform shard moody.json 1 --output mood-$mood.json
done
run 1 conform merge moody.json mood-1.json mood-2.json --output forth.json
has out 'shard 1 was given with different contents: answers '
has out ': 1 of 7 shards'
has out '100 rays: '
run 1 conform merge moody.json mood-2.json mood-1.json --output back.json
same forth.json back.json
run 0 conform merge moody.json mood-1.json mood-1.json

# A merge writes the page of a run.
run 0 conform merge moody.json mood-1.json --report pages
has pages/report.html '<h2>Families that fail</h2>'
has pages/report.json '"format":"durero-report"'

# A shard of no rays, and the campaign beside its shards.
mkdir empty
campaign empty/c.json durero 0
for shard in 0 1 2 6; do run 0 conform shard empty/c.json $shard --output empty/$shard.json; done
cp empty/c.json empty/campaign.json
run 0 conform merge empty/c.json empty
has out ': 4 of 7 shards'
run 0 conform merge empty/campaign.json empty
has out 'missing: 3-5'
has out '0 rays: '

# SIGINT and SIGKILL leave no file; a shard that ends leaves a whole one.
printf '#!/bin/sh\necho system slow 1\nwhile read -r w n; do [ "$w" = rays ] || continue; sleep 0.2; i=0; while [ $i -lt $n ]; do read -r x; echo miss; i=$((i+1)); done; done\n' >slow.sh
campaign slow.json 'command:exec sh ./slow.sh' 6400 ',"profile":"durero"'
for signal in INT KILL; do
  mkdir $signal
  "$durero" conform shard slow.json 0 --jobs 1 --output $signal/s.json >out 2>err &
  asked=$!
  sleep 1
  kill -$signal $asked
  wait $asked
  got=$?
  called="a shard that is ended by $signal"
  checks=$((checks + 1))
  [ -z "$(ls $signal)" ] || fail "$called: it left $(ls $signal)"
  [ $signal = KILL ] || { checks=$((checks + 1)); [ $got = 2 ] || fail "$called: status $got, expected 2"; has err 'stopped after'; }
done
finish
