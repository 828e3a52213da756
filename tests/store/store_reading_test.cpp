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
