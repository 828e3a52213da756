#include "durero/conform/report/explanation.hpp"

#include "durero/model/operaciones.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::conform;

namespace {

SuiteCase case_of(const model::Operation& addition, const model::Rayo& ray) {
  SuiteCase of;
  of.family = find_family("generic");
  of.the_case.scene.apply(addition);
  of.the_case.rays = {{ray, {}}};
  answer(of);
  return of;
}

}  // namespace

TEST_CASE("a hit is explained to forty digits and as a surd") {
  // |p + t·v|² = 3 with p = (0, 0, −2), v = (1, 0, 1)·½: t²/2 − 2t + 1 = 0, so t = 2 − √2.
  const SuiteCase of = case_of(model::Agregar_Esfera{model::Elemento{"s"}, model::Punto{0, 0, 0}, std::sqrt(3.0)},
                               {model::Punto{0, 0, -2}, model::Vector{0.5, 0, 0.5}});
  const std::string text = explanation(of, 0);
  CHECK(text.find("the exact answer: s at t = 0.58578643762690") != text.npos);
  CHECK(text.find("·√(") != text.npos);
  CHECK(text.find("  y = 0\n") != text.npos);
  CHECK(text.find("esfera s 0 0 0 1.7320508075688772") != text.npos);
  CHECK(text.find("ambiguous") == text.npos);
}

TEST_CASE("what may also be answered is said") {
  const SuiteCase of = case_of(model::Agregar_Esfera{model::Elemento{"s"}, model::Punto{0, 1, 0}, 1},
                               {model::Punto{-4, 0, 0}, model::Vector{2, 0, 0}});
  const std::string text = explanation(of, 0);
  CHECK(text.find("the exact answer: s at t = 2\n") != text.npos);
  CHECK(text.find("  t = 2\n    = 2\n") != text.npos);
  CHECK(text.find("ambiguous: tangent\n") != text.npos);
  CHECK(text.find("as good: a miss\n") != text.npos);
}

TEST_CASE("a ray that lies in a surface from the start has no nearest point") {
  const SuiteCase of =
      case_of(model::Agregar_Plano{model::Elemento{"floor"}, model::Punto{0, 0, 0}, model::Vector{0, 0, 1}},
              {model::Punto{1, 2, 0}, model::Vector{1, 0, 0}});
  const std::string text = explanation(of, 0);
  CHECK(text.find("the exact answer: floor, without a nearest point\n") != text.npos);
  CHECK(text.find("in its surface from t → 0\n  without end\n") != text.npos);
  CHECK(text.find("ambiguous: in_surface") != text.npos);
}
