#include "conform/families/digest.hpp"

#include <boost/crc.hpp>

#include "durero/conform/random.hpp"
#include "support/catch.hpp"

using namespace durero;
using conform::digest;

TEST_CASE("a digest is CRC-64, as xz computes it") {
  CHECK(conform::digest_text(digest("123456789")) == "995dc9bbdf1939fa");
  CHECK(conform::digest_text(digest("")) == "0000000000000000");
  CHECK(conform::digest_text(0x1a) == "000000000000001a");
}

TEST_CASE("the digest of a text is the same in one piece and in several, and that of Boost") {
  conform::Random random(1);
  for (int i = 0; i < 200; ++i) {
    std::string text(random.below(100), ' ');
    for (char& c : text) c = static_cast<char>(random.below(256));
    boost::crc_optimal<64, 0x42f0e1eba9ea3693, ~std::uint64_t{0}, ~std::uint64_t{0}, true, true> second_opinion;
    second_opinion.process_bytes(text.data(), text.size());
    const std::size_t cut = random.below(text.size() + 1);
    CHECK(digest(text) == second_opinion.checksum());
    CHECK(digest(text.substr(cut), digest(text.substr(0, cut))) == digest(text));
  }
}
