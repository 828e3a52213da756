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
refused '--engine: no engine magic, but sampled, exact, analytic' trace scene.json rays --engine magic
refused '--threads: ' trace scene.json rays --threads 0
refused '--threads: ' trace scene.json rays --threads many
refused '--output is required' export scene.json
refused 'nowhere.json: cannot be read: No such file or directory' check nowhere.json
refused '.: cannot be read: Is a directory' check .
refused 'scene.obj: a format that is not known by this name' export scene.json -o scene.obj
refused 'scene.obj: a format that is not known by this name' import scene.obj -o out.json
absent scene.obj
finish
