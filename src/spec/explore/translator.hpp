#pragma once
/// Translates terms of the text, once, to code on kept values. A local name is a place in a frame; what the code does
/// not serve is asked of the evaluator, whose answers are kept.

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "durero/zed/evaluate/unfold.hpp"
#include "interned_values.hpp"
#include "spec/machine_parts.hpp"

namespace durero::spec {

/// The values of local names, by their places.
using IdFrame = ValueId*;
using IdCode = std::function<ValueId(IdFrame frame)>;
using IdTest = std::function<bool(IdFrame frame)>;
/// A visit is called for each value that is found; it returns false to stop.
using IdVisit = std::function<bool(ValueId value)>;

/// The error of a term that neither the code nor the evaluator decides.
class Undecided : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Local names with their places.
struct FrameScope {
  const FrameScope* outer = nullptr;
  std::map<zed::Name, unsigned> places{};
  std::optional<unsigned> find(const zed::Name& name) const;
};

/// A set that a name is declared from, asked for members, or to list them.
class ValueDomain {
 public:
  virtual ~ValueDomain() = default;
  virtual bool has(ValueId value, IdFrame frame) const = 0;
  /// Says whether each value of the type is a member.
  virtual bool is_whole() const { return false; }
  /// About how many members it has; infinite where they cannot be listed.
  virtual double size() const = 0;
  /// Lists the members. Returns false where the visit stopped it.
  virtual bool each(IdFrame frame, const IdVisit& visit) const = 0;
  /// The least whole number in a set of all whole numbers from there on; nothing for any other set.
  virtual std::optional<std::optional<std::int64_t>> numbers_from() const { return std::nullopt; }
};
using DomainPtr = std::shared_ptr<const ValueDomain>;

/// The size of a set that cannot be listed.
constexpr double unlisted = std::numeric_limits<double>::infinity();

/// Whole numbers from one to another.
struct NumberBounds {
  std::int64_t low = 0, high = 3;
};

/// A declaration of variables with what holds of them, whose values are looked for.
struct SoughtNames {
  std::vector<std::pair<unsigned, DomainPtr>> variables;  ///< a place, with its set; null where it has none
  std::vector<std::pair<zed::Name, unsigned>> names;      ///< those of a characteristic tuple, in order
  std::vector<zed::Term> facts;
  FrameScope scope;
};

/// The fact that the name is in the set, at the place of the set.
zed::Term member_of(const zed::Name& name, const zed::Term& set);

class TermTranslator {
 public:
  TermTranslator(const Machine::Parts& parts, InternedValues& values, NumberBounds numbers);

  /// A new place in frames.
  unsigned place() { return size_++; }
  /// The number of places in a frame.
  unsigned frame_size() const { return size_; }
  /// Code, with the places that it reads.
  template <class Code>
  struct Translated {
    Code code;
    std::set<unsigned> reads;
  };
  Translated<IdCode> expression_read(const zed::Term& term, const FrameScope& scope);
  Translated<IdTest> predicate_read(const zed::Term& term, const FrameScope& scope);
  Translated<DomainPtr> domain_read(const zed::Term& term, const FrameScope& scope);

  /// The schema text that the schema is, without others in it; nothing where the term is no schema.
  std::shared_ptr<const zed::SchemaText> flat(const zed::Term& schema);
  /// Splits a fact into those that it is the conjunction of.
  void add_facts(std::vector<zed::Term>& facts, const zed::Term& fact);
  /// Adds the facts of a schema text: each name is in its set, and each predicate holds.
  void add_facts(std::vector<zed::Term>& facts, const zed::SchemaText& text);
  /// The names of a schema text, each with a new place.
  SoughtNames sought(const zed::SchemaText& text, const FrameScope& scope);

  InternedValues& values() { return values_; }
  const NumberBounds& numbers() const { return numbers_; }
  const Machine::Parts& parts() const { return parts_; }

 private:
  friend class PlanMaker;
  /// The places that are read in its life are kept apart. At its end, by an error too, they are added to the others.
  class ReadsApart {
   public:
    explicit ReadsApart(std::set<unsigned>& reads) : reads_(reads), before_(std::exchange(reads, {})) {}
    ~ReadsApart() {
      before_.merge(reads_);  // the others are many, and are not gone through
      reads_.swap(before_);
    }
    ReadsApart(const ReadsApart&) = delete;
    ReadsApart& operator=(const ReadsApart&) = delete;

   private:
    std::set<unsigned>& reads_;
    std::set<unsigned> before_;
  };
  /// Translates, and tells the places that the code reads.
  template <class Translate>
  auto with_reads(Translate&& translate) -> Translated<decltype(translate())> {
    const ReadsApart apart(reads_);
    auto code = translate();
    return {std::move(code), reads_};
  }
  IdCode expression(const zed::Term& term, const FrameScope& scope);
  IdCode translated(const zed::Term& term, const FrameScope& scope);
  IdCode reference(const zed::Node& node, const FrameScope& scope);
  IdCode application(const zed::Term& term, const FrameScope& scope);
  IdCode each_part(const zed::Node& node, const FrameScope& scope, InternedForm form);
  IdCode comprehension(const zed::Node& node, const FrameScope& scope);
  IdCode definite(const zed::Node& node, const FrameScope& scope);
  IdCode let_value(const zed::Node& node, const FrameScope& scope);
  IdCode binding_of(const zed::Node& node, const FrameScope& scope);
  IdCode theta(const zed::Node& node, const FrameScope& scope);
  IdCode selection(const zed::Node& node, const FrameScope& scope);
  IdCode asked_value(const zed::Term& term, const FrameScope& scope);
  IdCode characteristic(const zed::SchemaText& text, const SoughtNames& sought);

  IdTest predicate(const zed::Term& term, const FrameScope& scope);
  IdTest translated_test(const zed::Term& term, const FrameScope& scope);
  IdTest relation(const zed::Node& node, const FrameScope& scope);
  IdTest link(const std::string& word, const zed::Term& left, const zed::Term& right, const FrameScope& scope);
  IdTest quantified(const zed::Node& node, const FrameScope& scope);
  IdTest schema_test(const zed::Term& term, const FrameScope& scope);
  IdTest asked_truth(const zed::Term& term, const FrameScope& scope);

  DomainPtr domain(const zed::Term& term, const FrameScope& scope);
  DomainPtr domain_of_name(const zed::Term& term, const FrameScope& scope);

  /// The places of the local names in a term, for the evaluator.
  std::vector<std::pair<zed::Name, unsigned>> locals_in(const zed::Term& term, const FrameScope& scope);
  void collect(const zed::Term& term, const FrameScope& scope, std::map<zed::Name, unsigned>& into);
  ValueId global(const zed::Name& name);
  ValueId applied(ValueId function, ValueId argument);
  bool contained(ValueId set, ValueId value);
  zed::Valuation valuation(const std::vector<std::pair<zed::Name, unsigned>>& locals, IdFrame frame) const;
  bool is_global(const zed::Name& name) const { return globals_.contains(name); }
  bool names_no_schema(const zed::Name& name) const;
  std::shared_ptr<const zed::SchemaText> flat_anew(const zed::Term& schema);

  const Machine::Parts& parts_;
  InternedValues& values_;
  NumberBounds numbers_;
  unsigned size_ = 0;
  std::set<unsigned> reads_;
  std::map<zed::Name, const zed::Paragraph*> globals_;
  std::map<zed::Name, ValueId> global_values_;
  std::map<std::pair<ValueId, ValueId>, ValueId> applications_;
  std::map<std::pair<ValueId, ValueId>, bool> memberships_;
  zed::SchemaUnfolder unfolder_;
  std::map<zed::Name, std::shared_ptr<const zed::SchemaText>> flat_;
};

}  // namespace durero::spec
