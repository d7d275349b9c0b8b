#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/decode/profile.h"
#include "core/decode/table.h"
#include "core/flow/decoder.h"
#include "core/types/result.h"

namespace leadline::decode {

struct DecoderInfo {
  using Make = std::unique_ptr<Decoder> (*)(const DecoderSettings&, const ProfileOptions&);
  std::string_view name, help;
  Make make = nullptr;  ///< null: `table`, which needs its columns
};
/// The decoders of this build.
[[nodiscard]] std::span<const DecoderInfo> decoders();

/// Error: no decoder of that name (the known ones are listed), or a table whose columns make no sense.
[[nodiscard]] Result<std::unique_ptr<Decoder>> make_decoder(std::string_view name,
                                                            const DecoderSettings& settings,
                                                            const TableOptions& table = {},
                                                            const ProfileOptions& profile = {});

}  // namespace leadline::decode
