// libFuzzer's entry to one target.
#include <cstdint>

#include "tests/fuzz/target.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const fuzz::Target target = fuzz::find(SEAGLASS_FUZZ_TARGET);
    target.run(std::as_bytes(std::span(data, size)));
    return 0;
}
