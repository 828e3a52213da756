#include "durero/trace/counts.hpp"

#include "support/catch.hpp"

using durero::trace::Counts;

TEST_CASE("counts add up kind by kind and step by step") {
  Counts sum{.element = {1, 2, 3}, .order = {4, 5, 6}, .rounding = {7, 8, 9}};
  sum += Counts{.element = {10, 20, 30}, .order = {40, 50, 60}, .rounding = {70, 80, 90}};
  CHECK(sum == Counts{.element = {11, 22, 33}, .order = {44, 55, 66}, .rounding = {77, 88, 99}});
  CHECK((sum += Counts{}) == sum);
}
