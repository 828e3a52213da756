#!/bin/sh
# fresh_root.sh ROOT BUILD: ./x package builds the Debian packages and leaves nothing among the sources; in a root that
# holds Debian 12 and no more, apt installs them, the program works, and the examples of the library are built and run.
# Status 77: not root, or no debootstrap here. DEBIAN_MIRROR names another mirror than debootstrap's.
set -eu
root=$1 work=$2/package
PATH=$PATH:/usr/sbin
[ "$(id -u)" = 0 ] || { echo "package: not root"; exit 77; }
command -v debootstrap >/dev/null || { echo "package: no debootstrap here"; exit 77; }
fresh=$work/root
mkdir -p "$work"
umount "$fresh/proc" 2>/dev/null || true
rm -rf "$fresh"
fail() { tail -n 30 "$work/log"; echo "package: $*"; exit 1; }
sources() { (cd "$root" && find . -path ./build -prune -o -path ./.git -prune -o -type f -print | sort); }

sources >"$work/before"
"$root/x" package >"$work/packages" 2>"$work/log" || fail "no packages"
sources | diff "$work/before" - || fail "something was left among the sources"

debootstrap --variant=minbase bookworm "$fresh" ${DEBIAN_MIRROR:+"$DEBIAN_MIRROR"} >"$work/log" 2>&1 || fail "no fresh root"
cp /etc/resolv.conf "$fresh/etc/resolv.conf"
inside() { DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 chroot "$fresh" "$@" >>"$work/log" 2>&1 || fail "in the fresh root: $*"; }
says() { tail -n 20 "$work/log" | grep -qF -e "$1" || fail "it does not say: $1"; }
mount -t proc proc "$fresh/proc"
trap 'umount "$fresh/proc"' EXIT
while read -r package; do cp "$package" "$fresh/"; done <"$work/packages"
cp "$root/demo/still-life.json" "$root/demo/rays.txt" "$fresh/"

inside apt-get install -y --no-install-recommends $(cd "$fresh" && ls ./durero_*.deb)
inside test -f /usr/share/doc/durero/formats/scene.md
inside durero check still-life.json
inside durero trace still-life.json rays.txt
inside durero render still-life.json -o picture.png --samples 9
cmp "$fresh/picture.png" "$root/docs/still-life.png" || fail "it draws another picture"
chroot "$fresh" durero conform setup nothing >>"$work/log" 2>&1 || true
says 'expected one of'
says 'embree'

# The compiler and CMake, with which the examples are to build by what libdurero-dev depends on.
inside apt-get install -y --no-install-recommends g++ cmake make $(cd "$fresh" && ls ./libdurero-dev_*.deb)
inside cmake -S /usr/share/doc/libdurero-dev/examples -B /consume -DCMAKE_BUILD_TYPE=Release
inside cmake --build /consume
for program in $(sed -n 's/^==> .\/\(.*\)\.said <==$/\1/p' "$root/tests/consume/expected.txt"); do
  chroot "$fresh" "/consume/$program" >"$work/$program.said"
done
(cd "$work" && head -n 9 ./*.said) | diff "$root/tests/consume/expected.txt" - ||
  fail "the examples answer otherwise"
inside sh -c 'eval "c++ -O2 /usr/share/doc/libdurero-dev/examples/edit.cpp -o /edit $(pkg-config --cflags --libs durero)" && /edit'
inside sh -c 'eval "cc /usr/share/doc/libdurero-dev/examples/first_hit.c -o /first_hit $(pkg-config --cflags --libs durero-c)" && /first_hit'

inside apt-get purge -y durero libdurero-dev
[ ! -e "$fresh/usr/bin/durero" ] && [ ! -e "$fresh/usr/share/durero" ] || fail "something is left once they are purged"
umount "$fresh/proc"
trap - EXIT
rm -rf "$fresh"
echo "installed, used and purged in a fresh root"
