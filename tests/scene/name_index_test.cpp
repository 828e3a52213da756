#include "durero/scene/name_index.hpp"

#include <map>

#include "support/catch.hpp"
#include "support/property.hpp"

using durero::model::Tipo;
using durero::scene::ElementRef;
using durero::scene::NameIndex;

TEST_CASE("the index agrees with a map, however the hashes collide") {
  durero::test::property("inserts, erases, moves", [] {
    const auto hashes = *rc::gen::inRange<NameIndex::hash_type>(1, 40);
    NameIndex index;
    std::map<std::uint32_t, ElementRef> places;  // a name is here a number, and its hash the number modulo `hashes`
    std::uint32_t fresh = 0;
    const auto hash = [&](std::uint32_t name) { return name % hashes * 7; };
    for (const auto& [what, name] : *rc::gen::container<std::vector<std::pair<int, std::uint32_t>>>(
             rc::gen::pair(rc::gen::inRange(0, 4), rc::gen::inRange(0U, 60U)))) {
      const auto known = places.find(name);
      if (known == places.end()) {
        index.reserve_one_more();
        places.emplace(name, ElementRef{static_cast<Tipo>(fresh % 3), fresh});
        index.insert(hash(name), places.at(name));
      } else if (what == 0) {
        const ElementRef to{static_cast<Tipo>(fresh % 3), fresh};
        index.move(hash(name), known->second, to);
        known->second = to;
      } else if (what < 3) {
        index.erase(hash(name), known->second);
        places.erase(known);
      }
      ++fresh;
      RC_ASSERT(index.size() == places.size());
    }
    for (std::uint32_t name = 0; name < 60; ++name) {
      const auto known = places.find(name);
      const auto found =
          index.find(hash(name), [&](ElementRef place) { return known != places.end() && place == known->second; });
      RC_ASSERT(found.has_value() == (known != places.end()));
    }
  });
}

TEST_CASE("an empty index knows nothing") {
  const NameIndex index;
  CHECK(index.size() == 0);
  CHECK_FALSE(index.find(NameIndex::hash("a"), [](ElementRef) { return true; }));
}

TEST_CASE("the last place of the last type is a place, and no unused cell") {
  const ElementRef last{static_cast<Tipo>(durero::scene::shape_count - 1), NameIndex::last_index};
  NameIndex index;
  index.reserve_one_more();
  index.insert(7, last);
  CHECK(index.knows(7, last));
  index.erase(7, last);
  CHECK_FALSE(index.knows(7, last));
}
