#include "durero/scene/table.hpp"

#include <string>
#include <vector>

#include "durero/scene/shapes.hpp"
#include "support/catch.hpp"
#include "support/property.hpp"

using namespace durero;
using namespace durero::scene;

namespace {

using Spheres = Table<Sphere>;

/// A row that is known by its number.
TableRow<Sphere> row(std::uint32_t number) {
  return {{glm::dvec3(number), 1.0 + number}, {model::Elemento("e" + std::to_string(number)), number, number}};
}

Spheres table_of(std::uint32_t rows) {
  Spheres table;
  for (std::uint32_t i = 0; i < rows; ++i) {
    table.reserve_one_more();
    table.push_back(row(i));
  }
  return table;
}

/// The numbers of the rows, in order, where shape and label of each belong together.
std::vector<std::uint32_t> numbers(const Spheres& table) {
  std::vector<std::uint32_t> all;
  REQUIRE(table.shapes.size() == table.labels.size());
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    const std::uint32_t number = table.labels[i].material;
    const TableRow<Sphere> expected = row(number);
    CHECK(table.shapes[i].centro == expected.shape.centro);
    CHECK(table.shapes[i].radio == expected.shape.radio);
    CHECK(table.labels[i].name == expected.label.name);
    CHECK(table.labels[i].hash == expected.label.hash);
    all.push_back(number);
  }
  return all;
}

}  // namespace

TEST_CASE("rows are added at the end, and taken from there") {
  Spheres table = table_of(3);
  CHECK(numbers(table) == std::vector<std::uint32_t>{0, 1, 2});
  table.pop_back();
  CHECK(numbers(table) == std::vector<std::uint32_t>{0, 1});
  CHECK(Label{model::Elemento("e"), 0}.material == no_material);
}

TEST_CASE("the last row fills the gap of one that is taken out") {
  Spheres table = table_of(4);
  CHECK(table.take(1).label.material == 1);
  CHECK(numbers(table) == std::vector<std::uint32_t>{0, 3, 2});
  CHECK(table.take(2).label.material == 2);
  CHECK(numbers(table) == std::vector<std::uint32_t>{0, 3});
}

TEST_CASE("put_back undoes take, of any row") {
  for (std::uint32_t rows = 1; rows < 6; ++rows) {
    for (std::uint32_t i = 0; i < rows; ++i) {
      Spheres table = table_of(rows);
      const std::vector<std::uint32_t> before = numbers(table);
      table.put_back(i, table.take(i));
      CHECK(numbers(table) == before);
    }
  }
}

TEST_CASE("room for a row is asked for ahead, and seldom; then nothing moves") {
  Spheres table;
  std::size_t moves = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    table.reserve_one_more();
    const Sphere* before = table.shapes.data();
    const std::size_t room = table.shapes.capacity();
    table.push_back(row(i));
    CHECK(table.shapes.data() == before);
    CHECK(table.shapes.capacity() == room);
    moves += i + 1 == room;
  }
  CHECK(table.size() == 1000);
  CHECK(moves <= 7);  // 16, 32, … 1024
}

TEST_CASE("there is a table for each shape") {
  Tables<Shapes> tables;
  CHECK(std::tuple_size_v<Tables<Shapes>> == shape_count);
  for_each_shape([&]<class Shape>(std::type_identity<Shape>) { CHECK(std::get<Table<Shape>>(tables).size() == 0); });
}
