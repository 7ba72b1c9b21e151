// fuzz_once TARGET FILE...: gives each file to a target, without a fuzzer.
#include <cstdio>

#include "tests/fuzz/target.h"
#include "tests/program/run.h"

int main(int argc, char** argv) {
    const fuzz::Target target = argc > 2 ? fuzz::find(argv[1]) : fuzz::Target{};
    if (!target.run) {
        std::fprintf(stderr, "usage: fuzz_once TARGET FILE..., of these targets:\n");
        for (const fuzz::Target& known : fuzz::targets()) std::fprintf(stderr, "  %s\n", known.name);
        return 2;
    }
    for (int i = 2; i < argc; ++i) {
        const std::string content = tests::readAll(argv[i]);
        target.run(std::as_bytes(std::span(content)));
    }
    return 0;
}
