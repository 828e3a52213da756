#pragma once
/// Statements of a PostgreSQL server, prepared.

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "postgres_connection.hpp"

namespace durero::store {

/// Is prepared where it is asked first. Numbers go as eight bytes, the highest first; texts and bytes as they are; rows
/// come so.
class PostgresQuery final : public PreparedQuery {
 public:
  /// `broken` is called where the server's files are spoiled, before that is thrown.
  PostgresQuery(const Database& of, PostgresConnection& connection, std::string name, const char* sql,
                std::function<void()> broken)
      : of_(of), connection_(connection), name_(std::move(name)), sql_(sql), broken_(std::move(broken)) {}
  PreparedQuery& bind(int parameter, std::int64_t value) override;
  PreparedQuery& bind(int parameter, std::string_view text) override { return bind_bytes(parameter, text); }
  PreparedQuery& bind_bytes(int parameter, std::string_view bytes) override;
  bool step() override;
  void run() override;
  void reset() noexcept override;
  std::int64_t integer(int column) const noexcept override;
  std::string_view bytes(int column) const noexcept override;

 private:
  /// More than the greatest event has.
  static constexpr std::size_t most_parameters = 12;

  void prepare();
  std::span<const std::string_view> values() const noexcept { return {values_.data(), count_}; }

  const Database& of_;
  PostgresConnection& connection_;
  std::string name_;
  const char* sql_;
  std::function<void()> broken_;
  bool is_prepared_ = false;
  std::size_t count_ = 0;  // of parameters
  std::array<std::array<char, 8>, most_parameters> numbers_{};
  std::array<std::string_view, most_parameters> values_{};
  PostgresAnswer answer_{};
  int row_ = -1;
};

}  // namespace durero::store
