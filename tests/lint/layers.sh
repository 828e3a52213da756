#!/bin/sh
# Dependencies point one way: a layer includes only itself and the layers before it in this list. What is in src/ belongs
# to its layer alone: no public header includes it, nor any other layer. src/lanes, which has to do with the compiler alone,
# belongs to none.
order="text contract number algebra polygon mesh zed lsp model scene spec surface oracle trace accel distance engine composed io written store render raster shader conform serve web c cli"
git grep -nE '^#include "' -- 'include/durero/*.hpp' 'src/*.cpp' 'src/*.hpp' | awk -F: -v order="$order" '
  BEGIN { count = split(order, name, " "); for (i = 1; i <= count; ++i) rank[name[i]] = i }
  function complain(what) { print $1 ":" $2 ": " what }
  {
    path = $1
    public = sub(/^include\/durero\//, "", path)
    if (!public) sub(/^src\//, "", path)
    layer = path; sub(/\/.*/, "", layer)
    used = $3; sub(/^#include "/, "", used); sub(/".*/, "", used)
    if (sub(/^durero\//, "", used)) {
      sub(/\/.*/, "", used)
      if (!(used in rank) || rank[used] > rank[layer])
        complain("layer " layer " includes " used "; expected a layer before it in: " order)
    } else if (public) {
      complain("a public header includes an internal one")
    } else if (sub(/\/.*/, "", used) && used in rank && used != layer) {
      complain("layer " layer " includes an internal header of " used "; expected a public one")
    }
  }' | { ! grep .; }
