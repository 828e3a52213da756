#include "durero/io/json/why_not.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

#include "durero/io/json/json_writer.hpp"
#include "durero/model/operaciones_clauses.hpp"
#include "durero/scene/attributes.hpp"
#include "durero/scene/preconditions.hpp"
#include "durero/scene/retrieve.hpp"

namespace durero::io {
namespace {

/// Whether a byte may stand in a name of the text, and so bounds none.
bool is_of_name(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' || c == '?';
}

/// Whether a word stands in a predicate by itself: `e?` does not stand in `de? ∈ elementos`.
bool has_word(std::string_view predicate, std::string_view word) {
  for (std::size_t at = predicate.find(word); at != predicate.npos; at = predicate.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !is_of_name(predicate[at - 1]);
    if (begins && (end == predicate.size() || !is_of_name(predicate[end]) || !is_of_name(word.back()))) return true;
  }
  return false;
}

/// A mesh in a few words: how many points and faces it has, and the first face that is no triangle.
std::string summary_of(const scene::Mesh& mesh) {
  const std::size_t points = mesh.puntos.size();
  const auto is_wrong = [&](const model::Cara& c) {
    if (c.i >= points || c.j >= points || c.k >= points) return true;
    const auto corner = [&](model::Ordinal n) { return model::Punto(mesh.puntos[n]); };
    return !model::Vertices::contains({corner(c.i), corner(c.j), corner(c.k)});
  };
  std::string text = fmt::format("{} puntos, {} caras", points, mesh.caras.size());
  const auto wrong = std::ranges::find_if(mesh.caras, is_wrong);
  if (wrong == mesh.caras.end()) return text;
  return text + fmt::format(", caras {} = ({},{},{})", wrong - mesh.caras.begin(), wrong->i, wrong->j, wrong->k);
}

/// The values of an operation's names, and of what is said of them.
class PredicateValues {
 public:
  explicit PredicateValues(const EditedScene& edited) : scene_(edited.of().scene), types_(edited.types()) {}

  std::vector<NamedValue> of(std::string_view predicate) const {
    std::vector<NamedValue> values;
    for (const NamedValue& named : all_)
      if (has_word(predicate, named.word)) values.push_back(named);
    return values;
  }

  void add(const scene::Edit& edit) {
    std::visit([&](const auto& in) { add_inputs(in); }, edit.operation);
  }
  void add(const WrittenEdit& edit) {
    if (const auto* const in = std::get_if<WrittenAddition>(&edit)) return add_written(in->element);
    add_element(std::get<WrittenRemoval>(edit).e);
  }
  void add(const model::AttributeChange& change) {
    std::visit(
        [&]<class Change>(const Change& in) {
          const auto& attribute = model::attribute_of<Change::component>();
          add_element(in.e.name());
          add(fmt::format("{}?", attribute.word), scene::stored(attribute.input(in)));
        },
        change);
  }
  void add(const model::LookChange& change) {
    std::visit(
        [&](const auto& in) {
          add_element(in.e.name());
          if constexpr (requires { in.material; }) add("material?", in.material);
          if constexpr (requires { in.g; }) add("g?", in.g);
        },
        change);
  }
  void add(const scene::GroupEdit& edit) {
    if (const auto* const in = std::get_if<scene::Ungrouping>(&edit)) return add("g?", in->g);
    const auto& in = std::get<scene::Grouping>(edit);
    add("g?", in.g);
    add("elementos?", std::vector<std::string>(in.of.elementos.begin(), in.of.elementos.end()));
    add("groups?", std::vector<std::string>(in.of.groups.begin(), in.of.groups.end()));
  }
  void add(const scene::Closing& in) {
    add_element(in.e);
    add("base?", in.base);
    add("top?", in.top);
    if (const auto element = scene_.find(in.e)) scene_.visit(*element, [&](const auto& shape) { add_shape(shape); });
  }
  void add(const scene::Copying& in) {
    add_element(in.e);
    add("de?", in.de);
    const std::pair<const char*, const model::ExactVector&> vectors[] = {
        {"x", in.mapa.x}, {"y", in.mapa.y}, {"z", in.mapa.z}};
    for (const auto& [word, v] : vectors)
      add(word,
          glm::dvec3(number::round_to_binary64(v.x), number::round_to_binary64(v.y), number::round_to_binary64(v.z)));
  }
  void add(const scene::Joining& in) {
    add_element(in.e);
    add("de?", in.de);
  }
  void add(const scene::CopyRemoval& in) { add_element(in.e); }
  void add(const scene::SolidRemoval& in) { add_element(in.e); }
  void add(const scene::MeshEdit& edit) {
    std::visit([&](const auto& in) { add_mesh(in); }, edit);
  }

 private:
  void add(std::string word, PredicateValue value) { all_.push_back({std::move(word), std::move(value)}); }

  void add_element(const std::string& name) {
    add("e?", name);
    const auto element = scene_.find(name);
    add("de_que_tipo(e?)", element ? PredicateValue(std::string(model::name(element->tipo))) : PredicateValue());
  }

  template <class Op>
  void add_inputs(const Op& in) {
    add_element(in.e.name());
    if constexpr (requires { in.t; }) add("t?", std::string(model::name(in.t)));
    model::for_each_attribute([&](const auto& attribute) {
      if constexpr (requires { attribute.input(in); })
        add_input(std::string(attribute.word) + "?", attribute.input(in));
    });
  }
  template <class Input>
  void add_input(std::string word, const std::optional<Input>& input) {
    if (input) add_input(std::move(word), *input);
  }
  template <class Input>
  void add_input(std::string word, const Input& input) {
    add(std::move(word), scene::stored(input));
  }

  /// A text speaks of the attributes of its types by their words alone.
  void add_written(const WrittenElement& element) {
    add_element(element.id);
    const std::vector<WrittenAttribute>& attributes = types_[element.type].attributes;
    for (std::size_t i = 0; i < attributes.size(); ++i)
      std::visit([&](const auto& value) { add(attributes[i].word, value); }, element.values[i]);
  }
  template <class Shape>
  void add_shape(const Shape& shape) {
    scene::for_each_attribute<Shape>(
        [&](const auto& attribute) { add(std::string(attribute.word), shape.*attribute.field); });
  }

  void add_mesh(const scene::MeshAddition& in) { add_net(in.mesh); }
  void add_mesh(const scene::MeshReplacement& in) { add_net(in.mesh); }
  void add_net(const scene::Mesh& mesh) {
    add("m?", mesh.m.name());
    add("red?", summary_of(mesh));
  }
  void add_mesh(const scene::MeshRemoval& in) { add("m?", in.m.name()); }
  void add_mesh(const scene::VertexMove& in) {
    add("m?", in.m.name());
    add("n?", std::uint64_t{in.n});
    add("punto?", in.punto.xyz());
  }

  const scene::Scene& scene_;
  std::span<const WrittenType> types_;
  std::vector<NamedValue> all_{};
};

/// @{ The judgements of the program's own clauses.
model::Judgements judged(const EditedScene& edited, const scene::Edit& edit) {
  return model::pre(scene::retrieve(edited.of().scene), edit.operation);
}
model::Judgements judged(const EditedScene& edited, const WrittenEdit& edit) {
  const auto* const in = std::get_if<WrittenAddition>(&edit);
  const auto exists = [&](const std::string& name) { return edited.of().scene.find(name).has_value(); };
  if (in != nullptr) return {{&model::Agregar_Elemento_pre_1, !exists(in->element.id)}};
  return {{&model::Eliminar_Elemento_pre_1, exists(std::get<WrittenRemoval>(edit).e)}};
}
model::Judgements judged(const EditedScene& edited, const model::AttributeChange& change) {
  return model::pre(scene::retrieve(edited.of().scene), change);
}
model::Judgements judged(const EditedScene& edited, const model::LookChange& change) {
  return model::pre(scene::retrieve_looks(edited.of()), change);
}
template <class In>
model::Judgements judged(const EditedScene& edited, const In& in) {
  return scene::pre(edited.of(), in);
}
/// @}

/// Whether the Z text of --with is asked about the step as well, which tells the first predicate alone.
bool asks_text(const EditedScene& edited, const ScriptStep& step) {
  return !edited.types().empty() &&
         (std::holds_alternative<scene::Edit>(step.edit) || std::holds_alternative<WrittenEdit>(step.edit));
}

void write_values(json::Writer& out, const std::vector<NamedValue>& values) {
  out.key("values").begin_object();
  for (const auto& [word, value] : values) {
    out.key(word);
    if (std::holds_alternative<std::monostate>(value)) {
      out.value("undefined");
    } else if (const auto* const names = std::get_if<std::vector<std::string>>(&value)) {
      out.begin_array();
      for (const std::string& name : *names) out.value(name);
      out.end_array();
    } else {
      std::visit(
          [&](const auto& shown) {
            if constexpr (requires { out.value(shown); }) out.value(shown);
          },
          value);
    }
  }
  out.end_object();
}

}  // namespace

WhyNot why_not(const EditedScene& edited, const ScriptStep& step) {
  WhyNot told{edited.copy()->apply_total(step)};
  told.is_whole = !asks_text(edited, step);
  PredicateValues values(edited);
  std::visit([&](const auto& edit) { values.add(edit); }, step.edit);
  const auto add = [&](std::string_view label, std::string_view predicate) {
    if (std::ranges::find(told.broken, label, &BrokenClause::label) == told.broken.end())
      told.broken.push_back({std::string(label), std::string(predicate), values.of(predicate)});
  };
  const model::Judgements all = std::visit([&](const auto& edit) { return judged(edited, edit); }, step.edit);
  for (const auto& [what, holds] : all)
    if (!holds) add(what->label, what->predicate);
  if (!told.answer.ok()) {
    add(told.answer.violated, told.answer.predicate);  // of a face, a body or a text
  } else if (!told.broken.empty()) {
    throw std::logic_error(
        fmt::format("a defect of the program: {} does not hold, and would be carried out; expected "
                    "that all clauses hold of what is carried out",
                    told.broken.front().label));
  }
  return told;
}

std::string why_not_text(std::size_t line, const WhyNot& told) {
  std::string text;
  json::Writer out(text);
  out.begin_object().member("line", std::uint64_t{line}).member("ok", told.answer.ok()).member("r", told.answer.r);
  out.key("broken").begin_array();
  for (const BrokenClause& clause : told.broken) {
    out.begin_object().member("label", clause.label).member("predicate", clause.predicate);
    write_values(out, clause.values);
    out.end_object();
  }
  out.end_array();
  if (!told.is_whole && !told.answer.ok()) out.member("whole", false);
  out.end_object();
  return text;
}

}  // namespace durero::io
