#include "core/links/link_address.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leadline::links {
namespace {

using testing::AllOf;
using testing::HasSubstr;

LinkAddress read(const std::string& text) {
  const auto link = parse_link(text);
  EXPECT_TRUE(link.ok()) << (link ? "" : link.error().line());
  return link ? link.value() : LinkAddress{};
}

TEST(LinkAddress, ReadsEveryKindWithItsKeys) {
  const auto serial = read("serial:///dev/ttyUSB0?baud=4800&parity=e&flow=rts&data=7&stop=2");
  EXPECT_EQ(serial.kind, LinkKind::serial);
  EXPECT_EQ(serial.path, "/dev/ttyUSB0");
  EXPECT_EQ(serial.baud, 4800);
  EXPECT_EQ(serial.parity, LinkAddress::Parity::even);
  EXPECT_EQ(serial.flow, LinkAddress::Flow::rts);
  EXPECT_EQ(serial.data_bits, 7);
  EXPECT_EQ(serial.stop_bits, 2);
  const auto multicast = read("udp://239.192.0.4:60004?iface=eth0&ttl=8");
  EXPECT_EQ(multicast.kind, LinkKind::udp);
  EXPECT_EQ(multicast.host, "239.192.0.4");
  EXPECT_EQ(multicast.port, 60004);
  EXPECT_EQ(multicast.iface, "eth0");
  EXPECT_EQ(multicast.ttl, 8);
  EXPECT_TRUE(multicast.multicast());
  EXPECT_FALSE(read("udp://192.168.1.255:4001").multicast());
  EXPECT_EQ(read("tcp://my-vessel.local:10110").host, "my-vessel.local");
  EXPECT_EQ(read("udp://[fe80::1%eth0]:4001").host, "fe80::1%eth0");
  EXPECT_EQ(read("tcp-listen://0.0.0.0:0").kind, LinkKind::tcp_listen);
  const auto file = read("file:///data/a%20log?follow=1");
  EXPECT_EQ(file.path, "/data/a log");
  EXPECT_TRUE(file.follow);
}

TEST(LinkAddress, WhatIsWrittenReadsTheSame) {
  for (const char* text :
       {"serial:///dev/ttyUSB0", "serial:///dev/ttyS1?baud=4800&parity=o&flow=xon&data=7&stop=2",
        "udp://127.0.0.1:4001", "udp://239.192.0.4:60004?iface=eth0&ttl=8", "udp://[ff02::1]:5?iface=eth1",
        "tcp://[::1]:65535", "tcp-listen://0.0.0.0:10110", "file:///a%20b%25c%3F", "file:///x?follow=1"})
    EXPECT_EQ(read(text).text(), text);
  EXPECT_EQ(read("serial:///dev/ttyUSB0?baud=115200&parity=n&flow=none"), read("serial:///dev/ttyUSB0"));
}

TEST(LinkAddress, EveryMistakeIsNamedWithWhatToDo) {
  struct Case {
    const char *text, *what, *remedy;
  };
  const Case cases[] = {
      {"", "is no link", "write serial:///dev/ttyUSB0, udp://"},
      {"/dev/ttyUSB0", "is no link", "serial:///dev/ttyUSB0"},
      {"http://a:1", "\"http\" is no kind of link", "udp://HOST:PORT"},
      {"udp://a b:1", "holds a blank", "%20"},
      {"udp://a:1\n", "control character", "%20"},
      {"serial://dev/ttyUSB0", "does not begin with /", "serial:///dev/ttyUSB0"},
      {"serial://", "does not begin with /", "serial:///PATH"},
      {"serial:///dev/", "names a folder", "serial:///dev/ttyUSB0"},
      {"serial:///dev/x?bauds=9600", "no key \"bauds\"", "it has baud, parity, flow, data, stop"},
      {"serial:///dev/x?baud=fast", "baud cannot be \"fast\"", "from 50 to 4000000"},
      {"serial:///dev/x?baud=-1", "baud cannot be \"-1\"", "from 50"},
      {"serial:///dev/x?parity=none", "parity cannot be \"none\"", "n, e or o"},
      {"serial:///dev/x?flow=on", "flow cannot be \"on\"", "none, rts or xon"},
      {"serial:///dev/x?data=9", "data cannot be \"9\"", "5 to 8"},
      {"serial:///dev/x?stop=1.5", "stop cannot be \"1.5\"", "1 or 2"},
      {"serial:///dev/x?baud=9600&baud=4800", "\"baud\" is given twice", "once"},
      {"serial:///dev/x?baud", "\"baud\" has no value", "baud=VALUE"},
      {"serial:///dev/x?baud=", "\"baud\" has no value", "baud=VALUE"},
      {"serial:///dev/x?&", "no key \"\"", "it has"},
      {"udp://127.0.0.1", "no port", "udp://HOST:PORT"},
      {"udp://127.0.0.1:", "no port", "1 to 65535"},
      {"udp://127.0.0.1:0", "port \"0\"", "udp://HOST:PORT"},
      {"udp://127.0.0.1:65536", "port \"65536\"", "udp://HOST:PORT"},
      {"udp://127.0.0.1:4oo1", "port \"4oo1\"", "udp://HOST:PORT"},
      {"udp://:4001", "no host", "udp://HOST:PORT"},
      {"udp://127.0.0.256:4001", "no IPv4 address", "0 to 255"},
      {"udp://127.1:4001", "no IPv4 address", "192.168.1.20"},
      {"udp://ship's:4001", "neither a host's name nor an address", "udp://"},
      {"udp://::1:4001", "goes into brackets", "udp://[ADDRESS]:PORT"},
      {"udp://[::1:4001", "not closed", "[ADDRESS]:PORT"},
      {"udp://[::g]:4001", "no IPv6 address", "[::1]"},
      {"udp://[::1]4001", "only a port", "[ADDRESS]:PORT"},
      {"udp://me@host:1", "user's name", "udp://HOST:PORT"},
      {"tcp://host:1/x", "\"/x\"", "tcp://HOST:PORT"},
      {"tcp://host:1?iface=eth0", "no key \"iface\"", "has none"},
      {"udp://127.0.0.1:1?iface=eth0", "iface is for multicast", "239.255.255.255"},
      {"udp://239.0.0.1:1?ttl=256", "ttl cannot be \"256\"", "1 to 255"},
      {"tcp-listen://ship:1", "no address to listen on", "0.0.0.0"},
      {"file://log", "does not begin with /", "file:///log"},
      {"file:///a%2", "two hex digits", "%25"},
      {"file:///a%00b", "two hex digits", "%25"},
      {"file:///x?follow=yes", "follow cannot be \"yes\"", "0 or 1"},
  };
  for (const auto& [text, what, remedy] : cases) {
    const auto link = parse_link(text);
    ASSERT_FALSE(link.ok()) << text;
    EXPECT_THAT(link.error().what, HasSubstr(what)) << text;
    EXPECT_THAT(link.error().remedy, HasSubstr(remedy)) << text;
    EXPECT_EQ(link.error().where, "\"" + std::string(text) + "\"");
  }
  EXPECT_THAT(parse_link("udp://" + std::string(5000, 'a')).error().what, HasSubstr("longer than 4096"));
}

TEST(LinkAddress, EachSideOfALinkHasAnother) {
  const std::pair<const char*, const char*> cases[] = {
      {"udp://127.0.0.1:4001", "udp://0.0.0.0:4001"},
      {"udp://[::1]:4001", "udp://[::]:4001"},
      {"udp://192.168.1.255:4001", "udp://0.0.0.0:4001"},
      {"udp://239.192.0.4:60004?iface=eth0&ttl=3", "udp://239.192.0.4:60004?iface=eth0"},
      {"tcp://127.0.0.1:4001", "tcp-listen://0.0.0.0:4001"},
      {"tcp-listen://0.0.0.0:4001", "tcp://127.0.0.1:4001"},
      {"tcp-listen://192.168.1.5:4001", "tcp://192.168.1.5:4001"},
      {"file:///x", "file:///x?follow=1"},
  };
  for (const auto& [sending, receiving] : cases) {
    const auto other = receiving_side(read(sending));
    ASSERT_TRUE(other.has_value()) << sending;
    EXPECT_EQ(other->text(), receiving);
  }
  EXPECT_FALSE(receiving_side(read("serial:///dev/ttyUSB0")).has_value());
}

}  // namespace
}  // namespace leadline::links
