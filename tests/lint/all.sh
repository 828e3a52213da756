#!/bin/sh
# Runs every rule of the house. A rule is a script RULE.sh that prints FILE:LINE: what is wrong, and fails. A rule that writes
# to the standard error has not looked at all of the tree, as one whose grep or awk finds no file; it fails, whatever its status.
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
cd "${DURERO_TREE:-$here/../..}" || exit 2
troubles=$(mktemp) && trap 'rm -f "$troubles"' EXIT
failed=0 count=0
for rule in "$here"/*.sh; do
  case ${rule##*/} in all.sh | drill.sh) continue ;; esac
  count=$((count + 1))
  if ! said=$(sh "$rule" 2>"$troubles") || [ -s "$troubles" ]; then
    failed=$((failed + 1))
    printf '%s\nlint: %s failed\n' "$said$(cat "$troubles")" "${rule##*/}"
  elif [ -n "$said" ]; then printf '%s\n' "$said"
  fi
done
echo "lint: $((count - failed)) passed, $failed failed"
[ "$failed" = 0 ]
