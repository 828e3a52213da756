#!/bin/sh
# bare_root.sh ROOT BUILD [STEP...]: what README and docs/*.md tell a newcomer to type, in a root that holds Debian 12's
# minimum, git and ca-certificates and no more, in an environment of PATH, HOME and LANG. The committed tree is cloned there.
#   demo      ./x demo, then the picture is there
#   install   every block of README and docs/*.md that installs something, in a clone of its own
#   test      ./x test, in the clone of the demonstration
# Without a STEP: all three. How long each took is printed. BUILD/bare_root holds a log of each step.
# Apt inside fetches as apt outside does: from DEBIAN_MIRROR, or else as /etc/apt says, whose sources and whose files with
# a setting `Acquire` are copied; the variables http_proxy and https_proxy are handed on. Status 77: not root, or no
# debootstrap, no unshare or no git history here.
set -eu
# A namespace of its own takes mounts and processes along, however the test ends; then the root holds files alone.
if [ -z "${BARE_ROOT_INSIDE-}" ]; then
  [ "$(id -u)" = 0 ] || { echo "bare root: not root"; exit 77; }
  unshare --mount --pid --fork true 2>/dev/null || { echo "bare root: no namespaces here"; exit 77; }
  BARE_ROOT_INSIDE=yes unshare --mount --propagation private --pid --fork --kill-child sh "$0" "$@" &
  child=$!
  trap 'kill -KILL "$child"; status=130' INT TERM HUP
  wait "$child" && status=${status-0} || status=${status-$?}
  rm -rf --one-file-system "$2/bare_root/root"
  exit "$status"
fi
root=$(CDPATH='' cd -- "$1" && pwd)
work=$(CDPATH='' cd -- "$2" && pwd)/bare_root
shift 2
[ $# -gt 0 ] || set -- demo install test
for step in "$@"; do
  case $step in demo | install | test) ;; *) echo "bare root: no step $step; expected demo, install or test"; exit 2 ;; esac
done
PATH=$PATH:/usr/sbin:/sbin
command -v debootstrap >/dev/null || { echo "bare root: no debootstrap here"; exit 77; }
git -C "$root" rev-parse --verify -q HEAD >/dev/null || { echo "bare root: no git history here"; exit 77; }
[ -z "$(git -C "$root" status --porcelain)" ] || echo "bare root: what is not committed is not tried"
fresh=$work/root
fail() { tail -n 40 "$log"; echo "bare root: $*; the whole log is $log"; exit 1; }

# inside COMMAND...: in the bare root, in a clean environment; its output goes to the log.
inside() {
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/newcomer LANG=C.UTF-8 \
    ${http_proxy:+"http_proxy=$http_proxy"} ${https_proxy:+"https_proxy=$https_proxy"} \
    chroot "$fresh" "$@" </dev/null >>"$log" 2>&1
}

# timed STEP: runs the function do_STEP and says how long it took.
timed() {
  log=$work/$1.log
  : >"$log"
  begin=$(date +%s)
  "do_$1"
  echo "bare root: $1 took $(($(date +%s) - begin)) s"
}

do_root() {
  mirror=${DEBIAN_MIRROR:-$(sed -nE 's/^URIs: *([^ ]*).*/\1/p; s/^deb +(\[[^]]*\] +)?([^ ]*).*/\2/p' \
    /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list 2>/dev/null | head -n 1)}
  debootstrap --variant=minbase --include=git,ca-certificates bookworm "$fresh" ${mirror:+"$mirror"} >"$log" 2>&1 ||
    fail "no bare root"
  if [ -z "${DEBIAN_MIRROR-}" ]; then
    rm -f "$fresh/etc/apt/sources.list"
    for file in /etc/apt/sources.list /etc/apt/sources.list.d/debian.sources $(grep -l '^ *Acquire' /etc/apt/apt.conf.d/* 2>/dev/null); do
      [ ! -f "$file" ] || cp "$file" "$fresh$file"
    done
  fi
  cp /etc/resolv.conf /etc/hosts "$fresh/etc/"
  # What this machine trusts besides Debian's certificates, and how its pip fetches.
  cp /etc/ssl/certs/ca-certificates.crt "$fresh/etc/ssl/certs/ca-certificates.crt"
  [ ! -f /etc/pip.conf ] || cp /etc/pip.conf "$fresh/etc/pip.conf"
  mount -t proc proc "$fresh/proc"
  mount --bind /dev/pts "$fresh/dev/pts"
  mkdir "$fresh/newcomer"
  git -C "$root" bundle create -q "$fresh/newcomer/durero.bundle" HEAD
}

clone() { [ -d "$fresh/newcomer/$1" ] || inside git clone -q /newcomer/durero.bundle "/newcomer/$1" || fail "no clone"; }

do_demo() {
  clone durero
  inside sh -c 'cd /newcomer/durero && ./x demo' || fail "./x demo: status $?"
  [ -s "$fresh/newcomer/durero/durero-demo.png" ] || fail "./x demo leaves no picture"
}

do_install() {
  clone installed
  # The programs that docs/library.md compiles lie where its lines are typed.
  cp "$root"/tests/consume/programs/*.c "$root"/tests/consume/programs/*.cpp "$fresh/newcomer/installed/"
  sh "$root/tests/docs/install_lines.sh" "$root" >"$fresh/newcomer/lines"
  cat "$fresh/newcomer/lines" >>"$log"
  inside sh -ec 'cd /newcomer/installed; . /newcomer/lines; python3 -c "import durero; print(durero.__version__)"' ||
    fail "the documented lines do not install: status $?"
  [ -x "$fresh/opt/durero/bin/durero" ] || fail "no program is installed"
}

do_test() {
  clone durero
  inside sh -c 'cd /newcomer/durero && ./x test' || fail "./x test: status $?"
  ! grep -q 'python/absent' "$log" || fail "./x test: no Python module, though the demonstration was drawn first"
  tail -n 30 "$log" | sed -n '/tests passed/p; /^Total Test time/p'
}

rm -rf --one-file-system "$fresh"
mkdir -p "$work"
timed root
for step in "$@"; do timed "$step"; done
