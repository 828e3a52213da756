/// Random step tables as proofs/oracle/tables.ml reads them, and what the search answers on each.
///   search_tables COUNT SEED FIRST TABLES ANSWERS [fault]     both files, of the tables FIRST … FIRST + COUNT − 1
/// fault: the answers are those where the ends of one finding change places.
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "trace/drawn_step_table.hpp"

using namespace durero;

int main(int argc, char** argv) {
  if (argc < 6) return std::fputs("search_tables COUNT SEED FIRST TABLES ANSWERS [fault]\n", stderr), 2;
  const auto number = [&](int i) { return std::strtoull(argv[i], nullptr, 10); };
  const std::uint64_t count = number(1), seed = number(2), first = number(3);
  std::ofstream tables(argv[4]), answers(argv[5]);
  for (const double limit : test::limits) {
    std::array<char, 32> word;
    std::snprintf(word.data(), word.size(), "%a ", limit);
    tables << word.data();
  }
  tables << '\n';
  for (std::uint64_t i = first; i < first + count; ++i) {
    test::StepTable table = test::DrawnStepTable(seed, i).table();
    tables << text(table) << '\n';
    if (argc > 6) std::swap(table.findings[0].triage_low, table.findings[0].triage_high);
    answers << answer(table) << '\n';
  }
  return tables.flush() && answers.flush() ? 0 : 1;
}
