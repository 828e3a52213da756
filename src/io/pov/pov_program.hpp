#pragma once
/// A POV-Ray text as a program: its directives are carried out, its macros and names replaced by what they stand for.
/// Objects and settings of literal values are left.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "durero/scene/stage.hpp"
#include "pov_expression.hpp"
#include "pov_spline.hpp"
#include "pov_token.hpp"

namespace durero::io {

struct PovValue;
/// Values by number; some have none yet.
using PovArray = std::vector<std::shared_ptr<PovValue>>;

/// A function of numbers.
struct PovFunction {
  std::vector<std::string_view> parameters;
  std::shared_ptr<const PovTokens> body;
};

/// The value of a name: nothing yet, numbers, a text, an array, a function, a spline, or tokens that are put in its
/// place.
struct PovValue {
  std::variant<std::monostate, PovNumbers, std::string, PovArray, PovFunction, std::shared_ptr<const PovSpline>,
               std::shared_ptr<const PovTokens>>
      of;

  /// Whether it is nothing but the name that has it, as that of a name without a value which a macro is given.
  bool is_itself(std::string_view name) const;
};

/// Runs a text when it is made. Files that it includes are searched in its folder and where POV-Ray keeps its own.
class PovProgram final : private PovTerms {
 public:
  /// Throws InputError, in the file and at the place where it is wrong. The source must outlive it.
  explicit PovProgram(const Source& source);

  /// The tokens that are left; they live as long as the program.
  const PovTokens& tokens() const { return left_; }
  /// The text itself.
  const Source& source() const { return main_; }

 private:
  struct Macro {
    std::vector<std::string_view> parameters;
    std::shared_ptr<const PovTokens> tokens;
    std::size_t begin, end;  // of its body
  };
  /// A directive that ends at an #end.
  struct Block {
    enum class Kind : std::uint8_t { condition, loop, count, choice } kind;
    std::size_t again = 0;                // where a turn of a loop begins
    std::shared_ptr<PovValue> counter{};  // of #for
    double last = 0, step = 1;            // of #for
    bool goes_on(double count) const;
  };
  /// Tokens that are read, up to an end.
  struct Frame {
    explicit Frame(std::shared_ptr<const PovTokens> all) : tokens(std::move(all)), next(0), end(tokens->size()) {}
    Frame(std::shared_ptr<const PovTokens> some, std::size_t from, std::size_t to, bool scope = false)
        : tokens(std::move(some)), next(from), end(to), has_scope(scope) {}
    /// A file, whose local names are its own; but those of the text itself are of all.
    Frame(const Source& source, bool is_included) : Frame(std::make_shared<const PovTokens>(pov_tokens(source))) {
      is_file = true, has_scope = is_included;
    }

    std::shared_ptr<const PovTokens> tokens;
    std::size_t next, end;
    bool is_file = false;
    bool has_scope = false;
    std::vector<Block> blocks{};
  };
  using Scope = std::unordered_map<std::string_view, std::shared_ptr<PovValue>>;

  // The tokens that expressions are read from: behind directives, macros, and names of things.
  const PovToken* here() override;
  void pass() override;
  std::optional<PovNumbers> named() override;
  void refuse(const std::string& expected) const override;

  // Tokens as they stand.
  const PovToken* raw(std::size_t ahead = 0) const;
  PovToken take_raw(const std::string& expected);
  void expect_raw(std::string_view text, std::string_view where);
  bool take_raw_if(std::string_view text);
  std::string_view name(const std::string& expected);
  void count_step(const PovToken& at);
  void push(Frame frame, const PovToken& at);
  void put(const PovValue& value, const PovToken& at);
  void leave_frame();
  bool replace(const PovToken& token);
  std::vector<std::string_view> parameters();

  void run();
  void emit();
  void emit(const PovNumbers& numbers, const PovToken& at);
  void emit_block_as_it_stands();
  void keep(const PovToken& token);
  template <class Keep>
  PovTokens kept_by(Keep keep);
  PovToken made(std::string text, const PovToken& at);

  // Directives, each from behind its name on.
  struct Directive;
  void direct(const PovToken& directive);
  std::optional<std::string> found_file(const std::string& name) const;
  void include(const PovToken& at);
  void declare(const PovToken& directive);
  void undefine(const PovToken& directive);
  void start_condition(const PovToken& directive);
  void start_loop(const PovToken& directive);
  void start_count(const PovToken& directive);
  void start_choice(const PovToken& directive);
  void end_branch(const PovToken& directive);
  void end_block(const PovToken& at);
  void break_out(const PovToken& at);
  void define_macro(const PovToken& directive);
  void set_version(const PovToken& at);
  void set_default(const PovToken& directive);
  void say(const PovToken& directive);
  void use_file(const PovToken& at);

  std::string_view skip();
  void skip_to_end();
  double in_parentheses(std::string_view where);
  bool is_defined();
  bool begins_text();
  double compared_texts();
  void pass_directives();

  PovValue value();
  PovArray array();
  PovArray elements();
  PovFunction function();
  std::shared_ptr<const PovSpline> spline();
  PovNumbers value_of(const PovSpline& spline, const PovToken& at);
  PovTokens captured();
  void invoke(const Macro& macro, const PovToken& at);
  std::shared_ptr<PovValue> argument();
  double call(const PovFunction& function, const PovToken& at);

  std::shared_ptr<PovValue> find(std::string_view name) const;
  std::shared_ptr<PovValue>& place_of(std::string_view name, bool is_local);
  std::shared_ptr<PovValue> element_of(const std::shared_ptr<PovValue>& array);
  std::optional<std::string> take_text();
  std::string text(std::string_view where);
  std::vector<PovNumbers> numbers_in_parentheses(std::string_view where);
  std::optional<PovNumbers> asked(std::string_view word);

  /// Two numbers are the same to POV-Ray's directives where they differ by less.
  static constexpr double same_within = 1e-10;
  /// The number of no token.
  static constexpr std::size_t unsettled = ~std::size_t{0};

  const Source& main_;
  const scene::Resolution size_;
  std::deque<Source> files_;
  std::deque<std::string> made_;
  std::vector<Frame> frames_;
  std::vector<Scope> scopes_;
  std::unordered_map<std::string_view, std::shared_ptr<const Macro>> macros_;
  std::vector<std::uint32_t> streams_;
  PovTokens left_;
  PovTokens* sink_ = &left_;
  std::size_t steps_ = 0, kept_ = 0, calls_ = 0, nested_ = 0;
  std::size_t floor_ = 0;            // frames that are not left
  std::size_t statement_ = 0;        // frames where an expression may end before a directive
  std::size_t open_ = 0;             // parentheses within that expression
  std::size_t settled_ = unsettled;  // the token of the last frame that is known to stand for itself
  double version_ = 3.62;            // POV-Ray's where none is told
};

/// The tokens that keep() keeps.
template <class Keep>
PovTokens PovProgram::kept_by(Keep keep) {
  PovTokens tokens;
  PovTokens* const sink = std::exchange(sink_, &tokens);
  keep();
  sink_ = sink;
  return tokens;
}

}  // namespace durero::io
