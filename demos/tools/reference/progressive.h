// A picture that gains its samples one at a time, to be looked at meanwhile.
#pragma once

#include "host/host.h"
#include "reference/pixel.h"
#include "reference/rows.h"

namespace demos::reference {

class Progressive {
  public:
    /// The frame, whose `samples` are what each pixel is to have, lives longer.
    explicit Progressive(const Frame& frame);

    uint32_t samples() const { return samples_; }
    bool done() const { return samples_ == frame_.desc.samples; }
    /// One sample more for each pixel. False where it was stopped, which leaves no whole picture.
    bool add(const ProgressFunction& goOn = {});
    /// As of the samples so far; with all of them the bits of renderReference().
    Picture mean() const;

  private:
    const Frame& frame_;
    std::vector<PixelSum> pixels_;
    uint32_t samples_ = 0;
};

} // namespace demos::reference
