#pragma once
/// The parts that the formats of a report share.

#include <span>
#include <string>
#include <string_view>

#include "durero/conform/report/report.hpp"

namespace durero::conform {

/// Every verdict, in the order of the columns.
inline constexpr Verdict verdicts[verdict_count] = {
    Verdict::exact,         Verdict::right,       Verdict::off,          Verdict::phantom,      Verdict::missed,
    Verdict::wrong_element, Verdict::far_root,    Verdict::misplaced,    Verdict::out_of_range, Verdict::doubled,
    Verdict::unsorted,      Verdict::wrong_count, Verdict::wrong_normal, Verdict::wrong_face,   Verdict::wrong_uv,
    Verdict::non_finite,    Verdict::crashed,     Verdict::hung,         Verdict::skipped};

/// The verdicts with a column: exact, right and off always, any other where a ray has it.
std::vector<Verdict> columns_of(const Tally& tally);

/// The names of the elements, with commas between them.
std::string element_names(const scene::ElementSet& elements, const scene::Scene& scene);

/// The words of types in files, with commas between them.
std::string type_words(std::span<const model::Tipo> tipos, std::span<const BodyKind> bodies);

/// A claim of the profile for the reader of a report: `directions: any`.
struct ProfileLine {
  std::string claim, value;
};
std::vector<ProfileLine> profile_lines(const Profile& profile);

/// The verdict in words, such as "far root" for far_root.
std::string verdict_words(Verdict verdict);

/// The question of the finding's ray, as a system would read it.
std::string whole_question_of(const Finding& finding, const Profile& profile);
/// The text of it for a reader: a scene of many elements has those alone that the ray meets, and the number of the
/// others.
std::string question_of(const Finding& finding, const Profile& profile);
std::string shown_question(const SuiteCase& of, const std::optional<scene::ElementRef>& claimed, Caps caps);

/// @{ `missed: expected e0 at t = 4, …; got a miss`
std::string sentence(Verdict verdict, const std::string& expected, const std::string& got);
std::string sentence(const Finding& finding);
/// @}
/// The call that shows the ray and its exact answer.
std::string replay(const Report& report, const Finding& finding);
/// The call that reduces the failure to its smallest case; empty where the system was not asked by this program.
std::string minimising(const Report& report, const Finding& finding);

/// The call that writes the failure up, with a reproducer; empty where the system was not asked by this program.
std::string writing_up(const Report& report, const Finding& finding);

/// The reduced finding in full; empty where it was not reduced.
std::string least_of(const Report& report, const Finding& finding);
/// "3 worst findings were not made small"; empty where none was left out.
std::string left_out_words(const Report& report);

/// "2 families have no scene of these types of elements: apex, rim"; empty where each has some.
std::string unasked_words(const Report& report);

/// The worst findings of a family, gross ones first.
std::vector<const Finding*> findings_of(const FamilyTally& family);

/// @{ The parts of the section on causes.
/// The cause of a failure in a sentence without its end; one that is not known is told by the type of the element.
std::string cause_title(Trait trait, const Finding& finding, const Profile& profile);
/// "3 causes, by what makes 41 failing rays right", and how sure that is.
std::string causes_words(const Report& report);
/// A line on a cause, such as "families: apex, rim".
struct CauseLine {
  std::string label, value;
};
/// The lines on a cause: what makes its rays right, how many they are, where, how likely on ordinary rays, and how far
/// the data must be off at least that explain the worst.
std::vector<CauseLine> cause_lines(const Report& report, const Cause& cause);
/// The severity alone; empty where nobody knows.
std::string severity_words(const Report& report, const Cause& cause);
/// The finding that shows the cause best, and its reduction; null where there is none.
const Finding* shown_finding(const Report& report, const Cause& cause);
const LeastFinding* shown_least(const Report& report, const Cause& cause);
/// @}

/// The text with something before each of its lines.
std::string indented(const std::string& text, std::string_view by);

/// A text as XML and HTML take it, in elements and in attributes; a byte that neither allows is `?`.
std::string as_markup(std::string_view text);

}  // namespace durero::conform
