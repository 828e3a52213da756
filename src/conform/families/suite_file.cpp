#include "durero/conform/families/suite_file.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "conform/families/suite_text.hpp"
#include "durero/io/source.hpp"

namespace durero::conform {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& wrong) {
  throw io::FileError(path.string(), wrong, "expected a directory that can be written, new or empty");
}

/// The directory that the path means, without a separator at its end and with links followed.
fs::path resolved(const std::string& directory) {
  std::error_code error;
  const fs::path real = fs::canonical(directory, error);
  if (!error) return real;
  const fs::path plain = fs::path(directory).lexically_normal();
  return plain.has_filename() ? plain : plain.parent_path();
}

/// A directory beside its target, which it replaces at commit(). Until then, and if commit() is never reached, the
/// target is as it was, and nothing else is left behind.
class OutputDirectory {
 public:
  explicit OutputDirectory(const std::string& directory) : target_(resolved(directory)) {
    std::error_code error;
    if (fs::exists(target_, error) && !(fs::is_directory(target_, error) && fs::is_empty(target_, error)))
      refuse(target_, "it is there already, and is no empty directory");
    for (int i = 0; temporary_.empty(); ++i) {
      const fs::path beside = target_.string() + fmt::format(".new{}", i);
      if (fs::create_directory(beside, error)) temporary_ = beside;
      if (error) refuse(target_, "cannot be written: " + error.message());
    }
  }
  ~OutputDirectory() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
  }
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  void add_folder(std::string_view name) const {
    std::error_code error;
    fs::create_directory(temporary_ / name, error);
    if (error) refuse(target_, "cannot be written: " + error.message());
  }
  void add_file(const std::string& name, const std::string& text) const {
    std::ofstream out(temporary_ / name, std::ios::binary);
    out << text;
    out.close();
    if (!out) refuse(target_, fmt::format("{} in it cannot be written", name));
  }
  void commit() {
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) refuse(target_, "cannot be put in place: " + error.message());
    temporary_.clear();
  }

 private:
  fs::path target_, temporary_;
};

/// The cases of a family, each on a thread of its own.
FamilySummary write_family(const OutputDirectory& to, const SuiteOptions& options, const Family& family,
                           const std::function<void()>& before_case) {
  std::vector<FamilySummary> counted(cases(options, family));
  if (!counted.empty()) to.add_folder(family.name);
  oneapi::tbb::parallel_for(std::size_t{0}, counted.size(), [&](std::size_t number) {
    before_case();
    SuiteCase of = suite_case(options, family, number);
    answer(of);
    counted[number] = summary(of);
    ask_question(of, options);
    for (const File& file : case_files(of, counted[number].count))
      to.add_file(fmt::format("{}{}", of.name(), file.ending), file.text);
  });
  FamilySummary all{.family = &family};
  for (const FamilySummary& of_case : counted) all += of_case;
  return all;
}

}  // namespace

std::vector<FamilySummary> write_suite(const std::string& directory, const SuiteOptions& options,
                                       const std::function<void()>& before_case) {
  if (options.question == QuestionKind::closest)
    throw std::invalid_argument("a suite of nearest points; expected durero conform run, which asks them");
  OutputDirectory to(directory);
  std::vector<FamilySummary> families;
  for (const Family* family : chosen_families(options))
    families.push_back(write_family(to, options, *family, before_case));
  to.add_file("suite.json", suite_text(options, families));
  to.commit();
  return families;
}

}  // namespace durero::conform
