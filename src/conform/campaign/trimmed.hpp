#pragma once
/// The counts of a shard in one form: no list ends in entries that count nothing. Counts that are equal are then equal
/// values.

#include "durero/conform/campaign/shard.hpp"

namespace durero::conform {

template <class Value>
void trim(std::vector<Value>& list) {
  while (!list.empty() && list.back() == Value{}) list.pop_back();
}

inline FamilyCounts trimmed(FamilyCounts counts) {
  trim(counts.verdicts);
  trim(counts.clauses);
  return counts;
}

inline ShardCounts trimmed(ShardCounts counts) {
  trim(counts.ulps);
  trim(counts.families);
  return counts;
}

}  // namespace durero::conform
