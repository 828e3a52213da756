#include "durero/spec/label_index.hpp"

#include "durero/spec/spec.hpp"
#include "support/catch.hpp"

namespace durero::spec {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

const LabelIndex index(
    "Escena.inv.1\ttest\ttests/a.cpp:7\tname\nEscena.inv.1\ttext\tspec/"
    "escena.tex:9\t\nEscena.inv.2\tclause\tx.hpp:1\tf\n");

TEST_CASE("the theorem of a label is the one that discharges it") {
  const LabelIndex labels(
      "A.conj.1\ttext\tspec/a.tex:3\nA.conj.1\ttheorem\tproofs/A.v:9\tA_holds\nB.inv.1\ttext\tspec/a.tex:1\n");
  CHECK(labels.theorem("A.conj.1") == "A_holds");
  CHECK(labels.theorem("B.inv.1").empty());
  CHECK(labels.theorem("C.inv.1").empty());
}

TEST_CASE("the places of a label stand in the order text, clause, function, test, theorem") {
  CHECK(index.places("Escena.inv.1") ==
        "Escena.inv.1\n  text      spec/escena.tex:9\n  test      tests/a.cpp:7  name\n");
  CHECK(index.places("nothing") == "nothing\n");
}

TEST_CASE("all places of a label are those of the table") {
  const auto places = index.all("Escena.inv.1");
  REQUIRE(places.size() == 2);
  CHECK(places[0].kind == "test");
  CHECK(places[0].place == "tests/a.cpp:7");
  CHECK(places[0].name == "name");
  CHECK(places[1].kind == "text");
  CHECK(index.all("nothing").empty());
}

TEST_CASE("the labels of a table stand in any order") {
  const LabelIndex labels("C.inv.1\ttext\tc:1\t\nA.inv.1\ttext\ta:1\t\nC.inv.1\tclause\tc:2\t\nB.inv.1\ttext\tb:1\t\n");
  CHECK(labels.carried_out("C.inv.1") == "c:2");
  CHECK(labels.all("A.inv.1").at(0).place == "a:1");
  CHECK(labels.all("B.inv.1").size() == 1);
  CHECK(labels.all("C.inv.1").at(0).place == "c:1");
}

TEST_CASE("a name is shown by what declares it, a label by its own places, ΔS by what it stands for") {
  CHECK_THAT(shown(text(), "Escena", index),
             StartsWith("spec/escena.tex:") && Contains("tests/a.cpp:7") && Contains("x.hpp:1"));
  CHECK_THAT(shown(text(), "Escena.inv.1", index), Contains("tests/a.cpp:7") && !Contains("x.hpp:1"));
  CHECK_THAT(shown(text(), "mi\\_radio", index), Contains("│ mi_radio : Elemento ⇸ Rmas"));
  CHECK_THAT(shown(text(), "ΞEscena", index), StartsWith("ΞEscena == [Escena; Escena ' | θ Escena = θ Escena ']\n"));
  CHECK_THAT(shown(text(), "ΔEscena", index), StartsWith("ΔEscena == [Escena; Escena ']\n"));
  CHECK(shown(text(), "nadie", index).empty());
  CHECK(shown(text(), "Δ", index).empty());
  CHECK(in_unicode(text(), "\\real") == "ℝ");
  CHECK(in_unicode(text(), "\\nadie") == "\\nadie");
}

TEST_CASE("a name stands where it is declared, or is a component, or a variable") {
  const auto declared = name_location(text(), "Escena", index);
  REQUIRE(declared);
  CHECK_THAT(declared->text, StartsWith("spec/escena.tex:"));
  CHECK(declared->paragraph == "Escena");
  CHECK(declared->program == "x.hpp:1");
  const auto component = name_location(text(), "radio?", index);
  REQUIRE(component);
  CHECK_THAT(component->text, StartsWith("spec/operaciones.tex:"));
  CHECK(component->paragraph == "Agregar_Esfera");
  CHECK(component->program.empty());
  const auto variable = name_location(text(), "otro", index);
  REQUIRE(variable);
  CHECK(variable->paragraph == "reduccion");
  const auto value =
      name_location(text(), "soy_esfera", LabelIndex("Tipo\ttype\ttipos.hpp:9\nTipo.inv.1\tclause\tx.hpp:1\n"));
  REQUIRE(value);
  CHECK(value->paragraph == "Tipo");
  CHECK(value->program == "tipos.hpp:9");
  CHECK(!name_location(text(), "oj", index));
  CHECK(!name_location(text(), "nadie", index));
}

}  // namespace
}  // namespace durero::spec
