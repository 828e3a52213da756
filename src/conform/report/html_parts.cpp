#include "conform/report/html_parts.hpp"

#include <fmt/format.h>

#include "conform/report/picture.hpp"
#include "conform/report/report_parts.hpp"

namespace durero::conform {

std::string_view colour(Verdict verdict) {
  if (is_gross(verdict)) return "#c62828";
  if (verdict == Verdict::off) return "#ef6c00";
  return verdict == Verdict::skipped ? "#9e9e9e" : "#2e7d32";
}

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
body { max-width: 70rem; margin: 2rem auto; padding: 0 1rem; overflow-wrap: anywhere; }
.wide { overflow-x: auto; } .wide th, .wide td { overflow-wrap: normal; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .15rem .6rem; text-align: right; border-bottom: 1px solid #8884; }
th:first-child, td:first-child { text-align: left; }
td.bad { color: #c62828; font-weight: 600; } td.off { color: #ef6c00; } td.zero { color: #8888; }
pre { background: #8881; padding: .6rem; overflow-x: auto; font-size: 13px; }
figure { display: inline-block; margin: 0 1rem 1rem 0; vertical-align: top; width: 30rem; max-width: 100%; }
figcaption { font-size: 13px; opacity: .75; }
svg { width: 100%; background: #8881; } svg text { font-size: 11px; fill: currentColor; }
.grid { stroke: #8884; } .element { fill: none; stroke: currentColor; stroke-opacity: .3; stroke-width: .7; }
.ray { stroke-width: 1; }
.cause { border-left: .25rem solid #c62828; padding-left: 1rem; margin: 2rem 0; } .cause h3 { margin: 0; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; margin: .5rem 0; } dd { margin: 0; }
@media (max-width: 40rem) { dl { display: block; } dt { font-weight: 600; } h1 { font-size: 1.4rem; } }
summary { font-weight: 600; cursor: pointer; margin: .3rem 0; } .less { font-size: 13px; opacity: .8; }
)";

}  // namespace

std::string page_head(std::string_view title, std::string_view subject) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>{0}: {1}</title>\n<meta "
      "name=\"viewport\" content=\"width=device-width\"><style>{2}</style></head>\n<body>\n<h1>{0}</h1>\n",
      as_markup(title), subject, style);
}

std::string figure(const std::string& svg, const std::string& caption) {
  return fmt::format("<figure>\n{}<figcaption>{}</figcaption></figure>\n", svg, as_markup(caption));
}

std::string profile_html(const Profile& profile) {
  std::string html = "<h2>The profile that was judged by</h2>\n<div class=\"wide\"><table>\n";
  for (const ProfileLine& line : profile_lines(profile)) {
    std::string why;
    for (const Citation& source : profile.sources) {
      if (source.claim != line.claim) continue;
      why += fmt::format("<q>{}</q> ({}) ", as_markup(source.sentence), as_markup(source.place));
    }
    html += fmt::format("<tr><td>{}</td><td>{}</td><td style=\"text-align:left\">{}</td></tr>\n", line.claim,
                        as_markup(line.value), why);
  }
  return html + "</table></div>\n";
}

}  // namespace durero::conform
