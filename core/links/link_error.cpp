#include "core/links/link_error.h"

#include <grp.h>
#include <sys/stat.h>

#include <array>
#include <boost/asio/error.hpp>

namespace leadline::links {
namespace {

std::string group_of(const std::string& path) {
  struct stat about {};
  if (::stat(path.c_str(), &about) != 0) return "dialout";
  struct group entry {
  }, *found = nullptr;
  std::array<char, 4096> room{};
  if (::getgrgid_r(about.st_gid, &entry, room.data(), room.size(), &found) != 0 || !found) return "dialout";
  return entry.gr_name;
}

struct Words {
  std::string what, remedy;
};

Words words_on_disk(const LinkAddress& address, int code) {
  const bool device = address.kind == LinkKind::serial;
  switch (code) {
    case EACCES:
    case EPERM:
      return {"permission denied", device ? "add yourself to the group " + group_of(address.path) +
                                                " (sudo usermod -aG " + group_of(address.path) +
                                                " $USER) and log in again"
                                          : "choose a folder this user may write to"};
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return device ? Words{"there is no such device",
                            "is it plugged in? /dev/serial/by-id lists those that are"}
                    : Words{"there is no such folder", "make it first"};
    case EBUSY:
      return {"another program has the device open", "close that program"};
    case ENOTTY:
      return {"is no serial device", "name a device like /dev/ttyUSB0"};
    case EINVAL:
      return device ? Words{"the device cannot do what is asked of it", "try another baud, parity or flow"}
                    : Words{"cannot be written", "name an ordinary file"};
    case EIO:
      return {"the device is gone", "plug it in again; the link comes back by itself"};
    case ENOSPC:
      return {"the disk is full", "make room on it"};
    case EISDIR:
      return {"is a folder", "name a file in it"};
    default:
      return {};
  }
}

Words words_on_network(const LinkAddress& address, int code) {
  switch (code) {
    case EACCES:
    case EPERM:
      return address.kind == LinkKind::tcp_listen
                 ? Words{"this user may not listen on the port", "choose a port from 1024 on"}
                 : Words{"the system does not let it through", "is a firewall in the way?"};
    case EADDRINUSE:
      return {"another program listens on this port", "close it, or choose another port"};
    case EADDRNOTAVAIL:
      return {"this computer has no such address",
              "`ip address` lists those it has; 0.0.0.0 means every one"};
    case ECONNREFUSED:
      return {"nobody listens there", "is the other program started, and the port right?"};
    case ENETUNREACH:
    case EHOSTUNREACH:
      return {"there is no way to that host", "is the cable plugged in, and this computer's address right?"};
    case ETIMEDOUT:
      return {"the other side does not answer", "is it switched on, and the address right?"};
    case ECONNRESET:
    case EPIPE:
      return {"the other side broke the connection off", "the link comes back by itself"};
    case EMSGSIZE:
      return {"a frame is longer than a datagram may be", "use tcp:// for frames above 65507 bytes"};
    case ENODEV:
    case ENXIO:
      return {"there is no network interface " + address.iface, "`ip link` lists those there are"};
    case EMFILE:
    case ENFILE:
      return {"no handle is left for another connection", "raise ulimit -n"};
    default:
      return {};
  }
}

}  // namespace

Error link_error(const LinkAddress& address, const boost::system::error_code& error) {
  namespace asio_error = boost::asio::error;
  const bool on_disk = address.kind == LinkKind::serial || address.kind == LinkKind::file;
  Words words;
  if (error == asio_error::eof)
    words = on_disk ? words_on_disk(address, EIO)
                    : Words{"the other side closed the connection", "the link comes back by itself"};
  else if (error == asio_error::host_not_found || error == asio_error::host_not_found_try_again ||
           error == asio_error::no_data)
    words = {"no host has the name " + address.host, "is it spelt right? an address needs no name server"};
  else
    words = on_disk ? words_on_disk(address, error.value()) : words_on_network(address, error.value());
  if (words.what.empty()) words.what = error.message();
  return {words.what, address.text(), words.remedy};
}

}  // namespace leadline::links
