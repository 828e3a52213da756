#pragma once
/// The texts that the names of a reproducer's template stand for.

#include <map>
#include <string>
#include <vector>

#include "durero/conform/ask/profile.hpp"
#include "durero/conform/report/tally.hpp"

namespace durero::conform {

using Words = std::map<std::string, std::string>;

/// An element, by the names of a template.
struct ElementWords {
  std::string tipo;  ///< its word in files
  Words words;
};

/// The elements in order; of solids, the discs that close them are left out.
std::vector<ElementWords> element_words(const SuiteCase& of);

/// The names that concern the ray and the whole case.
Words ray_words(const SuiteCase& of);

/// The exact answer as a system with that profile writes it.
std::string expected_answer(const Finding& finding, const Profile& profile);

}  // namespace durero::conform
