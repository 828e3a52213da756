#pragma once
/// The inputs of an operation as written, by their names and with the values that the operation takes.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/model/cara.hpp"
#include "durero/model/tipos.hpp"
#include "operation_call.hpp"

namespace durero::io {

/// What may stand in a call of an operation: the inputs it needs, and those it may go without.
struct Signature {
  std::string name;
  std::vector<std::string_view> required, optional;
};

/// Precondition of the members that take a name and answer a value: has(name). Each throws InputError where the value
/// is not what it asks for.
class Inputs {
 public:
  /// Throws InputError at an input that the signature has not or that stands twice, and where a required one is
  /// missing. The source, the call and the signature must outlive the inputs.
  Inputs(const Source& source, const Call& call, const Signature& signature);

  bool has(std::string_view name) const { return find(name) != nullptr; }
  /// Throws InputError, at the operation, where it is missing.
  void require(std::string_view name) const;

  /// The value of e? and of t?.
  model::Elemento element() const;
  model::Tipo tipo() const;

  void read(std::string_view name, double& value) const;
  void read(std::string_view name, glm::dvec3& value) const;
  void read(std::string_view name, std::array<glm::dvec3, 3>& value) const;
  void read(std::string_view name, model::Ordinal& value) const;
  void read(std::string_view name, std::vector<glm::dvec3>& value) const;
  void read(std::string_view name, std::vector<model::Cara>& value) const;
  const std::string& word(std::string_view name) const;
  /// A name as elements have it, and a list of such: with commas between them, or an array of JSON.
  const std::string& name(std::string_view input) const;
  std::vector<std::string> names(std::string_view input) const;

  [[noreturn]] void fail(std::string_view name, const std::string& wrong, const std::string& expected) const;

 private:
  model::Ordinal ordinal(std::string_view input, double value) const;
  const CallInput* find(std::string_view name) const;
  void check_name(std::string_view input, const std::string& name) const;
  void check_known(const CallInput& input, const Signature& signature) const;

  const Source& source_;
  const Call& call_;
};

}  // namespace durero::io
