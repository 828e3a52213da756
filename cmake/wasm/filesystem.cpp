// Names of files as texts: what std::filesystem says of them without looking any up.
#include <algorithm>
#include <filesystem>

namespace std::filesystem {
namespace {

size_t dot_of(const std::string& name) {
  const size_t dot = name.rfind('.');
  return dot == 0 || name == ".." ? std::string::npos : dot;
}

}  // namespace

path path::parent_path() const {
  size_t slash = name_.rfind('/');
  if (slash == std::string::npos) return {};
  while (slash > 0 && name_[slash - 1] == '/') --slash;
  return slash == 0 ? path("/") : path(name_.substr(0, slash));
}

path path::extension() const {
  const std::string name = filename().string();
  const size_t dot = dot_of(name);
  return dot == std::string::npos ? path() : path(name.substr(dot));
}

path path::stem() const {
  const std::string name = filename().string();
  return name.substr(0, dot_of(name));
}

path& path::operator/=(const path& more) {
  if (more.is_absolute() || name_.empty()) return *this = path(more.name_);
  parts_.clear();
  if (!name_.ends_with('/')) name_ += '/';
  name_ += more.name_;
  return *this;
}

const vector<path>& path::parts() const {
  parts_.clear();
  if (is_absolute()) parts_.emplace_back("/");
  for (size_t at = 0; at < name_.size();) {
    const size_t slash = std::min(name_.find('/', at), name_.size());
    if (slash > at) parts_.emplace_back(name_.substr(at, slash - at));
    at = slash + 1;
    if (slash + 1 == name_.size()) parts_.emplace_back();  // an empty part behind the last stroke
  }
  return parts_;
}

path::const_iterator path::begin() const { return parts().begin(); }
path::const_iterator path::end() const { return parts_.end(); }

path path::lexically_normal() const {
  vector<std::string> kept;
  bool is_folder = false;
  for (const path& part : vector<path>(parts())) {
    const std::string& word = part.string();
    is_folder = word.empty() || word == "." || word == "..";
    if (word.empty() || word == "." || word == "/") continue;
    if (word != ".." || (kept.empty() && !is_absolute()) || (!kept.empty() && kept.back() == "..")) {
      kept.push_back(word);
    } else if (!kept.empty()) {
      kept.pop_back();
    }
  }
  std::string name = is_absolute() ? "/" : "";
  for (size_t i = 0; i < kept.size(); ++i) name += (i > 0 ? "/" : "") + kept[i];
  if (name.empty()) return name_.empty() ? path() : path(".");
  if (is_folder && !kept.empty() && kept.back() != "..") name += '/';
  return name;
}

path path::lexically_relative(const path& base) const {
  if (is_absolute() != base.is_absolute()) return {};
  const vector<path> of = parts(), from = base.parts();
  size_t common = 0;
  while (common < min(of.size(), from.size()) && of[common] == from[common]) ++common;
  path result;
  ptrdiff_t up = 0;
  for (size_t i = common; i < from.size(); ++i) {
    if (from[i] == "..") {
      --up;
    } else if (!from[i].empty() && from[i] != ".") {
      ++up;
    }
  }
  if (up < 0) return {};
  if (up == 0 && (common == of.size() || of[common].empty())) return ".";
  for (; up > 0; --up) result /= "..";
  for (size_t i = common; i < of.size(); ++i) result /= of[i];
  return result;
}

}  // namespace std::filesystem
