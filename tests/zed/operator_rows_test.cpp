// The table of operators: its rows are complete, agree with each other, and are what the readers know.
#include <fmt/core.h>

#include <map>
#include <set>

#include "support/catch.hpp"
#include "zed/lines.hpp"
#include "zed/operators.hpp"
#include "zed/syntax/symbols.hpp"
#include "zed/types/toolkit.hpp"

namespace durero::zed {
namespace {

TEST_CASE("a name has one row, and the row is found by it") {
  std::set<std::string_view> names;
  for (const OperatorRow& row : operator_rows()) {
    CAPTURE(row.name);
    CHECK(names.insert(row.name).second);
    CHECK(operator_row(row.name) == &row);
  }
  CHECK(names.size() > 80);
  CHECK(operator_row("_nothing_") == nullptr);
}

TEST_CASE("an operator is found by its symbol, and its command gives the symbol") {
  for (const OperatorRow& row : operator_rows()) {
    CAPTURE(row.name);
    if (!row.command.empty()) CHECK(unicode_of_command(row.command) == row.symbol());
    if (!row.binding.role) continue;
    const Operator* op = find_operator(row.symbol(), *row.fixity());
    REQUIRE(op != nullptr);
    CHECK(op->name() == row.name);
    CHECK(op == operator_of_name(row.name));
    CHECK(op->precedence == row.binding.precedence);
    const bool binds = *row.fixity() == Fixity::infix && *row.binding.role != Role::relation;
    CHECK((row.binding.precedence > 0) == binds);
  }
}

TEST_CASE("the fuzzer's dictionary has each operator's command and sign") {
  const std::string words = zed::test::contents(durero::test::source_dir() + "/tests/fuzz/zed.dict");
  for (const OperatorRow& row : operator_rows()) {
    CAPTURE(row.name);
    std::string sign;
    for (const char byte : row.symbol())
      sign += static_cast<unsigned char>(byte) < 0x80 ? std::string(1, byte)
                                                      : fmt::format("\\x{:02X}", static_cast<unsigned char>(byte));
    CHECK(words.find("\"" + sign + "\"\n") != words.npos);
    if (!row.command.empty()) CHECK(words.find(fmt::format("\"\\\\{}\"\n", row.command)) != words.npos);
  }
}

TEST_CASE("all but = and ∈ have a type, and each has a value") {
  for (const OperatorRow& row : operator_rows()) {
    CAPTURE(row.name);
    const Name name{std::string(row.name), {}};
    CHECK((toolkit().contains(name) || calculator().contains(name)) == (row.name != "_=_" && row.name != "_∈_"));
    const Evaluation& by = row.evaluation;
    const int ways = (by.constant != nullptr) + (by.unary != nullptr) + (by.binary != nullptr) +
                     (by.property != nullptr) + (by.relation != nullptr) + row.arrow.has_value();
    CHECK(ways == 1);
    const bool relates = by.property != nullptr || by.relation != nullptr;
    CHECK(relates == (row.binding.role == Role::relation));
  }
  CHECK_FALSE(toolkit().contains({"_/_", {}}));
}

TEST_CASE("a relation is the opposite of its opposite") {
  for (const OperatorRow& row : operator_rows()) {
    if (row.opposite.empty()) continue;
    CAPTURE(row.name);
    REQUIRE(operator_row(row.opposite) != nullptr);
    CHECK(operator_row(row.opposite)->opposite == row.name);
  }
}

TEST_CASE("a subscript 1 belongs to the word where the word with it is known") {
  for (const char* word : {"ℙ", "𝔽", "ℕ", "ℤ", "∃", "seq"}) CHECK(has_indexed(word));
  for (const char* word : {"𝔸", "x", "∀", "dom", "iseq"}) CHECK_FALSE(has_indexed(word));
  for (const char* word : {"𝔸", "ℕ", "ℕ₁", "ℤ", "ℤ₁", "∅", "⋃", "⋂", "⁀/"}) CHECK(is_symbol_name(word));
  for (const char* word : {"∪", "dom", "ℙ", "x", ""}) CHECK_FALSE(is_symbol_name(word));
}

}  // namespace
}  // namespace durero::zed
