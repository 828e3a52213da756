#!/bin/sh
# Five folders, one stem: what spec/STEM.tex says is carried out, tested and proved under the same name, and stands as
# printed in spec/impresa, but for what the paper has nothing of; a text of a refinement stands in the layer that it
# describes. And each public header, include/durero/LAYER/STEM.hpp of any layer, has one test, tests/LAYER/STEM_test.cpp,
# and one source, src/LAYER/STEM.cpp. The test is asked for always; the source where the header declares what one must
# define, which the linker tells: a header of templates, inline functions and values has none.
capital() { printf '%s' "$1" | cut -c1 | tr '[:lower:]' '[:upper:]' | tr -d '\n'; printf '%s' "$1" | cut -c2-; }
{
  for text in spec/*.tex; do
    stem=$(basename "$text" .tex)
    case $stem in
      promocion | tablas) layer=scene printed= ;;
      auditoria | distancias | distribuida | haces | historia | iluminacion | instancias | luz | malla | proyeccion | solidos) layer=model printed= ;;
      *) layer=model printed=spec/impresa/$stem.tex ;;
    esac
    for file in $printed "include/durero/$layer/$stem.hpp" "src/$layer/$stem.cpp" "tests/$layer/${stem}_test.cpp" \
      "proofs/$(capital "$stem").v"; do
      [ -f "$file" ] || echo "$text:1: its counterpart $file is missing"
    done
  done
  git ls-files 'include/durero/*.hpp' 'include/durero/*.h' | while read -r header; do
    stem=${header#include/durero/}
    test="tests/${stem%.h*}_test.cpp"
    [ -f "$test" ] || echo "$header:1: its test $test is missing"
  done
} | { ! grep .; }
