#include "core/links/link_receiver.h"

#include "core/links/link_port.h"

namespace leadline::links {

LinkReceiver::LinkReceiver(IoLoop& loop, const LinkAddress& address, const LinkLimits& limits, Heard heard)
    : loop_(loop), port_(make_port(loop, address, limits, {.heard = std::move(heard)})) {
  loop_.post([port = port_] { port->start(); });
}

LinkReceiver::~LinkReceiver() {
  loop_.run_there([this] {
    port_->close();
    port_->account.stop_telling();
  });
}

LinkStatus LinkReceiver::status() const { return port_->account.status(); }
const LinkAddress& LinkReceiver::address() const { return port_->address; }

}  // namespace leadline::links
