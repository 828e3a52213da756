#!/bin/sh
# One layout for all C++: .clang-format. Other versions of the tool lay out a little differently, so only 16 is asked.
# Reproducers in docs/findings are as durero conform bug writes them.
command -v clang-format-16 >/dev/null 2>&1 || { echo "format.sh: skipped, clang-format-16 is absent"; exit 0; }
git ls-files '*.cpp' '*.hpp' ':!docs/findings' | xargs clang-format-16 --dry-run --Werror 2>&1 | grep -E 'error|warning' | { ! grep .; }
