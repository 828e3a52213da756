# durero version: every version, in words and as JSON with keys that stay.
sources=$(cd "$(dirname "$0")/../.." && pwd)  # before the harness goes elsewhere
. "$(dirname "$0")/harness.sh"

run 0 --version
cp out line
run 0 version
head -n 1 out >first
same first line
for word in compiler 'instruction sets' formats libraries GMP; do has out "$word"; done

run 0 version --json
lines out 1
checks=$((checks + 1))
python3 - "$(cat line)" <<'PYTHON' || fail 'the JSON is not as documented'
import json
said = json.load(open("out"))
assert list(said) == ["durero", "formats", "compiler", "build_type", "sanitizers", "instruction_sets", "libraries"], said
import sys
assert "durero " + said["durero"] == sys.argv[1]
assert set(said["compiler"]) == {"name", "version"} and said["compiler"]["name"] in ("GCC", "Clang")
sets = said["instruction_sets"]
assert set(sets) == {"compiled", "in_use"} and sets["in_use"] in sets["compiled"], sets
libraries = said["libraries"]
assert [name for name in libraries if name != "libpq"] == ["GMP", "Boost", "oneTBB", "Highway", "fmt", "libpng", "OpenEXR", "libjpeg-turbo", "RapidJSON", "CLI11", "FLINT", "pugixml", "libedit", "SQLite", "OpenSSL"]
assert all(version[0].isdigit() and "." in version for version in libraries.values()), libraries
assert all(isinstance(version, int) and version >= 1 for version in said["formats"].values())
open("formats", "w").write("".join(name + "\n" for name in sorted(said["formats"])))
PYTHON

# The formats are those that the sources name.
grep -rhoE '"durero-[a-z]+"|\{\\?"format\\?":\\?"durero-[a-z]+' "$sources/src" "$sources/include" |
  grep -oE 'durero-[a-z]+' | sort -u >named
same formats named
sample >scene.json
run 0 edit scene.json --op 'Eliminar_Esfera e=s1' -o edited.json
run 0 version --json
version=$(sed 's/.*"durero-scene":\([0-9]*\).*/\1/' out)
has edited.json "\"format\":\"durero-scene\",\"version\":$version"
finish
