#include "durero/io/input.hpp"

#include <chrono>
#include <thread>

#include "arriving.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using io::Input;

TEST_CASE("What is read and not taken waits, in whatever blocks it comes") {
  test::property("any text, any blocks", [] {
    const auto text = *rc::gen::arbitrary<std::string>();
    const auto block = *rc::gen::inRange<std::size_t>(1, 9);
    Input input("f", test::file_of(text), block);
    std::string read;
    for (bool more = true; more;) {
      more = input.read();
      RC_ASSERT(input.waiting() == text.substr(read.size(), input.waiting().size()));
      const auto taken = *rc::gen::inRange<std::size_t>(0, input.waiting().size() + 1);
      read += input.waiting().substr(0, taken);
      input.take(taken);
    }
    RC_ASSERT(read + std::string(input.waiting()) == text);
    RC_ASSERT_FALSE(input.read());
  });
}

TEST_CASE("A block is read at a time, and no more") {
  Input input("f", test::file_of("abcdefg"), 3);
  REQUIRE(input.read());
  CHECK(input.waiting() == "abc");
  input.take(2);
  REQUIRE(input.read());
  CHECK(input.waiting() == "cdef");
}

TEST_CASE("What is left of a regular file is known, and can be looked at") {
  Input input("f", test::file_of("abcdefg"), 3);
  CHECK(input.left() == 7U);
  REQUIRE(input.read());
  input.take(1);
  CHECK(input.left() == 6U);
  std::string seen(4, ' ');
  input.look(2, seen);
  CHECK(seen == "defg");
  CHECK(input.waiting() == "bc");
  REQUIRE(input.read());
  CHECK(input.waiting() == "bcdef");
  std::string beyond(2, ' ');
  CHECK_THROWS_WITH(input.look(5, beyond), "f: cannot be read: Input/output error; expected a readable file");
}

TEST_CASE("A pipe gives what is there; what is left of it is known at its end") {
  test::Pipe pipe;
  Input input("p", pipe.out());
  pipe.write("ab");
  CHECK_FALSE(input.left());
  REQUIRE(input.read());
  CHECK(input.waiting() == "ab");
  pipe.write("c");
  pipe.write("d");
  REQUIRE(input.read());
  CHECK(input.waiting() == "abcd");
  pipe.close();
  CHECK_FALSE(input.read());
  CHECK(input.left() == 4U);
  std::string seen(2, ' ');
  input.look(1, seen);
  CHECK(seen == "bc");
}

// A thread may be kept from running for as long as the writer waits, but not in each of many attempts.
TEST_CASE("A pipe gives what is there at once, and waits for no more of a slow writer") {
  bool came_alone = false;
  for (int attempt = 0; attempt < 20 && !came_alone; ++attempt) {
    test::Pipe pipe;
    Input input("p", pipe.out());
    pipe.write("ab");
    std::thread writer([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      pipe.write("c");
    });
    CHECK(input.read());
    came_alone = input.waiting() == "ab";
    writer.join();
  }
  CHECK(came_alone);
}

TEST_CASE("A text is there at once") {
  const io::Source source("f", "abc");
  Input input(source);
  CHECK(input.name() == "f");
  CHECK(input.waiting() == "abc");
  CHECK(input.left() == 3U);
  CHECK_FALSE(input.read());
}

TEST_CASE("An input that cannot be read is named, with the reason") {
  CHECK_THROWS_WITH(Input("/nowhere"), "/nowhere: cannot be read: No such file or directory; expected a readable file");
  Input folder("/");
  CHECK_THROWS_WITH(folder.read(), "/: cannot be read: Is a directory; expected a readable file");
}
