#pragma once
/// The log of a run's claims, from which the run can go on after a stop:
///
///   {"format":"durero-claims","version":1,"run":"embree --seed 1 --rays 1024","system":"Embree 3.13.5"}
///   {"case":"generic/0000","claims":["miss","hit e0 4.5","crashed signal 6 (Aborted)"]}
///
/// The file has a line for each case, in their order. The rest that a stop cut off behind the last whole line is left
/// out.

#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "durero/conform/ask/claim.hpp"
#include "durero/conform/families/suite.hpp"

namespace durero::conform {

class ClaimsLog {
 public:
  /// Begins a log. The file must not exist. Throws io::FileError.
  static ClaimsLog begin(const std::string& path, const std::string& identity);
  /// Reads the log and continues behind it. Throws io::InputError where it is of another run, or malformed.
  static ClaimsLog go_on(const std::string& path, const std::string& identity);

  /// The number of cases that the log had when it was opened.
  std::size_t cases() const { return lines_.size(); }
  /// The system's name and version when the run began; empty where no case was kept.
  const std::string& says() const { return says_; }
  /// The claims on a case that the log had. Throws std::runtime_error where they are of another case.
  std::vector<Claim> claims(std::size_t place, const SuiteCase& of) const;

  /// Writes the claims on the next case. Throws io::FileError, and std::runtime_error where the system has another
  /// version now.
  void add(const SuiteCase& of, std::span<const Claim> claims, const std::string& says);
  /// Removes the file, whose contents cannot be believed.
  void remove();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void open(const char* mode);
  void write_head(const std::string& says);
  void write(const std::string& line);

  std::string path_, identity_, says_;
  std::vector<std::string> lines_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace durero::conform
