#!/bin/sh
# The repository speaks of the project alone, and nothing in it is unfinished or switched off.
look() {  # look PATTERN WHAT
  git ls-files | grep -vE '^tests/lint/|\.png$' | xargs grep -HnIE -e "$1" 2>/dev/null | sed "s/\$/  <- $2/"
}
{
  look 'TODO|FIXME|\bXXX\b|[Nn]ot implemented|#if 0' 'unfinished'
  look '(^|[^A-Za-z0-9_.])/(work|root|home)/[a-z]' 'a path of one machine'
  look 'https?://[a-z0-9.-]*(debian|npmjs|pypi|maven|crates)' 'a host of a package registry' |
    grep -v '^debian/copyright:1:Format: '  # so the format is named
  git ls-files '*.py' | python3 -c '
import pathlib, sys
for path in sys.stdin.read().split():
    if pathlib.Path(path).stem in sys.stdlib_module_names: print(path + ":1: Python has a module of that name; expected another")'
  look '\[\.\]|\[!mayfail\]|\[!shouldfail\]' 'a test that is switched off'
} | { ! grep .; }
