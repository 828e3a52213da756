#pragma once
/// The order of the facts of a search.

#include <deque>

#include "search_plan.hpp"

namespace durero::spec {

/// Orders the facts of a search. What is known grows by the steps that are planned.
class PlanMaker {
 public:
  using Places = std::set<unsigned>;
  /// A set of so few members is listed before a disjunction is gone side by side.
  static constexpr double few_members = 64;

  PlanMaker(TermTranslator& translator, SearchPlan& plan, const PlanWish& wish)
      : translator_(translator), plan_(plan), wish_(wish) {}

  void make(const SoughtNames& sought);

 private:
  struct Fact {
    zed::Term term;
    const FrameScope* scope;
    bool whole = false;                                                // it is asked as it stands, and not taken apart
    bool counted = true;                                               // how it is answered is counted
    std::shared_ptr<const TermTranslator::Translated<IdTest>> test{};  // once it was translated
  };
  struct Sought {
    DomainPtr set;
    zed::Name name;
  };
  struct Pending {
    std::map<unsigned, Sought> unknown;
    std::vector<Fact> facts;
  };
  using Steps = std::vector<SearchPlan::Step>;

  void add(Pending& pending, const SoughtNames& sought, const FrameScope& scope);
  static Places unknown_places(const Pending& pending);
  static bool meets(const Places& a, const Places& b);
  void plan(Pending pending, Steps& steps, std::vector<zed::Term> sides);
  /// Asks each fact of which all is known.
  bool add_tests(Pending& pending, Steps& steps);
  const TermTranslator::Translated<IdTest>& test_of(Fact& fact);
  IdTest counted(const zed::Term& fact, IdTest test);
  /// The name that a term is, where its value is sought.
  static std::optional<unsigned> sought_name(const Pending& pending, const zed::Term& term, const FrameScope& scope);
  /// Gives a name its value; what is declared of it is asked.
  void give(Pending& pending, Steps& steps, unsigned at, IdCode value);
  bool add_equation(Pending& pending, Steps& steps);
  /// x = right, where left is x, x + b, b + x, x − b or b − x.
  static std::optional<std::pair<unsigned, zed::Term>> solved_for(const Pending& pending, const zed::Term& left,
                                                                  const zed::Term& right, const FrameScope& scope);
  /// ∃ D | P • Q of names that are sought: its variables are sought too.
  bool add_inner(Pending& pending);
  /// Takes a member apart: sought names are given its parts, and other parts are compared.
  using Match = std::function<bool(ValueId value, IdFrame frame)>;
  std::optional<Match> match(const Pending& pending, const zed::Term& pattern, const FrameScope& scope, Places& given);
  /// Goes through the members of a known set of which a name that is sought, or a tuple of such, is one.
  bool add_membership(Pending& pending, Steps& steps);
  /// Lists the smallest set of a name that no equation may give, unless sets of any size are listed.
  bool add_listing(Pending& pending, Steps& steps, double below);
  /// The names that an equation, in some side of a disjunction too, may give.
  static Places given_by_equations(const Pending& pending);
  /// The sides of a fact, each as the facts that it adds; none where it is no disjunction.
  std::vector<std::vector<Fact>> sides_of(const Fact& fact) const;
  /// Goes each side of a disjunction on its own.
  bool add_sides(Pending& pending, Steps& steps, const std::vector<zed::Term>& before, bool any);
  static zed::Term side_text(const std::vector<Fact>& side);
  void add_side(Pending& rest, const std::vector<Fact>& side);
  /// The bounds that facts x ≤ e, x < e, e ≤ x and e < x set a sought number.
  struct Bounds {
    std::vector<std::pair<IdCode, int>> low, high;  // each with what is added to it
  };
  Bounds bounds_of(Pending& pending, unsigned at);
  /// Goes through the whole numbers that facts bound, or that the setup does.
  bool add_range(Pending& pending, Steps& steps, bool by_setup);

  TermTranslator& translator_;
  SearchPlan& plan_;
  const PlanWish& wish_;
  std::deque<FrameScope> scopes_;
  std::size_t sides_ = 0;
};

/// Says whether a term is one of these.
bool has_term(const std::vector<zed::Term>& terms, const zed::Term& term);

}  // namespace durero::spec
