#pragma once
/// What the definitions of proofs/Formas.v are written of: rays and elements by their names, and parts of what is
/// built.

#include <string>
#include <string_view>
#include <vector>

#include "durero/scene/attributes.hpp"
#include "durero/scene/shapes.hpp"
#include "proofs/recorder.hpp"

namespace durero::trace::HWY_NAMESPACE {

/// A part of what is defined, by a form without operands.
inline Node built(const std::string& constructor, const std::vector<Node>& parts) {
  Form form{constructor, Tightness::application};
  for (std::size_t i = 0; i < parts.size(); ++i) form.text += " %" + std::to_string(i);
  return record(form, parts);
}
template <class T>
Node known(const T& value, Term error) {
  return built("Known", {value.node, error.node});
}
/// A pair as a part.
template <class T>
Node node_of(const Twofold<T>& x) {
  return record_pair(x.hi.node, x.lo.node);
}
inline Built built_pair(const Twofold<Term>& x) { return Built{"Twofold", {x.hi.node, x.lo.node}}; }

// Names of what the definitions are of.

inline Term real(const std::string& name) { return Term(name); }
template <class T>
T variable(const std::string& name) {
  return T(called(name), {});
}
/// A double-double by its name.
inline Twofold<Term> pair_of(const std::string& name) { return {real("hi " + name), real("lo " + name)}; }
template <class L = Term>
Vec<L> vector(const std::string& name) {
  return {L(real("cx " + name)), L(real("cy " + name)), L(real("cz " + name))};
}
template <model::Tipo tipo, class L = Term>
LaneElement<tipo, L> element() {
  return {vector<L>("centro"), L(real("radio")),  L(real("proporcion")),
          vector<L>("vector"), L(real("altura")), {vector<L>("a"), vector<L>("b"), vector<L>("c")}};
}
template <class L = Term>
RayIn<L> ray() {
  return {vector<L>("p"), vector<L>("v"), L(real("speed"))};
}

/// What a shape is stored as, as the variables of a definition.
inline std::string variables(std::string_view word, double) { return " (" + std::string(word) + " : R)"; }
inline std::string variables(std::string_view word, const glm::dvec3&) { return " (" + std::string(word) + " : vec)"; }
inline std::string variables(std::string_view, const scene::Corners&) { return " (a b c : vec)"; }

template <class Shape>
std::string attributes() {
  std::string given;
  scene::for_each_attribute<Shape>(
      [&](const auto& attribute) { given += variables(attribute.word, Shape().*attribute.field); });
  return given;
}

/// What range.hpp computes.
void write_range();
/// The module Powers, of power-inl.hpp.
void write_powers();

}  // namespace durero::trace::HWY_NAMESPACE
