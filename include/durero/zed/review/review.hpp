#pragma once
/// A review checks a Z text beyond its types. Each check states exactly what it looks for, and none of them proves a
/// theorem: its findings are Z all the same, and so warnings or opinions. On a text with errors of reading or of types
/// each check judges the parts that it can.

#include <vector>

#include "durero/zed/syntax/defect.hpp"
#include "durero/zed/syntax/reader.hpp"
#include "durero/zed/types/typecheck.hpp"

namespace durero::zed {

/// Gives the warnings of E15. They name a given set, a free type or a constant of one that no paragraph of the
/// specification mentions, and a variable of a quantifier, a comprehension, a λ, a μ or a let that neither its
/// predicates nor its value mentions (the characteristic tuple, where it is the value, mentions all). Schemas,
/// definitions and axiomatic names are what a text is for, and components belong to whoever uses the schema: they are
/// not looked at.
std::vector<Defect> unused_names(const Specification& specification, const Typing& typing);

/// Gives the opinions of E06: a loose operation is Z, and refinement is to remove what is loose. A schema is judged
/// where it is a `schema` box, or a definition by one schema text, that includes ΔS, by itself or through what it
/// includes, and that no declaration of the specification includes. It must determine each component x' of S: by Ξ, or
/// by an equation `x' = e` (either way round) among its conjuncts and those of what it includes, the invariant of S'
/// too, where e mentions no component of S' that is not determined itself. Equal tuples and bindings (θS' too) have
/// equal parts, `x' + e` and `x' - e` determine x' as x' does, and a schema as a predicate says what its text says. A
/// disjunction determines what each of its sides does. p ⇒ P with ¬ p ⇒ Q determines what P and Q both do, and a
/// relation and its opposite, such as = and ≠, are cases too. An ∃ or a let determines what its body does without a
/// variable that is open. So tipos' is determined by `tipos' = ran de_que_tipo'`. A schema that others include may
/// leave open what they state, and a combination by the schema calculus is as good as its parts. Where a schema
/// includes anything but schema texts, references, conjunctions and decorations, it is not judged.
std::vector<Defect> open_frames(const Specification& specification, const Typing& typing);

/// Gives the opinions of E07: whether a function is applied in its domain is no question of types. An application f x,
/// where f is declared by one of the arrows ⇸ ⤔ ⤀ ⇻ ⤕, needs x ∈ dom f from what holds where it stands: the invariants
/// of the schemas in scope, the axioms, the ranges of variables (x : S), the other predicates of the same text, the
/// other sides of ∧ and ∨ (which are denied there), the left side of ⇒, and the conditions of if (which are denied in
/// else). Two forms are found, and nothing else: x ∈ S is found where S is dom f, or is tied to it by equations and ⊆
/// between sets; x ∈ dom g is found with `g x = c`, where dom f is tied to `g ∼ ⦇ {…, c, …} ⦈`, or with `g x` denied to
/// be any other constant of its free type. A member of a displayed set, of either side of ∪ and of both sides of ∩
/// counts; so do a first part of a displayed function's pairs, of either side of f ∪ g and of f ⊕ g, `x ↦ y ∈ f`, and
/// an element that is stated to be x.
std::vector<Defect> partial_applications(const Specification& specification, const Typing& typing);

/// Gives the opinions of E04: ΔS or ΞS, declared nowhere, where S has a component with strokes, as an operation has.
std::vector<Defect> doubled_operations(const Specification& specification, const Typing& typing);

/// Gives a warning for each let before a predicate: older Z has it, ISO Z has let before expressions only.
std::vector<Defect> predicates_of_let(const Specification& specification, const Typing& typing);

/// Gives a warning where a section names a parent twice.
std::vector<Defect> repeated_parents(const Specification& specification, const Typing& typing);

/// Gives an error for each of these files in which no section was read: it was meant to hold Z.
std::vector<Defect> without_paragraphs(const std::vector<std::string>& files, const Specification& specification);

/// Gives the defects of reading, of types and of the checks above, but those of partial_applications() only where
/// there are no errors. Precondition: `typing` is check(specification).
std::vector<Defect> review(const Specification& specification, const Typing& typing);
/// Checks the types first.
std::vector<Defect> review(const Specification& specification);

}  // namespace durero::zed
