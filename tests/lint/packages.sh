#!/bin/sh
# What the program is built from is named once and the same: each package that ./x installs has its licence in
# docs/licences.md; those that a build needs, but for the compiler, are the Build-Depends of debian/control; and no
# source of the program or of the library includes CGAL, by whose licence the whole would come under the GPL.
list=docs/licences.md
# packages: each word of the variables NAME_packages of ./x, and its line: NAME LINE PACKAGE
packages() {
  awk -F '"' '/^[a-z]+_packages="/ { name = $1; sub(/_packages=/, "", name); inside = 1; words = $2; closed = NF > 2 }
    inside && !/^[a-z]+_packages="/ { words = $1; closed = NF > 1 }
    inside { count = split(words, word, " "); for (i = 1; i <= count; ++i) print name, FNR, word[i]; inside = !closed }' x
}
{
  packages | while read -r name line package; do
    grep -qF "\`$package\`" $list || echo "x:$line: $list names no licence of $package"
    case $name:$package in build:g++) continue ;; build:*) ;; *) continue ;; esac
    grep -qE "^Build-Depends:.* $package( \([^)]*\))?(,|\$)" debian/control ||
      echo "x:$line: Build-Depends of debian/control lack $package"
  done
  git ls-files src include python | xargs grep -nHE '^ *# *include *[<"]CGAL/' | cut -d: -f1,2 |
    sed 's/$/: an include of CGAL, whose licence is the GPL/'
} | { ! grep .; }
