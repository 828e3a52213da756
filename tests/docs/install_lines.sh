#!/bin/sh
# install_lines.sh ROOT: the commands that README and docs/*.md say install something, as a script that stops at the first
# that fails: each fenced block with such a command, after a comment that names its page and line. Lines of the wheel of a
# release, which is no file of the tree, are not among them: package/release runs these.
set -eu
cd "$1"
awk '
  function end_of_block() {
    if (text !~ /\.whl/ && text ~ /(^|\n)(cmake --install|pip install|eval c)/) printf "# %s:%d\n%s", FILENAME, first, text
  }
  /^```/ && inside { end_of_block(); inside = 0; next }
  /^```/ { inside = 1; text = ""; first = FNR + 1; next }
  inside { text = text $0 "\n" }
' README.md docs/*.md
