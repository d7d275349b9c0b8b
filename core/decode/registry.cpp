#include "core/decode/registry.h"

#include <array>
#include <string>

#include "core/decode/nmea0183.h"
#include "core/decode/trdi_pd0.h"
#include "core/decode/trdi_pd4.h"
#include "core/decode/trdi_pd6.h"

namespace leadline::decode {

std::span<const DecoderInfo> decoders() {
  static constexpr std::array<DecoderInfo, 5> kDecoders{{
      {"nmea0183",
       "NMEA 0183 / IEC 61162-1 sentences, with PSIMSSB, PTSAG, PTSAX, PASHR, PRDID, PSXN, PUHAW"},
      {"trdi-pd0", "Teledyne RDI PD0 ensembles with bottom track and embedded NMEA"},
      {"trdi-pd4", "Teledyne RDI PD4 and PD5 frames"},
      {"trdi-pd6", "Teledyne RDI PD6 and PD13 text"},
      {"table", "text tables, one row a sample, columns named in the configuration"},
  }};
  return kDecoders;
}

Result<std::unique_ptr<Decoder>> make_decoder(std::string_view name, const DecoderSettings& settings,
                                              const TableOptions& table) {
  if (name == "nmea0183") return make_nmea0183(settings);
  if (name == "trdi-pd0") return make_trdi_pd0(settings);
  if (name == "trdi-pd4") return make_trdi_pd4(settings);
  if (name == "trdi-pd6") return make_trdi_pd6(settings);
  if (name == "table") return make_table(settings, table);
  std::string known;
  for (const auto& decoder : decoders()) known += (known.empty() ? "" : ", ") + std::string(decoder.name);
  return Error{"no decoder is called \"" + std::string(name) + "\"", "decoder", "this build has " + known};
}

}  // namespace leadline::decode
