#include "durero/written/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <stdexcept>

#include "durero/io/source.hpp"
#include "durero/scene/shapes.hpp"
#include "durero/spec/spec.hpp"
#include "durero/zed/print/print.hpp"
#include "durero/zed/syntax/paragraphs.hpp"
#include "symbolic.hpp"

namespace durero::written {
namespace {

using zed::Name;
using zed::Type;

constexpr std::string_view prefix = "puntos_";

[[noreturn]] void fail(const zed::Defect& defect) {
  throw io::InputError(defect.file, {defect.place.line, defect.place.column}, defect.what, defect.expected);
}

using Texts = std::map<std::string, std::string>;

/// The file, and the sections of the program's own text that the file does not have itself. `read` reads texts by the
/// names of their files.
template <class Read>
zed::Specification read_with_own(const io::Source& file, Read read) {
  Texts texts{{file.name(), std::string(file.text())}};
  const zed::Specification alone = read(texts);
  for (const zed::Section& own : spec::text().sections)
    if (!alone.find(own.name)) texts.emplace(own.file, spec::files().at(own.file));
  zed::Specification whole = read(texts);
  if (!whole.defects.empty()) fail(whole.defects[0]);
  return whole;
}

/// @{ The texts with the parents that stand beside a file, and without.
zed::Specification read_with_neighbours(const Texts& texts) { return zed::read_sources({texts.begin(), texts.end()}); }
zed::Specification read_alone(const Texts& texts) { return zed::read_texts(texts); }
/// @}

bool is_number(const Type& type) { return type.is(Type::Kind::given) && type.name().text() == "𝔸"; }

bool has_fields(const Type& type, std::string_view names, bool (*is_right)(const Type&)) {
  if (!type.is(Type::Kind::schema) || type.fields().size() != names.size()) return false;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (type.fields()[i].text() != names.substr(i, 1) || !is_right(type.parts()[i])) return false;
  return true;
}

bool is_triple(const Type& type) { return has_fields(type, "xyz", is_number); }
bool is_three_points(const Type& type) { return has_fields(type, "abc", is_triple); }

std::optional<io::WrittenKind> kind_of(const Type& type) {
  if (is_number(type)) return io::WrittenKind::number;
  if (is_triple(type)) return io::WrittenKind::triple;
  if (is_three_points(type)) return io::WrittenKind::three_points;
  return std::nullopt;
}

SymbolicValue triple_value(SymbolicValue x, SymbolicValue y, SymbolicValue z) {
  return {Fields{{{"x", ""}, std::move(x)}, {{"y", ""}, std::move(y)}, {{"z", ""}, std::move(z)}}};
}

/// The values of attributes, whose numbers may be off: each by an error of its own, in their order.
class AttributeValues {
 public:
  explicit AttributeValues(const AttributeErrors* errors) : errors_(errors) {}

  SymbolicValue operator()(const io::WrittenValue& value) {
    largest_ = largest(value);
    if (const auto* const x = std::get_if<double>(&value)) return number_value(*x);
    if (const auto* const v = std::get_if<glm::dvec3>(&value)) return triple(*v);
    const auto& corners = std::get<scene::Corners>(value);
    return {Fields{{{"a", ""}, triple(corners[0])}, {{"b", ""}, triple(corners[1])}, {{"c", ""}, triple(corners[2])}}};
  }
  /// How many numbers there were.
  std::size_t count() const { return count_; }

 private:
  static double largest(const io::WrittenValue& value) {
    const auto of_triple = [](const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
    if (const auto* const x = std::get_if<double>(&value)) return std::abs(*x);
    if (const auto* const v = std::get_if<glm::dvec3>(&value)) return of_triple(*v);
    const auto& corners = std::get<scene::Corners>(value);
    return std::max({of_triple(corners[0]), of_triple(corners[1]), of_triple(corners[2])});
  }
  SymbolicValue number_value(double x) {
    const std::size_t number = count_++;
    if (errors_ == nullptr) return {Formula(number::exact(x))};
    return {Formula::off_by(number::exact(x), number, errors_->part * number::exact(largest_) + errors_->least)};
  }
  SymbolicValue triple(const glm::dvec3& v) {
    SymbolicValue x = number_value(v.x), y = number_value(v.y), z = number_value(v.z);
    return triple_value(std::move(x), std::move(y), std::move(z));
  }

  const AttributeErrors* errors_;
  double largest_ = 0;
  std::size_t count_ = 0;
};

SymbolicValue any_point() {
  return triple_value({Formula::coordinate(0)}, {Formula::coordinate(1)}, {Formula::coordinate(2)});
}

/// The moving point, whose s is the coordinate x. Its coordinates have the errors of that number and the next two.
SymbolicValue moving(const MovedPoint& point, std::size_t first_error) {
  const Formula s = Formula::coordinate(0);
  const auto coordinate = [&](std::size_t axis) -> SymbolicValue {
    const std::size_t error = first_error + axis;
    return {Formula::off_by(point.at.at(axis), error, point.off) +
            s * Formula::off_by(point.step.at(axis), error, point.off_by_step)};
  };
  return triple_value(coordinate(0), coordinate(1), coordinate(2));
}

bool is_shape(std::string_view word) {
  bool is = false;
  scene::for_each_shape([&]<class Shape>(std::type_identity<Shape>) { is = is || Shape::word == word; });
  return is;
}

}  // namespace

struct Text::State {
  State(const std::string& name, zed::Specification read) : file(name), specification(std::move(read)) {
    typing = zed::check(specification);
    if (!typing.ok()) fail(typing.defects[0]);
    for (const zed::Section& each : specification.sections) {
      if (each.file != file) continue;
      section = each.name;
      declares_shapes = declares_shapes || spec::text().find(each.name) != nullptr;
      for (const zed::Paragraph& paragraph : each.paragraphs)
        for (const Name& declared : zed::names_of(paragraph)) add_type(declared);
    }
    symbolic = std::make_unique<Symbolic>(specification, typing);
    if (!has_points)
      throw io::InputError(file, {1, 1}, "no section of it declares points of a type of elements",
                           fmt::format("expected a function such as {}toro, to ℙ Punto", prefix));
  }

  void add_type(const Name& declared) {
    if (!declared.word.starts_with(prefix)) return;
    const Symbolic reader(specification, typing);
    const auto parameters = reader.parameters(section, declared);
    if (!parameters || !gives_points(declared)) return;
    has_points = true;
    const std::string word = declared.word.substr(prefix.size());
    declares_shapes = declares_shapes || is_shape(word);
    auto attributes = attributes_of(*parameters);
    if (!attributes || is_shape(word)) return;
    check_keys(*attributes, *parameters, declared);
    types.push_back({word, std::move(*attributes)});
  }

  /// Checks that the names of attributes do not clash with the keys of an element in a scene file, and that they are
  /// not too many.
  void check_keys(const std::vector<io::WrittenAttribute>& attributes, const FunctionParameters& of,
                  const Name& name) const {
    constexpr std::size_t most = 32;
    const auto refuse = [&](const std::string& what, const std::string& expected) {
      fail({specification.find(of.section)->file, of.body->place, what, expected});
    };
    if (attributes.size() > most)
      refuse(fmt::format("{} has {} parameters", name.text(), attributes.size()),
             fmt::format("expected {} at most", most));
    for (const std::string_view key : {"id", "tipo", "material", "e"})
      if (std::ranges::find(attributes, key, &io::WrittenAttribute::word) != attributes.end())
        refuse(fmt::format("a parameter of {} is called {}", name.text(), key),
               "expected another name: every element has that of its own");
  }

  /// Whether the values of the function are sets of points: its type is ℙ (A × ℙ Punto).
  bool gives_points(const Name& function) const {
    const Type type = typing.find(section, function)->scheme.type.settled();
    if (!type.is(Type::Kind::power) || !type.parts()[0].is(Type::Kind::product)) return false;
    const Type& result = type.parts()[0].parts().back();
    return result.is(Type::Kind::power) && is_triple(result.parts()[0]);
  }

  std::optional<Type> type_of(const FunctionParameters& function, const zed::Term& formal) const {
    zed::Term set;
    if (formal->kind == zed::Kind::theta) set = formal->children[0];
    for (const zed::Declaration& declaration : function.head.declarations)
      if (std::ranges::find(declaration.names, formal->name) != declaration.names.end()) set = declaration.term;
    const auto type = set ? typing.type_of(set) : std::nullopt;
    if (!type || !type->is(Type::Kind::power)) return std::nullopt;
    return type->settled().parts()[0];
  }

  /// The attributes of a function; nothing where one is of a type that scene files do not have.
  std::optional<std::vector<io::WrittenAttribute>> attributes_of(const FunctionParameters& function) const {
    std::vector<io::WrittenAttribute> attributes;
    const auto add = [&](const Name& name, const Type& type) {
      const auto kind = kind_of(type);
      if (kind) attributes.push_back({name.text(), *kind});
      return kind.has_value();
    };
    for (const zed::Term& formal : function.formal) {
      const auto type = type_of(function, formal);
      if (!type) return std::nullopt;
      if (is_whole(function, *type)) {
        for (std::size_t i = 0; i < type->fields().size(); ++i)
          if (!add(type->fields()[i], type->parts()[i])) return std::nullopt;
      } else if (formal->kind != zed::Kind::reference || !add(formal->name, *type)) {
        return std::nullopt;
      }
    }
    return attributes;
  }

  /// Whether the one parameter is a schema whose components are the attributes.
  static bool is_whole(const FunctionParameters& function, const Type& type) {
    return function.formal.size() == 1 && type.is(Type::Kind::schema) && !kind_of(type);
  }

  Tuple arguments(const FunctionParameters& function, Tuple values) const {
    const auto type = type_of(function, function.formal[0]);
    if (!type || !is_whole(function, *type)) return values;
    Fields fields;
    for (std::size_t i = 0; i < values.size(); ++i) fields.emplace(type->fields()[i], values[i]);
    return {SymbolicValue{std::move(fields)}};
  }

  /// The condition under which a point, point(the number of errors of attributes), is one of an element, and what
  /// `made` makes of it.
  template <class PointOf, class Maker>
  auto of_points(const std::string& type, const std::vector<io::WrittenValue>& attributes,
                 const AttributeErrors* errors, PointOf point, Maker made) {
    const std::scoped_lock lock(asking);
    const Name function{std::string(prefix) + type, ""};
    const auto parameters = symbolic->parameters(section, function);
    if (!parameters)
      throw io::InputError(file, {1, 1}, fmt::format("no equation gives {} a value", function.text()),
                           fmt::format("expected ∀ … • {}(…) = {{ w : Punto | … }}", function.text()));
    AttributeValues value_of(errors);
    Tuple values;
    for (const io::WrittenValue& attribute : attributes) values.push_back(value_of(attribute));
    const Tuple of_function = arguments(*parameters, std::move(values));
    const zed::Place place = parameters->body->place;
    const std::string& where = specification.find(parameters->section)->file;
    if (of_function.size() != parameters->formal.size())
      fail({where, place, fmt::format("{} takes {} arguments", function.text(), parameters->formal.size()),
            fmt::format("expected {}, the attributes of {}", of_function.size(), type)});
    constexpr std::size_t axes = 3;  // whose errors stand behind those of the attributes
    symbolic->let_numerals_be_off(errors ? errors->part : number::Rational(0), value_of.count() + axes);
    try {
      const SymbolicValue set = symbolic->apply(section, function, of_function);
      const auto* const suspended = std::get_if<Suspended>(&set.form);
      Condition points = suspended ? symbolic->member(point(value_of.count()), *suspended) : always(true);
      if (errors == nullptr) require_surface(points, function, {where, place});
      return made(std::move(points));
    } catch (const Refusal& refusal) {
      fail(refusal.defect);
    } catch (const Outside& outside) {
      throw NotInDomain{type, outside.parameter.text(), outside.expected};
    } catch (const std::length_error& error) {
      fail({where, place, fmt::format("{} comes to {}", function.text(), error.what()),
            fmt::format("expected a degree of {} at most, and fewer digits", Formula::max_degree)});
    } catch (const zed::StepsSpent&) {
      fail({where, place, fmt::format("{} takes more steps than it may", function.text()), "expected a shorter text"});
    }
  }

  /// Checks that a condition is that of an algebraic surface.
  static void require_surface(const Condition& points, const Name& function,
                              const std::pair<std::string, zed::Place>& at) {
    const std::size_t pieces = Surface::pieces(points);
    if (pieces == 0)
      fail({at.first, at.second, fmt::format("not all points of {} satisfy an equation", function.text()),
            "expected p = q ∧ clips, where p and q are polynomials, or a union of such"});
    if (pieces > Surface::most_pieces)
      fail({at.first, at.second, fmt::format("{} is a union of {} pieces", function.text(), pieces),
            fmt::format("expected {} at most", Surface::most_pieces)});
  }

  std::string file, section;
  zed::Specification specification;
  zed::Typing typing;
  std::unique_ptr<Symbolic> symbolic;
  std::vector<io::WrittenType> types;
  bool has_points = false, declares_shapes = false;
  std::mutex asking;  // of `symbolic`, which counts its steps
};

Text::Text(const std::string& file)
    : state_(std::make_unique<State>(file, read_with_own(io::read_source(file), read_with_neighbours))) {}
Text::Text(const io::Source& source)
    : state_(std::make_unique<State>(source.name(), read_with_own(source, read_alone))) {}
Text::~Text() = default;
Text::Text(Text&&) noexcept = default;
Text& Text::operator=(Text&&) noexcept = default;

const std::string& Text::file() const { return state_->file; }
const std::vector<io::WrittenType>& Text::types() const { return state_->types; }
bool Text::declares_shapes() const { return state_->declares_shapes; }

Surface Text::surface(const std::string& type, const std::vector<io::WrittenValue>& attributes) const {
  return state_->of_points(
      type, attributes, nullptr, [](std::size_t) { return any_point(); },
      [](const Condition& points) { return Surface(points); });
}

MovedPoints Text::moved_points(const std::string& type, const std::vector<io::WrittenValue>& attributes,
                               const AttributeErrors& errors, const MovedPoint& at) const {
  return state_->of_points(
      type, attributes, &errors, [&](std::size_t numbers) { return moving(at, numbers); },
      [](Condition points) { return MovedPoints(std::move(points)); });
}

}  // namespace durero::written
