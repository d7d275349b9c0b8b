#include "core/links/serial_line.h"

#include <sys/ioctl.h>

namespace leadline::links {

boost::system::error_code open_serial(boost::asio::serial_port& port, const LinkAddress& address) {
  using Port = boost::asio::serial_port;
  using Flow = LinkAddress::Flow;
  using Parity = LinkAddress::Parity;
  boost::system::error_code error;
  port.open(address.path, error);
  if (error) return error;
  (void)::ioctl(port.native_handle(), TIOCEXCL);  // where it is unknown the line works all the same
  const auto set = [&](const auto& option) {
    if (!error) port.set_option(option, error);
  };
  set(Port::baud_rate(static_cast<unsigned>(address.baud)));
  set(Port::character_size(static_cast<unsigned>(address.data_bits)));
  set(Port::stop_bits(address.stop_bits == 2 ? Port::stop_bits::two : Port::stop_bits::one));
  set(Port::parity(address.parity == Parity::even  ? Port::parity::even
                   : address.parity == Parity::odd ? Port::parity::odd
                                                   : Port::parity::none));
  set(Port::flow_control(address.flow == Flow::rts   ? Port::flow_control::hardware
                         : address.flow == Flow::xon ? Port::flow_control::software
                                                     : Port::flow_control::none));
  if (error) {
    boost::system::error_code ignored;
    port.close(ignored);
  }
  return error;
}

}  // namespace leadline::links
