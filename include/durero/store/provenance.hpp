#pragma once
/// Who does something, and when, where whoever calls does not say.

#include <string>

#include "durero/store/history_event.hpp"

namespace durero::store {

/// The author that the environment names, by DURERO_AUTHOR, LOGNAME or USER; empty where it names none.
std::string author_of_environment();
/// The time now, as Provenance has it.
std::string time_now();

/// Throws std::invalid_argument where the author or the comment does not stand on one line, or the time is none.
void require_provenance(const Provenance& by);

}  // namespace durero::store
