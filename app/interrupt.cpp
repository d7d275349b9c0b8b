#include "app/interrupt.h"

#include <csignal>

namespace leadline::app {
namespace {

volatile std::sig_atomic_t flag = 0;
void raise_flag(int) { flag = 1; }

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, raise_flag);
  std::signal(SIGTERM, raise_flag);
}

bool interrupted() { return flag != 0; }

}  // namespace leadline::app
