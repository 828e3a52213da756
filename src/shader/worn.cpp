#include "worn.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "durero/contract/contract.hpp"
#include "durero/render/light/whitted.hpp"
#include "durero/scene/axes_across.hpp"
#include "durero/scene/stage.hpp"
#include "tables.hpp"

namespace durero::shader {
namespace {

using scene::Coefficient;
using scene::Material;
using scene::Pattern;
using scene::Texture;

constexpr std::size_t most_glasses = 15;  // four bits each, and one of them for none
constexpr std::size_t few_materials = 8;
/// The least weight of a ray that is followed.
constexpr double least_shader_weight = 0x1p-9;
constexpr std::uint32_t most_waiting = 9;  // shares whose sum is at most 1 let fewer wait

/// A rule that the parts know, and what says that they need it.
struct PatternRow {
  Pattern pattern;
  std::string_view define;
};
constexpr std::array pattern_rows{PatternRow{Pattern::checker, "CHECKER"}, PatternRow{Pattern::stripes, "STRIPES"},
                                  PatternRow{Pattern::p6m, "P6M"}, PatternRow{Pattern::waves, "WAVES"}};

double most_of(const glm::dvec3& x) { return std::max({x.x, x.y, x.z}); }

/// The coordinates (u, v) of an element at the point `at`, in the language of shaders.
std::string coordinates_of(const scene::Sphere& s) { return fmt::format("on_sphere(at - {})", numbers(s.centro)); }
std::string coordinates_of(const scene::Plane& p) {
  const auto [first, second] = scene::axes_across(p.vector);
  return fmt::format("on_flat(at - {}, {}, {})", numbers(p.centro), numbers(first), numbers(second));
}
std::string coordinates_of(const scene::Disc& d) {
  const auto [first, second] = scene::axes_across(d.vector);
  return fmt::format("0.5 + 0.5 / {} * on_flat(at - {}, {}, {})", numbers(d.radio), numbers(d.centro), numbers(first),
                     numbers(second));
}
std::string coordinates_of(const scene::Triangle& t) {
  const auto& [a, b, c] = t.vertices;
  return fmt::format("on_triangle(at - {}, {}, {})", numbers(a), numbers(b - a), numbers(c - a));
}
template <class Round>
std::string coordinates_of(const Round& c) {
  const auto [first, second] = scene::axes_across(c.vector);
  return fmt::format("on_round(at - {}, {}, {}, {}, {})", numbers(c.centro), numbers(c.vector), numbers(c.altura),
                     numbers(first), numbers(second));
}

/// Whether a texture multiplies the coefficient by its colour, and not by the mean of its components.
bool is_colored(Coefficient coefficient) {
  switch (coefficient) {
    case Coefficient::color:
    case Coefficient::M_PS:
    case Coefficient::M_T:
    case Coefficient::emission:
    case Coefficient::ambient:
      return true;
    case Coefficient::k_a:
    case Coefficient::k_d:
    case Coefficient::k_s:
    case Coefficient::k_ps:
    case Coefficient::k_t:
      return false;
  }
  contract::unreachable();
}

/// The colour of a texture at `uv`, in the language of shaders. Precondition: it is no image.
std::string color_of(const Texture& texture) {
  const std::string at = fmt::format("({} * uv)", numbers(texture.repeat)), first = numbers(texture.colors[0]),
                    second = numbers(texture.colors[1]);
  const std::string_view rule = scene::pattern_words[static_cast<std::size_t>(texture.pattern)];
  if (texture.pattern == Pattern::waves) return fmt::format("mix({}, {}, {}{})", first, second, rule, at);
  return fmt::format("({}{} ? {} : {})", rule, at, first, second);
}

/// The materials that elements wear, the default one among them where one wears none.
class WornMaterials {
 public:
  explicit WornMaterials(const scene::Scene& scene) : scene_(scene) {
    scene.for_each([&](scene::ElementRef element, const auto&) { of_elements_.push_back(place(element)); });
    for (const Material& m : materials_) require_drawable(m);
  }

  WornText text(std::uint32_t depth) const {
    std::string tables = defines(depth);
    if (glasses() > 0) tables += glass_tables();
    std::vector<std::string> of_elements;
    for (const std::size_t i : of_elements_) of_elements.push_back(fmt::format("{}", i));
    tables += array("int", "MATERIAL", of_elements);
    const std::string plain = plain_look(tables);
    return {tables, plain + (has_textures() ? coordinates() : "") + look()};
  }

 private:
  /// The place of the element's material, which is added where it is new.
  std::size_t place(scene::ElementRef element) {
    const std::optional<std::uint32_t> material = scene_.material(element);
    const auto [found, is_new] = places_.try_emplace(material, materials_.size());
    if (is_new)
      materials_.push_back(material ? scene_.stage().materials[*material] : Material{.color = render::default_color});
    const Material& worn = materials_[found->second];
    const auto refuse = [&](const char* what) {
      throw std::domain_error(
          fmt::format("element {} {}; expected none in a shader", scene_.name(element).name(), what));
    };
    if (scene_.body(element) != nullptr) refuse("is a copy or a solid");
    if (scene_.vertex_normals(element)) refuse("has normals at its vertices");
    if (worn.textures.any() && scene_.wrap(element)) refuse("has coordinates at its vertices");
    return found->second;
  }

  void require_drawable(const Material& m) const {
    const auto refuse = [&](const char* what) {
      throw std::domain_error(fmt::format("material {} has {}; expected none in a shader", m.name, what));
    };
    if (m.bump) refuse("a relief");
    if (std::isfinite(m.gloss)) refuse("a gloss");
    for (const std::string& name : m.textures.names)
      if (!name.empty() && texture(name).pattern == Pattern::image) refuse("an image");
    if (glasses() > most_glasses)
      throw std::domain_error(
          fmt::format("{} materials let light through; expected {} at most in a shader", glasses(), most_glasses));
  }

  const Texture& texture(const std::string& name) const {
    return *std::ranges::find(scene_.stage().textures, name, &Texture::name);
  }
  std::size_t glasses() const {
    return static_cast<std::size_t>(std::ranges::count_if(materials_, [](const Material& m) { return m.k_t > 0; }));
  }
  bool has_textures() const {
    return std::ranges::any_of(materials_, [](const Material& m) { return m.textures.any(); });
  }

  /// What of a shader the looks need.
  std::string defines(std::uint32_t depth) const {
    const auto any = [&](auto&& of) { return std::ranges::any_of(materials_, of) ? 1 : 0; };
    std::string text = fmt::format("#define GLASSES {}\n#define WAITING {}\n#define HIGHLIGHTS {}\n", glasses(),
                                   waiting(depth), any([](const Material& m) { return m.k_s > 0; }));
    text +=
        fmt::format("const float LEAST = {};  // the least weight of a ray that is followed\n#define COORDINATES {}\n",
                    numbers(least_shader_weight), has_textures() ? 1 : 0);
    for (const PatternRow& row : pattern_rows)
      text += fmt::format("#define {} {}\n", row.define, any([&](const Material& m) { return wears(m, row.pattern); }));
    return text;
  }
  /// The most rays that wait at once: each time that one does, the weight of the other, which is followed, falls to the
  /// lesser share of a material at most, and none is followed below the least weight.
  std::uint32_t waiting(std::uint32_t depth) const {
    double share = 0;
    for (const Material& m : materials_)
      share = std::max(share, std::min(m.k_ps * most_of(m.M_PS), m.k_t * most_of(m.M_T)));
    std::uint32_t most = 0;
    for (double weight = share; weight > least_shader_weight && most < depth; weight *= share) ++most;
    return std::min(most, most_waiting);
  }
  bool wears(const Material& m, Pattern pattern) const {
    return std::ranges::any_of(
        m.textures.names, [&](const std::string& name) { return !name.empty() && texture(name).pattern == pattern; });
  }

  /// The number of each material among those that let light through, and the index of each number; 0 is the open.
  std::string glass_tables() const {
    std::vector<std::string> of_materials, indices{numbers(1)};
    for (const Material& m : materials_) {
      of_materials.push_back(fmt::format("{}u", m.k_t > 0 ? indices.size() : 0));
      if (m.k_t > 0) indices.push_back(numbers(m.index));
    }
    return array("uint", "GLASS", of_materials) + array("float", "INDEX", indices);
  }

  /// The coordinates of those elements whose materials have textures.
  std::string coordinates() const {
    std::string text = "vec2 coordinates(int element, vec3 at) {\n";
    std::size_t i = 0;
    scene_.for_each([&](scene::ElementRef, const auto& shape) {
      if (materials_[of_elements_[i]].textures.any())
        text += fmt::format("  if (element == {}) return {};\n", i, coordinates_of(shape));
      ++i;
    });
    return text + "  return vec2(0.0);\n}\n";
  }

  /// A coefficient of `material`: an array, which is added, or a constant where all materials have the same.
  template <class Value>
  std::string coefficient(std::string& tables, const char* name, Value Material::*which) const {
    std::vector<std::string> values;
    for (const Material& m : materials_) values.push_back(numbers(m.*which));
    if (std::ranges::count(values, values[0]) == std::ptrdiff_t(values.size())) return values[0];
    if (values.size() <= few_materials) return chosen(values);
    const bool is_color = std::is_same_v<Value, glm::dvec3>;
    tables += array(is_color ? "vec3" : "float", fmt::format("OF_{}", name), values);
    return fmt::format("OF_{}[material]", name);
  }
  /// The value of the material, by comparisons: for few materials these take less time than an array.
  static std::string chosen(const std::vector<std::string>& values) {
    std::string text = values.back();
    for (std::size_t i = values.size() - 1; i-- > 0;)
      text = fmt::format("material == {} ? {} : {}", i, values[i], text);
    return text;
  }
  std::string plain_look(std::string& tables) const {
    std::string text = "Look plain_look(int material) {\n  Look look;\n";
    const auto add = [&](const char* name, auto which) {
      text += fmt::format("  look.{} = {};\n", name, coefficient(tables, name, which));
    };
    add("color", &Material::color);
    add("k_a", &Material::k_a);
    add("k_d", &Material::k_d);
    add("k_s", &Material::k_s);
    add("e", &Material::e);
    add("k_ps", &Material::k_ps);
    add("M_PS", &Material::M_PS);
    add("k_t", &Material::k_t);
    add("M_T", &Material::M_T);
    add("emission", &Material::emission);
    add("ambient", &Material::ambient);
    return text + "  return look;\n}\n";
  }

  std::string look() const {
    std::string text = "Look look_of(int material, int element, vec3 at) {\n  Look look = plain_look(material);\n";
    if (has_textures()) text += "  vec2 uv = coordinates(element, at);\n";
    for (std::size_t i = 0; i < materials_.size(); ++i) {
      if (!materials_[i].textures.any()) continue;
      text += fmt::format("  if (material == {}) {{\n", i);
      for (std::size_t c = 0; c < scene::coefficient_words.size(); ++c)
        if (const std::string& name = materials_[i].textures.names[c]; !name.empty())
          text += fmt::format("    look.{} *= {}({});\n", scene::coefficient_words[c],
                              is_colored(static_cast<Coefficient>(c)) ? "" : "grey", color_of(texture(name)));
      text += "  }\n";
    }
    return text + "  return look;\n}\n";
  }

  const scene::Scene& scene_;
  std::map<std::optional<std::uint32_t>, std::size_t> places_;
  std::vector<Material> materials_;
  std::vector<std::size_t> of_elements_;
};

}  // namespace

WornText worn_text(const scene::Scene& scene, std::uint32_t depth) { return WornMaterials(scene).text(depth); }

}  // namespace durero::shader
