#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "durero/io/pov/pov.hpp"
#include "durero/scene/closing.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/solids.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "io/losses.hpp"
#include "io/mesh/numbered_materials.hpp"
#include "pov_look.hpp"
#include "pov_pattern.hpp"
#include "pov_shapes.hpp"
#include "pov_solids.hpp"
#include "pov_stage.hpp"

namespace durero::io {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view meshes[] = {"triangle", "smooth_triangle"},
                           holders[] = {"mesh", "union", "object", "merge", "intersection", "difference", "box"};
/// Objects that are one element, made of their parts.
constexpr std::string_view solid_words[] = {"merge", "intersection", "difference", "box"};
/// Attributes that tell of the look, that are read by themselves, and that no picture of such surfaces shows.
constexpr std::string_view looks[] = {"texture", "pigment", "finish", "normal", "interior"},
                           flags[] = {"no_shadow", "no_image", "no_reflection"},
                           unseen[] = {"hollow", "split_union", "double_illuminate", "bounded_by"};

bool is_object(std::string_view word) { return is_one_of(PovShapes::words, word) || is_one_of(holders, word); }

std::string expected_of(std::string_view word, std::initializer_list<Words> lists) {
  std::vector<std::string> all;
  for (const Words list : lists) all.insert(all.end(), list.begin(), list.end());
  return "expected " + text::expected_of(word, all);
}

/// Objects within objects, at most: each is read by a call within a call.
constexpr int deepest = 200;

/// Whether the textures of a scene stand there on a shape.
bool is_place_of(const scene::AnyShape& shape, const PovPlace& at) {
  const PovCoordinates own = pov_coordinates(shape);
  return at == PovPlace{own.place, own.depth};
}

/// Reads objects one after another; each is then put into the scene as a whole, since an attribute stands behind all
/// that it is of.
class PovReader {
 public:
  explicit PovReader(const Source& source) : in_(source) {
    scene_.stage().resolution = pov_size(source);
    scene_.put_off_audits();
  }

  Imported read() {
    scene::Group all;
    while (!in_.done()) {
      if (stage_.read()) continue;
      if (!is_object(in_.word())) fail_unknown("", {PovShapes::words, holders, PovStage::statements});
      add(read_object(1), {}, all);
    }
    materials_.finish();
    scene_.stage().textures = looks_.patterns();
    std::ranges::sort(scene_.stage().textures, {}, &scene::Texture::name);
    stage_.make_linear();
    scene_.audit();
    std::vector<std::string> lost = losses();
    return {std::move(scene_), std::move(lost), std::move(groups_)};
  }

 private:
  struct Counts {
    std::size_t aligned = 0, empty = 0, bare = 0, rounded_rims = 0, unseen = 0, part_seen = 0, colored_shadows = 0,
                attributes = 0;
  };

  [[noreturn]] void fail_unknown(const std::string& where, std::initializer_list<Words> expected) const {
    if (in_.done()) in_.fail_here(fmt::format("expected }} behind {}", where));
    in_.fail(in_.offset(),
             fmt::format("{} is not read{}", text::shown(in_.word()), where.empty() ? "" : " in " + where),
             expected_of(in_.word(), expected));
  }

  PovObject read_object(int depth) {
    PovObject object{.at = in_.offset(), .word = in_.word()};
    if (depth > deepest) in_.fail(object.at, "objects in objects, deeper than 200", "expected 200 at most");
    in_.pass();
    in_.expect("{", fmt::format("behind {}", object.word));
    const bool is_shape = is_one_of(PovShapes::words, object.word);
    const std::size_t from = is_shape || is_one_of(solid_words, object.word) ? object.at : in_.offset();
    if (is_shape)
      object.shape = shapes_.read(object.word);
    else if (object.word == "box")
      object.box = solids_.box(object.at);
    else
      read_parts(object, depth);
    object.text = in_.passed(from);
    read_attributes(object);
    return object;
  }

  /// An `object` holds one.
  void read_parts(PovObject& object, int depth) {
    const bool is_mesh = object.word == "mesh", is_one = object.word == "object";
    if (is_one && !is_object(in_.word())) fail_unknown("object", {PovShapes::words, holders});
    while (is_mesh ? is_one_of(meshes, in_.word()) : is_object(in_.word())) {
      object.parts.push_back(read_object(depth + 1));
      if (is_one) break;
    }
  }

  void read_attributes(PovObject& object) {
    PovLook look;
    for (bool is_first = true; !in_.take("}"); is_first = false) {
      const auto* const flag = std::ranges::find(flags, in_.word());
      if (flag != std::end(flags)) {
        object.flags[static_cast<std::size_t>(flag - flags)] = true;
        in_.pass();
      } else if (is_one_of(unseen, in_.word())) {
        ++counts_.attributes;
        in_.pass();
        in_.skip_value();
      } else if (!looks_.read(look)) {
        fail_in(object, is_first);
      }
    }
    object.look.is_told = look.at.has_value();
    auto read = looks_.material(look);
    if (!read) return;
    object.look.material = materials_.number(std::move(read->material));
    object.look.at = std::move(read->at);
  }

  /// Its parts stand before its attributes.
  [[noreturn]] void fail_in(const PovObject& object, bool may_be_part) const {
    const bool holds_shapes = object.word == "union" || is_one_of(solid_words, object.word);
    const bool is_union = may_be_part && holds_shapes && object.word != "box",
               is_mesh = may_be_part && object.word == "mesh";
    const Words first = is_mesh ? Words(meshes) : is_union ? Words(PovShapes::words) : Words();
    const Words second = is_union ? Words(holders) : Words();
    fail_unknown(std::string(object.word), {first, second, looks, flags, unseen});
  }

  /// Adds what an object stands for to the scene, and to the group that it is in. What it does not tell of its look, it
  /// has from what it is in.
  void add(const PovObject& object, const ObjectMaterial& around, scene::Group& into) {
    if (is_only_a_shadow(object)) return;
    const ObjectMaterial& look = object.look.is_told ? object.look : around;
    if (object.shape) return add_shape(object, look, into);
    if (object.word == "object") return add(object.parts.front(), look, into);
    if (is_one_of(solid_words, object.word)) return add_solid(object, look, into);
    scene::Group own;
    for (const PovObject& part : object.parts) add(part, look, own);
    add_group(object.word == "mesh" ? numbered('m', meshes_) : numbered('u', unions_), std::move(own), into);
  }

  /// A solid has one look: its own, or the first that a part tells of.
  void add_solid(const PovObject& object, const ObjectMaterial& around, scene::Group& into) {
    if (object.parts.empty() && !object.box) {
      ++counts_.empty;
      return;
    }
    const ObjectMaterial* const of_part = around.is_told ? nullptr : PovSolids::first_look(object);
    const ObjectMaterial& look = of_part != nullptr ? *of_part : around;
    scene::Body body = solids_.body(object, look);
    const std::string name = numbered('b', bodies_);
    if (!look.is_told) ++counts_.bare;
    if (look.at) looks_.leave_out_texture();  // no texture lies on a solid
    scene_.add(model::Elemento{name}, scene::stand_in, look.at ? std::nullopt : look.material);
    scene_.set_body(scene_.find(name).value(), std::move(body));
    into.elementos.insert(name);
  }

  /// A shape with caps is a group: an element, and the discs that close it.
  void add_shape(const PovObject& object, const ObjectMaterial& look, scene::Group& into) {
    const std::string name =
        std::visit([&](const auto& shape) { return add(object, shape, look); }, object.shape->surface);
    if (name.empty()) return;
    if (object.shape->normals) scene_.set_vertex_normals(scene_.find(name).value(), *object.shape->normals);
    if (!object.shape->is_closed) {
      into.elementos.insert(name);
      return;
    }
    const scene::Lids lids = scene::lids(scene_, {name, name + ":base", name + ":top"});
    if (!lids.exact) ++counts_.rounded_rims;
    if (lids.violated != nullptr) fail_clause(object, "its top is beyond binary64", *lids.violated);
    scene::Group own{.elementos = {name}, .groups = {}};
    for (const scene::Edit& disc : lids.additions) {
      const model::Answer answer = scene_.apply_total(disc);
      if (!answer.ok()) fail_clause(object, model::name(answer.r), *answer.violated);
      own.elementos.insert(scene::name_of(disc.operation).name());
    }
    add_group(name, std::move(own), into);
  }

  [[noreturn]] void fail_clause(const PovObject& object, std::string_view wrong, const contract::clause& broken) const {
    in_.fail(object.at, std::string(wrong), fmt::format("expected {} ({})", broken.predicate, broken.label), &broken);
  }

  /// The name of the new element; empty where it is a triangle that is left out.
  template <class Shape>
  std::string add(const PovObject& object, const Shape& shape, const ObjectMaterial& look) {
    static constexpr std::string_view letters = "scktpdv";  // by type
    std::string name = numbered(letters[scene::place_of<Shape>], numbered_[scene::place_of<Shape>]);
    const bool has_place = !look.at || is_place_of(shape, *look.at);
    if (!has_place) looks_.leave_out_texture();
    const model::Answer answer = scene_.add(model::Elemento{name}, shape, has_place ? look.material : std::nullopt);
    if (answer.ok()) {
      if (!look.is_told) ++counts_.bare;
      return name;
    }
    if (!std::is_same_v<Shape, scene::Triangle>) fail_clause(object, model::name(answer.r), *answer.violated);
    ++counts_.aligned;
    return "";
  }

  /// Its name is new, and so is whatever is in it, so that none is refused.
  void add_group(std::string name, scene::Group own, scene::Group& into) {
    if (own == scene::Group()) {
      ++counts_.empty;
      return;
    }
    groups_.apply_total(scene::Grouping{name, std::move(own)}, scene_);
    into.groups.insert(std::move(name));
  }

  static std::string numbered(char letter, std::size_t& count) { return fmt::format("{}{}", letter, ++count); }

  /// Glass with the shadow of a stone is two objects: one without a shadow, and an opaque one that nothing but a shadow
  /// shows. Here it is one.
  bool is_only_a_shadow(const PovObject& object) {
    const auto [no_shadow, no_image, no_reflection] = object.flags;
    if (no_image && no_reflection) {
      const auto twin = shadowless_.find(object.text);
      if (twin == shadowless_.end())
        ++counts_.unseen;
      else
        twin->second = true;
      return true;
    }
    if (no_image || no_reflection) ++counts_.part_seen;
    const auto& material = object.look.material;
    if (no_shadow)
      shadowless_.try_emplace(object.text, false);
    else if (material && scene_.stage().materials[*material].k_t > 0)
      ++counts_.colored_shadows;
    return false;
  }

  std::vector<std::string> losses() const {
    std::vector<std::string> lost;
    stage_.name_losses(lost);
    shapes_.name_losses(lost);
    solids_.name_losses(lost);
    looks_.name_losses(lost);
    add_loss(lost, counts_.aligned, "triangle", "triangles", "left out: the vertices lie on one line");
    add_loss(lost, counts_.empty, "group", "groups", "left out: nothing is in it");
    add_loss(lost, counts_.rounded_rims, "solid", "solids", "closed but for the rounding of its rims");
    add_loss(lost, counts_.bare, "object", "objects", "without a texture: of no material, where POV-Ray's is black");
    add_loss(lost, counts_.unseen, "object", "objects", "left out: nothing but a shadow would show it");
    add_loss(lost, counts_.part_seen, "object", "objects", "not seen everywhere: kept, and seen");
    add_loss(lost,
             static_cast<std::size_t>(std::ranges::count(shadowless_, false, [](const auto& s) { return s.second; })),
             "object", "objects", "without a shadow: kept, with one");
    add_loss(lost, counts_.colored_shadows, "object", "objects",
             "that light goes through: its shadow is that of a stone");
    add_loss(lost, counts_.attributes, "attribute", "attributes", "left out: no picture shows it");
    return lost;
  }

  PovWords in_;
  scene::Scene scene_;
  scene::Groups groups_;
  PovStage stage_{in_, scene_.stage()};
  PovShapes shapes_{in_};
  PovSolids solids_{in_};
  PovLooks looks_{in_};
  NumberedMaterials materials_{scene_};
  Counts counts_;
  std::array<std::size_t, std::tuple_size_v<scene::Shapes>> numbered_{};
  std::size_t meshes_ = 0, unions_ = 0, bodies_ = 0;
  std::map<std::string_view, bool> shadowless_;  // and whether they have a twin
};

}  // namespace

Imported read_pov(const Source& source) { return PovReader(source).read(); }

}  // namespace durero::io
