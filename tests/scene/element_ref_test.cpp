#include "durero/scene/element_ref.hpp"

#include <algorithm>
#include <vector>

#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero::scene;
using durero::model::Tipo;

namespace {

ElementRef any_element() {
  return {*rc::gen::element(Tipo::soy_esfera, Tipo::soy_cilindro, Tipo::soy_cono, Tipo::soy_tronco, Tipo::soy_plano,
                            Tipo::soy_disco, Tipo::soy_triangulo),
          *rc::gen::resize(100, rc::gen::inRange<std::uint32_t>(0, 4))};
}

}  // namespace

TEST_CASE("elements are in the order of their types, and of their places in one type") {
  const std::vector<ElementRef> ascending{{Tipo::soy_esfera, 0},
                                          {Tipo::soy_esfera, 7},
                                          {Tipo::soy_cilindro, 0},
                                          {Tipo::soy_cilindro, 0xFFFFFFFF},
                                          {Tipo::soy_cono, 0}};
  for (std::size_t i = 0; i < ascending.size(); ++i)
    for (std::size_t j = 0; j < ascending.size(); ++j) CHECK((ascending[i] <=> ascending[j]) == (i <=> j));
}

TEST_CASE("sets are equal where they have the same elements, in place or on the heap") {
  durero::test::property("sorted and each once", [] {
    std::vector<ElementRef> drawn(*rc::gen::resize(100, rc::gen::inRange<std::size_t>(0, 8)));
    for (ElementRef& e : drawn) e = any_element();
    std::sort(drawn.begin(), drawn.end());
    drawn.erase(std::unique(drawn.begin(), drawn.end()), drawn.end());
    ElementSet set(drawn.begin(), drawn.end()), copy = set;
    RC_ASSERT(std::equal(set.begin(), set.end(), drawn.begin(), drawn.end()));
    RC_ASSERT(copy == set);
    copy.push_back({Tipo::soy_cono, 9});
    RC_ASSERT(copy != set);
    RC_ASSERT(set < copy);
  });
}

TEST_CASE("a set of one or two elements needs no heap") {
  ElementSet set{{Tipo::soy_esfera, 0}, {Tipo::soy_cono, 0}};
  const auto* begin = reinterpret_cast<const char*>(&set);
  const auto* first = reinterpret_cast<const char*>(set.data());
  CHECK(first >= begin);
  CHECK(first < begin + sizeof(set));
}
