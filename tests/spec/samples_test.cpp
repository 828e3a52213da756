#include "durero/spec/samples.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "durero/spec/label_index.hpp"
#include "durero/spec/spec.hpp"
#include "support/catch.hpp"

using namespace durero;

TEST_CASE("the samples are states of the text") {
  const zed::Samples samples = spec::samples();
  const zed::Evaluator text(spec::text().sections, spec::sample_constants());
  for (const char* set : {"Escena", "Tablas", "Retrieve", "Rayo", "Punto", "Vector", "Terna", "Rmas", "Parte",
                          "Cantidad", "Material", "conserva", "Fuente", "Ventana", "Mallas", "Red", "Vecinos"})
    for (const zed::Value& each : samples.at(set)) {
      INFO(set << ": " << each.text());
      CHECK(text.contains(text.value(zed::Name{set, ""}), each) == zed::Truth::yes);
    }
}

TEST_CASE("the samples have states of each lifted operation, with shapes as the text's own constructors make them") {
  const zed::Samples samples = spec::samples();
  const zed::Evaluator text(spec::text().sections);
  const zed::Typing typing = zed::check(spec::text());
  std::set<std::string> made;
  for (const char* type : {"Esfera", "Cilindro", "Cono", "Tronco", "Plano", "Disco", "Triangulo"})
    for (const char* deed : {"Agregar_", "Eliminar_"}) {
      const std::string schema = std::string(deed) + type + "_Formas";
      INFO(schema);
      REQUIRE(samples.contains(schema));
      const zed::Value steps = text.value(zed::Name{schema, ""});
      const auto& fields = typing.find("promocion", {schema, ""})->scheme.type.parts()[0].fields();
      for (const zed::Value& each : samples.at(schema)) {
        CHECK(text.contains(steps, each) == zed::Truth::yes);
        CHECK(*each.binding()->names == fields);
        for (const zed::Value& pair : *each.binding()->component({"forma", ""})->set()->members()) {
          const auto& shape = **pair.tuple()->parts[1].get<zed::ConstructedPtr>();
          const std::string word = shape.constructor->text;
          CHECK(zed::same(text.apply(text.value(zed::Name{word, ""}), shape.argument), pair.tuple()->parts[1]));
          made.insert(word);
        }
      }
    }
  CHECK(made.size() == 7);
}

/// The conjectures that cannot be tried: of a function on all whole numbers, or on all ways of light, the evaluator
/// cannot say that it is one; a ray whose direction may have any length is not determined, nor is what is nearest
/// of all points of an element; equations that tell a draw, a lens, a pencil, a beam, a shadow, a cone of light or
/// a point that a map puts somewhere have no value among those drawn, nor do those that tell a moved mesh; the
/// state in the middle of a composition is not determined; and the members of sets of quadrics, of the identity on
/// states and of the inverse of all transitions cannot be enumerated, so that no history has a value. What these say of
/// meshes, maps, solids, cones of light, changes and histories, tests of the model try.
bool beyond_trial(const std::string& label) {
  static const char* const families[] = {"acumulado.",
                                         "aplicado.",
                                         "aportacion.",
                                         "circulo_de_confusion.",
                                         "compuesto.conj.1",
                                         "con_signo.",
                                         "copia.conj.3",
                                         "cuerpo.",
                                         "de_luz_extensa.",
                                         "Deshacer.conj.1",
                                         "Deshacer_Total.conj.1",
                                         "Elemento_Agregado.conj.1",
                                         "Elemento_Eliminado.conj.1",
                                         "Eliminar_Malla.conj.1",
                                         "estirado.",
                                         "haz.",
                                         "identidad.",
                                         "iluminada.",
                                         "intensidad.",
                                         "interior.",
                                         "mas_cercano.",
                                         "media.conj.1",
                                         "media.conj.2",
                                         "mezcla.conj.3",
                                         "Mismo_Aspecto.conj.1",
                                         "Mover_Vertice.conj.1",
                                         "movido.conj.2",
                                         "oscura.",
                                         "pliegue.conj.1",
                                         "rayo_de_lente.conj.1",
                                         "rayo_de_pixel.",
                                         "Reemplazar_Malla.conj.1",
                                         "refraccion_paraxial.conj.1",
                                         "Rehacer.conj.1",
                                         "Rehacer_Total.conj.1",
                                         "repartida.conj.1",
                                         "ruleta.conj.1",
                                         "solido_",
                                         "sueltas.conj.2",
                                         "sueltas.conj.8",
                                         "superficie.",
                                         "superficie_desde.conj.1",
                                         "Transaccion.conj.1",
                                         "Transaccion_Total.conj.1",
                                         "transiciones.conj.1",
                                         "transmitido.",
                                         "traslado.conj.1",
                                         "trazador."};
  return std::any_of(std::begin(families), std::end(families),
                     [&](const char* each) { return label.starts_with(each); });
}

TEST_CASE("no conjecture of the text is false on the samples, and each is tried that can be") {
  const auto trials = zed::try_conjectures(spec::text(), zed::check(spec::text()), spec::samples(),
                                           {.states = 8, .draws = 128, .constants = spec::sample_constants()});
  CHECK(trials.size() == 317);
  for (const zed::Trial& trial : trials) {
    INFO(trial.label);
    CHECK(trial.counterexample.empty());
    CHECK_FALSE(trial.label.empty());
    INFO(trial.why_not);
    CHECK((trial.tried == 0) == beyond_trial(trial.label));
    CHECK(trial.why_not.empty() == (trial.tried > 0));
  }
}

TEST_CASE("a conjecture that the samples refute is refuted") {
  zed::Specification wrong = spec::text();
  for (zed::Section& section : wrong.sections)
    for (zed::Paragraph& paragraph : section.paragraphs)
      if (auto* conjecture = std::get_if<zed::Conjecture>(&paragraph.form))
        if (conjecture->claim.label == "alcances.conj.1") {
          const zed::Term& claim = conjecture->claim.term;
          conjecture->claim.term = zed::quantified(
              zed::Kind::forall, *claim->text, {zed::node(zed::Kind::negation, {claim->children[0]})}, claim->place);
        }
  for (const zed::Trial& trial : zed::try_conjectures(wrong, zed::check(wrong), spec::samples()))
    CHECK(trial.counterexample.empty() == (trial.label != "alcances.conj.1"));
}
