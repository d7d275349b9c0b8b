#include "app/list.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "core/decode/registry.h"

namespace leadline::app {

Exit list(const std::string& what, const PluginHost& plugins, bool json) {
  struct Entry {
    std::string name, help, plugin;
  };
  std::vector<Entry> entries;
  if (what == "engines") {
    for (const auto& engine : plugins.engines()) entries.push_back({engine.name, engine.help, engine.plugin});
  } else if (what == "decoders") {
    for (const auto& decoder : decode::decoders())
      entries.push_back({std::string(decoder.name), std::string(decoder.help), ""});
    for (const auto& decoder : plugins.decoders())
      entries.push_back({decoder.name, decoder.help, decoder.plugin});
  } else {
    entries = {
        {"serial",
         "serial:///dev/ttyUSB0?baud=115200&parity=n&flow=none: a serial line, reopened when plugged in "
         "again",
         ""},
        {"udp", "udp://0.0.0.0:4001, udp://239.192.0.4:60004?iface=eth0: datagrams to a port or a group", ""},
        {"tcp", "tcp://host:port: a server's stream", ""},
        {"tcp-listen", "tcp-listen://0.0.0.0:port: our own server, its clients' streams", ""},
        {"file", "file:///x?follow=1: a file that grows; in replay a log is an INPUT", ""},
        {"capture", "a .pcap or .pcapng as INPUT of `leadline replay`, by the ports of the links", ""}};
  }
  if (json) {
    nlohmann::ordered_json j = nlohmann::ordered_json::array();
    for (const auto& [name, help, plugin] : entries) {
      j.push_back({{"name", name}, {"help", help}});
      if (!plugin.empty()) j.back()["plugin"] = plugin;
    }
    fmt::print("{}\n", j.dump(2));
  } else {
    for (const auto& [name, help, plugin] : entries)
      fmt::print("{:<16} {}{}\n", name, help, plugin.empty() ? "" : " [" + plugin + "]");
  }
  return Exit::done;
}

}  // namespace leadline::app
