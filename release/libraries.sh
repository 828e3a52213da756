#!/bin/sh
# libraries.sh FOLDER: the libraries that a wheel and the program of one file carry, as archives, in FOLDER/prefix.
# Debian has no archives of some of them, and of others none that a module of Python can hold: an archive whose code reads
# `stderr` or a variable of a thread must be compiled by -fPIC. Those are compiled here, of Debian's own sources, which
# apt-get fetches and verifies. The archives of SQLite, zlib, libcrypto and libedit are Debian's.
# FOLDER/prefix/sources.txt names each source package and its version; FOLDER/lgpl has the sources of those that come under the
# LGPL, glibc's too, which a release hands on. A library that is there already, of the same version and by the same script,
# is not compiled again.
set -eu
[ $# = 1 ] || { echo "libraries: expected FOLDER" >&2; exit 2; }
self=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)/$(basename -- "$0")
mkdir -p "$1"
folder=$(CDPATH='' cd -- "$1" && pwd)
prefix=$folder/prefix
say() { printf '%s\n' "$*" >&2; }
give_up() { say "libraries: $*"; exit 2; }

# Flags: -ffile-prefix-map keeps the name of FOLDER out of what is compiled; a section for each function lets the linker
# leave out what nothing calls.
flags="-O2 -fPIC -ffunction-sections -fdata-sections -ffile-prefix-map=$folder/="
ccache=$(command -v ccache || :)
jobs=$(nproc)
lgpl='gmp mpfr4 flint glibc'

# apt_of_sources COMMAND...: apt-get with lists of its own, so that the machine's stay as they are.
apt_of_sources() {
  apt-get -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$folder/apt/parts" \
    -o Dir::State::Lists="$folder/apt/lists" -o Dir::Cache="$folder/apt/cache" -o APT::Sandbox::User=root "$@"
}

# list_sources: reads which source packages there are, from where the machine has its packages.
list_sources() {
  [ ! -e "$folder/apt/read" ] || return 0
  mkdir -p "$folder/apt/parts" "$folder/apt/lists/partial" "$folder/apt/cache/archives/partial"
  for file in /etc/apt/sources.list.d/debian.sources; do
    [ ! -f "$file" ] || sed -E 's/^Types:.*/Types: deb-src/' "$file" >"$folder/apt/parts/debian.sources"
  done
  [ ! -f /etc/apt/sources.list ] || sed -nE 's/^deb(-src)? /deb-src /p' /etc/apt/sources.list >"$folder/apt/parts/debian.list"
  apt_of_sources -qq update >"$folder/log" 2>&1 || { tail -n 5 "$folder/log" >&2; give_up "no list of Debian's sources"; }
  : >"$folder/apt/read"
}

# versions SOURCE PACKAGE: those of a source package that may be fetched: that of its installed package first, then the newest.
versions() {
  dpkg-query -W -f '${source:Version}\n' "$2" 2>/dev/null || :
  apt-cache -o Dir::Etc::SourceList=/dev/null -o Dir::Etc::SourceParts="$folder/apt/parts" \
    -o Dir::State::Lists="$folder/apt/lists" -o Dir::Cache="$folder/apt/cache" showsrc "$1" |
    sed -n 's/^Version: //p' | sort -ruV
}

# fetch SOURCE PACKAGE: the sources of a library in FOLDER/src/SOURCE, of the version of the installed package where its
# sources are offered. A mirror may hold an older one alone; a line says so.
fetch() {
  source=$1
  wanted=''
  rm -rf "$folder/src/$source"
  mkdir -p "$folder/src/$source"
  for version in $(versions "$source" "$2"); do
    wanted=${wanted:-$version}
    (cd "$folder/src/$source" && apt_of_sources -qq source "$source=$version") >"$folder/log" 2>&1 || continue
    [ "$version" = "$wanted" ] || say "libraries: no sources of $source $wanted are offered; version $version is compiled"
    case " $lgpl " in *" $source "*)
      mkdir -p "$folder/lgpl/$source"
      find "$folder/lgpl/$source" -type f -delete
      find "$folder/src/$source" -maxdepth 1 -type f -exec cp {} "$folder/lgpl/$source" \; ;;
    esac
    set -- "$folder/src/$source"/*/
    mv "$1" "$folder/src/$source/tree"
    printf '%s\n' "$version" >"$folder/src/$source/version"
    return 0
  done
  tail -n 5 "$folder/log" >&2
  give_up "no sources of $source"
}

# by_cmake OPTION...: configures, compiles and installs the sources at hand.
by_cmake() {
  cmake -S "$folder/src/$source/tree" -B "$folder/src/$source/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_C_FLAGS="$flags" -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_C_FLAGS_RELEASE= -DCMAKE_CXX_FLAGS_RELEASE= \
    ${ccache:+-DCMAKE_C_COMPILER_LAUNCHER="$ccache" -DCMAKE_CXX_COMPILER_LAUNCHER="$ccache"} \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_PREFIX_PATH="$prefix" \
    -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON "$@"
  cmake --build "$folder/src/$source/build" -j "$jobs"
  cmake --install "$folder/src/$source/build"
}

# by_configure OPTION...: the same by a script of GNU's. The machine is named, so that no processor of the one at hand is.
by_configure() {
  (
    cd "$folder/src/$source/tree"
    ./configure --build=x86_64-linux-gnu --prefix="$prefix" --disable-shared --enable-static --with-pic "$@" \
      CC="${ccache:+$ccache }gcc" CFLAGS="$flags"
    make -j "$jobs"
    make install
  )
}

# Recipes: make_SOURCE compiles a library. Debian's package of GMP has no documents, for which its Makefile asks.
make_gmp() {
  mkdir -p "$folder/src/gmp/tree/doc"
  printf 'all install check clean:\n' >"$folder/src/gmp/tree/doc/Makefile.in"
  by_configure --disable-fat
}
make_mpfr4() { by_configure --with-gmp="$prefix"; }
make_flint() {
  by_cmake -DWITH_NTL=OFF -DGMP_INCLUDE_DIRS="$prefix/include" -DGMP_LIBRARIES="$prefix/lib/libgmp.a" \
    -DMPFR_INCLUDE_DIRS="$prefix/include" -DMPFR_LIBRARIES="$prefix/lib/libmpfr.a"
}
make_libpng1_6() { by_cmake -DPNG_SHARED=OFF -DPNG_TESTS=OFF -DPNG_BUILD_ZLIB=OFF; }
make_libjpeg_turbo() { by_cmake -DCMAKE_INSTALL_LIBDIR="$prefix/lib" -DENABLE_SHARED=OFF -DWITH_SIMD=OFF -DWITH_TURBOJPEG=OFF; }
make_fmtlib() { by_cmake -DFMT_TEST=OFF -DFMT_DOC=OFF; }
make_onetbb() { by_cmake -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DTBB_DISABLE_HWLOC_AUTOMATIC_SEARCH=ON; }
make_highway() { by_cmake -DHWY_ENABLE_CONTRIB=OFF -DHWY_ENABLE_TESTS=OFF -DHWY_ENABLE_EXAMPLES=OFF; }
make_imath() { by_cmake -DIMATH_INSTALL_SYM_LINK=OFF; }
make_openexr() { by_cmake -DOPENEXR_INSTALL_TOOLS=OFF -DOPENEXR_INSTALL_EXAMPLES=OFF -DOPENEXR_BUILD_TOOLS=OFF; }
make_pugixml() { by_cmake; }
# libtinfo, for libedit: the rest of ncurses is not compiled. Descriptions of terminals are found where Debian and others have them.
make_ncurses() {
  (
    cd "$folder/src/ncurses/tree"
    ./configure --build=x86_64-linux-gnu --prefix="$prefix" --without-shared --without-debug --without-cxx-binding --without-ada \
      --without-progs --without-tests --without-manpages --with-termlib=tinfo --enable-widec --disable-db-install --enable-pc-files \
      --with-default-terminfo-dir=/etc/terminfo --with-terminfo-dirs=/etc/terminfo:/lib/terminfo:/usr/share/terminfo \
      CC="${ccache:+$ccache }gcc" CFLAGS="$flags"
    make -C include -j "$jobs"
    make -C ncurses -j "$jobs" ../lib/libtinfo.a
    cp lib/libtinfo.a "$prefix/lib/libtinfo.a"
  )
}
make_glibc() { :; }  # Debian's archive is linked; its sources are handed on
# cpp-httplib: its one header, without TLS and compression, which the server does not use.
make_cpp_httplib() {
  mkdir -p "$prefix/include" "$prefix/lib/pkgconfig"
  cp "$folder/src/$source/tree/httplib.h" "$prefix/include/httplib.h"
  version=$(sed -n 's/^#define CPPHTTPLIB_VERSION "\(.*\)"$/\1/p' "$prefix/include/httplib.h")
  printf 'Name: cpp-httplib\nDescription: HTTP\nVersion: %s\nCflags: -I%s/include -pthread\nLibs: -pthread\n' "$version" "$prefix" \
    >"$prefix/lib/pkgconfig/cpp-httplib.pc"
}

# library SOURCE PACKAGE: fetches and compiles it, unless that is done.
library() {
  done_by="$folder/done/$1"
  mark="$(dpkg-query -W -f '${source:Version}' "$2" 2>/dev/null || :) $(cksum <"$self")"
  if [ -f "$done_by" ] && [ "$(head -n 1 "$done_by")" = "$mark" ]; then return 0; fi
  list_sources
  say "libraries: $1"
  fetch "$1" "$2"
  source=$1
  "make_$(printf %s "$1" | tr '.-' '__')" >"$folder/$1.log" 2>&1 || { tail -n 30 "$folder/$1.log" >&2; give_up "$1 is not compiled"; }
  { printf '%s\n' "$mark"; cat "$folder/src/$1/version"; } >"$done_by"
  rm -rf "$folder/src/$1"
}

mkdir -p "$folder/done" "$prefix"
while read -r source package; do library "$source" "$package"; done <<'END'
gmp libgmp-dev
mpfr4 libmpfr-dev
flint libflint-dev
libpng1.6 libpng-dev
libjpeg-turbo libjpeg62-turbo-dev
fmtlib libfmt-dev
onetbb libtbb-dev
highway libhwy-dev
imath libimath-dev
openexr libopenexr-dev
pugixml libpugixml-dev
cpp-httplib libcpp-httplib-dev
ncurses libncurses-dev
glibc libc6-dev
END
for library in "$folder"/done/*; do printf '%s %s\n' "${library##*/}" "$(tail -n 1 "$library")"; done >"$prefix/sources.txt"
