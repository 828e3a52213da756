#include "durero/model/operaciones_errors.hpp"

namespace durero::model {

Judgements pre(const Escena& s, const Elemento_Ya_Existe& in) {
  return {{&Elemento_Ya_Existe_pre_1, s.elementos.contains(in.e)}};
}

Judgements post(const Elemento_Ya_Existe&, Respuesta r) {
  return {{&Elemento_Ya_Existe_post_1, r == Respuesta::elemento_ya_existe}};
}

Judgements pre(const Escena& s, const Elemento_No_Existe& in) {
  return {{&Elemento_No_Existe_pre_1, !s.elementos.contains(in.e)}};
}

Judgements post(const Elemento_No_Existe&, Respuesta r) {
  return {{&Elemento_No_Existe_post_1, r == Respuesta::elemento_no_existe}};
}

Judgements pre(const Escena&, const Radio_No_Positivo& in) {
  return {{&Radio_No_Positivo_pre_1, !Rmas::contains(in.radio)}};
}

Judgements post(const Radio_No_Positivo&, Respuesta r) {
  return {{&Radio_No_Positivo_post_1, r == Respuesta::radio_no_positivo}};
}

Judgements pre(const Escena&, const Vector_No_Unitario& in) {
  return {{&Vector_No_Unitario_pre_1, !Unitario::contains(in.vector)}};
}

Judgements post(const Vector_No_Unitario&, Respuesta r) {
  return {{&Vector_No_Unitario_post_1, r == Respuesta::vector_no_unitario}};
}

Judgements pre(const Escena&, const Altura_No_Positiva& in) {
  return {{&Altura_No_Positiva_pre_1, !Rmas::contains(in.altura)}};
}

Judgements post(const Altura_No_Positiva&, Respuesta r) {
  return {{&Altura_No_Positiva_post_1, r == Respuesta::altura_no_positiva}};
}

Judgements pre(const Escena&, const Proporcion_No_Positiva& in) {
  return {{&Proporcion_No_Positiva_pre_1, !Rmas::contains(in.proporcion)}};
}

Judgements post(const Proporcion_No_Positiva&, Respuesta r) {
  return {{&Proporcion_No_Positiva_post_1, r == Respuesta::proporcion_no_positiva}};
}

Judgements pre(const Escena& s, const No_Es_Esfera& in) {
  return {{&No_Es_Esfera_pre_1, s.elementos.contains(in.e)},
          {&No_Es_Esfera_pre_2, !is_of_type(s, in.e, Tipo::soy_esfera)}};
}

Judgements post(const No_Es_Esfera&, Respuesta r) { return {{&No_Es_Esfera_post_1, r == Respuesta::tipo_incorrecto}}; }

Judgements pre(const Escena& s, const No_Es_Cilindro& in) {
  return {{&No_Es_Cilindro_pre_1, s.elementos.contains(in.e)},
          {&No_Es_Cilindro_pre_2, !is_of_type(s, in.e, Tipo::soy_cilindro)}};
}

Judgements post(const No_Es_Cilindro&, Respuesta r) {
  return {{&No_Es_Cilindro_post_1, r == Respuesta::tipo_incorrecto}};
}

Judgements pre(const Escena& s, const No_Es_Cono& in) {
  return {{&No_Es_Cono_pre_1, s.elementos.contains(in.e)}, {&No_Es_Cono_pre_2, !is_of_type(s, in.e, Tipo::soy_cono)}};
}

Judgements post(const No_Es_Cono&, Respuesta r) { return {{&No_Es_Cono_post_1, r == Respuesta::tipo_incorrecto}}; }

Judgements pre(const Es_Esfera& in) { return {{&Es_Esfera_pre_1, in.t == Tipo::soy_esfera}}; }

Judgements pre(const Es_Cono& in) { return {{&Es_Cono_pre_1, in.t == Tipo::soy_cono}}; }

Respuesta apply(const Escena& escena, const Error& error) {
  return std::visit(
      [&](const auto& in) {
        if (contract::evaluated(contract::cost::normal)) {
          check(pre(escena, in), contract::cost::normal);
          check(post(in, in.answer), contract::cost::normal);
        }
        return in.answer;
      },
      error);
}

std::vector<Refusal> refusals(const Agregar_Esfera& in) {
  return {{Elemento_Ya_Existe{in.e}, &Agregar_Elemento_pre_1}, {Radio_No_Positivo{in.radio}, &Agregar_Esfera_pre_2}};
}

std::vector<Refusal> refusals(const Agregar_Cilindro& in) {
  return {{Elemento_Ya_Existe{in.e}, &Agregar_Elemento_pre_1},
          {Radio_No_Positivo{in.radio}, &Agregar_Cilindro_pre_2},
          {Vector_No_Unitario{in.vector}, &Agregar_Cilindro_pre_3},
          {Altura_No_Positiva{in.altura}, &Agregar_Cilindro_pre_4}};
}

std::vector<Refusal> refusals(const Agregar_Cono& in) {
  return {{Elemento_Ya_Existe{in.e}, &Agregar_Elemento_pre_1},
          {Proporcion_No_Positiva{in.proporcion}, &Agregar_Cono_pre_2},
          {Vector_No_Unitario{in.vector}, &Agregar_Cono_pre_3},
          {Altura_No_Positiva{in.altura}, &Agregar_Cono_pre_4}};
}

std::vector<Refusal> refusals(const Eliminar_Esfera& in) {
  return {{Elemento_No_Existe{in.e}, &Eliminar_Elemento_pre_1}, {No_Es_Esfera{in.e}, &Eliminar_Esfera_pre_1}};
}

std::vector<Refusal> refusals(const Eliminar_Cilindro& in) {
  return {{Elemento_No_Existe{in.e}, &Eliminar_Elemento_pre_1}, {No_Es_Cilindro{in.e}, &Eliminar_Cilindro_pre_1}};
}

std::vector<Refusal> refusals(const Eliminar_Cono& in) {
  return {{Elemento_No_Existe{in.e}, &Eliminar_Elemento_pre_1}, {No_Es_Cono{in.e}, &Eliminar_Cono_pre_1}};
}

std::vector<Refusal> refusals(const Agregar_Elemento& in) {
  if (all_hold(pre(Es_Esfera{in.t})))
    return {{Elemento_Ya_Existe{in.e}, &Agregar_Elemento_pre_1},
            {Radio_No_Positivo{in.radio.value()}, &Agregar_Esfera_pre_2}};
  if (all_hold(pre(Es_Cono{in.t})))
    return {{Elemento_Ya_Existe{in.e}, &Agregar_Elemento_pre_1},
            {Proporcion_No_Positiva{in.proporcion.value()}, &Agregar_Cono_pre_2},
            {Vector_No_Unitario{in.vector.value()}, &Agregar_Cono_pre_3},
            {Altura_No_Positiva{in.altura.value()}, &Agregar_Cono_pre_4}};
  return {{Elemento_Ya_Existe{in.e}, &Agregar_Elemento_pre_1},
          {Radio_No_Positivo{in.radio.value()}, &Agregar_Cilindro_pre_2},
          {Vector_No_Unitario{in.vector.value()}, &Agregar_Cilindro_pre_3},
          {Altura_No_Positiva{in.altura.value()}, &Agregar_Cilindro_pre_4}};
}

std::vector<Refusal> refusals(const Eliminar_Elemento& in) {
  return {{Elemento_No_Existe{in.e}, &Eliminar_Elemento_pre_1}};
}

}  // namespace durero::model
