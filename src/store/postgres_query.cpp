#include "postgres_query.hpp"

#include <algorithm>

namespace durero::store {
namespace {

/// A value is 10⁹ bytes at most, as SQLite's, so that either kind of store holds what the other does.
constexpr std::size_t most_bytes = 1'000'000'000;

}  // namespace

PreparedQuery& PostgresQuery::bind(int parameter, std::int64_t value) {
  std::array<char, 8>& number = numbers_.at(static_cast<std::size_t>(parameter - 1));
  for (std::size_t i = 0; i < number.size(); ++i)
    number[i] = static_cast<char>(static_cast<std::uint64_t>(value) >> (56U - 8U * i));
  return bind_bytes(parameter, {number.data(), number.size()});
}

PreparedQuery& PostgresQuery::bind_bytes(int parameter, std::string_view bytes) {
  if (bytes.size() > most_bytes)
    of_.refuse("cannot hold so much at once: a snapshot takes 10⁹ bytes at most", "expected a smaller scene");
  const auto number = static_cast<std::size_t>(parameter);
  values_.at(number - 1) = bytes;
  count_ = std::max(count_, number);
  return *this;
}

void PostgresQuery::prepare() {
  if (!is_prepared_) connection_.prepare(name_, sql_);
  is_prepared_ = true;
}

bool PostgresQuery::step() {
  if (!answer_) {
    prepare();
    PostgresAnswer answer = connection_.answer(name_, values());
    if (error_state(answer.get()).starts_with("XX")) broken_();
    answer_ = checked(of_, connection_.get(), answer.release());
  }
  return ++row_ < PQntuples(answer_.get());
}

/// Nothing is waited for: whatever the statement answers beside an error is of no use.
void PostgresQuery::run() {
  prepare();
  connection_.send(name_, values());
  reset();
}

void PostgresQuery::reset() noexcept {
  answer_.reset();
  row_ = -1;
  count_ = 0;
}

/// A whole number has 8 or 4 bytes, and whether something is, 1.
std::int64_t PostgresQuery::integer(int column) const noexcept {
  const std::string_view value = bytes(column);
  std::uint64_t number =
      value.size() == 4 && (static_cast<unsigned char>(value[0]) & 0x80U) != 0 ? ~std::uint64_t{0} : 0;
  for (const char byte : value) number = number << 8U | static_cast<unsigned char>(byte);
  return static_cast<std::int64_t>(number);
}

std::string_view PostgresQuery::bytes(int column) const noexcept {
  return {PQgetvalue(answer_.get(), row_, column), static_cast<std::size_t>(PQgetlength(answer_.get(), row_, column))};
}

}  // namespace durero::store
