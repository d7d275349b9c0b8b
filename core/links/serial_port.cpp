#include <algorithm>

#include "core/links/serial_line.h"
#include "core/links/stream_port.h"

namespace leadline::links {
namespace {

/// Looking for a device costs nothing and asks nobody: it is looked for at least this often.
LinkLimits of_a_device(LinkLimits limits) {
  limits.retry_last = std::min(limits.retry_last, std::chrono::milliseconds(2000));
  return limits;
}

class SerialPort final : public StreamPort<boost::asio::serial_port> {
 public:
  SerialPort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkCalls calls)
      : StreamPort(loop, where, of_a_device(held_to), std::move(calls)) {}

 private:
  void open() override {
    if (const auto error = open_serial(stream_, address)) return fail(error);
    opened();
  }
};

}  // namespace

std::shared_ptr<LinkPort> make_serial_port(IoLoop& loop, const LinkAddress& address, const LinkLimits& limits,
                                           LinkCalls calls) {
  return std::make_shared<SerialPort>(loop, address, limits, std::move(calls));
}

}  // namespace leadline::links
