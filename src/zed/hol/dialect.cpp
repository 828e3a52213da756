#include "zed/hol/dialect.hpp"

#include <fmt/format.h>

#include "zed/hol/toolkit.hpp"

namespace durero::zed::hol {
namespace {

/// The text of one language or of the other, with these parts.
template <class... Parts>
std::string two(ProofAssistant prover, const char* coq, const char* isabelle, const Parts&... parts) {
  return fmt::format(fmt::runtime(prover == ProofAssistant::coq ? coq : isabelle), parts...);
}

}  // namespace

std::string HolDialect::bound(const char* coq, const char* isabelle, const Binders& variables,
                              const std::string& body) const {
  if (variables.empty()) return body;
  const bool is_coq = prover == ProofAssistant::coq;
  std::string names;
  for (const auto& [name, type] : variables)
    names += type.empty() ? " " + name : two(prover, " ({} : {})", " ({} :: {})", name, type);
  return is_coq ? fmt::format("({}{}, {})", coq, names, body)
                : fmt::format("({}{}. {})", isabelle, names.substr(1), body);
}

std::string HolDialect::all(const Binders& variables, const std::string& body) const {
  return bound("forall", "\\<forall>", variables, body);
}
std::string HolDialect::some(const Binders& variables, const std::string& body) const {
  return bound("exists", "\\<exists>", variables, body);
}
std::string HolDialect::function(const std::string& variable, const std::string& body) const {
  return two(prover, "(fun {} => {})", "(\\<lambda>{}. {})", variable, body);
}

std::string HolDialect::all_of(const std::vector<std::string>& parts) const {
  if (parts.empty()) return truth();
  std::string said = parts[0];
  for (std::size_t i = 1; i < parts.size(); ++i)
    said += (prover == ProofAssistant::coq ? " /\\ " : " \\<and> ") + parts[i];
  return parts.size() == 1 ? said : "(" + said + ")";
}
std::string HolDialect::any_of(const std::string& a, const std::string& b) const {
  return two(prover, "({} \\/ {})", "({} \\<or> {})", a, b);
}
std::string HolDialect::implied(const std::string& a, const std::string& b) const {
  return two(prover, "({} -> {})", "({} \\<longrightarrow> {})", a, b);
}
std::string HolDialect::equivalent(const std::string& a, const std::string& b) const {
  return two(prover, "({} <-> {})", "({} \\<longleftrightarrow> {})", a, b);
}
std::string HolDialect::denied(const std::string& a) const { return two(prover, "(~ {})", "(\\<not> {})", a); }

std::string HolDialect::set_of(const std::string& type) const { return two(prover, "(set {0})", "({0} set)", type); }
std::string HolDialect::pair_of(const std::vector<std::string>& types) const {
  std::string said = types[0];
  for (std::size_t i = 1; i < types.size(); ++i)
    said += (prover == ProofAssistant::coq ? " * " : " \\<times> ") + types[i];
  return "(" + said + ")";
}
std::string HolDialect::whole(const std::string& type) const {
  return two(prover, "(z_all {})", "(UNIV :: {} set)", type);
}

std::string HolDialect::definition(const std::string& name, const Binders& arguments, const std::string& type,
                                   const std::string& body) const {
  std::string names, types;
  for (const auto& [argument, of] : arguments) {
    names += prover == ProofAssistant::coq ? fmt::format(" ({} : {})", argument, of) : " " + argument;
    types += of + " \\<Rightarrow> ";
  }
  if (prover == ProofAssistant::coq) return fmt::format("Definition {}{} : {} :=\n  {}.\n", name, names, type, body);
  return fmt::format("definition {} :: \"{}{}\" where\n  \"{}{} = {}\"\n", name, types, type, name, names, body);
}

std::string HolDialect::given(const std::string& name) const {
  return two(prover, "Variable {} : Type.\n", "typedecl {}\n", name);
}

std::string HolDialect::free_type(const std::string& name, const Binders& branches) const {
  std::string said;
  for (const auto& [branch, type] : branches) {
    said += said.empty() ? (prover == ProofAssistant::coq ? " | " : " ") : " | ";
    said += branch;
    if (type.empty()) continue;
    said += prover == ProofAssistant::coq ? fmt::format(" (argument : {})", type) : fmt::format(" \"{}\"", type);
  }
  return prover == ProofAssistant::coq ? fmt::format("Inductive {} : Type :={}.\n", name, said)
                                       : fmt::format("datatype {} ={}\n", name, said);
}

std::string HolDialect::constant(const std::string& name, const std::string& type) const {
  return two(prover, "Variable {} : {}.\n", "consts {} :: \"{}\"\n", name, type);
}
std::string HolDialect::axiom(const std::string& name, const std::string& body) const {
  return two(prover, "Hypothesis {} : {}.\n", "axiomatization where {}: \"{}\"\n", name, body);
}
std::string HolDialect::comment(const std::string& text) const { return "(* " + text + " *)\n"; }

std::string HolDialect::head(const std::string& theory) const {
  if (prover == ProofAssistant::coq) return std::string(coq_toolkit) + "\nSection Text.\n\n";
  return fmt::format("theory {}\n  imports Main\nbegin\n\n{}\n", theory, isabelle_toolkit);
}
std::string HolDialect::tail() const { return prover == ProofAssistant::coq ? "\nEnd Text.\n" : "\nend\n"; }

}  // namespace durero::zed::hol
