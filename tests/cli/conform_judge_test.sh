# durero conform judge, show and compare: hits from files, a ray explained, systems side by side.
surfaces=$(cd "$(dirname "$0")/../../demo/surfaces" && pwd)
. "$(dirname "$0")/harness.sh"

run 0 conform make suite --family generic,rim --rays 24

# Exact answers, handed in as JSON lines, as CSV and as .npy, are right.
python3 - <<'END'
import json, pathlib, struct
lines, rows, distances = [], ["case,ray,element,t"], []
cases = [f"{family}/{number}" for family in ("generic", "rim") for number in ("0000", "0001")]
for case in cases:
    for line in pathlib.Path("suite", case + ".hits.jsonl").read_text().splitlines():
        hit = json.loads(line)
        is_hit = hit["outcome"] == "hit"
        claim = {"case": case, "ray": hit["ray"], "outcome": "hit" if is_hit else "miss"}
        if is_hit:
            claim |= {"element": hit["elementos"][0], "t": hit["t"]}
        lines.append(json.dumps(claim))
        rows.append(f'{case},{hit["ray"]},{claim.get("element", "")},{claim.get("t", "")}')
        distances.append(claim.get("t", float("inf")))
pathlib.Path("hits.jsonl").write_text("\n".join(lines) + "\n")
pathlib.Path("hits.csv").write_text("\n".join(rows) + "\n")
head = "{'descr': '<f8', 'fortran_order': False, 'shape': (%d,), }" % len(distances)
head += " " * (-(11 + len(head)) % 64) + "\n"
pathlib.Path("hits.npy").write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode()
                                     + struct.pack("<%dd" % len(distances), *distances))
# One is a hit at twice its distance, one a miss, and one is left out.
wrong = [json.loads(line) for line in lines]
hits = [claim for claim in wrong if claim["outcome"] == "hit" and claim["case"] == "generic/0000"]
hits[0]["t"] *= 2
for key in ("t", "element"):
    del hits[1][key]
hits[1]["outcome"] = "miss"
wrong.remove(hits[2])
pathlib.Path("wrong.jsonl").write_text("\n".join(map(json.dumps, wrong)))
END
for hits in hits.jsonl hits.csv hits.npy; do
  run 0 conform judge suite $hits --profile durero
  has out '48 rays: 0 gross, 0 off, '
done

run 1 conform judge suite wrong.jsonl --profile durero --report found
has out '48 rays: 2 gross, 0 off, '
has out 'generic missed: expected e'
has out '; got a miss'
has out ': no answer'
for report in report.json report.xml report.sarif report.html; do
  [ -s found/$report ] || fail "no $report"
done
python3 -c '
import json, xml.etree.ElementTree as tree
report = json.load(open("found/report.json"))
assert report["verdicts"]["missed"] == 1, report["verdicts"]
assert json.load(open("found/report.sarif"))["version"] == "2.1.0"
suite = tree.parse("found/report.xml").getroot()
assert (suite.get("tests"), suite.get("failures")) == ("2", "1"), suite.attrib
' || fail 'the reports'

# The call that a report names shows the ray.
replay=$(sed -n 's/^  durero \(conform show .*\)/\1/p' out | head -n 1)
# shellcheck disable=SC2086  # words are meant to split
run 0 $replay
has out 'generic/0000, ray '
has out 'the exact answer: e'
refused 'no case "generic"; expected FAMILY/NUMBER, such as generic/0000' conform show --case generic --ray 0
refused 'no case "generic/x"; expected FAMILY/NUMBER, such as generic/0000' conform show --case generic/x --ray 0
refused 'no family "nothing"; expected' conform show --case nothing/0 --ray 0

# Systems side by side, on the same rays alone.
run 0 conform judge suite hits.jsonl --profile durero --report right
run 0 conform compare right/report.json found/report.json
has out 'durero: gross in generic '
has out 'durero: gross in none'
run 0 conform compare --markdown right/report.json
has out '| durero |'
run 0 conform history found/report.json right/report.json
has out '  fewer gross in generic '
run 0 conform make other --family rim --rays 64
: >none.jsonl
run 1 conform judge other none.jsonl --profile durero --report other-found  # what was not judged is no pass
has out '64 rays: 0 gross, 0 off, 64 skipped'
refused '"durero" and "durero" were asked other rays' conform compare right/report.json other-found/report.json

# A failure is made as small as it stays one.
mkdir -p systems/blind
cat >systems/blind/ask.py <<'END'
import sys
print("system blind 1", flush=True)
for line in sys.stdin:
    words = line.split()
    if words[0] == "rays":
        for _ in range(int(words[1])):
            sys.stdin.readline()
            print("miss", flush=True)
END
printf '%s' '{"format":"durero-system","version":1,"system":"blind","title":"Blind","install":{},
"ask":["python3","{here}/ask.py"],"profile":{"format":"binary64","tipos":["esfera","cilindro"],"caps":"solid",
"measure":"parameter","directions":"any","inside":"exit_point","names_elements":false},"sources":[]}' >systems/blind/blind.json
run 1 conform minimise blind --systems systems --case generic/0000 --ray 0
has out 'missed: expected e'
has out 'in hexadecimal:'
[ "$(grep -c '^esfera\|^cilindro' out)" = 3 ] || fail 'more than one element is left'  # asked, in hexadecimal, explained
run 0 conform minimise durero --case generic/0000 --ray 0
has out 'exact: expected e'
refused 'no system "blind"' conform minimise blind --case generic/0000 --ray 0

refused 'hits.jsonl:1:' conform judge other hits.jsonl --profile durero
refused 'no system "nothing"; expected' conform judge suite hits.jsonl --profile nothing
refused 'nowhere' conform judge nowhere hits.jsonl --profile durero
printf '{"a":1}' >changed && cp changed suite/rim/0000.hits.jsonl
refused 'suite/rim/0000.hits.jsonl:1:3: ' conform judge suite hits.jsonl --profile durero

# One's own scene and rays: the same verdicts, ray by ray.
printf '{"format":"durero-scene","version":1,"elementos":[{"id":"ball","tipo":"esfera","centro":[0,0,5],"radio":1}]}' >own.json
printf '0 0 0 0 0 1\n0 3 0 0 0 1\n' >own.txt
printf '{"ray":0,"outcome":"hit","element":"ball","t":4}\n{"ray":1,"outcome":"miss"}\n' >own.jsonl
run 0 conform judge --scene own.json --rays own.txt own.jsonl --profile durero
is out '2 rays: 2 exact'
printf '{"ray":0,"outcome":"miss"}\n' >own.jsonl
run 1 conform judge --scene own.json --rays own.txt own.jsonl --profile durero
has out '2 rays: 1 missed, 1 skipped'
has out 'ray 0 missed: expected ball at t = 4, point (0, 0, 4); got a miss'
has out 'ray 1 skipped: no answer'
run 1 conform judge --scene own.json --rays own.txt own.jsonl --profile durero --format json
lines out 2
refused 'HITS alone stands beside --scene; expected no suite' \
  conform judge suite own.jsonl --scene own.json --rays own.txt --profile durero
refused 'HITS is missing; expected DIR and HITS, or --scene, --rays and HITS' conform judge own.jsonl --profile durero
refused '--format json is for' conform judge suite own.jsonl --profile durero --format json
run 2 conform judge --scene own.json own.jsonl --profile durero
run 2 conform judge --scene own.json --rays own.txt own.jsonl --profile durero --report found
printf '0 0 4 0 0 1 @ball\n' >named.txt
refused 'named.txt: ray 0 names elements that it starts on' conform judge --scene own.json --rays named.txt own.jsonl --profile durero

# Elements that a text describes: the profile names their types.
printf '0.25 0 -6 0 0 1\n0.25 0 -6 0 1 0\n' >ring.txt
printf '{"ray":0,"outcome":"hit","element":"ring","t":3.2613872124741694}\n{"ray":1,"outcome":"miss"}\n' >ring.jsonl
cat >ring.json <<'END'
{"format":"durero-profile","version":1,"system":"mine","profile":{"format":"binary64","tipos":["esfera","plano"],
"surfaces":["toro"],"caps":"open","measure":"parameter","directions":"any","inside":"exit_point","names_elements":true,
"questions":["first","shadow","closest"]}}
END
judge_ring() {
  expected=$1
  shift
  run "$expected" conform judge --scene "$surfaces/torus.json" --with "$surfaces/torus.tex" --rays ring.txt ring.jsonl "$@"
}
judge_ring 0 --profile ring.json
is out '2 rays: 2 exact'
judge_ring 1 --profile durero
has out 'ray 0 skipped: no toro'
printf '{"ray":0,"outcome":"hit","element":"ring","t":3.261387212474}\n{"ray":1,"outcome":"miss"}\n' >ring.jsonl
judge_ring 1 --profile ring.json
has out 'ray 0 off: expected ring at t = 3.2613872124741694'
printf '{"ray":0,"outcome":"hit","element":"ball","t":5.6}\n{"ray":1,"outcome":"miss"}\n' >ring.jsonl
judge_ring 1 --profile ring.json
has out 'ray 0 misplaced: expected ring'
judge_ring 2 --profile ring.json --question closest
has err 'distances from a surface of a text are not known; expected another question'
run 2 conform judge suite ring.jsonl --with "$surfaces/torus.tex" --profile ring.json
sed 's/"esfera","plano"//; s/"toro"//' ring.json >empty.json
judge_ring 2 --profile empty.json
has err 'empty.json:1:95: tipos is empty; expected one type of elements at least'
sed 's/"esfera","plano"//' ring.json >text.json
judge_ring 1 --profile text.json
has out 'skipped: no '

finish
