#pragma once
/// spec/iluminacion.tex: where light goes at a surface. Each function is the definition of the same name, carried out
/// in exact arithmetic; each set of the text is the predicate that its members satisfy.

#include <optional>

#include "durero/model/exact_point.hpp"

namespace durero::model {

/// A vector whose components are named exactly; Z sees one type in points and vectors (E28).
using ExactDirection = ExactPoint;

// Precondition of all that follows: the components lie in one field.

/// (v, n, r) ∈ reflexion: a mirror of normal n shows towards v what lies in the direction r (reflexion.def.1).
bool reflexion(const ExactDirection& v, const ExactDirection& n, const ExactDirection& r);

/// The only r with (v, n, r) ∈ reflexion. Throws std::domain_error where n = 0: there is none.
ExactDirection reflected(const ExactDirection& v, const ExactDirection& n);

/// (i, n) ∈ incidencia: unit vectors, the normal on the side of i (incidencia.def.1).
bool incidencia(const ExactDirection& i, const ExactDirection& n);

/// The square of the cosine on the far side, by the law of Snell; negative where there is none (coseno_cuadrado.def.1).
/// Precondition, as below: razon > 0.
Surd coseno_cuadrado(const ExactDirection& i, const ExactDirection& n, const Rational& razon);

/// (i, n, razon) ∈ reflexion_total (reflexion_total.def.1).
bool reflexion_total(const ExactDirection& i, const ExactDirection& n, const Rational& razon);

/// (i, n, razon, t) ∈ refraccion (refraccion.def.1). No root is taken: t has one part along −i, and what is left is to
/// be along n with the cosine that is asked.
bool refraccion(const ExactDirection& i, const ExactDirection& n, const Rational& razon, const ExactDirection& t);

/// The only t with (i, n, razon, t) ∈ refraccion; nothing in total reflection. Precondition: (i, n) ∈ incidencia.
/// Throws std::domain_error where the square of its cosine is irrational: its root then has no name in our numbers.
std::optional<ExactDirection> refracted(const ExactDirection& i, const ExactDirection& n, const Rational& razon);

}  // namespace durero::model
