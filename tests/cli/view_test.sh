# durero view, as a person at a terminal has it.
. "$(dirname "$0")/harness.sh"
checks=$((checks + 1))
home=$(dirname "$0")
python3 "$home/view.py" "$durero" >err 2>&1 || fail view.py
finish
