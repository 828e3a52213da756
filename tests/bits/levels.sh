# levels.sh PROGRAM...: each prints the same lines, and says within itself that all instruction sets agree.
set -eu
first=$("$1") || { printf '%s\n' "$first"; exit 1; }
printf '%s\n' "$first"
for program in "$@"; do
  said=$("$program") || { printf '%s: %s\n' "$program" "$said"; exit 1; }
  [ "$said" = "$first" ] || { printf '%s differs:\n%s\n' "$program" "$said"; exit 1; }
done
printf '%s\n' "$# levels of optimisation, the same bits"
