#!/bin/sh
# The programs of systems/ are compiled where the program is installed, without our sources: each file that one includes in
# quotes lies at that path from its own folder.
git ls-files 'systems/*.cpp' 'systems/*.hpp' 'systems/*.c' | xargs grep -HnoE '^#include "[^"]*"' |
  while IFS=: read -r file line include; do
    named=${include#*\"}
    [ -f "$(dirname "$file")/${named%\"}" ] || echo "$file:$line: there is no ${named%\"} beside it; expected a path from its folder"
  done | { ! grep .; }
