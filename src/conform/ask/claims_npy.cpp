#include <fmt/format.h>

#include <limits>

#include "conform/ask/claim_rows.hpp"
#include "durero/io/rays/npy.hpp"

namespace durero::conform {

void read_claims_npy(ClaimRows& rows) {
  const io::Source& source = rows.source();
  const std::size_t columns = io::npy_columns(source);
  if (columns != 1 && columns != 4)
    source.fail(0, fmt::format("{} columns", columns), "expected t, or t and the point: (n,) or (n, 4)");
  const std::vector<double> values = io::read_npy(source, columns);
  std::size_t rays = 0;
  for (const SuiteCase& of : rows.cases()) rays += of.the_case.rays.size();
  if (values.size() != rays * columns)
    source.fail(0, fmt::format("{} rows", values.size() / columns), fmt::format("expected {}, one a ray", rays));
  const double* row = values.data();
  for (std::size_t number = 0; number < rows.cases().size(); ++number) {
    for (std::size_t ray = 0; ray < rows.cases()[number].the_case.rays.size(); ++ray, row += columns) {
      Claim& claim = rows.claim_on(0, number, static_cast<double>(ray));
      claim.outcome = Claim::Outcome::miss;
      if (row[0] == std::numeric_limits<double>::infinity()) continue;
      claim = {Claim::Outcome::hit, {}, row[0], {}};
      if (columns == 4) claim.punto = {row[1], row[2], row[3]};
    }
  }
}

}  // namespace durero::conform
