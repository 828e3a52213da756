#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "durero/io/pbrt/pbrt.hpp"
#include "durero/text/nearest.hpp"
#include "durero/text/shown.hpp"
#include "io/losses.hpp"
#include "io/placed/placed_scene.hpp"
#include "pbrt_look.hpp"
#include "pbrt_shapes.hpp"
#include "pbrt_stage.hpp"
#include "pbrt_words.hpp"

namespace durero::io {
namespace {

/// States within each other, at most.
constexpr std::size_t deepest_state = 10'000;

/// The settings of the shapes that follow.
struct PbrtState {
  AffinePlacement by{};
  std::optional<std::uint32_t> material{};  ///< nothing: the usual one
  scene::Material look{};
  glm::dvec3 emission{0};
  bool has_bright_back = false;  ///< whether the emission is on both sides, as in a scene
  bool at_start = true;          ///< whether transformations are of the time at which the shutter opens
};

class PbrtReader {
 public:
  explicit PbrtReader(const Source& source) : words_(source) { state_.look = looks_.usual(); }

  Imported read() {
    while (!words_.done()) {
      for (std::size_t ends = words_.ends(); ends > 0; --ends) leave("Import");
      const PbrtWord word = words_.next();
      const auto* const known = std::ranges::find(statements, word.is_quoted ? "" : word.text, &Statement::word);
      if (known == statements.end()) fail_unknown(word);
      (this->*known->carry_out)();
    }
    for (std::size_t ends = words_.ends(); ends > 0; --ends) leave("Import");
    if (!states_.empty()) words_.fail(fmt::format("{} has no end", states_.back().first), "expected it");
    if (!into_.empty()) words_.fail("ObjectBegin has no end", "expected ObjectEnd");
    stage_.finish();
    return made_.take(losses());
  }

 private:
  using Carry = void (PbrtReader::*)();
  struct Statement {
    std::string_view word;
    Carry carry_out;
  };
  static const std::array<Statement, 45> statements;

  [[noreturn]] void fail_unknown(const PbrtWord& word) const {
    std::vector<std::string> known;
    for (const Statement& one : statements) known.emplace_back(one.word);
    words_.fail(fmt::format("{} is no statement", text::shown(word.text)),
                "expected " + text::expected_of(std::string(word.text), known));
  }

  /// Passes the parameters of a statement whose type is a text.
  std::pair<std::string, PbrtParameters> typed(std::string_view what) {
    std::string type = words_.quoted(what);
    return {std::move(type), words_.parameters()};
  }
  void count_unknown(const PbrtParameters& parameters) {
    for (const std::string& name : parameters.unknown()) ++parameters_[name];
  }

  // Statements, in the order of their table.

  void attribute_begin() { enter("AttributeBegin"); }
  void attribute_end() { leave("AttributeBegin"); }
  void transform_begin() { enter("TransformBegin"); }
  void transform_end() { leave("TransformBegin"); }

  void enter(std::string_view word) {
    if (states_.size() == deepest_state)
      words_.fail(fmt::format("states within each other, deeper than {}", deepest_state), "expected fewer");
    states_.emplace_back(word, state_);
  }
  /// TransformEnd brings the transformation back alone, as in pbrt 3.
  void leave(std::string_view word) {
    if (states_.empty() || states_.back().first != word)
      words_.fail(fmt::format("the end of {} stands here", word),
                  states_.empty() ? "expected its beginning before it"
                                  : fmt::format("expected that of {}", states_.back().first));
    PbrtState before = std::move(states_.back().second);
    states_.pop_back();
    if (word == "TransformBegin")
      state_.by = std::move(before.by);
    else
      state_ = std::move(before);
  }

  void move(const AffinePlacement& by) {
    if (!state_.at_start) {
      ++motions_;
      return;
    }
    state_.by = state_.by.after(by);
    if (state_.by.steps > AffinePlacement::most_steps)
      words_.fail(fmt::format("more than {} transformations one after another", AffinePlacement::most_steps),
                  "expected fewer");
  }

  void identity() {
    if (state_.at_start) state_.by = {};
  }
  glm::dvec3 three(std::string_view what) {
    const std::vector<double> numbers = words_.numbers(3, what);
    return {numbers[0], numbers[1], numbers[2]};
  }
  void translate() { move(AffinePlacement::translation(three("Translate"))); }
  void scale() { move(AffinePlacement::scaling(three("Scale"))); }
  void rotate() {
    const std::vector<double> numbers = words_.numbers(4, "Rotate");
    const auto turn = AffinePlacement::rotation({numbers[1], numbers[2], numbers[3]}, numbers[0]);
    if (!turn) words_.fail("Rotate about no axis", "expected an angle, and x, y and z of an axis");
    move(*turn);
  }
  /// It brings the world before the camera, where other transformations put things into the world.
  void look_at() {
    const std::vector<double> n = words_.numbers(9, "LookAt");
    const auto frame = AffinePlacement::looking({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]});
    if (!frame) words_.fail("LookAt gives no direction", "expected two points, and up across the way between them");
    move(*frame->inverse());
  }
  AffinePlacement sixteen(std::string_view what) {
    const std::vector<double> numbers = words_.numbers(16, what);
    std::array<double, 16> matrix{};
    std::ranges::copy(numbers, matrix.begin());
    if (matrix[3] != 0 || matrix[7] != 0 || matrix[11] != 0 || !(matrix[15] > 0))
      words_.fail(fmt::format("{} of another last column", what), "expected 0, 0, 0 and 1 in it");
    return AffinePlacement::of_matrix(matrix);
  }
  void transform() {
    const AffinePlacement by = sixteen("Transform");
    if (state_.at_start)
      state_.by = by;
    else
      ++motions_;
  }
  void concat_transform() { move(sixteen("ConcatTransform")); }
  void coordinate_system() { systems_.insert_or_assign(words_.quoted("a name"), state_.by); }
  void coord_sys_transform() {
    const std::string name = words_.quoted("a name");
    const auto found = systems_.find(name);
    if (found == systems_.end())
      words_.fail(fmt::format("{} names no system of coordinates", text::shown(name)), "expected one from above");
    if (state_.at_start) state_.by = found->second;
  }
  void active_transform() {
    const PbrtWord word = words_.next();
    if (word.text != "StartTime" && word.text != "EndTime" && word.text != "All")
      words_.fail(fmt::format("{} stands here", text::shown(word.text)), "expected StartTime, EndTime or All");
    state_.at_start = word.text != "EndTime";
  }
  void transform_times() {
    words_.numbers(2, "TransformTimes");
    ++settings_;
  }

  /// Sides are told apart by no shape here.
  void reverse_orientation() {}
  void world_begin() {
    state_ = {};
    state_.look = looks_.usual();
    systems_.insert_or_assign("world", AffinePlacement());
  }
  void world_end() {}

  void camera() {
    const auto [type, parameters] = typed("a type of camera");
    auto frame = state_.by.inverse();
    if (frame) systems_.insert_or_assign("camera", *frame);
    stage_.read_camera(type, parameters, std::move(frame));
    count_unknown(parameters);
  }
  void film() {
    const auto [type, parameters] = typed("a type of film");
    stage_.read_film(parameters);
    count_unknown(parameters);
  }
  /// How a picture is drawn, which a scene does not say.
  void setting() {
    typed("a type");
    ++settings_;
  }
  /// Of pbrt 4: a setting without a type; and the name of a space of colours.
  void option() {
    words_.parameters();
    ++settings_;
  }
  void color_space() {
    words_.quoted("a name");
    ++settings_;
  }
  void medium() {
    typed("a medium");
    ++media_;
  }
  void medium_interface() {
    words_.quoted("a medium");
    words_.take_quoted();  // the one outside
    ++media_;
  }

  void light_source() {
    const auto [type, parameters] = typed("a type of light");
    stage_.read_light(type, parameters, state_.by);
    count_unknown(parameters);
  }
  void area_light_source() {
    const auto [type, parameters] = typed("a type of light");
    state_.emission = looks_.light(parameters, "L", 1);
    state_.has_bright_back = parameters.word("twosided", "false") == "true";
    state_.material.reset();
    count_unknown(parameters);
  }

  void set_look(scene::Material look) {
    state_.look = std::move(look);
    state_.material.reset();
  }
  void material() {
    const auto [type, parameters] = typed("a type of material");
    set_look(looks_.material(type, parameters));
    count_unknown(parameters);
  }
  void make_named_material() {
    const auto [name, parameters] = typed("a name of a material");
    named_.insert_or_assign(name, looks_.material(parameters.word("type", "diffuse"), parameters));
    count_unknown(parameters);
  }
  void named_material() {
    const auto [name, parameters] = typed("the name of a material");
    const auto found = named_.find(name);
    without_material_ += found == named_.end();
    set_look(found == named_.end() ? looks_.usual() : found->second);
  }
  void texture() {
    const std::string name = words_.quoted("the name of a texture");
    words_.quoted("what it is of");
    const auto [type, parameters] = typed("a type of texture");
    looks_.add_texture(name, type, parameters);
  }

  void include() { words_.include(words_.quoted("the name of a file"), false); }
  void import() {
    const std::string name = words_.quoted("the name of a file");
    enter("Import");
    words_.include(name, true);
  }

  /// A look, with what the surface shines, as a material.
  std::uint32_t material_here() {
    if (!state_.material) {
      scene::Material look = state_.look;
      look.emission = state_.emission;
      state_.material = made_.material(std::move(look));
    }
    if (state_.emission != glm::dvec3(0) && !state_.has_bright_back) ++emitters_;
    return *state_.material;
  }

  void shape() {
    const PbrtPlace at = words_.place();
    const auto [type, parameters] = typed("a type of shape");
    auto surface = shapes_.read(at, type, parameters);
    count_unknown(parameters);
    if (!surface) return;
    PlacedThing thing{std::move(*surface), state_.by};
    thing.material = material_here();
    if (into_.empty())
      put(at, thing, all_);
    else
      objects_[into_].push_back(std::move(thing));
  }
  void put(const PbrtPlace& at, const PlacedThing& thing, scene::Group& into) {
    if (!made_.add(thing, into))
      at.fail(fmt::format("more than {} elements", PlacedScene::most_elements), "expected fewer, instances included");
  }

  void object_begin() {
    const std::string name = words_.quoted("the name of an object");
    if (!into_.empty() || name.empty())
      words_.fail("an object within another", "expected ObjectEnd before it, and a name");
    enter("ObjectBegin");
    into_ = name;
    objects_[name].clear();
  }
  void object_end() {
    leave("ObjectBegin");
    into_.clear();
  }
  void object_instance() {
    const PbrtPlace at = words_.place();
    const std::string name = words_.quoted("the name of an object");
    const auto found = objects_.find(name);
    if (found == objects_.end())
      words_.fail(fmt::format("{} names no object", text::shown(name)), "expected one from above");
    if (!into_.empty()) words_.fail("an instance within an object", "expected it outside, as pbrt does");
    scene::Group own;
    for (PlacedThing thing : found->second) {
      thing.by = state_.by.after(thing.by);
      put(at, thing, own);
    }
    made_.add_instance(std::move(own), all_);
  }

  std::vector<std::string> losses() const {
    std::vector<std::string> lost;
    stage_.name_losses(lost);
    looks_.name_losses(lost);
    shapes_.name_losses(lost);
    add_loss(lost, emitters_, "surface", "surfaces", "with a light: it shines on both of its sides");
    add_loss(lost, without_material_, "name of a material", "names of materials",
             "that nothing above has: a grey of one half");
    add_loss(lost, media_, "medium", "media", "left out: a scene has none");
    add_loss(lost, motions_, "transformation", "transformations",
             "of the end of a motion left out: things are where they begin");
    for (const auto& [name, count] : parameters_)
      add_loss(lost, count, fmt::format("parameter {}", text::shown(name)),
               fmt::format("parameters {}", text::shown(name)), "left out: no scene has such");
    add_loss(lost, settings_, "setting", "settings", "left out: how a picture is drawn, the call says");
    return lost;
  }

  PbrtWords words_;
  PlacedScene made_;
  PbrtLooks looks_;
  PbrtStage stage_{made_.stage(), looks_};
  PbrtShapes shapes_{words_};
  PbrtState state_;
  std::vector<std::pair<std::string, PbrtState>> states_;  // with the words that began them
  std::map<std::string, AffinePlacement> systems_;
  std::map<std::string, scene::Material> named_;
  std::map<std::string, std::vector<PlacedThing>> objects_;
  std::string into_;  // the object that shapes are of; empty outside
  scene::Group all_;
  std::size_t emitters_ = 0, without_material_ = 0, media_ = 0, motions_ = 0, settings_ = 0;
  std::map<std::string, std::size_t> parameters_;  // by name
};

const std::array<PbrtReader::Statement, 45> PbrtReader::statements{
    {{"Shape", &PbrtReader::shape},
     {"AttributeBegin", &PbrtReader::attribute_begin},
     {"AttributeEnd", &PbrtReader::attribute_end},
     {"TransformBegin", &PbrtReader::transform_begin},
     {"TransformEnd", &PbrtReader::transform_end},
     {"ObjectBegin", &PbrtReader::object_begin},
     {"ObjectEnd", &PbrtReader::object_end},
     {"ObjectInstance", &PbrtReader::object_instance},
     {"Include", &PbrtReader::include},
     {"Import", &PbrtReader::import},
     {"Identity", &PbrtReader::identity},
     {"Translate", &PbrtReader::translate},
     {"Scale", &PbrtReader::scale},
     {"Rotate", &PbrtReader::rotate},
     {"LookAt", &PbrtReader::look_at},
     {"Transform", &PbrtReader::transform},
     {"ConcatTransform", &PbrtReader::concat_transform},
     {"CoordinateSystem", &PbrtReader::coordinate_system},
     {"CoordSysTransform", &PbrtReader::coord_sys_transform},
     {"ActiveTransform", &PbrtReader::active_transform},
     {"TransformTimes", &PbrtReader::transform_times},
     {"ReverseOrientation", &PbrtReader::reverse_orientation},
     {"WorldBegin", &PbrtReader::world_begin},
     {"WorldEnd", &PbrtReader::world_end},
     {"Camera", &PbrtReader::camera},
     {"Film", &PbrtReader::film},
     {"LightSource", &PbrtReader::light_source},
     {"AreaLightSource", &PbrtReader::area_light_source},
     {"Material", &PbrtReader::material},
     {"MakeNamedMaterial", &PbrtReader::make_named_material},
     {"NamedMaterial", &PbrtReader::named_material},
     {"Texture", &PbrtReader::texture},
     {"Integrator", &PbrtReader::setting},
     {"SurfaceIntegrator", &PbrtReader::setting},
     {"Sampler", &PbrtReader::setting},
     {"PixelFilter", &PbrtReader::setting},
     {"Accelerator", &PbrtReader::setting},
     {"VolumeIntegrator", &PbrtReader::setting},
     {"Renderer", &PbrtReader::setting},
     {"Volume", &PbrtReader::medium},
     {"Attribute", &PbrtReader::setting},
     {"Option", &PbrtReader::option},
     {"ColorSpace", &PbrtReader::color_space},
     {"MakeNamedMedium", &PbrtReader::medium},
     {"MediumInterface", &PbrtReader::medium_interface}}};

}  // namespace

Imported read_pbrt(const Source& source) { return PbrtReader(source).read(); }

}  // namespace durero::io
