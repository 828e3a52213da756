#!/bin/sh
# Runs every rule of the house. A rule is a script RULE.sh that prints FILE:LINE: what is wrong, and fails.
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
cd "${DURERO_TREE:-$here/../..}" || exit 2
failed=0 count=0
for rule in "$here"/*.sh; do
  case ${rule##*/} in all.sh | drill.sh) continue ;; esac
  count=$((count + 1))
  if ! said=$(sh "$rule" 2>&1); then
    failed=$((failed + 1))
    printf '%s\nlint: %s failed\n' "$said" "${rule##*/}"
  elif [ -n "$said" ]; then printf '%s\n' "$said"
  fi
done
echo "lint: $((count - failed)) passed, $failed failed"
[ "$failed" = 0 ]
