#pragma once
/// The words of a pbrt scene and of the files that it includes, and the parameters that stand behind a statement.

#include <cstddef>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "durero/io/source.hpp"
#include "io/scene_folder.hpp"

namespace durero::io {

/// A place in a file of a scene.
struct PbrtPlace {
  std::shared_ptr<const Source> file;
  std::size_t at = 0;

  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const {
    file->fail(at, wrong, expected);
  }
};

/// A word: a text in quotes, without them, or a statement, a number or a bracket.
struct PbrtWord {
  std::string_view text;
  std::size_t at;  ///< in the file that is being read
  bool is_quoted;
};

/// A parameter of a statement: `"float radius" 2`, and so on.
struct PbrtParameter {
  std::string type, name;
  PbrtPlace place;
  std::vector<double> numbers{};     ///< where its values are numbers
  std::vector<std::string> words{};  ///< where they are in quotes, or true and false
};

/// The parameters of a statement. Each is asked for by name; those that nobody asks for are told of.
class PbrtParameters {
 public:
  /// Adds one; the last of a name holds, as in pbrt 3, and the others are told of.
  void add(PbrtParameter parameter);
  /// The parameter of a name; null where there is none. It is then known.
  const PbrtParameter* find(std::string_view name) const;
  /// @{ One number, or whole text; the usual where there is none.
  double number(std::string_view name, double usual) const;
  std::string word(std::string_view name, std::string_view usual) const;
  /// @}
  /// Three numbers.
  glm::dvec3 triple(std::string_view name, const glm::dvec3& usual) const;
  /// The names of those that nobody has asked for, or that another of the name replaces.
  std::vector<std::string> unknown() const;

 private:
  std::vector<PbrtParameter> all_;
  mutable std::vector<std::string> known_;
  std::vector<std::string> replaced_;
};

/// Walks the words of a scene; where a file is included, those of that file first.
class PbrtWords {
 public:
  explicit PbrtWords(const Source& source);

  /// Whether all words of all files have been passed.
  bool done();
  /// Passes the next word and answers it.
  PbrtWord next();
  /// @{ Passes a statement's arguments: a text in quotes; one, if it stands there; so many numbers, perhaps
  /// in brackets; the parameters.
  std::string quoted(std::string_view what);
  void take_quoted();
  std::vector<double> numbers(std::size_t count, std::string_view what);
  PbrtParameters parameters();
  /// @}
  /// The next words are those of a file; `is_alone`: what it changes ends with it, which ends() tells.
  void include(const std::string& name, bool is_alone);
  /// How many files that are alone have ended since the last call.
  std::size_t ends() { return std::exchange(ended_, 0); }
  /// The path of another file of the scene, where it is. Throws InputError at the place.
  std::string path(const PbrtPlace& place, std::string_view name) const;
  /// Where the last word stands.
  PbrtPlace place() const { return {last_file_, last_at_}; }
  /// Fails at the last word.
  [[noreturn]] void fail(const std::string& wrong, const std::string& expected) const { place().fail(wrong, expected); }

 private:
  struct File {
    std::shared_ptr<const Source> source;
    std::size_t next = 0;
    bool is_alone = false;
  };

  /// The next word without passing it; nothing at the end of the file.
  std::optional<PbrtWord> peek();
  std::optional<PbrtWord> take(std::string_view text);
  void read_values(PbrtParameter& parameter);

  std::vector<File> files_;
  SceneFolder folder_;
  std::shared_ptr<const Source> last_file_;
  std::size_t last_at_ = 0, includes_ = 0, bytes_ = 0, ended_ = 0;
};

}  // namespace durero::io
