#pragma once

#include <boost/asio/ip/address.hpp>
#include <memory>
#include <string>
#include <vector>

namespace leadline::links {

/// Every endpoint of a host, by resolver.async_resolve() for a name; an address asks nobody. Then calls
/// done(error, endpoints) on the I/O thread, for an address at once. The resolver's owner keeps it alive.
template <class Protocol, class Done>
void find_endpoints(typename Protocol::resolver& resolver, const std::string& host, std::uint16_t port,
                    Done done) {
  using Endpoint = typename Protocol::endpoint;
  boost::system::error_code is_name;
  const auto address = boost::asio::ip::make_address(host, is_name);
  if (!is_name) return done(boost::system::error_code{}, std::vector<Endpoint>{{address, port}});
  resolver.async_resolve(host, std::to_string(port),
                         [done = std::move(done)](const boost::system::error_code& error,
                                                  const typename Protocol::resolver::results_type& found) {
                           std::vector<Endpoint> endpoints;
                           if (!error)
                             for (const auto& entry : found) endpoints.push_back(entry.endpoint());
                           done(error, std::move(endpoints));
                         });
}

}  // namespace leadline::links
