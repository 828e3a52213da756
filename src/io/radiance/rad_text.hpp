#pragma once
/// A text of Radiance, carried out: its primitives in their order, and in the place of each command what it makes.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "rad_command.hpp"
#include "rad_words.hpp"

namespace durero::io {

/// A primitive: a surface, a material, or what changes one.
struct RadPrimitive {
  const Source* source;  ///< lives as long as the text
  std::size_t at;        ///< its first word
  std::string modifier, type, identifier;
  std::vector<std::string> words{};
  std::vector<double> numbers{};
  Transform placed{};  ///< by the commands around it

  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const {
    source->fail(at, wrong, expected);
  }
};

class RadText {
 public:
  /// The text must live longer.
  explicit RadText(const Source& source) : main_(source) {}

  /// Hands on all primitives. Throws InputError.
  void for_each(const std::function<void(const RadPrimitive&)>& primitive);
  /// Appends a line for the commands that are not carried out.
  void name_losses(std::vector<std::string>& lost) const;

 private:
  /// The commands around a text, the innermost last.
  struct Around {
    Transform placed{};
    std::string prefix{};
    std::string modifier{};  ///< of surfaces; empty where they keep their own
  };

  void read(const Source& source, const Around& around);
  RadPrimitive primitive(const Source& source, RadWords& in);
  void carry_out(const Source& source, const RadLine& line, const Around& around);
  void carry_out(const Source& source, const RadLine& line, const RadCommand& command, std::size_t stage,
                 const Around& around);
  const Source& file(const Source& source, const RadLine& line, const std::string& name);
  void hand_on(RadPrimitive primitive, const Around& around);
  void count_step(const Source& source, std::size_t at);

  const Source& main_;
  std::function<void(const RadPrimitive&)> primitive_;
  std::map<std::string, Source> files_;
  std::map<std::string, std::size_t, std::less<>> not_run_;
  std::size_t steps_ = 0, depth_ = 0, bytes_ = 0;
};

/// @{ What kind of primitive a type is; neither is a pattern, a texture, or a mixture.
bool is_rad_surface(std::string_view type);
bool is_rad_material(std::string_view type);
bool is_rad_mixture(std::string_view type);
/// @}

}  // namespace durero::io
