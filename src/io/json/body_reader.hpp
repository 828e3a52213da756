#pragma once
/// Elements with bodies, read from JSON. Such an element may name others that stand below it, so each is kept until all
/// of the file has been read, and then made with what it names.

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "durero/io/json/json.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/scene.hpp"
#include "element_reader.hpp"
#include "groups_reader.hpp"

namespace durero::io {

/// What a name or a value stands for: one body, whose name is empty then, or those of a group by their names in it.
struct BodyPart {
  std::string name;
  scene::Body body;
  std::optional<Placed<std::string_view>> material{};
};
using BodyParts = std::vector<BodyPart>;

/// The one part that a body without a name is.
BodyParts alone(scene::Body body);

class BodyReader;

/// A tipo of elements with bodies: its keys beside `id`, `tipo` and `material`, all of them required, and what makes
/// the parts of an element of the values behind them.
struct BodyTipo {
  std::string_view word;
  std::span<const std::string_view> keys;
  BodyParts (*make)(BodyReader& reader, std::span<const json::Reader> values);
};
/// All of them.
std::span<const BodyTipo> body_tipos();
/// The tipo of the element that stands here; null where it is none of them.
const BodyTipo* body_tipo(const json::Reader& in);

/// Makes the bodies of one file.
class BodyReader {
 public:
  /// Adds to the scene of that file, to the uses of materials and to the groups, all of which outlive it.
  BodyReader(scene::Scene& scene, std::vector<MaterialUse>& uses, std::vector<WrittenGroup>& groups)
      : scene_(scene), uses_(uses), groups_(groups) {}

  /// Reads an element with a body, and keeps it. Precondition: its tipo is one of body_tipos().
  void keep_element(json::Reader& in);
  /// Reads the prototypes, and keeps them.
  void keep_prototypes(json::Reader& in);

  /// Makes what was kept, prototypes first: each make(what) calls what(), which may throw InputError. Precondition: all
  /// else of the file has been read.
  template <class Make>
  void make_all(const json::Reader& in, Make&& make) {
    if (elements_.empty() && prototypes_.empty()) return;
    find_what_is_named();
    bool are_few = false;
    make([&] {
      require_few(in);
      are_few = true;
    });
    if (!are_few) return;
    for (const Kept& prototype : prototypes_) make([&] { check_prototype(in, prototype); });
    for (const Kept& element : elements_) make([&] { add(in, element); });
  }

  /// The materials that prototypes name, whether somebody copies them or not.
  std::vector<Placed<std::string_view>> materials_of_prototypes() const;

  /// What stands here, a name or an object, as one body. Fails where it is a group.
  scene::Body body(json::Reader in);
  /// What stands here, as one body or those of a group.
  BodyParts parts(json::Reader in);

 private:
  /// What stands in the file: a shape, or a body of what is behind its keys, or the members of a prototype.
  struct Kept {
    Placed<std::string_view> name{};
    std::optional<Placed<std::string_view>> material{};
    std::optional<scene::AnyShape> shape{};
    const BodyTipo* tipo = nullptr;
    std::vector<json::Reader> values{};
    std::vector<Kept> members{};
  };
  using ByName = std::map<std::string_view, const Kept*>;

  static Kept read(json::Reader& in, ShapeKeys has);
  static Kept read_prototype(json::Reader& in);
  void find_what_is_named();
  void require_few(const json::Reader& in);
  std::size_t parts_count(const Kept& kept);
  std::size_t parts_count(json::Reader in);
  std::size_t named_count(std::string_view name);
  std::size_t group_count(std::string_view name);
  void check_prototype(const json::Reader& in, const Kept& prototype);
  void add(const json::Reader& in, const Kept& element);
  void add_part(const json::Reader& in, const Kept& element, std::string_view name, const BodyPart& part);
  const BodyParts& parts_of(const json::Reader& in, std::size_t at, const Kept& kept);
  BodyParts made(const Kept& kept);
  BodyParts named(const json::Reader& in, std::size_t at, std::string_view name);
  BodyParts of_group(const json::Reader& in, std::size_t at, std::string_view name);
  BodyPart of_element(const json::Reader& in, const NamePlace& name);

  scene::Scene& scene_;
  std::vector<MaterialUse>& uses_;
  std::vector<WrittenGroup>& groups_;
  std::deque<Kept> elements_, prototypes_;  // in the order of the file
  ByName element_by_name_, prototype_by_name_;
  std::map<std::string, std::size_t, std::less<>> group_by_name_;  // names of its own: groups_ grows
  std::map<std::string_view, Placed<std::string_view>> material_by_name_;
  std::map<const void*, std::size_t> counts_;  // of parts, known before any is made
  std::map<const Kept*, BodyParts> made_;
  std::set<const void*> in_work_;       // who names itself meets itself here
  std::deque<std::string> part_names_;  // what uses_ refer to
  std::size_t count_ = 0, depth_ = 0;
};

}  // namespace durero::io
