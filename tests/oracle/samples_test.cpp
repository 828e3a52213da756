#include "durero/oracle/samples.hpp"

#include <algorithm>
#include <iterator>

#include "durero/oracle/spec.hpp"
#include "durero/oracle/spec_index.hpp"
#include "support/catch.hpp"

using namespace durero;
using namespace durero::oracle;

TEST_CASE("the samples are states of the text") {
  const zed::Samples samples = spec::samples();
  const spec::Judge judge;
  const zed::Evaluator& text = judge.evaluator();
  for (const char* set : {"Escena", "Tablas", "Retrieve", "Rayo", "Punto", "Vector", "Terna"})
    for (const zed::Value& each : samples.at(set)) {
      INFO(set << ": " << each.text());
      CHECK(text.contains(text.value(zed::Name{set, ""}), each) == zed::Truth::yes);
    }
}

/// What is said of values that chance does not draw: a Material has twelve numbers, most of them shares, a Trazado
/// functions of all ways, and a Ventana whole numbers of pixels; the axis of the cylinder and the cone of one is one
/// vector; and visible asks whether a set of points without end is empty.
bool beyond_chance(const std::string& label) {
  static const char* const families[] = {"Material.",      "acumulado.",       "aportacion.", "centro_de_pixel.",
                                         "conserva.",      "coseno_cuadrado.", "directa.",    "potencia_cilindro.",
                                         "potencia_cono.", "rayo_de_pixel.",   "trazador.",   "visible."};
  return std::any_of(std::begin(families), std::end(families),
                     [&](const char* each) { return label.starts_with(each); });
}

TEST_CASE("no conjecture of the text is false on the samples, and each is tried but what is beyond chance") {
  const auto trials =
      zed::try_conjectures(spec::text(), zed::check(spec::text()), spec::samples(), {.states = 8, .draws = 128});
  CHECK(trials.size() == 87);
  for (const zed::Trial& trial : trials) {
    INFO(trial.label);
    CHECK(trial.counterexample.empty());
    CHECK_FALSE(trial.label.empty());
    INFO(trial.why_not);
    CHECK((trial.tried >= 1 || beyond_chance(trial.label)));
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
