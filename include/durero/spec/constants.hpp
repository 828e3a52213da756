#pragma once
/// Values that one gives to the constants of a Z text, and those that are taken where nothing gives them one.

#include <stdexcept>
#include <string>
#include <vector>

#include "durero/spec/calculator.hpp"

namespace durero::spec {

/// Says what is wrong with a value that is given for a constant; its place is a column of `NAME=VALUE`.
class ConstantError : public zed::ZError {
 public:
  using zed::ZError::ZError;
};

/// Says what is wrong with the members, or the value, that a scope gives; its place is a column of `NAME=…`.
class ScopeError : public ConstantError {
 public:
  using ConstantError::ConstantError;
};

/// Says what is wrong with the members that a given set is to have in a machine; `what is wrong; what is expected`.
class GivenSetError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The names and values that a text knows.
struct Knowledge {
  const zed::Specification& specification;  ///< without defects
  const zed::Typing& typing;                ///< of it
  const std::string& section;               ///< the section of it that sees all that may be named
  const zed::Valuation& given;              ///< the values that names have already, as those of given sets
};

/// Returns the values of `NAME=VALUE`, one for each constant of an axiomatic box; VALUE is Z. Throws ConstantError
/// where there is no such constant, or VALUE has no value of its type, or makes something false that the text says.
zed::Valuation typed_constants(const std::vector<std::string>& typed, const Knowledge& known);

/// The values that typed_constants() returns of a whole text without defects, in which no name has a value yet.
zed::Valuation given_constants(const zed::Specification& text, const std::vector<std::string>& typed);

/// Values of names of a text, and what they leave of it.
struct GivenScope {
  zed::Valuation values;            ///< of given sets and constants
  std::vector<std::string> within;  ///< of each given set, `NAME = {NAME1, NAME2}`
};

/// The values of constants by `let`, and of given sets and constants by `scope`, as Calculator::scope() takes them, for
/// a whole text without defects. Throws ScopeError of what is wrong in `scope`, and ConstantError of `let`.
GivenScope given_scope(const zed::Specification& text, const std::vector<std::string>& let,
                       const std::vector<std::string>& scope);

/// Returns a line for each constant for which a value was taken: which, and how one chooses another.
std::vector<std::string> taken_lines(const zed::Valuation& taken);

}  // namespace durero::spec
