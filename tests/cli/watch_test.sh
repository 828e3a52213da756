# durero watch: each save of a file is told once, when it is whole.
. "$(dirname "$0")/harness.sh"
home=$(dirname "$0")
checks=$((checks + 1))
PYTHONDONTWRITEBYTECODE=1 python3 "$home/watch.py" "$durero" >err 2>&1 || fail watch.py
refused 'none/a.json: cannot be watched: ' watch none/a.json
refused '-: is the standard input, which cannot be watched; ' watch -
sample >scene.json
refused 'standard input or output is no terminal; ' watch scene.json --view
finish
