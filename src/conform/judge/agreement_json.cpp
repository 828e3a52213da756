#include "durero/conform/format_versions.hpp"
#include "durero/conform/judge/agreement.hpp"
#include "durero/io/json/json_writer.hpp"
#include "durero/io/json/scene_file.hpp"
#include "durero/io/rays/hits_file.hpp"
#include "durero/text/shown.hpp"

namespace durero::conform {
namespace {

using io::json::Writer;

/// The predicate that the samples assert of every right hit, and that a hit with this verdict breaks.
std::string_view predicate(oracle::sampled::SampledVerdict verdict) {
  return verdict == oracle::sampled::SampledVerdict::incomplete
             ? "where the ray meets an element, a sample of it is near"
             : "no sample lies on the ray before the hit";
}

void write_elements(Writer& out, const AgreementCall& call, const scene::Hit& claimed) {
  out.key("elementos").begin_array();
  for (const scene::ElementRef element : claimed.elementos) {
    const std::string name = call.scene.name(element).name();
    const auto [pointer, place] = io::element_place(call.file, name);
    out.begin_object().member("id", name).member("pointer", pointer);
    out.member("line", std::uint64_t{place.line}).member("column", std::uint64_t{place.column}).end_object();
  }
  out.end_array();
}

void write_finding(Writer& out, const AgreementCall& call, const Agreement::Disagreement& found) {
  const model::Rayo& ray = found.query.rayo;
  out.new_line().begin_object().member("label", name(found.verdict)).member("predicate", predicate(found.verdict));
  out.member("ray", found.ray).member("p", ray.p().xyz()).member("v", ray.v().xyz());
  out.key("claimed").begin_object();
  io::write_hit(out, found.claimed, call.scene);
  out.end_object();
  write_elements(out, call, found.claimed);
  out.end_object();
}

}  // namespace

std::string agreement_json(const Agreement& agreement, const AgreementCall& call) {
  std::string text;
  Writer out(text);
  write_version(out.begin_object(), agreement_format);
  out.member("file", text::escaped(call.file.name())).member("engine", call.engine).member("seed", call.seed);
  out.member("rays", agreement.rays()).member("ok", !agreement.first).new_line().key("verdicts").begin_object();
  for (std::size_t i = 0; i < oracle::sampled::verdict_count; ++i)
    out.member(name(static_cast<oracle::sampled::SampledVerdict>(i)), agreement.counts[i]);
  out.end_object().new_line().key("findings").begin_array();
  if (agreement.first) write_finding(out, call, *agreement.first);
  out.end_array().end_object();
  return text + "\n";
}

}  // namespace durero::conform
