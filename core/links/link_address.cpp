#include "core/links/link_address.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

namespace leadline::links {
namespace {

constexpr std::string_view kForms =
    "write serial:///dev/ttyUSB0, udp://HOST:PORT, tcp://HOST:PORT, tcp-listen://0.0.0.0:PORT or "
    "file:///PATH";
constexpr std::size_t kLongest = 4096;

struct Scheme {
  std::string_view name;
  LinkKind kind;
  std::string_view form;
  std::vector<std::string_view> keys;
};
const std::array<Scheme, 5>& schemes() {
  static const std::array<Scheme, 5> kSchemes{{
      {"serial",
       LinkKind::serial,
       "serial:///dev/ttyUSB0?baud=115200",
       {"baud", "parity", "flow", "data", "stop"}},
      {"udp", LinkKind::udp, "udp://HOST:PORT", {"iface", "ttl"}},
      {"tcp", LinkKind::tcp, "tcp://HOST:PORT", {}},
      {"tcp-listen", LinkKind::tcp_listen, "tcp-listen://0.0.0.0:PORT", {}},
      {"file", LinkKind::file, "file:///PATH", {"follow"}},
  }};
  return kSchemes;
}
const Scheme& scheme_of(LinkKind kind) {
  return *std::find_if(schemes().begin(), schemes().end(), [&](const Scheme& s) { return s.kind == kind; });
}

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

std::optional<std::int64_t> whole(std::string_view text, std::int64_t least, std::int64_t most) {
  std::int64_t value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc{} || end != text.data() + text.size() || value < least || value > most)
    return std::nullopt;
  return value;
}

bool is_ipv4(const std::string& host) {
  in_addr address{};
  return ::inet_pton(AF_INET, host.c_str(), &address) == 1;
}
bool is_ipv6(const std::string& host) {
  in6_addr address{};
  return ::inet_pton(AF_INET6, host.substr(0, host.find('%')).c_str(), &address) == 1;
}
bool is_name(std::string_view host) {
  return !host.empty() && host.size() <= 253 && std::all_of(host.begin(), host.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '.' || c == '_';
  });
}
bool digits_and_dots(std::string_view host) {
  return std::all_of(host.begin(), host.end(), [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
}

int hex_digit(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

std::optional<std::string> without_percent(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain.push_back(text[i]);
      continue;
    }
    if (i + 2 >= text.size()) return std::nullopt;
    const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
    if (high < 0 || low < 0 || (high == 0 && low == 0)) return std::nullopt;
    plain.push_back(static_cast<char>(high * 16 + low));
    i += 2;
  }
  return plain;
}

std::string with_percent(const std::string& path) {
  constexpr char kDigits[] = "0123456789ABCDEF";
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte <= 0x20 || byte == 0x7F || c == '%' || c == '?' || c == '#')
      text.push_back('%'), text.push_back(kDigits[byte >> 4]), text.push_back(kDigits[byte & 15]);
    else
      text.push_back(c);
  }
  return text;
}

/// One text on its way to an address; every mistake is this text's.
class Parsing {
 public:
  explicit Parsing(std::string_view text) : text_(text) {}

  Result<LinkAddress> read() {
    if (text_.size() > kLongest)
      return Error{"is longer than " + std::to_string(kLongest) + " characters", quoted(text_.substr(0, 40)),
                   std::string(kForms)};
    if (std::any_of(text_.begin(), text_.end(), [](char c) { return (c >= 0 && c <= ' ') || c == 0x7F; }))
      return mistake("holds a blank or a control character", "write %20 for a blank in a path");
    const auto colon = text_.find("://");
    if (colon == std::string_view::npos) return mistake("is no link", std::string(kForms));
    const auto scheme = std::find_if(schemes().begin(), schemes().end(),
                                     [&](const Scheme& s) { return s.name == text_.substr(0, colon); });
    if (scheme == schemes().end())
      return mistake(quoted(text_.substr(0, colon)) + " is no kind of link", std::string(kForms));
    scheme_ = &*scheme;
    address_.kind = scheme->kind;
    const auto rest = text_.substr(colon + 3);
    const auto question = rest.find('?');
    const auto place = rest.substr(0, question);
    const bool on_disk = address_.kind == LinkKind::serial || address_.kind == LinkKind::file;
    if (auto read = on_disk ? read_path(place) : read_host(place); !read) return read.error();
    if (question != std::string_view::npos)
      if (auto read = read_keys(rest.substr(question + 1)); !read) return read.error();
    return address_;
  }

 private:
  [[nodiscard]] Error mistake(std::string what, std::string remedy) const {
    return {std::move(what), quoted(text_), std::move(remedy)};
  }
  [[nodiscard]] std::string as_form() const { return "write " + std::string(scheme_->form); }

  Result<void> read_path(std::string_view place) {
    const auto path = without_percent(place);
    if (!path) return mistake("a % is not followed by two hex digits", "write %25 for the sign itself");
    if (path->empty() || path->front() != '/')
      return mistake("the path does not begin with /",
                     "three slashes stand before it: " + std::string(scheme_->name) + ":///" +
                         (path->empty() ? "PATH" : *path));
    if (path->back() == '/') return mistake("the path names a folder", as_form());
    address_.path = *path;
    return {};
  }

  Result<void> read_host(std::string_view place) {
    if (place.find('@') != std::string_view::npos)
      return mistake("a user's name has no meaning here", as_form());
    if (const auto slash = place.find('/'); slash != std::string_view::npos)
      return mistake("nothing may follow the port, and " + quoted(place.substr(slash)) + " does", as_form());
    std::string_view port;
    if (!place.empty() && place.front() == '[') {
      const auto close = place.find(']');
      if (close == std::string_view::npos)
        return mistake("the bracket is not closed", "write [ADDRESS]:PORT");
      address_.host = place.substr(1, close - 1);
      if (!is_ipv6(address_.host))
        return mistake(quoted(address_.host) + " is no IPv6 address", "write it as [fe80::1%eth0] or [::1]");
      port = place.substr(close + 1);
      if (!port.empty() && port.front() != ':')
        return mistake("only a port may follow the bracket", "write [ADDRESS]:PORT");
      if (!port.empty()) port.remove_prefix(1);
    } else {
      if (std::count(place.begin(), place.end(), ':') > 1)
        return mistake("an IPv6 address goes into brackets",
                       "write " + std::string(scheme_->name) + "://[ADDRESS]:PORT");
      const auto colon = place.find(':');
      address_.host = place.substr(0, colon);
      if (colon != std::string_view::npos) port = place.substr(colon + 1);
      if (address_.host.empty()) return mistake("no host is given", as_form());
      if (!is_name(address_.host))
        return mistake(quoted(address_.host) + " is neither a host's name nor an address", as_form());
      if (digits_and_dots(address_.host) && !is_ipv4(address_.host))
        return mistake(quoted(address_.host) + " is no IPv4 address",
                       "four numbers from 0 to 255 make one: 192.168.1.20");
    }
    if (address_.kind == LinkKind::tcp_listen && !is_ipv4(address_.host) && !is_ipv6(address_.host))
      return mistake(quoted(address_.host) + " is no address to listen on",
                     "write 0.0.0.0 for every address of this computer, 127.0.0.1 for programs on it");
    if (port.empty()) return mistake("no port is given", as_form() + ", PORT from 1 to 65535");
    const auto number = whole(port, address_.kind == LinkKind::tcp_listen ? 0 : 1, 65535);
    if (!number) return mistake("the port " + quoted(port) + " is no number from 1 to 65535", as_form());
    address_.port = static_cast<std::uint16_t>(*number);
    return {};
  }

  Result<void> read_keys(std::string_view keys) {
    std::vector<std::string_view> seen;
    while (!keys.empty()) {
      const auto part = keys.substr(0, keys.find('&'));
      keys.remove_prefix(std::min(keys.size(), part.size() + 1));
      const auto equals = part.find('=');
      const auto key = part.substr(0, equals);
      if (std::find(scheme_->keys.begin(), scheme_->keys.end(), key) == scheme_->keys.end())
        return mistake("a " + std::string(scheme_->name) + " link has no key " + quoted(key), legal_keys());
      if (std::find(seen.begin(), seen.end(), key) != seen.end())
        return mistake("the key " + quoted(key) + " is given twice", "give it once");
      seen.push_back(key);
      if (equals == std::string_view::npos || equals + 1 == part.size())
        return mistake("the key " + quoted(key) + " has no value", "write " + std::string(key) + "=VALUE");
      if (auto read = read_key(key, part.substr(equals + 1)); !read) return read.error();
    }
    return {};
  }

  [[nodiscard]] std::string legal_keys() const {
    if (scheme_->keys.empty()) return "it has none; leave away what follows the ?";
    std::string text = "it has";
    for (const auto key : scheme_->keys) text += (text.size() > 6 ? ", " : " ") + std::string(key);
    return text;
  }

  [[nodiscard]] Error value_mistake(std::string_view key, std::string_view value,
                                    const std::string& legal) const {
    return mistake(std::string(key) + " cannot be " + quoted(value), "it is " + legal);
  }

  Result<void> read_key(std::string_view key, std::string_view value) {
    if (key == "iface" || key == "ttl") {
      if (!address_.multicast())
        return mistake(
            std::string(key) + " is for multicast, and " + quoted(address_.host) + " is no multicast address",
            "leave it away, or send to an address from 224.0.0.0 to 239.255.255.255");
      if (key == "iface") return address_.iface = value, Result<void>{};
      const auto ttl = whole(value, 1, 255);
      if (!ttl) return value_mistake(key, value, "a number of hops from 1 to 255");
      address_.ttl = static_cast<int>(*ttl);
    } else if (key == "baud") {
      const auto baud = whole(value, 50, 4'000'000);
      if (!baud)
        return value_mistake(key, value, "a speed from 50 to 4000000, mostly 4800, 9600, 38400 or 115200");
      address_.baud = *baud;
    } else if (key == "parity") {
      using enum LinkAddress::Parity;
      if (value != "n" && value != "e" && value != "o") return value_mistake(key, value, "n, e or o");
      address_.parity = value == "n" ? none : value == "e" ? even : odd;
    } else if (key == "flow") {
      using enum LinkAddress::Flow;
      if (value != "none" && value != "rts" && value != "xon")
        return value_mistake(key, value, "none, rts or xon");
      address_.flow = value == "none" ? none : value == "rts" ? rts : xon;
    } else if (key == "data") {
      const auto bits = whole(value, 5, 8);
      if (!bits) return value_mistake(key, value, "a number of bits from 5 to 8");
      address_.data_bits = static_cast<int>(*bits);
    } else if (key == "stop") {
      const auto bits = whole(value, 1, 2);
      if (!bits) return value_mistake(key, value, "1 or 2");
      address_.stop_bits = static_cast<int>(*bits);
    } else {
      if (value != "0" && value != "1") return value_mistake(key, value, "0 or 1");
      address_.follow = value == "1";
    }
    return {};
  }

  std::string_view text_;
  const Scheme* scheme_ = nullptr;
  LinkAddress address_;
};

}  // namespace

std::string LinkAddress::text() const {
  std::string text = std::string(scheme_of(kind).name) + "://";
  char sign = '?';
  const auto key = [&](const char* name, const std::string& value) {
    text += std::exchange(sign, '&') + std::string(name) + "=" + value;
  };
  if (kind == LinkKind::serial || kind == LinkKind::file)
    text += with_percent(path);
  else
    text += (ipv6() ? "[" + host + "]" : host) + ":" + std::to_string(port);
  const LinkAddress usual;
  if (kind == LinkKind::serial) {
    if (baud != usual.baud) key("baud", std::to_string(baud));
    if (parity != usual.parity) key("parity", parity == Parity::even ? "e" : "o");
    if (flow != usual.flow) key("flow", flow == Flow::rts ? "rts" : "xon");
    if (data_bits != usual.data_bits) key("data", std::to_string(data_bits));
    if (stop_bits != usual.stop_bits) key("stop", std::to_string(stop_bits));
  }
  if (!iface.empty()) key("iface", iface);
  if (ttl != usual.ttl) key("ttl", std::to_string(ttl));
  if (follow) key("follow", "1");
  return text;
}

bool LinkAddress::multicast() const {
  in_addr v4{};
  if (::inet_pton(AF_INET, host.c_str(), &v4) == 1) return (ntohl(v4.s_addr) >> 28) == 14;
  in6_addr v6{};
  return ::inet_pton(AF_INET6, host.substr(0, host.find('%')).c_str(), &v6) == 1 && v6.s6_addr[0] == 0xFF;
}

Result<LinkAddress> parse_link(std::string_view text) { return Parsing(text).read(); }

std::optional<LinkAddress> receiving_side(const LinkAddress& sending) {
  LinkAddress other = sending;
  const std::string anywhere = sending.ipv6() ? "::" : "0.0.0.0";
  switch (sending.kind) {
    case LinkKind::serial:
      return std::nullopt;
    case LinkKind::udp:
      if (!sending.multicast()) other.host = anywhere;
      other.ttl = 1;
      return other;
    case LinkKind::tcp:
      other.kind = LinkKind::tcp_listen;
      other.host = anywhere;
      return other;
    case LinkKind::tcp_listen:
      other.kind = LinkKind::tcp;
      if (sending.host == anywhere) other.host = sending.ipv6() ? "::1" : "127.0.0.1";
      return other;
    case LinkKind::file:
      other.follow = true;
      return other;
  }
  return std::nullopt;
}

}  // namespace leadline::links
