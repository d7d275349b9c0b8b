#pragma once

#include <QtPlugin>
#include <memory>
#include <string_view>
#include <vector>

#include "core/flow/decoder.h"
#include "core/types/option_key.h"
#include "core/types/result.h"
#include "plugins/sdk/offer.h"

namespace leadline {

/// Owns the options a decoder adds to its [[source]]; one for each source, made at its defaults.
class SourceSettings {
 public:
  virtual ~SourceSettings() = default;
  virtual std::vector<BoundKey> keys() { return {}; }
};

/// A plugin of kind "decoder": the interface its root QObject implements. Decoders run on the core thread,
/// between the bytes and the engines: they must not block. An exception costs the bytes the decoder held,
/// and it is made anew. See plugins/example_decoder.
class DecoderPlugin {
 public:
  virtual ~DecoderPlugin() = default;
  [[nodiscard]] virtual std::vector<Offer> decoders() const = 0;
  [[nodiscard]] virtual std::unique_ptr<SourceSettings> settings(std::string_view /*name*/) const {
    return std::make_unique<SourceSettings>();
  }
  /// name: one of decoders(); settings: made by settings(name), outlives the decoder.
  [[nodiscard]] virtual Result<std::unique_ptr<Decoder>> make(std::string_view name,
                                                              const DecoderSettings& common,
                                                              const SourceSettings& settings) const = 0;
};

}  // namespace leadline

#define LEADLINE_DECODER_PLUGIN "leadline.DecoderPlugin"
Q_DECLARE_INTERFACE(leadline::DecoderPlugin, LEADLINE_DECODER_PLUGIN)
