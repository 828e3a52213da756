#include "durero/store/digest.hpp"

#include <fmt/format.h>
#ifdef DURERO_DIGEST_ALONE
#define OPENSSL_SUPPRESS_DEPRECATED
#include <openssl/sha.h>
#else
#include <openssl/evp.h>
#endif

#include <new>

namespace durero::store {

std::string hexadecimal(const Digest& digest) {
  std::string text;
  for (const char byte : digest) text += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  return text;
}

FieldDigest& FieldDigest::add(std::string_view field) {
  fmt::format_to(std::back_inserter(fields_), "{}:", field.size());
  fields_.append(field).push_back(',');
  return *this;
}

Digest FieldDigest::digest() const { return digest_of(fields_); }

#ifdef DURERO_DIGEST_ALONE
/// The functions of this algorithm, which OpenSSL keeps for programs that carry no other (cmake/Static.cmake).
Digest digest_of(std::string_view bytes) {
  SHA256_CTX context;
  Digest digest{};
  if (SHA256_Init(&context) != 1 || SHA256_Update(&context, bytes.data(), bytes.size()) != 1 ||
      SHA256_Final(reinterpret_cast<unsigned char*>(digest.data()), &context) != 1)
    throw std::bad_alloc();
  return digest;
}
#else
/// The algorithm is looked up once: that takes longer than the digest of an event.
Digest digest_of(std::string_view bytes) {
  static EVP_MD* const sha256 = EVP_MD_fetch(nullptr, "SHA256", nullptr);
  Digest digest{};
  if (sha256 == nullptr || EVP_Digest(bytes.data(), bytes.size(), reinterpret_cast<unsigned char*>(digest.data()),
                                      nullptr, sha256, nullptr) != 1)
    throw std::bad_alloc();
  return digest;
}
#endif

}  // namespace durero::store
