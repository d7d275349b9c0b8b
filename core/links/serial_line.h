#pragma once

#include <boost/asio/serial_port.hpp>

#include "core/links/link_address.h"

namespace leadline::links {

/// Opens the device raw, with the speed, bits, parity and flow control of the address, for this program
/// alone.
[[nodiscard]] boost::system::error_code open_serial(boost::asio::serial_port& port,
                                                    const LinkAddress& address);

}  // namespace leadline::links
