#include "durero/contract/contract.hpp"

#include <fmt/core.h>

#include <atomic>
#include <cstdio>

namespace durero::contract {
namespace {

constexpr std::string_view name(kind what) {
  switch (what) {
    case kind::precondition:
      return "precondition";
    case kind::postcondition:
      return "postcondition";
    case kind::invariant:
      return "invariant";
    case kind::assertion:
      return "assertion";
  }
  unreachable();
}

void default_handler(const contract_violation& violation) {
  if (violation.semantic() == evaluation_semantic::enforce) throw contract_violation(violation);
  fmt::print(stderr, "durero: {}\n", violation.what());
}

std::atomic<violation_handler> handler{&default_handler};

}  // namespace

contract_violation::contract_violation(const clause& broken, std::string values, std::source_location where,
                                       evaluation_semantic semantic)
    : broken_(broken), where_(where), semantic_(semantic) {
  std::string what = fmt::format("{} {} broken: {}", name(broken.kind()), broken.label, broken.predicate);
  if (!values.empty()) what += fmt::format(" [{}]", values);
  text_ = std::make_shared<const text>(text{std::move(values), std::move(what)});
}

violation_handler set_violation_handler(violation_handler next) noexcept {
  return handler.exchange(next ? next : &default_handler);
}

void report(const clause& broken, std::string values, std::source_location where, evaluation_semantic semantic) {
  if (semantic == evaluation_semantic::quick_enforce) std::terminate();
  handler.load()(contract_violation(broken, std::move(values), where, semantic));
  if (semantic == evaluation_semantic::enforce) std::terminate();
}

}  // namespace durero::contract
