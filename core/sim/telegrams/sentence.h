#pragma once

#include "core/encode/sentence.h"

namespace leadline::sim {

using encode::rounded;
using encode::Sentence;

}  // namespace leadline::sim
