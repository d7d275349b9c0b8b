#pragma once

#include <fcntl.h>
#include <sys/wait.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <thread>

#include "sessions/store/frames.h"
#include "tests/support/files.h"
#include "tests/support/peer.h"

namespace leadline::test {

/// Instruments by plain system calls: pseudo-terminals, datagrams and TCP servers in turn, each with its own
/// sentences, and everything that was sent remembered.
class LiveLoad {
 public:
  enum class Kind : std::uint8_t { terminal, udp, tcp };
  struct Instrument {
    std::string name, link;
    Kind kind = Kind::udp;
    Peer peer{0}, server{0};
    std::uint16_t port = 0;
    std::string path;               ///< of a terminal: a name that stays while the device behind it changes
    std::vector<std::string> sent;  ///< telegrams
    std::uint64_t next = 0;
  };

  LiveLoad(std::string folder, int count, std::function<Kind(int)> kind_of) : folder_(std::move(folder)) {
    for (int i = 0; i < count; ++i) {
      Instrument instrument;
      instrument.peer.let_go(), instrument.server.let_go();
      instrument.name = "s" + std::to_string(i);
      instrument.kind = kind_of(i);
      if (instrument.kind == Kind::terminal) {
        instrument.path = folder_ + "/" + instrument.name;
        instrument.link = "serial://" + instrument.path;
        plug(instrument);
      } else if (instrument.kind == Kind::udp) {
        instrument.port = port_of(udp_peer());
        instrument.link = "udp://127.0.0.1:" + std::to_string(instrument.port);
        instrument.peer = udp_to(instrument.port);
      } else {
        instrument.server = tcp_server();
        instrument.link = "tcp://127.0.0.1:" + std::to_string(port_of(instrument.server));
      }
      instruments_.push_back(std::move(instrument));
    }
  }

  [[nodiscard]] std::vector<Instrument>& instruments() { return instruments_; }

  /// One GNSS of a ship is navigated by, the others are heard beside it.
  [[nodiscard]] std::string configuration(const std::string& more = "") const {
    std::string text =
        "version = 1\n[navigation]\nengine = \"fusion\"\nbody = \"ship\"\noutput_hz = 1000.0\n";
    for (const auto& instrument : instruments_)
      text += "[[source]]\nname = \"" + instrument.name + "\"\nlink = \"" + instrument.link +
              "\"\ndecoder = \"nmea0183\"\nbody = \"ship\"\n";
    return text + more;
  }

  /// Servers take the connection that a started program makes; terminals and datagrams need its ports open.
  void meet() {
    for (auto& instrument : instruments_)
      if (instrument.kind == Kind::tcp) instrument.peer = accepted(instrument.server);
  }

  static Peer udp_to(std::uint16_t port) {
    Peer peer(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    const auto address = loopback(port);
    EXPECT_EQ(::connect(peer.file(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return peer;
  }

  static void plug(Instrument& instrument) {
    instrument.peer = pseudo_terminal();
    // Opened and closed once, its master says whether somebody has it open.
    ::close(::open(path_of(instrument.peer).c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    std::filesystem::remove(instrument.path);
    std::filesystem::create_symlink(path_of(instrument.peer), instrument.path);
  }
  /// Whether anybody has the other end of a terminal open.
  static bool heard(const Instrument& instrument) {
    pollfd look{instrument.peer.file(), POLLIN, 0};
    return ::poll(&look, 1, 0) >= 0 && (look.revents & POLLHUP) == 0;
  }

  /// The next telegram of an instrument: the first sends positions, the others headings and depths too.
  std::string next_telegram(Instrument& instrument) {
    const std::uint64_t n = instrument.next++;
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now).count() % 86'400'000;
    std::array<char, 120> body{};
    const std::size_t which = instrument.name == "s0" ? 0 : n % 3;
    if (which == 0)
      std::snprintf(body.data(), body.size(),
                    "GPGGA,%02d%02d%02d.%03d,5912.%05d,N,00512.%05d,E,4,14,0.7,41.20,M,44.10,M,1.2,0123",
                    static_cast<int>(ms / 3'600'000), static_cast<int>(ms / 60'000 % 60),
                    static_cast<int>(ms / 1000 % 60), static_cast<int>(ms % 1000),
                    static_cast<int>(30'000 + n % 50'000), static_cast<int>(10'000 + n % 70'000));
    else if (which == 1)
      std::snprintf(body.data(), body.size(), "HEHDT,%.3f,T",
                    std::fmod(static_cast<double>(n) * 0.01, 360.0));
    else
      std::snprintf(body.data(), body.size(), "SDDPT,%.3f,1.5,200.0",
                    10.0 + static_cast<double>(n % 1000) * 0.01);
    unsigned sum = 0;
    for (const char* c = body.data(); *c != 0; ++c) sum ^= static_cast<std::uint8_t>(*c);
    std::array<char, 140> line{};
    std::snprintf(line.data(), line.size(), "$%s*%02X\r\n", body.data(), sum);
    return line.data();
  }

  /// Sends one telegram whole; remembers it.
  void send(Instrument& instrument) {
    const std::string text = next_telegram(instrument);
    std::size_t done = 0;
    while (done < text.size()) {
      const auto n = ::write(instrument.peer.file(), text.data() + done, text.size() - done);
      if (n > 0)
        done += static_cast<std::size_t>(n);
      else if (errno != EINTR && errno != EAGAIN)
        return;
    }
    instrument.sent.push_back(text);
  }

  /// In turn, each when it is due.
  void send_all(double per_s, double duration_s) {
    using Steady = std::chrono::steady_clock;
    const auto begun = Steady::now();
    const auto count = static_cast<std::uint64_t>(per_s * duration_s);
    for (std::uint64_t i = 0; i < count; ++i) {
      const auto due = begun + std::chrono::duration_cast<Steady::duration>(
                                   std::chrono::duration<double>(static_cast<double>(i) / per_s));
      if (due - Steady::now() > std::chrono::microseconds(200)) std::this_thread::sleep_until(due);
      send(instruments_[i % instruments_.size()]);
    }
  }

  [[nodiscard]] std::uint64_t telegrams() const {
    std::uint64_t all = 0;
    for (const auto& instrument : instruments_) all += instrument.sent.size();
    return all;
  }

 private:
  std::string folder_;
  std::vector<Instrument> instruments_;
};

/// `leadline record` as a process of its own.
class RecordProcess {
 public:
  RecordProcess(const std::string& program, const std::string& config, const std::string& session,
                const std::string& err)
      : err_(err) {
    const int file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    pid_ = ::fork();
    if (pid_ != 0) {
      ::close(file);
      return;
    }
    ::dup2(file, STDERR_FILENO);
    ::execl(program.c_str(), program.c_str(), "record", "--config", config.c_str(), "--session",
            session.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ~RecordProcess() {
    if (pid_ > 0) (void)end(SIGKILL);
  }
  RecordProcess(const RecordProcess&) = delete;
  RecordProcess& operator=(const RecordProcess&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  [[nodiscard]] std::string said() const { return read_text(err_); }
  [[nodiscard]] std::size_t said_count(const std::string& words) const {
    const std::string text = said();
    std::size_t count = 0;
    for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
    return count;
  }
  /// Waits until so many links are open.
  [[nodiscard]] bool opens(std::size_t links) const {
    return comes_about([&] { return said_count(" is open\n") >= links; });
  }
  /// The exit status; -1 when a signal ended it.
  int end(int signal) {
    ::kill(pid_, signal);
    int status = 0;
    ::waitpid(std::exchange(pid_, -1), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  struct Usage {
    std::size_t handles = 0, threads = 0, resident_kib = 0;
    double cpu_s = 0.0;
  };
  [[nodiscard]] Usage usage() const {
    namespace fs = std::filesystem;
    const std::string proc = "/proc/" + std::to_string(pid_);
    const auto entries = [](const std::string& folder) {
      return static_cast<std::size_t>(
          std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    };
    Usage usage{entries(proc + "/fd"), entries(proc + "/task"), 0, 0.0};
    std::ifstream status(proc + "/status");
    for (std::string line; std::getline(status, line);)
      if (line.rfind("VmRSS:", 0) == 0) usage.resident_kib = std::stoul(line.substr(6));
    std::ifstream stat(proc + "/stat");
    std::string field;
    double user = 0.0, system = 0.0;
    for (int i = 0; i < 13; ++i) stat >> field;
    stat >> user >> system;
    usage.cpu_s = (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
    return usage;
  }

 private:
  std::string err_;
  pid_t pid_ = -1;
};

/// The raw frames of a run by the name of their source, in order.
inline std::map<std::string, std::vector<std::string>> recorded_frames(
    const std::string& path, std::optional<sessions::RunId> run = {}) {
  std::map<std::string, std::vector<std::string>> frames;
  auto session = sessions::Session::open(path, sessions::Access::read);
  EXPECT_TRUE(session) << (session ? "" : session.error().line());
  if (!session) return frames;
  const auto runs = session.value().runs().value();
  for (const auto& found : runs) {
    if (run && found.id != *run) continue;
    const auto sources = session.value().sources(found.id).value();
    sessions::FrameReader reader(session.value(), found.id);
    for (sessions::StoredFrame frame; reader.next(frame).value();)
      frames[sources[frame.source].info.name].emplace_back(frame.bytes.begin(), frame.bytes.end());
  }
  return frames;
}

inline std::string joined(const std::vector<std::string>& pieces) {
  std::string all;
  for (const auto& piece : pieces) all += piece;
  return all;
}

/// Random datagrams to a port until it is destroyed; their number, bytes and a sum of their contents that
/// does not depend on their order.
class Flood {
 public:
  struct Sum {
    std::uint64_t datagrams = 0, bytes = 0, hashes = 0;
    void add(std::string_view datagram) {
      ++datagrams;
      bytes += datagram.size();
      hashes += std::hash<std::string_view>()(datagram);
    }
    bool operator==(const Sum&) const = default;
  };

  Flood(std::uint16_t port, double bytes_per_s) {
    thread_ = std::thread([this, port, bytes_per_s] {
      const Peer peer = LiveLoad::udp_to(port);
      std::mt19937_64 random(5);
      std::string noise(1 << 16, ' ');
      for (char& c : noise) c = static_cast<char>(random());
      using Steady = std::chrono::steady_clock;
      const auto begun = Steady::now();
      while (!stop_) {
        const double due = std::chrono::duration<double>(Steady::now() - begun).count() * bytes_per_s;
        if (static_cast<double>(sum_.bytes) >= due) {
          std::this_thread::sleep_for(std::chrono::microseconds(200));
          continue;
        }
        const std::size_t length = 64 + random() % 1409, at = random() % (noise.size() - length);
        const std::string_view datagram(noise.data() + at, length);
        if (::write(peer.file(), datagram.data(), length) == static_cast<ssize_t>(length)) sum_.add(datagram);
      }
    });
  }
  ~Flood() { (void)end(); }
  Sum end() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    return sum_;
  }

 private:
  std::atomic<bool> stop_ = false;
  Sum sum_;
  std::thread thread_;
};

}  // namespace leadline::test
