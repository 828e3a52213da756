#pragma once
/// A call, taken apart.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/json.hpp"
#include "durero/io/source.hpp"

namespace durero::web {

/// The members of a call by their keys. All members throw io::InputError at what is wrong.
class AskedCall {
 public:
  /// Reads a request, which is one object of JSON with a member `call`.
  explicit AskedCall(std::string_view request);
  AskedCall(const AskedCall&) = delete;
  AskedCall& operator=(const AskedCall&) = delete;

  /// The name of what is asked.
  const std::string& call() const noexcept { return call_; }
  /// The error about that name.
  [[noreturn]] void refuse_call(const std::string& expected) const;

  /// Checks that the keys beside `call` are some of these, and that the first `required` of them are there.
  void require(std::span<const std::string_view> keys, std::size_t required) const;

  /// Whether the key is there.
  bool has(std::string_view key) const { return members_.contains(key); }
  /// A reader that stands on the value of the key. Precondition: has(key).
  io::json::Reader at(std::string_view key) const { return members_.find(key)->second.value; }
  /// The call, whose places the readers tell.
  const io::Source& source() const noexcept { return source_; }

  /// @{ The value of a key; `otherwise` where it is not there.
  std::string text(std::string_view key, std::string_view otherwise) const;
  bool flag(std::string_view key, bool otherwise) const;
  std::uint64_t whole(std::string_view key, std::uint64_t least, std::uint64_t most, std::uint64_t otherwise) const;
  std::vector<std::string> texts(std::string_view key) const;
  /// @}
  /// The text of a key as a source of that name: of a string its value, of an object the object. Precondition:
  /// has(key).
  io::Source part(std::string_view key) const;

 private:
  /// A member: where its key stands, and a reader that stands on its value.
  struct Member {
    std::size_t key;
    io::json::Reader value;
  };

  io::Source source_;
  io::json::Document document_;
  std::map<std::string, Member, std::less<>> members_{};
  std::string call_{};
  std::size_t call_offset_ = 0;
};

}  // namespace durero::web
