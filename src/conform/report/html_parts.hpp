#pragma once
/// The parts that pages of HTML share.

#include <string>
#include <string_view>

#include "durero/conform/report/report.hpp"

namespace durero::conform {

/// The page up to its first heading, which is the title; `subject` stands behind it in the name of the page.
std::string page_head(std::string_view title, std::string_view subject);
inline constexpr std::string_view page_foot = "</body>\n</html>\n";

/// A picture with its caption.
std::string figure(const std::string& svg, const std::string& caption);

/// The section on the profile, with its sources.
std::string profile_html(const Profile& profile);

}  // namespace durero::conform
