#!/bin/sh
# changes.sh VERSION <CHANGELOG.md: the section of a version, without its heading; fails where there is none.
awk -v heading="## [$1]" '
  /^## / { here = index($0, heading) == 1; if (here) { found = 1; next } }
  here && (began || NF) { began = 1; print }
  END { exit !found }'
