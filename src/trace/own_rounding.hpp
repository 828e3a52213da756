#pragma once
/// What improve_and_round (packet.hpp) does, of rays that start on their elements.

#include "durero/trace/packet.hpp"

namespace durero::trace {

/// rounded(improved) in every lane. Precondition: the findings are hits by triage_from of these rays and elements.
void improve_and_round_from(const Packet& packet, model::Tipo tipo, const Findings& findings, RoundedPacket& result);

}  // namespace durero::trace
