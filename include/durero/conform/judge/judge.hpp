#pragma once
/// The judge decides by exact arithmetic whether a system's claim about a ray is right.
///
/// A hit is right where its point may lie on the element that it names (on any element, where it names none; on the
/// wall or the discs of a solid) for some data within the declared backward error (verdict.hpp), and no element is met
/// before it by the rays of *all* such data. A hit with neither a distance nor a point is right where the ray of some
/// such data meets its element, and the rays of all such data meet no other element before; it claims no number and is
/// never `exact`. A miss is right where no element is met by the rays of all such data, and the origin lies in no
/// closed mesh of a system that claims to be watertight. An exact answer from data that are off by no more than the
/// backward error is therefore right. A claim that is off is the answer of no such data: beside
/// conform/judge/shell.hpp, conform/judge/zones.hpp and conform/judge/limits.hpp this is proved as a theorem, with
/// exact arithmetic.
///
/// Of a shadow ray (SuiteCase::ends) a hit is right where the ray of some such data meets an element at a t that may be
/// up to the end, and a miss where not all such rays meet one certainly before it.
///
/// The limits least_t and greatest_t of a profile bound the distances at which the system must see a hit. The data
/// given decide which rays are judged: rays whose exact first hit is not beyond a limit, and rays that hit nothing. All
/// data within the declared backward error decide which claims are right: hits beyond a limit may be seen or passed by,
/// and another hit, or a miss, is right where all nearer hits may be beyond a limit. A hit within the error of a limit
/// is permitted on either side of it; a hit beyond a limit is right where it is right without the limits.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/ask/profile.hpp"
#include "durero/conform/families/suite.hpp"
#include "durero/conform/judge/verdict.hpp"

namespace durero::conform {

/// The judge of one case for one profile. What concerns the scene alone it finds once, and a tree finds the elements of
/// a scene that has many; its verdicts are those of judge(). Many threads may ask it.
class CaseJudge {
 public:
  /// Case and profile must outlive it unchanged. Precondition: the case was answered.
  CaseJudge(const SuiteCase& of, const Profile& profile);
  ~CaseJudge();  ///< lets go of what it found
  CaseJudge(const CaseJudge&) = delete;
  CaseJudge& operator=(const CaseJudge&) = delete;

  /// The judgement on the claim about ray number `ray`. Precondition: the case has such a ray.
  ClaimJudgement judge(std::size_t ray, const Claim& claim) const;
  /// The judgements on the claims about all rays, in order, by as many threads as the calling one may use.
  /// Precondition: there is a claim for each ray.
  std::vector<ClaimJudgement> judge(std::span<const Claim> claims) const;
  /// The clause of the profile that excludes the ray, or an empty text where the ray is inside the profile. A ray
  /// outside is not asked. Precondition: the case has such a ray.
  std::string outside(std::size_t ray) const;
  /// The clause of each ray, in order.
  std::vector<std::string> outside() const;

 private:
  class Parts;
  std::unique_ptr<const Parts> parts_;
};

/// CaseJudge::judge() of a case that is asked for one ray.
ClaimJudgement judge(const SuiteCase& of, std::size_t ray, const Claim& claim, const Profile& profile);

/// CaseJudge::outside() of a case that is asked for one ray.
std::string outside(const SuiteCase& of, std::size_t ray, const Profile& profile);

}  // namespace durero::conform
