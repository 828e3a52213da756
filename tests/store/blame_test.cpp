// Blame: the event that set an element last, by every kind of edit.
#include "durero/store/blame.hpp"

#include <map>

#include "kept.hpp"
#include "support/catch.hpp"

using namespace durero;
using test::edit;

namespace {

using Blamed = std::map<std::string, store::EventNumber>;

Blamed blamed(store::Store& of, std::string_view revision = "HEAD") {
  Blamed all;
  for (const store::BlamedElement& one : store::blame(of, of.find(revision)))
    CHECK(all.emplace(one.name, one.event).second);
  return all;
}

}  // namespace

TEST_CASE("An element is the event's that set it last, or the import's") {
  const test::KeptStore kept(
      R"({"format":"durero-scene","version":1,"elementos":[{"id":"a","tipo":"esfera","centro":[0,0,0],"radio":1},)"
      R"({"id":"b","tipo":"cilindro","centro":[0,0,0],"radio":1,"vector":[0,0,1],"altura":2}]})");
  store::Store of = kept.open();
  CHECK(blamed(of) == Blamed{{"a", 1}, {"b", 1}});
  edit(of, "Eliminar_Esfera e=a\nAgregar_Esfera e=a centro=(9,0,0) radio=1\nclose e=b top=lid\n");
  CHECK(blamed(of) == Blamed{{"a", 3}, {"b", 1}, {"b:base", 4}, {"lid", 4}});
  edit(of,
       "Agregar_Instancia e=copy de=a centro=(0,0,0) x=(1,0,0) y=(0,1,0) z=(0,0,1)\n"
       "Agregar_Union e=both de=a,b\nEliminar_Elemento e=lid\ngroup g=pair elementos=a,b\n");
  CHECK(blamed(of) == Blamed{{"a", 3}, {"b", 1}, {"b:base", 4}, {"copy", 5}, {"both", 6}});
  edit(of,
       "Eliminar_Instancia e=copy\nEliminar_Solido e=both\n"
       "Agregar_Malla m=m puntos=((0,0,9),(1,0,9),(0,1,9)) caras=((0,1,2))\n"
       "Agregar_Malla m=n puntos=((0,0,8),(1,0,8),(0,1,8)) caras=((0,1,2))\n"
       "Mover_Vertice m=m n=0 punto=(0,0,7)\n");
  CHECK(blamed(of) == Blamed{{"a", 3}, {"b", 1}, {"b:base", 4}, {"m", 13}, {"n", 12}});
  edit(of, "Reemplazar_Malla m=n puntos=((0,0,8),(2,0,8),(0,1,8)) caras=((0,1,2))\nEliminar_Malla m=m\n");
  CHECK(blamed(of) == Blamed{{"a", 3}, {"b", 1}, {"b:base", 4}, {"n", 14}});
  CHECK(blamed(of, "4") == Blamed{{"a", 3}, {"b", 1}, {"b:base", 4}, {"lid", 4}});
  of.import({}, "nothing.json", test::by_ann);
  edit(of, test::ball(1));
  CHECK(blamed(of) == Blamed{{"s1", 17}});
}

TEST_CASE("An element of another branch is not of this one") {
  const test::KeptStore kept;
  store::Store of = kept.open();
  edit(of, test::ball(1));
  of.undo();
  edit(of, test::ball(1));
  CHECK(blamed(of) == Blamed{{"s1", 3}});
  CHECK(blamed(of, "2") == Blamed{{"s1", 2}});
}
