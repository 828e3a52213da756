#include "durero/store/store_path.hpp"

#include <algorithm>

namespace durero::store {
namespace {

constexpr std::string_view schemes[] = {"postgresql://", "postgres://"};

/// The parameters of libpq whose values open something.
constexpr std::string_view secrets[] = {"password", "sslpassword"};

std::size_t length_of_scheme(std::string_view path) noexcept {
  for (const std::string_view scheme : schemes)
    if (path.starts_with(scheme)) return scheme.size();
  return 0;
}

/// libpq takes for user and password what stands before the first @, unless a / is before that; the password is behind
/// the first colon.
std::string without_password(std::string_view behind) {
  const std::size_t at = behind.find_first_of("@/");
  if (at == behind.npos || behind[at] != '@') return std::string(behind);
  const std::string_view user = behind.substr(0, at);
  return std::string(user.substr(0, user.find(':'))).append(behind.substr(at));
}

/// Whether a parameter has a secret name. A name may have its letters as %70, so that one with a % counts as secret.
bool is_secret(std::string_view parameter) {
  const std::string_view name = parameter.substr(0, parameter.find('='));
  for (const std::string_view secret : secrets)
    if (name == secret) return true;
  return name.find('%') != name.npos;
}

}  // namespace

bool is_server_uri(std::string_view path) noexcept { return length_of_scheme(path) > 0; }

std::string shown_path(std::string_view path) {
  const std::size_t scheme = length_of_scheme(path);
  if (scheme == 0) return std::string(path);
  const std::string rest = without_password(path.substr(scheme));
  const std::size_t question = rest.find('?');
  std::string shown(path.substr(0, scheme));
  shown.append(rest, 0, question);
  char before = '?';
  for (std::size_t begin = question; begin < rest.size();) {
    const std::size_t end = std::min(rest.find('&', begin + 1), rest.size());
    const std::string parameter = rest.substr(begin + 1, end - begin - 1);
    begin = end;
    if (is_secret(parameter)) continue;
    shown += before;
    shown += parameter;
    before = '&';
  }
  return shown;
}

std::string picture_place(const std::string& path) { return is_server_uri(path) ? "/store" : path; }

}  // namespace durero::store
