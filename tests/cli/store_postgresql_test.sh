# Stores on a PostgreSQL server, which the test starts.
. "$(dirname "$0")/harness.sh"
checks=$((checks + 1))
python3 "$(dirname "$0")/store_postgresql.py" "$durero" || fail store_postgresql.py
finish
