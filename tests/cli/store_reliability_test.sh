# Stores that are killed, shared, full, read-only and spoiled beside a journal.
. "$(dirname "$0")/harness.sh"
checks=$((checks + 1))
python3 "$(dirname "$0")/store_reliability.py" "$durero" || fail store_reliability.py
finish
