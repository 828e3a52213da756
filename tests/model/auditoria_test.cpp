#include "durero/model/auditoria.hpp"

#include "support/catch.hpp"
#include "support/mallas_gen.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::model;

namespace {

using Edges = std::set<Arista>;
using Numbers = std::set<Ordinal>;

const std::vector<Punto> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}, {2, 0, 0}};
/// A tetrahedron, seen from outside its faces turn to the left.
const std::vector<Cara> closed{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

Red with(std::vector<Cara> faces, const Cara& more) {
  faces.push_back(more);
  return Red::of(corners, faces);
}

}  // namespace

TEST_CASE("a closed mesh has nothing wrong, and its volume is that of the solid") {
  const Red red = Red::of(corners, closed);
  CHECK(abiertas(red).empty());
  CHECK(multiples(red).empty());
  CHECK(discordes(red).empty());
  CHECK(repetidas(red).empty());
  CHECK(degeneradas(red).empty());
  CHECK(uniones_en_t(red).empty());
  CHECK(piezas(red) == std::set<Numbers>{{0, 1, 2, 3}});
  CHECK(volumen(red) == number::Rational(1) / 6);  // volumen.def.1
}

TEST_CASE("each fault of a mesh is seen where it is") {
  CHECK(aristas({0, 2, 1}) == Edges{{0, 2}, {2, 1}, {1, 0}});                       // aristas.def.1
  CHECK(de_arista(Red::of(corners, closed), 2, 0) == Numbers{0, 3});                // de_arista.def.1
  CHECK(abiertas(Red::of(corners, {{2, 1, 0}})) == Edges{{0, 1}, {0, 2}, {1, 2}});  // abiertas.def.1
  CHECK(multiples(with(closed, {1, 0, 5})) == Edges{{0, 1}});                       // multiples.def.1
  CHECK(discordes(Red::of(corners, {{0, 1, 2}, {0, 1, 3}})) == Edges{{0, 1}});      // discordes.def.1
  CHECK(repetidas(with(closed, {1, 0, 2})) == Numbers{4});                          // repetidas.def.1
  CHECK(degeneradas(with(closed, {0, 4, 5})) == Numbers{4});                        // degeneradas.def.1
  CHECK(degeneradas(with(closed, {0, 0, 1})) == Numbers{4});
  CHECK(uniones_en_t(Red::of(corners, {{0, 1, 2}, {4, 3, 2}})) ==
        std::set<std::array<Ordinal, 3>>{{4, 0, 1}});  // uniones_en_t.def.1
}

TEST_CASE("a face has the means of its corners, and crosses another by more than what they share") {
  const Red red =
      Red::of({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {0, 0, 2}, {2, 2, 0}, {1, 1, -1}, {3, 3, 3}, {2, 2, -5}},
              {{0, 1, 2}, {0, 0, 1}, {0, 6, 8}, {1, 5, 2}, {3, 2, 1}, {1, 2, 0}, {4, 6, 7}, {6, 7, 5}, {0, 4, 7}});
  CHECK(esquinas({0, 2, 0}) == Numbers{0, 2});           // esquinas.def.1
  CHECK(is_in_envolvente(red, {0, 1, 2}, {1, 0.5, 0}));  // envolvente.def.1
  CHECK(is_in_envolvente(red, {0, 1, 2}, {1, 1, 0}));
  CHECK_FALSE(is_in_envolvente(red, {0, 1, 2}, {1, 1 + 0x1p-52, 0}));
  CHECK_FALSE(is_in_envolvente(red, {0, 1, 2}, {0.5, 0.5, 0x1p-1074}));
  CHECK(is_in_envolvente(red, {0, 5}, {1, 1, 0}));
  CHECK_FALSE(is_in_envolvente(red, {0, 5}, {1, 1, 1}));
  CHECK(is_in_envolvente(red, {3}, {1, 0, 0}));
  CHECK_FALSE(is_in_envolvente(red, {}, {1, 0, 0}));
  const std::set<Arista> found = cruzadas(red);  // cruzadas.def.1
  const auto cross = [&](Ordinal m, Ordinal n) { return found.contains({m, n}); };
  CHECK_FALSE(cross(0, 1));  // one on one line is an edge of the other
  CHECK_FALSE(cross(0, 3));  // a common edge
  CHECK_FALSE(cross(0, 5));  // the same corners
  CHECK_FALSE(cross(0, 2));  // a common corner, below which the face lies
  CHECK(cross(0, 4));        // within the other, at a common edge
  CHECK(cross(0, 6));        // across an edge
  CHECK(cross(6, 8));        // in one plane, on one side of a common edge
  CHECK_FALSE(cross(6, 7));  // in one plane, on both sides of it
  CHECK(cross(1, 4));        // a face on one line, with a corner of the other
}

TEST_CASE("a point is singular where fans touch in it alone") {
  const Red red =
      Red::of(std::vector<Punto>(7, Punto(0, 0, 0)), {{0, 1, 2}, {2, 3, 0}, {0, 4, 5}, {5, 6, 6}, {4, 0, 0}});
  CHECK(de_punto(red, 0) == Numbers{0, 1, 2, 4});  // de_punto.def.1
  CHECK(de_punto(red, 7).empty());
  CHECK(singulares(red) == Numbers{0, 5});  // singulares.def.1
  CHECK(singulares(Red::of(corners, closed)).empty());
  CHECK(singulares(with(closed, {0, 4, 5})) == Numbers{0});
}

TEST_CASE("singulares.def.1: some choice of the faces of a singular point shares that point alone with the others") {
  test::property("singular points of any mesh", [] {
    const Red red = *test::any_red();
    Numbers expected;
    for (Ordinal v = 0; v < 5; ++v) {
      const Numbers all = de_punto(red, v);
      const std::vector<Ordinal> faces(all.begin(), all.end());
      const auto is_apart = [&](unsigned choice) {
        for (std::size_t a = 0; a < faces.size(); ++a)
          for (std::size_t b = 0; b < faces.size(); ++b)
            for (const Ordinal w : esquinas(red.caras().at(faces[a])))
              if (((choice >> a) & 1) != 0 && ((choice >> b) & 1) == 0 && w != v &&
                  esquinas(red.caras().at(faces[b])).contains(w))
                return false;
        return true;
      };
      for (unsigned choice = 1; choice + 1 < 1U << faces.size(); ++choice)
        if (is_apart(choice)) expected.insert(v);
    }
    RC_CLASSIFY(!expected.empty(), "with singular points");
    RC_ASSERT(singulares(red) == expected);
  });
}

TEST_CASE("an edge whose ends are one point has no point between them") {
  const Red red = Red::of({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}});
  CHECK(uniones_en_t(red).empty());
}

TEST_CASE("cerradas.def.1 and piezas.def.1: pieces share no point, and no part of one is closed") {
  test::property("pieces of any mesh", [] {
    const Red red = *test::any_mesh();
    Numbers all;
    for (const Numbers& piece : piezas(red)) {
      RC_ASSERT(is_closed(red, piece));
      for (const Ordinal n : piece) {
        RC_ASSERT(all.insert(n).second);
        Numbers rest = piece;
        rest.erase(n);
        RC_ASSERT(!is_closed(red, rest));
      }
    }
    RC_ASSERT(all.size() == red.caras().size());
  });
  CHECK_FALSE(is_closed(Red::of(corners, closed), {}));
  CHECK(piezas(Red::of(corners, {{0, 1, 2}, {3, 4, 5}})) == std::set<Numbers>{{0}, {1}});
}

TEST_CASE("determinante.def.1: a face that is turned over counts against") {
  const Terna v{{1, 2, 3}, {0, 1, 4}, {5, 6, 0}};
  CHECK(determinante(v) == 1);
  CHECK(determinante({v.b, v.c, v.a}) == 1);
  CHECK(determinante({v.b, v.a, v.c}) == -1);
}

TEST_CASE("a point is enclosed where a ray from it meets an odd number of faces") {
  const Red red = Red::of(corners, closed);
  CHECK(is_even(red));  // pares.def.1
  CHECK_FALSE(is_even(Red::of(corners, {{0, 2, 1}})));
  CHECK_FALSE(is_even(Red::of(corners, {{0, 4, 5}, {0, 4, 5}})));
  CHECK(is_in_piel(red, {0.25, 0.25, 0}));  // piel.def.1
  CHECK_FALSE(is_in_piel(red, {0.25, 0.25, 0.25}));
  CHECK(is_enclosed(red, {0.25, 0.25, 0.25}));  // encerrados.def.1
  CHECK_FALSE(is_enclosed(red, {0.25, 0.25, 0}));
  CHECK_FALSE(is_enclosed(red, {-0.25, -0.25, -0.25}));
  CHECK_FALSE(is_enclosed(red, {1, 1, 1}));
  CHECK_FALSE(is_enclosed(Red::of(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}), {0.25, 0.25, 0.25}));
}
