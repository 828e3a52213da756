#!/bin/sh
# The engine of the page as one script: web/engine.js, and behind it the module, gzip in base 64, in lines of 64 kB.
#   sh cmake/wasm/engine.sh MODULE.wasm web/engine.js > OUT.js
set -eu
cat "$2"
printf '\nconst module_text = ""'
gzip -9 -n -c "$1" | base64 -w 65536 | sed 's/.*/\n  + "&"/'
printf ';\n'
