#pragma once
/// The sets that names are declared from, by their forms.

#include "translator.hpp"

namespace durero::spec {

/// The properties of the functions that an arrow admits.
struct ArrowProperties {
  bool function = true, total = false, injective = false, surjective = false;
};
/// The properties of an arrow of the toolkit, such as `_⇸_`; nothing where the name is none.
std::optional<ArrowProperties> arrow_properties(const std::string& name);

/// @{ The set of that form.
DomainPtr whole_numbers(InternedValues& values, std::optional<std::int64_t> from);
/// The members of a set that an expression gives; a set that is not listed is asked by `contained`.
DomainPtr set_given(InternedValues& values, IdCode set, std::function<bool(ValueId set, ValueId value)> contained,
                    double size);
/// All values of a type that has these members, or that is not listed.
DomainPtr whole_type(InternedValues& values, std::optional<std::vector<ValueId>> members);
DomainPtr power_set(InternedValues& values, DomainPtr of, bool nonempty);
DomainPtr arrow_set(InternedValues& values, DomainPtr from, DomainPtr to, ArrowProperties properties);
DomainPtr product_set(InternedValues& values, std::vector<DomainPtr> parts);
/// Sequences; nonempty, or without repetitions, or both.
DomainPtr sequence_set(InternedValues& values, DomainPtr of, bool nonempty, bool injective);
/// @}

/// The members of a domain. Throws NotInterned where they cannot be listed.
std::vector<ValueId> listed_members(const ValueDomain& domain, IdFrame frame);

}  // namespace durero::spec
