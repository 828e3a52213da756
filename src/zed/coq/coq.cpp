#include "durero/zed/coq/coq.hpp"

#include "zed/coq/writer.hpp"

namespace durero::zed {
namespace {

constexpr const char* head =
    R"((** The Z text of spec/*.tex, without tablas, malla, auditoria, historia and promocion, in Coq, written by
    `durero spec export --coq` of its sections: change the text, not this file. Nothing is proved here. The rules:

    ℝ, ℤ                  == Coq's R, and those of it that are integers (Toolkit.integers); what the text assumes of
                             them are statements, proved in Tipos.v
    a given set           == a Type, a section variable
    a free type           == an Inductive
    a set, ℙ T            == a predicate on the carrier of T (Toolkit.set); univ where the set is the whole carrier
    x ∈ T, T a whole type == x has a value: exists c : T, c = x
    a partial function    == a set of pairs (Toolkit.rel)
    (_ + _), and − and *  == the set of pairs of Coq's operation (Toolkit.graph)
    S × T                 == univ of whole types, else cartesian S T;  S → T == the set of total functions, S ⟶ T
    f(e) within a predicate P  == exists v, (e, v) ∈ f /\ P: an application outside the domain makes P false. P is the
                             relation that f(e) stands in, a chain counting as one; in a condition, all of its IF
    A = B, sets           == A ≡ B
    IF P THEN E ELSE F    == y is E or F: P /\ y = E \/ ~ P /\ y = F; of sets, with y ∈; within a sum or a product,
                             where P compares two reals: if Rle_dec a b then E else F, for ≤
    a function with ∀ … f(x) = E     == a Definition; arguments are taken from the carriers
    a partial function with dom f = S and ∀ … | … f(x) = E  == the relation "x ∈ S and y is E"
    another name of a box == its declaration and predicates as statements f_decl and the labels', about any such f; and
                             f itself: what solves f * n = m, or Coq's sqrt, or Toolkit.power_of
    { x : S | P }         == fun x => x ∈ S /\ P
    { D | P } of several  == a Definition of the arguments, a Prop;  (x, y) ∈ S  == S x y
    λ D | P • E, E a set  == a Definition of the arguments; outside P the set is empty
    λ D | P • E, otherwise == the same with the set of E alone as value
    S                     == a Record S of carriers and a predicate S_ok with one field a declaration that says more than
                             a type and one a predicate; components are prefixed by S, but for those of the state
    ΔS, ΞS, θS = θS '     == Delta_S, Xi_S, S_eq, for the state S: the schema that boxes include as ΔS, ΞS or S '
    other schemas         == predicates on their components: a Record with one field an inclusion, a declaration that says
                             more than a type, and a predicate; or a Definition where the text combines schemas
    pre S                 == there are an after-state and outputs of S
    ⊢? P                  == P as a statement: the theorem that its label leads to proves it
    θS, θS '; x?, x!      == s, s'; x_in, x_out
    a label A.kind.n      == the field or Definition A_kind_n *)
From Coq Require Import Reals.
From Durero Require Import Toolkit.
Local Open Scope R_scope.
Local Open Scope zed_scope.
Set Implicit Arguments.

Section Especificacion.

)";

}  // namespace

std::string to_coq(const Specification& specification, const Typing& typing) {
  return head + coq::CoqWriter(specification, typing).take() + "End Especificacion.\n";
}

}  // namespace durero::zed
