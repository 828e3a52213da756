#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "durero/io/pov/algebraic.hpp"
#include "durero/io/pov/pov.hpp"
#include "durero/scene/closing.hpp"
#include "durero/scene/scene.hpp"
#include "durero/scene/solids.hpp"
#include "durero/scene/stage.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "io/letters.hpp"
#include "io/losses.hpp"
#include "io/mesh/numbered_materials.hpp"
#include "pov_bounds.hpp"
#include "pov_isosurface.hpp"
#include "pov_look.hpp"
#include "pov_mesh.hpp"
#include "pov_patch.hpp"
#include "pov_pattern.hpp"
#include "pov_pieces.hpp"
#include "pov_program.hpp"
#include "pov_shapes.hpp"
#include "pov_solids.hpp"
#include "pov_stage.hpp"
#include "pov_swept.hpp"
#include "pov_transform.hpp"
#include "pov_turned.hpp"
#include "pov_written_shapes.hpp"

namespace durero::io {
namespace {

using Words = std::span<const std::string_view>;

constexpr std::string_view meshes[] = {"triangle", "smooth_triangle"},
                           holders[] = {"mesh",           "mesh2",      "polygon",    "union",        "object", "merge",
                                        "intersection",   "difference", "box",        "prism",        "lathe",  "sor",
                                        "superellipsoid", "blob",       "isosurface", "bicubic_patch"};
/// Objects that no scene has.
constexpr std::string_view others[] = {"height_field", "julia_fractal", "lemon", "ovus",
                                       "parametric",   "sphere_sweep",  "text"};
/// Statements that tell of what no scene has.
constexpr std::string_view other_statements[] = {"fog", "rainbow", "media", "photons", "radiosity", "light_group"};
/// Objects that are one element, made of their parts.
constexpr std::string_view solid_words[] = {"merge", "intersection", "difference", "box"};
/// Attributes that tell of the look, that are read by themselves, that no picture of such surfaces shows, and that
/// limit what is shown.
constexpr std::string_view looks[] = {"texture", "pigment", "finish", "normal", "interior", "material"},
                           moves[] = {"translate", "rotate", "scale", "matrix", "transform"},
                           flags[] = {"no_shadow", "no_image", "no_reflection"},
                           unseen[] = {"hollow",    "split_union",   "double_illuminate", "sturm",
                                       "hierarchy", "inside_vector", "uv_mapping",        "photons",
                                       "radiosity", "no_radiosity",  "cutaway_textures",  "interior_texture"},
                           limits[] = {"bounded_by", "clipped_by"};

bool is_object(std::string_view word) {
  return is_one_of(PovShapes::words, word) || is_one_of(holders, word) || is_one_of(pov_surface_words, word) ||
         is_one_of(others, word);
}

std::string expected_of(std::string_view word, std::initializer_list<Words> lists) {
  std::vector<std::string> all;
  for (const Words list : lists) all.insert(all.end(), list.begin(), list.end());
  return "expected " + text::expected_of(word, all);
}

/// Objects within objects, at most: each is read by a call within a call.
constexpr int deepest_object = 200;

/// Whether the textures of a scene stand there on a shape.
bool is_place_of(const scene::AnyShape& shape, const PovPlace& at) {
  const PovCoordinates own = pov_coordinates(shape);
  return at == PovPlace{pov_normal_text(own.place), own.depth};
}

/// Reads objects one after another; each is then put into the scene as a whole, since an attribute stands behind all
/// that it is of.
class PovReader {
 public:
  explicit PovReader(const Source& source) : program_(source), in_(program_), keeps_surfaces_(source.keeps_surfaces()) {
    scene_.put_off_audits();
  }

  Imported read() {
    scene::Group all;
    while (!in_.done()) {
      if (stage_.read()) continue;
      if (in_.take("#default") || in_.take("default")) {
        looks_.read_default();
        continue;
      }
      if (is_one_of(other_statements, in_.word())) {
        ++left_out_[std::string(in_.word())];
        in_.pass();
        in_.skip_value();
        continue;
      }
      if (in_.take(";")) continue;
      if (!is_object(in_.word())) fail_unknown("", {PovShapes::words, holders, PovStage::statements});
      const PovObject object = read_object(1);
      add(object, default_material(), {}, {}, all);
    }
    materials_.finish();
    scene_.stage().textures = looks_.patterns();
    std::ranges::sort(scene_.stage().textures, {}, &scene::Texture::name);
    stage_.make_linear();
    scene_.audit();
    std::vector<std::string> lost = losses();
    return {std::move(scene_), std::move(lost), std::move(groups_), std::move(surfaces_)};
  }

 private:
  struct Counts {
    std::size_t aligned = 0, empty = 0, bare = 0, rounded_rims = 0, unseen = 0, part_seen = 0, colored_shadows = 0,
                attributes = 0, solids = 0, clipped = 0, rounded = 0, bounded = 0, zeros = 0, part_looks = 0;
  };

  [[noreturn]] void fail_unknown(const std::string& where, std::initializer_list<Words> expected) const {
    if (in_.done()) in_.fail_here(fmt::format("expected }} behind {}", where));
    in_.fail(in_.offset(),
             fmt::format("{} is not read{}", text::shown(in_.word()), where.empty() ? "" : " in " + where),
             expected_of(in_.word(), expected));
  }

  PovObject read_object(int depth) {
    PovObject object{.at = in_.offset(), .word = in_.word()};
    if (depth > deepest_object) in_.fail(object.at, "objects in objects, deeper than 200", "expected 200 at most");
    in_.pass();
    in_.expect("{", fmt::format("behind {}", object.word));
    const bool is_shape = is_one_of(PovShapes::words, object.word);
    if (is_one_of(others, object.word)) {
      ++left_out_[std::string(object.word)];
      in_.skip_block();
      object.is_left_out = true;
      return object;
    }
    const bool is_whole = is_shape || is_one_of(solid_words, object.word) || is_one_of(pov_surface_words, object.word);
    const std::size_t from = is_whole ? object.at : in_.offset();
    if (is_shape)
      object.shape = shapes_.read(object.word);
    else if (is_one_of(pov_surface_words, object.word))
      read_surface(object);
    else if (object.word == "box")
      object.box = solids_.box();
    else if (object.word == "mesh2" || object.word == "polygon" || object.word == "prism")
      read_triangles(object);
    else if (is_turned(object.word))
      read_turned(object);
    else if (object.word == "bicubic_patch")
      read_patch(object);
    else if (object.word == "isosurface")
      read_isosurface(object);
    else if (object.word == "superellipsoid" || object.word == "blob")
      read_element(object);
    else
      read_parts(object, depth);
    object.text = in_.passed(from);
    read_attributes(object, depth);
    return object;
  }

  void read_surface(PovObject& object) {
    object.surface = read_pov_surface(in_, object.word);
    object.is_left_out = !keeps_surfaces_ || !object.surface;
    if (object.surface && !keeps_surfaces_) ++only_by_text_;
    if (object.surface) return;
    ++left_out_[object.word == "poly" ? "poly of degree five or more" : "torus that passes through itself, in part,"];
  }

  /// From where its { stands before.
  void read_curved_prism(PovObject& object, const PovWords& begin) {
    const PovWords end = in_;
    in_.stand_where(begin);
    auto parts = read_pov_curved_prism(in_, object.at);
    object.is_left_out = !parts;
    if (parts)
      object.parts = *std::move(parts);
    else
      ++left_out_["prism of curves that is closed, or whose outline touches itself,"];
    in_.stand_where(end);
  }

  void read_patch(PovObject& object) {
    object.patch = read_pov_patch(in_);
    object.is_left_out = !object.patch;
    if (!object.patch) ++left_out_["bicubic_patch of more than 20 steps in all"];
  }

  void read_isosurface(PovObject& object) {
    auto pieces = read_pov_isosurface(in_);
    object.is_left_out = !pieces;
    if (pieces)
      object.pieces = *std::move(pieces);
    else
      ++left_out_["isosurface of no polynomial, or of a degree above four,"];
  }

  void read_element(PovObject& object) {
    const bool is_blob = object.word == "blob";
    object.element = is_blob ? read_pov_blob(in_, counts_.part_looks) : read_pov_superellipsoid(in_);
    object.is_left_out = !object.element;
    if (!object.element)
      ++left_out_[is_blob ? "blob of too many parts, or one moved otherwise," : "superellipsoid of too high a degree"];
  }

  void read_turned(PovObject& object) {
    auto parts = read_pov_turned(in_, object.word, object.at);
    object.is_left_out = !parts;
    if (parts)
      object.parts = *std::move(parts);
    else
      ++left_out_["lathe with a line that crosses its axis or turns back"];
  }

  /// An `object` holds one.
  void read_parts(PovObject& object, int depth) {
    const bool is_mesh = object.word == "mesh", is_one = object.word == "object";
    if (is_one && !is_object(in_.word()) && in_.word() != "light_source")
      fail_unknown("object", {PovShapes::words, holders});
    while (is_mesh ? is_one_of(meshes, in_.word()) : is_object(in_.word()) || in_.word() == "light_source") {
      if (in_.word() == "light_source")
        object.parts.push_back(read_light());
      else
        object.parts.push_back(read_object(depth + 1));
      if (is_one) break;
    }
  }

  PovObject read_light() {
    PovObject object{.at = in_.offset(), .word = in_.word()};
    in_.pass();
    in_.expect("{", "behind light_source");
    object.light = read_pov_light(in_);
    return object;
  }

  void read_attributes(PovObject& object, int depth) {
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
      } else if (const auto move = take_pov_transform(in_)) {
        object.moved = object.moved.then(*move);
        for (PovClip& clip : object.clips) clip.place = clip.place.then(*move);
        if (object.bound) object.bound->place = object.bound->place.then(*move);
        counts_.zeros += move->zeros;
        if (look.at) looks_.move(look);
      } else if (in_.take("inverse")) {
        object.is_inverse = !object.is_inverse;
      } else if (is_one_of(limits, in_.word())) {
        read_limit(object, depth);
      } else if (in_.take("material")) {
        in_.expect("{", "behind material");
        while (!in_.take("}"))
          if (!looks_.read(look) && !take_pov_transform(in_)) fail_unknown("material", {looks});
      } else if (!looks_.read(look)) {
        fail_in(object, is_first);
      }
    }
    if (object.may_be_cut) ++counts_.bounded;
    object.look.is_told = look.at.has_value();
    auto read = looks_.material(look);
    if (!read) return;
    object.look.material = materials_.number(std::move(read->material));
    object.look.at = std::move(read->at);
  }

  /// A bound or a clip: objects, or the word of the other one, which is then the same.
  void read_limit(PovObject& object, int depth) {
    const bool is_clip = in_.word() == "clipped_by";
    const std::string_view other = is_clip ? "bounded_by" : "clipped_by";
    in_.pass();
    in_.expect("{", is_clip ? "behind clipped_by" : "behind bounded_by");
    if (in_.take(other)) {
      in_.expect("}", fmt::format("behind {}", other));
      if (is_clip) clip(object, object.bound);
      object.may_be_cut = false;  // it lies within both
      return;
    }
    const std::vector<PovObject> by = read_limiting(depth);
    if (is_clip) return clip(object, clip_by(by));
    object.may_be_cut = !surely_hold(by, object);
    if (!object.may_be_cut) ++counts_.attributes;
    object.bound = clip_by(by);
  }

  static void clip(PovObject& object, std::optional<PovClip> by) {
    if (by)
      object.clips.push_back(*std::move(by));
    else
      object.has_lost_clip = true;
  }

  /// Objects up to a }, of which nothing is told: they are not shown.
  std::vector<PovObject> read_limiting(int depth) {
    const Counts counts = counts_;
    const auto left_out = left_out_;
    const std::size_t only_by_text = only_by_text_;
    std::vector<PovObject> all;
    while (is_object(in_.word())) all.push_back(read_object(depth + 1));
    const PovTransform by = take_pov_transforms(in_);
    for (PovObject& each : all) each.moved = each.moved.then(by);
    in_.expect("}", "behind what limits an object");
    counts_ = counts, left_out_ = left_out, only_by_text_ = only_by_text;
    return all;
  }

  /// Its parts stand before its attributes.
  [[noreturn]] void fail_in(const PovObject& object, bool may_be_part) const {
    const bool holds_shapes = object.word == "union" || is_one_of(solid_words, object.word);
    const bool is_union = may_be_part && holds_shapes && object.word != "box",
               is_mesh = may_be_part && object.word == "mesh";
    const Words first = is_mesh ? Words(meshes) : is_union ? Words(PovShapes::words) : Words();
    const Words second = is_union ? Words(holders) : Words();
    fail_unknown(std::string(object.word), {first, second, looks, moves, flags, unseen, limits});
  }

  /// Adds what an object stands for to the scene, and to the group that it is in. What it does not tell of its look, it
  /// has from what it is in; and what clips that clips it.
  void add(const PovObject& object, const ObjectMaterial& around, const PovTransform& by,
           const std::vector<PovClip>& clips_around, scene::Group& into) {
    if (object.is_left_out || is_only_a_shadow(object)) return;
    const ObjectMaterial& look = object.look.is_told ? object.look : around;
    const PovTransform here = object.moved.then(by);
    if (object.light) return stage_.add(*object.light, here);
    if (object.has_lost_clip) return count_clipped();
    std::vector<PovClip> clips = clips_around;
    for (PovClip clip : object.clips) {
      clip.place = clip.place.then(by);
      clip.is_rounded = clip.is_rounded || !by.is_identity();
      clips.push_back(std::move(clip));
    }
    if (object.word == "object") return add(object.parts.front(), look, here, clips, into);
    const bool is_clipped = !clips.empty() && object.word != "union" && !is_turned(object.word);
    if (is_clipped || (object.shape && object.shape->hole != 0) || !object.pieces.empty())
      return add_pieces(object, look, here, clips, into);
    if (object.shape) return add_shape(object, look, here, into);
    if (object.surface || object.element) return add_surface(object, look, here, into);
    if (is_one_of(solid_words, object.word)) return add_solid(object, look, by, into);
    scene::Group own;
    for (const PovObject& part : object.parts) add(part, look, here, clips, own);
    if (object.patch) add_patch(object, look, here, own);
    add_group(is_of_triangles(object.word) ? numbered('m', meshes_) : numbered('u', unions_), std::move(own), into);
  }

  /// Adds the triangles of a patch, which POV-Ray divides where it is put.
  void add_patch(const PovObject& object, const ObjectMaterial& look, const PovTransform& by, scene::Group& into) {
    for (PovShape& triangle : triangles_of(*object.patch, by)) {
      PovObject part{.at = object.at, .word = "triangle"};
      part.shape = std::move(triangle);
      add(part, look, {}, {}, into);
    }
  }

  void count_clipped() { ++counts_.clipped; }

  /// Adds the pieces of a surface that is clipped, or has a hole, as elements of a Z text.
  void add_pieces(const PovObject& object, const ObjectMaterial& look, const PovTransform& by,
                  const std::vector<PovClip>& clips, scene::Group& into) {
    const auto pieces = pieces_of(object);
    const auto clip = clips.empty() ? std::nullopt : common_clip(clips);
    if (!pieces || clip.has_value() == clips.empty()) return count_clipped();
    std::vector<std::pair<std::size_t, std::vector<WrittenValue>>> elements;
    bool is_rounded = false;
    for (const PovPiece& piece : *pieces) {
      auto values = clipped_piece(piece, clip ? &*clip : nullptr, by, is_rounded);
      if (!values) return count_clipped();
      elements.emplace_back(piece.is_lid ? lid_of_surface : clipped_surface, *std::move(values));
    }
    if (!keeps_surfaces_) {
      ++only_by_text_;
      return;
    }
    if (is_rounded) ++counts_.rounded;
    scene::Group own;
    for (auto& [type, values] : elements) add_written(type, std::move(values), look, own);
    if (elements.size() == 1) return into.elementos.merge(own.elementos);
    add_group(numbered('u', unions_), std::move(own), into);
  }

  /// The look of what tells of none: POV-Ray's own, where #default told of another.
  ObjectMaterial default_material() {
    auto read = looks_.default_material();
    if (!read) return {};
    return {true, materials_.number(std::move(read->material)), std::nullopt};
  }

  /// The triangles of a mesh2, a polygon or a prism, from behind its { to behind its numbers.
  void read_triangles(PovObject& object) {
    std::optional<std::vector<PovShape>> triangles;
    if (object.word == "polygon") {
      triangles = read_pov_polygon(in_);
      object.is_left_out = !triangles;
      if (!triangles) ++left_out_["polygon that touches itself, or of several parts,"];
    } else if (object.word == "prism") {
      const PovWords begin = in_;
      triangles = read_pov_prism(in_);
      if (!triangles) return read_curved_prism(object, begin);
    } else {
      const PovMesh mesh = read_pov_mesh(in_);
      counts_.attributes += mesh.left_out;
      triangles = mesh.triangles();
    }
    if (!triangles) return;
    for (PovShape& triangle : *triangles) {
      PovObject part{.at = object.at, .word = "triangle"};
      part.shape = std::move(triangle);
      object.parts.push_back(std::move(part));
    }
  }

  /// A solid has one look: its own, or the first that a part tells of.
  void add_solid(const PovObject& object, const ObjectMaterial& around, const PovTransform& by, scene::Group& into) {
    if (object.parts.empty() && !object.box) {
      ++counts_.empty;
      return;
    }
    if (!PovSolids::is_solid(object)) {
      ++counts_.solids;
      return;
    }
    const ObjectMaterial* const of_part = around.is_told ? nullptr : PovSolids::first_look(object);
    const ObjectMaterial& look = of_part != nullptr ? *of_part : around;
    add_body(solids_.body(object, look, by), look, into);
  }

  /// Adds an element that no table holds, on which no texture lies.
  std::string add_stand_in(char letter, std::size_t& count, const ObjectMaterial& look) {
    std::string name = numbered(letter, count);
    if (!look.is_told) ++counts_.bare;
    if (look.at) looks_.leave_out_texture();
    scene_.add(model::Elemento{name}, scene::stand_in, look.at ? std::nullopt : look.material);
    return name;
  }

  void add_body(scene::Body body, const ObjectMaterial& look, scene::Group& into) {
    const std::string name = add_stand_in('b', bodies_, look);
    scene_.set_body(scene_.find(name).value(), std::move(body));
    into.elementos.insert(name);
  }

  /// A shape with caps is a group: an element, and the discs that close it.
  void add_shape(const PovObject& object, const ObjectMaterial& look, const PovTransform& by, scene::Group& into) {
    const auto placed = shapes_.placed(object.at, object.word, *object.shape, by);
    if (!placed) return add_copy(object, look, by, into);
    ObjectMaterial own_look = look;
    if (own_look.at && !by.is_identity()) own_look.at->place += " moved";
    const auto add_placed = [&](const auto& surface) { return add_element(surface, own_look); };
    const std::string name = std::visit(add_placed, placed->surface);
    if (name.empty()) return;
    if (placed->normals) scene_.set_vertex_normals(scene_.find(name).value(), *placed->normals);
    if (!placed->is_closed) {
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

  void add_surface(const PovObject& object, const ObjectMaterial& look, const PovTransform& by, scene::Group& into) {
    auto values = object.element ? placed_element(*object.element, by) : placed_surface(*object.surface, by);
    if (!values) in_.fail(object.at, "numbers beyond binary64", "expected smaller ones");
    if (!keeps_surfaces_) {
      ++only_by_text_;
      return;
    }
    if (object.element && object.element->is_rounded) ++counts_.rounded;
    add_written(object.element ? object.element->type : type_of(*object.surface), *std::move(values), look, into);
  }

  void add_written(std::size_t type, std::vector<WrittenValue> values, const ObjectMaterial& look, scene::Group& into) {
    const std::string name = add_stand_in('a', algebraic_, look);
    surfaces_.emplace(name, WrittenElement{name, type, 0, std::move(values), {}});
    into.elementos.insert(name);
  }

  /// Adds what a map makes of a shape that is then of no type: a copy of it, and of its caps.
  void add_copy(const PovObject& object, const ObjectMaterial& look, const PovTransform& by, scene::Group& into) {
    const PovShape shape = *shapes_.placed(object.at, object.word, *object.shape, {});
    scene::Scene original;
    const auto add = [&](const auto& s) { return original.add(model::Elemento("e"), s); };
    const model::Answer answer = std::visit(add, shape.surface);
    if (!answer.ok()) return refuse(*answer.violated);
    scene::Group own;
    add_body({scene::Instance{shape.surface, by.map()}}, look, own);
    if (!shape.is_closed) return into.elementos.merge(own.elementos);
    for (const scene::Edit& disc : scene::lids(original, {"e", "e:base", "e:top"}).additions)
      original.apply_total(disc);
    for (const scene::Disc& disc : original.shapes<scene::Disc>())
      add_body({scene::Instance{disc, by.map()}}, look, own);
    add_group(numbered('u', unions_), std::move(own), into);
  }

  void refuse(const contract::clause& broken) { ++refused_[fmt::format("{} ({})", broken.predicate, broken.label)]; }

  [[noreturn]] void fail_clause(const PovObject& object, std::string_view wrong, const contract::clause& broken) const {
    in_.fail(object.at, std::string(wrong), fmt::format("expected {} ({})", broken.predicate, broken.label), &broken);
  }

  /// The name of the new element; empty where it is left out.
  template <class Shape>
  std::string add_element(const Shape& shape, const ObjectMaterial& look) {
    std::string name = numbered(letter_of<Shape>(), numbered_[scene::place_of<Shape>]);
    const bool has_place = !look.at || is_place_of(shape, *look.at);
    if (!has_place) looks_.leave_out_texture();
    const model::Answer answer = scene_.add(model::Elemento{name}, shape, has_place ? look.material : std::nullopt);
    if (answer.ok()) {
      if (!look.is_told) ++counts_.bare;
      return name;
    }
    if (std::is_same_v<Shape, scene::Triangle>)
      ++counts_.aligned;
    else
      refuse(*answer.violated);
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
    for (const auto& [word, count] : left_out_) add_loss(lost, count, word, word, "left out: a scene has none");
    add_loss(lost, only_by_text_, "surface", "surfaces", "left out: a scene has such by a Z text alone (--with)");
    add_loss(lost, counts_.solids, "solid", "solids", "left out: a part of it bounds nothing that a scene has");
    add_loss(lost, counts_.clipped, "object", "objects", "left out: clipped_by");
    add_loss(lost, counts_.part_looks, "texture", "textures", "of parts of a blob left out: a surface has one");
    add_loss(lost, counts_.rounded, "surface", "surfaces", "by a Z text, with rounded numbers");
    add_loss(lost, counts_.bounded, "bounded_by", "bounded_by",
             "left out: it may cut, where POV-Ray shows a thing only to rays that meet its bound");
    for (const auto& [clause, count] : refused_)
      add_loss(lost, count, "object", "objects", "left out: a scene's have " + clause);
    add_loss(lost, counts_.zeros, "0", "0s", "that scale: taken for 1, as POV-Ray does");
    add_loss(lost, counts_.attributes, "attribute", "attributes", "left out: no picture shows it");
    return lost;
  }

  PovProgram program_;
  PovWords in_;
  scene::Scene scene_;
  scene::Groups groups_;
  PovStage stage_{in_, scene_.stage(), pov_size(program_.source())};
  PovShapes shapes_{in_};
  PovSolids solids_{in_, shapes_};
  PovLooks looks_{in_};
  NumberedMaterials materials_{scene_};
  Counts counts_;
  std::array<std::size_t, std::tuple_size_v<scene::Shapes>> numbered_{};
  std::size_t meshes_ = 0, unions_ = 0, bodies_ = 0, algebraic_ = 0, only_by_text_ = 0;
  bool keeps_surfaces_;
  WrittenByName surfaces_;
  std::map<std::string, std::size_t> left_out_;
  std::map<std::string, std::size_t> refused_;
  std::map<std::string, bool> shadowless_;  // and whether they have a twin
};

}  // namespace

Imported read_pov(const Source& source) { return PovReader(source).read(); }

}  // namespace durero::io
