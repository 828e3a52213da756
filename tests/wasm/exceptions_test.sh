#!/bin/sh
# Exceptions by cmake/wasm/exceptions.cpp are caught, counted and released as a native program's are.
#   sh exceptions_test.sh ROOT
root=$1
skip() { echo "skipped: $*"; exit 77; }
command -v node >/dev/null 2>&1 || skip "there is no node"
command -v clang++-19 >/dev/null 2>&1 || skip "there is no clang++-19; ./x page installs it"
folder=$(mktemp -d) && trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
[ -f /usr/lib/wasm32-wasi/libc++.a ] || skip "there is no libc++ for WebAssembly; ./x page installs it"
c++ -std=c++20 -O1 "$root/tests/wasm/exceptions.cpp" -o native || exit 1
clang++-19 --target=wasm32-wasi -std=c++20 -O2 -fwasm-exceptions "$root/tests/wasm/exceptions.cpp" \
  "$root/cmake/wasm/exceptions.cpp" "$root/cmake/wasm/memory_of_objects.cpp" "$root/cmake/wasm/stack_guard.cpp" -o module.wasm || exit 1
cat >run.js <<'END'
const { WASI } = require("wasi"), wasi = new WASI({ version: "preview1" });
const module_ = new WebAssembly.Module(require("fs").readFileSync("module.wasm"));
process.exitCode = wasi.start(new WebAssembly.Instance(module_, { wasi_snapshot_preview1: wasi.wasiImport }));
END
./native >wanted || exit 1
node --no-warnings run.js >said || { echo "FAILED: the module ends with status $?"; cat said; exit 1; }
diff wanted said || { echo "FAILED: the module (>) says otherwise"; exit 1; }
[ "$(wc -l <wanted)" -ge 36 ] || { echo "FAILED: too few lines"; cat wanted; exit 1; }
