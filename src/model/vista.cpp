#include "durero/model/vista.hpp"

#include <algorithm>
#include <vector>

namespace durero::model {
namespace {

using contract::cost;

template <class T>
std::map<Elemento, T> restricted(const std::set<Elemento>& to, const std::map<Elemento, T>& f) {
  std::map<Elemento, T> left;
  for (const auto& maplet : f)
    if (to.contains(maplet.first)) left.insert(maplet);
  return left;
}

// The changes of looks: each gives its after-state, and which errors deny its preconditions.

/// An error of a change of looks: its clauses, and what it answers.
struct LookError {
  const clause *pre, *post;
  Respuesta answer;
};
constexpr LookError nadie_se_llama{&Nadie_Se_Llama_pre_1, &Nadie_Se_Llama_post_1, Respuesta::elemento_no_existe};
constexpr LookError material_no_existe{&Material_No_Existe_pre_1, &Material_No_Existe_post_1,
                                       Respuesta::material_no_existe};
constexpr LookError grupo_no_existe{&Grupo_No_Existe_pre_1, &Grupo_No_Existe_post_1, Respuesta::grupo_no_existe};

struct LookPrecondition {
  Judgement judged;
  LookError denial;
};

std::vector<LookPrecondition> preconditions_of(const Vista& s, const Cambiar_Material& in) {
  return {{{&Cambiar_Material_pre_1, s.escena.elementos.contains(in.e)}, nadie_se_llama},
          {{&Cambiar_Material_pre_2, s.materiales.contains(in.material)}, material_no_existe}};
}
std::vector<LookPrecondition> preconditions_of(const Vista& s, const Quitar_Material& in) {
  return {{{&Quitar_Material_pre_1, s.escena.elementos.contains(in.e)}, nadie_se_llama}};
}
std::vector<LookPrecondition> preconditions_of(const Vista& s, const Cambiar_Grupo& in) {
  return {{{&Cambiar_Grupo_pre_1, s.escena.elementos.contains(in.e)}, nadie_se_llama},
          {{&Cambiar_Grupo_pre_2, s.grupos.contains(in.g)}, grupo_no_existe}};
}
std::vector<LookPrecondition> preconditions_of(const Vista& s, const Quitar_Grupo& in) {
  return {{{&Quitar_Grupo_pre_1, s.escena.elementos.contains(in.e)}, nadie_se_llama}};
}

std::vector<LookPrecondition> look_preconditions(const Vista& s, const LookChange& change) {
  return std::visit([&](const auto& in) { return preconditions_of(s, in); }, change);
}

void carry_out(Vista& s, const Cambiar_Material& in) { s.mi_material.insert_or_assign(in.e, in.material); }
void carry_out(Vista& s, const Quitar_Material& in) { s.mi_material.erase(in.e); }
void carry_out(Vista& s, const Cambiar_Grupo& in) { s.mi_grupo.insert_or_assign(in.e, in.g); }
void carry_out(Vista& s, const Quitar_Grupo& in) { s.mi_grupo.erase(in.e); }

/// f ⊕ { e ↦ x }
std::map<Elemento, Nombre> overridden(std::map<Elemento, Nombre> f, const Elemento& e, const Nombre& x) {
  f.insert_or_assign(e, x);
  return f;
}
/// { e } ⩤ f
std::map<Elemento, Nombre> without(std::map<Elemento, Nombre> f, const Elemento& e) {
  f.erase(e);
  return f;
}

bool kept_names(const Vista& a, const Vista& b) { return a.grupos == b.grupos; }
bool kept_materials(const Vista& a, const Vista& b) { return a.materiales == b.materiales; }

Judgements effects_of(const Vista& s, const Cambiar_Material& in, const Vista& after, bool answered) {
  return {{&Cambiar_Material_post_1, kept_names(s, after)},
          {&Cambiar_Material_post_2, kept_materials(s, after)},
          {&Cambiar_Material_post_3, after.mi_grupo == s.mi_grupo},
          {&Cambiar_Material_post_4, after.mi_material == overridden(s.mi_material, in.e, in.material)},
          {&Cambiar_Material_post_5, answered}};
}
Judgements effects_of(const Vista& s, const Quitar_Material& in, const Vista& after, bool answered) {
  return {{&Quitar_Material_post_1, kept_names(s, after)},
          {&Quitar_Material_post_2, kept_materials(s, after)},
          {&Quitar_Material_post_3, after.mi_grupo == s.mi_grupo},
          {&Quitar_Material_post_4, after.mi_material == without(s.mi_material, in.e)},
          {&Quitar_Material_post_5, answered}};
}
Judgements effects_of(const Vista& s, const Cambiar_Grupo& in, const Vista& after, bool answered) {
  return {{&Cambiar_Grupo_post_1, kept_names(s, after)},
          {&Cambiar_Grupo_post_2, kept_materials(s, after)},
          {&Cambiar_Grupo_post_3, after.mi_grupo == overridden(s.mi_grupo, in.e, in.g)},
          {&Cambiar_Grupo_post_4, after.mi_material == s.mi_material},
          {&Cambiar_Grupo_post_5, answered}};
}
Judgements effects_of(const Vista& s, const Quitar_Grupo& in, const Vista& after, bool answered) {
  return {{&Quitar_Grupo_post_1, kept_names(s, after)},
          {&Quitar_Grupo_post_2, kept_materials(s, after)},
          {&Quitar_Grupo_post_3, after.mi_grupo == without(s.mi_grupo, in.e)},
          {&Quitar_Grupo_post_4, after.mi_material == s.mi_material},
          {&Quitar_Grupo_post_5, answered}};
}

/// Mismo_Aspecto
Judgements same_looks(const Vista& s, const Vista& after) {
  const auto& left = after.escena.elementos;
  return {{&Mismo_Aspecto_post_1, kept_names(s, after)},
          {&Mismo_Aspecto_post_2, kept_materials(s, after)},
          {&Mismo_Aspecto_post_3, after.mi_grupo == restricted(left, s.mi_grupo)},
          {&Mismo_Aspecto_post_4, after.mi_material == restricted(left, s.mi_material)}};
}

}  // namespace

Judgements inv(const Vista& s) {
  Judgements all = inv(s.escena);
  const auto& names = s.escena.elementos;
  const auto known = [&](const std::map<Elemento, Nombre>& f) {
    return std::ranges::all_of(f, [&](const auto& maplet) { return names.contains(maplet.first); });
  };
  const auto into = [](const std::map<Elemento, Nombre>& f, const std::set<Nombre>& set) {
    return std::ranges::all_of(f, [&](const auto& maplet) { return set.contains(maplet.second); });
  };
  all.push_back({&Vista_inv_1, known(s.mi_grupo)});
  all.push_back({&Vista_inv_2, into(s.mi_grupo, s.grupos)});
  all.push_back({&Vista_inv_3, known(s.mi_material)});
  all.push_back({&Vista_inv_4, into(s.mi_material, s.materiales)});
  return all;
}

const Elemento& name_of(const LookChange& change) {
  return std::visit([](const auto& in) -> const Elemento& { return in.e; }, change);
}

Judgements pre(const Vista& before, const LookChange& change) {
  Judgements all;
  for (const LookPrecondition& each : look_preconditions(before, change)) all.push_back(each.judged);
  return all;
}

Judgements post(const Vista& before, const LookChange& change, const Vista& after, Respuesta r) {
  return std::visit([&](const auto& in) { return effects_of(before, in, after, r == Respuesta::elemento_cambiado); },
                    change);
}

Respuesta apply(Vista& s, const LookChange& change) {
  if (contract::evaluated(cost::normal)) check(pre(s, change), cost::normal);
  Vista after = s;
  std::visit([&](const auto& in) { carry_out(after, in); }, change);
  const Respuesta r = Respuesta::elemento_cambiado;
  if (contract::evaluated(cost::normal)) {
    check(post(s, change, after, r), cost::normal);
    check(inv(after), cost::normal);
  }
  s = std::move(after);
  return r;
}

Answer apply_total(Vista& s, const LookChange& change) {
  for (const auto& [judged, denial] : look_preconditions(s, change)) {
    if (judged.holds) continue;
    if (contract::evaluated(cost::normal)) check({{denial.pre, !judged.holds}, {denial.post, true}}, cost::normal);
    return {denial.answer, judged.what};
  }
  return {apply(s, change)};
}

Answer apply_total(Vista& s, const ElementOperation& operation) {
  Vista after = s;
  const Answer answer = apply_either(after.escena, operation);
  after.mi_grupo = restricted(after.escena.elementos, s.mi_grupo);
  after.mi_material = restricted(after.escena.elementos, s.mi_material);
  if (contract::evaluated(cost::normal)) {
    check(same_looks(s, after), cost::normal);
    check(inv(after), cost::normal);
  }
  s = std::move(after);
  return answer;
}

}  // namespace durero::model
