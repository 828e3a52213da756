#include "conform/report/json_parts.hpp"

#include <array>
#include <cmath>

#include "conform/report/report_parts.hpp"
#include "durero/conform/ask/question.hpp"
#include "durero/conform/report/explanation.hpp"
#include "durero/conform/report/least_findings.hpp"

namespace durero::conform {
namespace {

void write_data(Writer& out, const Profile& profile, const ExplainingData& data) {
  out.key("data").begin_object().member("epsilon", data.epsilon).member("M", data.M);
  if (data.excluded) out.member("excluded", std::ldexp(1, *data.excluded));
  out.member("most", std::ldexp(1, data.most));
  if (data.nearest) {
    constexpr std::array<std::size_t, 1> only{0};
    out.member("off", data.nearest->off);
    out.member("question", question_text(data.nearest->of, profile.caps, only));
  }
  out.end_object();
}

}  // namespace

void write_profile(Writer& out, const Profile& profile) {
  out.key("profile").begin_object();
  for (const ProfileLine& line : profile_lines(profile)) out.member(line.claim, line.value);
  out.end_object().new_line().key("sources").begin_array();
  for (const Citation& source : profile.sources) {
    out.new_line().begin_object().member("claim", source.claim).member("sentence", source.sentence);
    out.member("place", source.place).end_object();
  }
  out.end_array();
}

void write_least(Writer& out, const Profile& profile, const LeastFinding& least) {
  const Finding& finding = least.finding;
  const std::string question = whole_question_of(finding, profile);
  out.new_line().key("least").begin_object().member("question", question);
  out.member("hexadecimal", in_hexadecimal(question)).member("exact", exact_answer(finding.of, 0));
  out.member("expected", truth_words(finding)).member("got", claim_words(finding));
  out.member("ulps", finding.judgement.ulps).member("backward", finding.judgement.backward);
  if (least.data) write_data(out, profile, *least.data);
  out.end_object();
}

}  // namespace durero::conform
