// How a store carries operations out: what it is given decides, and is asked for each.
#include "durero/store/carry_out.hpp"

#include "kept.hpp"
#include "support/catch.hpp"

using namespace durero;

TEST_CASE("Operations are carried out by what the call names, once each") {
  const test::KeptStore kept;
  store::Store of = kept.open();
  std::size_t asked = 0;
  const store::CarryOut counted = [&](io::EditedScene& edited, const io::ScriptStep& step) {
    ++asked;
    return store::carry_out(edited, step);
  };
  of.edit({test::script(test::balls(0, 3) + test::ball(0)), 0, test::by_ann, false, counted});
  CHECK(asked == 4);
  CHECK(of.last() == 4);  // the import, and three
  const store::CarryOut refusing = [](io::EditedScene&, const io::ScriptStep&) {
    return io::EditAnswer{"no", "label.1", "never"};
  };
  const store::EditResult refused = of.edit({test::script(test::ball(9)), 0, test::by_ann, false, refusing});
  CHECK(refused.is_refused);
  CHECK(refused.answers == R"({"line":1,"ok":false,"r":"no","violated":"label.1","predicate":"never"})"
                           "\n");
  CHECK(of.last() == 4);
}
