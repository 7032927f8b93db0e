// The golden flights in C++: the samples that C emulates, navigated by the wrapper. It says the digests of two navigators.

#include "schuler.hpp"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "flights.h"
#include "../digests/sensors.h"

namespace {

void must(std::int32_t status)
{
    if (status != SCHULER_OK) {
        std::fprintf(stderr, "digests: %s\n", schuler_result_text(status));
        std::exit(1);
    }
}

struct scene {
    const char* name;
    double rate_hz;
    std::size_t samples;
    const std::uint64_t* initial;
    const std::uint64_t (*increments)[6];
    const schuler_triad_f64* gyros;
    const schuler_triad_f64* accelerometers;
};

void say(const scene& of, const char* stage, const schuler_digest& running)
{
    std::uint64_t value = 0;
    must(schuler_digest_value(&running, &value));
    std::printf("%s %s %016" PRIx64 "\n", of.name, stage, value);
}

void fly(const scene& of)
{
    schuler::navigator<schuler_f64_earth_fixed_h0b4a0> twice;
    schuler::navigator<schuler_f32_local_level_h0b4a0> single;
    schuler_digest of_twice{}, of_single{};
    schuler_carried carried{};
    schuler_emulator_f64 unit{};
    schuler_solution_f64 initial{};

    std::memcpy(&initial, of.initial, sizeof initial);
    must(twice.start(of.rate_hz, initial));
    must(single.start(of.rate_hz, initial));
    must(schuler_digest_start(&of_twice, SCHULER_ABI));
    must(schuler_digest_start(&of_single, SCHULER_ABI));
    must(schuler_carried_start(&carried, SCHULER_ABI));
    must(schuler_emulator_f64_start(&unit, SCHULER_ABI, 1.0 / of.rate_hz, of.samples, of.gyros, of.accelerometers, 1, 0));
    for (std::size_t i = 0; i < of.samples; i++) {
        schuler_increment_f64 sample;
        schuler_increment_f32 narrow;
        std::memcpy(&sample, of.increments[i], sizeof sample);
        must(schuler_emulator_f64_read(&unit, &sample, &sample));
        must(schuler_carried_narrow(&carried, &sample, &narrow));
        must(twice.push(sample));
        must(twice.digest(of_twice));
        must(single.push(narrow));
        must(single.digest(of_single));
    }
    say(of, "f64-earth-fixed-taylor-0-4-0", of_twice);
    say(of, "f32-local-level-taylor-0-4-0", of_single);
}

} // namespace

int main()
{
    fly({ "paper", 20.0, PAPER_SAMPLES, paper_initial, paper_increments, &paper_gyros, &paper_accelerometers });
    fly({ "turns", 50.0, TURNS_SAMPLES, turns_initial, turns_increments, &turns_gyros, &turns_accelerometers });
    return 0;
}
