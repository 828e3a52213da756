#include "durero/io/rays/npy.hpp"

#include <algorithm>

#include "io/arriving.hpp"
#include "support/catch.hpp"
#include "support/doubles.hpp"
#include "support/property.hpp"

using namespace durero;
using io::npy_head;
using io::read_npy;
using io::Source;

namespace {

// A file of that version with this dictionary and these bytes: the length of the dictionary takes 2 bytes in version 1,
// and 4 in the others.
std::string file(const std::string& dictionary, const std::string& data, char version = 1) {
  std::string out("\x93NUMPY");
  out += {version, '\0'};
  for (unsigned i = 0; i < (version == 1 ? 2U : 4U); ++i) {
    out.push_back(static_cast<char>(dictionary.size() >> (8 * i) & 0xFFU));
  }
  return out + dictionary + data;
}

std::string bytes(const std::vector<double>& values, bool big = false) {
  std::string out;
  for (const double x : values) {
    io::append_binary64(out, x);
    if (big) std::reverse(out.end() - 8, out.end());
  }
  return out;
}

std::vector<double> read(const std::string& text, std::size_t columns) {
  return read_npy(Source("f.npy", text), columns);
}

// The rows of a table as they come.
std::vector<double> arriving(io::Input& input, std::size_t columns) {
  io::NpyReader table(input, columns);
  std::vector<double> all, rows;
  while (table.next(rows)) all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

// What is wrong with a table that comes through a pipe.
std::string error_of_pipe(const std::string& text, std::size_t columns) {
  test::Pipe pipe;
  pipe.write(text);
  pipe.close();
  io::Input input("f.npy", pipe.out());
  try {
    arriving(input, columns);
  } catch (const io::InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("A table reads back") {
  test::property("any shape", [] {
    const auto columns = *rc::gen::inRange<std::size_t>(1, 7);
    const auto rows = *rc::gen::inRange<std::size_t>(0, 5);
    const auto values = *rc::gen::container<std::vector<double>>(rows * columns, test::anyFinite());
    const std::string text = npy_head("'<f8'", "(" + std::to_string(rows) + ", " + std::to_string(columns) + ")");
    RC_ASSERT(text.size() % 64 == 0U);
    RC_ASSERT(read(text + bytes(values), columns) == values);
  });
}

TEST_CASE("Either byte order and either order of storage") {
  const std::vector<double> values = {1, 2, 3, 4, 5, 6};
  CHECK(read(file("{'descr': '>f8', 'fortran_order': False, 'shape': (2, 3), }", bytes(values, true)), 3) == values);
  CHECK(read(file("{'shape':(2,3),\"fortran_order\":True,'descr':'<f8'}", bytes({1, 4, 2, 5, 3, 6})), 3) == values);
}

TEST_CASE("A row of numbers is a table of one column") {
  const std::string text = file("{'descr': '<f8', 'fortran_order': False, 'shape': (3,), }", bytes({1, 2, 3}));
  CHECK(io::npy_columns(Source("f.npy", text)) == 1);
  CHECK(read(text, 1) == std::vector<double>{1, 2, 3});
  const std::string table = file("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3)}", bytes({1, 2, 3}));
  CHECK(io::npy_columns(Source("f.npy", table)) == 3);
}

TEST_CASE("Versions 1, 2 and 3 are read, and no others") {
  const std::string dictionary = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3), }";
  const std::vector<double> values = {1, 2, 3};
  for (const char version : {'\1', '\2', '\3'}) CHECK(read(file(dictionary, bytes(values), version), 3) == values);
  CHECK_THROWS_WITH(read(file(dictionary, bytes(values), 0), 3), "f.npy:1:1: .npy version 0; expected 1, 2 or 3");
  CHECK_THROWS_WITH(read(file(dictionary, bytes(values), 4), 3), "f.npy:1:1: .npy version 4; expected 1, 2 or 3");
  // NumPy writes version 2 where the head is longer than 65535 bytes.
  CHECK(read(file(dictionary + std::string(70000, ' '), bytes(values), 2), 3) == values);
}

TEST_CASE("What is no table of float64 of that width is refused") {
  const std::string data = bytes({1, 2, 3});
  CHECK_THROWS_WITH(read("NUMPY", 3), "f.npy:1:1: no NumPy file; expected one that starts with \\x93NUMPY");
  CHECK_THROWS_WITH(read(file("{'descr': '<f4', 'fortran_order': False, 'shape': (1, 3)}", data), 3),
                    "f.npy:1:1: dtype \"'<f4'\"; expected float64 ('<f8' or '>f8')");
  CHECK_THROWS_WITH(read(file("{'descr': '<f8', 'fortran_order': False, 'shape': (3,)}", data), 3),
                    "f.npy:1:1: another shape; expected (n, 3)");
  CHECK_THROWS_WITH(read(file("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 3, 1)}", data), 3),
                    "f.npy:1:1: another shape; expected (n,) or (n, m)");
  CHECK_THROWS_WITH(read(file("{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3)}", data), 3),
                    "f.npy:1:1: 24 bytes of data; expected 2 rows of 3 float64");
  CHECK_THROWS_WITH(read(file("{'descr': '<f8', 'shape': (1, 3)}", data), 3),
                    "f.npy:1:1: the head has no fortran_order; expected descr, fortran_order and shape");
  CHECK_THROWS_AS(read(file("{'descr': '<f8', 'fortran_order': False, 'shape': (768614336404564651, 3)}", data), 3),
                  io::InputError);  // times 24 it wraps to 8
}

TEST_CASE("Every prefix of a table is refused") {
  const std::string text = npy_head("'<f8'", "(2, 3)") + bytes({1, 2, 3, 4, 5, 6});
  for (std::size_t n = 0; n < text.size(); ++n) CHECK_THROWS_AS(read(text.substr(0, n), 3), io::InputError);
}

TEST_CASE("A table that arrives in blocks is the table, in either order") {
  test::property("any table, any blocks", [] {
    const auto columns = *rc::gen::inRange<std::size_t>(1, 7);
    const auto rows = *rc::gen::inRange<std::size_t>(0, 9);
    const auto values = *rc::gen::container<std::vector<double>>(rows * columns, test::anyFinite());
    const bool fortran = *rc::gen::arbitrary<bool>(), big = *rc::gen::arbitrary<bool>();
    const std::string text =
        file("{'descr': '" + std::string(big ? ">" : "<") + "f8', 'fortran_order': " + (fortran ? "True" : "False") +
                 ", 'shape': (" + std::to_string(rows) + ", " + std::to_string(columns) + ")}",
             bytes(values, big));
    const std::vector<double> whole = read(text, columns);
    io::Input input("f.npy", test::file_of(text), *rc::gen::inRange<std::size_t>(1, 200));
    RC_ASSERT(arriving(input, columns) == whole);
    test::Pipe pipe;
    pipe.write(text);
    pipe.close();
    io::Input piped("f.npy", pipe.out(), *rc::gen::inRange<std::size_t>(1, 200));
    RC_ASSERT(arriving(piped, columns) == whole);
  });
}

TEST_CASE("A row is read when it has come, and the end is waited for behind the last") {
  test::Pipe pipe;
  pipe.write(npy_head("'<f8'", "(2, 3)") + bytes({1, 2, 3, 4}));
  io::Input input("f.npy", pipe.out());
  io::NpyReader table(input, 3);
  std::vector<double> rows;
  REQUIRE(table.next(rows));
  CHECK(rows == std::vector<double>{1, 2, 3});
  pipe.write(bytes({5, 6}));
  REQUIRE(table.next(rows));
  CHECK(rows == std::vector<double>{4, 5, 6});
  pipe.close();
  CHECK_FALSE(table.next(rows));
}

TEST_CASE("A table from a pipe that is cut, or goes on behind its end, is refused with the words of a file") {
  const std::string text = npy_head("'<f8'", "(2, 3)") + bytes({1, 2, 3, 4, 5, 6});
  for (std::size_t n = 0; n < text.size(); ++n) {
    INFO(n);
    std::string error;
    try {
      read(text.substr(0, n), 3);
    } catch (const io::InputError& thrown) {
      error = thrown.what();
    }
    CHECK(error != "");
    CHECK(error_of_pipe(text.substr(0, n), 3) == error);
  }
  CHECK(error_of_pipe(text + "behind", 3) == "f.npy:1:1: 54 bytes of data; expected 2 rows of 3 float64");
}

TEST_CASE("A regular file of another size is refused before a row of it is read") {
  const std::string head = npy_head("'<f8'", "(2, 3)");
  for (const std::size_t count : {4U, 7U}) {
    io::Input input("f.npy", test::file_of(head + bytes(std::vector<double>(count, 1))), 16);
    CHECK_THROWS_WITH(io::NpyReader(input, 3), Catch::Contains(std::to_string(8 * count) + " bytes of data; expected"));
  }
}

TEST_CASE("A head of no known version is refused though its length never comes") {
  test::Pipe pipe;
  pipe.write(std::string("\x93NUMPY\x09", 7));
  io::Input input("f.npy", pipe.out());
  pipe.write("\1\2\3\4\5");
  CHECK_THROWS_WITH(io::NpyReader(input, 3), "f.npy:1:1: .npy version 9; expected 1, 2 or 3");
}

TEST_CASE("Of a head or a table that does not end no more is read than it may have") {
  const std::string too_long = "\x93NUMPY" + std::string("\2\0\xFF\xFF\xFF\xFF", 6);
  const std::string fortran = file("{'descr': '<f8', 'fortran_order': True, 'shape': (2, 3)}", "");
  for (const auto& [before, wrong] : {std::pair{too_long, "f.npy:1:1: a head of 4294967295 bytes; expected at most"},
                                      std::pair{fortran, " bytes of data; expected 2 rows of 3 float64"}}) {
    test::Blanks endless(before);
    {
      io::Input input("f.npy", endless.out());
      CHECK_THROWS_WITH(io::NpyReader(input, 3), Catch::Contains(wrong));
    }
    CHECK(endless.count() < 4 * io::Input::usual_block);
  }
}
