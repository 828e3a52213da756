# How what commands take grows with their input.
. "$(dirname "$0")/harness.sh"
checks=$((checks + 1))
python3 "$(dirname "$0")/growth.py" "$durero" || fail growth.py
finish
