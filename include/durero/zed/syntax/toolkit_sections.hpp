#pragma once
/// The mathematical toolkit of Z is a prelude and sections (ISO/IEC 13568, clause 11 and annex B). A section sees the
/// prelude, and of the others those that are among its ancestors.

#include <cstdint>
#include <optional>
#include <string_view>

namespace durero::zed {

/// A section of the toolkit that declares names. `standard_toolkit` declares none, and has all of them as ancestors.
enum class ToolkitSection : std::uint8_t { prelude, set, relation, function, number, sequence };

/// Returns the name of a section of the toolkit in Z, such as `set_toolkit`.
std::string_view name_of(ToolkitSection section);

/// The sections of the toolkit that a section sees; the prelude is always among them.
class ToolkitSections {
 public:
  /// The prelude alone.
  constexpr ToolkitSections() = default;

  /// Returns what a section of this name gives to its children: itself and its ancestors. Nothing where the toolkit has
  /// no such section.
  static std::optional<ToolkitSections> of(std::string_view name);
  /// All of the toolkit, which `standard_toolkit` gives.
  static constexpr ToolkitSections all() { return ToolkitSections(0x3F); }

  /// Says whether a section is among them.
  constexpr bool has(ToolkitSection section) const { return (seen_ >> static_cast<unsigned>(section) & 1U) != 0; }
  /// Adds the others to these.
  constexpr ToolkitSections& operator|=(ToolkitSections other) {
    seen_ |= other.seen_;
    return *this;
  }
  /// Says whether both have the same sections.
  friend constexpr bool operator==(ToolkitSections, ToolkitSections) = default;

 private:
  explicit constexpr ToolkitSections(unsigned seen) : seen_(seen) {}
  unsigned seen_ = 1;  // a bit for each section, that of the prelude first
};

}  // namespace durero::zed
