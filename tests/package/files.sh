#!/bin/sh
# files.sh ROOT: Debian's tools read debian/, and each path that a package takes is one that ./x or CMake puts there.
set -eu
cd "$1"
version=$(dpkg-parsechangelog -l debian/changelog -S Version)
[ "$(sed -nE 's/^project\(durero VERSION ([0-9.]+).*/\1/p' CMakeLists.txt)" = "${version%%[-~+]*}" ] || { echo "debian/changelog: $version"; exit 1; }
packages=$(sed -n 's/^Package: //p' debian/control)
for package in $packages; do
  # What it says of itself is read as when the package is made.
  tmp=$(mktemp -d)
  dpkg-gencontrol -p"$package" -P"$tmp" -O -T/dev/null -Vshlibs:Depends= -Vmisc:Depends= >"$tmp/control"
  grep -qx "Version: $version" "$tmp/control" || { cat "$tmp/control"; echo "no version $version"; exit 1; }
  rm -r "$tmp"
  [ -f "debian/$package.install" ] || { echo "debian/$package.install: missing, so that $package is empty"; exit 1; }
done
for list in debian/*.docs debian/*.examples; do
  while read -r path; do
    # shellcheck disable=SC2086  # a pattern
    ls $path >/dev/null || { echo "$list: there is no $path"; exit 1; }
  done <"$list"
done
# The pages lie together where they are installed: a page that one of docs/ points to, in docs/, is taken too.
taken=$(while read -r path; do ls -d $path; done <debian/durero.docs)
grep -noE '\]\([^)#:]+' docs/[a-z]*.md | sed -E 's/:([0-9]+):\]\(/ \1 /' | while read -r page line link; do
  case $link in ../* | http*) continue ;; esac
  printf '%s\n' "$taken" | grep -qxF -e "docs/$link" -e "docs/${link%%/*}" || echo "$page:$line: debian/durero.docs does not take docs/$link"
done | { ! grep .; }
[ -x debian/rules ] || { echo "debian/rules: not executable"; exit 1; }
make -n -f debian/rules clean >/dev/null
echo "debian/ is read: version $version, packages" $packages
