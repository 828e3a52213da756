# durero serve: a store over HTTP, as a program of another language asks it, and what its call refuses.
. "$(dirname "$0")/harness.sh"
sample >scene.json
run 0 store init room.store --from scene.json

refused 'nothing.store: ' serve nothing.store --port 0
refused '0.0.0.0 is reached from other machines; expected a token, or 127.0.0.1' serve room.store --host 0.0.0.0 --port 0
echo >token
refused 'token:1:1: there is no token; expected one on the first line' serve room.store --port 0 --token token
echo 'open sesame' >token

"$durero" serve room.store --port 0 --token token --author ann >address 2>err &
server=$!
tries=0
until grep -q http address || [ $tries -ge 100 ]; do
  tries=$((tries + 1))
  sleep 0.1
done
python3 - "$(cat address)" <<'PYTHON' || fail 'the client'
import json
import sys
import urllib.error
import urllib.request


def ask(path, body=None, **headers):
    request = urllib.request.Request(sys.argv[1] + path, body and json.dumps(body).encode(), headers)
    request.add_header("Authorization", "Bearer open sesame")
    if body is not None:
        request.add_header("Content-Type", "application/json")
    try:
        with urllib.request.urlopen(request, timeout=60) as answer:
            return answer.status, json.load(answer), answer.headers["ETag"]
    except urllib.error.HTTPError as error:
        return error.code, json.load(error), error.headers["ETag"]


status, head, first = ask("/")
assert (status, head["event"], first) == (200, 1, '"1"'), head
status, answer, tag = ask("/edits", {"operations": ["Cambiar_Radio_Esfera e=s1 radio=2", {"op": "Eliminar_Cono", "e": "s1"}]})
assert status == 200 and answer["event"] == 2 and tag == '"2"', answer
assert answer["answers"][1]["violated"] == "Eliminar_Cono.pre.1", answer
assert ask("/edits", {"operations": ["Eliminar_Esfera e=s1"]}, **{"If-Match": first})[0] == 412
status, scene, _ = ask("/scene")
assert {"id": "s1", "radio": 2}.items() <= next(e for e in scene["elementos"] if e["id"] == "s1").items(), scene
status, hits, _ = ask("/hits", {"rays": [[0, 0, 0, 0, 0, 1]]})
assert hits["hits"][0]["outcome"] in ("hit", "miss"), hits
status, log, _ = ask("/log?limit=1")
assert log[0]["author"] == "ann" and log[0]["operation"].startswith("Cambiar_Radio_Esfera"), log
assert ask("/edits", {"operations": 3})[1]["error"].startswith("body:1:"), "the place in the body"
PYTHON
kill -INT $server
wait $server || fail "it ends by $?"
run 0 store log room.store
has out 'Cambiar_Radio_Esfera e=s1 radio=2'
run 0 store verify room.store

finish
