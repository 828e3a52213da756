#include "snapshot.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

#include "database.hpp"
#include "durero/io/json/groups_file.hpp"
#include "durero/io/source.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/addition.hpp"
#include "durero/scene/body.hpp"
#include "durero/scene/by_name.hpp"
#include "durero/scene/stage.hpp"

namespace durero::store {
namespace {

using scene::ElementRef;
using scene::GroupedScene;

static_assert(std::endian::native == std::endian::little, "a snapshot is written as the numbers lie in memory");

/// How many binary64 hold a stored attribute, which is made of nothing else.
template <class Stored>
constexpr std::size_t bytes_of_stored = sizeof(Stored);
static_assert(sizeof(glm::dvec3) == 3 * sizeof(double) && sizeof(scene::Corners) == 9 * sizeof(double));

template <class Value>
void append(std::string& to, const Value& value) {
  to.append(reinterpret_cast<const char*>(&value), bytes_of_stored<Value>);
}

bool is_plain(const GroupedScene& of, ElementRef element, const std::string& name) {
  return of.scene.body(element) == nullptr && of.scene.motion(element) == nullptr && !of.scene.wrap(element) &&
         !of.scene.vertex_normals(element) && of.groups.of_element(name).empty();
}

void append_element(std::string& to, const GroupedScene& of, ElementRef element, const std::string& name) {
  append(to, static_cast<std::uint8_t>(name.size()));
  to.append(name);
  append(to, of.scene.material(element).value_or(scene::no_material));
  of.scene.visit(element, [&]<class Shape>(const Shape& shape) {
    scene::for_each_attribute<Shape>([&](const auto& attribute) { append(to, shape.*attribute.field); });
  });
}

/// Copies an element that is not plain, with all that it has.
void copy_element(const GroupedScene& from, ElementRef element, const std::string& name, scene::Scene& to) {
  from.scene.visit(element,
                   [&](const auto& shape) { to.add(model::Elemento(name), shape, from.scene.material(element)); });
  const ElementRef copy = to.find(name).value();
  if (const scene::Body* const body = from.scene.body(element)) to.set_body(copy, *body);
  if (const glm::dvec3* const motion = from.scene.motion(element)) to.set_motion(copy, *motion);
  if (const auto wrap = from.scene.wrap(element)) to.set_wrap(copy, *wrap);
  if (const auto normals = from.scene.vertex_normals(element)) to.set_vertex_normals(copy, *normals);
}

/// The plain elements of one shape: how many, and their bytes.
struct PlainRows {
  std::uint64_t count = 0;
  std::string bytes{};
};

/// Reads what stands in a snapshot, one behind the other.
class SnapshotReader {
 public:
  SnapshotReader(std::string_view left, const std::string& name) : left_(left), name_(name) {}

  std::string_view take(std::uint64_t count) {
    if (count > left_.size()) refuse();
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }
  template <class Value>
  Value number() {
    Value value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  bool is_at_end() const noexcept { return left_.empty(); }
  [[noreturn]] void refuse() const { throw io::FileError(name_, "a snapshot is no scene", expected_whole); }

 private:
  std::string_view left_;
  const std::string& name_;
};

template <class Shape>
void read_row(SnapshotReader& in, scene::Scene& to) {
  const std::string name(in.take(in.number<std::uint8_t>()));
  const auto material = in.number<std::uint32_t>();
  Shape shape{};
  scene::for_each_attribute<Shape>([&](const auto& attribute) {
    shape.*attribute.field = in.number<std::remove_cvref_t<decltype(shape.*attribute.field)>>();
  });
  const bool has_material = material != scene::no_material;
  if (!model::Elemento::is_name(name) || (has_material && material >= to.stage().materials.size())) in.refuse();
  if (!to.add(model::Elemento(name), shape, has_material ? std::optional(material) : std::nullopt).ok()) in.refuse();
}

}  // namespace

std::string snapshot_of(const GroupedScene& of) {
  GroupedScene rest{{}, of.groups};
  rest.scene.stage() = of.scene.stage();
  for (std::size_t i = 0; i < of.scene.meshes().size(); ++i)
    rest.scene.apply_total(scene::MeshEdit(scene::MeshAddition{of.scene.meshes()[i]}));
  std::vector<PlainRows> rows(scene::shape_count);
  for (const ElementRef element : scene::singles_by_name(of.scene)) {
    const std::string name = of.scene.name(element).name();
    if (!is_plain(of, element, name)) {
      copy_element(of, element, name, rest.scene);
      continue;
    }
    PlainRows& of_shape = rows[static_cast<std::size_t>(element.tipo)];
    ++of_shape.count;
    append_element(of_shape.bytes, of, element, name);
  }
  const std::string file = io::scene_text(rest.scene, rest.groups);
  std::string snapshot;
  append(snapshot, std::uint64_t{file.size()});
  snapshot += file;
  for (const PlainRows& of_shape : rows) {
    append(snapshot, of_shape.count);
    snapshot += of_shape.bytes;
  }
  return snapshot;
}

GroupedScene scene_of(std::string_view snapshot, const std::string& name) {
  SnapshotReader in(snapshot, name);
  const std::string file(in.take(in.number<std::uint64_t>()));
  GroupedScene of = io::read_grouped_scene(io::Source(name, file), io::Bodies::read);
  of.scene.put_off_audits();
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) {
    for (auto left = in.number<std::uint64_t>(); left > 0; --left) read_row<Shape>(in, of.scene);
  });
  if (!in.is_at_end()) in.refuse();
  of.scene.audit();
  return of;
}

}  // namespace durero::store
