# How the program is called: help, version, and one line for every bad call.
. "$(dirname "$0")/harness.sh"
sample >scene.json

run 0 --help
for command in check edit trace render import export; do has out "  $command "; done
empty err
run 0 edit --help
has out --script
run 0 --version
lines out 1
has out 'durero '

refused 'no subcommand'
refused 'The following argument was not expected: frobnicate' frobnicate
refused 'The following argument was not expected: --frobnicate' check scene.json --frobnicate
refused 'SCENE is required' check
refused 'RAYS is required' trace scene.json
refused '--engine: no engine magic; expected one of sampled, exact, analytic' trace scene.json rays --engine magic
refused '--threads: ' trace scene.json rays --threads 0
refused '--threads: ' trace scene.json rays --threads many
refused '--output is required' export scene.json
refused 'nowhere.json: cannot be read: No such file or directory' check nowhere.json
refused '.: cannot be read: Is a directory' check .
refused 'scene.obj: a format that is not known by this name' export scene.json -o scene.obj
refused 'scene.stl: a format that is not known by this name' import scene.stl -o out.json
absent scene.obj

# Whatever the bytes of an argument, of a file's name or of a file: a terminal prints the message and does not obey it.
escape=$(printf '\033[2J\233\n.')
escape=${escape%.}
refused 'The following argument was not expected: \x1b[2J\x9b' "$escape"
refused '\x1b[2J\x9b: cannot be read: No such file or directory' check "${escape%?}"
refused '\x1b[2J\x9b\x0a: cannot be read: No such file or directory' check "$escape"
refused '--engine: no engine \x1b[2J\x9b\x0a; expected ' trace scene.json rays --engine "$escape"
refused 'scene\x1b[2J\x9b\x0a: a format that is not known' export scene.json -o "scene$escape"
cp scene.json "$(printf 'a\033b')"
run 0 check "$(printf 'a\033b')"
has out 'a\x1bb: 3 elementos'
printf '{"\033[2J\302\233' >bad
refused 'bad:1:3: "\x1b" stands here inside a string' check bad
finish
