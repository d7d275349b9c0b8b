#pragma once

#include "core/encode/telegrams.h"

namespace leadline::sim {

/// The telegrams one measurement makes.
using encode::Telegrams;

}  // namespace leadline::sim
