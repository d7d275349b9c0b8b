#pragma once

namespace leadline::app {

/// SIGINT and SIGTERM from here on only raise a flag: the work under way ends at the next chunk and keeps
/// what is done.
void catch_interrupts();
[[nodiscard]] bool interrupted();

}  // namespace leadline::app
