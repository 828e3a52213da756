#!/bin/sh
# Where the program finds the systems that it asks: from where it stands, whatever folder it was built in.
. "$(dirname "$0")/harness.sh"
unset DURERO_SYSTEMS
mkdir -p prefix/bin
cp "$durero" prefix/bin/durero
built=$durero
here=$(pwd -P)
durero=$here/prefix/bin/durero

# system FOLDER NAME: a folder with one system of that name.
system() {
  mkdir -p "$1/$2"
  {
    printf '{"format":"durero-system","version":1,"system":"%s","title":"T","ask":["true"],"profile":{"format":"binary64",' "$2"
    printf '"tipos":["esfera"],"caps":"open","measure":"parameter","directions":"any","inside":"exit_point","names_elements":true}}\n'
  } >"$1/$2/$2.json"
}

refused "$here/prefix/share/durero/systems: no folder" conform setup nothing
system sources beside
ln -s "$here/sources" prefix/bin/systems
refused 'no system "nothing"; expected one of beside' conform setup nothing
system prefix/share/durero/systems installed
refused 'no system "nothing"; expected one of installed' conform setup nothing
system named mine
export DURERO_SYSTEMS=named
refused 'no system "nothing"; expected one of mine' conform setup nothing
DURERO_SYSTEMS=''
refused 'no system "nothing"; expected one of installed' conform setup nothing
unset DURERO_SYSTEMS
durero=$built
refused 'no system "nothing"; expected one of ' conform setup nothing
has err ' embree'
finish
