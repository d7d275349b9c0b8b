#pragma once

#include <string>

namespace leadline {

/// One name of `leadline list`.
struct Offer {
  std::string name;  ///< small letters, digits and "-"; no other plugin's
  std::string help;  ///< one line for the operator
};

}  // namespace leadline
