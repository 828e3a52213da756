#pragma once
/// What can go wrong (spec/operaciones.tex): one schema for each error, with its answer. The scene stays as it is, so
/// each takes it as a constant.

#include <variant>

#include "durero/model/operaciones_predicates.hpp"

namespace durero::model {

struct Elemento_Ya_Existe {
  Elemento e;
  static constexpr Respuesta answer = Respuesta::elemento_ya_existe;
};

struct Elemento_No_Existe {
  Elemento e;
  static constexpr Respuesta answer = Respuesta::elemento_no_existe;
};

struct Radio_No_Positivo {
  double radio;
  static constexpr Respuesta answer = Respuesta::radio_no_positivo;
};

struct Vector_No_Unitario {
  Vector vector;
  static constexpr Respuesta answer = Respuesta::vector_no_unitario;
};

struct Altura_No_Positiva {
  double altura;
  static constexpr Respuesta answer = Respuesta::altura_no_positiva;
};

struct Proporcion_No_Positiva {
  double proporcion;
  static constexpr Respuesta answer = Respuesta::proporcion_no_positiva;
};

struct No_Es_Esfera {
  Elemento e;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
};

struct No_Es_Cilindro {
  Elemento e;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
};

struct No_Es_Cono {
  Elemento e;
  static constexpr Respuesta answer = Respuesta::tipo_incorrecto;
};

using Error = std::variant<Elemento_Ya_Existe, Elemento_No_Existe, Radio_No_Positivo, Vector_No_Unitario,
                           Altura_No_Positiva, Proporcion_No_Positiva, No_Es_Esfera, No_Es_Cilindro, No_Es_Cono>;

Judgements pre(const Escena& before, const Elemento_Ya_Existe& in);
Judgements pre(const Escena& before, const Elemento_No_Existe& in);
Judgements pre(const Escena& before, const Radio_No_Positivo& in);
Judgements pre(const Escena& before, const Vector_No_Unitario& in);
Judgements pre(const Escena& before, const Altura_No_Positiva& in);
Judgements pre(const Escena& before, const Proporcion_No_Positiva& in);
Judgements pre(const Escena& before, const No_Es_Esfera& in);
Judgements pre(const Escena& before, const No_Es_Cilindro& in);
Judgements pre(const Escena& before, const No_Es_Cono& in);

Judgements post(const Elemento_Ya_Existe& in, Respuesta r);
Judgements post(const Elemento_No_Existe& in, Respuesta r);
Judgements post(const Radio_No_Positivo& in, Respuesta r);
Judgements post(const Vector_No_Unitario& in, Respuesta r);
Judgements post(const Altura_No_Positiva& in, Respuesta r);
Judgements post(const Proporcion_No_Positiva& in, Respuesta r);
Judgements post(const No_Es_Esfera& in, Respuesta r);
Judgements post(const No_Es_Cilindro& in, Respuesta r);
Judgements post(const No_Es_Cono& in, Respuesta r);

// The types at which the general addition looks.

struct Es_Esfera {
  Tipo t;
};

struct Es_Cono {
  Tipo t;
};

Judgements pre(const Es_Esfera& in);
Judgements pre(const Es_Cono& in);

/// The error, as an operation that changes nothing: checks its clauses and answers.
Respuesta apply(const Escena& escena, const Error& error);

/// An error of a total operation, and the precondition of the partial one that it denies.
struct Refusal {
  Error error;
  const clause* violated;
};

/// The errors of the total operation, in the order of the text.
std::vector<Refusal> refusals(const Agregar_Esfera& in);
std::vector<Refusal> refusals(const Agregar_Cilindro& in);
std::vector<Refusal> refusals(const Agregar_Cono& in);
std::vector<Refusal> refusals(const Agregar_Elemento& in);
std::vector<Refusal> refusals(const Eliminar_Esfera& in);
std::vector<Refusal> refusals(const Eliminar_Cilindro& in);
std::vector<Refusal> refusals(const Eliminar_Cono& in);
std::vector<Refusal> refusals(const Eliminar_Elemento& in);

}  // namespace durero::model
