#!/bin/sh
# release_roots.sh ROOT BUILD [STEP...]: ./x release of the committed tree, and its files in fresh roots; BUILD has a built program.
#   twice     two releases of one clone have the same bytes; no file names a folder of this machine, the wheel is small
#   program   the program of one file, in Debian 11, 12 and 13, in Ubuntu 22.04 and 24.04, and in a root that holds nothing
#             else: it draws README's picture, byte for byte, and ./x demo of the sources' tarball draws by it
#   wheel     README's lines of the wheel, in each of these systems whose Python has a wheel, from nothing to a verdict on a
#             tracer within two minutes, what apt fetches included
#   packages  apt installs the Debian package, and it works
# Without a STEP: all. The second release finds by ccache, where that is there, what the first has compiled; reproducible/twice
# compiles everything anew. A system whose mirror or whose keys (ubuntu-keyring) are not at hand is named as not tried;
# Debian 12 must be. DEBIAN_MIRROR and UBUNTU_MIRROR name other mirrors. Status 77: not root, or no debootstrap, no unshare or
# no git history here.
set -eu
if [ -z "${RELEASE_ROOTS_INSIDE-}" ]; then  # a namespace of its own takes mounts along, however the test ends
  [ "$(id -u)" = 0 ] || { echo "release: not root"; exit 77; }
  unshare --mount --pid --fork true 2>/dev/null || { echo "release: no namespaces here"; exit 77; }
  RELEASE_ROOTS_INSIDE=yes exec unshare --mount --propagation private --pid --fork --kill-child sh "$0" "$@"
fi
root=$(CDPATH='' cd -- "$1" && pwd)
built=$(CDPATH='' cd -- "$2" && pwd)/durero
mkdir -p "$2/release_roots"
work=$(CDPATH='' cd -- "$2/release_roots" && pwd)
shift 2
[ $# -gt 0 ] || set -- twice program wheel packages
PATH=$PATH:/usr/sbin:/sbin
command -v debootstrap >/dev/null || { echo "release: no debootstrap here"; exit 77; }
git -C "$root" rev-parse --verify -q HEAD >/dev/null || { echo "release: no git history here"; exit 77; }
[ -z "$(git -C "$root" status --porcelain)" ] || echo "release: what is not committed is not tried"
version=$(sed -nE 's/^project\(durero VERSION ([0-9.]+).*/\1/p' "$root/CMakeLists.txt")
release=$work/release
program=durero-$version-x86_64
log=$work/log
fail() { tail -n 40 "$log"; echo "release: $*; the whole log is $log"; exit 1; }
: >"$log"

do_twice() {
  rm -rf "$work/clone" "$release"
  git clone -q "$root" "$work/clone"
  for run in first second; do
    begin=$(date +%s)
    "$work/clone/x" release >"$work/said" 2>"$log" || fail "no $run release"
    echo "release: the $run took $(($(date +%s) - begin)) s"
    [ "$run" = second ] || mv "$(cat "$work/said")" "$release"
  done
  diff -r "$release" "$(cat "$work/said")" >>"$log" || fail "two releases differ"
  (cd "$release" && sha256sum --quiet -c SHA256SUMS) >>"$log" || fail "other digests than in SHA256SUMS"
  [ "$(ls "$release" | grep -vc '^SHA256SUMS$')" = "$(wc -l <"$release/SHA256SUMS")" ] || fail "a file without a digest"
  for wheel in "$release"/*.whl; do
    [ "$(wc -c <"$wheel")" -le 10000000 ] || fail "${wheel##*/} has $(wc -c <"$wheel") bytes; expected 10 MB at most"
  done
  rm -rf "$work/unpacked"
  mkdir "$work/unpacked"
  for wheel in "$release"/*.whl; do python3 -m zipfile -e "$wheel" "$work/unpacked"; done
  for package in "$release"/*.deb; do dpkg-deb -x "$package" "$work/unpacked"; done
  ! grep -raF -e "$work/" "$work/unpacked" "$release" >>"$log" || fail "a file names a folder of this machine"
  rm -rf "$work/unpacked" "$work/clone"
}

# make_root SYSTEM: a fresh root of its minimum in $fresh; status 1 where the system is not to be had here.
make_root() {
  fresh=$work/$1
  rm -rf --one-file-system "$fresh"
  set -- "$1" ''
  case $1 in
    jammy | noble)
      keys=/usr/share/keyrings/ubuntu-archive-keyring.gpg
      [ -f "$keys" ] || { echo "release: $1 is not tried: no $keys"; return 1; }
      # Ubuntu's releases have one script, whose name is that of the first; an older debootstrap knows no newer name.
      set -- "$1" "--keyring=$keys" "${UBUNTU_MIRROR:-http://archive.ubuntu.com/ubuntu} /usr/share/debootstrap/scripts/gutsy" ;;
    *) set -- "$1" '' "${DEBIAN_MIRROR-}" ;;
  esac
  # shellcheck disable=SC2086  # words that may be absent
  debootstrap --variant=minbase --include=ca-certificates $2 "$1" "$fresh" $3 >"$log" 2>&1 || {
    [ "$1" != bookworm ] || fail "no root of Debian 12"
    echo "release: $1 is not tried: no root: $(tail -n 1 "$log")"
    rm -rf --one-file-system "$fresh"
    return 1
  }
  # Debian 11, 12 and 13 and Ubuntu's releases have main alone then; Ubuntu has python3-venv in universe.
  case $1 in jammy | noble) sed -i 's/ main$/ main universe/' "$fresh/etc/apt/sources.list" ;; esac
  cp /etc/resolv.conf /etc/hosts "$fresh/etc/"
  mkdir -p "$fresh/etc/ssl/certs"
  cp /etc/ssl/certs/ca-certificates.crt "$fresh/etc/ssl/certs/ca-certificates.crt"
  [ ! -f /etc/pip.conf ] || cp /etc/pip.conf "$fresh/etc/pip.conf"
  mount -t proc proc "$fresh/proc"
  mkdir "$fresh/newcomer"
}
drop_root() { umount "$fresh/proc"; rm -rf --one-file-system "$fresh"; }

# inside COMMAND...: in the fresh root, in a clean environment, in the folder of a newcomer.
inside() {
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/newcomer LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+"http_proxy=$http_proxy"} ${https_proxy:+"https_proxy=$https_proxy"} \
    chroot "$fresh" sh -ec 'cd /newcomer; "$@"' sh "$@" </dev/null >>"$log" 2>&1
}

program_in_root() {
  cp "$release/$program" "$release/SHA256SUMS" "$fresh/newcomer/"
  tar -xzf "$release/durero-$version.tar.gz" -C "$fresh/newcomer"
  mv "$fresh/newcomer/$program" "$fresh/newcomer/SHA256SUMS" "$fresh/newcomer/durero-$version/"
  inside sh -c "cd durero-$version && ./x demo" || fail "$1: ./x demo by the program of one file: status $?"
  grep -qF 'nothing is built' "$log" || fail "$1: ./x demo does not say by which program it draws"
  [ -s "$fresh/newcomer/durero-$version/durero-demo.png" ] || fail "$1: ./x demo leaves no picture"
  inside sh -c "cd durero-$version && ./$program render demo/still-life.json -o ../picture.png --samples 9" || fail "$1: it does not draw"
  cmp "$fresh/newcomer/picture.png" "$root/docs/still-life.png" || fail "$1: it draws another picture"
  # The digests of a store are those of the program that looks them up in libcrypto; the server asks for the address of a name.
  inside sh -c "cd durero-$version && ./$program store init ../a.store --from demo/still-life.json --author a --time 2026-01-31T12:00:00Z" ||
    fail "$1: it makes no store"
  cmp "$fresh/newcomer/a.store" "$work/a.store" || fail "$1: it makes another store"
  inside sh -c "cd durero-$version && ./$program serve ../a.store --host localhost --port 0 >../served & sleep 3; kill -TERM \$!"
  grep -q 'http://' "$fresh/newcomer/served" || fail "$1: it does not serve"
  echo "release: $1: the program of one file draws README's picture"
}

do_program() {
  rm -f "$work"/a.store*
  # A store names the file that it begins with.
  (cd "$root" && "$built" store init "$work/a.store" --from demo/still-life.json --author a --time 2026-01-31T12:00:00Z) >>"$log" ||
    fail "the built program makes no store"
  # A root that has nothing but the program, a scene and its file of edits: no library, no shell.
  fresh=$work/nothing
  rm -rf "$fresh"
  mkdir -p "$fresh/tmp"
  cp "$release/$program" "$root/demo/still-life.json" "$fresh/"
  chroot "$fresh" "/$program" render /still-life.json -o /picture.png --samples 9 >"$log" 2>&1 || fail "nothing else: it does not draw"
  cmp "$fresh/picture.png" "$root/docs/still-life.png" || fail "nothing else: it draws another picture"
  rm -rf "$fresh"
  echo "release: a root of nothing else: the program of one file draws README's picture"
  tried=0
  for system in bullseye bookworm trixie jammy noble; do
    make_root "$system" || continue
    program_in_root "$system"
    tried=$((tried + 1))
    drop_root
  done
  echo "release: the program of one file in $tried systems"
}

# wheel_lines: README's lines of the wheel.
wheel_lines() {
  awk '/^## In a minute/ { here = 1 } here && /^```console/ { inside = 1; next } inside && /^```/ { exit } inside' "$root/README.md"
}

wheel_in_root() {
  inside apt-get update || fail "$1: no list of packages"
  python=$(inside_says apt-cache depends python3 | sed -nE 's/.*Depends: python(3\.[0-9]+)$/\1/p' | head -n 1)
  set -- "$1" "$release"/durero-*-cp"$(printf %s "$python" | tr -d .)"-*.whl
  [ -f "$2" ] || { echo "release: $1: there is no wheel for Python $python"; return 0; }
  cp "$2" "$fresh/newcomer/"
  wheel_lines >"$fresh/newcomer/lines"
  [ "$(wc -l <"$fresh/newcomer/lines")" -ge 4 ] || fail "README has no lines of the wheel"
  begin=$(date +%s)
  inside apt-get install -y --no-install-recommends python3-venv || fail "$1: no Python"
  status=0
  inside bash -c '. ./lines' || status=$?
  took=$(($(date +%s) - begin))
  [ "$status" = 1 ] || fail "$1: the lines of the wheel end with status $status; expected 1, since the tracer is wrong"
  tail -n 60 "$log" | grep -q 'gross' || fail "$1: there is no verdict"
  [ "$took" -le 120 ] || fail "$1: a verdict after $took s; expected 120 at most"
  inside sh -c '. venv/bin/activate && python -c "import durero; print(durero.__version__)" && durero spec show reduccion >/dev/null' ||
    fail "$1: the package, or the command, does not work"
  echo "release: $1, Python $python: from nothing to a verdict in $took s"
}
inside_says() { env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 chroot "$fresh" "$@" 2>/dev/null; }

do_wheel() {
  for system in bookworm trixie jammy noble; do
    make_root "$system" || continue
    wheel_in_root "$system"
    drop_root
  done
}

do_packages() {
  make_root bookworm
  cp "$release"/durero_*.deb "$fresh/newcomer/"
  inside sh -c 'apt-get update && apt-get install -y --no-install-recommends ./durero_*.deb' || fail "the Debian package does not install"
  cp "$root/demo/still-life.json" "$fresh/newcomer/"
  inside durero check still-life.json || fail "the installed program does not work"
  drop_root
  echo "release: the Debian package is installed and works"
}

for step in "$@"; do
  case $step in twice | program | wheel | packages) "do_$step" ;;
    *) echo "release: no step $step; expected twice, program, wheel or packages"; exit 2 ;;
  esac
done
