#!/bin/sh
# release_refusals.sh ROOT: what is no release is refused by one line, before anything is built or fetched; and a section of the
# changelog is found whole. The tree at hand is a small one with a history of its own.
set -eu
root=$1
tmp=$(mktemp -d)
trap 'rm -rf "$tmp"' EXIT
cd "$tmp"
mkdir tree
cp -R "$root/release" tree/release
cd tree
git init -q .
git config user.name Release
git config user.email release@durero.invalid
echo 'project(durero VERSION 1.2.3 LANGUAGES CXX' >CMakeLists.txt
printf '# Changelog\n\n## [1.2.3] - Unreleased\n\nNew.\n\n- a\n\n## [1.2.2] - 2026-01-01\n\nOld.\n' >CHANGELOG.md
echo /build/ >.gitignore
bad=0
refused() {  # refused WORDS OPTION...
  words=$1
  shift
  status=0
  sh release/release.sh . "$@" >../said 2>../complaint || status=$?
  [ "$status" = 2 ] && [ "$(wc -l <../complaint)" = 1 ] && grep -qF -e "$words" ../complaint ||
    { echo "release $*: status $status; expected 2 and a line with: $words"; cat ../complaint; bad=$((bad + 1)); }
}
refused 'no git history here'
git add -A
git commit -qm 'build: begin'
refused 'does not know --tags; expected --tag' --tags
refused '[1.2.3] is unreleased; expected its date' --tag
: >new.txt
refused 'new.txt is not committed'
rm new.txt
sed -i 's/Unreleased/2026-02-01/' CHANGELOG.md
refused 'CHANGELOG.md is not committed'
git commit -qam 'build: release'
git tag v1.2.3
refused 'the tag v1.2.3 is there' --tag
[ "$(ls build/release-work 2>/dev/null)" = '' ] || { echo "a refused release leaves files"; bad=$((bad + 1)); }

[ "$(sh release/changes.sh 1.2.3 <CHANGELOG.md)" = "$(printf 'New.\n\n- a\n')" ] || { echo "another section of 1.2.3"; bad=$((bad + 1)); }
[ "$(sh release/changes.sh 1.2.2 <CHANGELOG.md)" = 'Old.' ] || { echo "another section of 1.2.2"; bad=$((bad + 1)); }
! sh release/changes.sh 1.2 <CHANGELOG.md >/dev/null || { echo "a section of a version that is none"; bad=$((bad + 1)); }
echo "releases that are none: $bad failures"
[ "$bad" = 0 ]
