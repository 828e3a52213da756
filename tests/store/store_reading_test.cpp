// Several questions to a store that another program writes meanwhile: they are answered of one state.
#include "durero/store/store_reading.hpp"

#include "kept.hpp"
#include "support/catch.hpp"

using namespace durero;
using test::ball;
using test::edit;
using test::KeptStore;

TEST_CASE("a store that others write is read as it was at the first question") {
  const KeptStore kept;
  store::Store of = kept.open(), other = kept.open();
  {
    const store::StoreReading reading(of);
    CHECK(of.head().event == 1);
    edit(other, ball(1));
    CHECK(of.head().event == 1);
    CHECK(of.last() == 1);
  }
  CHECK(of.head().event == 2);
  edit(of, ball(2));
  CHECK(other.head().event == 3);
}

TEST_CASE("a store that is open for reading stays as it was when it was opened") {
  const KeptStore kept;
  store::Store of = kept.open(store::StoreAccess::read), other = kept.open();
  CHECK(of.head().event == 1);
  edit(other, ball(1));
  { const store::StoreReading reading(of); }
  CHECK(of.head().event == 1);
}

TEST_CASE("a store that is followed is as others have written it by then") {
  const KeptStore kept;
  store::Store of = kept.open(store::StoreAccess::follow), other = kept.open();
  CHECK(of.head().event == 1);
  edit(other, ball(1));
  CHECK(of.head().event == 2);
  CHECK(test::text_at(of).find("\"s1\"") != std::string::npos);
  {
    const store::StoreReading reading(of);
    CHECK(of.last() == 2);
    edit(other, ball(2));
    CHECK(of.last() == 2);
  }
  CHECK(of.last() == 3);
  CHECK_THROWS_AS(edit(of, ball(3)), io::FileError);
  CHECK(other.last() == 3);
}
