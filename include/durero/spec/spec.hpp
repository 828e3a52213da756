#pragma once
/// The Z text itself, evaluated. What it says of a state, a transition or a point is what the words in
/// spec/ say, and nothing of the program's own clauses or functions stands in between.

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "durero/model/exact_point.hpp"
#include "durero/model/judgement.hpp"
#include "durero/model/malla.hpp"
#include "durero/model/operation.hpp"
#include "durero/model/tipos.hpp"
#include "durero/scene/element_ref.hpp"
#include "durero/zed/evaluate/evaluate.hpp"

namespace durero::scene {
struct Tablas;
}  // namespace durero::scene

namespace durero::spec {

/// The files of spec/ as they were when the program was built, by name.
const std::map<std::string, std::string>& files();

/// The Z text of spec/ as it was when the program was built. Read once; it has no defect, or std::logic_error.
const zed::Specification& text();

/// @{ The program's value as one of the text.
zed::Value value(const model::Elemento& e);
zed::Value value(model::Tipo tipo);
zed::Value value(model::Respuesta r);
zed::Value value(const model::ExactPoint& p);
zed::Value value(const model::Punto& p);
zed::Value value(const model::Vector& v);
zed::Value value(const model::Terna& v);
zed::Value value(const model::Rayo& rayo);
zed::Value value(const model::Cara& c);
zed::Value value(const model::Red& red);
zed::Value value(scene::ElementRef place);
/// @}
/// θEscena
zed::Value value(const model::Escena& escena);

/// Components by name: of a state, of an operation.
using Named = zed::Valuation;
/// @{ The components of Escena, of Mallas, of Vista, and of Tablas.
Named components(const model::Escena& escena);
Named components(const model::Mallas& s);
Named components(const model::Vista& s);
Named components(const scene::Tablas& tables);
/// @}
/// The binding of these components.
zed::Value binding(Named parts);
/// @{ The inputs of an operation, `e?` or `m?` and the others.
Named inputs(const model::Operation& operation);
Named inputs(const model::MeshOperation& operation);
Named change_inputs(const model::AttributeChange& change);
Named change_inputs(const model::LookChange& change);
/// @}
/// The part of nombre_cara that names the faces below `count` of these meshes: a value for that constant of the text,
/// which leaves it open.
zed::Value names_of_faces(const std::set<model::Elemento>& meshes, model::Ordinal count);

/// e ∈ de_malla(θMallas). Where it is so, an operation on e alone is refused (Es_De_Malla).
bool in_de_malla(const model::Elemento& e, const model::Mallas& s);

/// @{ The schema of the operation, and of its total one: `Agregar_Esfera`, `Agregar_Esfera_Total`.
std::string schema_name(const model::Operation& operation);
std::string total_name(const model::Operation& operation);
/// @}

/// A transition that an operation made, or declined to make.
struct OperationStep {
  const model::Escena& before;        ///< the state before
  const model::Operation& operation;  ///< with its inputs
  model::Respuesta r;                 ///< r!
  const model::Escena& after;         ///< the state after
};

/// Every name of the operation's schema that a step gives a value.
Named named(const OperationStep& step);
/// The values of a schema's components; open where they are not given.
std::vector<zed::Value> in_order(const std::vector<zed::Name>& components, const Named& named);

/// Decides by the text. Not for use by two threads at once.
class Judge {
 public:
  Judge();
  ~Judge();
  Judge(const Judge&) = delete;
  Judge& operator=(const Judge&) = delete;

  /// @{ Whether the values satisfy the partial operation, or the total one.
  bool holds(const OperationStep& step) const;
  bool holds_total(const OperationStep& step) const;
  /// @}
  /// Every conjunct of the partial operation, and its truth.
  std::vector<zed::ConjunctTruth> findings(const OperationStep& step) const;
  /// @{ Every conjunct, where the after-state and r! are not known: what depends on them is open.
  std::vector<zed::ConjunctTruth> findings(const model::Escena& before, const model::Operation& operation) const;
  std::vector<zed::ConjunctTruth> change_findings(const model::Escena& before,
                                                  const model::AttributeChange& change) const;
  /// @}
  /// Every conjunct of Escena.
  std::vector<zed::ConjunctTruth> findings(const model::Escena& escena) const;

  /// @{ What the text says otherwise than the contracts, with the predicate: nothing where both agree. The contracts
  /// answered `answer`, and the scene was `before` and is `after`. A difference is a defect of the program.
  std::optional<std::string> difference(const model::Escena& before, const model::Operation& operation,
                                        const model::Answer& answer, const model::Escena& after) const;
  std::optional<std::string> change_difference(const model::Escena& before, const model::AttributeChange& change,
                                               const model::Answer& answer, const model::Escena& after) const;
  std::optional<std::string> change_difference(const model::Vista& before, const model::LookChange& change,
                                               const model::Answer& answer, const model::Vista& after) const;
  /// @}

  /// @{ What the text says otherwise than these judgements of the preconditions, which name all that do not hold: the
  /// predicate; nothing where both agree.
  std::optional<std::string> difference(const model::Escena& before, const model::Operation& operation,
                                        const model::Judgements& judged) const;
  std::optional<std::string> change_difference(const model::Escena& before, const model::AttributeChange& change,
                                               const model::Judgements& judged) const;
  /// @}

  // Points. Precondition: the coordinates lie in one field.
  /// p ∈ puntos_de_rayo(rayo)
  bool in_puntos_de_rayo(const model::ExactPoint& p, const model::Rayo& rayo) const;
  /// p ∈ puntos_de_escena(θEscena)
  bool in_puntos_de_escena(const model::ExactPoint& p, const zed::Value& escena) const;
  /// p ∈ alcance(θEscena, rayo, en, e)
  bool in_alcance(const model::ExactPoint& p, const zed::Value& escena, const model::Rayo& rayo,
                  const std::set<model::Elemento>& en, const model::Elemento& e) const;
  /// de_que_elemento(θEscena, p)
  std::set<model::Elemento> de_que_elemento(const zed::Value& escena, const model::ExactPoint& p) const;
  /// reduccion(ps, ojo) of a finite set of points; nothing outside its domain.
  std::optional<zed::Value> reduccion(std::span<const model::ExactPoint> ps, const model::Punto& ojo) const;

  /// What evaluates the text, for other questions.
  const zed::Evaluator& evaluator() const;

 private:
  struct Schemas;
  struct Transition;
  std::optional<std::string> difference(const Transition& step) const;
  std::unique_ptr<Schemas> schemas_;
};

}  // namespace durero::spec
