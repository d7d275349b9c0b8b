#include "core/decode/registry.h"

#include <array>
#include <string>

#include "core/decode/evologics_usbl.h"
#include "core/decode/iec61162_450.h"
#include "core/decode/mavlink.h"
#include "core/decode/navquest.h"
#include "core/decode/nmea0183.h"
#include "core/decode/nortek_dvl.h"
#include "core/decode/paroscientific.h"
#include "core/decode/pni_tcm.h"
#include "core/decode/trdi_pd0.h"
#include "core/decode/trdi_pd4.h"
#include "core/decode/trdi_pd6.h"
#include "core/decode/valeport.h"
#include "core/decode/waterlinked_json.h"
#include "core/decode/waterlinked_serial.h"
#include "core/decode/xsens_mtdata2.h"

namespace leadline::decode {
namespace {

template <auto kMake>
std::unique_ptr<Decoder> plain(const DecoderSettings& settings, const ProfileOptions& /*profile*/) {
  return kMake(settings);
}
template <auto kMake>
std::unique_ptr<Decoder> profiled(const DecoderSettings& settings, const ProfileOptions& profile) {
  return kMake(settings, profile);
}

}  // namespace

std::span<const DecoderInfo> decoders() {
  static constexpr std::array<DecoderInfo, 16> kDecoders{{
      {"nmea0183", "NMEA 0183 / IEC 61162-1 sentences, with PSIMSSB, PTSAG, PTSAX, PASHR, PRDID, PSXN, PUHAW",
       profiled<make_nmea0183>},
      {"iec61162-450", "IEC 61162-450 datagrams (UdPbC) of those sentences, over UDP",
       profiled<make_iec61162_450>},
      {"trdi-pd0", "Teledyne RDI PD0 ensembles with bottom track and embedded NMEA", plain<make_trdi_pd0>},
      {"trdi-pd4", "Teledyne RDI PD4 and PD5 frames", plain<make_trdi_pd4>},
      {"trdi-pd6", "Teledyne RDI PD6 and PD13 text", profiled<make_trdi_pd6>},
      {"waterlinked-serial", "Water Linked A50 and A125, serial protocol: wrz, wrs, wru, wrp, wrx, wrt",
       plain<make_waterlinked_serial>},
      {"waterlinked-json", "Water Linked A50 and A125, JSON over TCP", plain<make_waterlinked_json>},
      {"navquest", "LinkQuest NavQuest text", profiled<make_navquest>},
      {"valeport", "Valeport miniIPS2, miniSVS, SVP and CTD text, PVIPS2", profiled<make_valeport>},
      {"paroscientific", "Paroscientific Digiquartz pressure text", profiled<make_paroscientific>},
      {"nortek-dvl", "Nortek DVL: AD2CP bottom and water track (DF21, DF22) and PNORBT, PNORWT sentences",
       profiled<make_nortek_dvl>},
      {"evologics-usbl", "EvoLogics modem notifications with USBLLONG positions", plain<make_evologics_usbl>},
      {"pni-tcm", "PNI TCM, TRAX and FieldForce compasses, binary", profiled<make_pni_tcm>},
      {"xsens-mtdata2", "Xsens MTi, MTData2", plain<make_xsens_mtdata2>},
      {"mavlink", "MAVLink 1 and 2: a vehicle's telemetry, live or as a telemetry log",
       profiled<make_mavlink>},
      {"table", "text tables, one row a sample, columns named in the configuration"},
  }};
  return kDecoders;
}

Result<std::unique_ptr<Decoder>> make_decoder(std::string_view name, const DecoderSettings& settings,
                                              const TableOptions& table, const ProfileOptions& profile) {
  if (name == "table") return make_table(settings, table);
  std::string known;
  for (const auto& decoder : decoders()) {
    if (decoder.name == name) return decoder.make(settings, profile);
    known += (known.empty() ? "" : ", ") + std::string(decoder.name);
  }
  return Error{"no decoder is called \"" + std::string(name) + "\"", "decoder", "this build has " + known};
}

}  // namespace leadline::decode
