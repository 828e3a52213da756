// Digests, held against the examples of FIPS 180-4 and against fields that would run together.
#include "durero/store/digest.hpp"

#include "support/catch.hpp"

using namespace durero::store;

TEST_CASE("A digest is SHA-256") {
  CHECK(hexadecimal(digest_of("")) == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  CHECK(hexadecimal(digest_of("abc")) == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  CHECK(hexadecimal(digest_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")) ==
        "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  CHECK(bytes_of(digest_of("abc")).substr(0, 3) == "\xba\x78\x16");
}

TEST_CASE("A digest of fields tells where a field ends") {
  const auto of = [](std::initializer_list<std::string_view> fields) {
    FieldDigest digest;
    for (const std::string_view field : fields) digest.add(field);
    return digest.digest();
  };
  CHECK(of({"ab", "c"}) == digest_of("2:ab,1:c,"));
  CHECK(of({"ab", "c"}) != of({"a", "bc"}));
  CHECK(of({"a", ""}) != of({"", "a"}));
  CHECK(of({"a"}) != of({"a", ""}));
}
