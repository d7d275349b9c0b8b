#pragma once

#include <boost/system/error_code.hpp>

#include "core/links/link_address.h"
#include "core/types/result.h"

namespace leadline::links {

/// What a system's error means on this link, in the operator's words, and what to do about it.
[[nodiscard]] Error link_error(const LinkAddress& address, const boost::system::error_code& error);

}  // namespace leadline::links
