#!/bin/sh
# A rule that cannot fail is no rule: this plants, in a copy of the tree, the fault that each rule should see, and
# fails where the rule says nothing.
set -u
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
copy=$(mktemp -d) && trap 'rm -rf "$copy" "$copy.rules"' EXIT
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

# sees_each: each two lines of the standard input are a fault: RULE FILES: WHAT, and the script by which sed plants it.
sees_each() {
  while read -r rule files what && read -r script; do
    git ls-files -- "${files%:}" | xargs sed -i "$script"
    sees "$rule" "$what"
  done
}

# lets_be RULE WHAT: runs the rule on a tree that it should let be.
lets_be() {
  git add -A
  sh "$here/$1.sh" || { echo "drill: $1.sh complains of $2"; missed=$((missed + 1)); }
  git read-tree -u --reset "$clean"
}

for rule in layers edges independence stems house labels mutants z_text specified draws requirements standard_output packages \
  versions reference optimised narrow includes flush commits rooms types glossary private systems spanish; do
  sh "$here/$rule.sh" >/dev/null 2>&1 || { echo "drill: $rule.sh fails before any fault is planted"; missed=$((missed + 1)); }
done

# A rule whose own search errs finds nothing, and fails by what it writes to the standard error.
mkdir "$copy.rules"
cp "$here/all.sh" "$copy.rules"
echo "grep x no/such/file | { ! grep .; }" >"$copy.rules/rule.sh"
drills=$((drills + 1))
if DURERO_TREE=$copy sh "$copy.rules/all.sh" >/dev/null; then
  echo "drill: all.sh does not see a rule whose search errs"
  missed=$((missed + 1))
fi
rm -rf "$copy.rules"

sees_each <<'END'
layers include/durero/number/rational.hpp: number including io
  $a #include "durero/io/scene.hpp"
layers src/oracle/sampled.cpp: oracle including trace
  $a #include "durero/trace/analytic.hpp"
layers src/io/json/json.cpp: io including render
  $a #include "durero/render/output/image.hpp"
layers src/engine/engine.cpp: engine including an internal header of trace
  $a #include "trace/steps.hpp"
layers include/durero/trace/analytic.hpp: a public header including an internal one
  $a #include "trace/steps.hpp"
optimised src/trace/stable.cpp: lanes compiled without optimisation
  s/"lanes\/for_each_target.hpp"/<hwy\/foreach_target.h>/
optimised CMakeLists.txt: lanes not optimised in Debug
  s/ src\/trace\/rounding.cpp//
narrow include/durero/scene/groups.hpp: a header that hands operations on and reads them all
  s/model\/operation.hpp/model\/operaciones.hpp/
includes src/render/sample/statistical.cpp: a call of GLM by the include of another file
  /glm\/exponential.hpp/d
includes src/serve/request.cpp: a call of fmt by the include of another file
  /fmt\/core.h/d
includes src/zed/value/value.cpp: a type of the program by the include of another file
  /growing_function.hpp/d
includes tests/conform/judge/torus_test.cpp: a function of the program by the include of another file
  /report\/tally.hpp/d
edges CMakeLists.txt: an edge that no include needs
  s/^durero_layer(zed DEPENDS /&contract /
edges CMakeLists.txt: an include that no edge names
  s/^\(durero_layer(render DEPENDS .*\) model/\1/
edges CMakeLists.txt: a layer that the program includes and does not link
  s/PUBLIC durero::text /PUBLIC /
independence src/oracle/sampled.cpp: an oracle that knows the equation of a surface
  $a #include "durero/surface/equation.hpp"
independence tests/conform/reference.hpp: the tests' reference asking what it is held against
  $a #include "durero/surface/exact.hpp"
systems systems/ode/ask.cpp: a program of systems/ that includes by a path of the sources
  s/"..\/ask.hpp"/"systems\/ask.hpp"/
house src/oracle/sampled.cpp: an unfinished place
  $a // T\x4fDO
house README.md: a path of one machine
  $a # /w\x6frk/here
house tests/oracle/sampled_test.cpp: a test that is switched off
  $a TEST_CASE("x", "[.]") {}
labels spec/escena.tex: a predicate whose label no clause has
  0,/% Escena.inv.1$/s/% Escena.inv.1$/% Escena.inv.99/
labels spec/escena.tex: a predicate without a label
  s/ *% Escena.inv.2$//
labels spec/interseccion.tex: a predicate of several lines without a label
  s/ *% Hay_Interseccion.post.2$//
labels spec/operaciones.tex: a definition without a label
  s/ *% Eliminar_Cono_Total.def.1$//
labels include/durero/model/interseccion.hpp: a total operation that no function carries out
  s/Primera_Interseccion\.def\.1//
labels tests/*.cpp: a clause that no test violates
  s/Agregar_Cono\.pre\.4/Agregar_Cono_pre_4/
labels include/*.hpp: a clause of no predicate
  s/"Escena\.inv\.3"/"Escena.inv.77"/
labels include/durero/model/tipo/cono.hpp: a clause of model that nothing evaluates
  />{&Agregar_Cono_post_4}/d
labels include/durero/model/escena.hpp: a clause whose name and label differ
  s/clause Con_Radio_pre_1/clause Con_Radio_pre_2/
z_text spec/puntos.tex: a line beyond the measure
  $a % A comment that goes on and on, well beyond the measure of a hundred columns that the text is laid out in.
z_text spec/tipos.tex: a box without prose
  $a \\\begin{zed}\n  [ Nada ]\n\\end{zed}
specified spec/README.md: a table that says what is not so
  s/^| `Escena` | 9 /| `Escena` | 8 /
specified include/durero/model/escena.hpp: a table from before a clause went
  s/"Escena\.inv\.8"/"Escena.inv.88"/
mutants tests/mutants/mutants.txt: a mutant of a file that is gone
  0,/^file src\/trace/s/^file src\/trace/file src\/elsewhere/
mutants tests/mutants/mutants.txt: a mutant whose text is gone
  s/^- if (of_D < 0) return {};/- if (of_D < 1) return {};/
packages x: a package whose licence nobody names
  s/^build_packages="/&libhdf5-dev /
packages debian/control: a package that the build needs and Debian's does not install
  s/ libgmp-dev,//
packages src/io/mesh/obj_reader.cpp: a header under the GPL
  0,/^#include </s/^#include </#include <CGAL\/Polygon_2_algorithms.h>\n&/
versions debian/changelog: a Debian package of another version
  s/^durero (0\./durero (9./
versions CITATION.cff: a citation of another version
  s/^version: 0\./version: 9./
versions CHANGELOG.md: a changelog of another version
  s/^## \[0\./## [9./
versions docs/library.md: a page that asks for another version
  s/find_package(durero 0\./find_package(durero 9./
draws tests/oracle/sampled_test.cpp: two draws in the arguments of a call
  $a model::Punto f(test::Random& random) { return model::Punto(random.sign(), random.sign(), 0); }
draws tests/oracle/sampled_test.cpp: two draws on the sides of an operator
  $a double f(test::Random& random) { return random.sign() - half(random); }
requirements x: a package that README does not name
  s/ libpng-dev / libpng-dev libtiff-dev /
requirements README.md: a requirement that x does not install
  /^| tests |/s/ catch2 / catch2 libcppunit-dev /
standard_output src/cli/check.cpp: a command that prints what may be lost
  $a void f() { fmt::print("lost where nobody reads"); }
standard_output src/cli/check.cpp: a command that prints through iostreams
  $a void f() { std::cout << 1; }
flush tests/schemas/examples.py: a system whose first line waits in a buffer
  s/^print("system wrong 1", flush=True)/print("system wrong 1")/
flush tests/conform/flaky_system.py: a system whose answers wait in a buffer
  /sys.stdout.flush()/d
rooms docs/adding-a-surface.md: a room of surfaces that no page names
  s/`src\/accel\/touch.cpp`, //
rooms src/io/lines.cpp: a new room of surfaces
  $a bool f(const scene::TruncatedCone& cone);
rooms docs/adding-a-surface.md: a room that names no surface
  s/^| `src\/render\/texture\/coordinates.cpp`/| `src\/render\/texture\/bump.cpp`, `src\/render\/texture\/coordinates.cpp`/
types src/render/sample/points.cpp: a type of a name that another layer has
  $a namespace durero::render { namespace { struct Dyadic {}; } }
types include/durero/io/json/json.hpp: a template of a name that another layer has
  $a namespace durero::io {\ntemplate <class T>\nclass Dyadic final : T {};\n}
types include/durero/io/json/json.hpp: an enumeration of a name that another layer has
  $a namespace durero::io {\nenum class [[nodiscard]] Dyadic : int { a };\n}
types include/durero/io/json/json.hpp: a type of a name that two other places have
  $a namespace durero::io { struct Cilindro {}; struct Tally {}; }
types src/io/json/json.cpp: a verb that names a type
  $a namespace durero::io { class Told {}; }
types src/io/json/json.cpp: a verb that names a parameter of a template
  $a namespace durero::io { template <class Take> void f(Take take); }
private src/accel/bvh.cpp: a public header of one source
  s/"accel\/insertion.hpp"/"durero\/accel\/insertion.hpp"/
private src/accel/bvh.cpp: a header of the list that another source includes
  $a #include "durero/accel/names.hpp"
private src/accel/names.cpp: a header of the list that nothing includes
  /"durero\/accel\/names.hpp"/d
glossary docs/glossary.md: a page that says what no header says
  0,/^| `Dyadic` | /s//| `Dyadic` | Not /
glossary include/durero/number/dyadic.hpp: a type without a sentence
  $a namespace durero::number {\nstruct Nameless {};\n}
glossary include/durero/number/dyadic.hpp: a type that the page has not
  $a namespace durero::number {\n/// A new term.\nstruct Newcomer {};\n}
spanish src/text/spanish.cpp: a name of the text without English
  /^ *{"alejamiento", /d
spanish src/text/spanish.cpp: English for a name that the text lacks
  s/^ *{"alejamiento", .*/&\n    {"lejania", "distance", "a name that nobody declares"},/
spanish src/text/spanish.cpp: a name that stands twice
  s/^ *{"alejamiento", .*/&\n&/
spanish src/text/spanish.cpp: a page from before the English of a name changed
  s/{"alejamiento", "[a-z_]*"/{"alejamiento", "removal"/
spanish spec/luz.tex: a new component of a schema
  s/ojo, esquina : Punto/ojo, rincon : Punto/
END

# What is no line of a file: files that go, come or are named otherwise.
git mv tests/model/puntos_test.cpp tests/model/points_test.cpp
sees stems "a stem of the Z text without its test"
touch spec/nuevo.tex
sees stems "a new stem without counterparts"
git mv tests/scene/hit_test.cpp tests/scene/hits_test.cpp
sees stems "a public header whose test has another name"
echo 'import re' >tests/lint/types.py
sees house "a script that hides a module of Python's library"
echo '#pragma once' >include/durero/surface/shape/torus.hpp
sees stems "a new public header without a test"

[ ! -f proofs/Main.v ] || sees_each <<'END'
proofs proofs/Walk.v: a file of more than 500 lines
  s/$/\n(* a line *)\n(* a line *)\n(* a line *)/
proofs proofs/Slab.v: products that nobody names
  $a Lemma guessed (x : R) : 0 <= x * x.\nProof. nra. Qed.
labels proofs/Operaciones.v: a predicate that no theorem uses
  s/Agregar_Esfera\.post\.1//g
labels proofs/Tipos.v: an axiom that no theorem shows
  s/real\.axiom\.9//g
labels proofs/Escena.v: a conjecture that no theorem discharges
  s/Init\.conj\.1//g
labels proofs/Escena.v: a theorem that states another conjecture than it is to prove
  s/^Theorem Init_exists : Init_conj_1/Theorem Init_exists : Init_conj_9/
labels proofs/MainText.v: a conjecture that Main.v does not state
  s/^  Init_conj_1 Elemento$/  True/
labels proofs/MainText.v: an axiom that Main.v does not state
  s/real_axiom_8/True/
labels spec/escena.tex: a conjecture without a label
  s/^  .vdash. .exists Escena.*% Init.conj.1$/  \\vdash? true/
labels proofs/Totals.v: a total operation that no theorem is about
  s/Agregar_Cono_Total\.def\.1//g
END

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
lets_be commits "a good commit"
uncommitted

echo '// glm::sqrt(2) is called by none.' >>src/io/json/json.cpp
lets_be includes "a call in a comment"
sed -i '/growing_function.hpp/d; s/^std::vector<FunctionSpace> Set::.*/const FunctionSpace\& same(const FunctionSpace\& x) { return x; }/' src/zed/value/value.cpp
lets_be includes "a reference to a type that is declared"

# What defines no second type is let be: a declaration, a specialisation, a nested type, a comment, a literal, a type of
# the text's name.
cat >>src/io/json/json.cpp <<'END'
namespace durero::number { class Dyadic; }
template <>
struct std::hash<durero::number::Dyadic> {};
namespace durero::io { struct Nest { struct Dyadic {}; }; }  // struct Dyadic {};
namespace durero::io { struct Escena {}; const char* text = "struct Dyadic {};"; struct Dyadic f(struct Dyadic x) { return x; } }
END
lets_be types "what names no second type"

! command -v doxygen >/dev/null 2>&1 || sees_each <<'END'
reference include/durero/scene/scene.hpp: a public name without a sentence
  s/^  \/\/\/ #elementos$//
reference include/durero/model/puntos.hpp: a command that Doxygen does not know
  s/^\/\/\/ r \* r (cuadrado/\/\/\/ \\no_such_command (cuadrado/
END
! command -v clang-format-16 >/dev/null 2>&1 || sees_each <<'END'
format src/oracle/sampled.cpp: another layout
  $a int  f( ){return 0 ;}
END
echo "drill: $((drills - missed)) of $drills faults seen"
[ "$missed" = 0 ]
