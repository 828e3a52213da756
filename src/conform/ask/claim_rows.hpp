#pragma once
/// The claims that a reader has stored so far, row by row: each is on a case and a ray of the suite that had none yet.

#include <map>
#include <string_view>

#include "durero/conform/ask/claims_file.hpp"

namespace durero::conform {

class ClaimRows {
 public:
  ClaimRows(const io::Source& source, std::span<const SuiteCase> cases);

  /// The case of that name, whose text stands at the offset. Throws InputError.
  std::size_t case_of(std::size_t offset, std::string_view name) const;
  /// The element of that name. Throws InputError.
  scene::ElementRef element_of(std::size_t offset, std::size_t in_case, std::string_view name) const;
  /// The place of the claim on that ray, which has none yet. Throws InputError.
  Claim& claim_on(std::size_t offset, std::size_t in_case, double ray);

  std::span<const SuiteCase> cases() const { return cases_; }
  /// Whether each claim names its case: of a user's own rays there is one alone.
  bool names_cases() const { return cases_.size() != 1 || cases_[0].family != &own_family; }
  const io::Source& source() const { return *source_; }
  std::vector<Claims> take() && { return std::move(claims_); }

 private:
  const io::Source* source_;
  std::span<const SuiteCase> cases_;
  std::map<std::string, std::size_t, std::less<>> by_name_;
  std::vector<Claims> claims_;
};

/// The outcome of that name. Throws InputError where there is none.
Claim::Outcome read_outcome(const io::Source& source, std::size_t offset, std::string_view text);
/// Checks that a hit has t or a point, and that no other outcome has one. Throws InputError.
void check_claim(const io::Source& source, std::size_t offset, const Claim& claim);

void read_claims_json(ClaimRows& rows);
void read_claims_csv(ClaimRows& rows);
void read_claims_npy(ClaimRows& rows);

}  // namespace durero::conform
