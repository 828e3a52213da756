#!/bin/sh
# Dependencies point one way: a layer includes only itself and the layers before it in this list.
order="text contract number zed model scene surface oracle trace accel engine io render conform cli"
git ls-files 'include/durero/*.hpp' 'src/*.cpp' 'src/*.hpp' | while read -r file; do
  layer=$(printf '%s\n' "$file" | sed -E 's#^(include/durero|src)/([a-z]+)/.*#\2#')
  allowed=$(printf '%s\n' "$order" | sed -E "s/\b$layer\b.*/$layer/")
  grep -nE '^#include "durero/' "$file" | while IFS= read -r line; do
    used=$(printf '%s\n' "$line" | sed -E 's#.*"durero/([a-z]+)/.*#\1#')
    case " $allowed " in
      *" $used "*) ;;
      *) echo "$file:${line%%:*}: layer $layer includes $used; expected one of: $allowed" ;;
    esac
  done
done | { ! grep .; }
