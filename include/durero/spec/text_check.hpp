#pragma once
/// The check of a Z text: its defects, its sections, and its conjectures as they were tried; `durero spec check` prints
/// it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "durero/spec/label_index.hpp"
#include "durero/zed/trial/trial.hpp"

namespace durero::spec {

/// How a text is checked.
struct TextCheckSetup {
  std::vector<std::string> let{};    ///< values of constants, NAME=VALUE
  std::size_t states = 8;            ///< on so many each conjecture is tried, at most
  bool strict = false;               ///< opinions are errors
  bool own = false;                  ///< the text is the program's own, of which there are samples
  std::vector<std::string> scope{};  ///< members of given sets, SET=MEMBERS, or values of constants
  std::optional<std::pair<std::int64_t, std::int64_t>> numbers{};  ///< those tried are from one to the other
  const zed::SmtProgram* solver = nullptr;  ///< it is asked of conjectures that are not decided otherwise, if any
};

/// A conjecture that was tried. It is true where it was, which proves nothing unless its evaluation decides the whole.
struct TriedConjecture {
  zed::Trial trial;       ///< on which states, and a counterexample
  std::string theorem;    ///< the theorem that proves it; empty where none does
  std::string within{};   ///< the members of given sets within which the trial holds: ` within NAME = {ann, bob}`
  std::string numbers{};  ///< the numbers on which it was tried: `, with numbers from 0 to 9`
  std::string text()
      const;  ///< `FILE:LINE:COLUMN: conjecture LABEL tried on 8 states`, and the states of a counterexample
};

/// The findings about a text.
struct TextCheck {
  std::vector<zed::Defect> defects;            ///< in the order of the text, then the files without a Z paragraph
  const zed::Specification* text = nullptr;    ///< the text, whose sections are right where is_read() is
  std::vector<TriedConjecture> conjectures{};  ///< none where there is an error
  zed::Valuation taken{};                      ///< the values that were taken for constants

  /// Whether there is no error; a file without a paragraph is one.
  bool is_read() const;
  /// Whether a conjecture is false.
  bool is_refuted() const;
  /// How many conjectures are neither decided nor tried on a state.
  std::size_t untried() const;
  /// The lines of `durero spec check`.
  std::string lines() const;
};

/// Checks a text that was read from these files. Precondition: `typing` is zed::check(read), and both outlive the
/// result, and the program's own text has neither scope nor numbers, as its samples are what they are. Throws
/// ConstantError where a constant cannot have its value from the setup, and ScopeError of what its scope gives.
TextCheck check_text(const zed::Specification& read, const zed::Typing& typing, const std::vector<std::string>& files,
                     const TextCheckSetup& setup, const LabelIndex& index);

}  // namespace durero::spec
