#!/bin/sh
# A rule that cannot fail is no rule: this plants, in a copy of the tree, the fault that each rule should see, and
# fails where the rule says nothing.
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
copy=$(mktemp -d) && trap 'rm -rf "$copy"' EXIT
(cd "$here/../.." && git ls-files -z | xargs -0 tar cf - 2>/dev/null) | tar xf - -C "$copy"
cd "$copy" || exit 2
git init -q . && git add -A
drills=0 missed=0

# sees RULE WHAT: runs the rule on the tree with its fault, then undoes the fault.
sees() {
  drills=$((drills + 1))
  git add -A
  if sh "$here/$1.sh" >/dev/null 2>&1; then
    echo "drill: $1.sh does not see: $2"
    missed=$((missed + 1))
  fi
  git read-tree -u --reset "$clean"
  git clean -fdq
}
clean=$(git write-tree)  # the tree without any fault

for rule in layers edges independence stems house labels mutants z_text specified draws requirements standard_output packages \
  versions reference optimised narrow flush commits rooms types glossary; do
  sh "$here/$rule.sh" >/dev/null 2>&1 || { echo "drill: $rule.sh fails before any fault is planted"; missed=$((missed + 1)); }
done

echo '#include "durero/io/scene.hpp"' >>include/durero/number/rational.hpp
sees layers "number including io"
echo '#include "durero/trace/analytic.hpp"' >>src/oracle/sampled.cpp
sees layers "oracle including trace"
echo '#include "durero/render/output/image.hpp"' >>src/io/json/json.cpp
sees layers "io including render"
echo '#include "trace/steps.hpp"' >>src/engine/engine.cpp
sees layers "engine including an internal header of trace"
echo '#include "trace/steps.hpp"' >>include/durero/trace/analytic.hpp
sees layers "a public header including an internal one"
sed -i '/"trace\/optimised.hpp"/d' src/trace/stable.cpp
sees optimised "lanes compiled without optimisation"
sed -i 's/ src\/trace\/rounding.cpp//' CMakeLists.txt
sees optimised "lanes not optimised in Debug"
sed -i 's/model\/operation.hpp/model\/operaciones.hpp/' include/durero/scene/groups.hpp
sees narrow "a header that hands operations on and reads them all"
sed -i 's/^durero_layer(zed DEPENDS /&contract /' CMakeLists.txt
sees edges "an edge that no include needs"
sed -i 's/^durero_layer(render DEPENDS contract model/durero_layer(render DEPENDS contract/' CMakeLists.txt
sees edges "an include that no edge names"
sed -i 's/PRIVATE durero::text /PRIVATE /' CMakeLists.txt
sees edges "a layer that the program includes and does not link"
echo '#include "durero/surface/equation.hpp"' >>src/oracle/sampled.cpp
sees independence "an oracle that knows the equation of a surface"
echo '#include "durero/surface/exact.hpp"' >>tests/conform/reference.hpp
sees independence "the tests' reference asking what it is held against"
git mv tests/model/puntos_test.cpp tests/model/points_test.cpp
sees stems "a stem of the Z text without its test"
touch spec/nuevo.tex
sees stems "a new stem without counterparts"
git mv tests/scene/hit_test.cpp tests/scene/hits_test.cpp
sees stems "a public header whose test has another name"
echo '#pragma once' >include/durero/surface/shape/torus.hpp
sees stems "a new public header without a test"
echo '// T''ODO' >>src/oracle/sampled.cpp
sees house "an unfinished place"
echo '# /w''ork/here' >>README.md
sees house "a path of one machine"
echo 'TEST_CASE("x", "[.]") {}' >>tests/oracle/sampled_test.cpp
sees house "a test that is switched off"
sed -i '0,/% Escena.inv.1$/s/% Escena.inv.1$/% Escena.inv.99/' spec/escena.tex
sees labels "a predicate whose label no clause has"
sed -i 's/ *% Escena.inv.2$//' spec/escena.tex
sees labels "a predicate without a label"
sed -i 's/ *% Hay_Interseccion.post.2$//' spec/interseccion.tex
sees labels "a predicate of several lines without a label"
sed -i 's/ *% Eliminar_Cono_Total.def.1$//' spec/operaciones.tex
sees labels "a definition without a label"
sed -i 's/Primera_Interseccion\.def\.1//' include/durero/model/interseccion.hpp
sees labels "a total operation that no function carries out"
grep -rl 'Agregar_Cono\.pre\.4' tests --include=*.cpp | xargs sed -i 's/Agregar_Cono\.pre\.4/Agregar_Cono_pre_4/'
sees labels "a clause that no test violates"
grep -rl '"Escena\.inv\.3"' include src | xargs sed -i 's/"Escena\.inv\.3"/"Escena.inv.77"/'
sees labels "a clause of no predicate"
sed -i '/>{&Agregar_Cono_post_4}/d' include/durero/model/tipo/cono.hpp
sees labels "a clause of model that nothing evaluates"
sed -i 's/clause Con_Radio_pre_1/clause Con_Radio_pre_2/' include/durero/model/escena.hpp
sees labels "a clause whose name and label differ"
printf '%s\n' '% A comment that goes on and on, well beyond the measure of a hundred columns that the text is laid out in.' >>spec/puntos.tex
sees z_text "a line beyond the measure"
printf '%s\n' '\begin{zed}' '  [ Nada ]' '\end{zed}' >>spec/tipos.tex
sees z_text "a box without prose"
sed -i 's/^| `Escena` | 9 /| `Escena` | 8 /' spec/README.md
sees specified "a table that says what is not so"
sed -i 's/"Escena\.inv\.8"/"Escena.inv.88"/' include/durero/model/escena.hpp
sees specified "a table from before a clause went"
if [ -f proofs/Main.v ]; then
  yes '(* a line *)' | head -n 500 >>proofs/Walk.v
  sees proofs "a file of more than 500 lines"
  printf 'Lemma guessed (x : R) : 0 <= x * x.\nProof. nra. Qed.\n' >>proofs/Slab.v
  sees proofs "products that nobody names"
  sed -i 's/Agregar_Esfera\.post\.1//g' proofs/Operaciones.v
  sees labels "a predicate that no theorem uses"
  sed -i 's/real\.axiom\.9//g' proofs/Tipos.v
  sees labels "an axiom that no theorem shows"
  sed -i 's/Init\.conj\.1//g' proofs/Escena.v
  sees labels "a conjecture that no theorem discharges"
  sed -i 's/^Theorem Init_exists : Init_conj_1/Theorem Init_exists : Init_conj_9/' proofs/Escena.v
  sees labels "a theorem that states another conjecture than it is to prove"
  sed -i 's/^  Init_conj_1 Elemento$/  True/' proofs/MainText.v
  sees labels "a conjecture that Main.v does not state"
  sed -i 's/real_axiom_8/True/' proofs/MainText.v
  sees labels "an axiom that Main.v does not state"
  sed -i 's/^  .vdash. .exists Escena.*% Init.conj.1$/  \\vdash? true/' spec/escena.tex
  sees labels "a conjecture without a label"
  sed -i 's/Agregar_Cono_Total\.def\.1//g' proofs/Totals.v
  sees labels "a total operation that no theorem is about"
fi
sed -i '0,/^file src\/trace/s/^file src\/trace/file src\/elsewhere/' tests/mutants/mutants.txt
sees mutants "a mutant of a file that is gone"
sed -i 's/^- if (of_D < 0) return {};/- if (of_D < 1) return {};/' tests/mutants/mutants.txt
sees mutants "a mutant whose text is gone"
sed -i 's/^build_packages="/&libhdf5-dev /' x
sees packages "a package whose licence nobody names"
sed -i 's/ libgmp-dev,//' debian/control
sees packages "a package that the build needs and Debian's does not install"
sed -i 's/^#include <CGAL\/Polygon_2_algorithms.h>/#include <CGAL\/Nef_polyhedron_3.h>/' src/io/mesh/triangulation.cpp
sees packages "a header of CGAL whose licence nobody names"
sed -i 's/^durero (0\./durero (9./' debian/changelog
sees versions "a Debian package of another version"
sed -i 's/^version: 0\./version: 9./' CITATION.cff
sees versions "a citation of another version"
sed -i 's/^## \[0\./## [9./' CHANGELOG.md
sees versions "a changelog of another version"
sed -i 's/find_package(durero 0\./find_package(durero 9./' docs/library.md
sees versions "a page that asks for another version"
echo 'model::Punto f(test::Random& random) { return model::Punto(random.sign(), random.sign(), 0); }' >>tests/oracle/sampled_test.cpp
sees draws "two draws in the arguments of a call"
echo 'double f(test::Random& random) { return random.sign() - half(random); }' >>tests/oracle/sampled_test.cpp
sees draws "two draws on the sides of an operator"
sed -i 's/ libpng-dev / libpng-dev libtiff-dev /' x
sees requirements "a package that README does not name"
sed -i '/^| tests |/s/ catch2 / catch2 libcppunit-dev /' README.md
sees requirements "a requirement that x does not install"
echo 'void f() { fmt::print("lost where nobody reads"); }' >>src/cli/check.cpp
sees standard_output "a command that prints what may be lost"
echo 'void f() { std::cout << 1; }' >>src/cli/check.cpp
sees standard_output "a command that prints through iostreams"
sed -i 's/^print("system wrong 1", flush=True)/print("system wrong 1")/' tests/schemas/examples.py
sees flush "a system whose first line waits in a buffer"
sed -i '/sys.stdout.flush()/d' tests/conform/flaky_system.py
sees flush "a system whose answers wait in a buffer"
# committed SUBJECT [BODY]: the tree has a history of one commit; uncommitted, it has none.
committed() { git -c user.name=nobody -c user.email=nobody commit -q --allow-empty -m "$1" ${2:+-m "$2"}; }
uncommitted() { git update-ref -d HEAD; }
while IFS='|' read -r subject body what; do
  committed "$subject" "$body"
  sees commits "$what"
  uncommitted
done <<'END'
Ten cells, not eight|They are more.|a subject without an area
lattice: ten cells are made, where eight were, of each side of a box that holds it|They are more.|a subject of more than 72 characters
lattice: makes ten cells|They are more.|a subject that is no imperative
lattice: making ten cells|They are more.|a subject that says what goes on
lattice: A box is made of ten cells|They are more.|a subject that is a sentence
lattice: make ten cells||a commit without a reason
END
committed 'lattice: make ten cells' 'Eight were too few for a box that holds one more.'
sh "$here/commits.sh" || { echo "drill: commits.sh complains of a good commit"; missed=$((missed + 1)); }
uncommitted
sed -i 's/`src\/accel\/touch.cpp`, //' docs/adding-a-surface.md
sees rooms "a room of surfaces that no page names"
echo 'bool f(const scene::TruncatedCone& cone);' >>src/io/lines.cpp
sees rooms "a new room of surfaces"
sed -i 's/^| `src\/render\/texture\/coordinates.cpp`/| `src\/render\/texture\/bump.cpp`, `src\/render\/texture\/coordinates.cpp`/' docs/adding-a-surface.md
sees rooms "a room that names no surface"
echo 'namespace durero::render { namespace { struct Dyadic {}; } }' >>src/render/sample/points.cpp
sees types "a type of a name that another layer has"
printf 'namespace durero::io {\ntemplate <class T>\nclass Dyadic final : T {};\n}\n' >>include/durero/io/json/json.hpp
sees types "a template of a name that another layer has"
printf 'namespace durero::io {\nenum class [[nodiscard]] Dyadic : int { a };\n}\n' >>include/durero/io/json/json.hpp
sees types "an enumeration of a name that another layer has"
echo 'namespace durero::io { struct Cilindro {}; struct Tally {}; }' >>include/durero/io/json/json.hpp
sees types "a type of a name that two other places have"
echo 'namespace durero::io { class Told {}; }' >>src/io/json/json.cpp
sees types "a verb that names a type"
echo 'namespace durero::io { template <class Take> void f(Take take); }' >>src/io/json/json.cpp
sees types "a verb that names a parameter of a template"
# What defines no second type is let be: a declaration, a specialisation, a nested type, a comment, a literal, a type of
# the text's name.
cat >>src/io/json/json.cpp <<'END'
namespace durero::number { class Dyadic; }
template <>
struct std::hash<durero::number::Dyadic> {};
namespace durero::io { struct Nest { struct Dyadic {}; }; }  // struct Dyadic {};
namespace durero::io { struct Escena {}; const char* text = "struct Dyadic {};"; struct Dyadic f(struct Dyadic x) { return x; } }
END
git add -A
sh "$here/types.sh" || { echo "drill: types.sh complains of what names no second type"; missed=$((missed + 1)); }
git read-tree -u --reset "$clean"
sed -i '0,/^| `Dyadic` | /s//| `Dyadic` | Not /' docs/glossary.md
sees glossary "a page that says what no header says"
printf 'namespace durero::number {\nstruct Nameless {};\n}\n' >>include/durero/number/dyadic.hpp
sees glossary "a type without a sentence"
printf 'namespace durero::number {\n/// A new term.\nstruct Newcomer {};\n}\n' >>include/durero/number/dyadic.hpp
sees glossary "a type that the page has not"
if command -v doxygen >/dev/null 2>&1; then
  sed -i 's/^  \/\/\/ #elementos$//' include/durero/scene/scene.hpp
  sees reference "a public name without a sentence"
  sed -i 's/^\/\/\/ r \* r (cuadrado/\/\/\/ \\no_such_command (cuadrado/' include/durero/model/puntos.hpp
  sees reference "a command that Doxygen does not know"
  git read-tree -u --reset "$clean"
fi
if command -v clang-format-16 >/dev/null 2>&1; then
  printf 'int  f( ){return 0 ;}\n' >>src/oracle/sampled.cpp
  sees format "another layout"
fi
echo "drill: $((drills - missed)) of $drills faults seen"
[ "$missed" = 0 ]
