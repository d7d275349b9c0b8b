// What one telegram and one filter step cost.

#include <benchmark/benchmark.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/decode/registry.h"
#include "core/geo/geodesy.h"
#include "core/geo/magnetic.h"
#include "core/nav/filters/constant_velocity.h"
#include "core/nav/filters/covariance_intersection.h"
#include "core/nav/motion/dead_reckoning.h"

namespace {

using namespace leadline;

std::vector<std::uint8_t> bytes_of(const std::string& name) {
  std::ifstream in(std::string(LEADLINE_TEST_DATA) + "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Counts facts and telegrams, so that nothing is optimised away.
struct Counter final : DecoderOutput {
  std::uint64_t facts = 0, frames = 0;
  void fact(std::optional<Time>, const Message& message) override {
    benchmark::DoNotOptimize(message);
    ++facts;
  }
  void frame(const FrameReport& report) override { frames += report.block ? 0 : 1; }
};

void decode(benchmark::State& state, const char* decoder, const std::vector<std::uint8_t>& bytes) {
  Counter counter;
  for (auto _ : state) {
    auto made = decode::make_decoder(decoder, {.checksum_required = false}).value();
    for (std::size_t i = 0; i < bytes.size(); i += 65536)
      made->feed(std::span(bytes).subspan(i, std::min<std::size_t>(65536, bytes.size() - i)),
                 Arrival{1'406'851'200'000'000'000}, counter);
    made->finish(counter);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size()) * state.iterations());
  state.SetItemsProcessed(static_cast<std::int64_t>(counter.frames));
}

void DecodeNmea(benchmark::State& state) {
  std::vector<std::uint8_t> sentences;
  const auto lines = bytes_of("nmea_openrvdas_nbp1406/NBP1406_s330-2014-08-01");
  for (std::size_t i = 0; i < lines.size();) {  // without their stamps
    i += 28;
    for (; i < lines.size() && lines[i] != '\n'; ++i) sentences.push_back(lines[i]);
    sentences.push_back('\n');
    ++i;
  }
  decode(state, "nmea0183", sentences);
}
BENCHMARK(DecodeNmea);

void DecodePd0(benchmark::State& state) {
  decode(state, "trdi-pd0", bytes_of("dvl_pd0_adcp/winriver01.PD0"));
}
BENCHMARK(DecodePd0);

void DeadReckoningPing(benchmark::State& state) {
  nav::DeadReckoning track({.scale = 0.003, .angle_rad = 0.01});
  track.start(Time{0}, {Angle::deg(59), Angle::deg(5)}, Eigen::Matrix2d::Identity());
  std::int64_t t = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(
        track.velocity(Time{t += 200'000'000}, {.v_ne = {0.3, 0.4}, .noise_mps = 0.005}));
}
BENCHMARK(DeadReckoningPing);

void PlainCiPredict(benchmark::State& state) {
  nav::PlainCi filter(5.0);
  for (auto _ : state) {
    filter.predict({0.3, 0.4}, 0.2);
    benchmark::DoNotOptimize(filter.P());
  }
}
BENCHMARK(PlainCiPredict);

void PlainCiFix(benchmark::State& state) {
  nav::PlainCi filter(5.0);
  double t = 0.0;
  for (auto _ : state) benchmark::DoNotOptimize(filter.fix({1.0, -2.0}, t += 8.0, 5.0));
}
BENCHMARK(PlainCiFix);

void ConstantVelocityFix(benchmark::State& state) {
  nav::ConstantVelocity filter;
  for (auto _ : state) {
    benchmark::DoNotOptimize(filter.predict(1.0));
    benchmark::DoNotOptimize(filter.fix({1.0, -2.0}, Eigen::Matrix2d::Identity() * 2.0));
  }
}
BENCHMARK(ConstantVelocityFix);

void Displaced(benchmark::State& state) {
  Geodetic p{Angle::deg(59), Angle::deg(5)};
  for (auto _ : state) benchmark::DoNotOptimize(p = geo::displaced(p, 0.01, 0.02));
}
BENCHMARK(Displaced);

void Declination(benchmark::State& state) {
  const auto models = geo::MagneticModel::load(std::string(LEADLINE_BINARY_DIR) + "/magnetic");
  if (!models) return state.SkipWithError("no models");
  for (auto _ : state)
    benchmark::DoNotOptimize(
        models.value().declination({Angle::deg(45), Angle::deg(-67)}, {0.0}, from_unix(1'491'400'000.0)));
}
BENCHMARK(Declination);

}  // namespace
