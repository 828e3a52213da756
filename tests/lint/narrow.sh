#!/bin/sh
# Whoever only stores shapes, asks for hits or hands edits on reads no operation of the text: a change of an operation
# compiles what looks into one and no more. The headers of the left include none of the right, by whatever way.
set -u
while read -r header unseen; do
  [ -f "include/durero/$header" ] && [ -f "include/durero/$unseen" ] || echo "tests/lint/narrow.sh:1: no $header or no $unseen; expected the headers' places"
  ${CXX:-c++} -std=c++20 -Iinclude -MM "include/durero/$header" | tr -s ' \\' '\n' | grep -qxF "include/durero/$unseen" &&
    echo "include/durero/$header:1: includes durero/$unseen, itself or by another header; expected the names alone, durero/model/operation.hpp"
done <<'EOF' | { ! grep .; }
scene/scene.hpp model/operaciones.hpp
scene/scene.hpp model/escena.hpp
scene/attributes.hpp model/operaciones.hpp
scene/groups.hpp model/operaciones.hpp
scene/hit.hpp model/operaciones.hpp
surface/equation.hpp model/escena.hpp
trace/search.hpp model/operaciones.hpp
engine/engine.hpp model/operaciones.hpp
io/json/scene_file.hpp model/operaciones.hpp
spec/spec.hpp model/operaciones.hpp
EOF
